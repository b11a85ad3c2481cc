//! Lists of chosen inputs followed by sampled ones, each found by its place.

use super::sample::sampled;
use super::texts;
use stickler_types::{ElementaryType, SplitMix64, Value};

/// The inputs of an operand, which are chosen as raw forms or as texts.
#[derive(Clone, PartialEq, Debug)]
pub struct Operands<C = u64> {
    ty: ElementaryType,
    chosen: Vec<C>,
    sampled: u64,
    random: SplitMix64,
}

/// The inputs of an operand of type STRING or WSTRING.
pub type TextOperands = Operands<Vec<u16>>;

impl<C> Operands<C> {
    /// Makes a list of chosen inputs, followed by a number of sampled ones.
    pub const fn new(ty: ElementaryType, chosen: Vec<C>, sampled: u64, random: SplitMix64) -> Operands<C> {
        Operands {
            ty,
            chosen,
            sampled,
            random,
        }
    }

    /// Returns the number of chosen inputs.
    pub fn chosen(&self) -> u64 {
        self.chosen.len() as u64
    }

    /// Returns the number of sampled inputs.
    pub const fn sampled(&self) -> u64 {
        self.sampled
    }

    /// Returns the number of inputs, chosen and sampled.
    pub fn count(&self) -> u64 {
        self.chosen().saturating_add(self.sampled)
    }

    /// Returns the chosen input at a place; `None` where the place is of a sampled one.
    fn chosen_at(&self, place: u64) -> Option<&C> {
        self.chosen.get(usize::try_from(place).ok()?)
    }
}

impl Operands {
    /// Returns the raw form at a place.
    pub fn raw(&self, place: u64) -> u64 {
        match self.chosen_at(place) {
            Some(raw) => *raw,
            None => sampled(self.ty, self.random, place),
        }
    }

    /// Returns the value at a place.
    pub fn value(&self, place: u64) -> Value {
        Value::plain(self.ty, self.raw(place))
    }
}

impl TextOperands {
    /// Returns the text at a place.
    pub fn value(&self, place: u64) -> Value {
        let units = match self.chosen_at(place) {
            Some(units) => units.clone(),
            None => texts::made_up(self.random.split(place)),
        };
        Value::text(self.ty, units)
    }
}
