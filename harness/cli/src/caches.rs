//! What engines answered in earlier runs, for those of which it can be known that they still answer the same.

use crate::output;
use std::io::{self, Write};
use std::path::Path;
use stickler_cache::Cache;
use stickler_engines::Engine;
use stickler_run::AnswerStore;

/// The cache of each engine of a run, in their order.
pub struct Caches {
    caches: Vec<Option<Cache>>,
}

impl Caches {
    /// Returns no cache for any engine.
    pub const fn none() -> Caches {
        Caches { caches: Vec::new() }
    }

    /// Opens the caches in a folder, of the engines that have a fingerprint.
    pub fn open(folder: &Path, engines: &[&dyn Engine]) -> Caches {
        let cache = |engine: &&dyn Engine| {
            let fingerprint = engine.fingerprint()?;
            Some(Cache::open(folder, &engine.identity().name, &fingerprint))
        };
        let caches = Caches {
            caches: engines.iter().map(cache).collect(),
        };
        caches.tell();
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
    pub fn tell(&self) {
        for note in self.caches.iter().flatten().flat_map(Cache::notes) {
            output::note(note);
        }
    }
}

/// Writes how many of the results of a run come from the cache.
///
/// # Errors
/// Those of `out`.
pub fn tell_from_cache(out: &mut dyn Write, from_cache: u64, cases: u64) -> io::Result<()> {
    match from_cache {
        0 => Ok(()),
        _ => writeln!(
            out,
            "{from_cache} of {cases} results come from the cache of earlier runs; --no-cache asks everything anew."
        ),
    }
}
