//! Implicit conversion by the documents: the pairs of elementary types that convert without a call, and the converted values.
//!
//! The rules here are stated independently of the widening tables of the conformance cases; a test of `stickler-tabulate`
//! compares the two, cell by cell.

use crate::{integer, moment, real};
use stickler_types::documents::DocumentedImplicit;
use stickler_types::{Dialect, DialectName, ElementaryType, Family, MatrixWord, MomentUnits, Value};

/// Returns whether a value of the type `from` converts implicitly to `to` in a dialect.
///
/// A type that the dialect does not have converts to no other, and no other to it. A statement of the dialect's definition
/// about a pair takes precedence over the documents.
///
/// Basis: ironplc-type-conversions: Implicit Type Widening, Cross-family widening; forgeiec-conversion-functions: matiec
/// conformance; implicit-conversion-table: SEM1189 table; implicit-conversion-rules: ANY_DURATION, for TIME and LTIME, which are
/// not in the table; strucpp-architecture: Type System and strucpp-tests for STruC++; rusty-tests and rusty-datatypes for RuSTy;
/// codesys-implicit for CODESYS and TwinCAT; logix-manual: 512, 543, 546 for Logix; control-expert-implicit for Control Expert;
/// iec-61131-3: 6.6.1.6 for the third edition.
#[must_use]
pub fn implicit(from: ElementaryType, to: ElementaryType, dialect: DialectName) -> MatrixWord {
    if from == to {
        return MatrixWord::Same;
    }
    if !dialect.rules().has(from) || !dialect.rules().has(to) {
        return MatrixWord::No;
    }
    let rules = Dialect::of(dialect);
    if let Some(stated) = rules.cells.get(&(from, to)) {
        return stated.value;
    }
    match rules.documents.implicit {
        DocumentedImplicit::Ironplc if is_cross_family(from, to) => said(rules.cross_family_widening),
        DocumentedImplicit::Ironplc => ironplc(from, to),
        DocumentedImplicit::None => MatrixWord::No,
        DocumentedImplicit::Plcnext => plcnext(from, to),
        DocumentedImplicit::Strucpp => strucpp(from, to),
        DocumentedImplicit::Rusty => rusty(from, to),
        DocumentedImplicit::Codesys => codesys(from, to),
        DocumentedImplicit::Logix => logix(from, to),
        DocumentedImplicit::ControlExpert => control_expert(from, to),
        DocumentedImplicit::ThirdEdition => iec_ed3(from, to),
        DocumentedImplicit::Open => MatrixWord::Open,
    }
}

/// Returns the answer of IronPLC's three categories; open between the short and the long form of a type, for which only its
/// general rule could apply.
fn ironplc(from: ElementaryType, to: ElementaryType) -> MatrixWord {
    if from.is_form_of(to) {
        return MatrixWord::Open;
    }
    said(match (from.family(), to.family()) {
        // "The source type's full value range is exactly representable in the target type", which the matrix repeats.
        (Family::Signed | Family::Unsigned, Family::Signed | Family::Unsigned) => {
            holds_every_integer(from, to)
        }
        // "LREAL … covers all standard integer types": by the matrix, although 64 bits do not fit.
        (Family::Signed | Family::Unsigned, Family::Real) => to == ElementaryType::Lreal || from.bits() <= 16,
        (Family::BitString, Family::BitString) | (Family::Real, Family::Real) => from.bits() < to.bits(),
        _ => false,
    })
}

/// Returns whether the pair is one of "a bit-string type can widen to an integer type of strictly greater bit width", which
/// needs the flag.
const fn is_cross_family(from: ElementaryType, to: ElementaryType) -> bool {
    from.is_bit_string() && to.is_integer() && from.bits() < to.bits()
}

/// Returns the answer of PLCnext's coloured table.
fn plcnext(from: ElementaryType, to: ElementaryType) -> MatrixWord {
    use ElementaryType::{Ltime, Time, Udint};
    said(match (from.family(), to.family()) {
        (Family::Signed | Family::Unsigned, Family::Signed | Family::Unsigned) => {
            holds_every_integer(from, to)
        }
        // "REAL mantissa = 23 bit, LREAL mantissa = 52 bit": so LINT and ULINT become no real.
        (Family::Signed | Family::Unsigned, Family::Real) => {
            from.bits() <= if to == ElementaryType::Real { 16 } else { 32 }
        }
        (Family::Boolean | Family::BitString, Family::BitString) | (Family::Real, Family::Real) => {
            from.bits() < to.bits()
        }
        _ => matches!((from, to), (Udint, Time) | (Time, Udint) | (Time, Ltime)),
    })
}

/// Returns the answer of RuSTy's tests and its page on data types. A downcast is accepted with a warning, and nothing is said of the value, so it is
/// open; so is what no test names.
fn rusty(from: ElementaryType, to: ElementaryType) -> MatrixWord {
    use ElementaryType::{Char, String};
    let is_magnitude = |ty: ElementaryType| ty.is_number() || ty.is_bit_string() || ty.is_duration();
    let is_text = |ty: ElementaryType| matches!(ty.family(), Family::Text | Family::Character);
    // "The long pendants LTIME, LTOD, LDATE and LDT are mere aliases to the original types."
    if from.is_form_of(to) {
        return MatrixWord::Yes;
    }
    match (from, to) {
        (String | Char, _) if is_magnitude(to) => MatrixWord::No,
        (_, String | Char) if is_magnitude(from) || is_text(from) => MatrixWord::No,
        _ if keeps_its_value(from, to) => MatrixWord::Yes,
        _ => MatrixWord::Open,
    }
}

/// Returns the answer of STruC++'s page on its type system and of its tests. What narrows is accepted with a warning, and nothing is said of the
/// value, so it is open; so is what neither the page nor a test names.
fn strucpp(from: ElementaryType, to: ElementaryType) -> MatrixWord {
    // A test rejects a STRING that is assigned to an INT.
    if from == ElementaryType::String && to.is_integer() {
        return MatrixWord::No;
    }
    match keeps_its_value(from, to) {
        true => MatrixWord::Yes,
        false => MatrixWord::Open,
    }
}

/// Returns the answer of the matrix that was measured on CODESYS and TwinCAT, which has numbers and bit strings: what may lose the sign
/// or digits is warned of. For other types the matrix is a rule that was not measured.
fn codesys(from: ElementaryType, to: ElementaryType) -> MatrixWord {
    let is_number = |ty: ElementaryType| ty.is_number() || ty.is_bit_string();
    if !is_number(from) || !is_number(to) {
        return MatrixWord::Open;
    }
    let keeps_all = match (from.is_whole(), to.is_whole()) {
        (true, true) if from.bits() > to.bits() => return MatrixWord::No,
        (true, true) => match (from.is_signed(), to.is_signed()) {
            (true, false) => false,
            (false, true) => from.bits() < to.bits(),
            _ => true,
        },
        // 24 binary digits in a REAL, 53 in an LREAL.
        (true, false) => from.bits() <= if to == ElementaryType::Real { 16 } else { 32 },
        (false, true) => return MatrixWord::No,
        (false, false) => from == ElementaryType::Real,
    };
    if keeps_all {
        MatrixWord::Yes
    } else {
        MatrixWord::Warn
    }
}

/// Returns the answer of the Logix manual: which types an assignment writes, by the kind of their expression, and which conversions there are. It writes
/// BOOL, SINT, INT, DINT, REAL and STRING; of the pairs that are not named, and of LINT, whose range is said to be that of a time, nothing follows.
fn logix(from: ElementaryType, to: ElementaryType) -> MatrixWord {
    use ElementaryType::{Bool, Dint, Int, Lint, Lreal, Real, Sint, String};
    match (from, to) {
        (Bool, _) if to.is_number() => MatrixWord::No,
        (_, Bool | String) if from.is_number() => MatrixWord::No,
        (Bool, String) | (String, Bool | Sint | Int | Dint | Real) => MatrixWord::No,
        (Lint, _) => MatrixWord::Open,
        (Lreal, Sint | Int | Dint) => MatrixWord::Open,
        (_, Sint | Int | Dint | Real) if from.is_number() => MatrixWord::Yes,
        _ => MatrixWord::Open,
    }
}

/// Returns the answer of the table of Control Expert, which has nine types: all stand for each other, but nothing for a BOOL, and REAL for no bit string.
fn control_expert(from: ElementaryType, to: ElementaryType) -> MatrixWord {
    use ElementaryType::{Bool, Byte, Dint, Dword, Int, Real, Udint, Uint, Word};
    let is_in_table = |ty| matches!(ty, Real | Dint | Int | Udint | Uint | Dword | Word | Byte | Bool);
    match (from, to) {
        _ if !is_in_table(from) || !is_in_table(to) => MatrixWord::Open,
        (_, Bool) | (Real, Dword | Word | Byte) => MatrixWord::No,
        _ => MatrixWord::Yes,
    }
}

/// Returns the answer of the third edition's Figures 11 and 12: the paths are implicit, and a pair of Tables 23 to 27 without one is a call. Where the
/// standard defines neither, an implementation may convert, so that the pair is open; so is CHAR to STRING, on which the restatements do not agree.
fn iec_ed3(from: ElementaryType, to: ElementaryType) -> MatrixWord {
    use ElementaryType::{Date, Dt, Ldt, Ltime, Ltod, Time, Tod};
    use Family::{BitString, Boolean, Character, Real, Signed, Text, Unsigned};
    let widens = from.bits() < to.bits();
    match (from.family(), to.family()) {
        (Signed | Unsigned, Signed | Unsigned) => said(holds_every_integer(from, to)),
        // 24 binary digits in a REAL, 53 in an LREAL.
        (Signed | Unsigned, Real) => said(from.bits() * 2 <= to.bits()),
        (Real, Real) => said(widens),
        (Boolean | BitString, BitString) => said(widens),
        (Boolean | BitString, Signed | Unsigned) | (Real, Signed | Unsigned) => MatrixWord::No,
        (Signed | Unsigned, BitString) => MatrixWord::No,
        (BitString, Real) | (Real, BitString) if from.bits() == to.bits() => MatrixWord::No,
        (Text, Text) | (Character, Character) => MatrixWord::No,
        // One character of a text of its own width.
        (Text, Character) if is_wide(from) == is_wide(to) => MatrixWord::No,
        _ if from.long_form() == Some(to) => MatrixWord::Yes,
        _ => match (from, to) {
            (Ltime, Time) | (Ltod, Tod) | (Ldt, Dt) | (Dt | Ldt, Date | Tod | Ltod) => MatrixWord::No,
            _ => MatrixWord::Open,
        },
    }
}

const fn is_wide(text: ElementaryType) -> bool {
    matches!(text, ElementaryType::Wstring | ElementaryType::Wchar)
}

/// Returns whether a value widens within its category, or from a bit string to an integer, or from an integer to a real that holds it.
///
/// Basis: strucpp-architecture: Type System ("SINT -> INT -> DINT -> LINT"); strucpp-tests: tests/semantic/type-utils.test.ts (INT to REAL, DINT to
/// LREAL, BYTE to DWORD, BYTE to INT); rusty-tests: src/validation/tests/assignment_validation_tests.rs (without a warning); codesys-implicit: classifyElementary.
fn keeps_its_value(from: ElementaryType, to: ElementaryType) -> bool {
    use Family::{BitString, Real, Signed, Unsigned};
    let widens = from.bits() < to.bits();
    match (from.family(), to.family()) {
        (Signed, Signed)
        | (Unsigned, Unsigned)
        | (Real, Real)
        | (BitString, BitString | Signed | Unsigned) => widens,
        (Signed | Unsigned, Real) => from.bits() <= 16 || (widens && to == ElementaryType::Lreal),
        _ => false,
    }
}

/// Returns whether one integer type holds every value of another.
fn holds_every_integer(from: ElementaryType, to: ElementaryType) -> bool {
    let (Some((least, greatest)), Some((low, high))) = (from.integer_range(), to.integer_range()) else {
        return false;
    };
    low <= least && greatest <= high
}

const fn said(converts: bool) -> MatrixWord {
    if converts { MatrixWord::Yes } else { MatrixWord::No }
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
#[must_use]
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
