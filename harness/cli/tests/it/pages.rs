//! Tests what commands print: each file under `tests/cmd` is a test, and so is the example of the manual.
//!
//! A file is read by `trycmd`: what a command prints on both streams stands below it, `? 2` is its exit code, and `...` and `[..]`
//! stand for any lines and any text. The commands run in the folder `NAME.in`, or, where a folder `NAME.out` is there, in a temporary
//! copy of it. `$SUITE` is a small suite, `$CASES` the real one.
//!
//! `cargo xtask bless` writes down what the commands print now; read the difference before it is committed.

use crate::common::{self, ROOT, STICKLER, SUITE};
use std::env;
use std::path::Path;

/// The programs besides `stickler` that the files run.
const TOOLS: [&str; 7] = ["cat", "cp", "grep", "head", "ls", "rm", "sh"];

#[test]
fn each_command_prints_its_golden_output() {
    let folder = Path::new(STICKLER).parent().expect("the folder of the program");
    let path = env::var_os("PATH").unwrap_or_default();
    let folders: Vec<_> = [folder.to_owned()]
        .into_iter()
        .chain(env::split_paths(&path))
        .collect();
    let find = |tool: &str| {
        folders
            .iter()
            .map(|folder| folder.join(tool))
            .find(|file| file.is_file())
    };
    let path = env::join_paths(&folders).expect("a path");
    let tests = trycmd::TestCases::new();
    for (variable, value) in common::ENVIRONMENT {
        tests.env(variable, value);
    }
    for tool in TOOLS {
        tests.register_bin(tool, find(tool).expect(tool));
    }
    tests
        .env("PATH", path.to_string_lossy())
        .env("STICKLER", STICKLER)
        .env("ROOT", ROOT)
        .env("SUITE", SUITE)
        .env("CMD", concat!(env!("CARGO_MANIFEST_DIR"), "/tests/cmd"))
        .env("CASES", format!("{ROOT}/conformance-cases"))
        .case("tests/cmd/*.trycmd")
        .case("tests/cmd/*.toml")
        .case("../docs/conversions-and-sweeps.md");
    if cfg!(target_os = "linux") {
        tests.case("tests/cmd/linux/*.trycmd");
    }
}
