//! `stickler show`: shows one case.

use crate::arguments::{SelectionArguments, ShowArguments};
use crate::case_folder::{self, CaseFolder};
use crate::exit::Exit;
use anstyle::Style;
use anyhow::bail;
use std::io::{self, Write};
use stickler_engines::Outcome;
use stickler_run::{Answers, Fact, Filter, Grade, Plan, judge};
use stickler_suite::{Case, Suite};
use stickler_types::wrap;

const BOLD: Style = Style::new().bold();
const DIM: Style = Style::new().dimmed();

/// The maximum number of ids that are suggested for an unknown one.
const MAX_SUGGESTIONS: usize = 5;

/// The maximum length of a name that is compared with ids; a longer one is no misspelt id.
const MAX_NAME_LEN: usize = 200;

/// Shows the case in each dialect that it has. Dialects that agree on everything share one page.
///
/// # Errors
/// No folder of cases; no such case, where the error names similar ones.
pub fn execute(arguments: &ShowArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let selection = SelectionArguments {
        cases: arguments.cases.clone(),
        filter: Some(arguments.case.clone()),
        ..SelectionArguments::default()
    };
    let plan = case_folder::plan(&selection, None);
    let dialect = Filter::new(arguments.case.as_str()).dialect();
    let suite = CaseFolder::locate(arguments.cases.as_deref())?.load_selected(&plan, dialect);
    let named: Vec<&Case> = suite
        .cases
        .iter()
        .filter(|case| is_named(case, &arguments.case))
        .collect();
    if named.is_empty() {
        bail!("{}", no_such_case(&suite, &arguments.case));
    }
    for (number, group) in groups(&named).iter().enumerate() {
        if number > 0 {
            writeln!(out, "\n{DIM}{}{DIM:#}\n", "-".repeat(80))?;
        }
        write_group(group, out)?;
        write_end(group, &plan, out)?;
    }
    Ok(case_folder::exit_of(&suite))
}

fn is_named(case: &Case, name: &str) -> bool {
    match name.strip_prefix(&*case.id) {
        Some("") => true,
        Some(rest) => rest.strip_prefix('@') == Some(case.dialect.as_str()),
        None => false,
    }
}

/// Groups the cases that differ in the dialect only.
fn groups<'a>(cases: &[&'a Case]) -> Vec<Vec<&'a Case>> {
    let mut groups: Vec<Vec<&Case>> = Vec::new();
    for case in cases {
        match groups
            .iter_mut()
            .find(|group| group.first().is_some_and(|first| same(first, case)))
        {
            Some(group) => group.push(case),
            None => groups.push(vec![case]),
        }
    }
    groups
}

fn same(one: &Case, other: &Case) -> bool {
    *one == Case {
        dialect: one.dialect,
        ..other.clone()
    }
}

fn write_group(group: &[&Case], out: &mut dyn Write) -> io::Result<()> {
    let Some(case) = group.first() else { return Ok(()) };
    let dialects: Vec<&str> = group.iter().map(|case| case.dialect.as_str()).collect();
    writeln!(out, "{BOLD}{}{BOLD:#}\n{}\n", case.id, case.title)?;
    if let Some(summary) = &case.summary {
        writeln!(out, "{}\n", wrap(summary))?;
    }
    writeln!(out, "{DIM}basis{DIM:#}     {}", case.basis)?;
    writeln!(out, "{DIM}dialects{DIM:#}  {}", dialects.join(", "))?;
    writeln!(out, "{DIM}at{DIM:#}        {}:{}", case.file, case.line)?;
    if !case.tags.is_empty() {
        writeln!(out, "{DIM}tags{DIM:#}      {}", case.tags.join(", "))?;
    }
    if case.scans != 1 {
        writeln!(out, "{DIM}scans{DIM:#}     {}", case.scans)?;
    }
    writeln!(out, "\n{BOLD}Program{BOLD:#}\n")?;
    for (number, line) in case.source.lines().enumerate() {
        let gap = if line.is_empty() { "" } else { "  " };
        writeln!(out, "{DIM}{:>4}{DIM:#}{gap}{line}", number + 1)?;
    }
    writeln!(out, "\n{BOLD}Expected{BOLD:#}\n")?;
    write_expectation(case, out)
}

/// Writes the command that runs the cases.
fn write_end(group: &[&Case], plan: &Plan, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "\n{BOLD}Run it{BOLD:#}\n")?;
    group
        .iter()
        .try_for_each(|case| writeln!(out, "  {}", plan.rerun(case, "reference")))
}

/// Writes the expectation of a case in the form of reports. The text does not depend on the outcome, so any outcome serves.
fn write_expectation(case: &Case, out: &mut dyn Write) -> io::Result<()> {
    let answers = Answers::of_run(Outcome::Unsupported {
        reason: String::new(),
    });
    let expected = judge(case, &answers, Grade::Code).expected;
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

fn no_such_case(suite: &Suite, name: &str) -> String {
    let close = suggestions(suite, name);
    if close.is_empty() {
        return format!("there is no case `{name}`; `stickler list` lists all");
    }
    format!(
        "there is no case `{name}`; did you mean one of these?\n  {}",
        close.join("\n  ")
    )
}

/// Returns the ids that contain the name, or else the ids with the most similar spelling.
fn suggestions<'a>(suite: &'a Suite, name: &str) -> Vec<&'a str> {
    let name = name.split('@').next().unwrap_or(name);
    let mut ids: Vec<&str> = suite.cases.iter().map(|case| &*case.id).collect();
    ids.sort_unstable();
    ids.dedup();
    let mut close: Vec<&str> = ids
        .iter()
        .copied()
        .filter(|id| id.contains(name))
        .take(MAX_SUGGESTIONS)
        .collect();
    if close.is_empty() && name.len() <= MAX_NAME_LEN {
        let mut near: Vec<(usize, &str)> = ids
            .iter()
            .map(|id| (strsim::levenshtein(id, name), *id))
            .filter(|(distance, id)| *distance <= id.len() / 3)
            .collect();
        near.sort_unstable();
        close = near.into_iter().map(|(_, id)| id).take(MAX_SUGGESTIONS).collect();
    }
    close
}
