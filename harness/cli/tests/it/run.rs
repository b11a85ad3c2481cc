//! Tests the results of a run: reports, exit codes, and a readable event log when it is cut short.

#[cfg(unix)]
use crate::common::interrupt;
use crate::common::{STICKLER, SUITE, output, stickler, text, under_way};
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use stickler_report::events::{self, Completeness};
use stickler_run::{EngineHeader, Event};

fn read_log(path: &Path) -> (Vec<Event>, Completeness) {
    let mut events = Vec::new();
    let bytes = fs::read(path).expect("an event log");
    let completeness = events::read(&bytes[..], &mut |event| events.push(event)).expect("a readable log");
    (events, completeness)
}

/// Returns the entry of an engine in the header of an event log.
fn engine<'e>(events: &'e [Event], name: &str) -> &'e EngineHeader {
    let Some(Event::Header(header)) = events.first() else {
        panic!("no header")
    };
    let mut engines = header.engines.iter();
    engines.find(|engine| engine.name == name).expect("the engine")
}

#[test]
fn what_failed_is_annotated_in_a_job_of_github_or_on_request() {
    let folder = tempfile::tempdir().expect("a folder");
    let run = ["run", "--cases", SUITE, "--no-report"];
    let errors = |job: &str, more: &[&str]| {
        let mut command = stickler(folder.path(), &[&run[..], more].concat());
        let output = command
            .env("GITHUB_ACTIONS", job)
            .output()
            .expect("the command runs");
        let shown = text(&output.stdout);
        let last = shown.lines().last().unwrap_or_default();
        assert!(last.contains("not as expected"), "{shown}");
        shown
            .lines()
            .filter(|line| line.starts_with("::error file="))
            .count()
    };
    assert_eq!(errors("", &[]), 0);
    let asked = errors("", &["--annotate", "github"]);
    assert!(asked > 0);
    assert_eq!(errors("true", &[]), asked);
    assert_eq!(errors("true", &["--annotate", "off"]), 0);
}

#[test]
fn a_quiet_run_shows_its_result_and_its_page_and_a_verbose_one_every_source() {
    let folder = tempfile::tempdir().expect("a folder");
    let shown = |more: &[&str]| {
        let run = output(folder.path(), &[&["run", "--cases", SUITE], more].concat());
        assert_eq!(run.status.code(), Some(1), "{}", text(&run.stderr));
        text(&run.stdout)
    };
    let quiet = shown(&["--quiet"]);
    let [result, page] = quiet.lines().collect::<Vec<_>>()[..] else {
        panic!("{quiet}");
    };
    assert!(
        result.starts_with("1 of 16 cases not as expected (1 fail), in "),
        "{quiet}"
    );
    assert_eq!(page, "Page: reports/latest/index.html");
    let verbose = shown(&["--verbose"]);
    assert!(verbose.contains("\n  ironplc-type-conversions "), "{verbose}");
    assert!(
        verbose.ends_with("\nPage: reports/latest/index.html\n"),
        "{verbose}"
    );
    let both = output(folder.path(), &["run", "--quiet", "--verbose"]);
    assert_eq!(both.status.code(), Some(2));
}

#[test]
fn the_tables_fit_the_columns_and_a_pipe_gets_no_control_character() {
    let folder = tempfile::tempdir().expect("a folder");
    let whole = concat!(env!("CARGO_MANIFEST_DIR"), "/../../conformance-cases");
    for width in [60, 100, 200] {
        let arguments = ["run", "--cases", whole, "--filter", "language/*", "--no-report"];
        let mut command = stickler(folder.path(), &arguments);
        let run = command.env("COLUMNS", width.to_string()).env_remove("NO_COLOR");
        let run = run.output().expect("the command runs");
        assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
        let shown = text(&run.stdout);
        let widest = shown.lines().map(|line| line.chars().count()).max();
        assert!(widest <= Some(width) && shown.lines().count() <= 24, "{shown}");
        let streams = format!("{shown}{}", text(&run.stderr));
        assert!(
            !streams.chars().any(|c| c.is_control() && c != '\n'),
            "{streams:?}"
        );
    }
}

#[test]
fn a_shell_completes_every_command() {
    let folder = tempfile::tempdir().expect("a folder");
    let help = output(folder.path(), &["--help"]);
    let help = text(&help.stdout);
    let listed = help.split("Commands:\n").nth(1).expect("the commands");
    let commands = listed.lines().take_while(|line| !line.is_empty());
    // Further lines of a description are indented more.
    let commands: Vec<&str> = commands
        .filter_map(|line| line.strip_prefix("  ")?.split(' ').next())
        .filter(|name| !name.is_empty())
        .collect();
    assert!(commands.len() > 20, "{commands:?}");
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let made = output(folder.path(), &["completions", shell]);
        assert_eq!(made.status.code(), Some(0));
        let script = text(&made.stdout);
        let missing: Vec<_> = commands.iter().filter(|name| !script.contains(**name)).collect();
        assert!(missing.is_empty(), "{shell}: {missing:?}");
    }
}

#[test]
fn a_run_writes_every_report_about_the_same_cases() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let run = output(folder.path(), &["run", "--cases", SUITE]);
    assert_eq!(run.status.code(), Some(1), "{}", text(&run.stderr));
    let latest = folder.path().join("reports/latest");
    let (events, completeness) = read_log(&latest.join("events.jsonl"));
    assert_eq!(completeness, Completeness::Complete);
    let cases = events
        .iter()
        .filter(|event| matches!(event, Event::Case(_)))
        .count();
    let results: serde_json::Value =
        serde_json::from_slice(&fs::read(latest.join("results.json")).expect("results")).expect("JSON");
    assert_eq!(results["cases"].as_array().map(Vec::len), Some(1));
    assert_eq!(results["engines"][0]["totals"]["pass"], cases - 1);
    let junit = fs::read_to_string(latest.join("junit.xml")).expect("JUnit");
    let claims = results["claims"].as_array().map_or(0, Vec::len);
    let tests = junit.matches("<testcase ").count();
    assert!((claims + 2..claims + cases).contains(&tests), "{tests}: {junit}");
    assert_eq!(junit.matches("<failure ").count(), 2, "the case and its claim");
    let summary = fs::read_to_string(latest.join("summary.md")).expect("a summary");
    assert!(
        summary.starts_with(&format!("# Stickler: 1 of {cases} cases not as expected\n")),
        "{summary}"
    );
}

#[test]
fn the_rerun_command_of_a_failure_runs_that_case_alone() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    output(folder.path(), &["run", "--cases", SUITE]);
    let (events, _) = read_log(&folder.path().join("reports/latest/events.jsonl"));
    let failed = events.iter().find_map(|event| match event {
        Event::Case(case) if !case.verdict.is_as_expected() => Some(case),
        _ => None,
    });
    let failed = failed.expect("a failure");
    let rerun = engine(&events, "reference").rerun(&failed.id, &failed.dialect);
    let arguments = rerun.strip_prefix("stickler ").expect("a command line");
    let program = STICKLER;
    let shell = Command::new("sh")
        .current_dir(folder.path())
        .args(["-c", &format!("'{program}' {arguments}")])
        .output()
        .expect("a shell");
    assert_eq!(shell.status.code(), Some(1), "{rerun}");
    assert!(
        text(&shell.stdout).contains("1 of 1 case not as expected"),
        "{}",
        text(&shell.stdout)
    );
}

#[test]
fn the_parts_of_a_divided_run_are_the_whole() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let ids = |arguments: &[&str], report: &str| {
        let common = ["run", "--cases", SUITE, "--report", report];
        output(folder.path(), &[&common, arguments].concat());
        let (events, _) = read_log(&folder.path().join(report).join("events.jsonl"));
        let mut ids: Vec<String> = events
            .iter()
            .filter_map(|event| match event {
                Event::Case(case) => Some(format!("{}@{}", case.id, case.dialect)),
                Event::Header(_) | Event::Cause(_) | Event::Footer(_) => None,
            })
            .collect();
        ids.sort();
        ids
    };
    let mut parts = [ids(&["--shard", "1/2"], "one"), ids(&["--shard", "2/2"], "two")].concat();
    parts.sort();
    assert_eq!(parts, ids(&[], "whole"));
}

#[test]
fn a_report_folder_that_cannot_be_written_is_an_error_before_the_run() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("blocked"), "").expect("a file in the way");
    let run = output(
        folder.path(),
        &["run", "--cases", SUITE, "--report", "blocked/latest"],
    );
    assert_eq!(run.status.code(), Some(2));
    assert!(
        text(&run.stderr).contains("cannot write blocked/latest; name another folder"),
        "{}",
        text(&run.stderr)
    );
    assert_eq!(text(&run.stdout), "", "nothing was run");
}

#[test]
fn a_filter_that_leaves_nothing_keeps_the_reports_of_the_last_run() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    output(folder.path(), &["run", "--cases", SUITE]);
    let run = output(
        folder.path(),
        &["run", "--cases", SUITE, "--filter", "nothing-like-this"],
    );
    assert_eq!(run.status.code(), Some(4));
    let (_, completeness) = read_log(&folder.path().join("reports/latest/events.jsonl"));
    assert_eq!(completeness, Completeness::Complete);
}

#[test]
fn a_reader_that_goes_away_is_no_error() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut list = under_way(&mut stickler(folder.path(), &["list", "--cases", SUITE]));
    drop(list.stdout.take());
    let end = list.wait_with_output().expect("the command ends");
    assert_eq!(end.status.code(), Some(0));
    assert_eq!(text(&end.stderr), "");
}

#[test]
fn a_reader_that_goes_away_does_not_turn_a_rejection_into_success() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("bad.st"), "PROGRAM main x := 1; END_PROGRAM").expect("a program");
    let mut check = under_way(&mut stickler(
        folder.path(),
        &["check", "bad.st", "--dialect", "matiec"],
    ));
    drop(check.stdout.take());
    let end = check.wait_with_output().expect("the command ends");
    assert_eq!(end.status.code(), Some(1), "{}", text(&end.stderr));
}

/// Writes a suite that takes minutes, since each case runs into the step limit.
fn slow_suite(folder: &Path) {
    let cases = folder.join("conformance-cases/language");
    fs::create_dir_all(&cases).expect("a folder of cases");
    for file in ["suite.toml", "dialects.toml", "sources.toml"] {
        let copied = folder.join("conformance-cases").join(file);
        fs::copy(format!("{SUITE}/{file}"), copied).expect("a file that describes the suite");
    }
    let rows: String = (0..2000).map(|number| format!("[\"{number}\"],\n")).collect();
    let table = format!(
        "title = \"Endless\"\nbasis = \"iec-61131-3: Table 24\"\ndialects = [\"matiec\"]\n\
         columns = [\"number\"]\nrows = [\n{rows}]\n\n[[probe]]\nname = \"loop\"\nsource = \"\"\"\n\
         PROGRAM main\nVAR\n    a : INT := {{number}};\nEND_VAR\n\
         WHILE a = a DO (*! fault step-limit *)\n    a := a;\nEND_WHILE;\nEND_PROGRAM\n\"\"\"\n"
    );
    fs::write(cases.join("endless.toml"), table).expect("a table");
}

/// Waits until the event log has its header, or the run is over.
fn wait_for_header(run: &mut Child, log: &Path) {
    while fs::read(log).map_or(true, |bytes| !bytes.contains(&b'\n')) {
        assert_eq!(
            run.try_wait().expect("a child"),
            None,
            "the run ended before it began"
        );
        std::thread::yield_now();
    }
}

#[cfg(unix)]
#[test]
fn ctrl_c_leaves_a_readable_log_that_is_marked_as_cut_short() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    slow_suite(folder.path());
    let mut run = under_way(&mut stickler(folder.path(), &["run", "--jobs", "1"]));
    let log = folder.path().join("reports/latest/events.jsonl");
    wait_for_header(&mut run, &log);
    interrupt(&run);
    let end = run.wait_with_output().expect("the run ends");
    assert_eq!(end.status.code(), Some(130), "{}", text(&end.stderr));
    let (_, completeness) = read_log(&log);
    let Completeness::Truncated { cases } = completeness else {
        panic!("the run was cut short")
    };
    assert!(cases < 2000);
    assert!(
        text(&end.stdout).contains("Cut short after"),
        "{}",
        text(&end.stdout)
    );
    assert!(text(&end.stdout).contains("events.jsonl, as far as the run came"));
    let left: Vec<_> = fs::read_dir(log.parent().expect("a folder"))
        .expect("the folder")
        .collect();
    assert_eq!(left.len(), 1, "only the log is left: {left:?}");
}

#[test]
fn the_reference_in_a_process_of_its_own_does_what_it_does_in_this_one() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let process = format!("cmd:'{STICKLER}' engine");
    // The process calls itself `reference`, too; that name stays with the reference, whichever is asked for first.
    for [first, second] in [["reference", &process], [&process, "reference"]] {
        does_the_same(folder.path(), first, second);
    }
}

fn does_the_same(folder: &Path, first: &str, second: &str) {
    let engines = ["--engine", first, "--engine", second];
    let run = output(folder, &[&["run", "--cases", SUITE], &engines[..]].concat());
    assert_eq!(run.status.code(), Some(1), "{}", text(&run.stderr));
    let (events, completeness) = read_log(&folder.join("reports/latest/events.jsonl"));
    assert_eq!(completeness, Completeness::Complete);
    let of = |engine: &str| {
        let reported = |event: &Event| match event {
            Event::Case(case) if case.engine == engine => Some((
                case.id.clone(),
                case.dialect.clone(),
                case.verdict,
                case.got.clone(),
            )),
            Event::Case(_) | Event::Header(_) | Event::Cause(_) | Event::Footer(_) => None,
        };
        events.iter().filter_map(reported).collect::<Vec<_>>()
    };
    assert!(!of("reference").is_empty());
    assert_eq!(of("reference"), of("reference-2"));
    let rerun = &engine(&events, "reference-2").rerun;
    assert!(rerun.contains(" --engine 'cmd:"), "{rerun}");
}

/// Starts a command whose engine opens the pipe `reproducer`, sends SIGINT, and waits for the end of command and engine.
#[cfg(unix)]
fn interrupt_with_engine(command: &str, engine: &str) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let reproducer = folder.path().join("witness");
    let made = Command::new("mkfifo").arg(&reproducer).status().expect("mkfifo");
    assert!(made.success());
    let arguments: Vec<&str> = command.split(' ').chain(["--engine", engine]).collect();
    let mut ask = stickler(folder.path(), &arguments)
        .env("WITNESS", &reproducer)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the command starts");
    // The pipe opens when the engine opens it, and ends when no process holds it any more.
    let mut pipe = fs::File::open(&reproducer).expect("the witness");
    interrupt(&ask);
    let mut reported = Vec::new();
    std::io::Read::read_to_end(&mut pipe, &mut reported).expect("the end of the pipe");
    assert_eq!(ask.wait().expect("the command ends").code(), Some(130));
}

#[cfg(unix)]
#[test]
fn ctrl_c_leaves_no_engine_behind() {
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/cmd/conversions.in/hangs.sh");
    interrupt_with_engine("conversions REAL_TO_INT 2.5", &format!("cmd:sh '{script}'"));
}

#[cfg(unix)]
#[test]
fn ctrl_c_ends_a_run_whose_engine_does_not_start() {
    let never = r#"cmd:sh -c 'exec 9>"$WITNESS"; tail -f /dev/null >/dev/null 2>&1'"#;
    interrupt_with_engine("run --no-report", never);
}

#[cfg(unix)]
#[test]
fn ctrl_c_ends_a_run_although_its_engine_does_not_answer_and_leaves_a_readable_log() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    slow_suite(folder.path());
    let reproducer = folder.path().join("witness");
    let made = Command::new("mkfifo").arg(&reproducer).status().expect("mkfifo");
    assert!(made.success());
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/cmd/conversions.in/hangs.sh");
    let engine = format!("cmd:sh '{script}'");
    let run = stickler(folder.path(), &["run", "--jobs", "1", "--engine", &engine])
        .env("WITNESS", &reproducer)
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the command starts");
    // Opens when the engine has its first request, which it never answers, and ends with the engine.
    let mut pipe = fs::File::open(&reproducer).expect("the witness");
    interrupt(&run);
    std::io::Read::read_to_end(&mut pipe, &mut Vec::new()).expect("the end of the pipe");
    let end = run.wait_with_output().expect("an end");
    assert_eq!(end.status.code(), Some(130));
    assert!(
        text(&end.stderr).starts_with("stopping; Ctrl-C again ends at once\n"),
        "{}",
        text(&end.stderr)
    );
    // The end of the killed engine is not counted as one of its answers.
    let (events, completeness) = read_log(&folder.path().join("reports/latest/events.jsonl"));
    assert_eq!(completeness, Completeness::Truncated { cases: 0 });
    assert_eq!(events.len(), 1, "a header");
}

#[cfg(unix)]
#[test]
fn a_run_in_a_dialect_that_the_engine_does_not_speak_says_what_it_speaks() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let scripts = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/cmd/conversions.in");
    for (script, dialect, reason) in [
        (
            "rejects.sh",
            "ironplc-ed2",
            "speaks none of ironplc-ed2; it says that it speaks: matiec",
        ),
        ("far.sh", "matiec", "it says that it speaks: melsec"),
    ] {
        let engine = format!("cmd:sh '{scripts}/{script}'");
        let arguments = ["run", "--cases", SUITE, "--dialect", dialect, "--engine", &engine];
        let run = output(folder.path(), &arguments);
        assert_eq!(run.status.code(), Some(3), "{}", text(&run.stderr));
        assert_eq!(text(&run.stdout), "", "no empty table");
        assert!(text(&run.stderr).contains(reason), "{}", text(&run.stderr));
    }
}

/// An adapter in shell that answers `unsupported` to every request.
const UNABLE: &str = r#"while read -r line; do
  id=$(printf '%s' "$line" | sed -n 's/.*"id":\([0-9]*\).*/\1/p')
  case "$line" in
    *'"hello"'*) echo '{"type":"hello","protocol":1,"name":"unable","version":"1","dialects":["ironplc-ed2","ironplc-ed3"],"abilities":["check","execute"]}' ;;
    *'"bye"'*) exit 0 ;;
    *) echo "{\"type\":\"unsupported\",\"id\":$id,\"reason\":\"not written yet\"}" ;;
  esac
done
"#;

#[test]
fn an_engine_that_supports_no_case_is_not_as_expected() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("unable.sh"), UNABLE).expect("a stand-in");
    let run = output(
        folder.path(),
        &["run", "--cases", SUITE, "--engine", "cmd:sh unable.sh"],
    );
    assert_eq!(run.status.code(), Some(4), "{}", text(&run.stderr));
    assert!(text(&run.stdout).contains("unsupported"), "{}", text(&run.stdout));
}
