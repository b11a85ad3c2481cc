//! Chosen inputs followed by sampled ones, each to be had by its place.

use super::choose::sampled;
use super::texts;
use stickler_types::{ElementaryType, SplitMix64, Value};

/// Values of one type that is no text.
#[derive(Clone, PartialEq, Debug)]
pub struct Operands {
    ty: ElementaryType,
    chosen: Vec<u64>,
    sampled: u64,
    random: SplitMix64,
}

impl Operands {
    /// Makes a list of the chosen raw forms, followed by so many of the sample.
    #[must_use]
    pub const fn new(ty: ElementaryType, chosen: Vec<u64>, sampled: u64, random: SplitMix64) -> Operands {
        Operands {
            ty,
            chosen,
            sampled,
            random,
        }
    }

    /// Returns how many were chosen.
    #[must_use]
    pub fn chosen(&self) -> u64 {
        self.chosen.len() as u64
    }

    /// Returns how many are sampled.
    #[must_use]
    pub const fn sampled(&self) -> u64 {
        self.sampled
    }

    /// Returns how many there are, chosen and sampled.
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

/// Texts of one width.
#[derive(Clone, PartialEq, Debug)]
pub struct Texts {
    ty: ElementaryType,
    chosen: Vec<Vec<u16>>,
    sampled: u64,
    random: SplitMix64,
}

impl Texts {
    /// Makes a list of the chosen texts, followed by so many made-up ones.
    #[must_use]
    pub const fn new(ty: ElementaryType, chosen: Vec<Vec<u16>>, sampled: u64, random: SplitMix64) -> Texts {
        Texts {
            ty,
            chosen,
            sampled,
            random,
        }
    }

    /// Returns how many were chosen.
    #[must_use]
    pub fn chosen(&self) -> u64 {
        self.chosen.len() as u64
    }

    /// Returns how many are made up.
    #[must_use]
    pub const fn sampled(&self) -> u64 {
        self.sampled
    }

    /// Returns how many there are, chosen and sampled.
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
