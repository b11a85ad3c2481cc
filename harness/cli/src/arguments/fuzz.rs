//! The command lines of campaigns: `fuzz`, `promote`, `merge`.

use super::dialects;
use super::numbers::whole;
use clap::Args;
use clap::builder::NonEmptyStringValueParser;
use std::path::PathBuf;
use std::time::Duration;
use stickler_generate::oracles::FuzzTarget;
use stickler_types::DialectName;
use stickler_workers::Shard;

/// `stickler fuzz`.
#[derive(Args, Debug)]
pub struct FuzzArguments {
    /// Hold inputs against this oracle of the reference; may be repeated, then in rotation [default: execute, check,
    /// convert, literal, parse]
    #[arg(long, value_name = "TARGET", value_parser = super::one_of(FuzzTarget::ALL, FuzzTarget::as_str), conflicts_with_all = ["engine", "dialect"])]
    pub target: Vec<FuzzTarget>,
    /// Hold this engine, and the reference, against what the documents say of random programs: `reference`, a compiler
    /// with an adapter, or `cmd:COMMAND LINE`; may be repeated
    #[arg(long, value_name = "ENGINE")]
    pub engine: Vec<String>,
    /// Only programs of this dialect, on the engines or the reference; may be repeated [default: those that the engines speak]
    #[arg(long, value_name = "DIALECT", value_parser = dialects())]
    pub dialect: Vec<DialectName>,
    /// Where inputs come from: the same N gives the same inputs
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = whole::<u64>(0, u64::MAX), allow_negative_numbers = true)]
    pub seed: u64,
    /// Begin with input N of the seed
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = whole::<u64>(0, u64::MAX), allow_negative_numbers = true)]
    pub first: u64,
    /// Go on for so long: 90s, 10m, 2h [default: 60s]
    #[arg(long, value_name = "TIME", value_parser = time, allow_negative_numbers = true, conflicts_with = "count")]
    pub time: Option<Duration>,
    /// Judge N inputs; what is found then depends on nothing but the seed
    #[arg(long, value_name = "N", value_parser = whole::<u64>(0, u64::MAX), allow_negative_numbers = true)]
    pub count: Option<u64>,
    /// Judge N inputs at a time [default: one a processor]
    #[arg(long, value_name = "N", value_parser = whole::<u16>(1, 1024), allow_negative_numbers = true)]
    pub jobs: Option<u16>,
    /// Judge part I of N of the inputs; `stickler merge` puts the findings of all parts together
    #[arg(long, value_name = "I/N")]
    pub shard: Option<Shard>,
    /// With --engine: let programs use what documents leave open; then values are not compared, and only crashes and
    /// hangs count
    #[arg(long, requires = "engine")]
    pub open: bool,
    /// With --engine: only programs that have nothing of this, a type or a word that findings show for their programs (MUX,
    /// CHAR, REAL_TO_INT, array-one-element); may be repeated. What an engine was found to reject then no longer hides what else
    /// is wrong with it. WORD@DIALECT leaves it out of the programs of one dialect
    #[arg(long, value_name = "WORD", requires = "engine", value_delimiter = ',')]
    pub without: Vec<String>,
    /// With --engine: do not ask the engine for each part of the language alone first. Without this, what it fails with is
    /// left out of the programs, and said
    #[arg(long, requires = "engine")]
    pub no_survey: bool,
    /// With --engine: make programs of at most N random bytes, 32 to 2048; 256 make some 60 lines [default: 2048, and less
    /// for a slow engine without --count]
    #[arg(long, value_name = "N", requires = "engine", value_parser = whole::<u16>(32, 2048), allow_negative_numbers = true)]
    pub max_input: Option<u16>,
    /// With --engine: what the run of the suite in DIR found is known, and shown apart [default: reports/latest, where it
    /// has causes of the engine]
    #[arg(long, value_name = "DIR", requires = "engine")]
    pub known: Option<PathBuf>,
    /// Keep findings in DIR [default: reports/findings beside the folder of the cases]
    #[arg(long, value_name = "DIR")]
    pub findings: Option<PathBuf>,
    /// Judge a finding again, its folder or its name in the folder of findings, or, with --target, the bytes of any file
    #[arg(long, value_name = "PATH", conflicts_with_all = ["seed", "first", "time", "count", "shard", "open", "dialect", "without", "no_survey", "max_input", "known"])]
    pub replay: Option<PathBuf>,
}

/// `stickler promote`.
#[derive(Args, Debug)]
pub struct PromoteArguments {
    /// A finding: its folder, or its name in reports/findings; or a recording, such as conformance-cases/recordings/NAME.toml
    #[arg(value_name = "FINDING")]
    pub finding: PathBuf,
    /// Of a recording: the dialect that gets the cases, the recorded one or one that extends it [default: the recorded one, where there
    /// is one alone]
    #[arg(long, value_name = "DIALECT", value_parser = dialects())]
    pub dialect: Option<DialectName>,
    /// The document and section that say what must happen, `source: section` [default: as the finding proposes]
    #[arg(long, value_name = "BASIS")]
    pub basis: Option<String>,
    /// Give the case this title, a line that says what holds [default: what the program uses, and the symptom]
    #[arg(long, value_name = "TITLE", value_parser = NonEmptyStringValueParser::new())]
    pub title: Option<String>,
    /// The name of the case, found/NAME, or of the tables [default: the finding's, or the recording's]
    #[arg(long, value_name = "NAME")]
    pub name: Option<String>,
    /// The folder of the cases [default: conformance-cases here or above, or those inside the program]
    #[arg(long, value_name = "DIR")]
    pub cases: Option<PathBuf>,
}

/// `stickler merge`.
#[derive(Args, Debug)]
pub struct MergeArguments {
    /// The folders of the parts: the reports of the parts of a run, or the findings of the parts of a campaign
    #[arg(value_name = "DIR", required = true)]
    pub folders: Vec<PathBuf>,
    /// Of a run: read the cases, of whose conversions the page tells, from DIR [default: conformance-cases here or above, or those inside
    /// the program]
    #[arg(long, value_name = "DIR")]
    pub cases: Option<PathBuf>,
    /// Where to put them together: the reports of the whole run, or all findings
    #[arg(short, long, value_name = "DIR")]
    pub output: PathBuf,
}

/// Reads `90s`, `10m`, `2h`, `500ms`; a number alone is seconds.
pub(super) fn time(text: &str) -> Result<Duration, String> {
    let digits = text.bytes().take_while(u8::is_ascii_digit).count();
    let (number, unit) = text.split_at(digits);
    let wrong = || format!("`{text}` is no time; write it as 90s, 10m or 2h");
    let number: u64 = number.parse().map_err(|_| wrong())?;
    let milliseconds = match unit {
        "ms" => 1,
        "s" | "" => 1000,
        "m" => 60_000,
        "h" => 3_600_000,
        _ => return Err(wrong()),
    };
    let all = number
        .checked_mul(milliseconds)
        .ok_or_else(|| format!("`{text}` is too long a time"))?;
    Ok(Duration::from_millis(all))
}

#[cfg(test)]
mod tests {
    use super::time;
    use stickler_mdtest::check_examples;

    #[test]
    fn golden_times() {
        check_examples("tests/times.md", |example| {
            time(example.text("text")).map_or_else(|_| "none".to_owned(), |time| format!("{time:?}"))
        });
    }
}
