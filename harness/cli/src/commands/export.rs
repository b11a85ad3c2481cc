//! `stickler export`: writes pages of programs for a compiler behind an editor.

use crate::arguments::{ExportArguments, SelectionArguments};
use crate::case_folder::{self, CaseFolder, Loaded};
use crate::exit::Exit;
use crate::{output, run_plan, shell};
use std::collections::BTreeSet;
use std::io::Write;
use std::path::PathBuf;
use std::sync::Arc;
use stickler_conversions::recording::{all_questions, program_of};
use stickler_export::{ANSWERS, CASES, ExportPlan, Exported, ExtraCases, ProjectPlan, export, export_plain};
use stickler_run::{Filter, select};
use stickler_suite::{Acceptance, Case, Expectation};
use stickler_types::{DialectName, Question, counted};

/// Writes the pages, and shows which cases are on them and which are not.
///
/// # Errors
/// A folder that holds other files, or cannot be written; no folder of cases.
pub fn execute(arguments: &ExportArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let Some(dialect) = arguments.dialect else {
        return export_cases(arguments, out);
    };
    match (arguments.plain, arguments.recording) {
        (true, _) => export_cases(arguments, out),
        (false, true) => export_questions(dialect, arguments, out),
        (false, false) => export_pages(dialect, arguments, out),
    }
}

/// Writes cases as lines of JSON and files of Structured Text.
///
/// # Errors
/// As [`execute`].
fn export_cases(arguments: &ExportArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let folder = CaseFolder::locate(arguments.cases.as_deref())?;
    let plan = run_plan::plan(&selection(arguments), None);
    let Loaded { suite, .. } = folder.load_for(&plan, &[])?;
    let selected: Vec<&Case> = select(&plan, &suite.cases);
    if selected.is_empty() {
        return Ok(case_folder::nothing_selected(&plan, &folder.load_whole(&plan)));
    }
    let exported = export_plain(&selected, &suite.sources, &arguments.folder)?;
    let cases = counted(exported.cases as u64, "case", "cases");
    let programs = counted(exported.programs as u64, "file", "files");
    writeln!(
        out,
        "{}: {cases} in {CASES}, {programs} of Structured Text in programs",
        arguments.folder.display()
    )?;
    for (reason, cases) in &exported.without {
        writeln!(out, "  {cases:>6} have no file: {reason}")?;
    }
    Ok(case_folder::exit_of(&suite))
}

fn selection(arguments: &ExportArguments) -> SelectionArguments {
    SelectionArguments {
        cases: arguments.cases.clone(),
        filter: arguments.filter.clone().into_iter().collect(),
        dialect: arguments.dialect.into_iter().collect(),
        ..SelectionArguments::default()
    }
}

/// Writes the pages of cases.
///
/// # Errors
/// As [`execute`].
fn export_pages(
    dialect: DialectName,
    arguments: &ExportArguments,
    out: &mut dyn Write,
) -> anyhow::Result<Exit> {
    let folder = CaseFolder::locate(arguments.cases.as_deref())?;
    let plan = run_plan::plan(&selection(arguments), None);
    let Loaded { suite, defined, .. } = folder.load_for(&plan, &[])?;
    let selected: Vec<&Case> = select(&plan, &suite.cases);
    if selected.is_empty() {
        return Ok(case_folder::nothing_selected(&plan, &folder.load_whole(&plan)));
    }
    let plan = ExportPlan {
        defined: defined
            .into_iter()
            .find(|defined| defined.name == dialect.as_str()),
        suite: suite.version.clone(),
        ..export_plan(dialect, arguments, &selected)
    };
    let exported = export(&plan, &selected, &arguments.folder)?;
    show(&exported, dialect, arguments, out)?;
    Ok(exit(&exported).max(case_folder::exit_of(&suite)))
}

/// Exports the questions of a recording as open cases.
///
/// # Errors
/// As [`execute`].
fn export_questions(
    dialect: DialectName,
    arguments: &ExportArguments,
    out: &mut dyn Write,
) -> anyhow::Result<Exit> {
    let filter = arguments.filter.as_deref().map(Filter::new);
    let cases: Vec<Case> = all_questions(dialect)
        .into_iter()
        .map(|question| question_case(question, dialect))
        .filter(|case| {
            filter
                .as_ref()
                .is_none_or(|filter| filter.fits(&case.id, case.dialect.as_str()))
        })
        .collect();
    let selected: Vec<&Case> = cases.iter().collect();
    let mut plan = export_plan(dialect, arguments, &selected);
    plan.with.insert(ExtraCases::Open);
    let exported = export(&plan, &selected, &arguments.folder)?;
    show(&exported, dialect, arguments, out)?;
    Ok(exit(&exported))
}

/// Returns the case that asks a question of a recording: whether its program is accepted is open, and so are its values.
fn question_case(question: Question, dialect: DialectName) -> Case {
    let program = program_of(&question);
    let id = question.to_string();
    Case {
        title: id.as_str().into(),
        basis: "rule: not-stated".into(),
        area: "recording".into(),
        observe: program.observations().into(),
        question: Some(Arc::new(question)),
        expectation: Arc::new(Expectation {
            accepted: Acceptance::Observed,
            ..Expectation::default()
        }),
        ..Case::of_program(&id, dialect, &program.source())
    }
}

/// Returns the plan of an export of these cases, without a suite.
fn export_plan(dialect: DialectName, arguments: &ExportArguments, selected: &[&Case]) -> ExportPlan {
    ExportPlan {
        dialect,
        defined: None,
        suite: env!("CARGO_PKG_VERSION").to_owned(),
        cases_per_page: usize::from(arguments.cases_per_page),
        with: arguments.with.iter().copied().collect(),
        without: without(dialect, arguments, selected),
        sample: arguments
            .sample
            .map(|sample| usize::try_from(sample).unwrap_or(usize::MAX)),
        panes: arguments.panes,
        project: arguments.plcopen.clone().map(project),
    }
}

fn exit(exported: &Exported) -> Exit {
    Exit::NothingTested.when(exported.cases == 0)
}

/// Returns the plan of a project file that is created now.
fn project(file: PathBuf) -> ProjectPlan {
    let created = run_plan::now().to_string();
    ProjectPlan { file, created }
}

/// Reads the ids of the cases to be left out, which may have `@dialect` at their end, as `stickler list` and reports write them.
fn without(dialect: DialectName, arguments: &ExportArguments, selected: &[&Case]) -> BTreeSet<String> {
    let dialect = format!("@{dialect}");
    let ids = arguments
        .without
        .iter()
        .map(|named| named.strip_suffix(&dialect).unwrap_or(named).to_owned());
    let ids: BTreeSet<String> = ids.collect();
    for stranger in ids
        .iter()
        .filter(|id| selected.iter().all(|case| *case.id != ***id))
    {
        output::note(format!(
            "--without `{stranger}` leaves out nothing; no case that was selected has this id"
        ));
    }
    ids
}

fn show(
    exported: &Exported,
    dialect: DialectName,
    arguments: &ExportArguments,
    out: &mut dyn Write,
) -> std::io::Result<()> {
    let folder = arguments.folder.display();
    let pages = counted(exported.pages as u64, "page", "pages");
    let cases = counted(exported.cases as u64, "case", "cases");
    writeln!(out, "{folder}: {pages} with {cases} in {dialect}")?;
    if exported.compiled_only > 0 {
        writeln!(out, "  {} of them only to be compiled", exported.compiled_only)?;
    }
    if exported.answered > 0 {
        let answered = counted(
            exported.answered as u64,
            "case has its answer",
            "cases have their answers",
        );
        writeln!(out, "  {answered} in {ANSWERS} already, and no program")?;
    }
    let left_out: usize = exported.left_out.values().sum();
    if left_out > 0 {
        writeln!(out, "{} left out:", counted(left_out as u64, "case", "cases"))?;
    }
    for (reason, cases) in &exported.left_out {
        writeln!(out, "  {cases:>6} {reason}")?;
    }
    if exported.cases > 0 {
        let folder = shell::quote(&arguments.folder.to_string_lossy()).into_owned();
        if let Some(project) = &arguments.plcopen {
            let pages = match exported.compiled_only {
                0 => "all pages",
                _ => "all pages but those that are only compiled",
            };
            writeln!(out, "{}: {pages}, as one PLCopen XML project", project.display())?;
        }
        let start = match arguments.plcopen {
            Some(_) => "import the project, let it run, copy the array `results` of each program",
            None => "paste each page, let it run, copy its array `results`",
        };
        writeln!(out, "Next: {start} into a file, and")?;
        let names = match arguments.recording {
            true => "--record NAME.toml --product NAME --product-version VERSION --platform TEXT",
            false => "--engine-name NAME",
        };
        writeln!(
            out,
            "  {} import FILE --export {folder} {names}{}",
            shell::program(),
            run_plan::places(None)
        )?;
    }
    Ok(())
}
