//! The ForgeIEC page's rounding, ceiling and floor by hand, its range check, and the functions that it says do not exist.
//!
//! The idioms add two REALs before they convert. A REAL is what Rust calls `f32`, and adds by IEC 60559 as `f32` does: the sum
//! is rounded once, to nearest, ties to even. What becomes of the sum is asked of the exact arithmetic.

use super::words::{RANGE, TRUNC};
use crate::call::Call;
use crate::operand::Operand;
use crate::sheet::owned;
use crate::table::{Probe, Table};
use stickler_types::{DialectName, ElementaryType, Value};

/// The tables of this family.
pub fn tables() -> Vec<Table> {
    vec![
        round(),
        round_under_rounding(),
        ceiling(),
        ceiling_repaired(),
        floor_repaired(),
        floor_under_rounding(),
        range_check(),
        no_rounding_functions(),
    ]
}

const DOCUMENTED: [&str; 2] = ["matiec", "ironplc"];

/// A table of an input and what a variable must then hold.
fn idiom(
    name: &str,
    title: &str,
    dialects: &[&str],
    summary: &str,
    rows: Vec<Vec<String>>,
    probes: Vec<Probe>,
) -> Table {
    Table {
        name: name.to_owned(),
        title: title.to_owned(),
        basis: TRUNC.to_owned(),
        dialects: owned(dialects),
        summary: summary.to_owned(),
        columns: owned(&["input", "expected"]),
        rows,
        probes,
    }
}

fn asserted(name: &str, observe: &str, source: String) -> Probe {
    Probe {
        name: name.to_owned(),
        observe: observe.to_owned(),
        expect: "{expected}".to_owned(),
        source,
        ..Probe::default()
    }
}

/// A row for each literal: the literal, and what `function` makes of `prepare` of its REAL.
fn rows(literals: &[&str], function: &str, prepare: impl Fn(f32) -> f32) -> Vec<Vec<String>> {
    let real = ElementaryType::Real;
    let row = |literal: &&str| {
        // The raw form of a REAL has 32 bits.
        let input = f32::from_bits(Operand::read(real, literal).raw() as u32);
        let prepared = Operand::of(Value::plain(real, prepare(input).to_bits().into()));
        let call = Call::new(function, vec![prepared], ElementaryType::Dint);
        vec![(*literal).to_owned(), result(&call)]
    };
    literals.iter().map(row).collect()
}

/// What a call gives where the dialect truncates; ROUND and its kin are asked for by name, as IronPLC's catalogue has them.
fn result(call: &Call) -> String {
    let said = call.expected(DialectName::IronplcEd3);
    said.map_or_else(String::new, |said| said.value.to_string())
}

const TO_BE_ROUNDED: &[&str] = &[
    "0.0", "0.4", "0.5", "0.6", "1.4", "1.5", "2.4", "2.5", "2.6", "3.5", "-0.4", "-0.5", "-0.6", "-1.5",
    "-2.4", "-2.5", "-2.6", "1000.25", "-1000.75",
];

/// `rValue + SEL(rValue < 0.0, 0.5, -0.5)`.
fn half_added(value: f32) -> f32 {
    value + if value < 0.0 { -0.5 } else { 0.5 }
}

const AS_PRINTED: &str = "\
PROGRAM main
VAR
    rValue   : REAL := {input};
    iRounded : DINT;
END_VAR
    iRounded := REAL_TO_DINT(rValue + SEL(rValue < 0.0, 0.5, -0.5));
END_PROGRAM
";

fn round() -> Table {
    let as_printed = Probe {
        dialects: owned(&DOCUMENTED),
        ..asserted("as-printed", "iRounded", AS_PRINTED.to_owned())
    };
    let recorded = Probe {
        expect: "open".to_owned(),
        dialects: owned(&["plcnext"]),
        ..asserted("recorded", "iRounded : DINT", AS_PRINTED.to_owned())
    };
    idiom(
        "idiom-round",
        "Rounding by hand, as printed, under truncation",
        &["matiec", "ironplc", "plcnext"],
        "\
The page's idiom is right only where REAL_TO_DINT truncates, as the page says it does: then it rounds half away from zero. The literals
0.5 and -0.5 take the type of rValue. On a system whose REAL_TO_DINT rounds, the same line adds one half too much: see
idiom-round-under-rounding.",
        rows(TO_BE_ROUNDED, "REAL_TO_DINT", half_added),
        vec![as_printed, recorded],
    )
}

/// A function in ST that rounds half to even, so that every engine runs the idiom under rounding.
fn rounding_conversion(comment: &str) -> String {
    format!(
        "\
FUNCTION Rounding_Conversion : DINT
VAR_INPUT
    in : REAL;
END_VAR
VAR
    rest : REAL;
END_VAR
{comment}    Rounding_Conversion := TRUNC(in);
    rest := in - DINT_TO_REAL(Rounding_Conversion);
    IF rest > 0.5 OR (rest = 0.5 AND Rounding_Conversion MOD 2 <> 0) THEN
        Rounding_Conversion := Rounding_Conversion + 1;
    ELSIF rest < -0.5 OR (rest = -0.5 AND Rounding_Conversion MOD 2 <> 0) THEN
        Rounding_Conversion := Rounding_Conversion - 1;
    END_IF;
END_FUNCTION
"
    )
}

fn round_under_rounding() -> Table {
    let comment = "    (* REAL to DINT as IEC 60559 rounds it: to nearest, ties to even. *)\n";
    let source = rounding_conversion(comment)
        + "\
PROGRAM main
VAR
    rValue   : REAL := {input};
    iRounded : DINT;
END_VAR
    iRounded := Rounding_Conversion(rValue + SEL(rValue < 0.0, 0.5, -0.5));
END_PROGRAM
";
    idiom(
        "idiom-round-under-rounding",
        "Rounding by hand gives other answers where the conversion itself rounds",
        &DOCUMENTED,
        "\
The same idiom with a conversion that rounds half to even, spelt out in ST so that every engine runs it: 0.6 becomes 1, but so would 1.4
become 2, and 0.5 becomes 1 where 2.4 becomes 3. Whoever moves the idiom to a rounding system gets these numbers.",
        rows(TO_BE_ROUNDED, "ROUND", half_added),
        vec![asserted("half-to-even", "iRounded", source)],
    )
}

const TO_BE_RAISED: &[&str] = &[
    "0.0",
    "0.1",
    "0.5",
    "1.0",
    "1.000001",
    "1.5",
    "2.0",
    "2.1",
    "99.0",
    "100.0",
    "1000.0",
    "16777215.0",
    "-0.5",
    "-1.0",
    "-1.5",
    "-2.5",
    "-0.000001",
];

fn ceiling() -> Table {
    let source = "\
PROGRAM main
VAR
    rValue   : REAL := {input};
    iCeiling : DINT;
END_VAR
    iCeiling := TRUNC_DINT(rValue + 0.999999);
END_PROGRAM
";
    idiom(
        "idiom-ceiling",
        "CEILING by hand, as printed, computes this",
        &["matiec"],
        "\
What the printed line gives in 32-bit arithmetic, which is not always the ceiling: -1.5 + 0.999999 is -0.500001 and truncates to 0 where the
ceiling is -1, and from about 32 on 0.999999 can round up to a whole number, so that 100.0 becomes 101. See idiom-ceiling-repaired.",
        rows(TO_BE_RAISED, "TRUNC_DINT", |value| value + 0.999_999),
        vec![asserted("as-printed", "iCeiling", source.to_owned())],
    )
}

fn ceiling_repaired() -> Table {
    let source = "\
PROGRAM main
VAR
    rValue   : REAL := {input};
    iCeiling : DINT;
END_VAR
    iCeiling := TRUNC(rValue);
    IF DINT_TO_REAL(iCeiling) < rValue THEN
        iCeiling := iCeiling + 1;
    END_IF;
END_PROGRAM
";
    idiom(
        "idiom-ceiling-repaired",
        "CEILING by hand, repaired: right for every REAL that a DINT holds",
        &DOCUMENTED,
        "The idea of the page without its constant. Uses TRUNC, which every dialect has.",
        rows(TO_BE_RAISED, "CEILING", |value| value),
        vec![asserted("repaired", "iCeiling", source.to_owned())],
    )
}

fn floor_repaired() -> Table {
    const LITERALS: &[&str] = &[
        "0.0",
        "0.5",
        "1.0",
        "1.5",
        "2.9999",
        "100.0",
        "-0.5",
        "-1.0",
        "-1.5",
        "-2.0",
        "-2.5",
        "-100.25",
        "16777215.0",
        "-16777215.0",
        "-0.000001",
    ];
    let source = "\
PROGRAM main
VAR
    rValue : REAL := {input};
    iFloor : DINT;
END_VAR
    iFloor := TRUNC(rValue);
    IF rValue < 0.0 AND (DINT_TO_REAL(REAL_TO_DINT(rValue)) <> rValue) THEN
        iFloor := iFloor - 1;
    END_IF;
END_PROGRAM
";
    idiom(
        "idiom-floor-repaired",
        "FLOOR by hand, repaired so that the comparison types",
        &DOCUMENTED,
        "\
As printed the idiom compares a DINT with a REAL (see idiom-floor-as-printed); converting the DINT back makes it type, and then it is right under truncation.",
        rows(LITERALS, "FLOOR", |value| value),
        vec![asserted("repaired", "iFloor", source.to_owned())],
    )
}

fn floor_under_rounding() -> Table {
    const LITERALS: &[&str] = &["0.5", "1.5", "-0.5", "-1.5", "-2.0", "-2.5", "-0.25", "-2.75"];
    let source = rounding_conversion("")
        + "\
PROGRAM main
VAR
    rValue : REAL := {input};
    iFloor : DINT;
END_VAR
    iFloor := TRUNC(rValue);
    IF rValue < 0.0 AND (DINT_TO_REAL(Rounding_Conversion(rValue)) <> rValue) THEN
        iFloor := iFloor - 1;
    END_IF;
END_PROGRAM
";
    idiom(
        "idiom-floor-under-rounding",
        "FLOOR by hand gives the same answers where the conversion rounds",
        &DOCUMENTED,
        "The comparison only asks whether the value is a whole number, so rounding does no harm here, unlike in the rounding idiom.",
        rows(LITERALS, "FLOOR", |value| value),
        vec![asserted("half-to-even", "iFloor", source)],
    )
}

fn range_check() -> Table {
    const LITERALS: [&str; 10] = [
        "0",
        "1",
        "-1",
        "32767",
        "-32768",
        "32768",
        "-32769",
        "100000",
        "2147483647",
        "-2147483648",
    ];
    let source = "\
PROGRAM main
VAR
    dwSource : DINT := {input};
    iTarget  : INT;
END_VAR
    IF dwSource >= -32768 AND dwSource <= 32767 THEN
        iTarget := DINT_TO_INT(dwSource);
    ELSE
        iTarget := -999; (* handle out-of-range *)
    END_IF;
END_PROGRAM
";
    let row = |literal: &str| {
        let fits = Value::parse(&format!("INT#{literal}"));
        let expected = fits.map_or_else(|_| "INT#-999".to_owned(), |value| value.to_string());
        vec![literal.to_owned(), expected]
    };
    Table {
        basis: RANGE.to_owned(),
        ..idiom(
            "idiom-range-check",
            "The range check before DINT_TO_INT lets through what fits",
            &["all"],
            "",
            LITERALS.map(row).into(),
            vec![asserted("as-printed", "iTarget", source.to_owned())],
        )
    }
}

fn no_rounding_functions() -> Table {
    let names = ["ROUND", "CEIL", "CEILING", "FLOOR"];
    let rows = names
        .into_iter()
        .flat_map(|function| ["REAL", "LREAL"].map(|from| owned(&[function, from])));
    let rejected = Probe {
        name: "rejected".to_owned(),
        dialects: owned(&["matiec"]),
        source: "\
PROGRAM main
VAR
    data : {from} := 1.5;
    into : DINT;
END_VAR
    into := {function}(data);   (*! error P4017 *)
END_PROGRAM
"
        .to_owned(),
        ..Probe::default()
    };
    let recorded = Probe {
        name: "recorded".to_owned(),
        dialects: owned(&["ironplc", "plcnext"]),
        source: "\
PROGRAM main
VAR
    data : {from} := 1.5;
END_VAR
    data := {function}(data);   (*! observe acceptance *)
END_PROGRAM
"
        .to_owned(),
        ..Probe::default()
    };
    Table {
        columns: owned(&["function", "from"]),
        ..idiom(
            "no-round-ceiling-floor",
            "ROUND, CEIL, CEILING and FLOOR are not in the standard library",
            &["matiec", "ironplc", "plcnext"],
            "\
\"There is no ROUND, CEILING, FLOOR in the standard library.\" Other documents do not mention them; there acceptance is recorded.",
            rows.collect(),
            vec![rejected, recorded],
        )
    }
}
