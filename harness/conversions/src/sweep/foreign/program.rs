//! Writes the programs that count through operands: one that adds the results up, and one that keeps each result.

use super::plan::Counting;
use crate::program::ConversionProgram;
use std::ops::Range;
use stickler_exact::Signature;
use stickler_types::ElementaryType;

/// Writes a program that adds up the results for the operands at the given places of a stretch, fewer than 2^31.
pub fn summed(signature: &Signature, counting: &Counting, places: &Range<u64>) -> ConversionProgram {
    let Signature { function, result, .. } = signature;
    let inputs = places.end - places.start;
    let (making, advancing) = (counting.counter.making(), counting.counter.advancing());
    let making = if making.is_empty() {
        making
    } else {
        format!("        {making}\n")
    };
    let declarations = format!(
        "{}    given  : {result};\n    passed : DINT := DINT#0;\n{}",
        counting.counter.declarations(places.start),
        counting.checksum.declarations(),
    );
    let statements = format!(
        "    REPEAT\n\
         {making}        given := {function}(operand);\n{}        passed := passed + DINT#1;\n        \
         IF passed < DINT#{inputs} THEN\n            {advancing}\n        END_IF;\n    \
         UNTIL passed >= DINT#{inputs}\n    END_REPEAT;\n",
        counting.checksum.statements(),
    );
    ConversionProgram {
        declarations,
        statements,
        observed: vec!["total".to_owned()],
        ty: ElementaryType::Lint,
    }
}

/// Writes a program that counts through the given places of a stretch and keeps each result in a variable of its own.
pub fn unrolled(signature: &Signature, counting: &Counting, places: &Range<u64>) -> ConversionProgram {
    let Signature { function, result, .. } = signature;
    let (making, advancing) = (counting.counter.making(), counting.counter.advancing());
    let observed: Vec<String> = (1..=places.end - places.start)
        .map(|number| format!("given{number}"))
        .collect();
    let mut declarations = counting.counter.declarations(places.start);
    let mut statements = String::new();
    for name in &observed {
        declarations.push_str(&format!("    {name} : {result};\n"));
    }
    for (index, name) in observed.iter().enumerate() {
        if index > 0 {
            statements.push_str(&format!("    {advancing}\n"));
        }
        if !making.is_empty() {
            statements.push_str(&format!("    {making}\n"));
        }
        statements.push_str(&format!("    {name} := {function}(operand);\n"));
    }
    ConversionProgram {
        declarations,
        statements,
        observed,
        ty: *result,
    }
}
