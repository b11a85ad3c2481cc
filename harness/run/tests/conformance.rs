//! The conformance run: every case file below `conformance-cases/` is a test of the reference. A file dropped
//! into the folder is a test, with no code touched. The cases of one file run in parallel.
//!
//! `cargo test -p stickler-run --test conformance -- widening` runs the files whose path contains `widening`;
//! the command line (`cargo run --release`) runs the same cases with reports.

use similar::TextDiff;
use std::path::Path;
use stickler_engines::{Engine, EngineSession, Reference};
use stickler_run::{Fact, Judgement, Plan, RunError, Verdict, ask, judge};
use stickler_suite::{Case, load_file};
use stickler_workers::WorkerPool;

/// The number of cases that a worker is given at a time.
const BATCH_LEN: usize = 64;

/// The path of the suite from this crate's folder, in which cargo runs tests.
const ROOT: &str = "../../conformance-cases";

/// Requires the reference to pass every case of the file, by line and by each code that it gives.
fn conforms(path: &Path) -> datatest_stable::Result<()> {
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
    // datatest-stable shows an error on one long line.
    panic!(
        "{} of {} cases failed\n\n{}",
        complaints.len(),
        cases.len(),
        complaints.join("\n")
    );
}

/// Describes a case that does not pass.
fn complaint(session: &mut EngineSession<'_>, case: &Case) -> Result<Option<String>, RunError> {
    let needed = Plan::default().needed(Reference::new().identity(), case);
    let judgement = judge(case, &ask(session, case)?, needed);
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
    text.push_str(&format!(
        "{verdict}  {}  ({}:{})\n",
        case.key(),
        case.file,
        case.line
    ));
    text.push_str(&format!("  {}: {}\n", case.basis, case.title));
    let (expected, got) = (Fact::text(expected), Fact::text(got));
    for (name, lines) in [("expected", &expected), ("got", &got)] {
        text.push_str(&format!("  {name}:\n"));
        lines.lines().for_each(|line| text.extend(["    ", line, "\n"]));
    }
    text.push_str("  diff:\n");
    // Both end their last line, or it would differ from an equal line that is not the last.
    let (expected, got) = (format!("{expected}\n"), format!("{got}\n"));
    for change in TextDiff::from_lines(expected.as_str(), got.as_str()).iter_all_changes() {
        let line = change.value().trim_end_matches('\n');
        text.push_str(&format!("    {}{line}\n", change.tag()));
    }
    text.push_str(&format!(
        "  again: {}\n",
        Plan::default().rerun(case, "reference")
    ));
    text
}

datatest_stable::harness! {
    // The files `dialects.toml`, `features.toml`, `places.toml`, `sources.toml`, `statements.toml`, `suite.toml` and `withdrawn.toml` describe the suite, and the folders
    // `dialects` and `recordings` hold no cases; every other file of these kinds is a case file.
    { test = conforms, root = ROOT, pattern = r"^(?!(dialects|features|places|sources|statements|suite|withdrawn)\.toml$|(dialects|recordings)[/\\]).*\.(st|toml)$" },
}
