//! How much memory a group of processes holds, and how much processor time it took.
//!
//! Limits of the system would not do: they count each process for itself, and address space, of which some run-time systems
//! reserve far more than they use. What counts here is what is resident, and what was computed, of the whole group.

use std::time::{Duration, Instant};

/// What a group of processes takes.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(super) struct Usage {
    /// Its resident size in bytes.
    pub(super) memory: u64,
    /// The processor time of those that live and of those that ended and were waited for.
    pub(super) cpu: Duration,
}

/// A hundredth of the time that somebody waits is the most that looking takes: a look goes through every process of the system.
const REST: u32 = 100;

/// However long a look takes, the next one comes after this time.
const MAX_INTERVAL: Duration = Duration::from_secs(1);

/// Whoever looks again and again at what a group takes.
pub(super) struct Watch {
    /// Not to be looked at before.
    next: Instant,
}

impl Watch {
    /// Nobody has looked.
    pub(super) fn new() -> Watch {
        Watch { next: Instant::now() }
    }

    /// Returns what a group takes; `None` where the last look was too short a time ago for what it took, or the system does not tell.
    pub(super) fn look(&mut self, group: u32) -> Option<Usage> {
        let begun = Instant::now();
        if begun < self.next {
            return None;
        }
        let usage = of_group(group);
        self.next = Instant::now() + MAX_INTERVAL.min(begun.elapsed() * REST);
        usage
    }
}

/// Returns what a group of processes takes; `None` where the system does not tell.
///
/// Basis: linux: proc_pid_stat(5), fields 5 (process group), 14 to 17 (time, in clock ticks) and 24 (resident set size in
/// pages).
#[cfg(target_os = "linux")]
pub(super) fn of_group(group: u32) -> Option<Usage> {
    let processes = std::fs::read_dir("/proc").ok()?;
    let mut total = Usage::default();
    for process in processes.flatten() {
        // One that has ended meanwhile takes nothing.
        if !process.file_name().as_encoded_bytes()[0].is_ascii_digit() {
            continue;
        }
        if let Ok(status) = std::fs::read_to_string(process.path().join("stat"))
            && let Some((pages, ticks)) = pages_and_ticks(&status, group)
        {
            total.memory += pages * PAGE;
            total.cpu += TICK * u32::try_from(ticks).unwrap_or(u32::MAX);
        }
    }
    Some(total)
}

/// As above; other systems are not asked.
#[cfg(not(target_os = "linux"))]
pub(super) fn of_group(_group: u32) -> Option<Usage> {
    None
}

/// The smallest page that Linux has; where pages are larger, the limit is looser than it says.
#[cfg(target_os = "linux")]
const PAGE: u64 = 4096;

/// The clock tick that Linux shows to every program, whatever it uses inside: a hundredth of a second.
#[cfg(target_os = "linux")]
const TICK: Duration = Duration::from_millis(10);

/// The resident pages of a process and its time, if it belongs to this group.
#[cfg(target_os = "linux")]
fn pages_and_ticks(status: &str, group: u32) -> Option<(u64, u64)> {
    // The name of the program stands in parentheses and may hold anything.
    let (_, fields) = status.rsplit_once(')')?;
    let fields: Vec<&str> = fields.split_ascii_whitespace().collect();
    // The fields are counted from 1, and the two before these are the number and the name.
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
