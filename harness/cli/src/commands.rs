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

use crate::arguments::{self, Arguments};
use crate::exit::Exit;
use clap::Subcommand;
use std::io::Write;

/// Defines the commands: of each its help, the module that executes it, and its arguments. The examples in its help are those of the module.
macro_rules! commands {
    ($($(#[$help:meta])+ $module:ident: $command:ident($arguments:ident),)+) => {
        /// The commands.
        #[derive(Subcommand, Debug)]
        pub enum Command {
            $(
                $(#[$help])+
                #[command(after_help = include_str!(concat!("arguments/examples/", stringify!($module), ".txt")))]
                $command(arguments::$arguments),
            )+
        }

        /// Executes the command of the command line, writes its results to `out`, and returns its exit code.
        ///
        /// # Errors
        /// The error that kept the command from its work.
        pub fn execute(arguments: Arguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
            match arguments.command.unwrap_or_else(|| Command::Run(arguments::RunArguments::default())) {
                $(Command::$command(arguments) => $module::execute(&arguments, out),)+
            }
        }
    };
}

commands! {
    /// Run cases, judge what the engines did, write reports
    run: Run(RunArguments),
    /// Record the results of the last run as expected, in the baselines of its engines
    bless: Bless(BlessArguments),
    /// List the cases, or with --basis the claims that they check
    list: List(ListArguments),
    /// Show one case: its program, what must happen, why, and how to run it again
    show: Show(ShowArguments),
    /// List the sources of the claims, or hold what they quote against saved copies of their pages
    sources: Sources(SourcesArguments),
    /// Show what the suite claims otherwise than an older version of it
    changes: Changes(ChangesArguments),
    /// Check the case files themselves
    lint: Lint(LintArguments),
    /// Show the diagnostics of the reference for a program of one file or several
    check: Check(CheckArguments),
    /// Execute a program of one file or several on the reference and print the final values
    eval: Eval(EvalArguments),
    /// Execute a program, function block or function on traces, and compare what comes out with what they expect
    judge: Judge(JudgeArguments),
    /// Show what another system rejects of a program, and what it computes otherwise
    port: Port(PortArguments),
    /// Print one file in the normalised form of the reference
    render: Render(SourceArguments),
    /// Serve an engine over the wire protocol on stdin and stdout, or check whether an adapter keeps to it
    engine: Engine(EngineArguments),
    /// List the engines: where each was found, what it can do, and what is missing
    engines: Engines(EnginesArguments),
    /// Explain a diagnostic code, or list all of them
    explain: Explain(ExplainArguments),
    /// Show which types convert implicitly, by the documents and on engines
    matrix: Matrix(MatrixArguments),
    /// Show what a conversion function gives for boundary values, dialects side by side
    conversions: Conversions(ConversionsArguments),
    /// Show where documents, editions of the standard, recordings and compilers give different answers to one question
    contradictions: Contradictions(ContradictionsArguments),
    /// Write a file with the conversions of an engine, to be shown where the engine is not at hand
    record: Record(RecordArguments),
    /// Compare every input of a conversion function with exact arithmetic
    sweep: Sweep(SweepArguments),
    /// Show what a newer run does better or worse than an older one
    compare: Compare(CompareArguments),
    /// Build a static site of several runs: engines, their history, what each version fixed and broke
    site: Site(SiteArguments),
    /// Search for programs on which an engine, or the reference, does not do what documents say
    fuzz: Fuzz(FuzzArguments),
    /// Reduce a program that shows a symptom on an engine
    reduce: Reduce(ReduceArguments),
    /// Write what shows a case on a compiler without Stickler: its program, a driver and a script
    reproduce: Reproduce(ReproduceArguments),
    /// Turn a finding into a case, or a recording into tables of cases
    promote: Promote(PromoteArguments),
    /// Merge the parts of a run, or of a campaign
    merge: Merge(MergeArguments),
    /// Write pages of self-checking programs, for a compiler that is only reachable through an editor
    export: Export(ExportArguments),
    /// Write what systems have and do as one JSON file, with its schema, its types and packages for npm and PyPI
    data: Data(DataArguments),
    /// Write the compliance statement that the standard demands of a system, as it is declared and as an engine does
    compliance: Compliance(ComplianceArguments),
    /// Judge and report the results that exported pages left in their arrays
    import: Import(ImportArguments),
    /// Print the script by which a shell completes commands and options
    completions: Completions(CompletionsArguments),
}
