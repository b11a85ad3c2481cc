//! Engines with known defects: the reference, which is given another program than it was asked about.

use std::collections::HashSet;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use stickler_engines::{ClosureEngine, Outcome, RunRequest};

/// A planted defect of an engine.
#[derive(Clone, Copy, Debug)]
pub enum Defect {
    /// Takes one word of the program for another.
    Mistakes(&'static str, &'static str),
    /// Dies over programs with this word.
    DiesOver(&'static str),
    /// Dies over each request whose number is a multiple of this one, and over no program twice.
    DiesEvery(u64),
    /// Dies over every request from the first program with this word on.
    DiesForEverOver(&'static str),
    /// Rejects programs with one of these texts.
    Rejects(&'static [&'static str]),
    /// No defect.
    None,
}

/// Returns the reference with this defect, under the name `defective`.
pub fn defective(defect: Defect) -> ClosureEngine<'static> {
    dying(defect, u64::MAX, Arc::default())
}

/// Returns an engine with a defect that counts the requests to run a program, and dies over every request after the first `life`.
pub fn dying(defect: Defect, life: u64, requests: Arc<AtomicU64>) -> ClosureEngine<'static> {
    let life = AtomicU64::new(life);
    // The programs over which it has died.
    let fatal: Mutex<HashSet<String>> = Mutex::default();
    let is_first_death = move |source: &str| {
        let mut fatal = fatal.lock().unwrap_or_else(PoisonError::into_inner);
        fatal.insert(source.to_owned())
    };
    ClosureEngine::new("defective", move |reference, request| {
        let number = requests.fetch_add(1, Ordering::Relaxed) + 1;
        let mut source = request.source.to_owned();
        let dies = match defect {
            Defect::DiesOver(word) => source.contains(word),
            Defect::DiesEvery(every) => number.is_multiple_of(every) && is_first_death(&source),
            Defect::DiesForEverOver(word) if source.contains(word) => {
                life.store(0, Ordering::Relaxed);
                true
            }
            Defect::Rejects(texts) if texts.iter().any(|text| source.contains(text)) => {
                return Outcome::rejected(Vec::new());
            }
            Defect::Mistakes(word, other) => {
                source = source.replace(word, other);
                false
            }
            Defect::DiesForEverOver(_) | Defect::Rejects(_) | Defect::None => false,
        };
        if dies || number > life.load(Ordering::Relaxed) {
            return Outcome::crashed("it was made to");
        }
        reference.run(&RunRequest {
            source: &source,
            ..*request
        })
    })
}
