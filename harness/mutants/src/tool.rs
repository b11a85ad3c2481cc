//! Finding and running cargo-mutants.

use anyhow::{Context as _, bail};
use std::path::Path;
use std::process::{Command, Stdio};

/// The command that installs cargo-mutants.
const INSTALL: &str = "cargo install cargo-mutants --locked";

/// The crates that are mutated: the implementation that the suite is run on.
const MUTATED: [&str; 3] = ["stickler-syntax", "stickler-reference", "stickler-types"];

/// The name by which `tests/suite.rs` of the judge finds its cases.
const PREPARED: &str = "STICKLER_PREPARED";

/// Looks for cargo-mutants.
///
/// # Errors
/// An error where cargo-mutants is not installed; the message says how to install it.
pub fn find() -> anyhow::Result<()> {
    let version = cargo()
        .args(["mutants", "--version"])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status();
    if !version.is_ok_and(|status| status.success()) {
        bail!("cargo-mutants is not installed; to install it: {INSTALL}");
    }
    Ok(())
}

/// Runs cargo-mutants as `.cargo/mutants.toml` says, the judge reading `prepared`; results go to `output`.
///
/// # Errors
/// An error where cargo-mutants does not come to its end. That mutants survive is no error.
pub fn run(prepared: &Path, output: &Path, options: &[String]) -> anyhow::Result<()> {
    let mut command = cargo();
    command.args(["mutants", "--output"]).arg(output);
    for package in MUTATED {
        command.args(["--package", package]);
    }
    let status = command.args(options).env(PREPARED, prepared).status();
    let status = status.context("cargo could not be started")?;
    match status.code() {
        // All caught; some survived; some took too long.
        Some(0 | 2 | 3) => Ok(()),
        Some(4) => bail!(
            "the suite fails on the reference as it is, so it cannot judge mutants; see {}",
            output.join("mutants.out/log/baseline.log").display()
        ),
        _ => bail!("cargo mutants ended with {status}"),
    }
}

/// Returns the cargo that runs this program.
fn cargo() -> Command {
    Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
}
