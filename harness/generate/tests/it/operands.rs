//! Operators of two integers whose result goes to any integer type, the narrower ones included: the reference against arithmetic without limits.
//!
//! The generator draws operands of one type, and no programs in the dialects that promote operands: what these compute is compared here.

use num_bigint::BigInt;
use stickler_exact::implicit;
use stickler_reference::{Limits, run};
use stickler_types::{
    DialectName, ElementaryType, Family, MatrixWord, Observation, Outcome, RunRequest, Value,
};

/// The integers that the operators of a dialect take, by the documents.
///
/// Basis: logix-manual: 541 (SINT, INT, DINT); control-expert-implicit: Implicit Type Conversion Rules; the rest have all eight.
fn integers(dialect: DialectName) -> Vec<ElementaryType> {
    use ElementaryType::{Dint, Int, Sint};
    match dialect {
        DialectName::LOGIX => vec![Sint, Int, Dint],
        DialectName::CONTROL_EXPERT => vec![Int, Dint],
        _ => ElementaryType::ALL
            .into_iter()
            .filter(|ty| ty.is_integer())
            .collect(),
    }
}

/// An integer type in which operands meet.
#[derive(Clone, Copy)]
struct MeetingType {
    bits: u32,
    signed: bool,
}

impl MeetingType {
    fn of(ty: ElementaryType) -> MeetingType {
        MeetingType {
            bits: ty.bits(),
            signed: ty.family() == Family::Signed,
        }
    }

    /// Returns the number of the type with the same low bits.
    fn wrap(self, number: &BigInt) -> BigInt {
        let modulus = BigInt::from(1) << self.bits;
        let low = ((number % &modulus) + &modulus) % &modulus;
        match self.signed && low >= BigInt::from(1) << (self.bits - 1) {
            true => low - modulus,
            false => low,
        }
    }
}

/// Returns the type in which two integers meet; `None` where they do not.
///
/// Basis: codesys-recording: recordings/codesys.run.json (`meet_…`), and logix-manual: 541: as wide as the wider one and 32 bits at least, with a sign
/// if one of them has one; elsewhere the type of the one to which the other converts (iec-61131-3: 6.6.1.7).
fn meeting(left: ElementaryType, right: ElementaryType, dialect: DialectName) -> Option<MeetingType> {
    let (one, other) = (MeetingType::of(left), MeetingType::of(right));
    if matches!(
        dialect,
        DialectName::CODESYS | DialectName::TWINCAT | DialectName::LOGIX | DialectName::CONTROL_EXPERT
    ) {
        return Some(MeetingType {
            bits: one.bits.max(other.bits).max(32),
            signed: one.signed || other.signed,
        });
    }
    let converts = |from, to| from == to || implicit(from, to, dialect) == MatrixWord::Yes;
    if converts(left, right) {
        Some(other)
    } else {
        converts(right, left).then_some(one)
    }
}

/// The operators, each with its result; none is asked to divide by zero, nor the least number by -1.
const OPERATORS: [(&str, Arithmetic); 5] = [
    ("+", |a, b| a + b),
    ("-", |a, b| a - b),
    ("*", |a, b| a * b),
    ("/", |a, b| a / b),
    ("MOD", |a, b| a % b),
];

type Arithmetic = fn(&BigInt, &BigInt) -> BigInt;

/// Numbers at the limits of a type, and one between them.
fn numbers(ty: ElementaryType) -> [i128; 3] {
    let (least, greatest) = ty.integer_range().expect("an integer type has a range");
    [if least == 0 { 1 } else { least }, greatest, 7]
}

/// Runs one operation, and returns what its target holds; `None` where the program is rejected.
fn computed(
    dialect: DialectName,
    operator: &str,
    (left, a): (ElementaryType, i128),
    (right, b): (ElementaryType, i128),
    target: ElementaryType,
) -> Option<Value> {
    let text = format!(
        "PROGRAM main\nVAR a : {left} := {a}; b : {right} := {b}; r : {target}; END_VAR\nr := a {operator} b;\nEND_PROGRAM\n"
    );
    let observe = [Observation::last("r", "")];
    let outcome = run(&RunRequest::once(dialect, &text, &observe), Limits::default()).expect("r is observed");
    match outcome {
        Outcome::Executed { values, .. } => values.into_iter().next().map(|(_, value)| value),
        Outcome::Rejected { .. } => None,
        other => panic!("{text}: {other}"),
    }
}

fn compare_all(dialect: DialectName, operator: &str, pair: [ElementaryType; 2]) -> usize {
    let [left, right] = pair;
    let Some(meeting) = meeting(left, right, dialect) else {
        return 0;
    };
    let function = OPERATORS
        .iter()
        .find(|(name, _)| *name == operator)
        .expect("it is one of them")
        .1;
    let mut compared = 0;
    for (a, b) in numbers(left)
        .into_iter()
        .flat_map(|a| numbers(right).map(|b| (a, b)))
    {
        let [x, y] = [a, b].map(|number| meeting.wrap(&BigInt::from(number)));
        if y == BigInt::from(0) || y == BigInt::from(-1) {
            continue;
        }
        let result = meeting.wrap(&function(&x, &y));
        for target in integers(dialect) {
            let Some(value) = computed(dialect, operator, (left, a), (right, b), target) else {
                continue;
            };
            let expected = MeetingType::of(target).wrap(&result);
            let what = format!("{left}#{a} {operator} {right}#{b} as a {target} in {dialect}");
            assert_eq!(value.to_string(), format!("{target}#{expected}"), "{what}");
            compared += 1;
        }
    }
    compared
}

#[test]
fn operators_of_mixed_operands_give_what_arithmetic_without_limits_gives() {
    for dialect in [
        DialectName::IRONPLC_ED3,
        DialectName::PLCNEXT,
        DialectName::CODESYS,
        DialectName::TWINCAT,
        DialectName::LOGIX,
        DialectName::CONTROL_EXPERT,
    ] {
        let types = integers(dialect);
        let mut compared = 0;
        for (operator, _) in OPERATORS {
            for &left in &types {
                for &right in &types {
                    compared += compare_all(dialect, operator, [left, right]);
                }
            }
        }
        assert!(compared > 100, "{dialect}: {compared}");
    }
}
