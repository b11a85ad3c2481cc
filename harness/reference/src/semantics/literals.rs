//! Literals: the type that one has, and the value that it is read to in the type it takes.
//!
//! Basis: iec-61131-3: Tables 5 to 9; stickler-design: §7 (a sign directly before an untyped literal belongs to
//! it), §8 (untyped literals); ironplc-problem-codes: P2026, P2038, P2039, P2040.

use super::common::settle;
use super::inferred::{Inferred, Magnitude};
use super::lowering::{Lowering, Value};
use super::types::TypeId;
use crate::instruction::Instruction;
use crate::source::Span;
use crate::syntax::tree::{Literal, LiteralKind};
use stickler_types::{Code, ElementaryType, Family, LiteralError, literal};

/// A literal with the sign that stands directly before it.
#[derive(Clone, Copy)]
pub(super) struct Signed<'u> {
    pub(super) literal: &'u Literal<'u>,
    pub(super) negative: bool,
    /// Of the sign and the literal.
    pub(super) span: Span,
}

impl<'m> Lowering<'m> {
    /// The type of a literal by itself.
    pub(super) fn infer_literal(&self, literal: &Literal<'_>, negative: bool) -> Inferred {
        if let Some(prefix) = literal.prefix() {
            let ty = ElementaryType::from_literal_prefix(prefix.text);
            return match ty.filter(|&ty| self.model.source.dialect.has(ty)) {
                Some(ty) => Inferred::from(ty),
                None => Inferred::Error,
            };
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

    /// Pushes the value of a literal in the type that it has or takes.
    pub(super) fn literal(&mut self, signed: Signed<'m>, wanted: Option<TypeId>) -> Value {
        let literal = signed.literal;
        if let Some(prefix) = literal.prefix() {
            return match ElementaryType::from_literal_prefix(prefix.text) {
                Some(ty) if self.model.source.dialect.has(ty) => self.literal_of(signed, ty),
                Some(ty) => {
                    let message = format!("{} is a type of the third edition", ty.name());
                    self.report(Code::Std2013Feature, signed.span, message);
                    Value::ERROR
                }
                None => {
                    let message = format!("`{}` is no type of a literal", prefix.text);
                    self.report(Code::UndeclaredUnknownType, prefix.span, message);
                    Value::ERROR
                }
            };
        }
        let inferred = self.infer_literal(literal, signed.negative);
        let ty = match inferred {
            Inferred::Text { wide, single } => {
                let wanted = wanted.and_then(TypeId::elementary);
                Some(
                    wanted
                        .filter(|ty| single && ty.is_character())
                        .unwrap_or(text_type(wide)),
                )
            }
            Inferred::Known(ty) => ty.elementary(),
            _ => settle(inferred, wanted),
        };
        match ty {
            Some(ty) => self.literal_of(signed, ty),
            None => Value::ERROR,
        }
    }

    fn literal_of(&mut self, signed: Signed<'m>, ty: ElementaryType) -> Value {
        match ty.family() {
            Family::Boolean | Family::Signed | Family::Unsigned | Family::BitString => {
                self.integer_literal(signed, ty)
            }
            Family::Text | Family::Character => self.text_literal(signed, ty),
            _ => match read(signed, ty) {
                Ok(raw) => {
                    self.emit(Instruction::Push(raw));
                    Value::of(ty)
                }
                Err(error) => self.misread(signed, ty, error),
            },
        }
    }

    fn integer_literal(&mut self, signed: Signed<'m>, ty: ElementaryType) -> Value {
        let literal = signed.literal;
        let value = match literal.kind {
            LiteralKind::Boolean => Ok(i128::from(literal.text().eq_ignore_ascii_case("TRUE"))),
            LiteralKind::Integer | LiteralKind::BasedInteger if literal.prefix().is_some() => {
                literal::integer(literal.text())
            }
            LiteralKind::Integer | LiteralKind::BasedInteger => {
                untyped_integer(literal.text(), signed.negative)
                    .ok_or(LiteralError::Overflow { at: 0, range: "" })
            }
            _ => Err(LiteralError::Overflow { at: 0, range: "" }),
        };
        match (value, ty.integer_range()) {
            (Ok(value), Some((low, high))) if (low..=high).contains(&value) => {
                self.emit(Instruction::Push(ty.wrap(value)));
                Value {
                    ty: TypeId::of(ty),
                    constant: Some(value),
                }
            }
            (Ok(_), Some((low, high))) => {
                let text = self.excerpt(signed.span);
                let message = format!("{text} does not fit {} ({low}..{high})", ty.name());
                self.report(Code::ConstantOverflow, signed.span, message);
                Value::ERROR
            }
            (Err(error), _) => self.misread(signed, ty, error),
            (Ok(_), None) => Value::ERROR,
        }
    }

    fn text_literal(&mut self, signed: Signed<'m>, ty: ElementaryType) -> Value {
        let literal = signed.literal;
        let wide = matches!(ty, ElementaryType::Wstring | ElementaryType::Wchar);
        if wide != (literal.kind == LiteralKind::DoubleByteText) {
            let quotes = if wide { "double" } else { "single" };
            let message = format!("a literal of {} stands in {quotes} quotes", ty.name());
            self.report(Code::StringEncodingMismatch, signed.span, message);
            return Value::ERROR;
        }
        match literal::text(literal.text()) {
            Ok(units) if ty.is_text() => {
                self.emitter.push_text(units);
                Value::of(ty)
            }
            Ok(units) => match units[..] {
                [unit] => {
                    self.emit(Instruction::Push(unit.into()));
                    Value::of(ty)
                }
                _ => {
                    let message = format!("a {} is one character, not {}", ty.name(), units.len());
                    self.report(Code::ConstantOverflow, signed.span, message);
                    Value::ERROR
                }
            },
            Err(error) => self.misread(signed, ty, error),
        }
    }

    /// Says why a literal could not be read. Its form has been looked at by the lexer, so that as a rule it is
    /// the range.
    fn misread(&mut self, signed: Signed<'m>, ty: ElementaryType, error: LiteralError) -> Value {
        let text = self.excerpt(signed.span);
        let (code, message) = match error {
            LiteralError::Overflow { .. } => {
                let code = match ty.family() {
                    Family::Real => Code::RealLiteralOutOfRange,
                    Family::Duration => Code::DurationLiteralOutOfRange,
                    Family::Date | Family::TimeOfDay | Family::DateAndTime => Code::DateLiteralOutOfRange,
                    _ => Code::ConstantOverflow,
                };
                (code, format!("{text} does not fit {}", ty.name()))
            }
            LiteralError::Character { .. } => (
                Code::StringLiteralCharOutOfRange,
                "a character does not fit a single byte".to_owned(),
            ),
            LiteralError::Escape { .. } => (Code::InvalidStringEscape, error.to_string()),
            LiteralError::Malformed { .. } => (Code::SyntaxError, error.to_string()),
        };
        self.report(code, signed.span, message);
        Value::ERROR
    }

    /// The source text of a span, cut where it is long.
    fn excerpt(&self, span: Span) -> String {
        const LONGEST: usize = 40;
        let text = span.text(self.model.source.text);
        match text.char_indices().nth(LONGEST) {
            Some((end, _)) => format!("`{}…`", &text[..end]),
            None => format!("`{text}`"),
        }
    }
}

/// The value of a literal whose raw form is neither an integer nor a text.
fn read(signed: Signed<'_>, ty: ElementaryType) -> Result<u64, LiteralError> {
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
        Family::Duration => literal::duration(text).map(i64::cast_unsigned),
        Family::Date => literal::date(text).map(i64::cast_unsigned),
        Family::TimeOfDay => literal::time_of_day(text).map(i64::cast_unsigned),
        _ => literal::date_and_time(text).map(i64::cast_unsigned),
    }
}

/// A number as a real, rounded once from its digits.
fn real(literal: &Literal<'_>, ty: ElementaryType) -> Result<u64, LiteralError> {
    match literal.kind {
        LiteralKind::Real => literal::real(literal.text(), ty),
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

/// The number of an untyped integer literal with its sign; `None` where 128 bits do not hold it.
fn untyped_integer(text: &str, negative: bool) -> Option<i128> {
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
