//! `stickler`: the conformance suite for compilers of IEC 61131-3 Structured Text, as a command line.
//!
//! *Architecture invariant.* A command parses its arguments, calls the layers below, and shows what they answer; what
//! another crate can do is done there. Exit codes are decided in [`exit`] alone, and only this file ends the process.
#![forbid(unsafe_code)]

mod arguments;
mod baselines;
mod caches;
mod case_folder;
mod commands;
mod engines;
mod exit;
mod interrupt;
mod output;
mod progress;
mod shell;
mod snippet;
mod source_file;

use arguments::Arguments;
use clap::Parser;
use std::io::Write;
use std::process::ExitCode;
#[cfg(unix)]
use std::sync::Arc;

/// A file that must not grow any more (`ulimit -f`) is an error that is told, not the end of the process by a signal.
#[cfg(unix)]
fn survive_the_largest_file() {
    let whether_it_came = Arc::default();
    // Where no handler can be set all is as it was.
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, whether_it_came);
}

/// Other systems have no such signal.
#[cfg(not(unix))]
fn survive_the_largest_file() {}

fn main() -> ExitCode {
    survive_the_largest_file();
    // The command line may name the dialects of stickler.toml.
    let configured = engines::configure();
    let arguments = match (Arguments::try_parse(), configured) {
        (Ok(arguments), Ok(())) => arguments,
        (Err(usage), Ok(())) => usage.exit(),
        // Help is no less needed then.
        (Err(usage), Err(_)) if !usage.use_stderr() => usage.exit(),
        (_, Err(error)) => {
            output::complain(&error);
            return exit::of_error(&error).into();
        }
    };
    let mut out = output::stdout();
    let result = commands::execute(arguments, &mut out).and_then(|exit| {
        out.flush()?;
        Ok(exit)
    });
    match result {
        Ok(exit) => exit.into(),
        Err(error) => {
            // What was found so far stands before what went wrong; neither can be told anyone if both streams fail.
            let _ = out.flush();
            output::complain(&error);
            exit::of_error(&error).into()
        }
    }
}
