//! Tests baselines by the command line: their effect on a run, and `stickler bless`.

use crate::common::{SUITE, stickler};
use std::fs;
use std::path::Path;
use std::process::Output;

/// An engine that rejects every program without a line, but accepts those that contain `$KNOWS`, without running them.
const GRUMPY: &str = r#"while IFS= read -r line; do
    rest=${line#*\"id\":}
    case $line in
    *'"type":"hello"'*)
        echo '{"type":"hello","protocol":1,"name":"grumpy","version":"1.4","dialects":["ironplc-ed2","matiec"],"abilities":["check"],"grade":"rejected"}'
        ;;
    *'"type":"bye"'*) exit 0 ;;
    *"$KNOWS"*) echo "{\"type\":\"accepted\",\"id\":${rest%%,*}}" ;;
    *) echo "{\"type\":\"rejected\",\"id\":${rest%%,*},\"diagnostics\":[{\"message\":\"no\"}]}" ;;
    esac
done
"#;

/// A temporary folder that contains the engine.
struct TestFolder(tempfile::TempDir);

impl TestFolder {
    fn new() -> TestFolder {
        let folder = tempfile::tempdir().expect("a temporary folder");
        fs::write(folder.path().join("grumpy.sh"), GRUMPY).expect("a stand-in");
        TestFolder(folder)
    }

    fn path(&self) -> &Path {
        self.0.path()
    }

    /// Runs the suite on the engine, which accepts programs that contain `knows`.
    fn run(&self, knows: &str, more: &[&str]) -> CommandResult {
        let common = [
            "run",
            "--no-causes",
            "--cases",
            SUITE,
            "--engine",
            "cmd:sh grumpy.sh",
        ];
        self.command(&[&common, more].concat(), knows)
    }

    fn bless(&self, more: &[&str]) -> CommandResult {
        self.command(&[&["bless", "--cases", SUITE], more].concat(), "")
    }

    fn command(&self, arguments: &[&str], knows: &str) -> CommandResult {
        let output = stickler(self.path(), arguments)
            .env(
                "KNOWS",
                if knows.is_empty() {
                    "nothing of this kind"
                } else {
                    knows
                },
            )
            .output();
        CommandResult::of(output.expect("the command runs"))
    }

    fn baseline(&self) -> String {
        fs::read_to_string(self.path().join(BASELINE)).expect("a baseline")
    }

    fn write_baseline(&self, text: &str) {
        let path = self.path().join(BASELINE);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(path, text).expect("a baseline");
    }
}

const BASELINE: &str = "reports/baselines/grumpy.toml";

struct CommandResult {
    code: Option<i32>,
    stdout: String,
    stderr: String,
}

impl CommandResult {
    fn of(output: Output) -> CommandResult {
        CommandResult {
            code: output.status.code(),
            stdout: String::from_utf8_lossy(&output.stdout).into_owned(),
            stderr: String::from_utf8_lossy(&output.stderr).into_owned(),
        }
    }

    /// Asserts that the command ended with an exit code and printed all of the given texts.
    #[track_caller]
    fn with(self, code: i32, said: &[&str]) -> CommandResult {
        let all = format!("{}\n{}", self.stdout, self.stderr);
        assert_eq!(self.code, Some(code), "{all}");
        for part in said {
            assert!(all.contains(part), "no {part:?} in {all}");
        }
        self
    }
}

const ENTRY: &str =
    "[[expected]]\ncase = \"language/wrong-on-purpose\"\nverdict = \"fail\"\nreason = \"grumpy\"\n";

#[test]
fn what_a_run_found_is_known_once_it_is_blessed_and_what_is_new_still_fails() {
    let folder = TestFolder::new();
    folder
        .run("", &[])
        .with(1, &["not as expected", "judged without their place"]);
    folder
        .bless(&["--dry-run"])
        .with(0, &["  + fail language/wrong-on-purpose  1 case\n", "would have"]);
    assert!(!folder.path().join(BASELINE).exists(), "a dry run writes nothing");
    folder.bless(&[]).with(
        0,
        &[
            "  + fail language/wrong-on-purpose  1 case\n",
            "reports/baselines/grumpy.toml: ",
        ],
    );
    folder.run("", &[]).with(0, &["all as expected (", " xfail"]);
    folder.run("", &["--no-baseline"]).with(
        1,
        &[
            "not as expected",
            "stickler run --cases",
            " --no-baseline --engine",
        ],
    );
    folder.bless(&[]).with(0, &[": nothing is different, "]);
}

#[test]
fn an_unexpected_pass_fails_the_run_and_leaves_the_baseline_with_the_next_blessing() {
    const NARROWING: &str = "widening/integer::assignment(INT,SINT)";
    let folder = TestFolder::new();
    // The engine accepts every program, and then none.
    folder.run("PROGRAM", &[]).with(1, &[]);
    folder.bless(&[]).with(0, &[&format!("  + fail {NARROWING}")]);
    folder.run("", &[]).with(
        1,
        &[
            &format!("XPASS {NARROWING}@"),
            "baseline reports/baselines/grumpy.toml:",
            "not looked into yet",
        ],
    );
    folder
        .bless(&[])
        .with(0, &[&format!("  - fail {NARROWING}"), "now pass"]);
    assert!(!folder.baseline().contains(NARROWING), "{}", folder.baseline());
    folder.run("", &[]).with(0, &[]);
}

#[test]
fn a_stale_entry_fails_the_run_in_every_report() {
    let folder = TestFolder::new();
    folder.run("", &[]).with(1, &[]);
    folder.bless(&[]).with(0, &[]);
    let stale = "\n[[expected]]\ncase = \"language/gone\"\nverdict = \"fail\"\nreason = \"it was\"\n";
    folder.write_baseline(&(folder.baseline() + stale));
    folder.run("", &[]).with(
        1,
        &[
            "OUTDATED reports/baselines/grumpy.toml:",
            "language/gone is no case",
            "1 entry of a baseline is out of date",
        ],
    );
    for (report, part) in [
        ("summary.md", "- **out of date** reports/baselines/grumpy.toml:"),
        ("junit.xml", "<testsuite name=\"baselines\" tests=\"1\""),
        (
            "results.json",
            "\"outdated\":[{\"at\":\"reports/baselines/grumpy.toml:",
        ),
    ] {
        let text = fs::read_to_string(folder.path().join("reports/latest").join(report)).expect("a report");
        assert!(text.contains(part), "{report}: {text}");
    }
    folder
        .bless(&[])
        .with(0, &["  - fail language/gone  fits no case\n"]);
    folder.run("", &[]).with(0, &[]);
}

#[test]
fn an_expired_entry_fails_the_run() {
    let folder = TestFolder::new();
    folder.write_baseline(&format!("{ENTRY}until = 2001-01-01\n"));
    folder.run("", &["--filter", "language/wrong-on-purpose"]).with(
        1,
        &["FAIL language/wrong-on-purpose", "was to hold until 2001-01-01"],
    );
}

#[test]
fn a_mistake_in_a_baseline_is_told_with_its_line_before_the_run() {
    let folder = TestFolder::new();
    folder.write_baseline(&ENTRY.replace("verdict", "verdit"));
    let ended = folder
        .run("", &[])
        .with(2, &["reports/baselines/grumpy.toml:3: unknown field `verdit`"]);
    assert_eq!(ended.stdout, "", "nothing was run");
}

#[test]
fn a_baseline_may_be_named_and_must_be_about_an_engine_of_the_run() {
    let folder = TestFolder::new();
    fs::write(
        folder.path().join("known.toml"),
        format!("engine = \"grumpy\"\n{ENTRY}"),
    )
    .expect("a baseline");
    let only = [
        "--filter",
        "language/wrong-on-purpose",
        "--baseline",
        "known.toml",
    ];
    folder.run("", &only).with(0, &["all as expected (1 xfail)"]);
    folder
        .run("", &[&only[..], &["--baseline", "known.toml"]].concat())
        .with(2, &["are both the baseline of `grumpy`"]);
    folder
        .run("", &["--baseline", "gone.toml"])
        .with(2, &["there is no file gone.toml"]);
    fs::write(folder.path().join("matiec.toml"), ENTRY).expect("a baseline");
    folder.run("", &["--baseline", "matiec.toml"]).with(
        2,
        &["matiec.toml is the baseline of `matiec`, which takes no part"],
    );
}

#[test]
fn what_cannot_be_blessed_says_why() {
    let folder = TestFolder::new();
    folder
        .bless(&[])
        .with(2, &["cannot read reports/latest/events.jsonl"]);
    folder.run("", &[]).with(1, &[]);
    folder
        .bless(&["--engine", "gremlin"])
        .with(2, &["tells nothing of `gremlin`; it is about grumpy"]);
    let log = folder.path().join("reports/latest/events.jsonl");
    let text = fs::read_to_string(&log).expect("a log");
    let footer = text.trim_end().rfind('\n').expect("lines") + 1;
    fs::write(&log, &text[..footer]).expect("a log");
    folder.bless(&[]).with(2, &["cut short", "run it again"]);
    fs::write(&log, text.replace(r#""format":3"#, r#""format":1"#)).expect("a log");
    let reported = [
        "reports/latest/events.jsonl",
        "has format 1",
        "run the cases again",
    ];
    folder.bless(&[]).with(2, &reported);
    folder.command(&["run", "--cases", SUITE], "").with(1, &[]);
    folder.bless(&[]).with(2, &["the reference has no baseline"]);
}
