//! Real numbers that an expectation states up to some units in the last place.
//!
//! Basis: rule: reals-within-units.

use crate::elementary::ElementaryType;
use crate::literal::LiteralError;
use crate::value::{Value, WITHIN};

impl Value {
    /// Parses what an expectation states of a value: what [`Value::parse`] reads, or `REAL#1.4142135 within 2`.
    ///
    /// # Errors
    /// As [`Value::parse`]; and [`LiteralError::Malformed`] where a number of units stands behind what is no finite real number, or `within` before
    /// what is no such number from 1 to 1000.
    pub fn parse_expected(text: &str) -> Result<Value, LiteralError> {
        let Some((literal, units)) = text.split_once(WITHIN).filter(|_| !text.contains(['\'', '"'])) else {
            return Value::parse(text);
        };
        let units = units
            .trim()
            .parse()
            .ok()
            .filter(|units| (1..=1000).contains(units));
        let units = units.ok_or(LiteralError::malformed(
            literal.len() + WITHIN.len(),
            "a number of units in the last place from 1 to 1000",
        ))?;
        match Value::parse(literal.trim_end())? {
            Value::Plain { ty, raw } if rank(ty, raw).is_some() => Ok(Value::Near { ty, raw, units }),
            _ => Err(LiteralError::malformed(
                0,
                "a finite REAL or LREAL before `within`",
            )),
        }
    }

    /// Returns whether an engine may give a value where this one is expected: an equal one, or one that is so near.
    pub fn admits(&self, given: &Value) -> bool {
        match (self, given) {
            (&Value::Near { ty, raw, units }, &Value::Plain { ty: of, raw: given }) => {
                let ranks = rank(ty, raw).zip(rank(of, given));
                ty == of && ranks.is_some_and(|(one, other)| one.abs_diff(other) <= u128::from(units))
            }
            _ => self == given,
        }
    }
}

/// Returns the place of a finite real number among those of its type, in their order; both zeros have the same. `None` for all other values.
fn rank(ty: ElementaryType, raw: u64) -> Option<i128> {
    let infinity = match ty {
        ElementaryType::Real => u64::from(f32::INFINITY.to_bits()),
        ElementaryType::Lreal => f64::INFINITY.to_bits(),
        _ => return None,
    };
    let sign = 1_u64 << (ty.bits() - 1);
    let magnitude = raw & !sign;
    let rank = i128::from(magnitude);
    (magnitude < infinity).then_some(if raw & sign == 0 { rank } else { -rank })
}
