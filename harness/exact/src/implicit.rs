//! Implicit conversion by the documents: the pairs of elementary types that convert without a call, and the converted values.
//!
//! The tables of `implicit.toml` are stated independently of the widening tables of the conformance cases; a test of `stickler-tabulate`
//! compares the two, cell by cell.

use crate::{integer, moment, real};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::sync::LazyLock;
use stickler_types::documents::DocumentedImplicit;
use stickler_types::{Dialect, DialectName, ElementaryType, MatrixWord, MomentUnits, Value};

/// Returns whether a value of the type `from` converts implicitly to `to` in a dialect.
///
/// A type that the dialect does not have converts to no other, and no other to it. A statement of the dialect's definition
/// about a pair takes precedence over the documents, whose tables are in `implicit.toml`.
///
/// Basis: ironplc-type-conversions: Cross-family widening; for the rest see the tables.
pub fn implicit(from: ElementaryType, to: ElementaryType, dialect: DialectName) -> MatrixWord {
    if from == to {
        return MatrixWord::Same;
    }
    if !dialect.rules().may_name(from) || !dialect.rules().may_name(to) {
        return MatrixWord::No;
    }
    let rules = Dialect::of(dialect);
    if let Some(stated) = rules.cells.get(&(from, to)) {
        return stated.value;
    }
    let document = rules.documents.implicit;
    // "A bit-string type can widen to an integer type of strictly greater bit width", which needs the flag.
    let is_cross_family = from.is_bit_string() && to.is_integer() && from.bits() < to.bits();
    let has_flag = document == DocumentedImplicit::IronplcMatrices && rules.cross_family_widening;
    match is_cross_family && has_flag {
        true => MatrixWord::Yes,
        false => DOCUMENTS[document as usize][from as usize][to as usize],
    }
}

/// The word of each pair of types, by their numbers.
type PairWords = [[MatrixWord; ElementaryType::ALL.len()]; ElementaryType::ALL.len()];

/// The tables of the documents, in the order of [`DocumentedImplicit::ALL`]. The first use panics where `implicit.toml` has a mistake.
static DOCUMENTS: LazyLock<[PairWords; DocumentedImplicit::ALL.len()]> = LazyLock::new(|| {
    let tables = toml::from_str(include_str!("implicit.toml"));
    let tables: BTreeMap<String, PairTable> = tables.unwrap_or_else(|error| panic!("implicit.toml: {error}"));
    DocumentedImplicit::ALL.map(
        |document| match tables.get(document.as_str()).map(PairTable::words) {
            Some(Ok(words)) => words,
            Some(Err(name)) => panic!("`{name}` in [{document}] of implicit.toml is no word and no type"),
            None => panic!("implicit.toml has no table [{document}]"),
        },
    )
});

/// A table of `implicit.toml`.
#[derive(Deserialize)]
struct PairTable {
    otherwise: String,
    /// The types to which a type converts, by the word for them.
    #[serde(flatten)]
    rows: BTreeMap<String, BTreeMap<String, String>>,
}

impl PairTable {
    /// Returns the words of all pairs, or what is no word and no type.
    fn words(&self) -> Result<PairWords, &str> {
        let mut words = [[word(&self.otherwise)?; ElementaryType::ALL.len()]; ElementaryType::ALL.len()];
        for (from, said) in &self.rows {
            for (name, types) in said {
                for to in types.split(' ') {
                    words[ty(from)? as usize][ty(to)? as usize] = word(name)?;
                }
            }
        }
        Ok(words)
    }
}

fn word(name: &str) -> Result<MatrixWord, &str> {
    MatrixWord::from_word(name).ok_or(name)
}

fn ty(name: &str) -> Result<ElementaryType, &str> {
    ElementaryType::from_name(name).ok_or(name)
}

/// The unit of a TIME, which is the same whatever counts a date.
const MILLISECONDS: MomentUnits = MomentUnits::Seconds;

/// The result of an implicit conversion, as far as it is known.
#[derive(Clone, Debug, PartialEq)]
pub enum ImplicitResult {
    /// The result is exactly this value.
    Exactly(Value),
    /// The target cannot hold the value, and no document says what it holds instead.
    Open,
}

/// Returns the value of a variable of type `to` after `value` was assigned to it; `None` for pairs of types that no
/// document converts implicitly.
///
/// The result is the number (rounded once, to the nearest, where the target is a real), the zero-extended bits, the same
/// duration, date or time of day in its long or short form, or for UDINT and TIME the same count of milliseconds.
///
/// Basis: conformance-cases/README.md (a matrix of types).
pub fn implicit_result(value: &Value, to: ElementaryType) -> Option<ImplicitResult> {
    use ElementaryType::{Lreal, Real, Time, Udint};
    let (from, raw) = match *value {
        Value::Plain { ty, raw } => (ty, raw),
        Value::Text { ty, .. } => return (ty == to).then(|| ImplicitResult::Exactly(value.clone())),
        Value::Enumerated { .. } | Value::OutOfRange { .. } | Value::Near { .. } => return None,
    };
    let is_number = |ty: ElementaryType| ty.integer_range().is_some();
    let raw = match (from, to) {
        _ if from == to => raw,
        (Real, Lreal) => real::between(raw, from, to),
        // TIME has 32 bits with a sign in PLCnext Engineer, where the two convert.
        (Udint, Time) => moment::from_units(integer::number(raw, from), to, MomentUnits::ShortTime),
        (Time, Udint) if !moment::has_whole_units(raw, from, MILLISECONDS) => {
            return Some(ImplicitResult::Open);
        }
        (Time, Udint) => return Some(held(moment::units(raw, from, MILLISECONDS), to)),
        _ if is_number(from) && is_number(to) => return Some(held(integer::number(raw, from), to)),
        _ if from.is_integer() && to.is_real() => real::from_integer(integer::number(raw, from), to),
        _ if from.is_form_of(to) => moment::between(raw, to),
        _ => return None,
    };
    Some(ImplicitResult::Exactly(Value::plain(to, raw)))
}

/// Returns the number as a value of the type, if the type holds it.
fn held(number: i128, to: ElementaryType) -> ImplicitResult {
    match to.holds(number) {
        true => ImplicitResult::Exactly(Value::plain(to, integer::wrapped(number, to))),
        false => ImplicitResult::Open,
    }
}
