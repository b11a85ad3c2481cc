//! The commands of `stickler`, one module for each.

mod bless;
mod changes;
mod check;
mod compare;
mod completions;
mod compliance;
mod contradictions;
mod conversions;
mod data;
mod engine;
mod engines;
mod eval;
mod explain;
mod export;
mod fuzz;
mod import;
mod judge;
mod lint;
mod list;
mod matrix;
mod merge;
mod port;
mod promote;
mod record;
mod reduce;
mod render;
mod reproduce;
mod run;
mod show;
mod site;
mod sources;
mod sweep;

use crate::arguments::{Arguments, Command, RunArguments};
use crate::exit::Exit;
use std::io::Write;

/// Executes the command of the command line, writes its results to `out`, and returns its exit code.
///
/// # Errors
/// The error that kept the command from its work.
pub fn execute(arguments: Arguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    match arguments
        .command
        .unwrap_or_else(|| Command::Run(RunArguments::default()))
    {
        Command::Run(arguments) => run::execute(&arguments, out),
        Command::Bless(arguments) => bless::execute(&arguments, out),
        Command::List(arguments) => list::execute(&arguments, out),
        Command::Show(arguments) => show::execute(&arguments, out),
        Command::Sources(arguments) => sources::execute(&arguments, out),
        Command::Changes(arguments) => changes::execute(&arguments, out),
        Command::Lint(arguments) => lint::execute(&arguments, out),
        Command::Check(arguments) => check::execute(&arguments, out),
        Command::Eval(arguments) => eval::execute(&arguments, out),
        Command::Judge(arguments) => judge::execute(&arguments, out),
        Command::Port(arguments) => port::execute(&arguments, out),
        Command::Render(arguments) => render::execute(&arguments, out),
        Command::Engine(arguments) => engine::execute(&arguments, out),
        Command::Engines(arguments) => engines::execute(&arguments, out),
        Command::Explain(arguments) => explain::execute(&arguments, out),
        Command::Matrix(arguments) => matrix::execute(&arguments, out),
        Command::Contradictions(arguments) => contradictions::execute(&arguments, out),
        Command::Conversions(arguments) => conversions::execute(&arguments, out),
        Command::Record(arguments) => record::execute(&arguments, out),
        Command::Sweep(arguments) => sweep::execute(&arguments, out),
        Command::Compare(arguments) => compare::execute(&arguments, out),
        Command::Site(arguments) => site::execute(&arguments, out),
        Command::Fuzz(arguments) => fuzz::execute(&arguments, out),
        Command::Reduce(arguments) => reduce::execute(&arguments, out),
        Command::Reproduce(arguments) => reproduce::execute(&arguments, out),
        Command::Promote(arguments) => promote::execute(&arguments, out),
        Command::Merge(arguments) => merge::execute(&arguments, out),
        Command::Export(arguments) => export::execute(&arguments, out),
        Command::Data(arguments) => data::execute(&arguments, out),
        Command::Compliance(arguments) => compliance::execute(&arguments, out),
        Command::Import(arguments) => import::execute(&arguments, out),
        Command::Completions(arguments) => Ok(completions::execute(&arguments, out)?),
    }
}
