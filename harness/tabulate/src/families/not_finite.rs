//! NaN and the infinities, which no literal can write: the program makes them from variables at run time. So it does -0.0, for
//! there are compilers that read its literal as 0.0.

use super::words::{DESIGN, IRONPLC_EXPLICIT, NAMING, RANGE};
use crate::call::Call;
use crate::class::{self, Class, Form, Voices};
use crate::column::Column;
use crate::inputs::integers::{BIT_STRINGS, INTEGERS};
use crate::inputs::reals::REALS;
use crate::operand::Operand;
use crate::sheet::Sheet;
use stickler_types::ElementaryType;
use stickler_types::ElementaryType::{Bool, Date, Dint, Dt, Lreal, Real, String as Text, Time, Tod};

/// Multiplication goes beyond the greatest number, and the difference of two infinities is no number.
const PROGRAM: &str = "\
PROGRAM main
VAR
    huge : {from} := {huge};
    data : {from};
    into : {to};
END_VAR
    data := {made};
    into := {function}(data);
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
        summary: "Bit strings, dates and the truncating functions that no page names; the value is recorded.",
        voices: Voices::OPEN,
    },
    Class {
        name: "not-finite-never-faults",
        title: "NaN as a BOOL, and what is not finite as TIME, as a text or by TRUNC, never stop the program",
        summary: "What they give no document says; the value is recorded.",
        voices: Voices::NAMED,
    },
];

/// The tables of -0.0.
const OF_ZERO: [Class; 7] = [
    Class {
        name: "negative-zero-to-integer",
        title: "-0.0 converts to the integer 0",
        summary: "",
        voices: Voices::both(RANGE, IRONPLC_EXPLICIT),
    },
    Class {
        name: "negative-zero-lreal-to-real",
        title: "-0.0 of LREAL stays -0.0 as a REAL",
        summary: "",
        voices: Voices::all(RANGE),
    },
    Class {
        name: "negative-zero-real-to-lreal",
        title: "-0.0 of REAL stays -0.0 as an LREAL",
        summary: "",
        voices: Voices::all(DESIGN),
    },
    Class {
        name: "negative-zero-to-bool",
        title: "-0.0 converts to FALSE",
        summary: "",
        voices: Voices::both(NAMING, NAMING),
    },
    Class {
        name: "negative-zero-to-time",
        title: "-0.0 converts to a TIME of 0",
        summary: "",
        voices: Voices::all(NAMING),
    },
    Class {
        name: "negative-zero-never-faults",
        title: "-0.0 as a text gives something and never stops the program",
        summary: "Whether it has a sign no document says; the value is recorded.",
        voices: Voices::NAMED,
    },
    Class {
        name: "negative-zero-open",
        title: "-0.0 as a bit string, a date or a time of day",
        summary: "No document says; the value is recorded.",
        voices: Voices::OPEN,
    },
];

/// The tables of this family.
///
/// # Errors
/// What [`class::sheets`] says.
pub fn sheets() -> Result<Vec<Sheet>, String> {
    let mut pairs: Vec<(String, ElementaryType, ElementaryType)> = Vec::new();
    let mut truncating = Vec::new();
    for from in REALS {
        let other = if from == Real { Lreal } else { Real };
        let targets = INTEGERS.into_iter().chain(BIT_STRINGS);
        let targets = targets.chain([Bool, other, Time, Date, Tod, Dt, Text]);
        pairs.extend(targets.map(|to| (format!("{from}_TO_{to}"), from, to)));
        truncating.push(("TRUNC".to_owned(), from, Dint));
        truncating.extend(INTEGERS.map(|to| (format!("TRUNC_{to}"), from, to)));
        truncating.extend(INTEGERS.map(|to| (format!("{from}_TRUNC_{to}"), from, to)));
    }
    let zero = calls(&pairs, &["-0.0"]);
    let functions = [pairs, truncating].concat();
    let mut sheets = class::sheets(
        &calls(&functions, &["NaN", "Infinity", "-Infinity"]),
        &CLASSES,
        FORM,
    )?;
    sheets.extend(class::sheets(&zero, &OF_ZERO, FORM)?);
    Ok(sheets)
}

/// A call of each function with each of these words of its operand's type.
fn calls(functions: &[(String, ElementaryType, ElementaryType)], words: &[&str]) -> Vec<Call> {
    let calls = functions.iter().flat_map(|(function, from, to)| {
        let operands = words.iter().map(|word| Operand::read(*from, word));
        operands.map(|operand| Call::new(function, vec![operand], *to))
    });
    calls.collect()
}
