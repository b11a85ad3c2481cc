//! How long an engine takes for a program, and whether it pays to give it several at a time.

use std::time::Duration;

/// So many programs alone tell how long one takes.
const SAMPLE_LEN: u32 = 3;

/// From here on an engine spends its time starting, not working: a program of a campaign is done in microseconds.
const SLOW_PROGRAM: Duration = Duration::from_millis(20);

/// So many programs at most stand in one pack.
const MAX_PACK_LEN: usize = 16;

/// When an engine is given several programs at a time. It changes how long a campaign takes, not what it finds.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum PackPolicy {
    /// Where its first programs took long.
    #[default]
    WhereSlow,
    /// Never.
    Never,
    /// From the first program on.
    Always,
}

/// What is known of the pace of an engine.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pace {
    packs: PackPolicy,
    asked: u32,
    spent: Duration,
    width: usize,
}

impl Pace {
    /// Nothing is known yet.
    pub(super) fn new(packs: PackPolicy) -> Pace {
        Pace {
            packs,
            asked: 0,
            spent: Duration::ZERO,
            width: MAX_PACK_LEN,
        }
    }

    /// A program alone took so long.
    pub(super) fn took(&mut self, time: Duration) {
        if self.asked < SAMPLE_LEN {
            self.asked += 1;
            self.spent += time;
        }
    }

    /// How many programs are put into the next pack; 1: none are packed.
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
