//! The arguments of `stickler export` and `stickler import`.

use super::numbers::whole;
use clap::Args;
use std::path::PathBuf;
use stickler_export::ExtraCases;
use stickler_types::DialectName;

/// `stickler export`.
#[derive(Args, Debug)]
pub struct ExportArguments {
    /// The folder to write: an empty one, one that is not there yet, or that of an earlier export, which is replaced
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
    /// The dialect of the cases; with --plain it may be left out, for all of them
    #[arg(long, value_name = "DIALECT", value_parser = super::dialects(), required_unless_present = "plain")]
    pub dialect: Option<DialectName>,
    /// Instead of pages, write cases.jsonl, one line of JSON for each case, and a file of Structured Text for each that can be
    /// tried by hand
    #[arg(long, conflicts_with_all = ["recording", "cases_per_page", "with", "panes", "plcopen", "without", "sample"])]
    pub plain: bool,
    /// Read the cases from DIR [default: conformance-cases here or above, or those inside the program]
    #[arg(long, value_name = "DIR")]
    pub cases: Option<PathBuf>,
    /// Instead of cases, export the questions of a recording: implicit conversions, bits, comparisons, and conversion functions
    #[arg(long, conflicts_with_all = ["cases", "with"])]
    pub recording: bool,
    /// Only cases that TEXT names, as for `stickler run`
    #[arg(long, value_name = "TEXT")]
    pub filter: Option<String>,
    /// No more than N cases, drawn evenly from first to last
    #[arg(long, value_name = "N", value_parser = whole::<u32>(1, u64::from(u32::MAX)), allow_negative_numbers = true)]
    pub sample: Option<u32>,
    /// Put up to N cases on a page
    #[arg(long, value_name = "N", default_value_t = 64, value_parser = whole::<u16>(1, 1000), allow_negative_numbers = true)]
    pub cases_per_page: u16,
    /// Beside programs that must be accepted, also those that no document decides about (`open`), or those that must be
    /// rejected (`rejected`), whose pages are only compiled: on pages of their own; may be repeated
    #[arg(long, value_name = "KIND", value_parser = super::one_of(ExtraCases::ALL, ExtraCases::as_str), hide_possible_values = true)]
    pub with: Vec<ExtraCases>,
    /// Leave out the case of this id; may be repeated
    #[arg(long, value_name = "CASE")]
    pub without: Vec<String>,
    /// Write the declarations and the statements of each page as files of their own too, for editors with a pane for each
    #[arg(long)]
    pub panes: bool,
    /// Also write all pages that run as one PLCopen XML project (TC6, 2.01), which editors import at once
    #[arg(long, value_name = "FILE")]
    pub plcopen: Option<PathBuf>,
}

/// `stickler import`.
#[derive(Args, Debug)]
pub struct ImportArguments {
    /// Texts that were copied out of the editor: the arrays of pages, or the messages about pages that are only compiled;
    /// `-` reads stdin
    #[arg(value_name = "FILE", required = true)]
    pub files: Vec<PathBuf>,
    /// The folder that `stickler export` wrote [default: that of the first FILE, where it is one, or else this one]
    #[arg(long, value_name = "DIR")]
    pub export: Option<PathBuf>,
    /// The name of the compiler in reports, and in the file name of its baseline
    #[arg(long, value_name = "NAME", default_value = "imported")]
    pub engine_name: String,
    /// The version of the compiler
    #[arg(long, value_name = "VERSION", default_value = "unknown")]
    pub engine_version: String,
    /// Expect what FILE says of it [default: reports/baselines/NAME.toml beside the folder of the cases, where there is one]
    #[arg(long, value_name = "FILE", conflicts_with = "no_baseline")]
    pub baseline: Vec<PathBuf>,
    /// Expect every case to pass
    #[arg(long)]
    pub no_baseline: bool,
    /// Where the cases are that a baseline is about [default: conformance-cases here or above, or those inside the program]
    #[arg(long, value_name = "DIR")]
    pub cases: Option<PathBuf>,
    /// Write the reports to DIR [default: reports/latest beside the folder of the cases, or here]
    #[arg(long, value_name = "DIR", conflicts_with = "no_report")]
    pub report: Option<PathBuf>,
    /// Write no reports
    #[arg(long)]
    pub no_report: bool,
    /// Also write the answers as a recording, such as conformance-cases/recordings/NAME.toml; they replace those of FILE to the same questions, and its others stay
    #[arg(long, value_name = "FILE", requires_all = ["product", "product_version", "platform"])]
    pub record: Option<PathBuf>,
    /// The name of the product in the recording, such as CODESYS
    #[arg(long, value_name = "TEXT", requires = "record")]
    pub product: Option<String>,
    /// The version of the product, such as 3.5.21.40
    #[arg(long, value_name = "TEXT", alias = "version", requires = "record")]
    pub product_version: Option<String>,
    /// The system that ran the programs, such as 'Control Win V3 x64, simulation'
    #[arg(long, value_name = "TEXT", requires = "record")]
    pub platform: Option<String>,
    /// The day of the recording, such as 2026-11-24 [default: today]
    #[arg(long, value_name = "DATE", requires = "record")]
    pub date: Option<String>,
}

/// `stickler data`.
#[derive(Args, Debug)]
pub struct DataArguments {
    /// The folder to write: an empty one, one that is not there yet, or that of earlier data, which is replaced
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
    /// Read the cases from DIR [default: conformance-cases here or above, or those inside the program]
    #[arg(long, value_name = "DIR")]
    pub cases: Option<PathBuf>,
    /// Only this system; may be repeated [default: all that are documented]
    #[arg(long, value_name = "DIALECT", value_parser = super::dialects())]
    pub dialect: Vec<DialectName>,
}

/// `stickler compliance`.
#[derive(Args, Debug)]
pub struct ComplianceArguments {
    /// The system [default: the dialect of the engine, where it speaks one]
    #[arg(long, value_name = "DIALECT", value_parser = super::dialects())]
    pub dialect: Option<DialectName>,
    /// Measure this engine, as for `stickler run`
    #[arg(long, value_name = "ENGINE")]
    pub engine: Option<String>,
    /// The edition of IEC 61131-3 whose tables are listed [default: the one that the system declares, or 3]
    #[arg(long, value_name = "N", value_parser = whole::<u8>(2, 4))]
    pub edition: Option<u8>,
    /// Only the table of this number, without conversions and parameters; may be repeated
    #[arg(long, value_name = "N")]
    pub table: Vec<String>,
    /// Write a page for browsers
    #[arg(long)]
    pub html: bool,
    /// Write JSON
    #[arg(long, conflicts_with = "html")]
    pub json: bool,
    /// Write to FILE instead of stdout
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Read the cases from DIR [default: conformance-cases here or above, or those inside the program]
    #[arg(long, value_name = "DIR")]
    pub cases: Option<PathBuf>,
}
