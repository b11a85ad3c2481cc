//! The options of the choices in which dialects differ: the enumerations of `options.toml`, and what else is chosen.

use crate::ElementaryType;
use crate::choice::{Choice, choices_of_words, one_of, truth};
use crate::words::words;
use std::borrow::Cow;
use toml::de::DeValue;

include!(concat!(env!("OUT_DIR"), "/options.rs"));

choices_of_words! {
    Rounding: &Rounding::OF_CONVERSIONS,
    OutOfRange,
    TextReading,
    BitStringText,
    MomentText,
    BitsAsReal,
    BitsAsInteger,
    BitStringAsBool,
    MomentUnits,
    Widening,
    TextPositions,
    TextElements,
    ImplicitWarnings,
    OperandTypes,
    ComparedTypes,
    ResultSigns,
    ConstantTypes,
    ShiftCounts,
    DocumentedImplicit,
    DocumentedFunctions,
}

impl Rounding {
    /// The roundings that a dialect may choose for `<REAL>_TO_<INTEGER>`; the others belong to CEIL and FLOOR.
    pub const OF_CONVERSIONS: [Rounding; 3] = [
        Rounding::Truncate,
        Rounding::HalfToEven,
        Rounding::HalfAwayFromZero,
    ];
}

impl Choice for PartialAccess {
    fn state(&mut self, key: &str, value: &DeValue<'_>) -> Result<(), String> {
        *self = match key.starts_with("flags.") {
            false => one_of(value, &PartialAccess::ALL, PartialAccess::as_str)?,
            true if !truth(value)? => PartialAccess::Disabled,
            // The forms that are enabled already stay.
            true if self.is_enabled() => *self,
            true => PartialAccess::BitsOnly,
        };
        Ok(())
    }

    fn written(&self, key: &str) -> Cow<'static, str> {
        match key.starts_with("flags.") {
            true => self.is_enabled().to_string().into(),
            false => self.as_str().into(),
        }
    }
}

impl PartialAccess {
    /// Returns whether `.%Xn` selects a bit.
    pub const fn is_enabled(self) -> bool {
        matches!(self, PartialAccess::BitsOnly) || self.has_wider_parts()
    }

    /// Returns whether `.%Bn`, `.%Wn` and `.%Dn` select parts.
    pub const fn has_wider_parts(self) -> bool {
        matches!(
            self,
            PartialAccess::UpToDoubleWords | PartialAccess::UpToLongWords
        )
    }
}

impl Choice for ThirdEditionTypes {
    fn state(&mut self, key: &str, value: &DeValue<'_>) -> Result<(), String> {
        *self = match key.starts_with("flags.") {
            false => one_of(value, &ThirdEditionTypes::ALL, ThirdEditionTypes::as_str)?,
            true if truth(value)? => ThirdEditionTypes::All,
            true => ThirdEditionTypes::None,
        };
        Ok(())
    }

    fn written(&self, key: &str) -> Cow<'static, str> {
        match key.starts_with("flags.") {
            true => (*self != ThirdEditionTypes::None).to_string().into(),
            false => self.as_str().into(),
        }
    }
}

impl ThirdEditionTypes {
    /// Returns whether a type of the third edition is among them.
    pub(crate) const fn includes(self, ty: ElementaryType) -> bool {
        match self {
            ThirdEditionTypes::All => true,
            ThirdEditionTypes::WithoutLongDates => !ty.is_date_or_time(),
            ThirdEditionTypes::None => false,
        }
    }
}

/// Words that a dialect does not reserve though others do, in capital letters.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct FreeWords(Vec<String>);

impl FreeWords {
    /// No words: all keywords and names of elementary types are reserved.
    pub const NONE: FreeWords = FreeWords(Vec::new());

    /// Returns whether a word, in any case, is one of these.
    pub fn contain(&self, word: &str) -> bool {
        self.0.iter().any(|free| free.eq_ignore_ascii_case(word))
    }
}

impl Choice for FreeWords {
    fn state(&mut self, _: &str, value: &DeValue<'_>) -> Result<(), String> {
        let wrong = || "must be a list of words in quotes: `[\"ON\", \"TASK\"]`".to_owned();
        let words = value.as_array().ok_or_else(wrong)?.iter();
        let words = words.map(|word| word.get_ref().as_str().map(str::to_ascii_uppercase));
        self.0 = words.collect::<Option<_>>().ok_or_else(wrong)?;
        Ok(())
    }

    fn written(&self, _: &str) -> Cow<'static, str> {
        format!("{:?}", self.0).into()
    }
}
