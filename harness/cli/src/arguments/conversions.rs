//! The command lines of `stickler matrix`, `stickler conversions`, `stickler contradictions` and `stickler sweep`.

use super::dialects;
use super::numbers::whole;
use clap::Args;
use std::path::PathBuf;
use stickler_types::DialectName;

/// `stickler matrix`.
#[derive(Args, Debug)]
pub struct MatrixArguments {
    /// Ask this engine, as for `stickler run`; may be repeated, and all stand in one table [default: reference]
    #[arg(long, value_name = "ENGINE")]
    pub engine: Vec<String>,
    /// Read the cases from DIR [default: conformance-cases here or above, or those inside the program]
    #[arg(long, value_name = "DIR")]
    pub cases: Option<PathBuf>,
    /// Only this dialect; may be repeated [default: all]
    #[arg(long, value_name = "DIALECT", value_parser = dialects())]
    pub dialect: Vec<DialectName>,
    /// Show the recordings of conformance-cases/recordings too, also where engines are named [default: only where none is]
    #[arg(long)]
    pub recorded: bool,
    /// Print one JSON object: the questions with the answers of documents, recordings and engines, as `stickler data` has them
    #[arg(long)]
    pub json: bool,
}

/// `stickler conversions`.
#[derive(Args, Debug)]
pub struct ConversionsArguments {
    /// The function, such as REAL_TO_INT; all are listed where none is given
    #[arg(value_name = "FUNCTION")]
    pub function: Option<String>,
    /// A value to convert, as a typed or untyped literal; for CONCAT_DATE_TOD and its like, pairs of them
    /// [default: the boundaries of its types]
    #[arg(value_name = "VALUE", allow_negative_numbers = true)]
    pub values: Vec<String>,
    /// Only this dialect; may be repeated [default: all that have the function]
    #[arg(long, value_name = "DIALECT", value_parser = dialects())]
    pub dialect: Vec<DialectName>,
    /// Ask this engine: `reference`, or `cmd:COMMAND LINE`; may be repeated [default: reference]
    #[arg(long, value_name = "ENGINE")]
    pub engine: Vec<String>,
    /// Read the cases, which hold single recorded values, from DIR [default: conformance-cases here or above, or those inside the program]
    #[arg(long, value_name = "DIR")]
    pub cases: Option<PathBuf>,
    /// Show the recordings of conformance-cases/recordings too, also where engines are named [default: only where none is]
    #[arg(long)]
    pub recorded: bool,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// `stickler contradictions`.
#[derive(Args, Debug)]
pub struct ContradictionsArguments {
    /// Only questions in whose text, case or program each of these words stands, such as REAL_TO_INT or LIMIT [default: all]
    #[arg(value_name = "WORD", allow_negative_numbers = true)]
    pub words: Vec<String>,
    /// Show every contradiction [default: the 40 largest]
    #[arg(long)]
    pub all: bool,
    /// Read the cases from DIR [default: conformance-cases here or above, or those inside the program]
    #[arg(long, value_name = "DIR")]
    pub cases: Option<PathBuf>,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// `stickler sweep`.
#[derive(Args, Debug)]
pub struct SweepArguments {
    /// A conversion function such as DINT_TO_INT, or ABS, NOT, LEN, SQRT, LN, LOG, EXP, SIN, COS, TAN, ASIN, ACOS, ATAN; one that takes several types is swept
    /// for each
    #[arg(value_name = "FUNCTION")]
    pub function: String,
    /// Only this dialect; may be repeated [default: all that have the function; equal rules are swept once]
    #[arg(long, value_name = "DIALECT", value_parser = dialects())]
    pub dialect: Vec<DialectName>,
    /// Sweep this engine, through programs that it executes [default: reference, through its own conversion]
    #[arg(
        long,
        value_name = "ENGINE",
        default_value = "reference",
        hide_default_value = true
    )]
    pub engine: String,
    /// Take N inputs at random, beside the boundaries, instead of every one; sources of more than 32 bits and
    /// texts are always sampled [default: 1000000, or 10000 of an engine that is not the reference]
    #[arg(long, value_name = "N", value_parser = whole::<u64>(0, (1 << 48) - 1), allow_negative_numbers = true)]
    pub sample: Option<u64>,
    /// Where the random inputs come from: the same N gives the same inputs
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = whole::<u64>(0, u64::MAX), allow_negative_numbers = true)]
    pub seed: u64,
    /// Use N threads [default: one a processor]
    #[arg(long, value_name = "N", value_parser = whole::<u16>(1, 1024), allow_negative_numbers = true)]
    pub jobs: Option<u16>,
}
