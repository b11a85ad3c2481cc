//! The history of an engine: its runs, and the changes from each version to the next.

use super::SiteError;
use super::run::SiteRun;
use super::versions::{self, VersionRun};
use crate::comparison::{Change, Comparison, ComparisonError, Kind};
use crate::discrepancies::file_name;
use crate::events::Reader;
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};

/// The runs of one engine.
pub(super) struct History<'r> {
    pub(super) name: &'r str,
    /// The file name of the engine's page.
    pub(super) file: String,
    /// All runs, oldest first.
    pub(super) runs: Vec<VersionRun<'r>>,
    /// The run of each version that counts, oldest version first.
    pub(super) counted: Vec<VersionRun<'r>>,
    /// The steps from version to version, oldest first.
    pub(super) steps: Vec<VersionStep<'r>>,
}

/// The changes of an engine from one version to the next.
pub(super) struct VersionStep<'r> {
    pub(super) old: VersionRun<'r>,
    pub(super) new: VersionRun<'r>,
    /// The changes; the reason where the two runs cannot be compared.
    pub(super) changes: Result<Vec<Change>, String>,
}

impl<'r> History<'r> {
    /// Returns the history of every engine of the runs, by name.
    pub(super) fn of_engines(runs: &'r [SiteRun]) -> Result<Vec<History<'r>>, SiteError> {
        let mut by_engine: BTreeMap<&str, Vec<VersionRun<'r>>> = BTreeMap::new();
        for run in runs {
            for engine in &run.header.engines {
                by_engine.entry(&engine.name).or_default().push(VersionRun {
                    run,
                    version: &engine.version,
                    replaced: None,
                });
            }
        }
        let mut files = BTreeSet::new();
        let histories = by_engine.into_iter().map(|(name, mut runs)| {
            versions::replace(name, &mut runs);
            let counted = versions::in_order(&runs);
            Ok(History {
                name,
                file: page_name(name, &mut files),
                steps: steps(name, &counted)?,
                counted,
                runs,
            })
        });
        histories.collect()
    }

    /// Returns the steps of all engines, the newest first.
    pub(super) fn newest_steps<'h>(histories: &'h [Self]) -> Vec<(&'h Self, &'h VersionStep<'r>)> {
        let of_each = |history: &'h Self| history.steps.iter().map(move |step| (history, step));
        let mut steps: Vec<_> = histories.iter().flat_map(of_each).collect();
        steps.sort_by_key(|(_, step)| Reverse(step.new.run.number));
        steps
    }

    /// Returns the run of the newest version that counts.
    pub(super) fn newest(&self) -> VersionRun<'r> {
        *self
            .counted
            .last()
            .expect("an engine of the site is one of a run")
    }

    /// Describes the runs that do not count.
    pub(super) fn replaced(&self) -> Vec<String> {
        let sentence = |run: &VersionRun<'_>| {
            let reason = run.reason(self.name)?;
            Some(format!(
                "{} does not count for {} {}: {reason}; the history lists it",
                run.run.log.display(),
                self.name,
                run.version
            ))
        };
        self.runs.iter().filter_map(sentence).collect()
    }
}

impl VersionStep<'_> {
    /// Returns the changes of one kind.
    pub(super) fn of_kind(&self, kind: Kind) -> impl Iterator<Item = &Change> {
        let changes = self.changes.iter().flatten();
        changes.filter(move |change| change.kind == kind)
    }

    /// Returns the numbers of changes as text: `2 fixed, 1 broken, 0 crashed`, or why there are none.
    pub(super) fn numbers(&self) -> String {
        match &self.changes {
            Err(reason) => format!("not compared, since {reason}"),
            Ok(_) => format!(
                "{} fixed, {} broken, {} crashed",
                self.of_kind(Kind::Fixed).count(),
                self.of_kind(Kind::Broken).count(),
                self.of_kind(Kind::Crashed).count()
            ),
        }
    }
}

/// Returns the file name of an engine's page, another one for each engine.
fn page_name(engine: &str, taken: &mut BTreeSet<String>) -> String {
    let name = file_name(engine);
    let names = (1..).map(|number| match number {
        1 => format!("{name}.html"),
        _ => format!("{name}-{number}.html"),
    });
    // File systems exist that do not tell capitals from small letters.
    let mut free = names.filter(|name| taken.insert(name.to_lowercase()));
    free.next().expect("there is always a further number")
}

fn steps<'r>(engine: &str, counted: &[VersionRun<'r>]) -> Result<Vec<VersionStep<'r>>, SiteError> {
    let pairs = counted.iter().zip(counted.iter().skip(1));
    let step = |(old, new): (&VersionRun<'r>, &VersionRun<'r>)| {
        Ok(VersionStep {
            old: *old,
            new: *new,
            changes: changes(engine, old.run, new.run)?,
        })
    };
    pairs.map(step).collect()
}

fn changes(engine: &str, old: &SiteRun, new: &SiteRun) -> Result<Result<Vec<Change>, String>, SiteError> {
    let open = |run: &SiteRun| Reader::open(&run.log).map_err(SiteError::run(&run.log));
    match Comparison::of(open(old)?, open(new)?) {
        Ok(comparison) if comparison.same == 0 && comparison.changes.is_empty() => {
            Ok(Err("no case is in both runs".to_owned()))
        }
        Ok(mut comparison) => {
            comparison.changes.retain(|change| change.engine == engine);
            Ok(Ok(comparison.changes))
        }
        Err(error @ (ComparisonError::Parts { .. } | ComparisonError::NoEngine { .. })) => {
            Ok(Err(error.to_string()))
        }
        Err(source) => Err(SiteError::Comparison {
            old: old.log.clone(),
            new: new.log.clone(),
            source: Box::new(source),
        }),
    }
}
