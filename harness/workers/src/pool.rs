//! Threads that do tasks, under a supervisor on the caller's thread.

use rayon::{ThreadPoolBuildError, ThreadPoolBuilder};
use std::any::Any;
use std::cell::Cell;
use std::num::NonZero;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::mpsc::{self, Receiver, Sender};
use std::sync::{Mutex, PoisonError};
use std::thread;

/// The stack of a thread: an engine in this process may recurse as deep as its own limits allow, for which the usual two
/// megabytes are too few.
const STACK_SIZE: usize = 16 << 20;

/// The greatest number of tasks of a thread: the one under way and the next, so that it need not wait for the caller's
/// thread.
const MAX_TASKS_PER_THREAD: usize = 2;

/// A number of threads, started anew for each piece of work.
///
/// Each thread opens a worker (a session of an engine, buffers, nothing), which does one task after the other. Tasks are
/// given out and results are taken on the caller's thread alone, so whoever schedules them needs no locks; what the
/// number of threads changes is the order in which results come back, and nothing else.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct WorkerPool {
    threads: usize,
}

/// The caller's side of a [`WorkerPool`]: gives out tasks and takes their results.
pub trait Supervisor<T, R> {
    /// Returns the next task to be begun. `None` means that there is none before the next result is taken; when no task is
    /// under way either, the work is done.
    fn next_task(&mut self) -> Option<T>;

    /// Takes the result of a task. Results come in the order in which tasks end.
    fn take(&mut self, result: R);
}

/// The system gives no thread.
#[derive(Debug, thiserror::Error)]
#[error("a worker thread could not be started: {0}")]
pub struct SpawnError(#[source] ThreadPoolBuildError);

/// A message of a thread to the supervisor.
enum WorkerMessage<R, E> {
    Opened(Result<(), E>),
    Done(R),
    Panicked(Box<dyn Any + Send>),
}

impl WorkerPool {
    /// Returns a pool of this many threads; 0 stands for one a processor.
    pub fn new(jobs: usize) -> WorkerPool {
        let threads = match jobs {
            0 => thread::available_parallelism().map_or(1, NonZero::get),
            jobs => jobs,
        };
        WorkerPool { threads }
    }

    /// Returns the number of threads, which is at least 1.
    pub const fn threads(self) -> usize {
        self.threads
    }

    /// Has every thread `open` a worker, and then `work` on the tasks that the supervisor gives out, until there are no more.
    ///
    /// Both closures run on the threads of the pool, the supervisor on the caller's. No task is given out before all
    /// workers are open. A panic of a worker goes on on the caller's thread, after the tasks that were given out are done.
    ///
    /// # Errors
    /// The first error of `open`, or a [`SpawnError`]; then no task was given out.
    pub fn run<W, T: Send, R: Send, E: Send + From<SpawnError>>(
        self,
        open: impl Fn() -> Result<W, E> + Sync,
        work: impl Fn(&mut W, T) -> R + Sync,
        supervisor: &mut dyn Supervisor<T, R>,
    ) -> Result<(), E> {
        let threads = ThreadPoolBuilder::new()
            .num_threads(self.threads)
            .thread_name(|index| format!("worker-{index}"))
            .stack_size(STACK_SIZE)
            .build()
            .map_err(SpawnError)?;
        let (tasks, taken) = mpsc::channel();
        let (messages, answers) = mpsc::channel();
        let taken = Mutex::new(taken);
        threads.in_place_scope(|scope| {
            scope.spawn_broadcast(|_, _| work_until_closed(&open, &work, &taken, &messages));
            // The threads end when the sender of tasks is dropped, however this ends.
            self.supervise(supervisor, tasks, &answers)
        })
    }

    /// Gives out tasks and takes results until both have come to an end.
    fn supervise<T, R, E>(
        self,
        supervisor: &mut dyn Supervisor<T, R>,
        tasks: Sender<T>,
        messages: &Receiver<WorkerMessage<R, E>>,
    ) -> Result<(), E> {
        // To open a worker is the first thing that each thread does.
        let (mut opening, mut under_way) = (self.threads, self.threads);
        while under_way > 0
            && let Ok(message) = messages.recv()
        {
            under_way -= 1;
            match message {
                WorkerMessage::Opened(opened) => {
                    opened?;
                    opening -= 1;
                }
                WorkerMessage::Done(result) => supervisor.take(result),
                WorkerMessage::Panicked(panic) => resume_unwind(panic),
            }
            while opening == 0
                && under_way < self.threads * MAX_TASKS_PER_THREAD
                && let Some(task) = supervisor.next_task()
                && tasks.send(task).is_ok()
            {
                under_way += 1;
            }
        }
        Ok(())
    }

    /// Does the tasks of an iterator, which is asked for the next one when a thread needs it. `take` gets the results on the
    /// caller's thread, in the order in which tasks end.
    ///
    /// # Errors
    /// Fails as [`WorkerPool::run`] does.
    pub fn for_each<W, T: Send, R: Send, E: Send + From<SpawnError>>(
        self,
        tasks: impl Iterator<Item = T>,
        open: impl Fn() -> Result<W, E> + Sync,
        work: impl Fn(&mut W, T) -> R + Sync,
        take: impl FnMut(R),
    ) -> Result<(), E> {
        self.run(open, work, &mut Each { tasks, take })
    }

    /// Does one task for each item, and returns their results in the order of the items. After an error no more tasks are
    /// begun.
    ///
    /// # Errors
    /// Fails as [`WorkerPool::run`] does, or with the error of `work` that belongs to the earliest item.
    pub fn map<W, T: Send, R: Send, E: Send + From<SpawnError>>(
        self,
        items: impl ExactSizeIterator<Item = T>,
        open: impl Fn() -> Result<W, E> + Sync,
        work: impl Fn(&mut W, T) -> Result<R, E> + Sync,
    ) -> Result<Vec<R>, E> {
        let threads = self.threads.min(items.len()).max(1);
        let has_failed = Cell::new(false);
        let items = items.enumerate().take_while(|_| !has_failed.get());
        let numbered = |worker: &mut W, (number, item)| (number, work(worker, item));
        let mut results: Vec<(usize, Result<R, E>)> = Vec::new();
        let take = |result: (usize, Result<R, E>)| {
            has_failed.set(has_failed.get() || result.1.is_err());
            results.push(result);
        };
        WorkerPool { threads }.for_each(items, open, numbered, take)?;
        results.sort_by_key(|(number, _)| *number);
        results.into_iter().map(|(_, result)| result).collect()
    }
}

/// The life of a thread: opens a worker and does tasks until no more can come.
fn work_until_closed<W, T, R, E>(
    open: &(impl Fn() -> Result<W, E> + Sync),
    work: &(impl Fn(&mut W, T) -> R + Sync),
    tasks: &Mutex<Receiver<T>>,
    messages: &Sender<WorkerMessage<R, E>>,
) {
    // The caller's thread, which panics itself, may be gone.
    let send = |message| drop(messages.send(message));
    let next = || tasks.lock().unwrap_or_else(PoisonError::into_inner).recv();
    // Nothing of the worker is used any more after a panic.
    let life = catch_unwind(AssertUnwindSafe(|| {
        let mut worker = match open() {
            Ok(worker) => worker,
            Err(error) => return send(WorkerMessage::Opened(Err(error))),
        };
        send(WorkerMessage::Opened(Ok(())));
        while let Ok(task) = next() {
            send(WorkerMessage::Done(work(&mut worker, task)));
        }
    }));
    if let Err(panic) = life {
        send(WorkerMessage::Panicked(panic));
    }
}

/// The supervisor of [`WorkerPool::for_each`].
struct Each<I, F> {
    tasks: I,
    take: F,
}

impl<T, R, I: Iterator<Item = T>, F: FnMut(R)> Supervisor<T, R> for Each<I, F> {
    fn next_task(&mut self) -> Option<T> {
        self.tasks.next()
    }

    fn take(&mut self, result: R) {
        (self.take)(result);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Cancellation;
    use std::sync::atomic::{AtomicUsize, Ordering};
    use std::thread::ThreadId;
    use std::time::Duration;

    #[derive(Debug)]
    enum TestError {
        Spawn,
        Refused(u32),
    }

    impl From<SpawnError> for TestError {
        fn from(_: SpawnError) -> TestError {
            TestError::Spawn
        }
    }

    #[test]
    fn results_stand_in_the_order_of_the_items_although_early_ones_take_longest() {
        let slow_at_first = |(): &mut (), number: u64| {
            thread::sleep(Duration::from_millis(20_u64.saturating_sub(number)));
            Ok::<_, SpawnError>(number * number)
        };
        for jobs in [1, 5, 100] {
            let squares =
                WorkerPool::new(jobs).map([0, 1, 2, 3, 19, 20].into_iter(), || Ok(()), slow_at_first);
            assert_eq!(squares.unwrap(), [0, 1, 4, 9, 361, 400]);
        }
        let none = WorkerPool::new(3).map([].into_iter(), || Ok(()), slow_at_first);
        assert!(none.unwrap().is_empty());
    }

    #[test]
    fn each_thread_keeps_its_worker_and_there_are_no_more_than_tasks() {
        let opened = AtomicUsize::new(0);
        let open = || {
            opened.fetch_add(1, Ordering::Relaxed);
            Ok::<ThreadId, SpawnError>(thread::current().id())
        };
        let stays = |worker: &mut ThreadId, _| Ok(*worker == thread::current().id());
        let stayed = WorkerPool::new(8).map(0..3, open, stays).unwrap();
        assert_eq!(stayed, [true; 3]);
        assert_eq!(opened.into_inner(), 3);
    }

    #[test]
    fn where_a_worker_cannot_be_opened_no_task_is_begun() {
        let opened = AtomicUsize::new(0);
        let open = || match opened.fetch_add(1, Ordering::Relaxed) {
            1 => Err(TestError::Refused(1)),
            _ => Ok(()),
        };
        let work = |(): &mut (), _| panic!("a task was begun");
        let error = WorkerPool::new(3)
            .for_each(0..10, open, work, |()| ())
            .unwrap_err();
        assert!(matches!(error, TestError::Refused(1)), "{error:?}");
    }

    #[test]
    fn after_an_error_no_more_tasks_are_begun() {
        let begun = AtomicUsize::new(0);
        let work = |(): &mut (), number: u32| {
            begun.fetch_add(1, Ordering::Relaxed);
            if number < 3 {
                Ok(number)
            } else {
                Err(TestError::Refused(number))
            }
        };
        let error = WorkerPool::new(1).map(vec![1, 2, 3, 1, 1, 1, 1, 1].into_iter(), || Ok(()), work);
        assert!(matches!(error, Err(TestError::Refused(3))), "{error:?}");
        assert!(begun.into_inner() <= 3 + MAX_TASKS_PER_THREAD);
    }

    #[test]
    fn of_several_errors_the_one_of_the_earliest_item_is_returned() {
        let late_at_first = |(): &mut (), number: u32| {
            thread::sleep(Duration::from_millis(20 / u64::from(number)));
            Err::<(), _>(TestError::Refused(number))
        };
        let error = WorkerPool::new(4).map([1, 2, 3, 4].into_iter(), || Ok(()), late_at_first);
        assert!(matches!(error, Err(TestError::Refused(1))), "{error:?}");
    }

    #[test]
    fn a_panic_of_a_worker_reaches_the_caller() {
        let work = |(): &mut (), number: u32| {
            assert!(number != 5, "no fives");
            Ok::<_, SpawnError>(())
        };
        let panic = catch_unwind(|| WorkerPool::new(2).map(vec![5; 100].into_iter(), || Ok(()), work));
        let panic = panic.expect_err("it went on");
        assert_eq!(panic.downcast_ref::<&str>(), Some(&"no fives"));
    }

    #[test]
    fn a_cancelled_row_of_tasks_is_done_up_to_a_place() {
        let cancel = Cancellation::new();
        let tasks = (0..u64::MAX).take_while(|_| !cancel.is_requested());
        let mut done = Vec::new();
        let take = |number| {
            done.push(number);
            if done.len() == 100 {
                cancel.request();
            }
        };
        let ended = WorkerPool::new(4).for_each(tasks, || Ok::<_, SpawnError>(()), |(), number| number, take);
        ended.unwrap();
        done.sort_unstable();
        let all: Vec<u64> = (0..done.len() as u64).collect();
        assert_eq!(done, all);
        assert!((100..=100 + 4 * MAX_TASKS_PER_THREAD).contains(&done.len()));
    }

    /// Counts down: each result below its limit asks for a task more.
    struct Countdown {
        open: Vec<u32>,
        taken: Vec<u32>,
    }

    impl Supervisor<u32, u32> for Countdown {
        fn next_task(&mut self) -> Option<u32> {
            self.open.pop()
        }

        fn take(&mut self, result: u32) {
            self.taken.push(result);
            self.open.extend(result.checked_sub(1));
        }
    }

    #[test]
    fn a_result_may_give_rise_to_a_task_when_none_was_left() {
        let mut countdown = Countdown {
            open: vec![6],
            taken: Vec::new(),
        };
        let ended = WorkerPool::new(3).run(|| Ok::<_, SpawnError>(()), |(), number| number, &mut countdown);
        ended.unwrap();
        assert_eq!(countdown.taken, [6, 5, 4, 3, 2, 1, 0]);
    }
}
