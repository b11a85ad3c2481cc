//! The causes that tell which features an engine lacks, and which cases wait for each.

use super::{LackedFeature, Lacks, is_type};
use crate::judge::judge;
use crate::{Answers, CaseEvent, Cause, ExplainedCases, Fact, Grade, Reduced, Reproducer, Verdict};
use std::collections::BTreeMap;
use stickler_engines::{Ability, Engine, EngineSession, reproduce_and_run};
use stickler_reduce::{Interestingness, ReductionBudget};
use stickler_suite::{Case, Feature};
use stickler_types::DialectName;

/// The maximum number of characters that are kept of what the commands of a reproduction print.
const MAX_PRINTED: usize = 10_000;

/// The maximum number of questions for a smaller program with a feature.
const TRIES: u64 = 40;

/// The cases of one engine that wait for features, by the key of the feature.
#[derive(Debug, Default)]
pub(crate) struct WaitingCases(BTreeMap<String, Waiting>);

/// The cases that wait for a feature.
#[derive(Debug, Default)]
struct Waiting {
    /// The id of the first one of each dialect.
    first: BTreeMap<String, String>,
    cases: Vec<ExplainedCases>,
    /// The document that promises the feature by the first case of a dialect that uses no other, by dialect.
    promised: BTreeMap<String, String>,
}

impl WaitingCases {
    /// Adds a case to each of the features that it waits for.
    pub(crate) fn take(&mut self, event: &CaseEvent) {
        for fact in &event.got {
            let Fact::Lacks {
                feature, promised_by, ..
            } = fact
            else {
                continue;
            };
            let waiting = self.0.entry(feature.clone()).or_default();
            let first = waiting.first.entry(event.dialect.clone());
            first.or_insert_with(|| event.id.clone());
            if let Some(basis) = promised_by {
                let of_dialect = waiting.promised.entry(event.dialect.clone());
                of_dialect.or_insert_with(|| basis.clone());
            }
            let explained = ExplainedCases {
                probe: event.probe().to_owned(),
                dialect: event.dialect.clone(),
                basis: event.basis.clone(),
                verdict: event.verdict,
                cases: 1,
            };
            ExplainedCases::add(&mut waiting.cases, explained);
        }
    }

    /// Returns a cause for each feature that the engine lacks, those for which most cases wait first.
    pub(crate) fn causes(&self, lacks: &Lacks<'_>, engine: &dyn Engine) -> Vec<Cause> {
        let mut causes: Vec<Cause> = Vec::new();
        for (&dialect, features) in &lacks.features {
            for lacked in features {
                let key = &lacked.feature.key;
                let lacked = &self.promised(lacked, dialect);
                let cause = match causes.iter_mut().find(|cause| cause.construct == *key) {
                    Some(cause) => cause,
                    None => {
                        let waiting = self.0.get(key);
                        causes.push(cause(lacked, dialect, waiting, engine));
                        continue;
                    }
                };
                cause
                    .lacked_in
                    .insert(dialect.as_str().to_owned(), lacked.verdict);
                // The dialect in which the feature is promised is the one to show.
                if cause.shown.basis.is_empty() && !lacked.basis.is_empty() {
                    cause.shown = reproducer(lacked, dialect, self.0.get(key), engine);
                }
            }
        }
        causes.sort_by_key(|cause| std::cmp::Reverse(cause.number()));
        join_types(causes)
    }

    /// Returns a feature as one that fails where only the document of a case promises it. What an engine is declared to lack, or cannot be
    /// asked, fails nothing.
    fn promised<'s>(&self, lacked: &LackedFeature<'s>, dialect: DialectName) -> LackedFeature<'s> {
        let waiting = self.0.get(&lacked.feature.key);
        let basis = waiting.and_then(|waiting| waiting.promised.get(dialect.as_str()));
        let is_told =
            lacked.verdict == Verdict::Unsupported && !matches!(lacked.got[..], [Fact::Unsupported { .. }]);
        match basis.filter(|_| is_told) {
            Some(basis) => LackedFeature {
                verdict: Verdict::Fail,
                basis: basis.clone().into(),
                ..lacked.clone()
            },
            None => lacked.clone(),
        }
    }
}

/// Makes one cause of those of data types that the same source promises and the engine refuses in the same words: it has one list of types.
fn join_types(causes: Vec<Cause>) -> Vec<Cause> {
    let mut joined: Vec<Cause> = Vec::new();
    for cause in causes {
        let said = refused_type(&cause);
        let is_same = |other: &&mut Cause| {
            let of = |cause: &Cause| (cause.lacked_in.clone(), cause.shown.basis.clone());
            said.is_some() && refused_type(other) == said && of(other) == of(&cause)
        };
        match joined.iter_mut().find(is_same) {
            Some(first) => {
                let several = first.title.replace("data type ", "data types ");
                first.title = format!("{several}, {}", cause.construct.to_ascii_uppercase());
                first.construct = format!("{}, {}", first.construct, cause.construct);
                for some in cause.cases {
                    ExplainedCases::add(&mut first.cases, some);
                }
            }
            None => joined.push(cause),
        }
    }
    joined
}

/// Returns what the engine said of the first data type of a cause, without its name; `None` where the cause is the lack of something else.
fn refused_type(cause: &Cause) -> Option<String> {
    let first = cause
        .construct
        .split(", ")
        .next()
        .filter(|first| is_type(first))?;
    let said = cause.shown.got.iter().find_map(Fact::diagnostic)?;
    Some(said.message.replace(&first.to_ascii_uppercase(), ""))
}

fn cause(
    lacked: &LackedFeature<'_>,
    dialect: DialectName,
    waiting: Option<&Waiting>,
    engine: &dyn Engine,
) -> Cause {
    Cause {
        engine: engine.identity().name.clone(),
        symptom: Cause::LACKS.to_owned(),
        construct: lacked.feature.key.clone(),
        title: lacked.feature.title.clone(),
        shown: reproducer(lacked, dialect, waiting, engine),
        reduction: Reduced::Smallest,
        lacked_in: BTreeMap::from([(dialect.as_str().to_owned(), lacked.verdict)]),
        cases: waiting.map_or(Vec::new(), |waiting| waiting.cases.clone()),
        ..Cause::default()
    }
}

/// Returns the smallest program with a feature that an engine refuses as it refuses the minimal program, and what it does with it. The minimal
/// program is one that every compiler takes which has the feature, and may have more than this one needs.
fn smallest(lacked: &LackedFeature<'_>, dialect: DialectName, engine: &dyn Engine) -> (String, Vec<Fact>) {
    let Feature { key, program, .. } = lacked.feature;
    let refused = refusal(program, &lacked.got);
    if refused.is_none() {
        return (program.clone(), lacked.got.clone());
    }
    let mut session = EngineSession::new(engine);
    let mut got = lacked.got.clone();
    let mut is_refused = |text: &str| {
        let case = Case::of_program(key, dialect, text);
        // Without a PROGRAM a compiler may refuse what has nothing missing.
        if !case.features().contains(&**key) || !text.contains("PROGRAM") {
            return Interestingness::Invalid;
        }
        let Ok(outcome) = session.run(&case.request()) else {
            return Interestingness::Invalid;
        };
        let seen = judge(&case, &Answers::of_run(outcome), Grade::Rejected).got;
        let is_same = refusal(text, &seen) == refused;
        if is_same {
            got = seen;
        }
        Interestingness::from(is_same)
    };
    let budget = ReductionBudget {
        tries: TRIES,
        ..ReductionBudget::default()
    };
    let mut found = stickler_reduce::text(program, dialect, &mut is_refused, &budget).value;
    // The standard demands a statement, and so do some compilers.
    let emptied = found.replace("    ;\n", "");
    if emptied != found && is_refused(&emptied) == Interestingness::Interesting {
        found = emptied;
    }
    (found, got)
}

/// Returns what an engine says of a program that it refuses: the code and the message, and the text of the line; `None` where it gives
/// no diagnostic.
fn refusal<'p>(program: &'p str, got: &[Fact]) -> Option<(Option<String>, String, Option<&'p str>)> {
    let first = got.iter().find_map(Fact::diagnostic)?;
    let line = first
        .line
        .and_then(|line| program.lines().nth((line as usize).checked_sub(1)?));
    Some((first.code.clone(), first.message.clone(), line.map(str::trim)))
}

/// Returns the minimal program of a feature; where the feature fails, with the commands that show it and what they print.
fn reproducer(
    lacked: &LackedFeature<'_>,
    dialect: DialectName,
    waiting: Option<&Waiting>,
    engine: &dyn Engine,
) -> Reproducer {
    let case = waiting.and_then(|waiting| waiting.first.get(dialect.as_str()));
    let is_expected = lacked.verdict.is_as_expected();
    let (program, got) = match is_expected {
        true => (lacked.feature.program.clone(), lacked.got.clone()),
        false => smallest(lacked, dialect, engine),
    };
    let asked = Case::of_program(&lacked.feature.key, dialect, &program);
    let shown = (!is_expected).then(|| reproduce_and_run(engine, &asked.request(), Ability::Check).ok());
    let (reproduction, printed) = shown.flatten().unzip();
    Reproducer {
        case: case.cloned().unwrap_or_default(),
        dialect: dialect.as_str().to_owned(),
        basis: lacked.basis.clone().into_owned(),
        about: lacked.feature.title.clone(),
        program,
        expected: vec![Fact::Accepted],
        got,
        reproduction,
        printed: printed.map_or(String::new(), |printed| {
            let text = printed.map_or_else(|reason| reason, |output| output.text);
            text.chars().take(MAX_PRINTED).collect()
        }),
        ..Reproducer::default()
    }
}
