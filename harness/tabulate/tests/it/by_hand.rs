//! The tables whose rows are more than a call of one function: nobody fills in their cells, so that a test compares them.

use std::collections::HashMap;
use stickler_exact::{Signature, expected, signatures};
use stickler_tabulate::folder;
use stickler_tabulate::table::{ProbeClaim, Table};
use stickler_types::{DialectName, ElementaryType, Value};

/// The functions through which the input of a row goes, one after the other.
const STEPS: [(&str, [&str; 2]); 6] = [
    ("chains", ["{inner}", "{outer}"]),
    ("chains-of-what-widened", ["{inner}", "{outer}"]),
    ("chains-by-the-page", ["{inner}", "{outer}"]),
    (
        "expression-result-widens",
        ["{from}_TO_{narrow}", "{narrow}_TO_{wide}"],
    ),
    (
        "expression-argument-widens",
        ["{narrow}_TO_{wide}", "{wide}_TO_{to}"],
    ),
    // After these, 1 is added.
    (
        "expression-operand-widens",
        ["{from}_TO_{narrow}", "{narrow}_TO_{wide}"],
    ),
];

/// Preparations of the input of a row, each with the function that takes the result.
///
/// A REAL is what Rust calls `f32`, and adds by IEC 60559 as `f32` does: the sum is rounded once, to nearest, ties to even.
const IDIOMS: [(&str, Prepare, &str); 6] = [
    ("idiom-round", half_added, "REAL_TO_DINT"),
    ("idiom-round-under-rounding", half_added, "ROUND"),
    ("idiom-ceiling", |value| value + 0.999_999, "TRUNC_DINT"),
    ("idiom-ceiling-repaired", |value| value, "CEILING"),
    ("idiom-floor-repaired", |value| value, "FLOOR"),
    ("idiom-floor-under-rounding", |value| value, "FLOOR"),
];

type Prepare = fn(f32) -> f32;

fn half_added(value: f32) -> f32 {
    value + if value < 0.0 { -0.5 } else { 0.5 }
}

fn tables() -> HashMap<String, Table> {
    let tables = folder::tables(&crate::root()).unwrap();
    tables
        .into_iter()
        .map(|(_, table)| (table.name.clone(), table))
        .collect()
}

/// Returns the rows of a table, each as its cells by the names of their columns.
fn rows(table: &Table) -> impl Iterator<Item = HashMap<&str, &str>> {
    let columns = table.columns.iter().map(String::as_str);
    table
        .rows
        .iter()
        .map(move |row| columns.clone().zip(row.iter().map(String::as_str)).collect())
}

fn filled(template: &str, row: &HashMap<&str, &str>) -> String {
    row.iter().fold(template.to_owned(), |text, (column, cell)| {
        text.replace(&format!("{{{column}}}"), cell)
    })
}

fn literal(ty: &str, literal: &str) -> Value {
    let value = Value::parse(literal).or_else(|_| Value::parse(&format!("{ty}#{literal}")));
    value.unwrap_or_else(|error| panic!("{ty} {literal}: {error}"))
}

/// Returns the signature of a function for an operand; of several the one with the widest result.
fn signature(function: &str, operand: &Value, dialect: DialectName) -> Signature {
    let signatures = signatures(function, dialect).into_iter();
    let fitting = signatures.filter(|signature| signature.takes(std::slice::from_ref(operand)));
    let widest = fitting.max_by_key(|signature| signature.result.bits());
    widest.unwrap_or_else(|| panic!("{dialect} has no {function}({operand})"))
}

/// Returns what a function gives; `None` where no document of the dialect says so.
fn documented(function: &str, operand: &Value, to: Option<&str>, dialect: DialectName) -> Option<Value> {
    let mut signature = signature(function, operand, dialect);
    if let Some(to) = to.and_then(ElementaryType::from_name) {
        signature.result = to;
    }
    let expected = expected(&signature, std::slice::from_ref(operand), dialect);
    expected.basis.map(|_| expected.value)
}

#[test]
fn conversions_of_conversions_are_done_step_by_step() {
    let tables = tables();
    for (name, [first, second]) in STEPS {
        let table = &tables[name];
        let asserting = table
            .probes
            .iter()
            .filter(|probe| probe.claim == Some(ProbeClaim::Value));
        let dialects: Vec<DialectName> = asserting.flat_map(|probe| probe.dialects.clone()).collect();
        assert!(!dialects.is_empty(), "{name}");
        for (row, &dialect) in
            rows(table).flat_map(|row| dialects.iter().map(move |dialect| (row.clone(), dialect)))
        {
            let (first, second) = (filled(first, &row), filled(second, &row));
            let (source, _) = first.split_once("_TO_").unwrap();
            let step = documented(&first, &literal(source, row["input"]), None, dialect);
            let result = step.and_then(|value| documented(&second, &value, row.get("to").copied(), dialect));
            let result = match result {
                Some(Value::Plain { ty, raw }) if name == "expression-operand-widens" => {
                    Some(Value::plain(ty, ty.wrap(ty.integer_value(raw) + 1)))
                }
                result => result,
            };
            let result = result.map(|value| value.to_string());
            assert_eq!(
                result.as_deref().unwrap_or("open"),
                row["expected"],
                "{name} in {dialect}: {row:?}"
            );
        }
    }
}

/// The basis of a step that extends a sign: where the second step does so, a chain cites it.
const EXTENDS_SIGN: &str = "ironplc-conversion-design: Codegen Routing";

#[test]
fn a_chain_cites_what_its_first_step_rests_on_unless_the_second_extends_a_sign() {
    let sources = folder::names(&crate::root()).unwrap().sources;
    let tables = tables();
    let chains = ["chains", "chains-of-what-widened"].map(|name| &tables[name]);
    let probes = chains
        .into_iter()
        .flat_map(|table| table.probes.iter().map(move |probe| (table, probe)));
    let mut extending = 0;
    for (table, probe) in probes {
        let dialects = &probe.dialects;
        for (row, &dialect) in
            rows(table).flat_map(|row| dialects.iter().map(move |dialect| (row.clone(), dialect)))
        {
            let step = |function: &str, operand: Value| {
                let signature = signature(function, &operand, dialect);
                expected(&signature, &[operand], dialect)
            };
            let first = step(row["inner"], literal(row["from"], row["input"]));
            let second = step(row["outer"], first.value);
            let basis = second.basis.filter(|basis| *basis == EXTENDS_SIGN);
            extending += usize::from(basis.is_some());
            let bases = if row["basis"].is_empty() {
                &probe.basis[..]
            } else {
                row["basis"]
            };
            assert_eq!(
                sources.choose(bases, dialect),
                basis.or(first.basis),
                "{dialect}: {row:?}"
            );
        }
    }
    assert!(extending > 0, "no chain extends a sign in its second step");
}

#[test]
fn the_idioms_give_what_32_bit_arithmetic_gives() {
    let tables = tables();
    for (name, prepare, function) in IDIOMS {
        for row in rows(&tables[name]) {
            let Value::Plain { ty, raw } = literal("REAL", row["input"]) else {
                panic!("{row:?}");
            };
            let prepared = prepare(f32::from_bits(u32::try_from(raw).unwrap()));
            let operand = [Value::plain(ty, prepared.to_bits().into())];
            let mut signature = signature(function, &operand[0], DialectName::IRONPLC_ED3);
            signature.result = ElementaryType::Dint;
            let result = expected(&signature, &operand, DialectName::IRONPLC_ED3).value;
            assert_eq!(result.to_string(), row["expected"], "{name}: {row:?}");
        }
    }
}

/// The tables of the range check, and the target of a number that it does not let through.
const RANGE_CHECKS: [(&str, &str); 2] = [
    ("idiom-range-check", "INT#-999"),
    ("idiom-range-check-with-an-empty-else", "INT#7"),
];

/// The table of texts whose numbers are 0 where their type does not hold them.
const LATER_TEXTS: &str = "later-texts";

#[test]
fn the_range_check_lets_through_what_fits() {
    let tables = tables();
    for (name, outside) in RANGE_CHECKS {
        for row in rows(&tables[name]) {
            let fitting = Value::parse(&format!("INT#{}", row["input"]));
            let result = fitting.map_or_else(|_| outside.to_owned(), |value| value.to_string());
            assert_eq!(result, row["expected"], "{name}: {row:?}");
        }
    }
}

#[test]
fn a_text_is_a_number_that_its_type_holds_or_0() {
    for row in rows(&tables()[LATER_TEXTS]) {
        let ty = ElementaryType::from_name(row["type"]).unwrap();
        let number = row["text"].parse::<i128>().ok();
        let is_held = |number: &i128| match ty.integer_range() {
            Some((least, greatest)) => (least..=greatest).contains(number),
            None => (0..1_i128 << ty.bits()).contains(number),
        };
        let value = number.filter(is_held).unwrap_or(0);
        let expected = Value::parse(&format!("{}#{value}", ty.name())).unwrap();
        assert_eq!(expected.to_string(), row["expected"], "{row:?}");
    }
}

#[test]
fn every_constant_expression_is_5() {
    for row in rows(&tables()["constant-expressions"]) {
        let (function, operand) = row["call"].trim_end_matches(')').split_once('(').unwrap();
        let result = documented(function, &literal("", operand), None, DialectName::MATIEC).unwrap();
        assert!(result.to_string().ends_with("#5"), "{row:?} is {result}");
    }
}

#[test]
fn every_table_with_expected_values_is_compared() {
    let mut compared: Vec<&str> = STEPS.map(|(name, _)| name).into();
    compared.extend(IDIOMS.map(|(name, _, _)| name));
    compared.extend(RANGE_CHECKS.map(|(name, _)| name));
    compared.push(LATER_TEXTS);
    for (name, table) in tables() {
        let has_values = table.columns.iter().any(|column| column == "expected");
        let is_compared = table.is_of_calls() || compared.contains(&name.as_str());
        assert!(!has_values || is_compared, "nothing compares the rows of {name}");
    }
}
