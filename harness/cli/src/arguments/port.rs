//! The arguments of `stickler port`.

use clap::Args;
use std::path::PathBuf;
use stickler_types::DialectName;

/// `stickler port`.
#[derive(Args, Debug)]
pub struct PortArguments {
    /// Files of Structured Text that are one program, or folders of files *.st; `-` reads stdin
    #[arg(value_name = "FILE", required = true)]
    pub files: Vec<PathBuf>,
    /// The dialect for which the program was written
    #[arg(long, value_name = "DIALECT", value_parser = super::dialects())]
    pub from: DialectName,
    /// The dialect to which it moves
    #[arg(long, value_name = "DIALECT", value_parser = super::dialects())]
    pub to: DialectName,
    /// Make the suggested changes in the files, unless the program is still rejected after them or computes something else
    #[arg(long)]
    pub fix: bool,
    /// Print one JSON object a finding
    #[arg(long)]
    pub json: bool,
    /// Write the findings to FILE in SARIF 2.1.0, for editors and code scanning
    #[arg(long, value_name = "FILE")]
    pub sarif: Option<PathBuf>,
    /// Read the cases, which say what is documented, from DIR [default: conformance-cases here or above, or those inside the program]
    #[arg(long, value_name = "DIR")]
    pub cases: Option<PathBuf>,
}
