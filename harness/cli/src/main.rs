//! `stickler`: the conformance suite for compilers of IEC 61131-3 Structured Text, as a command line.
//!
//! *Architecture invariant.* A command parses its arguments, calls the layers below, and shows what they answer; what
//! another crate can do is done there. Exit codes are decided in [`exit`] alone, and only this file ends the process.
#![forbid(unsafe_code)]

mod arguments;
mod baselines;
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
    let mut arguments = Arguments::parse();
    if let Some(file) = arguments.config.take() {
        engines::read_from(file);
    }
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
