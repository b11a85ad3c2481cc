//! A cause: what one mend in a compiler would put right, with the smallest program that shows it.

use crate::{Fact, Verdict};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use stickler_engines::Reproduction;
use stickler_types::{grouped, joined};

/// A cause of failing cases on one engine: what one mend in the compiler would put right.
///
/// Causes are found after the cases, by asking the engine; `stickler_causes` says how. A run without that search has none.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Cause {
    /// The name of the engine.
    pub engine: String,
    /// The behaviour of the engine, as a key: `accepted P4035`, `rejected P0002 ;`, `value`.
    pub symptom: String,
    /// The constructs that a program needs to show the cause, as a key: `conversion integer and real`. Together with the
    /// engine and the symptom it is unique in a run, and by it the causes of several parts of a run are merged.
    pub construct: String,
    /// The cause in one line.
    pub title: String,
    /// The program that shows the cause best.
    pub shown: Reproducer,
    /// The extent to which the shown program was reduced.
    pub reduction: Reduced,
    /// The outcomes of several runs of the shown program; `None` where they were all the same.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub flaky: Option<Repeats>,
    /// The dialects in which the engine lacks a feature of the language, with the verdict on the feature's minimal program, where the cause
    /// is that: then its cases are waiting, its symptom is [`Cause::LACKS`], and its construct is the key of the feature.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub lacked_in: BTreeMap<String, Verdict>,
    /// The cases that fail for this cause, by probe, dialect, claim and verdict, in the order of the suite.
    pub cases: Vec<ExplainedCases>,
}

/// A program that shows a cause, what must happen and what happens.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Reproducer {
    /// The id of the case from which the program comes.
    pub case: String,
    /// The dialect of the case.
    pub dialect: String,
    /// The claim that the case checks: source and section.
    pub basis: String,
    /// The title of the case.
    pub about: String,
    /// The path of the case file; empty in a log of an earlier version.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub file: String,
    /// The line of the case in the case file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub line: Option<u32>,
    /// The program, without the header and the marks of the case.
    pub program: String,
    /// The expected facts; lines are those of the program.
    pub expected: Vec<Fact>,
    /// The actual facts.
    pub got: Vec<Fact>,
    /// Whether the program does other things than the case, so that the claim led to it but says nothing of it.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub is_derived: bool,
    /// The programs that differ from this one in one respect, and whether the engine deviates with each.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub neighbours: Vec<Neighbour>,
    /// The files and commands by which a person sees it without Stickler; `None` where the engine has no tools of its own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reproduction: Option<Reproduction>,
    /// The text that the commands of the reproduction print, without paths of the machine; empty where nobody ran them.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub printed: String,
}

impl Reproducer {
    /// Returns which neighbours deviate in the same way, and which do not, in sentences of a page; nothing where the engine was asked about none.
    pub fn neighbours_told(&self) -> Option<String> {
        let begins = [(true, "The same comes"), (false, "It does not come")].into_iter();
        let told = begins.filter_map(|(is_same, begins)| {
            let words = self.neighbours_in_words(is_same)?;
            Some(format!("{begins} {words}."))
        });
        let told: Vec<String> = told.collect();
        (!told.is_empty()).then(|| told.join(" "))
    }

    fn neighbours_in_words(&self, is_same: bool) -> Option<String> {
        let mut groups: Vec<(&str, Vec<&str>)> = Vec::new();
        for one in self.neighbours.iter().filter(|one| one.is_same == is_same) {
            match groups.last_mut() {
                Some((replaced, by)) if **replaced == one.replaced => by.push(&one.by),
                _ => groups.push((&one.replaced, vec![&one.by])),
            }
        }
        let words = groups.into_iter();
        let words =
            words.map(|(replaced, by)| format!("with {} in the place of {replaced}", joined(&by, "or")));
        let words: Vec<String> = words.collect();
        (!words.is_empty()).then(|| joined(&words, "or"))
    }
}

/// A program that differs from a shown one in one respect, about which the engine was asked too.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Neighbour {
    /// The elementary type, the integer literal, the location, the name or the dialect in whose place another stands, as a page writes it:
    /// `` `INT` ``.
    pub replaced: String,
    /// The type, the literal, the location, the name or the dialect that stands there instead.
    pub by: String,
    /// Whether the engine deviates in the same way; otherwise it does what it must.
    pub is_same: bool,
}

/// The extent to which a program was reduced.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Reduced {
    /// The program is as it was: the engine answered otherwise when it was asked again, or nothing can be left out.
    #[default]
    Not,
    /// The questions or the time for it were spent before it was as small as it can be, or before anything was asked.
    Partly,
    /// No smaller program was found.
    Smallest,
}

/// The outcomes of several runs of one program with which an engine does not do the same each time.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Repeats {
    /// The number of runs in which the engine deviated in the way of the cause.
    pub seen: u32,
    /// The number of all runs.
    pub of: u32,
    /// Each outcome that was seen, in the order in which they came.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub outcomes: Vec<RepeatedOutcome>,
}

/// An outcome of several runs of one program.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct RepeatedOutcome {
    /// The facts of the outcome.
    pub got: Vec<Fact>,
    /// The number of runs with this outcome.
    pub runs: u32,
}

/// A number of cases with a probe, dialect, claim and verdict in common.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ExplainedCases {
    /// The beginning that the ids of the cases share: a case file and a probe.
    pub probe: String,
    /// The dialect of the cases.
    pub dialect: String,
    /// The claim that they check.
    pub basis: String,
    /// Their verdict.
    pub verdict: Verdict,
    /// The number of the cases.
    pub cases: u64,
}

impl Cause {
    /// The symptom of a cause that is the lack of a feature.
    pub const LACKS: &str = "lacks";

    /// Returns whether the cause is the lack of a feature of the language.
    pub fn is_lack(&self) -> bool {
        !self.lacked_in.is_empty()
    }

    /// Returns the cause as a heading behind the name of the engine.
    pub fn headline(&self) -> String {
        format!("{}{}", self.verb(), self.title)
    }

    /// Returns what the engine does with a feature that it lacks: it dies at the minimal program, or gives no answer, or does not have it.
    /// Empty of another cause, whose title is a sentence.
    pub fn verb(&self) -> &'static str {
        let got = |is: fn(&Fact) -> bool| self.shown.got.iter().any(is);
        match self.is_lack() {
            true if got(|fact| matches!(fact, Fact::Crashed { .. })) => "dies at ",
            true if got(|fact| matches!(fact, Fact::TimedOut { .. })) => "never ends at ",
            true => "lacks ",
            false => "",
        }
    }

    /// Returns whether the cause is the lack of a feature that a source which binds the engine promises, or at whose minimal program the
    /// engine crashes or hangs.
    pub fn is_failing_lack(&self) -> bool {
        self.lacked_in.values().any(|verdict| !verdict.is_as_expected())
    }

    /// Returns the number of cases that fail for this cause.
    pub fn number(&self) -> u64 {
        self.cases.iter().map(|some| some.cases).sum()
    }

    /// Returns the number of these cases that are not as expected, which an expected failure is.
    pub fn unexpected(&self) -> u64 {
        let unexpected = self.cases.iter().filter(|some| !some.verdict.is_as_expected());
        unexpected.map(|some| some.cases).sum()
    }

    /// Returns the number of cases that fail for this cause, and before it how many of these are not as expected where not all are: `58`,
    /// `56 of 58`.
    pub fn cases_shown(&self) -> String {
        match (self.unexpected(), self.number()) {
            (0, all) => grouped(all),
            (unexpected, all) if unexpected == all => grouped(all),
            (unexpected, all) => format!("{} of {}", grouped(unexpected), grouped(all)),
        }
    }

    /// Returns whether no case of the cause contradicts a source that binds the engine.
    pub fn differs(&self) -> bool {
        !self.is_lack() && self.cases.iter().all(|some| some.verdict == Verdict::Differs)
    }

    /// Returns whether the questions were spent before the shown program was as small as it can be, or it shows something that came once.
    pub fn is_partly_reduced(&self) -> bool {
        let is_once = self.flaky.as_ref().is_some_and(|repeats| repeats.seen <= 1);
        self.reduction == Reduced::Partly || is_once && self.reduction == Reduced::Not
    }

    /// Returns whether two causes are the same, found in two parts of a run.
    pub fn is_same(&self, other: &Cause) -> bool {
        (&self.engine, &self.symptom, &self.construct) == (&other.engine, &other.symptom, &other.construct)
    }

    /// Adds what else was found out about the same cause: its cases, and its program where that is smaller.
    pub fn merge(&mut self, mut other: Cause) {
        let size = |reproducer: &Reproducer| (reproducer.program.len(), reproducer.program.clone());
        let is_smaller = size(&other.shown) < size(&self.shown);
        if other.flaky.is_none() && (is_smaller || self.flaky.is_some()) {
            std::mem::swap(&mut other.shown, &mut self.shown);
            (self.title, self.reduction, self.flaky) = (other.title.clone(), other.reduction, None);
        }
        self.lacked_in.append(&mut other.lacked_in);
        self.explain(other);
    }

    /// Adds the cases of another cause, which this one explains: its programs contain what fails here already.
    pub fn explain(&mut self, mut other: Cause) {
        for some in std::mem::take(&mut other.cases) {
            ExplainedCases::add(&mut self.cases, some);
        }
    }
}

impl ExplainedCases {
    /// Adds some cases to a list, to the entry with the same probe, dialect, claim and verdict where there is one.
    pub fn add(list: &mut Vec<ExplainedCases>, some: ExplainedCases) {
        let alike = |one: &&mut ExplainedCases| {
            (&one.probe, &one.dialect, &one.basis, one.verdict)
                == (&some.probe, &some.dialect, &some.basis, some.verdict)
        };
        match list.iter_mut().find(alike) {
            Some(one) => one.cases += some.cases,
            None => list.push(some),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cause(program: &str, cases: u64) -> Cause {
        Cause {
            engine: "compiler".to_owned(),
            title: program.to_owned(),
            shown: Reproducer {
                program: program.to_owned(),
                ..Reproducer::default()
            },
            cases: vec![ExplainedCases {
                probe: "t::p".to_owned(),
                verdict: Verdict::Fail,
                cases,
                ..ExplainedCases::default()
            }],
            ..Cause::default()
        }
    }

    #[test]
    fn of_two_parts_the_smaller_program_is_shown() {
        for (first, second) in [("short", "longer"), ("longer", "short")] {
            let mut whole = cause(first, 2);
            assert!(whole.is_same(&cause(second, 3)));
            whole.merge(cause(second, 3));
            assert_eq!(whole.number(), 5);
            assert_eq!((whole.title.as_str(), whole.cases.len()), ("short", 1));
            assert_eq!(whole.shown.program, "short");
        }
    }

    #[test]
    fn what_came_by_chance_gives_way_to_what_comes_each_time() {
        let mut whole = cause("short", 1);
        whole.flaky = Some(Repeats {
            seen: 3,
            of: 10,
            ..Repeats::default()
        });
        whole.merge(cause("longer", 1));
        assert_eq!((whole.title.as_str(), whole.flaky), ("longer", None));
    }
}
