//! The input at each place of a seed's row: the same on every machine, whoever asks and in whatever order.

use crate::exclusions::Exclusions;
use stickler_generate::generator::{self, GeneratorSettings};
use stickler_generate::model::Program;
use stickler_types::{DialectName, SplitMix64};

/// The number of programs that are tried at a place before it is given up, because all have something excluded.
const ATTEMPTS: u64 = 2000;

/// The inputs of a seed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Inputs {
    seed: u64,
    row: SplitMix64,
    /// The lengths of inputs are so many powers of two from 2 to the [`LEAST_LENGTH`] on.
    lengths: u64,
}

/// The exponent of the least length.
const LEAST_LENGTH: u32 = 5;

impl Inputs {
    /// Returns the inputs of this seed.
    pub const fn new(seed: u64) -> Inputs {
        Inputs {
            seed,
            row: SplitMix64::separate(seed),
            lengths: (Inputs::MAX_LEN.ilog2() - LEAST_LENGTH + 1) as u64,
        }
    }

    /// The number of bytes of the smallest inputs.
    pub const MIN_LEN: usize = 1 << LEAST_LENGTH;

    /// The number of bytes of the largest inputs, unless [`Inputs::up_to`] limits it.
    pub const MAX_LEN: usize = 2048;

    /// Returns the inputs of the same seed with at most so many bytes, which is taken for the power of two below it.
    pub fn up_to(self, length: usize) -> Inputs {
        let length = length.clamp(Inputs::MIN_LEN, Inputs::MAX_LEN);
        Inputs {
            lengths: u64::from(length.ilog2() - LEAST_LENGTH + 1),
            ..self
        }
    }

    /// Returns the seed.
    pub const fn seed(self) -> u64 {
        self.seed
    }

    /// Returns random numbers for the place, which nothing else draws.
    pub const fn draws(self, place: u64) -> SplitMix64 {
        self.row.split(place)
    }

    /// Returns the bytes at this place: from 32 on, short ones as often as long ones, so that small programs come as often as
    /// large ones.
    pub fn bytes(self, place: u64) -> Vec<u8> {
        let draws = self.draws(place);
        let length = draws.at(0) % self.lengths;
        // It is below the number of lengths.
        let length = 1_usize << (LEAST_LENGTH + length as u32);
        (1..)
            .map(|number| draws.at(number))
            .flat_map(u64::to_le_bytes)
            .take(length)
            .collect()
    }

    /// Returns the program at this place, in one of these dialects (in any where none is named).
    pub fn program(self, place: u64, dialects: &[DialectName], open: bool) -> Program {
        let settings = self.settings(place, dialects, open);
        generator::program(&self.bytes(place), &settings)
    }

    /// Returns the program at this place that has nothing of the exclusions; `None` where every attempt has some of it.
    ///
    /// A program that has something excluded is replaced by another one, so nothing of it remains, and a program that never
    /// had it is the same as without exclusions.
    pub fn program_without(
        self,
        place: u64,
        dialects: &[DialectName],
        open: bool,
        without: &Exclusions,
    ) -> Option<Program> {
        let first = self.program(place, dialects, open);
        if without.admits(&first) {
            return Some(first);
        }
        let settings = GeneratorSettings {
            lacking: [without.words(first.dialect), untimed()].concat(),
            ..self.settings(place, dialects, open)
        };
        // A row of rows, at a place from which the first takes nothing.
        let others = Inputs {
            row: self.draws(place).split(u64::MAX - 1),
            ..self
        };
        (0..ATTEMPTS)
            .map(|attempt| generator::program(&others.bytes(attempt), &settings))
            .find(|program| without.admits(program))
    }

    fn settings(self, place: u64, dialects: &[DialectName], open: bool) -> GeneratorSettings {
        let count = dialects.len().max(1) as u64;
        // From the far end of the row, where no byte comes from.
        let drawn = self.draws(place).at(u64::MAX) % count;
        let dialect = usize::try_from(drawn).ok().and_then(|index| dialects.get(index));
        GeneratorSettings {
            dialect: dialect.copied(),
            open,
            lacking: untimed(),
        }
    }
}

/// Returns what programs shall do without that several engines are asked about: most of them have no clock but that of the machine.
fn untimed() -> Vec<String> {
    vec!["timer-blocks".to_owned()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_types::sorted;

    #[test]
    fn an_input_depends_on_seed_and_place_alone() {
        let inputs = Inputs::new(7);
        assert_eq!(inputs.bytes(5), Inputs::new(7).bytes(5));
        assert_ne!(inputs.bytes(5), inputs.bytes(6));
        assert_ne!(inputs.bytes(5), Inputs::new(8).bytes(5));
        let dialects = [DialectName::MATIEC, DialectName::PLCNEXT];
        assert_eq!(
            inputs.program(3, &dialects, false),
            inputs.program(3, &dialects, false)
        );
    }

    #[test]
    fn all_lengths_and_all_dialects_that_are_named_come() {
        let inputs = Inputs::new(1);
        let lengths = sorted((0..200).map(|place| inputs.bytes(place).len()));
        assert_eq!(lengths, [32, 64, 128, 256, 512, 1024, 2048]);
        let shorter = inputs.up_to(300);
        assert_eq!((0..200).map(|place| shorter.bytes(place).len()).max(), Some(256));
        assert_eq!(inputs.up_to(1).bytes(9).len(), 32);
        assert_eq!(inputs.up_to(9999), inputs);
        let named = [DialectName::MATIEC, DialectName::PLCNEXT];
        let dialects = sorted((0..50).map(|place| inputs.program(place, &named, false).dialect));
        assert_eq!(dialects, named);
    }
}
