//! The memory that a group of processes holds, and the processor time that it took.
//!
//! The system's own limits do not serve: they count each process by itself, and address space, of which some run-time systems
//! reserve far more than they use. This module sums the resident memory and the processor time of the whole group.

use std::time::{Duration, Instant};

/// The memory and the processor time of a group of processes.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(super) struct Usage {
    /// The resident size, in bytes.
    pub(super) memory: u64,
    /// The processor time of the processes that run, and of those that ended and were waited for.
    pub(super) cpu: Duration,
}

/// The pause after a measurement, as a multiple of its duration, so that at most a hundredth of the waiting time is spent on
/// measuring: each measurement goes through every process of the system.
const PAUSE_FACTOR: u32 = 100;

/// The longest pause after a measurement, however long it took.
const MAX_INTERVAL: Duration = Duration::from_secs(1);

/// A repeated measurement of a group, whose frequency is limited.
pub(super) struct Watch {
    /// The time before which nothing is measured.
    next: Instant,
}

impl Watch {
    /// Returns a watch that has measured nothing yet.
    pub(super) fn new() -> Watch {
        Watch { next: Instant::now() }
    }

    /// Measures a group; `None` where the last measurement was too short a time ago for its duration, or the system does not
    /// tell.
    pub(super) fn measure(&mut self, group: u32) -> Option<Usage> {
        let begun = Instant::now();
        if begun < self.next {
            return None;
        }
        let usage = of_group(group);
        self.next = Instant::now() + MAX_INTERVAL.min(begun.elapsed() * PAUSE_FACTOR);
        usage
    }
}

/// Measures a group of processes; `None` where the system does not tell.
///
/// Basis: linux: proc_pid_stat(5), fields 5 (process group), 14 to 17 (time, in clock ticks) and 24 (resident set size in
/// pages).
#[cfg(target_os = "linux")]
pub(super) fn of_group(group: u32) -> Option<Usage> {
    let processes = std::fs::read_dir("/proc").ok()?;
    let mut total = Usage::default();
    for process in processes.flatten() {
        // A process that has ended meanwhile takes nothing.
        if !process.file_name().as_encoded_bytes()[0].is_ascii_digit() {
            continue;
        }
        if let Ok(status) = std::fs::read_to_string(process.path().join("stat"))
            && let Some((pages, ticks)) = pages_and_ticks(&status, group)
        {
            total.memory += pages * MIN_PAGE_SIZE;
            total.cpu += CLOCK_TICK * u32::try_from(ticks).unwrap_or(u32::MAX);
        }
    }
    Some(total)
}

/// Returns `None`: systems other than Linux are not asked.
#[cfg(not(target_os = "linux"))]
pub(super) fn of_group(_group: u32) -> Option<Usage> {
    None
}

/// The smallest memory page of Linux, in bytes; where pages are larger, the limit is looser than it says.
#[cfg(target_os = "linux")]
const MIN_PAGE_SIZE: u64 = 4096;

/// The duration of the clock tick in which Linux reports times to every program, whatever it uses inside: a hundredth of a
/// second.
#[cfg(target_os = "linux")]
const CLOCK_TICK: Duration = Duration::from_millis(10);

/// Returns the resident pages of a process and its time in clock ticks, if it belongs to the group.
#[cfg(target_os = "linux")]
fn pages_and_ticks(status: &str, group: u32) -> Option<(u64, u64)> {
    // The name of the program stands in parentheses and may hold anything.
    let (_, fields) = status.rsplit_once(')')?;
    let fields: Vec<&str> = fields.split_ascii_whitespace().collect();
    // Fields are counted from 1; the two before these are the number and the name.
    let field = |number: usize| fields.get(number - 3)?.parse::<u64>().ok();
    if field(5)? != u64::from(group) {
        return None;
    }
    let ticks = (14..=17).map(field).sum::<Option<u64>>()?;
    Some((field(24)?, ticks))
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::{Usage, of_group, pages_and_ticks};

    #[test]
    fn the_pages_and_the_time_of_a_group_are_counted_whatever_its_program_is_called() {
        let status = "17 (a) 1 (b) S 1 42 42 0 -1 4194560 100 0 0 0 1 2 3 4 20 0 1 0 500 1000000 321 18446744073709551615";
        assert_eq!(pages_and_ticks(status, 42), Some((321, 10)));
        assert_eq!(pages_and_ticks(status, 43), None);
        assert_eq!(pages_and_ticks("", 42), None);
    }

    #[test]
    fn a_group_that_nobody_belongs_to_takes_nothing() {
        assert_eq!(of_group(u32::MAX), Some(Usage::default()));
    }
}
