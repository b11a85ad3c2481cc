//! A baseline matched with the cases of a suite, and its application to their judgements.

use super::Owned;
use super::fold::CaseKey;
use super::{Baseline, Entry};
use crate::event::{BaselineHeader, BaselineNote, OutdatedEntry};
use crate::{Filter, Judgement, Verdict};
use jiff::civil::Date;
use semver::Version;
use std::collections::HashMap;
use stickler_engines::Identity;
use stickler_suite::Suite;
use stickler_types::{DialectName, version_numbers};

/// The baseline of one engine, matched with the cases of a suite.
#[derive(Debug)]
pub struct MatchedBaseline<'a> {
    header: BaselineHeader,
    /// The note of each entry.
    notes: Vec<BaselineNote>,
    /// The index of the entry that each case belongs to.
    owners: HashMap<CaseKey<'a>, usize>,
}

impl<'a> MatchedBaseline<'a> {
    /// Finds which cases of the suite each entry of an engine's baseline is about, and which entries are out of date on this day.
    ///
    /// An entry that is a case's id goes before one that is a pattern; of two patterns the first of the file counts. Where files of
    /// the suite are broken, no entry is out of date because it fits no case.
    pub fn new(baseline: &Baseline, suite: &'a Suite, engine: &Identity, today: Date) -> MatchedBaseline<'a> {
        let states: Vec<EntryState> = baseline
            .entries
            .iter()
            .map(|entry| EntryState::of(entry, &engine.version, today))
            .collect();
        let spoken = suite.cases.iter().filter(|case| engine.speaks(case.dialect));
        let cases: Vec<CaseKey<'_>> = spoken.map(|case| (&*case.id, case.dialect)).collect();
        let owned = Owned::of(&baseline.entries, &cases, |index| {
            states[index] == EntryState::Holds
        });
        let outdated = baseline.entries.iter().zip(&states).enumerate();
        let outdated = outdated.filter_map(|(index, (entry, state))| {
            let is_certain = suite.errors.is_empty() && !entry.is_beside(suite);
            let unfit = owned.unfit[index].as_ref().filter(|_| is_certain);
            Some(OutdatedEntry {
                at: baseline.place(entry),
                case: unfit.map_or_else(|| entry.shown(), |unfit| unfit.as_str().to_owned()),
                why: state.outdated(unfit)?,
            })
        });
        MatchedBaseline {
            header: BaselineHeader {
                engine: engine.name.clone(),
                file: baseline.file.clone(),
                entries: baseline.entries.len() as u64,
                outdated: outdated.collect(),
            },
            notes: baseline
                .entries
                .iter()
                .map(|entry| note(baseline, entry))
                .collect(),
            owners: owned.owners,
        }
    }

    /// Returns the entry for the baseline in the header of a run.
    pub fn header(&self) -> &BaselineHeader {
        &self.header
    }

    /// Applies the baseline to the judgement of a case, and returns the note on the case: an expected verdict becomes
    /// `xfail`, and a pass that is not expected becomes `xpass`. A pass that is among the expected verdicts stays a pass, a
    /// case that is expected to be unsupported or to differ keeps that verdict, and every verdict that is not expected stays as it
    /// is.
    pub fn apply(
        &self,
        id: &str,
        dialect: DialectName,
        judgement: Judgement,
    ) -> (Judgement, Option<BaselineNote>) {
        let Some(note) = self.owners.get(&(id, dialect)).map(|&index| &self.notes[index]) else {
            return (judgement, None);
        };
        let came = judgement.verdict;
        let (verdict, note) = match (came, note.verdicts().contains(&came)) {
            (Verdict::Pass, false) => (Verdict::Xpass, note.clone()),
            (Verdict::Pass | Verdict::Unsupported | Verdict::Differs, _) | (_, false) => (came, note.clone()),
            (_, true) => (Verdict::Xfail, note.of_xfail(came)),
        };
        (Judgement { verdict, ..judgement }, Some(note))
    }
}

fn note(baseline: &Baseline, entry: &Entry) -> BaselineNote {
    // A baseline with an entry without verdicts cannot be read.
    let (verdict, others) = entry.verdicts.split_first().unwrap_or((&Verdict::Fail, &[]));
    BaselineNote {
        at: baseline.place(entry),
        verdict: *verdict,
        others: others.to_vec(),
        reason: entry.reason.clone(),
        link: entry.link.clone(),
    }
}

/// The state of an entry for a version of the engine on a day.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum EntryState {
    /// The entry holds.
    Holds,
    /// The entry is about other versions.
    OtherVersions,
    /// The entry is limited to versions, and the engine's version text contains no version number.
    UnknownVersion(String),
    /// The last day of the entry, which it holds, is past.
    Expired(Date),
}

impl EntryState {
    pub(super) fn of(entry: &Entry, version: &str, today: Date) -> EntryState {
        if let Some(range) = &entry.versions {
            match version_numbers(version) {
                None => return EntryState::UnknownVersion(version.to_owned()),
                // A suffix is ignored, since version ranges do not depend on it.
                Some([major, minor, patch]) if !range.matches(&Version::new(major, minor, patch)) => {
                    return EntryState::OtherVersions;
                }
                Some(_) => {}
            }
        }
        match entry.until {
            Some(until) if until < today => EntryState::Expired(until),
            _ => EntryState::Holds,
        }
    }

    /// Returns the reason why the entry is out of date, if it is.
    /// `unfit` is an id or a pattern of it that fits no case.
    fn outdated(&self, unfit: Option<&Filter>) -> Option<String> {
        if let Some(unfit) = unfit {
            return Some(match unfit.is_pattern() {
                true => "fits no case that the engine could be asked".to_owned(),
                false => "is no case that the engine could be asked; a pattern has a `*`".to_owned(),
            });
        }
        match self {
            EntryState::UnknownVersion(version) => Some(format!(
                "names versions, and `{version}`, which the engine says of itself, is none"
            )),
            EntryState::Expired(until) => Some(format!("was to hold until {until}")),
            EntryState::Holds | EntryState::OtherVersions => None,
        }
    }
}
