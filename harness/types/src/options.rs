//! The options of the choices in which dialects differ, apart from those of conversions and operators.

use crate::ElementaryType;
use crate::choice::{Choice, choices_of_words, one_of, truth};
use crate::words::words;
use std::borrow::Cow;
use toml::de::DeValue;

words! {
    /// The pairs of elementary types that convert implicitly.
    Widening {
        /// IronPLC's three matrices and its general rule.
        Ironplc = "ironplc-matrices",
        /// No pair at all.
        None = "none",
        /// The coloured table of PLCnext Engineer's SEM1189.
        Plcnext = "plcnext-table",
        /// The paths of the third edition's Figure 12.
        ThirdEdition = "third-edition",
        /// Every pair of numbers and bit strings: what narrows is only warned of.
        Numbers = "numbers",
        /// Every pair of integers and reals.
        IntegersAndReals = "integers-and-reals",
        /// Every pair of numbers, bit strings, durations, dates and times of day: all of them are stored as integers or reals.
        NumbersAndMoments = "numbers-and-moments",
        /// Integers and bit strings into those with as many bits or more, and every number and bit string into REAL and LREAL.
        NumbersUnlessNarrower = "numbers-unless-narrower",
        /// Every pair of numbers and bit strings; BOOL stands for itself alone.
        NumbersApartFromBool = "numbers-apart-from-bool",
        /// Every pair of numbers and bit strings but reals into bit strings; BOOL into all of them, and nothing into BOOL.
        NumbersButNoRealAsBits = "numbers-but-no-real-as-bits",
    }
}

words! {
    /// The treatment of `.%Xn` and its kin.
    PartialAccess {
        /// `.%Xn` selects a bit; the wider forms are P0003.
        BitsOnly = "bits-only",
        /// `.%Xn` selects a bit, `.%Bn`, `.%Wn` and `.%Dn` a byte, a word and a double word; `.%Ln` is P0003.
        UpToDoubleWords = "up-to-double-words",
        /// `.%Ln` selects a long word, too; a part may be as wide as its variable, and a wider one is P4025.
        UpToLongWords = "up-to-long-words",
        /// P4033 for every form.
        Disabled = "disabled",
        /// P0002 for every form.
        SyntaxError = "syntax-error",
    }
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
    #[must_use]
    pub const fn is_enabled(self) -> bool {
        matches!(self, PartialAccess::BitsOnly) || self.has_wider_parts()
    }

    /// Returns whether `.%Bn`, `.%Wn` and `.%Dn` select parts.
    #[must_use]
    pub const fn has_wider_parts(self) -> bool {
        matches!(
            self,
            PartialAccess::UpToDoubleWords | PartialAccess::UpToLongWords
        )
    }
}

words! {
    /// What LEFT, RIGHT, MID, INSERT, DELETE and REPLACE do with a length or a position outside the text.
    TextPositions {
        /// What of the characters lies in the text counts, and no others.
        Clipped = "clipped",
        /// INSERT and REPLACE leave a text as it is where the position is behind it, and INSERT where it is negative; MID of a position before the text
        /// gives no character. The rest is as clipped.
        ///
        /// Basis: codesys-recording: recordings/codesys.run.json (`string_positions_…`, `str_…`).
        Kept = "kept",
        /// A negative length and a position below 1, or of INSERT below 0, give an empty text. The rest is as clipped.
        ///
        /// Basis: siemens-manual-2014: 308 and 312.
        Empty = "empty",
        /// As `empty`, and so does each length or position of which not all characters lie in the text. A result that is longer than the variable to which
        /// it is assigned gives an empty text as well, but that of CONCAT leaves the variable as it is; REPLACE by the variable of the result gives one, too.
        ///
        /// Basis: plcnext-text: CONCAT, DELETE, MID_WSTRING, REPLACE, RIGHT; plcnext-selection: LIMIT.
        Whole = "whole",
    }
}

words! {
    /// The types of the third edition that a dialect has.
    ThirdEditionTypes {
        /// LTIME, LDATE, LTOD, LDT, CHAR and WCHAR.
        All = "all",
        /// All types of the third edition but LDATE, LTOD and LDT.
        ///
        /// Basis: twincat-builds: recordings/twincat.build.json (`prim_default_…`, `xp_…`).
        WithoutLongDates = "without-long-dates",
        /// None of them.
        None = "none",
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

choices_of_words! { Widening, TextPositions, }

/// Words that a dialect does not reserve though others do, in capital letters.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct FreeWords(Vec<String>);

impl FreeWords {
    /// No words: all keywords and names of elementary types are reserved.
    pub const NONE: FreeWords = FreeWords(Vec::new());

    /// Returns whether a word, in any case, is one of these.
    #[must_use]
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
