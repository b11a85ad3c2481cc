//! The overview as one JSON object, for other programs.

use super::results::{ComparedResult, DialectResults, SignatureResults};
use serde::Serialize;
use std::io::{self, Write};
use stickler_engines::Identity;
use stickler_types::Value;

/// The JSON object: the results of one function for all of its signatures.
#[derive(Serialize)]
struct FunctionResults<'a> {
    function: &'a str,
    engines: Vec<EngineResults<'a>>,
    signatures: Vec<JsonSignature<'a>>,
}

#[derive(Serialize)]
struct EngineResults<'a> {
    name: &'a str,
    version: &'a str,
}

/// The results of one signature of the function.
#[derive(Serialize)]
struct JsonSignature<'a> {
    operands: Vec<&'static str>,
    result: &'static str,
    calls: Vec<CallResults<'a>>,
}

/// The results of one call; values are typed literals.
#[derive(Serialize)]
struct CallResults<'a> {
    operands: Vec<String>,
    results: Vec<CallResult<'a>>,
}

/// The result of one engine in one dialect for one call.
#[derive(Serialize)]
struct CallResult<'a> {
    engine: &'a str,
    dialect: &'static str,
    /// The value that the engine gave; `null` where it gave none.
    got: Option<String>,
    /// The reason why the engine gave no value: `rejected`, `crashed` …
    #[serde(skip_serializing_if = "Option::is_none")]
    without: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    detail: Option<&'a str>,
    /// The document and section that demand a result; `null` where none does.
    basis: Option<&'a str>,
    /// The value that the document demands.
    #[serde(skip_serializing_if = "Option::is_none")]
    expected: Option<String>,
    /// Whether the engine contradicts the document.
    contradicts: bool,
    /// The statement of another source of the same system, where its value differs.
    #[serde(skip_serializing_if = "Option::is_none")]
    otherwise: Option<JsonStatement<'a>>,
}

/// The value that a source states.
#[derive(Serialize)]
struct JsonStatement<'a> {
    basis: &'a str,
    value: String,
}

/// Writes the JSON object of a function, and a line feed.
///
/// # Errors
/// Errors of writing to `out`.
pub fn write(
    function: &str,
    results: &[SignatureResults],
    engines: &[&Identity],
    out: &mut dyn Write,
) -> io::Result<()> {
    let answers = FunctionResults {
        function,
        engines: engines.iter().map(|identity| engine(identity)).collect(),
        signatures: results.iter().map(|results| types(results, engines)).collect(),
    };
    serde_json::to_writer_pretty(&mut *out, &answers)?;
    writeln!(out)
}

fn engine(identity: &Identity) -> EngineResults<'_> {
    EngineResults {
        name: &identity.name,
        version: &identity.version,
    }
}

fn types<'a>(all: &'a SignatureResults, engines: &[&'a Identity]) -> JsonSignature<'a> {
    let call = |(index, operands): (usize, &Vec<Value>)| CallResults {
        operands: operands.iter().map(ToString::to_string).collect(),
        results: all
            .columns
            .iter()
            .filter_map(|column| Some(result(column, column.results.get(index)?, engines)))
            .collect(),
    };
    JsonSignature {
        operands: all.signature.operands.iter().map(|ty| ty.name()).collect(),
        result: all.signature.result.name(),
        calls: all.calls.iter().enumerate().map(call).collect(),
    }
}

fn result<'a>(
    column: &DialectResults,
    compared: &'a ComparedResult,
    engines: &[&'a Identity],
) -> CallResult<'a> {
    let (got, without, detail) = match &compared.got {
        Ok(value) => (Some(value.to_string()), None, None),
        Err(refusal) => (None, Some(refusal.kind.word()), Some(refusal.detail.as_str())),
    };
    CallResult {
        engine: engines.get(column.engine).map_or("", |identity| &identity.name),
        dialect: column.dialect.as_str(),
        got,
        without,
        detail,
        basis: compared.expected.basis.as_deref(),
        expected: compared
            .expected
            .basis
            .as_ref()
            .map(|_| compared.expected.value.to_string()),
        contradicts: compared.contradicts(),
        otherwise: compared.expected.otherwise.as_ref().map(|other| JsonStatement {
            basis: &other.basis,
            value: other.value.to_string(),
        }),
    }
}
