//! Rewriting a baseline from what a run found. Expectations are never touched: a baseline only says what is known.

use super::fold::{Folded, Key, Universe};
use super::matched::EntryState;
use super::owned::Owned;
use super::{Baseline, Entry, write};
use crate::Verdict;
use crate::event::{CaseEvent, EngineHeader};
use jiff::civil::Date;
use std::collections::{BTreeMap, HashMap, HashSet};
use stickler_suite::Suite;
use stickler_types::DialectName;

/// What a run found on one engine, before its baseline was held against it.
#[derive(Clone, Debug)]
pub struct EngineRun {
    engine: EngineHeader,
    verdicts: BTreeMap<(String, DialectName), Verdict>,
}

impl EngineRun {
    /// A run of this engine, without cases.
    #[must_use]
    pub fn new(engine: EngineHeader) -> EngineRun {
        EngineRun {
            engine,
            verdicts: BTreeMap::new(),
        }
    }

    /// The engine.
    #[must_use]
    pub fn engine(&self) -> &EngineHeader {
        &self.engine
    }

    /// Adds a case, if it is one of this engine.
    pub fn take(&mut self, case: &CaseEvent) {
        if case.engine != self.engine.name {
            return;
        }
        let Ok(dialect) = case.dialect.parse() else { return };
        self.verdicts
            .insert((case.id.clone(), dialect), case.actual_verdict());
    }

    fn verdict(&self, (id, dialect): Key<'_>) -> Option<Verdict> {
        self.verdicts.get(&(id.to_owned(), dialect)).copied()
    }
}

/// A baseline, rewritten.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Blessing {
    /// The whole text of its file.
    pub text: String,
    /// What is different from before, in the order of the file.
    pub changes: Vec<Change>,
    /// How many entries there are now.
    pub entries: usize,
    /// How many cases of the run are no longer in the suite; nothing is said about them.
    pub strangers: usize,
}

/// Something that is different in a baseline.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Change {
    /// What happened to the entry.
    pub kind: ChangeKind,
    /// What it expects, or expected; any of them where there are several.
    pub verdicts: Vec<Verdict>,
    /// Its case or pattern; of one that was narrowed, what it was.
    pub case: String,
    /// How many cases it is about, or what came of them, as a fragment.
    pub why: String,
}

/// What happened to an entry.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ChangeKind {
    /// It is new.
    Added,
    /// It is gone.
    Removed,
    /// Only some of its cases are still as it said; they have entries with the same reason.
    Narrowed,
    /// Its day was past and it still holds; the day is gone.
    Undated,
}

/// What becomes of an entry.
pub(super) enum Fate {
    Kept,
    Undated,
    Narrowed(Vec<Folded>, String),
    Removed(String),
}

/// A new entry.
pub(super) struct Added {
    pub(super) folded: Folded,
    pub(super) verdict: Verdict,
    pub(super) reason: String,
}

/// Rewrites the baseline of an engine, whose text is `text` (empty where there was none), from a run on the cases of this
/// suite. `day` is the day of the run.
///
/// An entry stays as it is, comments and all, while its cases do as it says; it is narrowed where only some do, and goes where
/// none does. Cases that were not run stay as they are. Entries about other versions of the engine are left alone.
#[must_use]
pub fn bless(text: &str, baseline: &Baseline, run: &EngineRun, suite: &Suite, day: Date) -> Blessing {
    // As for [`Identity::asked_in`](stickler_engines::Identity::asked_in), of which only the names are known.
    let named = |dialect: DialectName| run.engine.dialects.iter().any(|name| name == dialect.as_str());
    let spoken = |dialect: &DialectName| named(*dialect) || named(dialect.base().name());
    let cases = suite.cases.iter().filter(|case| spoken(&case.dialect));
    let keys: Vec<Key<'_>> = cases.map(|case| (&*case.id, case.dialect)).collect();
    let universe = Universe::new(keys.iter().copied());
    let states: Vec<EntryState> = baseline
        .entries
        .iter()
        .map(|entry| EntryState::of(entry, &run.engine.version, day))
        .collect();
    // An entry that is past its day still says what its cases do.
    let holds = |index: usize| matches!(states[index], EntryState::Holds | EntryState::Expired(_));
    let owned = Owned::of(&baseline.entries, &keys, holds);
    let mut of_entry: Vec<Vec<Key<'_>>> = vec![Vec::new(); baseline.entries.len()];
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
    let known: HashSet<Key<'_>> = keys.iter().copied().collect();
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
    cases: &[Key<'_>],
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
        (false, true) => Fate::Removed(told(&gone)),
        (false, false) => Fate::Narrowed(universe.fold(&left), told(&gone)),
    }
}

/// What came of the cases of an entry that are not as it says.
fn told(gone: &BTreeMap<Verdict, usize>) -> String {
    let told = gone.iter().map(|(verdict, number)| match verdict {
        Verdict::Pass => format!("{number} now pass"),
        verdict => format!("{number} now {verdict}"),
    });
    told.collect::<Vec<_>>().join(", ")
}

/// Entries for what did not pass and is not expected.
fn added(
    baseline: &Baseline,
    run: &EngineRun,
    keys: &[Key<'_>],
    owned: &Owned<'_>,
    universe: &Universe<'_>,
    day: Date,
) -> Vec<Added> {
    let mut unexpected: HashMap<Verdict, HashSet<Key<'_>>> = HashMap::new();
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

fn changes(baseline: &Baseline, fates: &[Fate], added: &[Added]) -> Vec<Change> {
    let of_old = baseline.entries.iter().zip(fates).filter_map(|(entry, fate)| {
        let (kind, why) = match fate {
            Fate::Kept => return None,
            Fate::Undated => (ChangeKind::Undated, "still so, and its day is past".to_owned()),
            Fate::Narrowed(_, why) => (ChangeKind::Narrowed, why.clone()),
            Fate::Removed(why) => (ChangeKind::Removed, why.clone()),
        };
        Some(Change {
            kind,
            verdicts: entry.verdicts.clone(),
            case: entry.case.as_str().to_owned(),
            why,
        })
    });
    let of_new = added.iter().map(|added| Change {
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
