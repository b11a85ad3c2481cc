//! The caches of engines' answers from earlier runs, for engines whose fingerprint shows that they have not changed.

use crate::output;
use std::path::Path;
use stickler_cache::Cache;
use stickler_engines::Engine;
use stickler_run::AnswerStore;

/// The caches of the engines of a run, in the order of the engines.
pub struct Caches {
    caches: Vec<Option<Cache>>,
}

impl Caches {
    /// Returns no cache for any engine.
    pub const fn none() -> Caches {
        Caches { caches: Vec::new() }
    }

    /// Opens the caches in a folder, for the engines that have a fingerprint.
    pub fn open(folder: &Path, engines: &[&dyn Engine]) -> Caches {
        let cache = |engine: &&dyn Engine| {
            let fingerprint = engine.fingerprint()?;
            Some(Cache::open(folder, &engine.identity().name, &fingerprint))
        };
        let caches = Caches {
            caches: engines.iter().map(cache).collect(),
        };
        caches.report_problems();
        caches
    }

    /// Returns the caches in the form that a run takes.
    pub fn stores(&self) -> Vec<Option<&dyn AnswerStore>> {
        let store = |cache| -> Option<&dyn AnswerStore> {
            Option::<&Cache>::map(cache, |cache| cache as &dyn AnswerStore)
        };
        self.caches.iter().map(Option::as_ref).map(store).collect()
    }

    /// Writes the problems of the caches to stderr, each once.
    pub fn report_problems(&self) {
        for note in self.caches.iter().flatten().flat_map(Cache::notes) {
            output::note(note);
        }
    }
}
