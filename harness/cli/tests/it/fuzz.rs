//! Tests campaigns by the command line: engines that are processes and have a defect, folders that cannot be used, Ctrl-C.

use crate::common::{self, STICKLER, interrupt, under_way};
use std::fs;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;

/// Returns the name of an engine that executes MOD as a division, after a script of sed has edited each request.
fn defective(script: &str) -> String {
    let script = format!("{script}s/ MOD / \\/ /g");
    format!("cmd:sh -c 'sed -u \"{script}\" | \"{STICKLER}\" engine'")
}

/// Runs a command, and returns its exit code and its output on both streams.
fn stickler(arguments: &[&str]) -> (Option<i32>, String) {
    let output = common::output(Path::new("."), arguments);
    let shown = [output.stdout, output.stderr].concat();
    (output.status.code(), String::from_utf8_lossy(&shown).into_owned())
}

/// Runs a campaign of 120 programs on an engine, some of which contain MOD.
fn campaign(engine: &str, folder: &str, more: &[&str]) -> (Option<i32>, String) {
    let line = [
        "fuzz",
        "--seed",
        "11",
        "--count",
        "120",
        "--engine",
        engine,
        "--findings",
        folder,
    ];
    stickler(&[&line[..], more].concat())
}

fn text(path: &Path) -> &str {
    path.to_str().expect("a path of plain characters")
}

/// Returns the folder of the only finding whose rule is MOD alone.
fn finding(folder: &Path) -> String {
    let folders = fs::read_dir(folder).expect("the folder").filter_map(Result::ok);
    let mut alone = folders.filter(|entry| {
        let json = fs::read_to_string(entry.path().join("finding.json")).unwrap_or_default();
        let json: serde_json::Value = serde_json::from_str(&json).unwrap_or_default();
        json["rule"] == serde_json::json!(["mod"])
    });
    alone
        .next()
        .expect("a finding")
        .path()
        .to_string_lossy()
        .into_owned()
}

#[test]
fn a_defect_is_found_judged_again_merged_and_promoted() {
    let folder = tempfile::tempdir().expect("a folder");
    let [one, two, all] = ["1", "2", "all"].map(|name| folder.path().join(name));
    let engine = defective("");
    for (part, own) in [("1/2", &one), ("2/2", &two)] {
        let (code, shown) = campaign(&engine, text(own), &["--shard", part]);
        assert!(code == Some(1) || code == Some(0), "{shown}");
        assert!(shown.contains("60 programs in "), "{shown}");
    }
    let (code, shown) = stickler(&["merge", text(&one), "-o", text(&all)]);
    assert_eq!(code, Some(2), "{shown}");
    assert!(shown.contains("part 2 of 2 of seed 11 is missing"), "{shown}");
    let (code, shown) = stickler(&["merge", text(&one), text(&two), "-o", text(&all)]);
    assert_eq!(code, Some(1), "{shown}");
    assert!(shown.contains("seed 11: 120 programs"), "{shown}");
    let found = finding(&all);
    let (code, shown) = stickler(&["fuzz", "--replay", &found, "--engine", &engine]);
    assert_eq!(code, Some(1), "{shown}");
    assert!(
        shown.contains("reference-2 0.1.0: executed ") && shown.contains("it is still there"),
        "{shown}"
    );
    let name = found.rsplit('/').next().expect("the name of the finding");
    let (code, shown) = stickler(&[
        "fuzz",
        "--replay",
        name,
        "--findings",
        text(&all),
        "--engine",
        "reference",
    ]);
    assert_eq!(code, Some(0), "{shown}");
    assert!(shown.contains("it is not there any more"), "{shown}");
    let cases = folder.path().join("cases");
    fs::create_dir_all(cases.join("found")).expect("a folder of cases");
    fs::write(cases.join("found/README.md"), "Found.").expect("a README");
    for file in ["suite.toml", "dialects.toml", "sources.toml", "rules.md"] {
        let real = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance-cases");
        fs::copy(real.join(file), cases.join(file)).expect("a copy");
    }
    let (code, shown) = stickler(&["promote", &found, "--name", "mod", "--cases", text(&cases)]);
    assert_eq!(code, Some(0), "{shown}");
    assert!(
        shown.contains("found/mod.st\n") && shown.contains("its basis is proposed"),
        "{shown}"
    );
    let (code, shown) = stickler(&["run", "--cases", text(&cases), "--no-report"]);
    assert_eq!(code, Some(0), "{shown}");
    let (code, shown) = stickler(&["promote", &found, "--name", "mod", "--cases", text(&cases)]);
    assert_eq!(code, Some(2), "{shown}");
    assert!(shown.contains("is there already"), "{shown}");
}

#[test]
fn what_cannot_be_saved_any_more_is_shown_at_the_end() {
    let folder = tempfile::tempdir().expect("a folder");
    let findings = folder.path().join("findings");
    // At its fifth request the engine puts a file in the place of the folder.
    let place = text(&findings);
    let engine = defective(&format!("5e rm -r {place}; touch {place}\n"));
    let (code, shown) = campaign(&engine, place, &["--jobs", "1", "--no-survey"]);
    assert_eq!(code, Some(2), "{shown}");
    assert!(
        shown.contains("the campaign goes on, and what cannot be saved is shown at its end"),
        "{shown}"
    );
    assert!(shown.contains("not saved: cannot write "), "{shown}");
    assert!(
        shown.contains(" MOD ") && shown.contains("  stickler fuzz --seed 11 --first "),
        "{shown}"
    );
}

#[test]
fn what_cannot_be_used_is_said_before_the_first_program() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("file");
    fs::write(&file, "no literal").expect("a file");
    let below = file.join("findings");
    let cases: &[(&[&str], i32, &str)] = &[
        (
            &["fuzz", "--count", "1", "--findings", text(&below)],
            2,
            "error: cannot write ",
        ),
        (
            &["fuzz", "--engine", "cmd:there-is-no-such-program", "--count", "1"],
            3,
            "could not be started",
        ),
        (
            &["fuzz", "--replay", text(&file)],
            2,
            "say by which oracle: --target parse",
        ),
        (
            &["fuzz", "--replay", text(folder.path())],
            2,
            "is no finding: it has no finding.json",
        ),
        (
            &["fuzz", "--replay", "nowhere", "--target", "parse"],
            2,
            "cannot read nowhere",
        ),
        (
            &[
                "fuzz",
                "--dialect",
                "matiec",
                "--count",
                "1",
                "--findings",
                text(folder.path()),
            ],
            2,
            "--dialect needs an --engine",
        ),
        (
            &["fuzz", "--target", "parse", "--engine", "reference"],
            2,
            "cannot be used with",
        ),
        (
            &[
                "fuzz",
                "--engine",
                "reference",
                "--without",
                "MUXX",
                "--count",
                "1",
            ],
            2,
            "`MUXX` is nothing that can be left out",
        ),
        (&["fuzz", "--without", "MUX"], 2, "--engine <ENGINE>"),
        (&["fuzz", "--time", "soon"], 2, "write it as 90s, 10m or 2h"),
        (&["fuzz", "--time", "-1"], 2, "`-1` is no time"),
        (&["fuzz", "--count", "-1"], 2, "write a whole number, 0 or more"),
        (
            &["fuzz", "--replay", "nowhere"],
            2,
            "nowhere is neither a finding nor a file",
        ),
        (
            &["promote", "nothing-of-this-name"],
            2,
            "cannot read nothing-of-this-name/finding.json",
        ),
    ];
    for (arguments, code, words) in cases {
        let (got, shown) = stickler(arguments);
        assert_eq!(
            (got, shown.contains(words)),
            (Some(*code), true),
            "{arguments:?}\n{shown}"
        );
    }
}

#[test]
fn an_input_of_libfuzzer_is_judged_alone() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("crash-1f3a");
    fs::write(&file, [0xFF, 0xFE, b'(', b'*']).expect("a file");
    let (code, shown) = stickler(&["fuzz", "--replay", text(&file), "--target", "parse"]);
    assert_eq!(code, Some(0), "{shown}");
    assert!(shown.contains("crash-1f3a: parse "), "{shown}");
}

#[test]
fn ctrl_c_ends_a_campaign_with_what_it_has() {
    let folder = tempfile::tempdir().expect("a folder");
    let arguments = ["fuzz", "--target", "execute", "--time", "10m", "--findings", "."];
    let mut campaign = under_way(&mut common::stickler(folder.path(), &arguments));
    let mut out = BufReader::new(campaign.stdout.take().expect("a pipe"));
    let mut shown = String::new();
    // The handler stands when the record of the campaign is there.
    out.read_line(&mut shown).expect("a line");
    while !folder.path().join("campaign.json").exists() {
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    interrupt(&campaign);
    out.read_to_string(&mut shown).expect("the rest");
    assert_eq!(campaign.wait().expect("an end").code(), Some(130), "{shown}");
    assert!(
        shown.contains(" programs in ") && shown.contains("stopped before its end"),
        "{shown}"
    );
    let record = fs::read_to_string(folder.path().join("campaign.json")).expect("the record");
    assert!(record.contains("\"complete\": false"), "{record}");
}
