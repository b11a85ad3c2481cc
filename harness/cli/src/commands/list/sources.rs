//! `stickler list --sources`: the sources of the claims, and Stickler's own rules.

use super::{BOLD, DIM, json_line};
use serde::Serialize;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::io::{self, Write};
use stickler_suite::{Case, Source, SourceKind, Sources};
use stickler_types::Relation;

/// The sections of a source that cases cite, with the number of these cases.
type Cited<'a> = BTreeMap<&'a str, Count>;

/// The number of cases that cite something.
#[derive(Clone, Copy, Default, Serialize)]
struct Count {
    asserted: usize,
    open: usize,
}

/// A source, or one of Stickler's own rules.
#[derive(Serialize)]
struct SourceLine<'a> {
    /// The key of the source; for a rule, `rule: NAME`.
    source: String,
    title: String,
    publisher: &'a str,
    /// The relation of the publisher to what the source speaks of.
    relation: Relation,
    kind: &'static str,
    /// The address of the source, at the section that most cases cite.
    address: String,
    read: Cow<'a, str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    since: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    until: Option<&'a str>,
    engines: &'a [String],
    dialects: Vec<&'static str>,
    #[serde(flatten)]
    count: Count,
}

/// Writes every source, or those with these `names`, and every rule that a case rests on, with the number of these cases.
///
/// # Errors
/// Errors of writing to `out`.
pub(in crate::commands) fn write(
    out: &mut dyn Write,
    sources: &Sources,
    names: &[String],
    cases: &[&Case],
    json: bool,
) -> io::Result<()> {
    let mut cited: BTreeMap<&str, Cited<'_>> = BTreeMap::new();
    for case in cases {
        if let Some((source, section)) = sources.of(&case.basis) {
            let count = cited.entry(&source.key).or_default().entry(section).or_default();
            match case.is_open() {
                true => count.open += 1,
                false => count.asserted += 1,
            }
        }
    }
    let is_named = |source: &&Source| names.is_empty() || names.contains(&source.key);
    for source in sources.iter().filter(is_named) {
        let sections = cited.remove(source.key.as_str()).unwrap_or_default();
        let lines = lines(source, &sections);
        match json {
            true => lines.iter().try_for_each(|line| json_line(out, line))?,
            false => write_source(out, source, &lines)?,
        }
    }
    Ok(())
}

/// Returns a line for a source, or one for each of the rules and recordings that a case rests on.
fn lines<'a>(source: &'a Source, sections: &Cited<'_>) -> Vec<SourceLine<'a>> {
    let line = |name: String, section: &str, count: Count| SourceLine {
        source: name,
        title: source.title.replace("{section}", section),
        publisher: &source.publisher,
        relation: source.relation,
        kind: source.kind.as_str(),
        address: source.address_of(section),
        read: source.read_of(section),
        since: source.versions.since.as_deref(),
        until: source.versions.until.as_deref(),
        engines: &source.engines,
        dialects: source
            .dialects_of(section)
            .iter()
            .map(|dialect| dialect.as_str())
            .collect(),
        count,
    };
    if source.is_built_in() {
        let rules = sections.iter();
        let rule = |(rule, count): (&&str, &Count)| line(format!("{}: {rule}", source.key), rule, *count);
        return rules.map(rule).collect();
    }
    let most = sections.iter().max_by_key(|(_, count)| count.asserted);
    let count = sections.values().fold(Count::default(), |sum, count| Count {
        asserted: sum.asserted + count.asserted,
        open: sum.open + count.open,
    });
    let section = most
        .map(|(section, _)| *section)
        .or_else(|| source.first_section());
    let section = section.unwrap_or_default();
    vec![line(source.key.clone(), section, count)]
}

fn write_source(out: &mut dyn Write, source: &Source, lines: &[SourceLine<'_>]) -> io::Result<()> {
    if lines.is_empty() {
        return Ok(());
    }
    if source.kind == SourceKind::Rule {
        let (publisher, title) = (&source.publisher, &source.title);
        writeln!(out, "{BOLD}{}{BOLD:#}  {publisher}: {title}", source.key)?;
        for line in lines {
            let open = if line.count.open > 0 { " open" } else { "" };
            let cases = line.count.asserted + line.count.open;
            writeln!(out, "{cases:>8}{open}  {}", line.address)?;
        }
        return Ok(());
    }
    for line in lines {
        writeln!(
            out,
            "{BOLD}{}{BOLD:#}  {}: {}",
            line.source, line.publisher, line.title
        )?;
        writeln!(
            out,
            "{:>8}  {}, read {}{}{}",
            line.count.asserted,
            line.relation.with_kind(line.kind),
            line.read,
            limits(line),
            speaks_for(line)
        )?;
        writeln!(out, "          {DIM}{}{DIM:#}", line.address)?;
    }
    writeln!(out)
}

/// Returns the words that say with which versions the claims of a source begin and end.
fn limits(line: &SourceLine<'_>) -> String {
    let end = |word, end: Option<&str>| end.map_or_else(String::new, |end| format!(", {word} {end}"));
    end("since", line.since) + &end("until", line.until)
}

/// Returns the words that say for whom a source speaks; none for a standard, which speaks for all.
fn speaks_for(line: &SourceLine<'_>) -> String {
    let part = |what: &str, names: &[&str]| match names.is_empty() {
        true => String::new(),
        false => format!("; {what} {}", names.join(" ")),
    };
    let engines: Vec<&str> = line.engines.iter().map(String::as_str).collect();
    part("speaks for", &line.dialects) + &part("binds", &engines)
}
