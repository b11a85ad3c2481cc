//! The key of a cause by one small program and what the engine did with it, without asking the engine anything more.

use crate::essence::Essence;
use crate::normal_form::Normal;
use crate::plainness::value_features;
use crate::program::read;
use crate::question::Deviation;
use crate::reduction::Smallest;
use crate::smaller_case::expected_value;
use crate::title::title;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use std::sync::Arc;
use stickler_run::{Answers, Cause, Fact, Grade, Symptom, Verdict, judge};
use stickler_suite::{Case, Expectation};
use stickler_types::{DialectName, NamedValue, Outcome};

/// The key of a cause, and its title, by a program that shows it. Two programs with the same symptom and the same constructs show one
/// cause of an engine.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct CauseKey {
    /// The cause in one line.
    pub title: String,
    /// The behaviour of the engine, as [`stickler_run::Cause::symptom`]: `rejected P4017`, `value`.
    pub symptom: String,
    /// The constructs that the program needs to show the cause.
    pub constructs: BTreeSet<String>,
    /// The properties of the values and types of the program, of which the cause may need some.
    pub labels: BTreeSet<String>,
}

impl CauseKey {
    /// Returns the key for a program without marks that must be accepted and give these values, by what an engine did with it;
    /// `None` where it did what it must, or does not support the program.
    pub fn of_program(
        program: &str,
        dialect: DialectName,
        values: &[NamedValue],
        outcome: &Outcome,
    ) -> Option<CauseKey> {
        let case = case(program, dialect, values);
        // The grade only says how exactly a rejection must be right; here none is, so any grade does.
        let strict = Grade::Rejected;
        let judged = judge(&case, &Answers::of_run(outcome.clone()), strict);
        judged
            .verdict
            .is_discrepancy()
            .then(|| CauseKey::of_facts(program, judged.verdict, (judged.expected, judged.got)))
    }

    /// Returns the key of the program that shows a cause, as that of any other program, so that both can be compared.
    pub fn of_shown(cause: &Cause) -> CauseKey {
        let verdict = cause.cases.first().map_or(Verdict::Fail, |some| some.verdict);
        let facts = (cause.shown.expected.clone(), cause.shown.got.clone());
        CauseKey::of_facts(&cause.shown.program, verdict, facts)
    }

    /// Returns whether a cause that a run of the suite found, by its symptom and its constructs, explains this one: it is of the
    /// same symptom, this one needs no other construct, and all that the cause needs is there.
    pub fn is_explained_by(&self, symptom: &str, construct: &str) -> bool {
        let needs: Vec<&str> = construct.split(", ").filter(|need| !need.is_empty()).collect();
        let has = |need: &&str| self.constructs.iter().chain(&self.labels).any(|own| own == need);
        self.symptom == symptom
            && needs.iter().all(has)
            && self.constructs.iter().all(|own| needs.contains(&own.as_str()))
    }

    fn of_facts(program: &str, verdict: Verdict, facts: (Vec<Fact>, Vec<Fact>)) -> CauseKey {
        CauseKey::of_deviation(program, Deviation::new(program, verdict, facts, Grade::Rejected))
    }

    /// Returns the key of a program by how an engine deviates with it.
    pub(crate) fn of_deviation(program: &str, deviation: Deviation) -> CauseKey {
        let smallest = Smallest::known(program.to_owned(), deviation);
        let essence = Essence::of(&smallest, &Normal::unasked(&smallest));
        let labels = match smallest.deviation.sign.symptom {
            Symptom::Value | Symptom::Missing => read(program, value_features),
            _ => BTreeSet::new(),
        };
        CauseKey {
            // No code in the title, since the symptom carries it.
            title: title(&smallest, false),
            symptom: essence.symptom,
            constructs: essence.constructs,
            labels,
        }
    }
}

fn case(program: &str, dialect: DialectName, values: &[NamedValue]) -> Case {
    Case {
        expectation: Arc::new(Expectation {
            values: values.iter().cloned().map(expected_value).collect(),
            ..Expectation::default()
        }),
        ..Case::of_program("found", dialect, program)
    }
}
