//! Integers and bit strings among each other.

use super::words::{ALL, DESIGN, DOCUMENTED, NAMING, PAIR, PLCNEXT, RANGE};
use crate::call::Call;
use crate::inputs::integers::{BIT_STRINGS, INTEGERS, for_pair};
use crate::program::{PAIR_OF_CONSTANT, PAIR_OF_VARIABLE};
use crate::sheet::{CallProbe, Sheet};
use stickler_types::ElementaryType;

const MODULO: &str = "\
The value of the source modulo 2^n of the target: at and around the limits of both types, at powers of two, and at an irregular
pattern. `constant` gives the function a literal, because folding a constant must not change the value. PLCnext's documents
do not say what happens; there the value is recorded.";

/// The tables of this family.
pub fn sheets() -> Vec<Sheet> {
    vec![
        modulo(
            "integer-to-integer",
            "An integer converts to an integer modulo 2^n",
            RANGE,
            "",
            (&INTEGERS, &INTEGERS),
        ),
        modulo(
            "integer-to-bit-string",
            "An integer converts to a bit string modulo 2^n",
            RANGE,
            " A negative number keeps its two's complement: SINT_TO_WORD(-1) is 16#FFFF.",
            (&INTEGERS, &BIT_STRINGS),
        ),
        modulo(
            "bit-string-to-integer",
            "A bit string converts to an integer as an unsigned number modulo 2^n",
            NAMING,
            " A bit string has no sign: BYTE_TO_INT(16#FF) is 255.",
            (&BIT_STRINGS, &INTEGERS),
        ),
        modulo(
            "bit-string-to-bit-string",
            "A bit string converts to a bit string modulo 2^n",
            DESIGN,
            " Wider targets are filled with zeros.",
            (&BIT_STRINGS, &BIT_STRINGS),
        ),
    ]
}

/// One of the four tables, with every pair of two lists of types.
fn modulo(
    name: &'static str,
    title: &'static str,
    basis: &'static str,
    more: &str,
    (sources, targets): (&[ElementaryType], &[ElementaryType]),
) -> Sheet {
    let pairs = sources
        .iter()
        .flat_map(|&from| targets.iter().map(move |&to| (from, to)));
    let calls = pairs.filter(|(from, to)| from != to).flat_map(|(from, to)| {
        let operands = for_pair(from, to).into_iter();
        operands.map(move |operand| Call::convert(from, to, operand))
    });
    Sheet {
        name,
        title,
        basis,
        dialects: ALL.to_vec(),
        summary: format!("{MODULO}{more}"),
        columns: PAIR,
        calls: calls.collect(),
        probes: CallProbe::variable_and_constant(DOCUMENTED, PLCNEXT, PAIR_OF_VARIABLE, PAIR_OF_CONSTANT),
    }
}
