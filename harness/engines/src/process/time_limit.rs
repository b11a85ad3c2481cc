//! The time that a program may take: that of its adapter, unless the command line says another for every program, and no longer
//! than until the end of a search.

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// The time limit of every program in milliseconds; 0 where each has that of its adapter.
static TIMEOUT: AtomicU64 = AtomicU64::new(0);

/// The time at which every question ends, and the time that each may take.
static END: Mutex<Option<(Instant, Duration)>> = Mutex::new(None);

/// Sets the time for which any program that an engine starts may run, and for which any answer may take, in place of what adapters
/// and descriptions say.
pub fn limit_programs(time: Duration) {
    TIMEOUT.store(milliseconds(time), Ordering::Relaxed);
}

/// Ends every question to an engine at this time, the one that is being answered then, too, and each after so long; `None` lifts that. What
/// ends so is [timed out](crate::Outcome::TimedOut).
pub fn end_questions_at(end: Option<(Instant, Duration)>) {
    *END.lock().unwrap_or_else(PoisonError::into_inner) = end;
}

/// Returns the time that a program may take from now on, of which its adapter says `usual`.
pub(crate) fn time_limit(usual: Duration) -> Duration {
    let timeout = match TIMEOUT.load(Ordering::Relaxed) {
        0 => None,
        milliseconds => Some(Duration::from_millis(milliseconds)),
    };
    let end = *END.lock().unwrap_or_else(PoisonError::into_inner);
    let left = end.map(|(end, each)| end.saturating_duration_since(Instant::now()).min(each));
    shortest(usual, timeout, left)
}

/// Returns the limit by a usual one, by another that replaces it, and by the time that is left until an end.
fn shortest(usual: Duration, timeout: Option<Duration>, left: Option<Duration>) -> Duration {
    let limit = timeout.unwrap_or(usual);
    left.map_or(limit, |left| limit.min(left))
}

/// Returns a time in whole milliseconds.
pub(crate) fn milliseconds(time: Duration) -> u64 {
    u64::try_from(time.as_millis()).unwrap_or(u64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_limit_for_every_program_replaces_the_usual_one_and_none_goes_beyond_the_end() {
        let [usual, short, long] = [60, 5, 600].map(Duration::from_secs);
        assert_eq!(shortest(usual, None, None), usual);
        assert_eq!(shortest(usual, Some(long), None), long);
        assert_eq!(shortest(usual, Some(long), Some(short)), short);
        assert_eq!(shortest(usual, None, Some(Duration::ZERO)), Duration::ZERO);
    }
}
