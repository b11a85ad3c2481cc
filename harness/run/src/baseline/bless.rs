//! Rewrites a baseline from the results of a run. Expectations are never touched: a baseline only states known deviations.

use super::Owned;
use super::fold::{CaseKey, Universe};
use super::matched::EntryState;
use super::write::{self, Added, Fate};
use super::{Baseline, Entry, shown};
use crate::Verdict;
use crate::event::{CaseEvent, Cause, EngineHeader, ExplainedCases};
use jiff::civil::Date;
use std::collections::{BTreeMap, HashMap, HashSet};
use stickler_suite::Suite;
use stickler_types::{DialectName, counted, join};

/// The verdicts of a run on one engine, as if it had no baseline.
#[derive(Clone, Debug)]
pub struct EngineRun {
    engine: EngineHeader,
    verdicts: BTreeMap<(String, DialectName), Verdict>,
    /// The claims of the cases that are not as expected.
    bases: HashMap<(String, DialectName), String>,
    causes: Vec<Cause>,
}

impl EngineRun {
    /// Creates the run of this engine, without cases.
    pub fn new(engine: EngineHeader) -> EngineRun {
        EngineRun {
            engine,
            verdicts: BTreeMap::new(),
            bases: HashMap::new(),
            causes: Vec::new(),
        }
    }

    /// Returns the header of the engine.
    pub fn engine(&self) -> &EngineHeader {
        &self.engine
    }

    /// Adds the verdict of a case, if the case ran on this engine.
    pub fn take(&mut self, case: &CaseEvent) {
        if case.engine != self.engine.name {
            return;
        }
        let Ok(dialect) = case.dialect.parse() else { return };
        if !case.verdict.is_as_expected() {
            self.bases.insert((case.id.clone(), dialect), case.basis.clone());
        }
        self.verdicts
            .insert((case.id.clone(), dialect), case.actual_verdict());
    }

    /// Adds a cause, if it is one of the engine.
    pub fn take_cause(&mut self, cause: Cause) {
        if cause.engine == self.engine.name {
            self.causes.push(cause);
        }
    }

    /// Returns the title of the cause that explains a case: of several that explain such cases of its probe, the one that explains most.
    fn explained(&self, (id, dialect): CaseKey<'_>, verdict: Verdict) -> Option<&str> {
        let basis = self.bases.get(&(id.to_owned(), dialect))?;
        let explains = |some: &&ExplainedCases| {
            id.split('(').next() == Some(&some.probe)
                && (some.dialect.as_str(), &some.basis, some.verdict) == (dialect.as_str(), basis, verdict)
        };
        let causes = self.causes.iter().filter_map(|cause| {
            let some = cause.cases.iter().find(explains)?;
            Some((some.cases, std::cmp::Reverse(cause.title.as_str())))
        });
        causes.max().map(|(_, title)| title.0)
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
    /// The first id or pattern of the entry and the number of the others; of an entry that stays, those before the change.
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
    /// Only some of the cases of the entry still have the expected verdict, and the entry is about these alone.
    Narrowed,
    /// The entry is about further cases, which have the cause that its reason begins with.
    Widened,
    /// The entry lost its last day, which is past although the entry still holds.
    Undated,
}

/// Rewrites the baseline of an engine, whose text is `text` (empty where there was none), from a run on the cases of this
/// suite. `day` is the day of the run.
///
/// Cases with one cause and one verdict get one entry, whose reason begins with the title of the cause. An entry stays as it is, with its
/// comments, while its cases have the expected verdicts; it is narrowed where only some do, widened where others have its cause, and
/// removed where none does. Cases that were not run stay as they are. Entries about other versions of the engine are
/// left alone.
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
    let mut unexpected = unexpected(baseline, run, &keys, &owned);
    let fates: Vec<Fate> = baseline
        .entries
        .iter()
        .enumerate()
        .map(|(index, entry)| {
            let (cases, state) = (&of_entry[index], &states[index]);
            let further = match entry.verdicts[..] {
                [verdict] if holds(index) => {
                    let title = entry.reason.split(SEEN).next().unwrap_or_default();
                    unexpected.remove(&(verdict, Some(title))).unwrap_or_default()
                }
                _ => HashSet::new(),
            };
            match &owned.unfit[index] {
                Some(_) if entry.is_beside(suite) => Fate::Kept,
                Some(_) if cases.is_empty() && further.is_empty() => Fate::Removed("fits no case".to_owned()),
                unfit => fate(entry, cases, (unfit.is_some(), further), run, &universe, state),
            }
        })
        .collect();
    let added = added(run, unexpected, &universe, day);
    let known: HashSet<CaseKey<'_>> = keys.iter().copied().collect();
    let strangers = run
        .verdicts
        .keys()
        .filter(|(id, dialect)| !known.contains(&(id.as_str(), *dialect)));
    let left = fates.iter().filter(|fate| !matches!(fate, Fate::Removed(_)));
    Blessing {
        entries: left.count() + added.len(),
        changes: changes(baseline, &fates, &added),
        strangers: strangers.count(),
        text: write::rewritten(text, baseline, &run.engine.name, &fates, &added),
    }
}

/// The cases that an entry is given because its reason names their cause.
type Further<'k> = HashSet<CaseKey<'k>>;

/// Returns what becomes of an entry, of which `is_stale` says whether a part of it fits no case.
fn fate<'k>(
    entry: &Entry,
    cases: &[CaseKey<'k>],
    (is_stale, further): (bool, Further<'k>),
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
    if !further.is_empty() {
        let why = counted(further.len() as u64, "case more", "cases more");
        left.extend(further);
        return Fate::Widened(universe.fold(&left), why);
    }
    match (gone.is_empty(), left.is_empty()) {
        (true, _) if is_stale => Fate::Narrowed(universe.fold(&left), "fits no case in part".to_owned()),
        (true, _) if seen && matches!(state, EntryState::Expired(_)) => Fate::Undated,
        (true, _) => Fate::Kept,
        (false, true) => Fate::Removed(describe_verdicts(&gone)),
        (false, false) => Fate::Narrowed(universe.fold(&left), describe_verdicts(&gone)),
    }
}

/// Describes the verdicts of those cases of an entry that no longer have the expected one.
fn describe_verdicts(gone: &BTreeMap<Verdict, usize>) -> String {
    let numbers = gone.iter();
    join(
        numbers.map(|(verdict, number)| format!("{number} now {verdict}")),
        ", ",
    )
}

/// The words between what an entry is about and where it was seen, in the reason of an entry that nobody has changed.
const SEEN: &str = ": seen on ";

/// The cases that did not pass and are not expected to fail, by their verdict and the title of their cause.
type Unexpected<'r, 'k> = BTreeMap<(Verdict, Option<&'r str>), HashSet<CaseKey<'k>>>;

fn unexpected<'r, 'k>(
    baseline: &Baseline,
    run: &'r EngineRun,
    keys: &[CaseKey<'k>],
    owned: &Owned<'_>,
) -> Unexpected<'r, 'k> {
    let mut unexpected = Unexpected::new();
    for &key in keys {
        let Some(verdict) = run.verdict(key) else { continue };
        let entry = owned.owners.get(&key).map(|&index| &baseline.entries[index]);
        let is_known = entry.is_some_and(|entry| entry.expects(verdict));
        if !verdict.is_as_expected() && !is_known {
            let cause = run.explained(key, verdict);
            unexpected.entry((verdict, cause)).or_default().insert(key);
        }
    }
    unexpected
}

/// Returns the new entries: one for each cause, and of cases whose cause is not known one for each pattern.
fn added(run: &EngineRun, unexpected: Unexpected<'_, '_>, universe: &Universe<'_>, day: Date) -> Vec<Added> {
    let engine = format!("{} {}", run.engine.name, run.engine.version);
    let reason = |about: &str| format!("{about}{SEEN}{day} in {}", engine.trim_end());
    let mut added: Vec<Added> = Vec::new();
    for ((verdict, cause), cases) in unexpected {
        let folded = universe.fold(&cases);
        let entry = |folded| Added {
            folded,
            verdict,
            reason: reason(cause.unwrap_or("not looked into yet")),
        };
        match cause {
            Some(_) => added.push(entry(folded)),
            None => added.extend(folded.into_iter().map(|one| entry(vec![one]))),
        }
    }
    added.sort_by(|a, b| (&a.folded[0].case, a.verdict).cmp(&(&b.folded[0].case, b.verdict)));
    added
}

fn changes(baseline: &Baseline, fates: &[Fate], added: &[Added]) -> Vec<EntryChange> {
    let of_old = baseline.entries.iter().zip(fates).filter_map(|(entry, fate)| {
        let (kind, why) = match fate {
            Fate::Kept => return None,
            Fate::Undated => (ChangeKind::Undated, "still so, and its day is past".to_owned()),
            Fate::Narrowed(_, why) => (ChangeKind::Narrowed, why.clone()),
            Fate::Widened(_, why) => (ChangeKind::Widened, why.clone()),
            Fate::Removed(why) => (ChangeKind::Removed, why.clone()),
        };
        Some(EntryChange {
            kind,
            verdicts: entry.verdicts.clone(),
            case: entry.shown(),
            why,
        })
    });
    let of_new = added.iter().map(|added| EntryChange {
        kind: ChangeKind::Added,
        verdicts: vec![added.verdict],
        case: shown(added.folded.iter().map(|one| one.case.as_str())),
        why: counted(
            added.folded.iter().map(|one| one.cases as u64).sum(),
            "case",
            "cases",
        ),
    });
    of_old.chain(of_new).collect()
}
