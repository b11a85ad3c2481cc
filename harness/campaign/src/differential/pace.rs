//! Deciding whether an engine is given several programs at a time, by how long it takes for one.

use std::time::Duration;

/// The number of programs run alone that tell how long one takes.
const SAMPLE_LEN: u32 = 3;

/// The time for one program from which on an engine is slow: it spends its time starting, for a program of a campaign is done
/// in microseconds.
const SLOW_PROGRAM: Duration = Duration::from_millis(20);

/// The number of programs in one pack at most.
const MAX_PACK_LEN: usize = 16;

/// The pace at which an engine is given several programs at a time. It changes how long a campaign takes, not what it finds.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum PackPolicy {
    /// Packs programs where the first ones took long.
    #[default]
    WhereSlow,
    /// Never packs programs.
    Never,
    /// Packs programs from the first one on.
    Always,
}

/// The pace of an engine, as far as it is known.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pace {
    packs: PackPolicy,
    asked: u32,
    spent: Duration,
    width: usize,
}

impl Pace {
    /// Returns a pace of which nothing is known yet.
    pub(super) fn new(packs: PackPolicy) -> Pace {
        Pace {
            packs,
            asked: 0,
            spent: Duration::ZERO,
            width: MAX_PACK_LEN,
        }
    }

    /// Learns the time that a program alone took.
    pub(super) fn took(&mut self, time: Duration) {
        if self.asked < SAMPLE_LEN {
            self.asked += 1;
            self.spent += time;
        }
    }

    /// Returns the number of programs in the next pack; 1 where none are packed.
    pub(super) fn width(self) -> usize {
        let packed = match self.packs {
            PackPolicy::WhereSlow => self.asked == SAMPLE_LEN && self.spent >= SLOW_PROGRAM * SAMPLE_LEN,
            PackPolicy::Never => false,
            PackPolicy::Always => true,
        };
        if packed { self.width } else { 1 }
    }

    /// A pack was agreed with as a whole, or had to be taken apart, which costs more than its programs alone: an engine with
    /// many defects gets smaller packs.
    pub(super) fn packed(&mut self, agreed: bool) {
        self.width = if agreed {
            (self.width * 2).min(MAX_PACK_LEN)
        } else {
            (self.width / 2).max(2)
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_engine_is_slow_when_its_first_programs_took_long() {
        let mut slow = Pace::new(PackPolicy::WhereSlow);
        assert_eq!(slow.width(), 1);
        (0..SAMPLE_LEN).for_each(|_| slow.took(Duration::from_millis(500)));
        assert_eq!(slow.width(), MAX_PACK_LEN);
        let mut quick = Pace::new(PackPolicy::WhereSlow);
        (0..SAMPLE_LEN).for_each(|_| quick.took(Duration::from_micros(50)));
        assert_eq!(quick.width(), 1);
    }

    #[test]
    fn packs_get_smaller_where_they_have_to_be_taken_apart_and_larger_again() {
        let mut pace = Pace::new(PackPolicy::WhereSlow);
        (0..SAMPLE_LEN).for_each(|_| pace.took(Duration::from_millis(500)));
        (0..10).for_each(|_| pace.packed(false));
        assert_eq!(pace.width(), 2);
        (0..10).for_each(|_| pace.packed(true));
        assert_eq!(pace.width(), MAX_PACK_LEN);
    }
}
