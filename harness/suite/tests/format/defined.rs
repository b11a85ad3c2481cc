//! The cases of a dialect that was defined: taken over, but for what its definition states.

use crate::folders::folder;
use std::collections::BTreeMap;
use stickler_suite::{Acceptance, Case, Suite};
use stickler_types::{Code, Dialect, DialectName, ElementaryType, MatrixWord};

/// A matrix of implicit conversions, one of another rule, a table of calls, and a program.
const FILES: [(&str, &str); 4] = [
    (
        "a/widening.toml",
        "title = 't'\nbasis = 'iec-61131-3: 6'\ndialects = ['ironplc']\nmatrix = \"\"\"\n     SINT INT BOOL\nSINT = yes no\nINT no = no\n\"\"\"\n\
         [[probe]]\nname = 'p'\nobserve = 'into'\nsource = \"\"\"\nVAR data : {row} := {value}; into : {column} := {other}; END_VAR\n\
         into := data; (*! error P4035 if no *)\n\"\"\"\n\
         [[probe]]\nname = 'own'\nonly = 'yes'\nsource = \"\"\"\nVAR data : {row}; into : {column}; same : BOOL; END_VAR\n\
         same := data = into;\n(*! values\nsame = BOOL#TRUE\n*)\n\"\"\"\n",
    ),
    (
        "a/in-out.toml",
        "title = 't'\nbasis = 'iec-61131-3: 6'\ndialects = ['ironplc']\nmatrix = \"\"\"\n    INT BOOL\nINT = no\n\"\"\"\n\
         [[probe]]\nname = 'p'\nsource = \"\"\"\n{row} {column} (*! error P4059 if no *) (*! ok if = *)\n\"\"\"\n",
    ),
    (
        "a/calls.toml",
        "title = 't'\nbasis = 'iec-61131-3: 6'\ndialects = ['ironplc-ed3']\ncolumns = ['input', 'expected']\n\
         rows = [['2.0', 'SINT#2'], ['2.5', 'SINT#2'], ['127.5', 'SINT#127'], ['300.0', 'open']]\n\
         [[probe]]\nname = 'p'\nasks = 'REAL_TO_SINT(REAL#{input}) : SINT'\nobserve = 'into : SINT'\nexpect = '{expected}'\nsource = \"\"\"\n\
         PROGRAM main\nVAR\n    data : REAL := {input};\n    into : SINT;\nEND_VAR\n    into := REAL_TO_SINT(data);\nEND_PROGRAM\n\"\"\"\n",
    ),
    (
        "a/program.st",
        "(*!\ntitle = 't'\nbasis = 'iec-61131-3: 6'\ndialects = ['all']\n*)\nx; (*! ok in ironplc-ed3 *)\n",
    ),
];

/// The cases that a dialect has, by id.
fn cases(definition: Dialect) -> BTreeMap<String, Case> {
    let dialect = DialectName::define(definition).unwrap();
    let files: Vec<(&str, &str)> = FILES.to_vec();
    let folder = folder(&files);
    let root = folder.path().join("cases");
    let suite = Suite::load_with(&root, &[dialect]);
    assert_eq!(suite.errors, []);
    let others = |suite: &Suite| {
        suite
            .cases
            .iter()
            .filter(|case| case.dialect != dialect)
            .cloned()
            .collect()
    };
    let (with, without): (Vec<Case>, Vec<Case>) = (others(&suite), others(&Suite::load(&root)));
    assert_eq!(with, without, "the cases of other dialects stay what they are");
    let own = suite.cases.into_iter().filter(|case| case.dialect == dialect);
    own.map(|case| (case.id.to_string(), case)).collect()
}

fn values(case: &Case) -> Vec<String> {
    case.expectation
        .values
        .iter()
        .map(|value| value.value.to_string())
        .collect()
}

#[test]
fn what_overrides_nothing_takes_every_case_over_as_it_is() {
    let own = cases(Dialect::custom(
        "overrides-nothing",
        DialectName::IRONPLC_ED3,
        "here",
    ));
    let suite = Suite::load(&folder(&FILES).path().join("cases"));
    let base: Vec<&Case> = suite
        .cases
        .iter()
        .filter(|case| case.dialect == DialectName::IRONPLC_ED3)
        .collect();
    assert_eq!(own.len(), base.len());
    for case in base {
        let own = &own[&*case.id];
        assert!(!own.is_stated());
        assert_eq!(
            *case,
            Case {
                dialect: case.dialect,
                ..own.clone()
            }
        );
    }
}

#[test]
fn a_cell_that_is_overridden_expects_what_the_definition_says() {
    use ElementaryType::{Bool, Int, Sint};
    let own = cases(
        Dialect::custom("cells", DialectName::IRONPLC_ED3, "here")
            .stating_cell((Sint, Int), MatrixWord::No, "cells: implicit SINT.INT")
            .stating_cell((Int, Sint), MatrixWord::Yes, "cells: implicit INT.SINT")
            .stating_cell((Int, Bool), MatrixWord::Open, "cells: implicit INT.BOOL"),
    );
    let rejected = &own["a/widening::p(SINT,INT)"];
    assert_eq!(
        rejected.expectation.diagnostics[0].code,
        "P4035".parse::<Code>().unwrap()
    );
    assert_eq!(&*rejected.basis, "cells: implicit SINT.INT");
    assert_eq!(&*rejected.title, "SINT to INT is `no` in cells");
    assert!(rejected.is_stated());
    // What fits arrives unchanged; of the rest IronPLC says that a conversion function wraps.
    assert_eq!(values(&own["a/widening::p(INT,SINT,-128)"]), ["SINT#-128"]);
    assert_eq!(values(&own["a/widening::p(INT,SINT,128)"]), ["SINT#-128"]);
    let open: Vec<&Case> = own
        .values()
        .filter(|case| case.id.starts_with("a/widening::p(INT,BOOL"))
        .collect();
    assert!(!open.is_empty());
    assert!(
        open.iter()
            .all(|case| case.expectation.accepted == Acceptance::Observed)
    );
    // A cell that nobody overrides, a matrix that says nothing of implicit conversion, and a probe that says values of its own.
    for taken_over in [
        "a/widening::p(SINT,BOOL)",
        "a/in-out::p(INT,BOOL)",
        "a/program",
        "a/widening::own(SINT,INT)",
    ] {
        assert!(!own[taken_over].is_stated(), "{taken_over}");
    }
    // A text is not that of a number by default: what a probe says of the pairs of its matrix, it says of no others.
    assert!(!own.contains_key("a/widening::own(INT,SINT)"));
}

#[test]
fn a_call_expects_what_exact_arithmetic_gives_by_the_choices_of_the_definition() {
    let rounding = |name| {
        let dialect = Dialect::custom(name, DialectName::IRONPLC_ED3, "here");
        dialect
            .stating("conversions.rounding", "'half-away-from-zero'", "calls: rounding")
            .unwrap()
    };
    let saturating =
        rounding("calls").stating("conversions.out-of-range", "'saturate'", "calls: out-of-range");
    let own = cases(saturating.unwrap());
    for (id, expected, basis) in [
        ("a/calls::p(2.0)", "SINT#2", "iec-61131-3: 6"),
        ("a/calls::p(2.5)", "SINT#3", "calls: rounding"),
        ("a/calls::p(127.5)", "SINT#127", "calls: out-of-range"),
        // What the file leaves open.
        ("a/calls::p(300.0)", "SINT#127", "calls: out-of-range"),
    ] {
        assert_eq!(
            (values(&own[id]), &*own[id].basis),
            (vec![expected.to_owned()], basis),
            "{id}"
        );
    }
    let own = cases(rounding("calls-wrapping"));
    // It is 128, and nobody says what becomes of that.
    let open = &own["a/calls::p(127.5)"];
    assert_eq!(
        (open.expectation.accepted, open.expectation.values.len()),
        (Acceptance::Observed, 0)
    );
    assert_eq!(&*open.observe[0].name, "into");
}
