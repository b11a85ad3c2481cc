//! The conformance run: every case file below `conformance-cases/` is a test of the reference. A file dropped
//! into the folder is a test, with no code touched. The cases of one file run in parallel.
//!
//! `cargo test -p stickler-run --test conformance -- widening` runs the files whose path contains `widening`;
//! the command line (`cargo run --release`) runs the same cases with reports.

use libtest_mimic::{Arguments, Failed, Trial};
use similar::TextDiff;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use stickler_engines::{EngineSession, Reference};
use stickler_run::{Fact, Grade, Judgement, Plan, RunError, Verdict, ask, judge};
use stickler_suite::{Case, load_file};
use stickler_workers::WorkerPool;
use walkdir::WalkDir;

/// The number of cases that a worker is given at a time.
const BATCH_LEN: usize = 64;

/// The path of the suite from this crate's folder, in which cargo runs tests.
const ROOT: &str = "../../conformance-cases";

/// The files that describe the suite; every other file of their kind is a case file.
const DESCRIPTIONS: [&str; 3] = ["dialects.toml", "sources.toml", "suite.toml"];

fn main() -> Result<ExitCode, walkdir::Error> {
    let arguments = Arguments::from_args();
    let trials = case_files()?.into_iter().map(|path| {
        let below = path.strip_prefix(ROOT).unwrap_or(&path);
        let name = format!("conforms::{}", below.display());
        Trial::test(name, move || conforms(&path))
    });
    Ok(libtest_mimic::run(&arguments, trials.collect()).exit_code())
}

/// Returns the paths of all case files, in the order of their names.
fn case_files() -> Result<Vec<PathBuf>, walkdir::Error> {
    let mut paths = Vec::new();
    for entry in WalkDir::new(ROOT).sort_by_file_name() {
        let entry = entry?;
        let path = entry.path();
        let is_description = DESCRIPTIONS.iter().any(|name| path == Path::new(ROOT).join(name));
        let is_case_file = path
            .extension()
            .is_some_and(|kind| kind == "st" || kind == "toml");
        if entry.file_type().is_file() && is_case_file && !is_description {
            paths.push(entry.into_path());
        }
    }
    assert!(!paths.is_empty(), "{ROOT} has no case files");
    Ok(paths)
}

/// Requires the reference to pass every case of the file, by code and line.
fn conforms(path: &Path) -> Result<(), Failed> {
    let (cases, errors) = load_file(Path::new(ROOT), path);
    let reference = Reference::new();
    let judged: Vec<Vec<Option<String>>> = WorkerPool::new(0).map(
        cases.chunks(BATCH_LEN),
        || Ok(EngineSession::new(&reference)),
        |session, cases| {
            cases
                .iter()
                .map(|case| complaint(session, case))
                .collect::<Result<_, RunError>>()
        },
    )?;
    let mut complaints: Vec<String> = errors.iter().map(ToString::to_string).collect();
    complaints.extend(judged.into_iter().flatten().flatten());
    if cases.is_empty() && errors.is_empty() {
        complaints.push("the file holds no case".to_owned());
    }
    if complaints.is_empty() {
        return Ok(());
    }
    let failed = complaints.len();
    Err(format!(
        "{failed} of {} cases failed\n\n{}",
        cases.len(),
        complaints.join("\n")
    )
    .into())
}

/// Describes a case that does not pass.
fn complaint(session: &mut EngineSession<'_>, case: &Case) -> Result<Option<String>, RunError> {
    let judgement = judge(case, &ask(session, case)?, Grade::Code);
    Ok((judgement.verdict != Verdict::Pass).then(|| describe(case, &judgement)))
}

fn describe(case: &Case, judgement: &Judgement) -> String {
    let Judgement {
        verdict,
        expected,
        got,
        ..
    } = judgement;
    let mut text = String::new();
    // Writing into a String does not fail.
    let _ = writeln!(text, "{verdict}  {}  ({}:{})", case.key(), case.file, case.line);
    let _ = writeln!(text, "  {}: {}", case.basis, case.title);
    let (expected, got) = (Fact::text(expected), Fact::text(got));
    for (name, lines) in [("expected", &expected), ("got", &got)] {
        let _ = writeln!(text, "  {name}:");
        lines.lines().for_each(|line| text.extend(["    ", line, "\n"]));
    }
    let _ = writeln!(text, "  diff:");
    // Both end their last line, or it would differ from an equal line that is not the last.
    let (expected, got) = (format!("{expected}\n"), format!("{got}\n"));
    for change in TextDiff::from_lines(expected.as_str(), got.as_str()).iter_all_changes() {
        let line = change.value().trim_end_matches('\n');
        let _ = writeln!(text, "    {}{line}", change.tag());
    }
    let _ = writeln!(text, "  again: {}", Plan::default().rerun(case, "reference"));
    text
}
