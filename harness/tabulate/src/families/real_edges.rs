//! Real numbers at the edges that [`super::reals`] leaves out: beside ties, at the ends of the format, each power of two.

use super::words::{DESIGN, IRONPLC_EXPLICIT, NAMING, OPEN_PAIR, PAIR, RANGE, VALUES};
use crate::call::Call;
use crate::class::{self, Class, Form, Voices};
use crate::inputs::edges::{self, both_signs, of_format, of_precision};
use crate::inputs::integers::{BIT_STRINGS, INTEGERS, ascending, powers_of_two};
use crate::inputs::reals::{REALS, by_value, far_outside, for_integer, sorted};
use crate::operand::Operand;
use crate::program::{PAIR_OF_CONSTANT, PAIR_OF_VARIABLE};
use crate::sheet::Sheet;
use stickler_types::ElementaryType;
use stickler_types::ElementaryType::{Bool, Lreal, Real};

/// Literals of numbers that no binary format holds exactly, and of everyday ones.
const EVERYDAY: [&str; 12] = [
    "0.1",
    "-0.1",
    "0.2",
    "0.3",
    "1.0",
    "-1.0",
    "1.1",
    "3.1415927",
    "100.0",
    "99.99",
    "1.0E10",
    "1.0E-10",
];

/// The form of most tables of this family.
const FORM: Form = Form {
    columns: PAIR,
    open_columns: OPEN_PAIR,
    variable: PAIR_OF_VARIABLE,
    constant: Some(PAIR_OF_CONSTANT),
    recorded: true,
};

/// The form where a table has many rows, and folding is tried elsewhere.
const VARIABLES: Form = Form {
    columns: VALUES,
    constant: None,
    ..FORM
};

/// The tables of this family. `already` are the calls that other tables make.
///
/// # Errors
/// What [`class::sheets`] says.
pub fn sheets(already: &[Call]) -> Result<Vec<Sheet>, String> {
    let mut sheets = real_to_integer()?;
    sheets.extend(real_to_bit_string()?);
    sheets.extend(between_reals(already)?);
    sheets.extend(integer_to_real(already)?);
    sheets.extend(number_to_bool(already)?);
    Ok(sheets)
}

fn real_to_integer() -> Result<Vec<Sheet>, String> {
    let mut calls = Vec::new();
    for (from, to) in REALS.into_iter().flat_map(|from| INTEGERS.map(|to| (from, to))) {
        let mut before = for_integer(from, to);
        before.extend(far_outside(from, to));
        let new = edges::for_integer(from, to).into_iter();
        let new = new.filter(|operand| !before.contains(operand));
        calls.extend(new.map(|operand| Call::convert(from, to, operand)));
    }
    let classes = [
        Class {
            name: "real-to-integer-edges",
            title: "A real next to a tie or a limit drops its fraction like any other",
            summary: "\
The greatest number below 0.5 is no tie: who adds one half and truncates makes 1 of it. Subnormal numbers and -0.0 are 0.",
            voices: Voices::both(RANGE, IRONPLC_EXPLICIT),
        },
        Class {
            name: "real-to-integer-edges-outside",
            title: "A real just outside the integer type, or far outside, wraps",
            summary: "The exact truncated integer modulo 2^n: 0 for what is a multiple of 2^n, such as the greatest finite numbers.",
            voices: Voices::only_matiec(RANGE),
        },
    ];
    class::sheets(&calls, &classes, FORM)
}

fn real_to_bit_string() -> Result<Vec<Sheet>, String> {
    const LITERALS: [&str; 14] = [
        "0.0",
        "-0.0",
        "1.0",
        "1.5",
        "2.5",
        "-0.5",
        "-1.0",
        "255.0",
        "256.0",
        "65536.0",
        "4294967296.0",
        "1.8446744073709552E19",
        "1.0E20",
        "1.0E-45",
    ];
    let mut calls = Vec::new();
    for (from, to) in REALS
        .into_iter()
        .flat_map(|from| BIT_STRINGS.map(|to| (from, to)))
    {
        let operands = by_value(from, &LITERALS.map(str::to_owned)).into_iter();
        calls.extend(operands.map(|operand| Call::convert(from, to, operand)));
    }
    let class = Class {
        name: "real-to-bit-string",
        title: "A real converts to a bit string: a number, or a copy of the bits",
        summary: "No document says which, nor how the number is rounded; the value is recorded.",
        voices: Voices::OPEN,
    };
    class::sheets(&calls, &[class], VARIABLES)
}

fn between_reals(already: &[Call]) -> Result<Vec<Sheet>, String> {
    let operands = |ty: ElementaryType| {
        let mut operands = of_format(ty);
        operands.extend(of_precision(ty));
        operands.extend(by_value(ty, &EVERYDAY.map(str::to_owned)));
        operands
    };
    let widened = sorted(operands(Real)).into_iter();
    let mut calls: Vec<Call> = widened
        .map(|operand| Call::convert(Real, Lreal, operand))
        .collect();
    let mut narrowed = operands(Lreal);
    // Each power of two from below the least REAL to above the greatest, and among the subnormal numbers of REAL one and a
    // half of it, which is a tie below 2^-149.
    for exponent in -152..=129 {
        let power = 2_f64.powi(exponent);
        narrowed.push(real_of_64_bits(power));
        if exponent < -120 {
            narrowed.push(real_of_64_bits(1.5 * power));
        }
    }
    // Half way between the greatest REAL and 2^128, and next to it.
    let half_way = real_of_64_bits(2_f64.powi(128) - 2_f64.powi(103));
    narrowed.extend([
        edges::beside(&half_way, -1),
        half_way.clone(),
        edges::beside(&half_way, 1),
    ]);
    narrowed.extend(both_signs(&half_way));
    let narrowed = sorted(narrowed).into_iter();
    let narrowed = narrowed.map(|operand| Call::convert(Lreal, Real, operand));
    calls.extend(narrowed.filter(|call| !already.contains(call)));
    let classes = [
        Class {
            name: "real-to-lreal",
            title: "Every REAL converts to the LREAL of the same value",
            summary: "Subnormal numbers and both zeros among them.",
            voices: Voices::all(DESIGN),
        },
        Class {
            name: "lreal-to-real-powers-of-two",
            title: "LREAL converts to REAL at each power of two, also where REAL has no more normal numbers",
            summary: "\
2^k, and below 2^-120 also 1.5 * 2^k. Below 2^-126 REAL loses a digit at each step, so that 1.5 * 2^-149 is a tie; from 2^128 - 2^103 on the result is infinite.",
            voices: Voices::all(RANGE),
        },
    ];
    class::sheets(&calls, &classes, VARIABLES)
}

/// An LREAL of a number that the arithmetic of `f64` gives exactly.
fn real_of_64_bits(number: f64) -> Operand {
    Operand::of(stickler_types::Value::plain(Lreal, number.to_bits()))
}

fn integer_to_real(already: &[Call]) -> Result<Vec<Sheet>, String> {
    let mut calls = Vec::new();
    for (from, to) in INTEGERS.into_iter().flat_map(|from| REALS.map(|to| (from, to))) {
        // Beside a power of two lies a number that the format does not hold, if it is great enough.
        let exact = 1_i128 << if to == Real { 24 } else { 53 };
        let powers = powers_of_two(from).into_iter();
        let powers = powers.map(|operand| from.integer_value(operand.raw()));
        let numbers = powers.flat_map(|power| {
            let reach = if power.abs() > exact { 1 } else { 0 };
            power - reach..=power + reach
        });
        let operands = ascending(from, numbers).into_iter();
        let new = operands.map(|operand| Call::convert(from, to, operand));
        calls.extend(new.filter(|call| !already.contains(call)));
    }
    let class = Class {
        name: "integer-to-real-powers-of-two",
        title: "Each power of two converts to a real exactly, and what lies beside it is rounded once",
        summary: "",
        voices: Voices::all(DESIGN),
    };
    class::sheets(&calls, &[class], VARIABLES)
}

fn number_to_bool(already: &[Call]) -> Result<Vec<Sheet>, String> {
    let types = INTEGERS.into_iter().chain(BIT_STRINGS);
    let whole = types.flat_map(|from| {
        let powers = powers_of_two(from).into_iter();
        powers.map(move |operand| Call::convert(from, Bool, operand))
    });
    let real = REALS.into_iter().flat_map(|from| {
        let ends = sorted(of_format(from)).into_iter();
        ends.map(move |operand| Call::convert(from, Bool, operand))
    });
    let calls = whole.chain(real).filter(|call| !already.contains(call));
    let class = Class {
        name: "number-to-bool-powers-of-two",
        title: "Each single bit makes TRUE, and so does the least subnormal number",
        summary: "Who looks at the lowest byte only, or takes what is subnormal for 0, is found here.",
        voices: Voices::both(NAMING, NAMING),
    };
    let form = Form {
        recorded: false,
        ..VARIABLES
    };
    class::sheets(&calls.collect::<Vec<_>>(), &[class], form)
}
