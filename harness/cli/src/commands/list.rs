//! `stickler list`: lists the cases, the claims that they check, the sources of the claims, the places of values, the features of
//! the language, or how many cases there are.

mod numbers;
pub(super) mod sources;

use crate::arguments::ListArguments;
use crate::case_folder::{self, CaseFolder, Loaded};
use crate::exit::Exit;
use crate::output::{BOLD, DIM, json_line};
use crate::run_plan;
use serde::Serialize;
use serde_json::{Value as Json, json};
use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, Write};
use stickler_report::basis::Basis;
use stickler_run::select;
use stickler_suite::Case;

/// Lists the selected cases, their claims, the sources of these, or the places and features in their programs.
///
/// # Errors
/// No folder of cases; nothing selected.
pub fn execute(arguments: &ListArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let selection = &arguments.selection;
    let plan = run_plan::plan(selection, None);
    let folder = CaseFolder::locate(selection.cases.as_deref())?;
    let Loaded { suite, left_out, .. } = folder.load_for(&plan, &[])?;
    let cases = match arguments.left_out {
        true => left_out.iter().collect(),
        false => select(&plan, &suite.cases),
    };
    if cases.is_empty() {
        return Ok(case_folder::nothing_selected(&plan, &folder.load_whole(&plan)));
    }
    if arguments.sources {
        sources::write(out, &suite.sources, &[], &cases, arguments.json)?;
    } else if arguments.places {
        numbers::write_places(out, &cases, arguments.json)?;
    } else if arguments.count {
        numbers::write_count(out, &cases, arguments.json)?;
    } else if arguments.features {
        numbers::write_features(out, &suite.features, &cases, arguments.json)?;
    } else if arguments.basis {
        write_claims(out, &claims(&cases), arguments.json)?;
    } else {
        cases.into_iter().try_for_each(|case| match arguments.json {
            true => json_line(out, &case_line(case)),
            false => writeln!(out, "{}@{}", case.id, case.dialect),
        })?;
    }
    Ok(case_folder::exit_of(&suite))
}

fn case_line(case: &Case) -> Json {
    json!({
        "id": case.id,
        "dialect": case.dialect.as_str(),
        "title": case.title,
        "basis": case.basis,
        "file": case.file,
        "line": case.line,
        "tags": case.tags,
    })
}

#[derive(Serialize)]
struct ClaimLine<'a> {
    source: &'a str,
    section: &'a str,
    cases: usize,
    files: BTreeSet<&'a str>,
}

/// Returns the claims of the cases, sorted by document and section.
fn claims<'a>(cases: &[&'a Case]) -> Vec<ClaimLine<'a>> {
    let mut claims: BTreeMap<Basis<'_>, ClaimLine<'_>> = BTreeMap::new();
    for case in cases {
        let basis @ Basis { source, section } = Basis::of(&case.basis);
        let claim = claims.entry(basis).or_insert_with(|| ClaimLine {
            source,
            section,
            cases: 0,
            files: BTreeSet::new(),
        });
        claim.cases += 1;
        claim.files.insert(&case.file);
    }
    claims.into_values().collect()
}

fn write_claims(out: &mut dyn Write, claims: &[ClaimLine<'_>], json: bool) -> io::Result<()> {
    if json {
        return claims.iter().try_for_each(|claim| json_line(out, claim));
    }
    let mut source = None;
    for claim in claims {
        if source != Some(claim.source) {
            let gap = if source.is_some() { "\n" } else { "" };
            let sections = claims.iter().filter(|other| other.source == claim.source);
            let cases: usize = sections.map(|section| section.cases).sum();
            writeln!(out, "{gap}{BOLD}{}{BOLD:#}  {cases} cases", claim.source)?;
            source = Some(claim.source);
        }
        let section = if claim.section.is_empty() {
            "(whole document)"
        } else {
            claim.section
        };
        writeln!(out, "{:>8}  {section}", claim.cases)?;
        for file in &claim.files {
            writeln!(out, "          {DIM}{file}{DIM:#}")?;
        }
    }
    Ok(())
}
