//! Pauses between checks whether a process has ended.

use std::thread;
use std::time::{Duration, Instant};

/// The longest pause between two checks of a process, where the system does not tell when it ends.
const MAX_PAUSE: Duration = Duration::from_millis(16);

/// The pauses between the checks of one process.
pub(super) struct Pauses {
    next: Duration,
}

impl Pauses {
    /// Returns pauses of which none was made so far.
    pub(super) fn new() -> Pauses {
        Pauses {
            next: Duration::from_micros(100),
        }
    }

    /// Returns when the process of this number has ended, or at the deadline; where the system does not tell, after a pause.
    /// The caller must not have collected the end of the process yet, so that its number belongs to no other.
    pub(super) fn pause(&mut self, process: u32, deadline: Instant) {
        let left = deadline.saturating_duration_since(Instant::now());
        if !ended_within(process, left) {
            thread::sleep(self.next.min(left));
            self.next = MAX_PAUSE.min(self.next * 2);
        }
    }
}

/// Waits for the end of a process, but no longer than `limit`. Returns whether the system can do so.
#[cfg(target_os = "linux")]
fn ended_within(process: u32, limit: Duration) -> bool {
    use rustix::event::{PollFd, PollFlags, Timespec, poll};
    use rustix::process::{Pid, PidfdFlags, pidfd_open};
    let number = i32::try_from(process).ok().and_then(Pid::from_raw);
    let Some(Ok(process)) = number.map(|number| pidfd_open(number, PidfdFlags::empty())) else {
        return false;
    };
    // The descriptor becomes readable when the process has ended.
    let mut asked = [PollFd::new(&process, PollFlags::IN)];
    let limit = Timespec::try_from(limit).ok();
    poll(&mut asked, limit.as_ref()).is_ok()
}

/// Returns `false`: systems other than Linux are not asked.
#[cfg(not(target_os = "linux"))]
fn ended_within(_process: u32, _limit: Duration) -> bool {
    false
}
