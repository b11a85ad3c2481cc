//! The command line from the outside: each file under `tests/cmd` is a test.
//!
//! `TRYCMD=overwrite cargo test -p stickler --test cli` writes down what the commands print now; read the difference
//! before it is committed.

#[test]
fn each_command_prints_what_its_file_says() {
    trycmd::TestCases::new()
        // Rerun commands name `stickler` itself unless cargo ran it, and here cargo runs the tests.
        .env("CARGO_MANIFEST_DIR", "")
        .env("NO_COLOR", "1")
        .case("tests/cmd/*.trycmd")
        .case("tests/cmd/*.toml");
}
