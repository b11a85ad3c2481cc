//! Literals: the type that one has, and the value that it is read to in the type it takes.
//!
//! Basis: iec-61131-3: Tables 5 to 9; rule: literal-as-operand (a sign directly before one belongs to
//! it); ironplc-problem-codes: P2026, P2038, P2039, P2040.

use super::common::settle;
use super::inferred::{Inferred, Magnitude};
use super::lowering::{LoweredValue, Lowering};
use super::types::TypeId;
use crate::instruction::Instruction;
use std::borrow::Cow;
use stickler_syntax::diagnostic::{SpannedDiagnostic, quoted};
use stickler_syntax::source::Span;
use stickler_syntax::tree::{Literal, LiteralKind};
use stickler_types::{Code, Dialect, ElementaryType, Family, LiteralError, MomentUnits, literal};

/// A literal with the sign that stands directly before it.
#[derive(Clone, Copy)]
pub(super) struct Signed<'u> {
    pub(super) literal: &'u Literal<'u>,
    pub(super) negative: bool,
    /// The span of the sign and the literal.
    pub(super) span: Span,
}

impl<'u> Signed<'u> {
    pub(super) const fn new(literal: &'u Literal<'u>, negative: bool, span: Span) -> Signed<'u> {
        Signed {
            literal,
            negative,
            span,
        }
    }

    fn refused(self, code: Code, message: String) -> SpannedDiagnostic {
        SpannedDiagnostic::new(code, self.span, message)
    }
}

/// The value of a literal.
pub(super) enum LiteralValue {
    /// A raw form.
    Plain(u64),
    /// Code units.
    Text(Vec<u16>),
}

impl<'m> Lowering<'m> {
    /// Infers the type of a literal by itself.
    pub(super) fn infer_literal(&self, literal: &Literal<'_>, negative: bool) -> Inferred {
        inferred_literal(literal, negative, self.model.source.dialect)
    }

    /// Pushes the value of a literal in the type that it has or takes.
    pub(super) fn literal(&mut self, signed: Signed<'m>, wanted: Option<TypeId>) -> LoweredValue {
        let source = self.model.source;
        let wanted = wanted.and_then(TypeId::elementary);
        let read = literal_type(signed, wanted, source.dialect)
            .and_then(|ty| Ok((ty, read_literal(signed, ty, source.text, source.dialect)?)));
        match read {
            Ok((ty, LiteralValue::Plain(raw))) => {
                self.emit(Instruction::Push(raw));
                LoweredValue {
                    ty: TypeId::of(ty),
                    constant: counts(ty).then(|| ty.integer_value(raw)),
                }
            }
            Ok((ty, LiteralValue::Text(units))) => {
                self.emitter.push_text(units);
                LoweredValue::of(ty)
            }
            Err(diagnostic) => {
                self.reporter.push(diagnostic);
                LoweredValue::ERROR
            }
        }
    }
}

/// Infers the type of a literal by itself.
pub(super) fn inferred_literal(literal: &Literal<'_>, negative: bool, dialect: &Dialect) -> Inferred {
    if let Some(prefix) = literal.prefix() {
        let ty = ElementaryType::from_literal_prefix(prefix.text);
        return ty
            .filter(|&ty| dialect.may_name(ty))
            .map_or(Inferred::Error, Inferred::from);
    }
    match literal.kind {
        LiteralKind::Integer | LiteralKind::BasedInteger => {
            let value = untyped_integer(literal.text(), negative);
            Inferred::Integer(value.map_or(Magnitude::Ulint, Magnitude::of))
        }
        LiteralKind::Real => Inferred::Real,
        LiteralKind::Boolean => Inferred::Known(TypeId::BOOL),
        LiteralKind::SingleByteText => text_literal(literal.text(), false),
        LiteralKind::DoubleByteText => text_literal(literal.text(), true),
        LiteralKind::Duration => Inferred::from(ElementaryType::Time),
        LiteralKind::Date => Inferred::from(ElementaryType::Date),
        LiteralKind::TimeOfDay => Inferred::from(ElementaryType::Tod),
        LiteralKind::DateAndTime => Inferred::from(ElementaryType::Dt),
    }
}

/// Returns the type that a literal has, or takes where another is wanted.
pub(super) fn literal_type(
    signed: Signed<'_>,
    wanted: Option<ElementaryType>,
    dialect: &Dialect,
) -> Result<ElementaryType, SpannedDiagnostic> {
    let literal = signed.literal;
    if let Some(prefix) = literal.prefix() {
        return match ElementaryType::from_literal_prefix(prefix.text) {
            Some(ty) if dialect.may_name(ty) => Ok(ty),
            Some(ty) => {
                let (code, message) = missing_type(ty, dialect);
                Err(SpannedDiagnostic::new(code, signed.span, message))
            }
            None => {
                let message = format!("`{}` is no type of a literal", prefix.text);
                Err(SpannedDiagnostic::new(
                    Code::UndeclaredUnknownType,
                    prefix.span,
                    message,
                ))
            }
        };
    }
    Ok(match inferred_literal(literal, signed.negative, dialect) {
        Inferred::Text { wide, single } => wanted
            .filter(|ty| single && ty.is_character())
            .unwrap_or(text_type(wide)),
        // Whatever is no untyped number either is of a type.
        inferred => inferred
            .elementary()
            .or_else(|| settle(inferred, wanted.map(TypeId::of)))
            .unwrap_or(ElementaryType::Dint),
    })
}

/// Reads the value of a literal in its type; `text` is the source text.
pub(super) fn read_literal(
    signed: Signed<'_>,
    ty: ElementaryType,
    text: &str,
    dialect: &Dialect,
) -> Result<LiteralValue, SpannedDiagnostic> {
    match ty.family() {
        _ if counts(ty) => integer_literal(signed, ty, text, dialect).map(LiteralValue::Plain),
        Family::Text | Family::Character => quoted_literal(signed, ty, text, dialect),
        Family::Real if dialect.literals_by_width && signed.literal.prefix().is_none() => {
            read(signed, ty, dialect)
                .or_else(|error| {
                    read(signed, ElementaryType::Lreal, dialect)
                        .map(as_real)
                        .map_err(|_| error)
                })
                .map(LiteralValue::Plain)
                .map_err(|error| misread(signed, ty, text, error))
        }
        _ => read(signed, ty, dialect)
            .map(LiteralValue::Plain)
            .map_err(|error| misread(signed, ty, text, error)),
    }
}

/// Returns whether the values of a type are written as whole numbers.
fn counts(ty: ElementaryType) -> bool {
    matches!(
        ty.family(),
        Family::Boolean | Family::Signed | Family::Unsigned | Family::BitString
    )
}

fn integer_literal(
    signed: Signed<'_>,
    ty: ElementaryType,
    text: &str,
    dialect: &Dialect,
) -> Result<u64, SpannedDiagnostic> {
    let literal = signed.literal;
    let value = match literal.kind {
        LiteralKind::Boolean => Ok(i128::from(literal.text().eq_ignore_ascii_case("TRUE"))),
        LiteralKind::Integer | LiteralKind::BasedInteger if literal.prefix().is_some() => {
            literal::integer(literal.text())
        }
        LiteralKind::Integer | LiteralKind::BasedInteger => untyped_integer(literal.text(), signed.negative)
            .ok_or(LiteralError::Overflow { at: 0, range: "" }),
        _ => Err(LiteralError::Overflow { at: 0, range: "" }),
    };
    let value = value.map_err(|error| misread(signed, ty, text, error))?;
    let (low, high) = ty.integer_range().unwrap_or((0, 0));
    // A number with the bits of the type, whatever its sign.
    let of_width = -(1_i128 << (ty.bits() - 1))..1_i128 << ty.bits();
    let has_its_bits = dialect.literals_wrap || dialect.literals_by_width && of_width.contains(&value);
    let stands_for_bits = has_its_bits && literal.prefix().is_none() && ty != ElementaryType::Bool;
    if (low..=high).contains(&value) || stands_for_bits {
        return Ok(ty.wrap(value));
    }
    let written = quoted(signed.span.text(text));
    let message = format!("{written} does not fit {} ({low}..{high})", ty.name());
    Err(signed.refused(Code::ConstantOverflow, message))
}

fn quoted_literal(
    signed: Signed<'_>,
    ty: ElementaryType,
    text: &str,
    dialect: &Dialect,
) -> Result<LiteralValue, SpannedDiagnostic> {
    let literal = signed.literal;
    let wide = matches!(ty, ElementaryType::Wstring | ElementaryType::Wchar);
    let by_prefix = dialect.texts_by_prefix && literal.prefix().is_some();
    if wide != (literal.kind == LiteralKind::DoubleByteText) && !by_prefix {
        let quotes = if wide { "double" } else { "single" };
        let message = format!("a literal of {} stands in {quotes} quotes", ty.name());
        return Err(signed.refused(Code::StringEncodingMismatch, message));
    }
    match literal::characters(literal.text(), wide) {
        Ok(units) if ty.is_text() => Ok(LiteralValue::Text(units)),
        Ok(units) => match units[..] {
            [unit] => Ok(LiteralValue::Plain(unit.into())),
            _ => {
                let message = format!("a {} is one character, not {}", ty.name(), units.len());
                Err(signed.refused(Code::ConstantOverflow, message))
            }
        },
        Err(LiteralError::Character { .. }) if dialect.utf8_texts => {
            let message = "characters beyond Latin-1 in a STRING, which holds UTF-8, are not implemented";
            Err(signed.refused(Code::NotImplemented, message.to_owned()))
        }
        Err(error) => Err(misread(signed, ty, text, error)),
    }
}

/// Says why a literal could not be read. Its form has been looked at by the lexer, so that as a rule it is the
/// range.
fn misread(signed: Signed<'_>, ty: ElementaryType, text: &str, error: LiteralError) -> SpannedDiagnostic {
    let (code, message) = match error {
        LiteralError::Overflow { range, .. } => {
            let code = match ty.family() {
                Family::Real => Code::RealLiteralOutOfRange,
                Family::Duration => Code::DurationLiteralOutOfRange,
                Family::Date | Family::TimeOfDay | Family::DateAndTime => Code::DateLiteralOutOfRange,
                _ => Code::ConstantOverflow,
            };
            let written = quoted(signed.span.text(text));
            // Of a date or a time of day one part may be at fault.
            let part = match range.starts_with("the ") {
                true => format!(": outside {range}"),
                false => String::new(),
            };
            (code, format!("{written} does not fit {}{part}", ty.name()))
        }
        LiteralError::Character { .. } => (
            Code::StringLiteralCharOutOfRange,
            "a character does not fit a single byte".to_owned(),
        ),
        LiteralError::Escape { .. } => (Code::InvalidStringEscape, error.to_string()),
        LiteralError::Malformed { .. } => (Code::SyntaxError, error.to_string()),
    };
    SpannedDiagnostic::new(code, signed.span, message)
}

/// Reads a literal whose raw form is neither an integer nor a text.
fn read(signed: Signed<'_>, ty: ElementaryType, dialect: &Dialect) -> Result<u64, LiteralError> {
    let text = signed.literal.text();
    match ty.family() {
        Family::Real => {
            let raw = real(signed.literal, ty)?;
            let sign = if ty == ElementaryType::Real {
                1 << 31
            } else {
                1 << 63
            };
            Ok(if signed.negative { raw ^ sign } else { raw })
        }
        Family::Duration => {
            let nanoseconds = literal::wide_duration(text)?;
            let is_fine = text.contains(['u', 'U', 'n', 'N']) && ty == ElementaryType::Time;
            if is_fine && !dialect.fine_time_literals {
                let expected = "milliseconds, the least unit of TIME";
                return Err(LiteralError::Malformed { at: 0, expected });
            }
            // There LTIME is a count without a sign.
            let is_count = ty.is_third_edition() && dialect.conversions.moment_units == MomentUnits::Counts;
            let fits = i64::try_from(nanoseconds).is_ok() || is_count && u64::try_from(nanoseconds).is_ok();
            let beyond = LiteralError::Overflow { at: 0, range: "" };
            fits.then_some(nanoseconds as u64).ok_or(beyond)
        }
        Family::Date => literal::date(text).map(i64::cast_unsigned),
        // The lexer lets the seconds be left out only where the dialect does.
        Family::TimeOfDay => literal::time_of_day(&literal::with_seconds(text)).map(i64::cast_unsigned),
        _ => literal::date_and_time(&literal::with_seconds(text)).map(i64::cast_unsigned),
    }
}

/// Returns the REAL of an LREAL, which is infinity where it is too large.
fn as_real(raw: u64) -> u64 {
    u64::from((f64::from_bits(raw) as f32).to_bits())
}

/// Reads a number as a real, rounded once from its digits.
pub(super) fn real(literal: &Literal<'_>, ty: ElementaryType) -> Result<u64, LiteralError> {
    match literal.kind {
        LiteralKind::Real => literal::real(&with_point(literal.text()), ty),
        LiteralKind::Integer => literal::real(&format!("{}.0", literal.text()), ty),
        _ => {
            let value = literal::unsigned_integer(literal.text())?;
            let (raw, finite) = if ty == ElementaryType::Real {
                (u64::from((value as f32).to_bits()), (value as f32).is_finite())
            } else {
                ((value as f64).to_bits(), true)
            };
            if finite {
                Ok(raw)
            } else {
                Err(LiteralError::Overflow { at: 0, range: "" })
            }
        }
    }
}

/// Reads the number of an untyped integer literal with its sign; `None` where 128 bits do not hold it.
pub(super) fn untyped_integer(text: &str, negative: bool) -> Option<i128> {
    let magnitude = literal::unsigned_integer(text).ok()?;
    if negative {
        0_i128.checked_sub_unsigned(magnitude)
    } else {
        i128::try_from(magnitude).ok()
    }
}

fn text_literal(quoted: &str, wide: bool) -> Inferred {
    let single = quoted.len() <= 7 && literal::text(quoted).is_ok_and(|units| units.len() == 1);
    Inferred::Text { wide, single }
}

/// STRING or WSTRING.
pub(super) fn text_type(wide: bool) -> ElementaryType {
    if wide {
        ElementaryType::Wstring
    } else {
        ElementaryType::String
    }
}

/// Returns a real number with the point that some dialects let it do without: `1.0E5` for `1E5`.
fn with_point(text: &str) -> Cow<'_, str> {
    match text.find(['e', 'E']) {
        Some(exponent) if !text.contains('.') => {
            format!("{}.0{}", &text[..exponent], &text[exponent..]).into()
        }
        _ => text.into(),
    }
}

/// Returns what is wrong with the use of an elementary type that the dialect does not have.
pub(super) fn missing_type(ty: ElementaryType, dialect: &Dialect) -> (Code, String) {
    let name = ty.name();
    if dialect.has(ty) {
        let message = format!("{} does not have the type {name}", dialect.spelling);
        return (Code::UndeclaredUnknownType, message);
    }
    (
        Code::Std2013Feature,
        format!("{name} is a type of the third edition"),
    )
}
