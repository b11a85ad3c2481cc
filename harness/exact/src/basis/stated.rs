//! Results of calls that the definition of a user-defined dialect states in place of the documents of its base.
//!
//! A choice *decides* a call if another choice in its place would give another value. Where no choice of the definition
//! decides, the documents apply. Where one does, the result is stated only if every choice that decides it is stated by the
//! definition or by a document: REAL#127.5 to SINT with `rounding = "half-to-even"` is 128, which is out of range, and
//! neither IronPLC nor such a definition states the result.

use super::{Rules, UnaryCall};
use crate::signature::Operation;
use crate::value::value;
use stickler_types::{ConversionChoices, Dialect, ElementaryType, Family, Value};

const TRUNCATION_OUT_OF_RANGE: &str = "conversions.truncation-out-of-range";

impl UnaryCall<'_> {
    /// Returns the basis of the call in a dialect with this definition; `choices` are those of the dialect.
    pub(super) fn stated(
        self,
        operand: &Value,
        dialect: &'static Dialect,
        choices: &ConversionChoices,
    ) -> Option<&'static str> {
        let of = |is_stated: bool| {
            let keys = ConversionChoices::keys().iter().copied();
            keys.filter(move |key| stated_by(key, dialect).is_some() == is_stated)
                .filter(|key| self.is_decided_by(key, operand, choices))
        };
        let stated: Vec<&str> = of(true).collect();
        let Some(first) = stated.first() else {
            return self.basis(operand);
        };
        let is_said = stated.iter().all(|key| self.speaks(key)) && of(false).all(|key| self.documents(key));
        stated_by(first, dialect).filter(|_| is_said)
    }

    /// Returns whether a choice of the definition decides the result of the call.
    pub(super) fn is_overridden(
        self,
        operand: &Value,
        dialect: &'static Dialect,
        choices: &ConversionChoices,
    ) -> bool {
        let mut keys = ConversionChoices::keys().iter();
        keys.any(|key| stated_by(key, dialect).is_some() && self.is_decided_by(key, operand, choices))
    }

    /// Returns whether another choice would change the result.
    fn is_decided_by(self, key: &str, operand: &Value, choices: &ConversionChoices) -> bool {
        let operands = std::slice::from_ref(operand);
        let own = value(self.signature, operands, choices);
        let mut others = choices.others(key);
        others.any(|other| value(self.signature, operands, &other) != own)
    }

    /// Returns whether a definition that makes this choice applies to the function: it applies to `<SRC>_TO_<DST>` and to
    /// the functions that the documents of its base have. It does not decide whether a bit string gets the bits of a real
    /// or its number.
    fn speaks(self, key: &str) -> bool {
        let is_pair =
            self.signature.operation == Operation::Convert && !self.signature.function.starts_with("TO_");
        let (from, to) = (self.from, self.to);
        match key {
            "conversions.rounding" | "conversions.out-of-range" => {
                is_pair && from.is_real() && to.is_integer()
            }
            TRUNCATION_OUT_OF_RANGE => {
                from.is_real() && to.is_integer() && self.basis(&Value::of_real(from, 1.0)).is_some()
            }
            "conversions.text-reading" => {
                is_pair && from.family() == Family::Text && (to.is_whole() || to.is_real())
            }
            "conversions.real-text" => is_pair && from.is_real() && to.family() == Family::Text,
            "conversions.bit-string-text" => is_pair && from.is_bit_string() && to.family() == Family::Text,
            "conversions.moment-text" => is_pair && from.is_moment() && to.family() == Family::Text,
            "conversions.bits-as-real" => {
                is_pair && (from.is_bit_string() && to.is_real() || from.is_real() && to.is_bit_string())
            }
            "conversions.bits-as-integer" => {
                is_pair && (from.is_signed() && to.is_bit_string() || from.is_bit_string() && to.is_signed())
            }
            "conversions.bit-string-as-bool" => is_pair && from.is_bit_string() && to == ElementaryType::Bool,
            "conversions.moment-units" => is_pair && (from.is_moment() || to.is_moment()),
            _ => false,
        }
    }

    /// Returns whether the documents of the base make this choice.
    fn documents(self, key: &str) -> bool {
        match key {
            _ if self.rules == Rules::Plcnext => {
                key != TRUNCATION_OUT_OF_RANGE && self.to.family() != Family::Text
            }
            "conversions.rounding" => matches!(self.rules, Rules::Ironplc | Rules::Matiec),
            "conversions.out-of-range" | TRUNCATION_OUT_OF_RANGE => self.rules == Rules::Matiec,
            "conversions.bits-as-real" => matches!(self.rules, Rules::Rusty | Rules::ThirdEdition),
            "conversions.bit-string-as-bool" => self.rules == Rules::Rusty,
            _ => false,
        }
    }
}

/// Returns the basis of the statement of a choice, if the dialect makes it beside its documents.
fn stated_by(key: &str, dialect: &'static Dialect) -> Option<&'static str> {
    match key {
        TRUNCATION_OUT_OF_RANGE => dialect
            .basis(key)
            .or_else(|| dialect.basis("conversions.out-of-range")),
        _ => dialect.basis(key),
    }
}
