//! The domain of a sweep: finds each input by its place, so that workers need not wait for each other.

use super::operands::{Operands, TextOperands};
use super::texts;
use std::ops::Range;
use stickler_types::boundaries::{BoundaryDetail, neighbourhoods};
use stickler_types::{ElementaryType, SplitMix64, Value};

/// The size and the seed of a sample.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Sampling {
    /// The number of inputs that are sampled beside the chosen ones. `None` takes every input of a source of at most 32 bits, and
    /// [`Sampling::DEFAULT`] of all others. A source of at most 16 bits is never sampled.
    pub inputs: Option<u64>,
    /// The seed; the same seed gives the same inputs.
    pub seed: u64,
    /// The level of detail of the boundary values, which decides the number of neighbours of each.
    pub detail: BoundaryDetail,
}

impl Sampling {
    /// The default size of a sample.
    pub const DEFAULT: u64 = 1_000_000;
}

impl Default for Sampling {
    /// Returns the sampling that takes every input where that is possible, otherwise fine neighbourhoods and the sample of seed 1.
    fn default() -> Sampling {
        Sampling {
            inputs: None,
            seed: 1,
            detail: BoundaryDetail::Fine,
        }
    }
}

/// The inputs of one sweep, in a fixed order.
#[derive(Clone, PartialEq, Debug)]
pub enum Domain {
    /// Every value of a type, in the order of its bits: 0, 1, 2 … and then, for signed types and REAL, the
    /// negative ones; a REAL passes its infinity and its NaNs on the way.
    Every(ElementaryType),
    /// The boundaries of a type with their neighbours, then a sample.
    Some(Operands),
    /// Texts: written by hand, then made up.
    Texts(TextOperands),
    /// Two operands: the boundaries of one type with those of the other, then a sample.
    Pairs {
        /// The inputs of the first operand.
        first: Operands,
        /// The inputs of the second operand.
        second: Operands,
    },
}

impl Domain {
    /// Returns the domain of a function with the given types of operands; an empty one unless there are one or two operands.
    pub fn of(operands: &[ElementaryType], sampling: Sampling) -> Domain {
        let sampled = sampling.inputs.unwrap_or(Sampling::DEFAULT);
        let (random, detail) = (SplitMix64::separate(sampling.seed), sampling.detail);
        match *operands {
            [ty] if ty.is_text() => Domain::Texts(TextOperands::new(ty, texts::by_hand(ty), sampled, random)),
            [ty] if ty.bits() <= 16 || (ty.bits() <= 32 && sampling.inputs.is_none()) => Domain::Every(ty),
            [ty] => Domain::Some(Operands::new(ty, neighbourhoods(ty, detail), sampled, random)),
            [first, second] => Domain::Pairs {
                first: Operands::new(first, neighbourhoods(first, detail), sampled, random.split(1)),
                second: Operands::new(second, neighbourhoods(second, detail), sampled, random.split(2)),
            },
            _ => Domain::Some(Operands::new(ElementaryType::Bool, Vec::new(), 0, random)),
        }
    }

    /// Returns the number of inputs.
    pub fn len(&self) -> u64 {
        match self {
            Domain::Every(ty) => 1 << ty.bits().min(63),
            Domain::Some(operands) => operands.count(),
            Domain::Texts(texts) => texts.count(),
            Domain::Pairs { first, second } => first.chosen() * second.chosen() + first.sampled(),
        }
    }

    /// Returns whether there is no input.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Returns whether the domain has every value of its type.
    pub const fn is_exhaustive(&self) -> bool {
        matches!(self, Domain::Every(_))
    }

    /// Returns the number of inputs that were chosen, by hand or as neighbours of a boundary, and the number of sampled ones;
    /// `None` where the domain has every value of its type.
    pub fn parts(&self) -> Option<(u64, u64)> {
        match self {
            Domain::Every(_) => None,
            Domain::Some(operands) => Some((operands.chosen(), operands.sampled())),
            Domain::Texts(texts) => Some((texts.chosen(), texts.sampled())),
            Domain::Pairs { first, second } => Some((first.chosen() * second.chosen(), first.sampled())),
        }
    }

    /// Returns the operands at a place. Beyond the last place they are further samples.
    pub fn operands(&self, place: u64) -> Vec<Value> {
        match self {
            Domain::Every(ty) => vec![Value::plain(*ty, ty.wrap(place.into()))],
            Domain::Some(operands) => vec![operands.value(place)],
            Domain::Texts(texts) => vec![texts.value(place)],
            Domain::Pairs { first, second } => {
                let (rows, columns) = (first.chosen(), second.chosen());
                match place.checked_sub(rows * columns) {
                    None => vec![first.value(place / columns), second.value(place % columns)],
                    Some(sampled) => vec![first.value(rows + sampled), second.value(columns + sampled)],
                }
            }
        }
    }

    /// Writes the raw forms at the given places, as many as `raws` has room for; nothing where an input is no single raw form.
    pub fn fill(&self, places: Range<u64>, raws: &mut [u64]) {
        match self {
            Domain::Every(ty) => every(*ty, places, raws),
            Domain::Some(operands) => places
                .zip(raws)
                .for_each(|(place, raw)| *raw = operands.raw(place)),
            Domain::Texts(_) | Domain::Pairs { .. } => {}
        }
    }
}

/// Writes the raw forms at the given places of [`Domain::Every`]: the low bits of the place, sign-extended for a signed type.
fn every(ty: ElementaryType, places: Range<u64>, raws: &mut [u64]) {
    let sign = if ty.is_signed() {
        1 << (ty.bits() - 1)
    } else {
        0_u64
    };
    for (place, raw) in places.zip(raws) {
        *raw = (place ^ sign).wrapping_sub(sign);
    }
}
