//! Lists of chosen inputs followed by sampled ones, each found by its place.

use super::sample::sampled;
use super::texts;
use stickler_types::{ElementaryType, SplitMix64, Value};

/// The inputs of an operand of a type other than text.
#[derive(Clone, PartialEq, Debug)]
pub struct Operands {
    ty: ElementaryType,
    chosen: Vec<u64>,
    sampled: u64,
    random: SplitMix64,
}

impl Operands {
    /// Makes a list of the chosen raw forms, followed by a number of sampled ones.
    #[must_use]
    pub const fn new(ty: ElementaryType, chosen: Vec<u64>, sampled: u64, random: SplitMix64) -> Operands {
        Operands {
            ty,
            chosen,
            sampled,
            random,
        }
    }

    /// Returns the number of chosen inputs.
    #[must_use]
    pub fn chosen(&self) -> u64 {
        self.chosen.len() as u64
    }

    /// Returns the number of sampled values.
    #[must_use]
    pub const fn sampled(&self) -> u64 {
        self.sampled
    }

    /// Returns the number of inputs, chosen and sampled.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.chosen().saturating_add(self.sampled)
    }

    /// Returns the raw form at a place.
    #[must_use]
    pub fn raw(&self, place: u64) -> u64 {
        match usize::try_from(place)
            .ok()
            .and_then(|place| self.chosen.get(place))
        {
            Some(raw) => *raw,
            None => sampled(self.ty, self.random, place),
        }
    }

    /// Returns the value at a place.
    #[must_use]
    pub fn value(&self, place: u64) -> Value {
        Value::plain(self.ty, self.raw(place))
    }
}

/// The inputs of an operand of type STRING or WSTRING.
#[derive(Clone, PartialEq, Debug)]
pub struct TextOperands {
    ty: ElementaryType,
    chosen: Vec<Vec<u16>>,
    sampled: u64,
    random: SplitMix64,
}

impl TextOperands {
    /// Makes a list of the chosen texts, followed by a number of generated ones.
    #[must_use]
    pub const fn new(
        ty: ElementaryType,
        chosen: Vec<Vec<u16>>,
        sampled: u64,
        random: SplitMix64,
    ) -> TextOperands {
        TextOperands {
            ty,
            chosen,
            sampled,
            random,
        }
    }

    /// Returns the number of chosen inputs.
    #[must_use]
    pub fn chosen(&self) -> u64 {
        self.chosen.len() as u64
    }

    /// Returns the number of generated texts.
    #[must_use]
    pub const fn sampled(&self) -> u64 {
        self.sampled
    }

    /// Returns the number of inputs, chosen and sampled.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.chosen().saturating_add(self.sampled)
    }

    /// Returns the text at a place.
    #[must_use]
    pub fn value(&self, place: u64) -> Value {
        let units = match usize::try_from(place)
            .ok()
            .and_then(|place| self.chosen.get(place))
        {
            Some(units) => units.clone(),
            None => texts::made_up(self.random.split(place)),
        };
        Value::text(self.ty, units)
    }
}
