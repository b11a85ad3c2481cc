//! Passes that make literals smaller.

use crate::TextView;
use stickler_syntax::Edits;
use stickler_syntax::tree::{ExpressionKind, LiteralKind};

/// The number of digits of a duration beyond which it is cut and not halved.
const MANY_DIGITS: usize = 6;

/// A way to make literals smaller.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum LiteralStep {
    /// Writes numbers with a base in decimal, so that a base stays only where it matters.
    Decimal,
    /// Makes numbers 0, and empties texts.
    Zero,
    /// Makes numbers 1.
    One,
    /// Halves numbers, and leaves the first half of texts.
    Half,
    /// Leaves the second half of texts.
    Rest,
    /// Makes numbers one less, and texts one character shorter.
    Less,
}

/// Makes literals smaller.
pub(crate) fn lessen(view: &TextView<'_>, step: LiteralStep) -> Vec<Edits> {
    let mut changes = Vec::new();
    for (_, expression) in view.expressions() {
        let ExpressionKind::Literal(literal) = &expression.kind else {
            continue;
        };
        if let Some(smaller) = smaller(literal.kind, literal.text(), step) {
            let end = expression.span.end as usize;
            changes.push(Edits::replacing(end - literal.text().len()..end, smaller));
        }
    }
    view.only_allowed(changes)
}

/// Leaves out the types of truth values, numbers and texts, so that a type stays only where it matters.
pub(crate) fn drop_types(view: &TextView<'_>) -> Vec<Edits> {
    use LiteralKind::*;
    let mut changes = Vec::new();
    for (_, expression) in view.expressions() {
        if let ExpressionKind::Literal(literal) = &expression.kind
            && let Some(prefix) = literal.prefix()
            && !matches!(literal.kind, Duration | Date | TimeOfDay | DateAndTime)
        {
            let span = prefix.span;
            changes.push(Edits::replacing(span.start as usize..span.end as usize + 1, ""));
        }
    }
    view.only_allowed(changes)
}

/// Returns the text of a literal without its prefix, made smaller; `None` if that changes nothing.
fn smaller(kind: LiteralKind, text: &str, step: LiteralStep) -> Option<String> {
    let smaller = match kind {
        LiteralKind::Integer => {
            let number: i128 = text.replace('_', "").parse().ok()?;
            match step {
                LiteralStep::Decimal | LiteralStep::Rest => return None,
                LiteralStep::Zero => 0,
                LiteralStep::One => 1,
                LiteralStep::Half => number / 2,
                LiteralStep::Less => number - number.signum(),
            }
            .to_string()
        }
        LiteralKind::BasedInteger => {
            let (base, digits) = text.split_once('#')?;
            let base: u32 = base.parse().ok().filter(|base| [2, 8, 16].contains(base))?;
            let number = u128::from_str_radix(&digits.replace('_', ""), base).ok()?;
            let number = match step {
                LiteralStep::Decimal => return Some(number.to_string()),
                LiteralStep::Rest => return None,
                LiteralStep::Zero => 0,
                LiteralStep::One => 1,
                LiteralStep::Half => number / 2,
                LiteralStep::Less => number.saturating_sub(1),
            };
            match base {
                2 => format!("2#{number:b}"),
                8 => format!("8#{number:o}"),
                _ => format!("16#{number:X}"),
            }
        }
        LiteralKind::Real => match step {
            LiteralStep::Decimal | LiteralStep::Rest => return None,
            LiteralStep::Zero => "0.0".to_owned(),
            LiteralStep::One => "1.0".to_owned(),
            // The exponent stays, since it may be what matters.
            LiteralStep::Half => match text.find(['e', 'E']) {
                Some(at) => format!("1.0{}", &text[at..]),
                None => format!("{}.0", text.split('.').next()?),
            },
            LiteralStep::Less => {
                let (before, behind) = text.split_once('.')?;
                format!("{before}.{}", behind.chars().next()?)
            }
        },
        LiteralKind::Duration => {
            let (digits, unit) = text.split_at(text.find(|sign: char| !sign.is_ascii_digit())?);
            let is_one = unit.chars().all(char::is_alphabetic);
            let number = || digits.parse::<u128>().ok().filter(|_| is_one);
            match step {
                LiteralStep::Zero => "0s".to_owned(),
                LiteralStep::One => "1s".to_owned(),
                // So many units are too long in most compilers: the digits that are too many go at once.
                LiteralStep::Half if is_one && digits.len() > MANY_DIGITS => {
                    format!("{}{unit}", &digits[..MANY_DIGITS])
                }
                LiteralStep::Half => format!("{}{unit}", number()? / 2),
                LiteralStep::Less => format!("{}{unit}", number()?.saturating_sub(1)),
                LiteralStep::Decimal | LiteralStep::Rest => return None,
            }
        }
        LiteralKind::SingleByteText | LiteralKind::DoubleByteText => {
            let quote = text.get(..1)?;
            let inner = text.get(1..text.len().checked_sub(1)?)?;
            let characters = characters(inner, if quote == "'" { 2 } else { 4 });
            let number = characters.len();
            let kept = match step {
                LiteralStep::Decimal => return None,
                LiteralStep::Zero => 0..0,
                LiteralStep::One => 0..1,
                LiteralStep::Half => 0..number / 2,
                LiteralStep::Rest => number / 2..number,
                LiteralStep::Less => 0..number.saturating_sub(1),
            };
            format!("{quote}{}{quote}", characters.get(kept)?.concat())
        }
        LiteralKind::Boolean | LiteralKind::Date | LiteralKind::TimeOfDay | LiteralKind::DateAndTime => {
            return None;
        }
    };
    (smaller != text).then_some(smaller)
}

/// Splits a text without its quotes into its characters, each as it is written: `a`, `$L`, `$0A`. `digits` is the number of digits of a
/// character that is written by its number.
fn characters(text: &str, digits: usize) -> Vec<&str> {
    let mut found = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let behind = rest.strip_prefix('$').unwrap_or_default();
        let is_number =
            behind.len() >= digits && behind.bytes().take(digits).all(|digit| digit.is_ascii_hexdigit());
        let length = match behind.chars().next() {
            Some(_) if is_number => 1 + digits,
            Some(escaped) => 1 + escaped.len_utf8(),
            None => first.len_utf8(),
        };
        let (character, others) = rest.split_at(length);
        found.push(character);
        rest = others;
    }
    found
}
