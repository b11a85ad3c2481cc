//! Tests the output of commands: each file under `tests/cmd` is a test, and so is the example of the manual.
//!
//! `cargo xtask bless` writes down what the commands print now; read the difference before it is committed.

#[test]
fn each_command_prints_its_golden_output() {
    trycmd::TestCases::new()
        // Rerun commands name `stickler` itself unless cargo ran it, and here cargo runs the tests.
        .env("CARGO_MANIFEST_DIR", "")
        .env("NO_COLOR", "1")
        .env("GITHUB_ACTIONS", "")
        .case("tests/cmd/*.trycmd")
        .case("tests/cmd/*.toml")
        .case("../docs/conversions-and-sweeps.md");
}
