//! `stickler list --sources`: the sources of the claims, and Stickler's own rules.

use super::{BOLD, DIM, json_line};
use crate::output::without_nulls;
use serde_json::{Value as Json, json};
use std::collections::BTreeMap;
use std::io::{self, Write};
use stickler_suite::{Case, Source, SourceKind, Sources};

/// The sections of a source that cases cite, with the number of these cases.
type Cited<'a> = BTreeMap<&'a str, Count>;

/// The number of cases that cite something.
#[derive(Clone, Copy, Default)]
struct Count {
    asserted: usize,
    open: usize,
}

/// A source, or one of Stickler's own rules, for a list.
struct SourceLine<'a> {
    /// The key of the source; for a rule, `rule: NAME`.
    name: String,
    source: &'a Source,
    /// The section that most cases cite.
    section: &'a str,
    count: Count,
}

impl SourceLine<'_> {
    fn title(&self) -> String {
        self.source.title.replace("{section}", self.section)
    }

    fn dialects(&self) -> Vec<&'static str> {
        let dialects = self.source.dialects_of(self.section);
        dialects.iter().map(|dialect| dialect.as_str()).collect()
    }

    fn json(&self) -> Json {
        let SourceLine {
            name,
            source,
            section,
            count,
        } = self;
        without_nulls(json!({
            "source": name,
            "title": self.title(),
            "publisher": source.publisher,
            "relation": source.relation,
            "kind": source.kind.as_str(),
            "address": source.address_of(section),
            "read": source.read_of(section),
            "since": source.versions.since,
            "until": source.versions.until,
            "engines": source.engines,
            "dialects": self.dialects(),
            "asserted": count.asserted,
            "open": count.open,
        }))
    }
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
            true => lines.iter().try_for_each(|line| json_line(out, &line.json()))?,
            false => write_source(out, source, &lines)?,
        }
    }
    Ok(())
}

/// Returns a line for a source, or one for each of the rules and recordings that a case rests on.
fn lines<'a>(source: &'a Source, sections: &Cited<'a>) -> Vec<SourceLine<'a>> {
    let line = |name: String, section: &'a str, count: Count| SourceLine {
        name,
        source,
        section,
        count,
    };
    if source.is_built_in() {
        let rules = sections.iter();
        let rule = |(rule, count): (&&'a str, &Count)| line(format!("{}: {rule}", source.key), rule, *count);
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
            writeln!(out, "{cases:>8}{open}  {}", source.address_of(line.section))?;
        }
        return Ok(());
    }
    for line in lines {
        let (name, title) = (&line.name, line.title());
        writeln!(out, "{BOLD}{name}{BOLD:#}  {}: {title}", source.publisher)?;
        writeln!(
            out,
            "{:>8}  {}, read {}{}{}",
            line.count.asserted,
            source.relation.with_kind(source.kind.as_str()),
            source.read_of(line.section),
            limits(source),
            speaks_for(line)
        )?;
        let address = source.address_of(line.section);
        writeln!(out, "          {DIM}{address}{DIM:#}")?;
    }
    writeln!(out)
}

/// Returns the words that say with which versions the claims of a source begin and end.
fn limits(source: &Source) -> String {
    let end = |word, end: &Option<String>| {
        end.iter()
            .map(|end| format!(", {word} {end}"))
            .collect::<String>()
    };
    end("since", &source.versions.since) + &end("until", &source.versions.until)
}

/// Returns the words that say for whom a source speaks; none for a standard, which speaks for all.
fn speaks_for(line: &SourceLine<'_>) -> String {
    let part = |what: &str, names: &[&str]| match names.is_empty() {
        true => String::new(),
        false => format!("; {what} {}", names.join(" ")),
    };
    let engines: Vec<&str> = line.source.engines.iter().map(String::as_str).collect();
    part("speaks for", &line.dialects()) + &part("binds", &engines)
}
