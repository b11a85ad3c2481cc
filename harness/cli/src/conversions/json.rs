//! The answers as one JSON object, for other programs.

use super::ask::Got;
use super::block::{Block, Cell, Column};
use crate::engines::Named;
use serde::Serialize;
use std::io::{self, Write};

/// Everything that was asked about one function.
#[derive(Serialize)]
struct Answers<'a> {
    function: &'a str,
    engines: Vec<Engine<'a>>,
    signatures: Vec<Types<'a>>,
}

#[derive(Serialize)]
struct Engine<'a> {
    name: &'a str,
    version: &'a str,
}

/// One way to call the function.
#[derive(Serialize)]
struct Types<'a> {
    operands: Vec<&'static str>,
    result: &'static str,
    calls: Vec<Call<'a>>,
}

/// One call. Values are typed literals.
#[derive(Serialize)]
struct Call<'a> {
    operands: Vec<String>,
    results: Vec<Result<'a>>,
}

/// What one engine gave in one dialect.
#[derive(Serialize)]
struct Result<'a> {
    engine: &'a str,
    dialect: &'static str,
    /// The value; `null` where there is none.
    got: Option<String>,
    /// Why there is none: `rejected`, `crashed` …
    #[serde(skip_serializing_if = "Option::is_none")]
    without: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    detail: Option<&'a str>,
    /// The document and section that say what must come; `null` where none does.
    basis: Option<&'static str>,
    /// What it says must come.
    #[serde(skip_serializing_if = "Option::is_none")]
    expected: Option<String>,
    /// Whether the engine contradicts it.
    contradicts: bool,
}

/// Writes the object and a line feed.
///
/// # Errors
/// Those of `out`.
pub fn write(function: &str, blocks: &[Block], engines: &[Named], out: &mut dyn Write) -> io::Result<()> {
    let answers = Answers {
        function,
        engines: engines.iter().map(engine).collect(),
        signatures: blocks.iter().map(|block| types(block, engines)).collect(),
    };
    serde_json::to_writer_pretty(&mut *out, &answers)?;
    writeln!(out)
}

fn engine(named: &Named) -> Engine<'_> {
    Engine {
        name: &named.identity().name,
        version: &named.identity().version,
    }
}

fn types<'a>(block: &'a Block, engines: &'a [Named]) -> Types<'a> {
    let call = |(index, operands): (usize, &Vec<stickler_types::Value>)| Call {
        operands: operands.iter().map(ToString::to_string).collect(),
        results: block
            .columns
            .iter()
            .filter_map(|column| Some(result(column, column.cells.get(index)?, engines)))
            .collect(),
    };
    Types {
        operands: block.signature.operands.iter().map(|ty| ty.name()).collect(),
        result: block.signature.result.name(),
        calls: block.calls.iter().enumerate().map(call).collect(),
    }
}

fn result<'a>(column: &Column, cell: &'a Cell, engines: &'a [Named]) -> Result<'a> {
    let (got, without, detail) = match &cell.got {
        Got::Value(value) => (Some(value.to_string()), None, None),
        Got::None { word, detail } => (None, Some(*word), Some(detail.as_str())),
    };
    Result {
        engine: engines
            .get(column.engine)
            .map_or("", |named| &named.identity().name),
        dialect: column.dialect.as_str(),
        got,
        without,
        detail,
        basis: cell.expected.basis,
        expected: cell.expected.basis.map(|_| cell.expected.value.to_string()),
        contradicts: cell.contradicts(),
    }
}
