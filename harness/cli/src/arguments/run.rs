//! The command line of `stickler run`.

use super::SelectionArguments;
use super::numbers::whole;
use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use std::path::PathBuf;
use stickler_run::Grade;
use stickler_workers::Shard;

/// `stickler run`.
#[derive(Args, Debug, Default)]
pub struct RunArguments {
    /// The selected cases.
    #[command(flatten)]
    pub selection: SelectionArguments,
    /// Run them on this engine: a name that `stickler engines` lists, or `cmd:COMMAND LINE` for a program that speaks the
    /// wire protocol; may be repeated [default: reference]
    #[arg(long, value_name = "ENGINE")]
    pub engine: Vec<String>,
    /// Demand this exactness of a rejection or a fault: `code` (the right codes on the right lines), `line`, or
    /// `rejected`; the reference always must meet `code` [default: the best that each engine claims]
    #[arg(long, value_name = "GRADE", value_parser = super::one_of(Grade::ALL, Grade::as_str), hide_possible_values = true)]
    pub strict: Option<Grade>,
    /// Fail a compiler that misses one of Stickler's own rules (`stickler list --sources`); without it, such a case differs
    #[arg(long)]
    pub strict_rules: bool,
    /// Expect what FILE says of its engine; may be repeated, once an engine [default: reports/baselines/ENGINE.toml beside the
    /// folder of the cases, where there is one]
    #[arg(long, value_name = "FILE", conflicts_with = "no_baseline")]
    pub baseline: Vec<PathBuf>,
    /// Expect every case to pass
    #[arg(long)]
    pub no_baseline: bool,
    /// Run part I of N of the cases
    #[arg(long, value_name = "I/N")]
    pub shard: Option<Shard>,
    /// Run N cases at a time [default: one a processor]
    #[arg(long, value_name = "N", value_parser = whole::<u16>(1, 1024), allow_negative_numbers = true)]
    pub jobs: Option<u16>,
    /// Give every program to a compiler alone, also where that takes much longer
    #[arg(long)]
    pub unpacked: bool,
    /// Give each program N seconds to be compiled, and N to run [default: what each engine's adapter or description says]
    #[arg(long, value_name = "N", value_parser = whole::<u64>(1, 100_000), allow_negative_numbers = true)]
    pub timeout: Option<u64>,
    /// Show N failing cases whole [default: 40 of an engine whose causes are not known, none otherwise]
    #[arg(long, value_name = "N", value_parser = whole::<usize>(0, 500), allow_negative_numbers = true)]
    pub failures: Option<usize>,
    /// After the run, run the cases of each case file that changes, until Ctrl-C; the reports stay those of the first run
    #[arg(long)]
    pub watch: bool,
    /// Show only the result and the page's path, and no progress
    #[arg(long, short, conflicts_with = "verbose")]
    pub quiet: bool,
    /// Show every source and every dialect in the tables of the summary
    #[arg(long, short)]
    pub verbose: bool,
    /// Write unexpected results as annotations of a CI service [default: github in a job of GitHub, otherwise off]
    #[arg(long, value_name = "CI", value_parser = annotations())]
    pub annotate: Option<bool>,
    /// Do not search for the causes of failing cases, which asks the engines about smaller programs
    #[arg(long)]
    pub no_causes: bool,
    /// Search for causes for N minutes at most [default: 10]
    #[arg(long, value_name = "N", value_parser = whole::<u64>(1, 100_000), allow_negative_numbers = true, conflicts_with = "no_causes")]
    pub cause_time: Option<u64>,
    /// Write the reports to DIR [default: reports/latest beside the folder of the cases]
    #[arg(long, value_name = "DIR", conflicts_with = "no_report")]
    pub report: Option<PathBuf>,
    /// Leave the text of programs out of the pages of `discrepancies`, for trackers that want none
    #[arg(long, conflicts_with = "no_report")]
    pub prose: bool,
    /// Write no reports, and neither use nor keep results in reports/cache
    #[arg(long)]
    pub no_report: bool,
    /// Ask compilers everything anew, and keep nothing of what they answer [default: reports/cache beside the folder of the
    /// cases keeps it for later runs]
    #[arg(long)]
    pub no_cache: bool,
}

/// Reads the service for whose annotations unexpected results are written: `true` for GitHub, `false` for none.
fn annotations() -> impl TypedValueParser<Value = bool> {
    PossibleValuesParser::new(["github", "off"]).map(|name| name == "github")
}
