//! The tasks of this repository that no user of Stickler needs: `cargo xtask --help`.

use clap::Parser;
use std::env;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use stickler_mutants::MutantsArguments;
use stickler_tabulate::{blocks, folder};

/// The tasks of this repository.
#[derive(Parser)]
#[command(name = "cargo xtask", bin_name = "cargo xtask")]
enum Task {
    /// Runs the whole check, `.ci/run`: formatting, lints, dependencies, tests, the suite.
    Check,
    /// Renews every golden text that a test compares, and the computed rows of the tables; read the difference before you commit it.
    Bless,
    /// Writes the computed rows and cells of the tables of conversions anew.
    ///
    /// Exit codes: 0; 1 `--check` found a difference; 2 a table that cannot be read or claims what no document says; 3 a file cannot
    /// be written.
    Tabulate {
        /// Only say which tables differ.
        #[arg(long)]
        check: bool,
    },
    Mutants(Box<MutantsArguments>),
}

fn main() -> ExitCode {
    ExitCode::from(match Task::parse() {
        Task::Check => exit_code(Command::new("bash").arg(root().join(".ci/run"))),
        Task::Bless => bless(),
        Task::Tabulate { check } => tabulate(check),
        Task::Mutants(arguments) => stickler_mutants::execute(&arguments),
    })
}

/// Renews the tables, then every golden text that a test compares; returns the exit code.
///
/// A golden text is a file with what a program writes now. The test that compares it has `golden` in its name, and writes the file anew
/// where the environment says so; thus a new one needs no entry here.
fn bless() -> u8 {
    let tabulated = tabulate(false);
    let mut tests = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    tests.args(["test", "--quiet", "--workspace", "--tests", "golden"]);
    tests.current_dir(root()).env("STICKLER_BLESS", "1");
    // The switch of `trycmd`, which compares the outputs of the command line.
    tests.env("TRYCMD", "overwrite");
    tabulated.max(exit_code(&mut tests))
}

/// Writes the rows of the tables anew or, with `only_check`, says which differ; returns the exit code.
fn tabulate(only_check: bool) -> u8 {
    let tables = match tables() {
        Ok(tables) => tables,
        Err(message) => {
            eprintln!("error: {message}");
            return 2;
        }
    };
    let differing = tables.iter().filter(|(_, text, wanted)| text != wanted);
    let differing: Vec<&(PathBuf, String, String)> = differing.collect();
    for (path, _, wanted) in &differing {
        let name = path.file_name().unwrap_or_default().display();
        if only_check {
            println!("differs  {name}");
        } else if let Err(error) = std::fs::write(path, wanted) {
            eprintln!("error: {}: {error}", path.display());
            return 3;
        } else {
            println!("written  {name}");
        }
    }
    let done = if only_check { "differ" } else { "written" };
    println!("{} tables, {} {done}", tables.len(), differing.len());
    if only_check && !differing.is_empty() {
        println!("to rewrite them: cargo xtask tabulate");
        return 1;
    }
    0
}

/// Returns the path of each table, its text, and the text that it must have.
fn tables() -> Result<Vec<(PathBuf, String, String)>, String> {
    let root = root();
    let calls = folder::call_tables(&root)?.into_iter();
    let calls = calls.map(|table| (table.path.clone(), table.table.text.clone(), table.wanted()));
    let blocks = blocks::block_tables(&root)?.into_iter();
    let blocks = blocks.map(|(path, table, wanted)| (path, table.text, wanted));
    Ok(calls.chain(blocks).collect())
}

/// Returns the root of the repository.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Runs a command to its end, and returns its exit code; 3 where it cannot be started or a signal ends it.
fn exit_code(command: &mut Command) -> u8 {
    match command.status() {
        Ok(status) => status.code().and_then(|code| code.try_into().ok()).unwrap_or(3),
        Err(error) => {
            eprintln!("error: {}: {error}", command.get_program().display());
            3
        }
    }
}
