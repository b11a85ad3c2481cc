//! Threads that judge and reduce, each with conversations of its own with the engines.

use super::Clock;
use crate::bench::{Bench, Suspicion, Verdict, Worker};
use crate::finding::Finding;
use std::collections::VecDeque;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::thread::{Builder, Scope};
use stickler_engines::EngineError;

/// Something to do.
pub(super) enum Task {
    /// Judge these places; `index` is the number of the batch.
    Judge {
        /// The number of the batch.
        index: usize,
        /// The places.
        places: Vec<u64>,
    },
    /// Make this small.
    Reduce(Suspicion),
}

/// Something that was done.
pub(super) enum Done {
    /// A batch was judged.
    Judged {
        /// The number of the batch.
        index: usize,
        /// What was said, in the order of the places.
        verdicts: Vec<Verdict>,
    },
    /// Something was made small.
    Reduced(Box<Finding>),
    /// A task was begun and came to nothing; [`Done::Lost`] said why.
    GivenUp,
    /// Nothing more can be judged, for this reason. It is no answer to a task.
    Lost(String),
}

/// The threads, as long as the pool lives.
pub(super) struct Pool {
    desk: Arc<Desk>,
    done: Receiver<Done>,
}

/// Where tasks lie until a thread takes them.
#[derive(Default)]
struct Desk {
    tasks: Mutex<Tasks>,
    changed: Condvar,
}

#[derive(Default)]
struct Tasks {
    judge: VecDeque<Task>,
    /// Done first: a campaign that is cut short has then made small most of what it found.
    reduce: VecDeque<Task>,
    closed: bool,
}

impl Pool {
    /// Starts the threads, and waits until each has its conversations.
    ///
    /// # Errors
    /// [`EngineError`] where one has none.
    pub(super) fn start<'s>(
        scope: &'s Scope<'s, '_>,
        bench: &'s dyn Bench,
        clock: &'s Clock<'s>,
        jobs: usize,
    ) -> Result<Pool, EngineError> {
        /// As deep as the limits of an engine in this process let it recurse.
        const STACK: usize = 16 << 20;
        let desk = Arc::new(Desk::default());
        let (tell, done) = channel();
        let (ready, started) = channel();
        // The pool exists before the first thread, so that an error below ends those that run.
        let pool = Pool { desk, done };
        for number in 0..jobs {
            let (desk, tell, ready) = (Arc::clone(&pool.desk), tell.clone(), ready.clone());
            let builder = Builder::new()
                .name(format!("campaign-{number}"))
                .stack_size(STACK);
            let spawned = builder.spawn_scoped(scope, move || match bench.worker() {
                Ok(mut worker) => {
                    // The pool waits for this.
                    let _ = ready.send(Ok(()));
                    drop(ready);
                    work(&mut *worker, &desk, &tell, clock);
                }
                Err(error) => {
                    let _ = ready.send(Err(error));
                }
            });
            if let Err(error) = spawned {
                return Err(EngineError::NotStarted {
                    engine: "of the campaign".to_owned(),
                    reason: format!("no thread can be started: {error}"),
                });
            }
        }
        drop(ready);
        for _ in 0..jobs {
            // A thread that ends without a word has panicked, and the scope says so.
            started.recv().unwrap_or(Ok(()))?;
        }
        Ok(pool)
    }

    /// Gives out a task.
    pub(super) fn give(&self, task: Task) {
        let mut tasks = self.desk.tasks.lock().unwrap_or_else(PoisonError::into_inner);
        match task {
            Task::Judge { .. } => tasks.judge.push_back(task),
            Task::Reduce(_) => tasks.reduce.push_back(task),
        }
        self.desk.changed.notify_one();
    }

    /// What was done next; `None` where no thread is left.
    pub(super) fn take(&self) -> Option<Done> {
        self.done.recv().ok()
    }
}

impl Drop for Pool {
    fn drop(&mut self) {
        self.desk
            .tasks
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .closed = true;
        self.desk.changed.notify_all();
    }
}

impl Desk {
    /// The next task; `None` at the end.
    fn task(&self) -> Option<Task> {
        let mut tasks = self.tasks.lock().unwrap_or_else(PoisonError::into_inner);
        loop {
            if tasks.closed {
                return None;
            }
            let next = tasks.reduce.pop_front().or_else(|| tasks.judge.pop_front());
            if next.is_some() {
                return next;
            }
            tasks = self.changed.wait(tasks).unwrap_or_else(PoisonError::into_inner);
        }
    }
}

fn work(worker: &mut dyn Worker, desk: &Desk, tell: &Sender<Done>, clock: &Clock<'_>) {
    while let Some(task) = desk.task() {
        let (done, lost) = match attempt(worker, task, clock) {
            Ok(done) => (done, worker.lost()),
            Err(panic) => (Done::GivenUp, Some(panic)),
        };
        for message in lost.map(Done::Lost).into_iter().chain([done]) {
            if tell.send(message).is_err() {
                return;
            }
        }
    }
}

/// Does a task. What a thread panics over is told like the loss of an engine: the campaign ends, and keeps what it has.
fn attempt(worker: &mut dyn Worker, task: Task, clock: &Clock<'_>) -> Result<Done, String> {
    let what = task.to_string();
    // A worker that has panicked judges nothing more, for the campaign ends.
    let result = catch_unwind(AssertUnwindSafe(|| match task {
        Task::Judge { index, places } => Done::Judged {
            index,
            verdicts: worker.judge(&places, &|| clock.judges()),
        },
        Task::Reduce(suspicion) => Done::Reduced(Box::new(worker.reduce(&suspicion, &|| clock.reduces()))),
    }));
    result.map_err(|_| format!("Stickler itself panicked {what}; that is a defect of Stickler"))
}

impl fmt::Display for Task {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Task::Judge { places, .. } => {
                let (first, last) = (places.first().unwrap_or(&0), places.last().unwrap_or(&0));
                write!(f, "over one of the inputs {first} to {last}")
            }
            Task::Reduce(suspicion) => write!(f, "while it made input {} small", suspicion.place),
        }
    }
}
