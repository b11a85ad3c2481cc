//! All inputs of a sweep through a subject, on all cores, until done or cancelled.

use crate::sweep::agenda::Sweep;
use crate::sweep::comparison::Comparison;
use crate::sweep::findings::Findings;
use crate::sweep::subject::Subject;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};

/// How far a sweep is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Progress {
    /// Inputs that were looked at.
    pub done: u64,
    /// Those that came out wrong.
    pub mismatches: u64,
}

/// Why a sweep could not be made at all.
#[derive(Debug, thiserror::Error)]
pub enum SweepError {
    /// The system gives no threads.
    #[error("cannot start the threads of a sweep: {0}")]
    Workers(#[from] rayon::ThreadPoolBuildError),
}

/// Holds every input of the sweep against exact arithmetic, on so many threads, 0 being one a processor.
///
/// `progress` is called from any of them, whenever some more inputs are done. When `cancel` becomes true, what has been
/// begun is finished and the rest left: what was looked at is always everything up to a place.
///
/// # Errors
/// [`SweepError::Workers`].
pub fn run(
    sweep: &Sweep,
    subject: &dyn Subject,
    jobs: usize,
    progress: &(dyn Fn(Progress) + Sync),
    cancel: &AtomicBool,
) -> Result<Findings, SweepError> {
    let pool = pool(jobs)?;
    let inputs = sweep.domain.len();
    let comparison = Comparison::new(sweep, subject);
    let next = AtomicU64::new(0);
    let findings = Mutex::new(Findings::new(inputs));
    let worker = || {
        let mut desk = comparison.desk();
        while let Some(places) = claim(&next, comparison.step(), inputs, cancel) {
            let found = desk.compare(places);
            let mut all = findings.lock().unwrap_or_else(PoisonError::into_inner);
            all.add(found);
            // Under the lock, so that what is shown never goes back.
            progress(all.progress());
        }
    };
    pool.scope(|scope| (0..pool.current_num_threads()).for_each(|_| scope.spawn(|_| worker())));
    Ok(findings.into_inner().unwrap_or_else(PoisonError::into_inner))
}

/// So many threads, with stacks on which an engine in this process may recurse as deep as its own limits allow.
pub fn pool(jobs: usize) -> Result<rayon::ThreadPool, rayon::ThreadPoolBuildError> {
    const STACK: usize = 16 << 20;
    rayon::ThreadPoolBuilder::new()
        .num_threads(jobs)
        .stack_size(STACK)
        .thread_name(|index| format!("sweep-{index}"))
        .build()
}

/// The next places that nobody has looked at; `None` where none are left, or no more are wanted.
fn claim(next: &AtomicU64, step: u64, inputs: u64, cancel: &AtomicBool) -> Option<Range<u64>> {
    if cancel.load(Ordering::Relaxed) {
        return None;
    }
    let start = next.fetch_add(step, Ordering::Relaxed);
    (start < inputs).then(|| start..inputs.min(start + step))
}
