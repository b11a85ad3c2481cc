//! The tasks of this repository that no user of Stickler needs: `cargo xtask --help`.

mod bless;
mod executions;
mod tabulate;

use clap::Parser;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use stickler_mutants::MutantsArguments;

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
    Mutants(MutantsArguments),
    /// Adds to a file of counts how many inputs libFuzzer judged.
    CountExecutions {
        /// The file of counts.
        counts: PathBuf,
        /// What libFuzzer printed with `-print_final_stats=1`, in files that are named after the target: `parse.log`.
        #[arg(required = true)]
        logs: Vec<PathBuf>,
    },
}

fn main() -> ExitCode {
    ExitCode::from(match Task::parse() {
        Task::Check => exit_code(Command::new("bash").arg(root().join(".ci/run"))),
        Task::Bless => bless::execute(),
        Task::Tabulate { check } => tabulate::execute(check),
        Task::Mutants(arguments) => stickler_mutants::execute(&arguments),
        Task::CountExecutions { counts, logs } => executions::execute(&counts, &logs),
    })
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
