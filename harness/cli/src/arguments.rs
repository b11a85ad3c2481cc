//! The command line as clap reads it: commands, options and the help that teaches them by example.

mod conversions;
mod engines;
mod export;
mod fuzz;
mod numbers;
mod programs;
mod reports;
mod run;
mod suite;

pub use conversions::{ContradictionsArguments, ConversionsArguments, MatrixArguments, SweepArguments};
pub use engines::{EngineArguments, EnginesArguments, RecordArguments};
pub use export::{ComplianceArguments, DataArguments, ExportArguments, ImportArguments};
pub use fuzz::{FuzzArguments, MergeArguments, PromoteArguments};
pub use programs::{JudgeArguments, PortArguments, ReduceArguments, ReproduceArguments};
pub use reports::{BlessArguments, CompareArguments, SiteArguments};
pub use run::RunArguments;
pub use suite::{ChangesArguments, LintArguments, ListArguments, ShowArguments, SourcesArguments};

use crate::commands::Command;
use crate::exit;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, Parser};
use clap_complete::Shell;
use numbers::whole;
use std::path::PathBuf;
use stickler_types::{ClockSetting, DialectName, Setting, Value};

/// The conformance suite for compilers of IEC 61131-3 Structured Text.
///
/// Without a command, the whole suite runs on the reference implementation in every dialect, and the reports are
/// written to reports/latest.
#[derive(Parser, Debug)]
#[command(name = "stickler", version, disable_help_subcommand = true, term_width = 80)]
#[command(after_help = top_level_help())]
pub struct Arguments {
    /// The command; `run` where none is given.
    #[command(subcommand)]
    pub command: Option<Command>,
    /// Read FILE, which names engines and defines dialects [default: stickler.toml here or in a folder above]
    #[arg(long, value_name = "FILE", global = true)]
    pub config: Option<PathBuf>,
}

/// The cases that a command works on.
#[derive(Args, Debug, Default)]
pub struct SelectionArguments {
    /// Read the cases from DIR [default: conformance-cases here or above, or those inside the program]
    #[arg(long, value_name = "DIR")]
    pub cases: Option<PathBuf>,
    /// Only the case that TEXT names; where it names none, the cases whose `id@dialect` contains it, or, where
    /// TEXT has a `*`, those that it fits from start to end; may be repeated
    #[arg(long, value_name = "TEXT")]
    pub filter: Vec<String>,
    /// Leave out the cases that TEXT names or fits, as --filter reads it; may be repeated
    #[arg(long, value_name = "TEXT")]
    pub exclude: Vec<String>,
    /// Only cases of this dialect, which stickler.toml may define; may be repeated [default: those of documented systems]
    #[arg(long, value_name = "DIALECT", value_parser = dialects())]
    pub dialect: Vec<DialectName>,
}

/// A source file and the dialect to read it in.
#[derive(Args, Debug)]
pub struct SourceArguments {
    /// A file of Structured Text; `-` reads stdin
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// The dialect to read it in
    #[arg(long, value_name = "DIALECT", value_parser = dialects())]
    pub dialect: DialectName,
}

/// A program of one source file or several, and the dialect to read it in.
#[derive(Args, Debug)]
pub struct ProgramArguments {
    /// Files of Structured Text that are one program, or folders of files *.st; `-` reads stdin
    #[arg(value_name = "FILE", required = true)]
    pub files: Vec<PathBuf>,
    /// The dialect to read it in
    #[arg(long, value_name = "DIALECT", value_parser = dialects())]
    pub dialect: DialectName,
}

/// `stickler check`.
#[derive(Args, Debug)]
pub struct CheckArguments {
    /// The program to check.
    #[command(flatten)]
    pub program: ProgramArguments,
    /// Print the reply of the wire protocol instead: one JSON object; of several files one a line, each with the name of its `file`
    #[arg(long)]
    pub json: bool,
}

/// `stickler eval`.
#[derive(Args, Debug)]
pub struct EvalArguments {
    /// The program to execute.
    #[command(flatten)]
    pub program: ProgramArguments,
    /// Run this PROGRAM, whatever a configuration says [default: what a configuration says, or main, or the first]
    #[arg(long = "program", value_name = "NAME")]
    pub runs: Option<String>,
    /// Give a variable a value before the first scan, or another one: `IN = BOOL#TRUE`, `IN = BOOL#FALSE before 3`; may be repeated
    #[arg(long, value_name = "SETTING", value_parser = setting)]
    pub set: Vec<Setting>,
    /// Run N scans
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = whole::<u32>(0, u32::MAX.into()), allow_negative_numbers = true)]
    pub scans: u32,
    /// Let TIME, such as T#10ms, pass from each scan to the next, for timers
    #[arg(long, value_name = "TIME", value_parser = duration)]
    pub cycle: Option<i64>,
    /// Begin a scan at a time since the start: `T#150ms before 3`; may be repeated
    #[arg(long, value_name = "TIME", value_parser = clock, conflicts_with = "cycle")]
    pub clock: Vec<ClockSetting>,
    /// Print only this variable; may be repeated, may be a path [default: all elementary variables of the program]
    #[arg(long, value_name = "NAME")]
    pub observe: Vec<String>,
}

/// `stickler explain`.
#[derive(Args, Debug)]
pub struct ExplainArguments {
    /// A code such as P4035; all codes are listed where none is given
    #[arg(value_name = "CODE")]
    pub code: Option<String>,
}

/// `stickler completions`.
#[derive(Args, Debug)]
pub struct CompletionsArguments {
    /// The shell
    #[arg(value_name = "SHELL")]
    pub shell: Shell,
}

/// Parses `NAME = VALUE` and `NAME = VALUE before SCAN`, as the marks of case files have it.
fn setting(text: &str) -> Result<Setting, String> {
    let wrong = || format!("`{text}` is no setting; write `NAME = INT#5` or `NAME = INT#5 before 3`");
    let (name, rest) = text.split_once('=').ok_or_else(wrong)?;
    let (value, before) = match rest.rsplit_once(" before ") {
        Some((value, scan)) => (value, scan.trim().parse().map_err(|_| wrong())?),
        None => (rest, 1),
    };
    let value = Value::parse(value.trim()).map_err(|error| format!("{}: {error}", value.trim()))?;
    Ok(Setting {
        before,
        name: name.trim().into(),
        value,
    })
}

/// Parses `TIME before SCAN`, as the marks of case files have it.
fn clock(text: &str) -> Result<ClockSetting, String> {
    let Setting { before, value, .. } = setting(&format!("clock = {text}"))?;
    ClockSetting::at(before, &value).ok_or_else(|| format!("{value} is no duration such as T#10ms"))
}

/// Parses a duration that is no less than none: its nanoseconds.
fn duration(text: &str) -> Result<i64, String> {
    let value = Value::parse(text).ok();
    let setting = value.and_then(|value| ClockSetting::at(1, &value));
    let nanoseconds = setting.map(|setting| setting.nanoseconds);
    nanoseconds
        .filter(|nanoseconds| *nanoseconds >= 0)
        .ok_or_else(|| "expected a duration of 0 or more, such as T#10ms".to_owned())
}

/// Parses one of some values by its name.
fn one_of<T>(
    all: impl IntoIterator<Item = T>,
    name: fn(T) -> &'static str,
) -> impl TypedValueParser<Value = T>
where
    T: Copy + Send + Sync + 'static,
{
    let all: Vec<T> = all.into_iter().collect();
    let names: Vec<&str> = all.iter().copied().map(name).collect();
    PossibleValuesParser::new(names).try_map(move |word| {
        let named = all.iter().copied().find(|one| name(*one) == word);
        named.ok_or("nothing has this name")
    })
}

/// Returns what an option that may be repeated names, or all where it names nothing.
pub fn named_or_all<'a, T>(named: &'a [T], all: &'a [T]) -> &'a [T] {
    if named.is_empty() { all } else { named }
}

/// The dialects that there are now: those of stickler.toml once that file was read.
fn dialects() -> impl TypedValueParser<Value = DialectName> {
    let shown = |dialect: DialectName| {
        // The help of each command would be about little else.
        let value = PossibleValue::new(dialect.as_str()).hide(dialect.is_variant());
        match dialect
            .definition()
            .and_then(|definition| definition.about.as_deref())
        {
            Some(about) => value.help(about),
            None => value,
        }
    };
    let all = DialectName::ALL.into_iter().chain(DialectName::defined());
    PossibleValuesParser::new(all.map(shown)).try_map(|name| name.parse::<DialectName>())
}

fn top_level_help() -> String {
    let examples = include_str!("arguments/examples/top-level.txt");
    format!("{examples}\n{}", exit::listing())
}

#[cfg(test)]
mod tests {
    use super::Arguments;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_contradicts_itself_nowhere() {
        Arguments::command().debug_assert();
    }
}
