//! `stickler conversions`: what one conversion function does, dialects side by side.

use crate::arguments::ConversionsArguments;
use crate::conversions::{self, Block, Present};
use crate::exit::Exit;
use crate::{engines, interrupt};
use std::io::Write;
use stickler_exact::Signature;
use stickler_types::DialectName;

/// Shows what a function gives for boundary values, or for the values that were named; lists the functions where none is
/// named. Each value comes from a program that runs on an engine, and is held against what the documents say.
///
/// # Errors
/// A name that is no conversion function, a value that does not fit, an engine that cannot be run.
pub fn execute(arguments: &ConversionsArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let Some(function) = &arguments.function else {
        conversions::all()
            .iter()
            .try_for_each(|name| writeln!(out, "{name}"))?;
        return Ok(Exit::AsExpected);
    };
    let function = function.to_ascii_uppercase();
    let Present { having, lacking } = conversions::present(&function, &arguments.dialect)?;
    let rows = conversions::rows(&arguments.values, signatures(&function, &having))?;
    interrupt::at_once()?;
    let engines = engines::by_names(&arguments.engine)?;
    let blocks = conversions::gather(rows, &having, &engines)?;
    if arguments.json {
        conversions::write_json(&function, &blocks, &engines, out)?;
    } else {
        conversions::write_page(&blocks, &lacking, &engines, out)?;
    }
    let contradicted = blocks
        .iter()
        .any(|block: &Block| block.contradictions().next().is_some());
    Ok(match contradicted {
        true => Exit::Failures,
        false => Exit::AsExpected,
    })
}

/// Every signature that one of the dialects has, each once.
fn signatures(function: &str, dialects: &[DialectName]) -> Vec<Signature> {
    let mut found: Vec<Signature> = Vec::new();
    for dialect in dialects {
        for signature in stickler_exact::signatures(function, *dialect) {
            if !found.contains(&signature) {
                found.push(signature);
            }
        }
    }
    found
}
