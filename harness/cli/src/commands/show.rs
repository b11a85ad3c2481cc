//! `stickler show`: shows one case.

use crate::arguments::ShowArguments;
use crate::case_folder;
use crate::documented;
use crate::exit::Exit;
use crate::named_case::NamedCase;
use crate::output::{BOLD, DIM};
use std::io::{self, Write};
use stickler_run::{Binding, Claim, Fact, Plan, binding, expected_facts, versions};
use stickler_suite::{Case, Suite};
use stickler_types::{Contradiction, Versions, grouped_by, wrap};

/// Shows the case in each dialect that it has. Dialects that agree on everything share one page.
///
/// # Errors
/// No folder of cases; no such case, where the error names similar ones.
pub fn execute(arguments: &ShowArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let named = NamedCase::load(&arguments.case, arguments.cases.as_deref())?;
    let groups = grouped_by(named.cases(), |one, other| same(one, other));
    for (number, group) in groups.iter().enumerate() {
        if number > 0 {
            writeln!(out, "\n{DIM}{}{DIM:#}\n", "-".repeat(80))?;
        }
        write_group(group, &named.suite, arguments.scan, out)?;
        write_end(group, &named.plan, out)?;
    }
    Ok(case_folder::exit_of(&named.suite))
}

/// Returns whether two cases differ in the dialect only.
fn same(one: &Case, other: &Case) -> bool {
    *one == Case {
        dialect: one.dialect,
        ..other.clone()
    }
}

fn write_group(group: &[&Case], suite: &Suite, scan: Option<u32>, out: &mut dyn Write) -> io::Result<()> {
    let Some(case) = group.first() else { return Ok(()) };
    let dialects: Vec<&str> = group.iter().map(|case| case.dialect.as_str()).collect();
    writeln!(out, "{BOLD}{}{BOLD:#}\n{}\n", case.id, case.title)?;
    if let Some(summary) = &case.summary {
        writeln!(out, "{}\n", wrap(summary))?;
    }
    for (label, text) in facts(case, &dialects, suite) {
        writeln!(out, "{DIM}{label}{DIM:#}{:1$}{text}", "", 10 - label.len())?;
    }
    writeln!(out, "\n{BOLD}Program{BOLD:#}\n")?;
    // The lines of the header and of marks in front are blank.
    let is_blank = |(_, line): &(usize, &str)| line.trim().is_empty();
    for (number, line) in case.source.lines().enumerate().skip_while(is_blank) {
        let gap = if line.is_empty() { "" } else { "  " };
        writeln!(out, "{DIM}{:>4}{DIM:#}{gap}{line}", number + 1)?;
    }
    if case.has_timing() {
        write_diagram(case, scan, out)?;
    }
    writeln!(out, "\n{BOLD}Expected{BOLD:#}\n")?;
    write_expectation(case, out)
}

/// Returns what is known of a case besides its program and expectation, each with its label.
fn facts(case: &Case, dialects: &[&str], suite: &Suite) -> Vec<(&'static str, String)> {
    let mut facts = vec![("basis", case.basis.to_string())];
    if let Some((source, section)) = suite.sources.of(&case.basis) {
        let kind = source.relation.with_kind(source.kind.as_str());
        facts.push(("source", format!("{kind}, {}", source.address_of(section))));
    }
    let is_against = |other: &Contradiction| other.is_of(&case.basis, (&case.id, &case.source));
    let against = documented::contradictions(suite, &[case.dialect], is_against);
    facts.extend(against.into_iter().map(|against| ("but", against)));
    if !case.is_open() {
        facts.push(("binds", bound(case, suite)));
    }
    let held = versions(Claim::of(case), None, suite);
    if held != Versions::default() {
        facts.push(("versions", held.to_string()));
    }
    facts.push(("dialects", dialects.join(", ")));
    facts.push(("at", format!("{}:{}", case.file, case.line)));
    facts.extend(
        case.question
            .iter()
            .map(|question| ("asks", question.to_string())),
    );
    if !case.tags.is_empty() {
        facts.push(("tags", case.tags.join(", ")));
    }
    if case.scans != 1 {
        facts.push(("scans", case.scans.to_string()));
    }
    facts
}

/// Draws the scans of a case as a timing diagram: of many those up to `scan`, or the first.
fn write_diagram(case: &Case, scan: Option<u32>, out: &mut dyn Write) -> io::Result<()> {
    const MAX_SCANS: u32 = 48;
    let last = scan.unwrap_or(MAX_SCANS).clamp(1, case.scans);
    let first = last.saturating_sub(MAX_SCANS - 1).max(1);
    writeln!(out, "\n{BOLD}Scans{BOLD:#}\n")?;
    for line in case.timing_diagram(first..=last).lines() {
        writeln!(out, "  {line}")?;
    }
    match case.scans - (last - first + 1) {
        0 => Ok(()),
        more => writeln!(
            out,
            "\n  {more} more of {} scans: --scan N draws those up to N",
            case.scans
        ),
    }
}

/// Returns whom the expectation of a case binds, and why.
fn bound(case: &Case, suite: &Suite) -> String {
    let dialect = case.dialect;
    match binding(Claim::of(case), None, suite) {
        Binding::Own => match suite.sources.of(&case.basis).map(|(source, _)| source) {
            Some(source) if !source.relation.is_maker() => format!(
                "compilers of {dialect}, by the word of {}, who does not make them",
                source.publisher
            ),
            _ => format!("compilers of {dialect}: the source speaks for this system"),
        },
        Binding::Standard => format!("compilers of {dialect}: it declares all features of the program"),
        Binding::Undeclared(feature) => {
            format!(
                "no compiler of {dialect}, which does not declare the feature `{feature}`: a miss differs"
            )
        }
        Binding::Rule => "no compiler without --strict-rules: a miss differs".to_owned(),
        Binding::OtherSystem => {
            format!("no compiler of {dialect}: the source speaks for another system, and a miss differs")
        }
        Binding::Contradicted(by) => {
            format!("no compiler of {dialect}: `{by}` says otherwise of this system, and a miss differs")
        }
        Binding::OtherVersion(versions) => versions.to_string(),
    }
}

/// Writes the command that runs the cases.
fn write_end(group: &[&Case], plan: &Plan, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "\n{BOLD}Run it{BOLD:#}\n")?;
    group
        .iter()
        .try_for_each(|case| writeln!(out, "  {}", plan.rerun(case, "reference")))
}

/// Writes the expectation of a case in the form of reports.
fn write_expectation(case: &Case, out: &mut dyn Write) -> io::Result<()> {
    // What is expected after a scan stands in the diagram.
    let is_drawn = |fact: &Fact| matches!(fact, Fact::Value { name, .. } if name.contains('@'));
    let expected: Vec<Fact> = expected_facts(case)
        .into_iter()
        .filter(|fact| !is_drawn(fact))
        .collect();
    for line in Fact::text(&expected).lines() {
        writeln!(out, "  {line}")?;
    }
    let asserted = |name: &str| case.expectation.values.iter().any(|value| &*value.name == name);
    for observed in case.observe.iter().filter(|observed| !asserted(&observed.name)) {
        writeln!(
            out,
            "  {} : {} is recorded and not judged",
            observed.name, observed.type_name
        )?;
    }
    Ok(())
}
