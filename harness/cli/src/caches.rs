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
    /// No engine has one.
    pub const fn none() -> Caches {
        Caches { caches: Vec::new() }
    }

    /// Those of the engines that have a fingerprint, in this folder.
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

    /// As a run takes them.
    pub fn stores(&self) -> Vec<Option<&dyn AnswerStore>> {
        let store = |cache| -> Option<&dyn AnswerStore> {
            Option::<&Cache>::map(cache, |cache| cache as &dyn AnswerStore)
        };
        self.caches.iter().map(Option::as_ref).map(store).collect()
    }

    /// Says on stderr what is wrong with them; each thing once.
    pub fn tell(&self) {
        for note in self.caches.iter().flatten().flat_map(Cache::notes) {
            output::note(note);
        }
    }
}

/// Says how much of what a run shows was not asked again.
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
