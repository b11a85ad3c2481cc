//! Each power of two between integers and bit strings, beside the boundaries in [`super::integers`].

use super::words::{DESIGN, IRONPLC_EXPLICIT, IRONPLC_NARROWING, NAMING, OPEN_PAIR, RANGE, VALUES};
use crate::call::Call;
use crate::class::{self, Class, Form, Voices};
use crate::inputs::integers::{BIT_STRINGS, INTEGERS, for_pair, powers_of_two};
use crate::program::PAIR_OF_VARIABLE;
use crate::sheet::Sheet;

const CLASSES: [Class; 6] = [
    Class {
        name: "powers-of-two-narrowed",
        title: "Each power of two of an integer loses the bits that a narrower type does not have",
        summary: "",
        voices: Voices::both(RANGE, IRONPLC_NARROWING),
    },
    Class {
        name: "powers-of-two-kept",
        title: "Each power of two of an integer stays what it is in a type that holds it",
        summary: "",
        voices: Voices::both(RANGE, IRONPLC_EXPLICIT),
    },
    Class {
        name: "powers-of-two-with-a-sign",
        title: "Each power of two of an integer keeps its bits where only the sign does not fit",
        summary: "A negative number is extended by ones: SINT_TO_ULINT(-1) is 2^64 - 1.",
        voices: Voices::both(RANGE, DESIGN),
    },
    Class {
        name: "powers-of-two-of-bits-narrowed",
        title: "Each bit of a bit string is lost that a narrower integer does not have",
        summary: "",
        voices: Voices::both(NAMING, IRONPLC_NARROWING),
    },
    Class {
        name: "powers-of-two-of-bits-kept",
        title: "Each bit of a bit string counts for its power of two in an integer that holds it",
        summary: "",
        voices: Voices::both(NAMING, IRONPLC_EXPLICIT),
    },
    Class {
        name: "powers-of-two-between-bit-strings",
        title: "Each bit of a bit string keeps its place in another, or is lost",
        summary: "",
        voices: Voices::both(DESIGN, DESIGN),
    },
];

/// The tables of this family.
///
/// # Errors
/// What [`class::sheets`] says.
pub fn sheets() -> Result<Vec<Sheet>, String> {
    let types = || INTEGERS.into_iter().chain(BIT_STRINGS);
    let pairs = types().flat_map(|from| types().map(move |to| (from, to)));
    let calls = pairs.filter(|(from, to)| from != to).flat_map(|(from, to)| {
        let already = for_pair(from, to);
        let powers = powers_of_two(from).into_iter();
        powers
            .filter(move |operand| !already.contains(operand))
            .map(move |operand| Call::convert(from, to, operand))
    });
    let form = Form {
        columns: VALUES,
        open_columns: OPEN_PAIR,
        variable: PAIR_OF_VARIABLE,
        constant: None,
        recorded: false,
    };
    class::sheets(&calls.collect::<Vec<_>>(), &CLASSES, form)
}
