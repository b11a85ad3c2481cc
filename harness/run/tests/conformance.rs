//! The conformance run: every case file below `conformance-cases/` is a test of the reference. A file dropped
//! into the folder is a test, with no code touched. The cases of one file run in parallel.
//!
//! `cargo test -p stickler-run --test conformance -- widening` runs the files whose path contains `widening`;
//! the command line (`cargo run --release`) runs the same cases with reports.

use libtest_mimic::{Arguments, Failed, Trial};
use similar::TextDiff;
use std::collections::HashMap;
use std::fmt::Write;
use std::path::Path;
use std::process::ExitCode;
use std::sync::LazyLock;
use stickler_engines::{EngineSession, Reference};
use stickler_run::{Fact, Grade, Judgement, Plan, RunError, Verdict, ask, judge};
use stickler_suite::{Case, Suite, case_files};
use stickler_workers::WorkerPool;

/// The number of cases that a worker is given at a time.
const BATCH_LEN: usize = 64;

/// The path of the suite from this crate's folder, in which cargo runs tests.
const ROOT: &str = "../../conformance-cases";

/// The suite, which takes long to read and is read once.
static SUITE: LazyLock<Suite> = LazyLock::new(|| Suite::load(Path::new(ROOT)));

/// The cases of each file, which come one after the other.
static CASES: LazyLock<HashMap<&str, &[Case]>> = LazyLock::new(|| {
    let files = SUITE.cases.chunk_by(|a, b| a.file == b.file);
    files.map(|cases| (&*cases[0].file, cases)).collect()
});

fn main() -> ExitCode {
    let conforms = case_files(Path::new(ROOT))
        .into_iter()
        .map(|file| Trial::test(file.clone(), move || conforms(&file)));
    let trials = [Trial::test("the suite has no mistakes", no_mistakes)];
    libtest_mimic::run(
        &Arguments::from_args(),
        trials.into_iter().chain(conforms).collect(),
    )
    .exit_code()
}

fn no_mistakes() -> Result<(), Failed> {
    match &SUITE.errors[..] {
        [] => Ok(()),
        errors => Err(errors
            .iter()
            .map(|error| format!("{error}\n"))
            .collect::<String>()
            .into()),
    }
}

/// Requires the reference to pass every case of the file, by code and line.
fn conforms(file: &str) -> Result<(), Failed> {
    let cases = *CASES.get(file).ok_or("the file holds no case")?;
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
    let complaints: Vec<String> = judged.into_iter().flatten().flatten().collect();
    if complaints.is_empty() {
        return Ok(());
    }
    let failed = complaints.len();
    let text = format!(
        "{failed} of {} cases failed\n\n{}",
        cases.len(),
        complaints.join("\n")
    );
    Err(text.into())
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
