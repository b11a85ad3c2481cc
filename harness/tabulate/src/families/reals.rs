//! Real numbers to integers and back, truncation, and REAL and LREAL.

use super::words::{
    ALL, DESIGN, DOCUMENTED, ELSEWHERE, IRONPLC_EXPLICIT, MATIEC, NAMED, NAMING, OPEN_NAMED, OPEN_PAIR, PAIR,
    PLCNEXT, RANGE, TRUNC,
};
use crate::call::Call;
use crate::inputs::integers::{BIT_STRINGS, INTEGERS, ascending, limits};
use crate::inputs::reals::{REALS, far_outside, for_integer, outside};
use crate::operand::Operand;
use crate::program::{FUNCTION_OF_CONSTANT, FUNCTION_OF_VARIABLE, PAIR_OF_CONSTANT, PAIR_OF_VARIABLE};
use crate::sheet::{CallProbe, Sheet};
use stickler_types::{DialectName, ElementaryType};

/// The tables of this family.
pub fn sheets() -> Vec<Sheet> {
    let mut sheets = Vec::from(real_to_integer());
    sheets.extend(truncation());
    sheets.extend(truncation_to_type());
    sheets.extend([lreal_to_real(), integer_to_real(), bit_string_to_real()]);
    sheets
}

fn real_to_integer() -> [Sheet; 2] {
    let mut inside = Vec::new();
    let mut outside = Vec::new();
    for (from, to) in REALS.into_iter().flat_map(|from| INTEGERS.map(|to| (from, to))) {
        let near = for_integer(from, to).into_iter();
        let far = far_outside(from, to).into_iter();
        let call = |operand| Call::convert(from, to, operand);
        let fits = |call: &Call| call.basis(DialectName::IronplcEd2).is_some();
        inside.extend(near.clone().map(call).filter(fits));
        let beyond = near.chain(far).map(call).filter(|call| !fits(call));
        outside.extend(calls_by_value(beyond.collect()));
    }
    [
        Sheet {
            name: "real-to-integer",
            title: "A real converts to an integer by dropping its fraction",
            basis: IRONPLC_EXPLICIT,
            dialects: ALL.to_vec(),
            summary: "\
Both documents say that REAL_TO_INT truncates (ForgeIEC: fractional digits dropped), ties such as 0.5, 1.5 and 2.5 among them. Real
compilers round here, to even or away from zero, which is why these cases exist."
                .to_owned(),
            columns: PAIR,
            calls: inside,
            probes: CallProbe::variable_and_constant(DOCUMENTED, PLCNEXT, PAIR_OF_VARIABLE, PAIR_OF_CONSTANT),
        },
        Sheet {
            name: "real-to-integer-outside",
            title: "A real outside the integer type wraps",
            basis: RANGE,
            dialects: ALL.to_vec(),
            summary: "\
\"Source out of INT range: wraps; fractional digits dropped\": the exact truncated integer modulo 2^n, however large. The other documents
do not say; there the value is recorded."
                .to_owned(),
            columns: PAIR,
            calls: outside,
            probes: CallProbe::variable_and_constant(MATIEC, ELSEWHERE, PAIR_OF_VARIABLE, PAIR_OF_CONSTANT),
        },
    ]
}

/// Calls of one function by the value of their operand, each once.
fn calls_by_value(calls: Vec<Call>) -> Vec<Call> {
    let Some(first) = calls.first().cloned() else {
        return calls;
    };
    let operands = calls.into_iter().flat_map(|call| call.operands).collect();
    let sorted = crate::inputs::reals::sorted(operands).into_iter();
    sorted
        .map(|operand| Call {
            signature: first.signature.clone(),
            operands: vec![operand],
        })
        .collect()
}

/// The calls of truncating functions, those within their target first.
fn truncating(functions: &[(&str, ElementaryType, ElementaryType)]) -> (Vec<Call>, Vec<Call>) {
    let (mut within, mut beyond) = (Vec::new(), Vec::new());
    for &(function, from, to) in functions {
        let near = for_integer(from, to).into_iter();
        let far = outside(from, to).into_iter();
        // Whether TRUNC's own type holds it does not matter here, so another name's claim is asked.
        let fits = |operand: &Operand| {
            let same = Call::convert(from, to, operand.clone());
            same.basis(DialectName::IronplcEd2).is_some()
        };
        let call = |operand| Call::new(function, vec![operand], to);
        within.extend(near.clone().filter(fits).map(call));
        let outside = near.chain(far).filter(|operand| !fits(operand)).map(call);
        beyond.extend(calls_by_value(outside.collect()));
    }
    (within, beyond)
}

fn truncation() -> [Sheet; 2] {
    use ElementaryType::{Dint, Lreal, Real};
    let (inside, outside) = truncating(&[("TRUNC", Real, Dint), ("TRUNC", Lreal, Dint)]);
    [
        Sheet {
            name: "trunc",
            title: "TRUNC truncates a real toward zero to a DINT",
            basis: TRUNC,
            dialects: ALL.to_vec(),
            summary: String::new(),
            columns: NAMED,
            calls: inside,
            probes: CallProbe::variable_and_constant(
                DOCUMENTED,
                PLCNEXT,
                FUNCTION_OF_VARIABLE,
                FUNCTION_OF_CONSTANT,
            ),
        },
        Sheet {
            name: "trunc-outside",
            title: "TRUNC of a real outside DINT",
            basis: DESIGN,
            dialects: ALL.to_vec(),
            summary: "No document says what TRUNC gives here; the value is recorded.".to_owned(),
            columns: OPEN_NAMED,
            calls: outside,
            probes: vec![CallProbe::recorded(&[], FUNCTION_OF_VARIABLE)],
        },
    ]
}

fn truncation_to_type() -> [Sheet; 2] {
    use ElementaryType::{Dint, Int, Lint, Lreal, Real};
    const DIALECTS: &[&str] = &["matiec", "ironplc", "plcnext"];
    let (inside, outside) = truncating(&[
        ("TRUNC_INT", Real, Int),
        ("TRUNC_DINT", Real, Dint),
        ("TRUNC_LINT", Lreal, Lint),
        ("TRUNC_LINT", Real, Lint),
    ]);
    let probes =
        CallProbe::variable_and_constant(MATIEC, ELSEWHERE, FUNCTION_OF_VARIABLE, FUNCTION_OF_CONSTANT);
    [
        Sheet {
            name: "trunc-to-type",
            title: "TRUNC_INT, TRUNC_DINT and TRUNC_LINT truncate toward zero to the type they name",
            basis: NAMING,
            dialects: DIALECTS.to_vec(),
            summary: String::new(),
            columns: NAMED,
            calls: inside,
            probes: probes.clone(),
        },
        Sheet {
            name: "trunc-to-type-outside",
            title: "TRUNC_INT, TRUNC_DINT and TRUNC_LINT wrap outside the type they name",
            basis: RANGE,
            dialects: DIALECTS.to_vec(),
            summary: "The page names REAL_TO_INT \"via TRUNC_INT\": source out of INT range wraps."
                .to_owned(),
            columns: NAMED,
            calls: outside,
            probes,
        },
    ]
}

fn lreal_to_real() -> Sheet {
    // Exact in the format of 64 bits: the tie above 1 with a last bit that rounding twice would lose, the greatest REAL and
    // what lies half above it, the least normal and subnormal ones, and half of these.
    let two = |exponent: i32| 2_f64.powi(exponent);
    let exact = [
        1.0 + two(-24),
        1.0 + 3.0 * two(-24),
        1.0 + two(-24) + two(-52),
        1.0 - two(-25),
        two(127) * (2.0 - two(-23)),
        two(127) * (2.0 - two(-24)) - two(80),
        two(-126),
        two(-149),
        two(-150) + two(-190),
        two(-126) - two(-150),
    ];
    let decimal = |literals: &[&str]| -> Vec<Operand> {
        let read = |literal: &&str| Operand::read(ElementaryType::Lreal, literal);
        literals.iter().map(read).collect()
    };
    let mut operands = decimal(&[
        "0.0",
        "1.0",
        "-1.0",
        "0.333333333333333333333333",
        "0.1",
        "3.14159265358979",
        "123456789.123",
        "0.30000000000000004",
        "16777216.0",
        "16777217.0",
        "16777218.0",
        "16777219.0",
        "-16777217.0",
    ]);
    let of_bits = |number: f64| {
        Operand::of(stickler_types::Value::plain(
            ElementaryType::Lreal,
            number.to_bits(),
        ))
    };
    operands.extend(exact.map(of_bits));
    operands.extend(decimal(&["1.0E30", "1.0E-30", "16777217.5", "1.0E-45", "-0.0"]));
    Sheet {
        name: "lreal-to-real",
        title: "LREAL converts to REAL rounded to nearest, ties to even, once",
        basis: RANGE,
        dialects: ALL.to_vec(),
        summary: "\
\"Source has more than ~7 significant digits: rounded.\" Ties such as 2^24+1 and 1+2^-24, their neighbours, the largest finite REAL, the
smallest normal and the subnormal numbers."
            .to_owned(),
        columns: PAIR,
        calls: operands
            .into_iter()
            .map(|operand| Call::convert(ElementaryType::Lreal, ElementaryType::Real, operand))
            .collect(),
        probes: CallProbe::variable_and_constant(ALL, &[], PAIR_OF_VARIABLE, PAIR_OF_CONSTANT),
    }
}

fn integer_to_real() -> Sheet {
    let mut calls = Vec::new();
    for (from, to) in INTEGERS.into_iter().flat_map(|from| REALS.map(|to| (from, to))) {
        let (least, greatest) = limits(from);
        let mut numbers = vec![least, least + 1, -1, 0, 1, greatest - 1, greatest, 123_456_789];
        for power in [1 << 24, 1 << 53] {
            numbers.extend((-1..=3).flat_map(|beside| [power + beside, -power - beside]));
        }
        // 2^62+2^38 is half way between two REALs; one more is not, but becomes so by way of LREAL.
        let (half, unit) = (1 << 38, 1_i128 << 62);
        numbers.extend([unit + half, unit + half + 1, unit + 3 * half, unit + 3 * half - 1]);
        numbers.push((1 << 63) + (1 << 39) + 1);
        calls.extend(
            ascending(from, numbers)
                .into_iter()
                .map(|operand| Call::convert(from, to, operand)),
        );
    }
    Sheet {
        name: "integer-to-real",
        title: "An integer converts to a real rounded to nearest, ties to even, once",
        basis: DESIGN,
        dialects: ALL.to_vec(),
        summary: "\
The page lists <num>_TO_REAL; IEC 60559 says how it rounds. 2^62+2^38+1 is one where rounding twice, by way of LREAL, gives
a different REAL."
            .to_owned(),
        columns: PAIR,
        calls,
        probes: CallProbe::variable_and_constant(ALL, &[], PAIR_OF_VARIABLE, PAIR_OF_CONSTANT),
    }
}

fn bit_string_to_real() -> Sheet {
    let mut calls = Vec::new();
    for (from, to) in BIT_STRINGS
        .into_iter()
        .flat_map(|from| REALS.map(|to| (from, to)))
    {
        let greatest = limits(from).1;
        let operands = ascending(from, [0, 1, greatest, greatest / 2 + 1]).into_iter();
        calls.extend(operands.map(|operand| Call::convert(from, to, operand)));
    }
    Sheet {
        name: "bit-string-to-real",
        title: "A bit string converts to a real: a number, or a copy of the bits",
        basis: DESIGN,
        dialects: ALL.to_vec(),
        summary: "No document says which; the value is recorded.".to_owned(),
        columns: OPEN_PAIR,
        calls,
        probes: vec![CallProbe::recorded(&[], PAIR_OF_VARIABLE)],
    }
}
