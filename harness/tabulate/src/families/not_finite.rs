//! NaN and the infinities, which no literal can write: the program makes them from variables at run time.

use super::words::{DESIGN, NAMING, RANGE};
use crate::call::Call;
use crate::class::{self, Class, Form, Voices};
use crate::inputs::integers::{BIT_STRINGS, INTEGERS};
use crate::inputs::reals::REALS;
use crate::operand::Operand;
use crate::sheet::{Column, Sheet};
use stickler_types::ElementaryType;
use stickler_types::ElementaryType::{Bool, Dint, Lreal, Real};

/// Multiplication goes beyond the greatest number, and the difference of two infinities is no number.
const PROGRAM: &str = "\
PROGRAM main
VAR
    huge : {from} := {huge};
    from : {from};
    into : {to};
END_VAR
    from := {made};
    into := {function}(from);
END_PROGRAM
";

const FORM: Form = Form {
    columns: &[
        Column::Id,
        Column::Function,
        Column::From,
        Column::To,
        Column::Huge,
        Column::Made,
        Column::Expected,
    ],
    open_columns: &[
        Column::Id,
        Column::Function,
        Column::From,
        Column::To,
        Column::Huge,
        Column::Made,
    ],
    variable: PROGRAM,
    constant: None,
    recorded: true,
};

const CLASSES: [Class; 6] = [
    Class {
        name: "not-finite-to-integer",
        title: "NaN and the infinities convert to the integer 0",
        summary: "",
        voices: Voices::only_matiec(DESIGN),
    },
    Class {
        name: "not-finite-lreal-to-real",
        title: "NaN and the infinities of LREAL stay what they are as a REAL",
        summary: "",
        voices: Voices::all(RANGE),
    },
    Class {
        name: "not-finite-real-to-lreal",
        title: "NaN and the infinities of REAL stay what they are as an LREAL",
        summary: "",
        voices: Voices::all(DESIGN),
    },
    Class {
        name: "infinity-to-bool",
        title: "The infinities convert to TRUE",
        summary: "",
        voices: Voices::both(NAMING, NAMING),
    },
    Class {
        name: "not-finite-open",
        title: "NaN and the infinities, converted where no document says to what",
        summary: "Bit strings and the truncating functions that no page names; the value is recorded.",
        voices: Voices::OPEN,
    },
    Class {
        name: "not-finite-never-faults",
        title: "NaN as a BOOL, and TRUNC of what is not finite, give something and never stop the program",
        summary: "What they give no document says; the value is recorded.",
        voices: Voices::NAMED,
    },
];

/// The tables of this family.
///
/// # Errors
/// What [`class::sheets`] says.
pub fn sheets() -> Result<Vec<Sheet>, String> {
    let mut functions: Vec<(String, ElementaryType, ElementaryType)> = Vec::new();
    for from in REALS {
        let other = if from == Real { Lreal } else { Real };
        let targets = INTEGERS.into_iter().chain(BIT_STRINGS).chain([Bool, other]);
        functions.extend(targets.map(|to| (format!("{from}_TO_{to}"), from, to)));
        functions.push(("TRUNC".to_owned(), from, Dint));
        functions.extend(INTEGERS.map(|to| (format!("TRUNC_{to}"), from, to)));
        functions.extend(INTEGERS.map(|to| (format!("{from}_TRUNC_{to}"), from, to)));
    }
    let calls = functions.iter().flat_map(|(function, from, to)| {
        ["NaN", "Infinity", "-Infinity"]
            .map(|word| Call::new(function, vec![Operand::read(*from, word)], *to))
    });
    class::sheets(&calls.collect::<Vec<_>>(), &CLASSES, FORM)
}
