//! Tests the output of commands: each file under `tests/cmd` is a test.
//!
//! `TRYCMD=overwrite cargo test -p stickler --test it pages` writes down what the commands print now; read the difference
//! before it is committed.

#[test]
fn each_command_prints_what_its_file_says() {
    trycmd::TestCases::new()
        // Rerun commands name `stickler` itself unless cargo ran it, and here cargo runs the tests.
        .env("CARGO_MANIFEST_DIR", "")
        .env("NO_COLOR", "1")
        .env("GITHUB_ACTIONS", "")
        .case("tests/cmd/*.trycmd")
        .case("tests/cmd/*.toml");
}

#[test]
fn the_manual_shows_what_conversions_prints() {
    let arguments = ["conversions", "REAL_TO_INT", "2.5", "-0.5", "1E10"];
    let output = std::process::Command::new(crate::common::STICKLER)
        .args(arguments)
        .env("NO_COLOR", "1")
        .output()
        .expect("the command runs");
    let shown = String::from_utf8(output.stdout).expect("text");
    let example = format!("$ stickler {}\n{shown}```\n", arguments.join(" "));
    let manual = include_str!("../../../docs/conversions-and-sweeps.md");
    assert!(
        manual.contains(&example),
        "conversions-and-sweeps.md does not show this:\n{example}"
    );
}
