//! The other names of the same rules: truncation in all its spellings, rounding, and the overloaded `TO_<DST>`. The values are
//! few, for the rules are tried elsewhere.

use super::words::{NAMED_VALUES, NAMING, OPEN_NAMED, RANGE};
use crate::call::Call;
use crate::class::{self, Class, Form, Voices};
use crate::inputs::integers::{INTEGERS, ascending, limits};
use crate::inputs::reals::{REALS, by_value};
use crate::operand::Operand;
use crate::program::FUNCTION_OF_VARIABLE;
use crate::sheet::Sheet;
use stickler_exact::signatures;
use stickler_types::{DialectName, ElementaryType, Family};

const FORM: Form = Form {
    columns: NAMED_VALUES,
    open_columns: OPEN_NAMED,
    variable: FUNCTION_OF_VARIABLE,
    constant: None,
    recorded: true,
};

/// The tables of this family. `already` are the calls that other tables make.
///
/// # Errors
/// What [`class::sheets`] says.
pub fn sheets(already: &[Call]) -> Result<Vec<Sheet>, String> {
    let mut sheets = truncation(already)?;
    sheets.extend(rounding()?);
    sheets.extend(overloaded()?);
    Ok(sheets)
}

fn truncation(already: &[Call]) -> Result<Vec<Sheet>, String> {
    let mut calls = Vec::new();
    for (from, to) in REALS.into_iter().flat_map(|from| INTEGERS.map(|to| (from, to))) {
        let (least, greatest) = limits(to);
        let mut numbers = ["-2.5", "-0.5", "0.5", "2.9999", "1.0E20"]
            .map(str::to_owned)
            .to_vec();
        numbers.extend([least - 1, least, greatest, greatest + 1].map(|edge| format!("{edge}.0")));
        for operand in by_value(from, &numbers) {
            for function in [format!("TRUNC_{to}"), format!("{from}_TRUNC_{to}")] {
                calls.push(Call::new(&function, vec![operand.clone()], to));
            }
        }
    }
    calls.retain(|call| !already.contains(call));
    let classes = [
        Class {
            name: "trunc-to-type-more",
            title: "TRUNC_INT, TRUNC_DINT and TRUNC_LINT take either real type",
            summary: "",
            voices: Voices::only_matiec(NAMING),
        },
        Class {
            name: "trunc-to-type-more-outside",
            title: "TRUNC_INT, TRUNC_DINT and TRUNC_LINT of either real type wrap outside the type they name",
            summary: "",
            voices: Voices::only_matiec(RANGE),
        },
        Class {
            name: "trunc-other-names",
            title: "TRUNC_<INTEGER> of the types that no page names, and <REAL>_TRUNC_<INTEGER>",
            summary: "No document says; the value is recorded.",
            voices: Voices::OPEN,
        },
    ];
    class::sheets(&calls, &classes, FORM)
}

fn rounding() -> Result<Vec<Sheet>, String> {
    const NUMBERS: [&str; 15] = [
        "-2.6",
        "-2.5",
        "-1.5",
        "-0.5",
        "-0.4",
        "-0.0",
        "0.4",
        "0.49999997",
        "0.5",
        "1.5",
        "2.5",
        "2.6",
        "8388609.0",
        "1.0E10",
        "1.0E20",
    ];
    let mut calls = Vec::new();
    for function in ["ROUND", "CEIL", "CEILING", "FLOOR"] {
        for (from, to) in REALS
            .into_iter()
            .zip([ElementaryType::Dint, ElementaryType::Lint])
        {
            let operands = by_value(from, &NUMBERS.map(str::to_owned)).into_iter();
            calls.extend(operands.map(|operand| Call::new(function, vec![operand], to)));
        }
    }
    let class = Class {
        name: "rounding-functions",
        title: "ROUND, CEIL, CEILING and FLOOR where a system has them",
        summary: "\
The ForgeIEC page says that the standard has none; see no-round-ceiling-floor. Other documents do not mention them: whether they are
there, how they round and which type they give is recorded.",
        voices: Voices {
            matiec: class::Voice::Lacks,
            ..Voices::OPEN
        },
    };
    class::sheets(&calls, &[class], FORM)
}

fn overloaded() -> Result<Vec<Sheet>, String> {
    let mut calls = Vec::new();
    for to in ElementaryType::ALL {
        let function = format!("TO_{to}");
        for signature in signatures(&function, DialectName::IronplcEd3) {
            let operands = few(signature.operands[0]).into_iter();
            calls.extend(operands.map(|operand| Call::new(&function, vec![operand], to)));
        }
    }
    let classes = [
        Class {
            name: "overloaded",
            title: "TO_<DST> of any type",
            summary: "\
The third edition of the standard has these names; the ForgeIEC page and IronPLC's say that every conversion is <SRC>_TO_<DST>. The value
is recorded.",
            voices: Voices::OPEN,
        },
        Class {
            name: "overloaded-third-edition",
            title: "TO_<DST> of and to the types of the third edition",
            summary: "The value is recorded.",
            voices: Voices::THIRD_EDITION,
        },
    ];
    class::sheets(&calls, &classes, FORM)
}

/// Two or three values of a type that tell one rule from another.
fn few(ty: ElementaryType) -> Vec<Operand> {
    let literals: &[&str] = match ty.family() {
        Family::Signed => return ascending(ty, [-2, limits(ty).1]),
        Family::Unsigned | Family::BitString => return ascending(ty, [2, limits(ty).1]),
        Family::Boolean => &["TRUE"],
        Family::Real => &["-2.5", "3.5"],
        Family::Duration => &["-1.5ms", "1d1ms"],
        Family::Date => &["1969-12-31", "2024-02-29"],
        Family::TimeOfDay => &["12:34:56.789"],
        Family::DateAndTime => &["1969-12-31-23:59:59.5", "2024-02-29-12:34:56"],
        Family::Text if ty == ElementaryType::String => &["'42'", "'abc'"],
        Family::Text => &["\"42\"", "\"abc\""],
        Family::Character if ty == ElementaryType::Char => &["'a'"],
        Family::Character => &["\"$20AC\""],
    };
    literals
        .iter()
        .map(|literal| Operand::read(ty, literal))
        .collect()
}
