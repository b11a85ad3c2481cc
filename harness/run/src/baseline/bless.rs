//! Rewrites a baseline from the results of a run. Expectations are never touched: a baseline only states known deviations.

use super::fold::{CaseKey, Universe};
use super::matched::EntryState;
use super::owned::Owned;
use super::write::{self, Added, Fate};
use super::{Baseline, Entry};
use crate::Verdict;
use crate::event::{CaseEvent, EngineHeader};
use jiff::civil::Date;
use std::collections::{BTreeMap, HashMap, HashSet};
use stickler_suite::Suite;
use stickler_types::DialectName;

/// The verdicts of a run on one engine, as if it had no baseline.
#[derive(Clone, Debug)]
pub struct EngineRun {
    engine: EngineHeader,
    verdicts: BTreeMap<(String, DialectName), Verdict>,
}

impl EngineRun {
    /// Creates the run of this engine, without cases.
    #[must_use]
    pub fn new(engine: EngineHeader) -> EngineRun {
        EngineRun {
            engine,
            verdicts: BTreeMap::new(),
        }
    }

    /// Returns the header of the engine.
    #[must_use]
    pub fn engine(&self) -> &EngineHeader {
        &self.engine
    }

    /// Adds the verdict of a case, if the case ran on this engine.
    pub fn take(&mut self, case: &CaseEvent) {
        if case.engine != self.engine.name {
            return;
        }
        let Ok(dialect) = case.dialect.parse() else { return };
        self.verdicts
            .insert((case.id.clone(), dialect), case.actual_verdict());
    }

    fn verdict(&self, (id, dialect): CaseKey<'_>) -> Option<Verdict> {
        self.verdicts.get(&(id.to_owned(), dialect)).copied()
    }
}

/// A rewritten baseline, and the changes to it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Blessing {
    /// The whole text of its file.
    pub text: String,
    /// The changes, in the order of the file.
    pub changes: Vec<EntryChange>,
    /// The number of entries after the rewrite.
    pub entries: usize,
    /// The number of cases of the run that are no longer in the suite; the baseline gets no entries for them.
    pub strangers: usize,
}

/// A change to an entry of a baseline.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct EntryChange {
    /// The kind of change.
    pub kind: ChangeKind,
    /// The expected verdicts of the entry; several are alternatives.
    pub verdicts: Vec<Verdict>,
    /// The id or pattern of the entry; of a narrowed entry, the one before the change.
    pub case: String,
    /// The number of cases that a new entry is about, or the reason for the change of an old one, as a fragment.
    pub why: String,
}

/// The kind of change to an entry.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ChangeKind {
    /// The entry is new.
    Added,
    /// The entry is gone.
    Removed,
    /// The entry is replaced: only some of its cases still have the expected verdict; they get entries with the same reason.
    Narrowed,
    /// The entry lost its last day, which is past although the entry still holds.
    Undated,
}

/// Rewrites the baseline of an engine, whose text is `text` (empty where there was none), from a run on the cases of this
/// suite. `day` is the day of the run.
///
/// An entry stays as it is, with its comments, while its cases have the expected verdicts; it is narrowed where only some
/// do, and removed where none does. Cases that were not run stay as they are. Entries about other versions of the engine are
/// left alone.
#[must_use]
pub fn bless(text: &str, baseline: &Baseline, run: &EngineRun, suite: &Suite, day: Date) -> Blessing {
    // As for [`Identity::asked_in`](stickler_engines::Identity::asked_in), of which only the names are known.
    let named = |dialect: DialectName| run.engine.dialects.iter().any(|name| name == dialect.as_str());
    let spoken = |dialect: &DialectName| named(*dialect) || named(dialect.base());
    let cases = suite.cases.iter().filter(|case| spoken(&case.dialect));
    let keys: Vec<CaseKey<'_>> = cases.map(|case| (&*case.id, case.dialect)).collect();
    let universe = Universe::new(keys.iter().copied());
    let states: Vec<EntryState> = baseline
        .entries
        .iter()
        .map(|entry| EntryState::of(entry, &run.engine.version, day))
        .collect();
    // An entry that is past its day still says what its cases do.
    let holds = |index: usize| matches!(states[index], EntryState::Holds | EntryState::Expired(_));
    let owned = Owned::of(&baseline.entries, &keys, holds);
    let mut of_entry: Vec<Vec<CaseKey<'_>>> = vec![Vec::new(); baseline.entries.len()];
    for key in &keys {
        if let Some(&index) = owned.owners.get(key) {
            of_entry[index].push(*key);
        }
    }
    let fates: Vec<Fate> = baseline
        .entries
        .iter()
        .enumerate()
        .map(|(index, entry)| match owned.fits[index] {
            false if entry.is_beside(suite) => Fate::Kept,
            false => Fate::Removed("fits no case".to_owned()),
            true => fate(entry, &of_entry[index], run, &universe, &states[index]),
        })
        .collect();
    let added = added(baseline, run, &keys, &owned, &universe, day);
    let known: HashSet<CaseKey<'_>> = keys.iter().copied().collect();
    let strangers = run
        .verdicts
        .keys()
        .filter(|(id, dialect)| !known.contains(&(id.as_str(), *dialect)));
    Blessing {
        entries: left(&fates) + added.len(),
        changes: changes(baseline, &fates, &added),
        strangers: strangers.count(),
        text: write::rewritten(text, baseline, &run.engine.name, &fates, &added),
    }
}

fn fate(
    entry: &Entry,
    cases: &[CaseKey<'_>],
    run: &EngineRun,
    universe: &Universe<'_>,
    state: &EntryState,
) -> Fate {
    let mut left = HashSet::new();
    let mut seen = false;
    let mut gone: BTreeMap<Verdict, usize> = BTreeMap::new();
    for &key in cases {
        match run.verdict(key) {
            Some(verdict) if !entry.expects(verdict) => *gone.entry(verdict).or_default() += 1,
            found => {
                left.insert(key);
                seen |= found.is_some();
            }
        }
    }
    match (gone.is_empty(), left.is_empty()) {
        (true, _) if seen && matches!(state, EntryState::Expired(_)) => Fate::Undated,
        (true, _) => Fate::Kept,
        (false, true) => Fate::Removed(describe_verdicts(&gone)),
        (false, false) => Fate::Narrowed(universe.fold(&left), describe_verdicts(&gone)),
    }
}

/// Describes the verdicts of those cases of an entry that no longer have the expected one.
fn describe_verdicts(gone: &BTreeMap<Verdict, usize>) -> String {
    let numbers = gone.iter().map(|(verdict, number)| match verdict {
        Verdict::Pass => format!("{number} now pass"),
        verdict => format!("{number} now {verdict}"),
    });
    numbers.collect::<Vec<_>>().join(", ")
}

/// Returns new entries for the cases that did not pass and are not expected to fail.
fn added(
    baseline: &Baseline,
    run: &EngineRun,
    keys: &[CaseKey<'_>],
    owned: &Owned<'_>,
    universe: &Universe<'_>,
    day: Date,
) -> Vec<Added> {
    let mut unexpected: HashMap<Verdict, HashSet<CaseKey<'_>>> = HashMap::new();
    for &key in keys {
        let Some(verdict) = run.verdict(key) else { continue };
        let entry = owned.owners.get(&key).map(|&index| &baseline.entries[index]);
        let is_known = entry.is_some_and(|entry| entry.expects(verdict));
        if !verdict.is_as_expected() && !is_known {
            unexpected.entry(verdict).or_default().insert(key);
        }
    }
    let engine = format!("{} {}", run.engine.name, run.engine.version);
    let reason = format!("not looked into yet: seen on {day} in {}", engine.trim_end());
    let mut added: Vec<Added> = Vec::new();
    for (verdict, wanted) in unexpected {
        added.extend(universe.fold(&wanted).into_iter().map(|folded| Added {
            folded,
            verdict,
            reason: reason.clone(),
        }));
    }
    added.sort_by(|a, b| (&a.folded.case, a.verdict).cmp(&(&b.folded.case, b.verdict)));
    added
}

fn left(fates: &[Fate]) -> usize {
    let number = |fate: &Fate| match fate {
        Fate::Kept | Fate::Undated => 1,
        Fate::Narrowed(parts, _) => parts.len(),
        Fate::Removed(_) => 0,
    };
    fates.iter().map(number).sum()
}

fn changes(baseline: &Baseline, fates: &[Fate], added: &[Added]) -> Vec<EntryChange> {
    let of_old = baseline.entries.iter().zip(fates).filter_map(|(entry, fate)| {
        let (kind, why) = match fate {
            Fate::Kept => return None,
            Fate::Undated => (ChangeKind::Undated, "still so, and its day is past".to_owned()),
            Fate::Narrowed(_, why) => (ChangeKind::Narrowed, why.clone()),
            Fate::Removed(why) => (ChangeKind::Removed, why.clone()),
        };
        Some(EntryChange {
            kind,
            verdicts: entry.verdicts.clone(),
            case: entry.case.as_str().to_owned(),
            why,
        })
    });
    let of_new = added.iter().map(|added| EntryChange {
        kind: ChangeKind::Added,
        verdicts: vec![added.verdict],
        case: added.folded.case.clone(),
        why: match added.folded.cases {
            1 => "1 case".to_owned(),
            number => format!("{number} cases"),
        },
    });
    of_old.chain(of_new).collect()
}
