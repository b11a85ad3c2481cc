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
mod conversions;
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

fn main() -> ExitCode {
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
