//! Tests Ctrl-C: each command ends with exit code 130 and with what it has, and leaves no engine behind.

use crate::common::{SUITE, interrupt, stickler, text, under_way};
use std::fs::{self, File};
use std::io::{BufRead, BufReader, Read};
use std::path::Path;
use std::process::{Child, ChildStdout, Command};
use std::time::{Duration, Instant};
use stickler_mdtest::assert_fits;
use stickler_report::LogError;
use stickler_report::events::Reader;
use tempfile::TempDir;

/// An engine that never answers, and opens the pipe that `WITNESS` names when it has its first request.
const HANGS: &str = concat!(
    "cmd:sh '",
    env!("CARGO_MANIFEST_DIR"),
    "/tests/cmd/conversions.in/hangs.sh'"
);

/// The time after which a command must have begun, however busy the machine is.
const TIMEOUT: Duration = Duration::from_secs(300);

/// Waits until something is there that a command makes; fails where it does not come.
fn wait_for(is_there: impl Fn() -> bool) {
    let began = Instant::now();
    while !is_there() {
        assert!(began.elapsed() < TIMEOUT, "the command does not begin");
        std::thread::sleep(Duration::from_millis(20));
    }
}

/// Waits for the end of a command that was interrupted; returns what it printed on both streams.
fn ended(command: Child) -> String {
    let end = command.wait_with_output().expect("an end");
    let shown = text(&end.stdout) + &text(&end.stderr);
    assert_eq!(end.status.code(), Some(130), "{shown}");
    shown
}

/// Returns after how many cases the event log of the last run was cut short, and the number of its events.
fn log(folder: &Path) -> (u64, usize) {
    let mut log = Reader::open(&folder.join("reports/latest/events.jsonl.gz")).expect("an event log");
    let events: Vec<_> = log.by_ref().collect::<Result<_, _>>().expect("a readable log");
    match log.check_complete() {
        Err(LogError::Truncated(cases)) => (cases, events.len()),
        complete => panic!("the log is not cut short: {complete:?}"),
    }
}

/// Makes a folder with a suite that takes minutes, since each case runs into the step limit.
fn slow_suite() -> TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let suite = folder.path().join("conformance-cases");
    fs::create_dir_all(suite.join("language")).expect("a folder of cases");
    for file in ["suite.toml", "dialects.toml", "sources.toml"] {
        let copied = suite.join(file);
        fs::copy(format!("{SUITE}/{file}"), copied).expect("a file that describes the suite");
    }
    let rows: String = (0..2000).map(|number| format!("[\"{number}\"],\n")).collect();
    let table = include_str!("endless.toml").replace("ROWS", &rows);
    fs::write(suite.join("language/endless.toml"), table).expect("a table");
    folder
}

#[test]
fn a_run_leaves_a_readable_log_that_is_marked_as_cut_short() {
    let folder = slow_suite();
    let run = under_way(&mut stickler(folder.path(), &["run", "--jobs", "1"]));
    let latest = folder.path().join("reports/latest");
    // The header is the first line.
    wait_for(|| fs::read(latest.join("events.jsonl.gz")).is_ok_and(|bytes| bytes.len() > 10));
    interrupt(&run);
    let shown = ended(run);
    assert!(log(folder.path()).0 < 2000);
    assert!(shown.contains("Cut short after"), "{shown}");
    assert_fits(&shown, "…events.jsonl.gz, as far as the run came…");
    let left = fs::read_dir(latest).expect("the folder").count();
    assert_eq!(left, 1, "only the log is left");
}

/// Starts a command whose engine opens the pipe that `WITNESS` names, sends SIGINT, and waits for the end of command and engine; returns
/// what the command printed.
fn interrupted_with_engine(folder: &Path, command: &str, engine: &str) -> String {
    let witness = folder.join("witness");
    let made = Command::new("mkfifo").arg(&witness).status().expect("mkfifo");
    assert!(made.success());
    let arguments: Vec<&str> = command.split(' ').chain(["--engine", engine]).collect();
    let run = under_way(stickler(folder, &arguments).env("WITNESS", &witness));
    // The pipe opens when the engine opens it, and ends when no process holds it any more.
    let mut pipe = File::open(&witness).expect("the witness");
    interrupt(&run);
    pipe.read_to_end(&mut Vec::new()).expect("the end of the pipe");
    ended(run)
}

#[test]
fn no_engine_is_left_behind() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    interrupted_with_engine(folder.path(), "conversions REAL_TO_INT 2.5", HANGS);
}

#[test]
fn a_run_ends_whose_engine_does_not_start() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let never = r#"cmd:sh -c 'exec 9>"$WITNESS"; tail -f /dev/null >/dev/null 2>&1'"#;
    interrupted_with_engine(folder.path(), "run --no-report", never);
}

#[test]
fn a_run_ends_although_its_engine_does_not_answer_and_leaves_a_readable_log() {
    let folder = slow_suite();
    let shown = interrupted_with_engine(folder.path(), "run --jobs 1", HANGS);
    let notice = "stopping; Ctrl-C again ends at once\n";
    assert!(shown.contains(notice), "{shown}");
    // The end of the killed engine is not counted as one of its answers, so the log has a header alone.
    assert_eq!(log(folder.path()), (0, 1));
}

/// Starts a command, and returns it with its first lines and its further output.
fn begun(folder: &Path, arguments: &[&str], lines: usize) -> (Child, String, BufReader<ChildStdout>) {
    let mut command = under_way(&mut stickler(folder, arguments));
    let mut out = BufReader::new(command.stdout.take().expect("a pipe"));
    let mut shown = String::new();
    for _ in 0..lines {
        out.read_line(&mut shown).expect("a line");
    }
    (command, shown, out)
}

#[test]
fn a_campaign_ends_with_what_it_has() {
    let folder = tempfile::tempdir().expect("a folder");
    let fuzz = ["fuzz", "--target", "execute", "--time", "10m", "--findings", "."];
    let (campaign, mut shown, mut out) = begun(folder.path(), &fuzz, 1);
    // The handler stands when the record of the campaign is there.
    let record = folder.path().join("campaign.json");
    wait_for(|| record.exists());
    interrupt(&campaign);
    out.read_to_string(&mut shown).expect("the rest");
    ended(campaign);
    assert_fits(&shown, "… programs in …stopped before its end…");
    let record = fs::read_to_string(record).expect("the record");
    assert!(record.contains("\"complete\": false"), "{record}");
}

#[test]
fn a_sweep_tells_how_far_it_came() {
    // Billions of texts, so that it cannot end by itself before the signal comes. The lines are shown when the handler stands and the
    // sweep is about to begin.
    let arguments = ["sweep", "DINT_TO_STRING", "--jobs", "1"];
    let (sweep, mut shown, mut out) = begun(Path::new("."), &arguments, 2);
    assert!(shown.contains("4,294,967,296 inputs: every DINT"), "{shown}");
    interrupt(&sweep);
    out.read_to_string(&mut shown).expect("the rest");
    ended(sweep);
    for part in [
        "  stopped by Ctrl-C after ",
        " of 4,294,967,296 inputs (",
        "  no mismatch so far, ",
    ] {
        assert!(shown.contains(part), "{part}\n{shown}");
    }
}

#[test]
fn a_reduction_ends_with_the_smallest_program_so_far() {
    let folder = tempfile::tempdir().expect("a folder");
    for file in ["start.st", "slow.sh"] {
        let from = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cmd/reduce.in");
        fs::copy(from.join(file), folder.path().join(file)).expect("a copy");
    }
    let reduce = [
        "reduce",
        "start.st",
        "--dialect",
        "matiec",
        "--engine",
        "cmd:sh slow.sh",
    ];
    let run = under_way(&mut stickler(folder.path(), &reduce));
    wait_for(|| folder.path().join("under-way").exists());
    interrupt(&run);
    let shown = ended(run);
    assert_fits(&shown, "PROGRAM main…MOD…");
    assert!(shown.contains("the smallest program so far"), "{shown}");
}
