//! Conversions of constants: a compiler that folds them must give what the running program gives.

use super::words::{
    BCD, CONFORMANCE, DESIGN, IRONPLC_EXPLICIT, IRONPLC_NARROWING, NAMED_VALUES, NAMING, OPEN_NAMED, RANGE,
    TRUNC,
};
use crate::call::{Call, is_chosen};
use crate::class::{self, Class, Form, Voices};
use crate::operand::Operand;
use crate::sheet::{CallProbe, Sheet, owned};
use crate::table::{Probe, Table};
use std::collections::HashSet;
use stickler_types::DialectName;
use stickler_types::ElementaryType::{self, Byte, Dint, Int, Lint, Real, Sint, String as Text, Time, Word};

const NAMED_CONSTANT: &str = "\
PROGRAM main
VAR CONSTANT
    given : {from} := {input};
END_VAR
VAR
    into : {to};
END_VAR
    into := {function}(given);
END_PROGRAM
";

const INITIAL_VALUE: &str = "\
PROGRAM main
VAR CONSTANT
    given : {from} := {input};
END_VAR
VAR
    into : {to} := {function}(given);
    done : BOOL;
END_VAR
    done := TRUE;
END_PROGRAM
";

const DIALECTS: [&str; 3] = ["ironplc-ed3", "matiec", "plcnext"];

/// The tables of this family: some of the calls that other tables make with variables, now with constants.
///
/// # Errors
/// What [`class::sheets`] says.
pub fn sheets(already: &[Call]) -> Result<Vec<Sheet>, String> {
    let mut calls: Vec<Call> = Vec::new();
    let mut seen = HashSet::new();
    for call in already {
        let text = call.to_string();
        let is_asserted = is_written(call) && call.basis(DialectName::Matiec).is_some();
        if is_asserted && is_chosen(&text, 7) && seen.insert(text) {
            calls.push(call.clone());
        }
    }
    let voices = |name, title, voices| Class {
        name,
        title,
        summary: "The argument is a VAR CONSTANT, whose value a compiler knows.",
        voices,
    };
    let classes = [
        voices(
            "constant-wraps",
            "A named constant wraps like a variable",
            Voices::both(RANGE, IRONPLC_NARROWING),
        ),
        voices(
            "constant-kept",
            "A named constant that fits is kept",
            Voices::both(RANGE, IRONPLC_EXPLICIT),
        ),
        voices(
            "constant-sign",
            "A named constant changes its sign like a variable",
            Voices::both(RANGE, DESIGN),
        ),
        voices(
            "constant-bits-wrap",
            "A named bit string wraps like a variable",
            Voices::both(NAMING, IRONPLC_NARROWING),
        ),
        voices(
            "constant-bits-kept",
            "A named bit string that fits is kept",
            Voices::both(NAMING, IRONPLC_EXPLICIT),
        ),
        voices(
            "constant-bits-sign",
            "A named bit string changes its sign like a variable",
            Voices::both(NAMING, DESIGN),
        ),
        voices(
            "constant-between-bits",
            "A named bit string converts to a bit string like a variable",
            Voices::both(DESIGN, DESIGN),
        ),
        voices(
            "constant-bool",
            "A named constant converts to and from BOOL like a variable",
            Voices::both(NAMING, NAMING),
        ),
        voices(
            "constant-to-real",
            "A named integer converts to a real like a variable",
            Voices::all(DESIGN),
        ),
        voices(
            "constant-lreal",
            "A named LREAL converts to REAL like a variable",
            Voices::all(RANGE),
        ),
        voices(
            "constant-time",
            "A named number and a named TIME convert like variables",
            Voices::all(NAMING),
        ),
        voices(
            "constant-trunc",
            "TRUNC of a named constant truncates like of a variable",
            Voices::both(TRUNC, TRUNC),
        ),
        voices(
            "constant-outside",
            "A named real outside the integer type wraps like a variable",
            Voices::only_matiec(RANGE),
        ),
        voices(
            "constant-listed",
            "A named constant converts like a variable by the page's other functions",
            Voices::only_matiec(NAMING),
        ),
        voices(
            "constant-no-number",
            "A named text that is no number is 0 like a variable",
            Voices::only_matiec(CONFORMANCE),
        ),
        voices(
            "constant-bcd",
            "A named constant converts to and from BCD like a variable",
            Voices::only_matiec(BCD),
        ),
    ];
    let form = Form {
        columns: NAMED_VALUES,
        open_columns: OPEN_NAMED,
        variable: NAMED_CONSTANT,
        constant: None,
        recorded: false,
    };
    let mut sheets = class::sheets(&calls, &classes, form)?;
    for probe in sheets.iter_mut().flat_map(|sheet| &mut sheet.probes) {
        probe.name = if probe.name == "variable" {
            "named-constant"
        } else {
            "named-constant-by-ironplc"
        };
    }
    calls.retain(|call| is_chosen(&format!("initially {call}"), 5));
    sheets.push(initial_values(calls));
    Ok(sheets)
}

/// Whether there is a literal for the operand: there is none for NaN and the infinities.
fn is_written(call: &Call) -> bool {
    let literal = &call.operands[0].literal;
    !["NaN", "Infinity", "-Infinity"].contains(&literal.as_str())
}

fn initial_values(calls: Vec<Call>) -> Sheet {
    Sheet {
        name: "constant-initial-value",
        title: "A conversion of a named constant as an initial value",
        basis: DESIGN,
        dialects: DIALECTS.to_vec(),
        summary:
            "No document says whether an initial value may be a call; acceptance and value are recorded."
                .to_owned(),
        columns: OPEN_NAMED,
        calls,
        probes: vec![CallProbe::recorded(&[], INITIAL_VALUE).also_where_said()],
    }
}

/// Conversions where the language needs a constant: all of them are 5.
///
/// # Errors
/// A sentence, where one of them is not.
pub fn tables() -> Result<Vec<Table>, String> {
    let calls: [(&str, ElementaryType, &str, ElementaryType); 13] = [
        ("SINT_TO_INT", Sint, "5", Int),
        ("DINT_TO_INT", Dint, "5", Int),
        ("DINT_TO_INT", Dint, "65541", Int),
        ("LINT_TO_INT", Lint, "-65531", Int),
        ("BYTE_TO_INT", Byte, "16#05", Int),
        ("WORD_TO_DINT", Word, "16#0005", Dint),
        ("REAL_TO_INT", Real, "5.0", Int),
        ("REAL_TO_INT", Real, "5.25", Int),
        ("TRUNC", Real, "5.75", Dint),
        ("TRUNC_INT", Real, "5.75", Int),
        ("TIME_TO_DINT", Time, "5ms", Dint),
        ("BCD_TO_INT", Word, "16#0005", Int),
        ("STRING_TO_INT", Text, "'5'", Int),
    ];
    let mut rows = Vec::new();
    for (function, from, literal, to) in calls {
        let call = Call::new(function, vec![Operand::read(from, literal)], to);
        let five = format!("{to}#5");
        let given = call
            .expected(DialectName::Matiec)
            .map(|expected| expected.value.to_string());
        if given.as_deref() != Some(&five) {
            return Err(format!("{call} is not 5 but {given:?}"));
        }
        rows.push(vec![call.to_string()]);
    }
    Ok(vec![Table {
        name: "constant-expressions".to_owned(),
        title: "A conversion where the language wants a constant: every call here is 5".to_owned(),
        basis: DESIGN.to_owned(),
        dialects: owned(&DIALECTS),
        summary: "\
No document says whether a call may stand as an array bound, a CASE label, a limit of a subrange or the length of a string; acceptance and
value are recorded. `into` is 1 where the constant is taken for 5."
            .to_owned(),
        columns: owned(&["call"]),
        rows,
        probes: [ARRAY_BOUND, CASE_LABEL, SUBRANGE, STRING_LENGTH].map(place).into(),
    }])
}

fn place((name, source): (&str, &str)) -> Probe {
    Probe {
        name: name.to_owned(),
        observe: "into : INT".to_owned(),
        expect: "open".to_owned(),
        source: source.to_owned(),
        ..Probe::default()
    }
}

const ARRAY_BOUND: (&str, &str) = (
    "array-bound",
    "\
PROGRAM main
VAR
    list : ARRAY[0..{call}] OF INT;
    into : INT;
END_VAR
    list[5] := 1;
    into := list[5];
END_PROGRAM
",
);

const CASE_LABEL: (&str, &str) = (
    "case-label",
    "\
PROGRAM main
VAR
    five : DINT := 5;
    into : INT;
END_VAR
    CASE five OF
        {call}: into := 1;
    ELSE
        into := 2;
    END_CASE;
END_PROGRAM
",
);

const SUBRANGE: (&str, &str) = (
    "subrange",
    "\
PROGRAM main
VAR
    few  : INT(0..{call}) := 5;
    into : INT;
END_VAR
    IF few = 5 THEN
        into := 1;
    END_IF;
END_PROGRAM
",
);

const STRING_LENGTH: (&str, &str) = (
    "string-length",
    "\
PROGRAM main
VAR
    word : STRING[{call}] := 'abcde';
    into : INT;
END_VAR
    IF word = 'abcde' THEN
        into := 1;
    END_IF;
END_PROGRAM
",
);
