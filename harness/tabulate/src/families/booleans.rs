//! BOOL to numbers and back.

use super::words::{ALL, DOCUMENTED, NAMING, PAIR, PLCNEXT};
use crate::call::Call;
use crate::inputs::integers::{BIT_STRINGS, INTEGERS, ascending, limits};
use crate::inputs::reals::REALS;
use crate::operand::Operand;
use crate::program::{PAIR_OF_CONSTANT, PAIR_OF_VARIABLE};
use crate::sheet::{CallProbe, Sheet};
use stickler_types::ElementaryType;

/// The tables of this family.
pub fn sheets() -> Vec<Sheet> {
    vec![bool_to_number(), number_to_bool()]
}

fn numbers() -> impl Iterator<Item = ElementaryType> {
    INTEGERS.into_iter().chain(BIT_STRINGS)
}

fn probes() -> Vec<CallProbe> {
    CallProbe::variable_and_constant(DOCUMENTED, PLCNEXT, PAIR_OF_VARIABLE, PAIR_OF_CONSTANT)
}

fn bool_to_number() -> Sheet {
    let bool = ElementaryType::Bool;
    let calls = numbers()
        .chain(REALS)
        .flat_map(|to| [0, 1].map(|number| Call::convert(bool, to, Operand::number(bool, number))));
    Sheet {
        name: "bool-to-number",
        title: "TRUE converts to 1 and FALSE to 0",
        basis: NAMING,
        dialects: ALL.to_vec(),
        summary: String::new(),
        columns: PAIR,
        calls: calls.collect(),
        probes: probes(),
    }
}

fn number_to_bool() -> Sheet {
    const FRACTIONS: [&str; 9] = [
        "0.0", "-0.0", "1.0", "-1.0", "0.5", "0.1", "256.0", "1.0E-30", "1.0E30",
    ];
    let bool = ElementaryType::Bool;
    let whole = numbers().flat_map(|from| {
        let (least, greatest) = limits(from);
        let numbers = [
            0,
            1,
            2,
            256,
            greatest,
            greatest - 1,
            greatest / 2 + 1,
            least.max(-1),
            least,
        ];
        ascending(from, numbers)
            .into_iter()
            .map(move |operand| (from, operand))
    });
    let real = REALS
        .into_iter()
        .flat_map(|from| FRACTIONS.map(|literal| (from, Operand::read(from, literal))));
    let calls = whole
        .chain(real)
        .map(|(from, operand)| Call::convert(from, bool, operand));
    Sheet {
        name: "number-to-bool",
        title: "0 converts to FALSE, anything else to TRUE",
        basis: NAMING,
        dialects: ALL.to_vec(),
        summary: "Not only the lowest bit counts: 2 and 256 are TRUE.".to_owned(),
        columns: PAIR,
        calls: calls.collect(),
        probes: probes(),
    }
}
