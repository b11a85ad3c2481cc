//! `stickler compliance`: the compliance statement of a system, as it is declared and as an engine does.

use crate::arguments::ComplianceArguments;
use crate::case_folder::CaseFolder;
use crate::exit::Exit;
use crate::{documented, engines};
use anyhow::{Context, bail};
use std::fs;
use std::io::Write;
use stickler_engines::Engine;
use stickler_export::{ComplianceForm, CompliancePlan, ComplianceStatement};
use stickler_suite::Case;
use stickler_types::DialectName;

/// Writes the statement of a dialect, or of an engine in the one dialect that it speaks.
///
/// # Errors
/// No folder of cases, an engine that cannot be run or speaks other dialects, a table that the edition does not have, a file that cannot be
/// written.
pub fn execute(arguments: &ComplianceArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let folder = CaseFolder::locate(arguments.cases.as_deref())?;
    let engine = arguments.engine.as_deref().map(engines::by_name).transpose()?;
    let dialect = dialect(arguments, engine.as_deref())?;
    let suite = match (&engine, arguments.table.is_empty()) {
        (None, false) => folder.load_sources(),
        _ => folder.load_with([dialect]),
    };
    let cases: Vec<&Case> = suite
        .cases
        .iter()
        .filter(|case| case.dialect == dialect)
        .collect();
    let mut statements = documented::builder(&cases, &suite, &[dialect]);
    statements.add_all_functions();
    let declared = dialect.rules().features.edition.unwrap_or(3);
    let plan = CompliancePlan {
        suite: &suite,
        statements: &statements,
        dialect,
        edition: arguments.edition.unwrap_or(declared),
        tables: &arguments.table,
        engine: engine.as_deref(),
    };
    let Some(statement) = ComplianceStatement::gather(&plan)? else {
        bail!(
            "edition {} of IEC 61131-3 has no feature of Stickler's list in {}; `stickler list --features` shows the tables",
            plan.edition,
            plan.tables.join(", ")
        );
    };
    let text = statement.text(match (arguments.html, arguments.json) {
        (true, _) => ComplianceForm::Html,
        (_, true) => ComplianceForm::Json,
        _ => ComplianceForm::Markdown,
    })?;
    match &arguments.output {
        Some(file) => fs::write(file, text).with_context(|| format!("cannot write {}", file.display()))?,
        None => out.write_all(text.as_bytes())?,
    }
    Ok(Exit::Failures.when(statement.differs))
}

/// Returns the dialect that is named, or the only one that the engine speaks.
///
/// # Errors
/// None that is named, and an engine that speaks several or not the one that is named.
fn dialect(arguments: &ComplianceArguments, engine: Option<&dyn Engine>) -> anyhow::Result<DialectName> {
    let spoken = match (engine, arguments.dialect) {
        (None, Some(dialect)) => vec![dialect],
        (Some(engine), Some(dialect)) => engines::spoken(engine.identity(), &[dialect])?,
        (Some(engine), None) => engines::spoken(engine.identity(), &DialectName::ALL)?,
        (None, None) => bail!("name a system with --dialect, or a compiler with --engine"),
    };
    match spoken[..] {
        [only] => Ok(only),
        _ => bail!("it speaks {}; name one with --dialect", engines::listed(&spoken)),
    }
}
