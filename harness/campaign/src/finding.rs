//! A finding: a disagreement, reduced, with all that is needed to see it again.

use crate::oracle::Mismatch;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use stickler_causes::CauseKey;
use stickler_generate::model::Program;
use stickler_generate::oracles::FuzzTarget;
use stickler_reduce::{Reduction, StopReason};
use stickler_run::Observed;
use stickler_types::{DialectName, Fnv1a, join};

/// The version of the form in which findings are saved.
pub const FORMAT: u32 = 1;

/// The [target](Finding::target) of a finding of a campaign with engines.
pub const DIFFERENTIAL: &str = "differential";

/// The number of characters of a symptom that stand in a name at most; some compilers say much.
const MAX_KIND_LEN: usize = 40;

/// A disagreement or crash, reduced and run again.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
pub struct Finding {
    /// [`FORMAT`]. Keys may be added under the same number.
    pub format: u32,
    /// The name of the finding and of its folder: the subject, the symptom, and a fingerprint of [`Finding::cause`], or of
    /// [`Finding::rule`] where that is unknown.
    pub id: String,
    /// The version of Stickler that found it.
    pub stickler: String,
    /// The target whose oracle found it, or [`DIFFERENTIAL`].
    pub target: String,
    /// The engine that disagrees; `None` where it is the reference, asked by a target of its own.
    pub engine: Option<EngineInfo>,
    /// The symptom in a word, such as `value:INT`, `rejected:P4035`, `crash`.
    pub symptom: String,
    /// The parts of the language that the reduced program uses: functions, operators, kinds of statements. Sorted.
    pub rule: Vec<String>,
    /// The cause, as far as the reduced program tells it; `None` where the input is no program, or the finding is flaky.
    #[serde(default)]
    pub cause: Option<CauseKey>,
    /// The dialect of the program, where the input is one.
    pub dialect: Option<String>,
    /// Whether the disagreement was seen again.
    pub standing: Confirmation,
    /// The place where the input was found, and the course of its reduction.
    pub origin: FindingOrigin,
    /// A description of what happened, for a person.
    pub message: String,
    /// The result that must come.
    pub expected: ExpectedBehavior,
    /// The outcome of each engine on the reduced program.
    pub outcomes: Vec<EngineReport>,
    /// Commands for a shell: the first judges the saved program again, the second finds the original again.
    pub reproduce: Vec<String>,
    /// The hash of the saved program, so that one that was edited is not taken for what was found.
    pub fingerprint: String,
    /// The reduced program; in a file of its own.
    #[serde(skip)]
    pub program: Option<String>,
    /// The program as it was found; in a file of its own.
    #[serde(skip)]
    pub original: Option<String>,
    /// The bytes that the target judges, as small as they could be made; in a file of its own.
    #[serde(skip)]
    pub input: Vec<u8>,
}

/// An engine that was asked.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct EngineInfo {
    /// The name of the engine in the campaign.
    pub name: String,
    /// The version of the engine, in its own words.
    pub version: String,
    /// The value of `--engine` that stands for the engine.
    pub asked_for: String,
}

/// Whether a finding was seen again.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Confirmation {
    /// The reduced program was run once more, and did the same.
    Confirmed,
    /// A second run did something else, or the engine was gone. The finding is kept as it was found.
    #[default]
    Flaky,
}

/// The origin of a finding.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
pub struct FindingOrigin {
    /// The seed of the campaign.
    pub seed: u64,
    /// The place of the input in the row of that seed.
    pub place: u64,
    /// Whether the campaign let programs use what documents leave open.
    pub open: bool,
    /// Whether nothing smaller was left to try; otherwise the end of the campaign, or the limit of tries, cut the reduction
    /// short.
    pub smallest: bool,
    /// The number of smaller inputs that were tried.
    pub tries: u64,
    /// Lines, or bytes where the input is no program, as it was found.
    pub size_found: u64,
    /// Lines, or bytes where the input is no program, now.
    pub size: u64,
}

/// The result that must come.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(tag = "what", rename_all = "lowercase")]
pub enum ExpectedBehavior {
    /// The program is accepted, and at its end its variables have these values.
    Values {
        /// The variables and their values, as typed literals.
        values: Vec<Observed>,
        /// The document and section that say so; `None` where something that happened is open.
        basis: Option<String>,
        /// The events that no document settles.
        opened: Vec<String>,
    },
    /// The program is rejected, by this diagnostic and no other.
    Rejected {
        /// The code.
        code: String,
        /// The line, from 1.
        line: u32,
        /// The document and section that say so.
        basis: Option<String>,
    },
    /// The target's property holds, which is stated in words.
    Property {
        /// The property that holds for every input.
        claim: String,
    },
}

impl Default for ExpectedBehavior {
    fn default() -> ExpectedBehavior {
        ExpectedBehavior::Property { claim: String::new() }
    }
}

/// The outcome of one engine.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct EngineReport {
    /// The engine.
    pub engine: EngineInfo,
    /// `executed`, `rejected`, `crashed` …
    pub outcome: String,
    /// One fact a line: values, diagnostics, reasons.
    pub said: Vec<String>,
}

impl Finding {
    /// Begins the finding of a mismatch that `target` found, of which nothing else is known yet: it is flaky, and has no program.
    pub(crate) fn begin(target: &str, mismatch: &Mismatch, seed: u64) -> Finding {
        Finding {
            format: FORMAT,
            stickler: env!("CARGO_PKG_VERSION").to_owned(),
            target: target.to_owned(),
            symptom: mismatch.symptom.clone(),
            origin: FindingOrigin {
                seed,
                place: mismatch.place,
                tries: 1,
                ..FindingOrigin::default()
            },
            ..Finding::default()
        }
    }

    /// Enters a program that the input stands for, as small as it was made, and how much that took.
    pub(crate) fn enter(&mut self, reduced: &Reduction<Program>) {
        self.dialect = Some(reduced.value.dialect.as_str().to_owned());
        self.origin.smallest = reduced.ended == StopReason::Smallest;
        self.origin.tries = self.origin.tries.saturating_add(reduced.tries);
    }

    /// Names the finding by what it is, so that it has the same name whoever finds it.
    pub fn named(mut self) -> Finding {
        let who = self.subject().to_owned();
        let mut print = Fnv1a::default();
        print.write_part(&self.target);
        match &self.cause {
            Some(cause) => {
                cause.constructs.iter().for_each(|part| print.write_part(part));
                print.write_part(&cause.symptom);
            }
            None => {
                self.rule.iter().for_each(|part| print.write_part(part));
                print.write_part(self.kind());
            }
        }
        let kind: String = self.kind().chars().take(MAX_KIND_LEN).collect();
        self.id = format!("{}-{:08x}", file_name(&format!("{who}-{kind}")), print.folded());
        self.fingerprint = fingerprint(self.program.as_deref(), &self.input);
        self
    }

    /// Returns the kind of symptom, without the type of a value: what a compiler does wrong it mostly does with several types.
    pub fn kind(&self) -> &str {
        kind(&self.symptom)
    }

    /// Returns whether this finding is probably the same as another: the same is wrong with more of the language around it.
    pub fn is_like(&self, simpler: &Finding) -> bool {
        let is_contained = |simpler: BTreeSet<&String>, own: BTreeSet<&String>| {
            !simpler.is_empty() && simpler != own && simpler.is_subset(&own)
        };
        let needs_more = match (&self.cause, &simpler.cause) {
            (Some(own), Some(simpler)) => {
                own.symptom == simpler.symptom
                    && is_contained(
                        simpler.constructs.iter().collect(),
                        own.constructs.iter().collect(),
                    )
            }
            _ => false,
        };
        self.id != simpler.id
            && self.subject() == simpler.subject()
            && self.target == simpler.target
            && self.kind() == simpler.kind()
            && (needs_more || is_contained(simpler.rule.iter().collect(), self.rule.iter().collect()))
    }

    /// Returns the name of the engine that disagrees, or of the target where that asks the reference alone.
    pub fn subject(&self) -> &str {
        self.engine.as_ref().map_or(&self.target, |engine| &engine.name)
    }

    /// Returns the unit of the sizes: lines of a program, or bytes where the input is none.
    pub fn unit(&self) -> &'static str {
        self.program.as_ref().map_or("bytes", |_| "lines")
    }

    /// Returns the fuzz target, if one found it and this version of Stickler has it.
    pub fn target(&self) -> Option<FuzzTarget> {
        FuzzTarget::from_word(&self.target)
    }

    /// Returns the dialect, if the input is a program and this version of Stickler knows it.
    pub fn dialect(&self) -> Option<DialectName> {
        self.dialect.as_deref()?.parse().ok()
    }

    /// Returns whether the program and the input are those that were found.
    pub fn is_as_found(&self) -> bool {
        self.fingerprint == fingerprint(self.program.as_deref(), &self.input)
    }

    /// Returns whether this finding is worth keeping in place of another of its name: seen again before flaky, small before large; the
    /// earlier place where they are alike, so that the choice does not depend on who came first.
    pub fn improves_on(&self, other: &Finding) -> bool {
        self.rank() < other.rank()
    }

    /// Returns whether this finding is worth keeping among others, which are known by their names.
    pub(crate) fn is_best_of(&self, known: &BTreeMap<String, Finding>) -> bool {
        known.get(&self.id).is_none_or(|known| self.improves_on(known))
    }

    fn rank(&self) -> (Confirmation, bool, u64, usize, u64, u64) {
        let length = self.program.as_ref().map_or(self.input.len(), String::len);
        (
            self.standing,
            !self.origin.smallest,
            self.origin.size,
            length,
            self.origin.place,
            self.origin.seed,
        )
    }
}

/// Returns the kind of a symptom, as [`Finding::kind`] does.
pub(crate) fn kind(symptom: &str) -> &str {
    match symptom.split_once(':') {
        Some((kind @ ("value" | "missing"), _)) => kind,
        _ => symptom,
    }
}

fn fingerprint(program: Option<&str>, input: &[u8]) -> String {
    let mut print = Fnv1a::default();
    print.write_part(program.unwrap_or_default());
    print.write_part(input);
    format!("{:016x}", print.finish())
}

/// Lower-case letters, digits and hyphens alone, so that any file system takes it.
fn file_name(name: &str) -> String {
    let words = name.split(|character: char| !character.is_ascii_alphanumeric());
    join(words.filter(|word| !word.is_empty()), "-").to_ascii_lowercase()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    #[test]
    fn a_name_tells_who_and_how_and_is_a_file_name() {
        let finding = sample::finding("My Compiler", "value:INT", &["MOD"], 9);
        assert!(finding.id.starts_with("my-compiler-value-"), "{}", finding.id);
        assert_eq!(finding.id.len(), "my-compiler-value-".len() + 8);
        let rejected = sample::finding("a", "rejected:P4035", &["MOD"], 9);
        assert!(rejected.id.starts_with("a-rejected-p4035-"), "{}", rejected.id);
    }

    #[test]
    fn what_is_the_same_has_the_same_name_wherever_it_was_found() {
        let one = sample::finding("a", "crash", &["FOR", "MOD"], 9);
        let other = sample::finding("a", "crash", &["FOR", "MOD"], 12);
        assert_eq!(one.id, other.id);
        assert_ne!(one.id, sample::finding("a", "crash", &["FOR"], 9).id);
        assert_ne!(one.id, sample::finding("b", "crash", &["FOR", "MOD"], 9).id);
    }

    #[test]
    fn a_finding_is_named_by_its_cause_where_that_is_known() {
        let with = |rule: &[&str], constructs: &[&str]| {
            let cause = CauseKey {
                title: "CONSTANT".to_owned(),
                symptom: "rejected".to_owned(),
                constructs: constructs.iter().map(|&part| part.to_owned()).collect(),
                labels: BTreeSet::from(["LREAL".to_owned()]),
            };
            let finding = sample::finding("a", "rejected", rule, 9);
            let cause = Some(cause);
            Finding { cause, ..finding }.named()
        };
        let (one, other) = (with(&["FOR"], &["call"]), with(&["MOD"], &["call"]));
        assert_eq!(one.id, other.id);
        let more = with(&["FOR"], &["call", "result"]);
        assert_ne!(one.id, more.id);
        assert!(more.is_like(&one) && !one.is_like(&more));
        let cause = one.cause.unwrap();
        assert!(
            cause.is_explained_by("rejected", "call, LREAL") && cause.is_explained_by("rejected", "call")
        );
        assert!(!cause.is_explained_by("rejected", ""), "another defect of more");
        assert!(!more.cause.unwrap().is_explained_by("rejected", "call"));
        assert!(!cause.is_explained_by("rejected", "call, result"));
        assert!(!cause.is_explained_by("value", "call"));
    }

    #[test]
    fn a_finding_is_like_one_that_needs_less_of_the_language() {
        let simple = sample::finding("a", "value:INT", &["MOD"], 9);
        let more = sample::finding("a", "value:UINT", &["INT_TO_UINT", "MOD"], 9);
        assert!(more.is_like(&simple) && !simple.is_like(&more) && !simple.is_like(&simple));
        assert!(!sample::finding("b", "value:INT", &["FOR", "MOD"], 9).is_like(&simple));
        assert!(!sample::finding("a", "crash", &["FOR", "MOD"], 9).is_like(&simple));
        assert!(!more.is_like(&sample::finding("a", "value:INT", &[], 9)));
    }

    #[test]
    fn the_better_of_two_does_not_depend_on_their_order() {
        let small = sample::finding("a", "crash", &[], 3);
        let large = sample::finding("a", "crash", &[], 30);
        assert!(small.improves_on(&large) && !large.improves_on(&small));
        let flaky = Finding {
            standing: Confirmation::Flaky,
            ..small
        };
        assert!(large.improves_on(&flaky) && !flaky.improves_on(&large));
    }

    #[test]
    fn a_program_that_was_edited_is_noticed() {
        let finding = sample::finding("a", "crash", &[], 3);
        assert!(finding.is_as_found());
        let edited = Finding {
            program: Some("PROGRAM other END_PROGRAM".to_owned()),
            ..finding
        };
        assert!(!edited.is_as_found());
    }
}
