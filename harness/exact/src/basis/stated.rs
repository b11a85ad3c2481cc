//! Results of calls that the definition of a user-defined dialect states in place of the documents of its base.
//!
//! A choice *decides* a call if another choice in its place would give another value. Where no choice of the definition
//! decides, the documents apply. Where one does, the result is stated only if every choice that decides it is stated by the
//! definition or by a document: REAL#127.5 to SINT with `rounding = "half-to-even"` is 128, which is out of range, and
//! neither IronPLC nor such a definition states the result.

use super::{Rules, UnaryCall};
use crate::signature::Operation;
use crate::value::value;
use stickler_types::{
    BitStringAsBool, BitStringText, BitsAsReal, ConversionChoices, Definition, ElementaryType, Family,
    MomentText, MomentUnits, OutOfRange, RealText, Rounding, Stated, TextReading, Value,
};

/// A choice that a definition may make.
#[derive(Clone, Copy, PartialEq, Eq)]
enum StatedKey {
    Rounding,
    OutOfRange,
    TruncationOutOfRange,
    TextReading,
    RealText,
    BitStringText,
    MomentText,
    BitsAsReal,
    BitStringAsBool,
    MomentUnits,
}

const KEYS: [StatedKey; 10] = [
    StatedKey::Rounding,
    StatedKey::OutOfRange,
    StatedKey::TruncationOutOfRange,
    StatedKey::TextReading,
    StatedKey::RealText,
    StatedKey::BitStringText,
    StatedKey::MomentText,
    StatedKey::BitsAsReal,
    StatedKey::BitStringAsBool,
    StatedKey::MomentUnits,
];

impl UnaryCall<'_> {
    /// Returns the basis of the call in a dialect with this definition; `choices` are those of the dialect.
    pub(super) fn stated(
        self,
        operand: &Value,
        definition: &'static Definition,
        choices: &ConversionChoices,
    ) -> Option<&'static str> {
        let decides = |key: &StatedKey| self.is_decided_by(*key, operand, choices);
        let (stated, left): (Vec<StatedKey>, Vec<StatedKey>) = KEYS
            .into_iter()
            .filter(decides)
            .partition(|key| key.stated_by(definition).is_some());
        let Some(first) = stated.first() else {
            return self.basis(operand);
        };
        let is_said =
            stated.iter().all(|key| self.speaks(*key)) && left.iter().all(|key| self.documents(*key));
        first.stated_by(definition).filter(|_| is_said)
    }

    /// Returns whether a choice of the definition decides the result of the call.
    pub(super) fn is_overridden(
        self,
        operand: &Value,
        definition: &'static Definition,
        choices: &ConversionChoices,
    ) -> bool {
        KEYS.into_iter()
            .any(|key| key.stated_by(definition).is_some() && self.is_decided_by(key, operand, choices))
    }

    /// Returns whether another choice would change the result.
    fn is_decided_by(self, key: StatedKey, operand: &Value, choices: &ConversionChoices) -> bool {
        let operands = std::slice::from_ref(operand);
        let own = value(self.signature, operands, choices);
        key.others(*choices)
            .iter()
            .any(|other| value(self.signature, operands, other) != own)
    }

    /// Returns whether a definition that makes this choice applies to the function: it applies to `<SRC>_TO_<DST>` and to
    /// the functions that the documents of its base have. It does not decide whether a bit string gets the bits of a real
    /// or its number.
    fn speaks(self, key: StatedKey) -> bool {
        let is_pair =
            self.signature.operation == Operation::Convert && !self.signature.function.starts_with("TO_");
        let (from, to) = (self.from, self.to);
        match key {
            StatedKey::Rounding => is_pair && from.is_real() && to.is_integer(),
            StatedKey::OutOfRange => is_pair && from.is_real() && to.is_integer(),
            StatedKey::TruncationOutOfRange => {
                from.is_real() && to.is_integer() && self.basis(&one(from)).is_some()
            }
            StatedKey::TextReading => {
                is_pair
                    && from.family() == Family::Text
                    && (to.is_integer() || to.is_bit_string() || to.is_real())
            }
            StatedKey::RealText => is_pair && from.is_real() && to.family() == Family::Text,
            StatedKey::BitStringText => is_pair && from.is_bit_string() && to.family() == Family::Text,
            StatedKey::MomentText => is_pair && is_moment(from) && to.family() == Family::Text,
            StatedKey::BitsAsReal => {
                is_pair && (from.is_bit_string() && to.is_real() || from.is_real() && to.is_bit_string())
            }
            StatedKey::BitStringAsBool => is_pair && from.is_bit_string() && to == ElementaryType::Bool,
            StatedKey::MomentUnits => is_pair && (is_moment(from) || is_moment(to)),
        }
    }

    /// Returns whether the documents of the base make this choice.
    fn documents(self, key: StatedKey) -> bool {
        match key {
            StatedKey::Rounding => matches!(self.rules, Rules::Ironplc | Rules::Matiec),
            StatedKey::OutOfRange | StatedKey::TruncationOutOfRange => self.rules == Rules::Matiec,
            StatedKey::BitsAsReal => matches!(self.rules, Rules::Rusty | Rules::ThirdEdition),
            StatedKey::BitStringAsBool => self.rules == Rules::Rusty,
            StatedKey::TextReading
            | StatedKey::RealText
            | StatedKey::BitStringText
            | StatedKey::MomentText
            | StatedKey::MomentUnits => false,
        }
    }
}

/// Returns whether a type is a duration, a date, a time of day or both.
fn is_moment(ty: ElementaryType) -> bool {
    ty.is_duration() || ty.is_date_or_time()
}

/// Returns the number 1 of a real type.
fn one(ty: ElementaryType) -> Value {
    let bits = match ty {
        ElementaryType::Real => u64::from(1.0_f32.to_bits()),
        _ => 1.0_f64.to_bits(),
    };
    Value::plain(ty, bits)
}

impl StatedKey {
    /// Returns the basis of the definition's statement, if the definition makes this choice.
    fn stated_by(self, definition: &'static Definition) -> Option<&'static str> {
        fn basis<T>(stated: &'static Option<Stated<T>>) -> Option<&'static str> {
            stated.as_ref()?.basis.as_deref()
        }
        match self {
            StatedKey::Rounding => basis(&definition.conversions.rounding),
            StatedKey::OutOfRange => basis(&definition.conversions.out_of_range),
            StatedKey::TruncationOutOfRange => basis(&definition.conversions.truncation_out_of_range)
                .or_else(|| basis(&definition.conversions.out_of_range)),
            StatedKey::TextReading => basis(&definition.conversions.text_reading),
            StatedKey::RealText => basis(&definition.conversions.real_text),
            StatedKey::BitStringText => basis(&definition.conversions.bit_string_text),
            StatedKey::MomentText => basis(&definition.conversions.moment_text),
            StatedKey::BitsAsReal => basis(&definition.conversions.bits_as_real),
            StatedKey::BitStringAsBool => basis(&definition.conversions.bit_string_as_bool),
            StatedKey::MomentUnits => basis(&definition.conversions.moment_units),
        }
    }

    /// Returns the choices with every alternative for this key; a few numbers of digits represent all.
    fn others(self, choices: ConversionChoices) -> Vec<ConversionChoices> {
        /// Returns the choices with each option in turn.
        fn each<T: Copy>(
            options: &[T],
            choices: ConversionChoices,
            set: impl Fn(&mut ConversionChoices, T),
        ) -> Vec<ConversionChoices> {
            let with = |option: &T| {
                let mut other = choices;
                set(&mut other, *option);
                other
            };
            options.iter().map(with).collect()
        }
        let texts = [
            RealText::Shortest,
            RealText::ByWidth,
            RealText::SignificantDigits(1),
            RealText::SignificantDigits(6),
            RealText::SignificantDigits(17),
        ];
        let all = match self {
            StatedKey::Rounding => each(&Rounding::OF_CONVERSIONS, choices, |all, one| all.rounding = one),
            StatedKey::OutOfRange => each(OutOfRange::ALL, choices, |all, one| all.out_of_range = one),
            StatedKey::TruncationOutOfRange => each(OutOfRange::ALL, choices, |all, one| {
                all.truncation_out_of_range = one;
            }),
            StatedKey::TextReading => each(TextReading::ALL, choices, |all, one| all.text_reading = one),
            StatedKey::RealText => each(&texts, choices, |all, one| all.real_text = one),
            StatedKey::BitStringText => {
                each(BitStringText::ALL, choices, |all, one| all.bit_string_text = one)
            }
            StatedKey::MomentText => each(MomentText::ALL, choices, |all, one| all.moment_text = one),
            StatedKey::BitsAsReal => each(BitsAsReal::ALL, choices, |all, one| all.bits_as_real = one),
            StatedKey::BitStringAsBool => each(BitStringAsBool::ALL, choices, |all, one| {
                all.bit_string_as_bool = one;
            }),
            StatedKey::MomentUnits => each(MomentUnits::ALL, choices, |all, one| all.moment_units = one),
        };
        all.into_iter().filter(|other| *other != choices).collect()
    }
}

#[cfg(test)]
mod tests {
    use crate::{expected, signatures};
    use stickler_types::definition::ConversionOverrides;
    use stickler_types::{Definition, DialectName, OutOfRange, Rounding, Stated, TextReading, Value};

    fn stated<T>(value: T, basis: &str) -> Option<Stated<T>> {
        Some(Stated {
            value,
            basis: Some(basis.to_owned()),
        })
    }

    fn gives(function: &str, operand: &str, dialect: DialectName) -> (String, Option<&'static str>) {
        let operand = Value::parse(operand).unwrap();
        let signatures = signatures(function, dialect);
        let signature = signatures
            .iter()
            .find(|signature| signature.takes(std::slice::from_ref(&operand)))
            .unwrap();
        let expected = expected(signature, &[operand], dialect);
        (expected.value.to_string(), expected.basis)
    }

    #[test]
    fn what_is_stated_is_expected_where_it_decides() {
        let dialect = DialectName::define(Definition {
            conversions: ConversionOverrides {
                rounding: stated(Rounding::HalfToEven, "rounds: rounding"),
                ..ConversionOverrides::default()
            },
            ..Definition::new("rounds", DialectName::IRONPLC_ED3, "here")
        })
        .unwrap();
        let rounding = Some("rounds: rounding");
        let documented = Some("ironplc-conversion-functions: Real to Integer");
        for (function, operand, value, basis) in [
            ("REAL_TO_INT", "REAL#2.5", "INT#2", rounding),
            ("REAL_TO_INT", "REAL#3.5", "INT#4", rounding),
            ("REAL_TO_INT", "REAL#-2.75", "INT#-3", rounding),
            ("REAL_TO_INT", "REAL#3.0", "INT#3", documented),
            // What becomes of 128 nobody says.
            ("REAL_TO_SINT", "REAL#127.5", "SINT#-128", None),
            ("REAL_TO_SINT", "REAL#300.0", "SINT#44", None),
            // No definition speaks of functions that no document has, nor of the bits of a real.
            ("TO_INT", "REAL#3.5", "INT#4", None),
            ("REAL_TO_WORD", "REAL#3.5", "WORD#16#0004", None),
            (
                "TRUNC",
                "REAL#3.5",
                "DINT#3",
                Some("ironplc-standard-functions: trunc"),
            ),
        ] {
            let (got, said) = gives(function, operand, dialect);
            assert_eq!((got.as_str(), said), (value, basis), "{function}({operand})");
        }
    }

    #[test]
    fn what_is_stated_settles_what_documents_leave_open() {
        let dialect = DialectName::define(Definition {
            conversions: ConversionOverrides {
                out_of_range: stated(OutOfRange::Saturate, "saturates: out-of-range"),
                text_reading: stated(TextReading::LeadingNumber, "saturates: text-reading"),
                ..ConversionOverrides::default()
            },
            ..Definition::new("saturates", DialectName::IRONPLC_ED3, "here")
        })
        .unwrap();
        let (outside, text) = (Some("saturates: out-of-range"), Some("saturates: text-reading"));
        for (function, operand, value, basis) in [
            ("REAL_TO_SINT", "REAL#300.0", "SINT#127", outside),
            ("REAL_TO_SINT", "REAL#-1.0E30", "SINT#-128", outside),
            ("TRUNC", "REAL#1.0E30", "DINT#2147483647", outside),
            ("TO_SINT", "REAL#300.0", "SINT#127", None),
            ("STRING_TO_INT", "STRING#'12abc'", "INT#12", text),
            ("STRING_TO_INT", "STRING#'12'", "INT#12", None),
        ] {
            assert_eq!(
                gives(function, operand, dialect),
                (value.to_owned(), basis),
                "{function}({operand})"
            );
        }
        // NaN is 0 whatever is chosen, so nothing is stated of it.
        assert_eq!(
            gives("REAL_TO_SINT", "REAL#NaN", dialect),
            ("SINT#0".to_owned(), None)
        );
    }
}
