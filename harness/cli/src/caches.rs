//! The caches of engines' answers from earlier runs, for engines whose fingerprint shows that they have not changed.

use crate::output;
use std::path::Path;
use stickler_cache::Cache;
use stickler_engines::Engine;
use stickler_run::AnswerStore;

/// Opens the caches in a folder for these engines, in their order; there is one of each engine that has a fingerprint.
pub fn open(folder: &Path, engines: &[&dyn Engine]) -> Vec<Option<Cache>> {
    let cache = |engine: &&dyn Engine| {
        let fingerprint = engine.fingerprint()?;
        Some(Cache::open(folder, &engine.identity().name, &fingerprint))
    };
    let caches: Vec<Option<Cache>> = engines.iter().map(cache).collect();
    report_problems(&caches);
    caches
}

/// Returns the caches in the form that a run takes.
pub fn stores(caches: &[Option<Cache>]) -> Vec<Option<&dyn AnswerStore>> {
    let caches = caches.iter().map(Option::as_ref);
    caches
        .map(|cache| cache.map(|cache| cache as &dyn AnswerStore))
        .collect()
}

/// Writes the problems of the caches to stderr, each once.
pub fn report_problems(caches: &[Option<Cache>]) {
    for note in caches.iter().flatten().flat_map(Cache::notes) {
        output::note(note);
    }
}
