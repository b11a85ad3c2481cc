//! Asks the foreign engines of a run, before its first case, for minimal programs of features and for counterparts.

use super::{CasesByFeatures, Counterpart, counterparts};
use super::{LackedFeature, Lacks, Refusal};
use crate::answer_store::{AnswerStore, ask_stored_together};
use crate::judge::judge;
use crate::{Answers, Fact, Judgement, Plan, RunError, Verdict, promise_of};
use std::collections::{BTreeMap, BTreeSet, HashMap};
use stickler_engines::{Engine, EngineSession, Identity, Outcome, Reference};
use stickler_suite::{Acceptance, Case, Feature, FeatureKey, Suite};
use stickler_types::DialectName;
use stickler_workers::{Cancellation, SpawnError, WorkerPool};

/// The number of cases whose features a worker finds at a time.
const BATCH_LEN: usize = 1024;

/// The reason that an engine gives for a feature that it is declared to lack.
const DECLARED: &str = "declared as lacking in stickler.toml";

/// A program that uses no feature: variables, assignments and INT are none.
const PLAINEST: &str = "PROGRAM main\nVAR\n    x : INT;\nEND_VAR\n    x := x;\nEND_PROGRAM\n";

/// The features that the selected cases of each dialect use.
type FeaturesOfDialects = BTreeMap<DialectName, BTreeSet<FeatureKey>>;

/// The reason why a program is asked about.
enum Question<'q, 's> {
    /// A program that uses no feature: `x := x;` of an INT.
    Plainest,
    /// The minimal program of a feature.
    Feature(&'s Feature),
    /// A case that must be accepted and differs least from cases that must be rejected.
    Counterpart(&'q Counterpart<'s>),
}

/// The plan, the suite and the engines of a run whose engines are asked what they lack.
pub(crate) struct Survey<'r, 's> {
    pub(crate) plan: &'r Plan,
    pub(crate) suite: &'s Suite,
    pub(crate) engines: &'r [&'r dyn Engine],
    pub(crate) stores: &'r [Option<&'r dyn AnswerStore>],
    pub(crate) cancel: &'r Cancellation,
}

/// Returns what each engine lacks of what the selected cases use. Nothing is asked of the reference, and of nobody where the suite has
/// no list of features.
///
/// # Errors
/// [`RunError::RejectsAll`] where an engine rejects even the plainest program; otherwise as the run itself.
pub(crate) fn survey<'s>(survey: &Survey<'_, 's>, selected: &[&'s Case]) -> Result<Vec<Lacks<'s>>, RunError> {
    let Survey { suite, engines, .. } = survey;
    let is_asked = |engine: &&dyn Engine| {
        engine.identity().name != Reference::NAME && suite.features.iter().next().is_some()
    };
    let speaks = |case: &&Case| {
        let mut engines = engines.iter().filter(|engine| is_asked(engine));
        engines.any(|engine| engine.identity().speaks(case.dialect))
    };
    let selected: Vec<&Case> = selected.iter().copied().filter(speaks).collect();
    let used = by_features(survey.plan, &selected)?;
    let mut of_dialects = FeaturesOfDialects::new();
    for (features, cases) in &used {
        for case in cases {
            of_dialects
                .entry(case.dialect)
                .or_default()
                .extend(features.iter().cloned());
        }
    }
    let files: BTreeSet<&str> = selected.iter().map(|case| &*case.file).collect();
    let is_beside = |case: &&Case| {
        case.expectation.accepted == Acceptance::Required && files.contains(&*case.file) && speaks(case)
    };
    let beside: Vec<&Case> = suite.cases.iter().filter(is_beside).collect();
    let counterparts = counterparts(&used, &by_features(survey.plan, &beside)?);
    let lacks = engines.iter().enumerate().map(|(engine, of)| match is_asked(of) {
        true => survey.lacks(engine, &of_dialects, &counterparts),
        false => Ok(Lacks::default()),
    });
    lacks.collect()
}

/// Returns the cases by the features that they use.
fn by_features<'s>(plan: &Plan, cases: &[&'s Case]) -> Result<CasesByFeatures<'s>, SpawnError> {
    let group = |(): &mut (), cases: &[&'s Case]| {
        let mut found = CasesByFeatures::new();
        for case in cases {
            found.entry(case.features()).or_default().push(*case);
        }
        Ok(found)
    };
    let mut found = CasesByFeatures::new();
    for (features, cases) in WorkerPool::new(plan.jobs)
        .map(cases.chunks(BATCH_LEN), || Ok(()), group)?
        .into_iter()
        .flatten()
    {
        found.entry(features).or_default().extend(cases);
    }
    Ok(found)
}

impl<'s> Survey<'_, 's> {
    /// Returns what one engine lacks.
    fn lacks(
        &self,
        engine: usize,
        used: &FeaturesOfDialects,
        counterparts: &[Counterpart<'s>],
    ) -> Result<Lacks<'s>, RunError> {
        let identity = self.engines[engine].identity();
        let none = Vec::new();
        let declared = self.plan.lacks.get(&identity.name).unwrap_or(&none);
        let mut asked: Vec<(Case, Question<'_, 's>)> = Vec::new();
        let mut features: BTreeMap<DialectName, Vec<LackedFeature<'s>>> = BTreeMap::new();
        for (&dialect, used) in used.iter().filter(|(dialect, _)| identity.speaks(**dialect)) {
            asked.push((
                Case::of_program("plainest", dialect, PLAINEST),
                Question::Plainest,
            ));
            let has = self
                .suite
                .features
                .iter()
                .filter(|feature| used.contains(&*feature.key) && has(dialect, feature));
            for feature in has {
                if declared.contains(&feature.key) {
                    features
                        .entry(dialect)
                        .or_default()
                        .push(LackedFeature::declared(feature));
                } else if !feature.needs.iter().any(|need| declared.contains(need)) {
                    let case = Case::of_program(&feature.key, dialect, &feature.program);
                    asked.push((case, Question::Feature(feature)));
                }
            }
        }
        let spoken = counterparts.iter().filter(|(of, _)| identity.speaks(of.dialect));
        asked.extend(spoken.map(|counterpart| (counterpart.0.clone(), Question::Counterpart(counterpart))));
        let answers = self.answers(engine, &asked)?;
        let mut lacks = Lacks {
            features,
            refused_counterparts: HashMap::new(),
        };
        for ((case, question), answers) in asked.iter().zip(answers) {
            let Some(answers) = answers.filter(|answers| Refusal::of(&answers.run).is_some()) else {
                continue;
            };
            match question {
                Question::Plainest => rejects_all(identity, case, &answers.run)?,
                Question::Feature(feature) => {
                    let lacked = self.judged(feature, case, &answers, identity);
                    lacks.features.entry(case.dialect).or_default().push(lacked);
                }
                Question::Counterpart((of, rejected)) => {
                    let rejected = rejected.iter().map(|case| ((&*case.id, case.dialect), &*of.id));
                    lacks.refused_counterparts.extend(rejected);
                }
            }
        }
        lacks.features.values_mut().for_each(retain_roots);
        Ok(lacks)
    }

    /// Returns the judgement on a feature whose minimal program an engine refuses.
    fn judged(
        &self,
        feature: &'s Feature,
        case: &Case,
        answers: &Answers,
        engine: &Identity,
    ) -> LackedFeature<'s> {
        let Judgement { verdict, got, .. } = judge(case, answers, self.plan.strict(engine));
        let basis = promise_of(feature, (&feature.program, case.dialect), engine, self.suite);
        let is_stated = Refusal::of(&answers.run) == Some(Refusal::Stated);
        // Where an adapter cannot ask, that says nothing of the compiler.
        let is_missed = basis.is_some() && !matches!(answers.run, Outcome::Unsupported { .. });
        LackedFeature {
            feature,
            verdict: match (is_stated, is_missed) {
                (false, _) => verdict,
                (true, true) => Verdict::Fail,
                (true, false) => Verdict::Unsupported,
            },
            basis: basis.unwrap_or_default(),
            got,
        }
    }

    /// Returns the answers of an engine about programs, from its store where that has them; `None` for those that were not asked
    /// before the run was cancelled.
    fn answers(
        &self,
        engine: usize,
        asked: &[(Case, Question<'_, '_>)],
    ) -> Result<Vec<Option<Answers>>, RunError> {
        let store = self.stores.get(engine).copied().flatten();
        let engine = self.engines[engine];
        let size = if self.plan.unpacked { 1 } else { engine.pack_size() };
        let ask = |session: &mut EngineSession<'_>, cases: &[(Case, Question<'_, '_>)]| {
            let cases: Vec<&Case> = cases.iter().map(|(case, _)| case).collect();
            let stopping = || self.cancel.is_requested();
            Ok::<_, RunError>(ask_stored_together(session, &cases, store, (size, &stopping))?)
        };
        let open_session = || Ok(EngineSession::new(engine));
        let answers = WorkerPool::new(self.plan.jobs).map(asked.chunks(size), open_session, ask)?;
        let answers = answers.into_iter().flatten().collect();
        Ok(answers)
    }
}

impl<'s> LackedFeature<'s> {
    /// Returns a feature that an engine is declared to lack, which is not asked for.
    fn declared(feature: &'s Feature) -> LackedFeature<'s> {
        LackedFeature {
            feature,
            verdict: Verdict::Unsupported,
            basis: "".into(),
            got: vec![Fact::Unsupported {
                reason: DECLARED.to_owned(),
            }],
        }
    }
}

/// Returns whether a dialect has a feature: the reference takes its minimal program.
fn has(dialect: DialectName, feature: &Feature) -> bool {
    let checked = Reference::new()
        .session()
        .map(|mut session| session.check(dialect, &feature.program));
    checked.is_ok_and(|outcome| matches!(outcome, Outcome::Accepted { .. }))
}

/// Keeps of the features that an engine lacks those that do not need another of them; of those that need each other the first.
fn retain_roots(lacked: &mut Vec<LackedFeature<'_>>) {
    let features: Vec<&Feature> = lacked.iter().map(|lacked| lacked.feature).collect();
    let needs = |one: &Feature, other: &Feature| one.needs.contains(&other.key);
    let is_root = |at: usize, one: &Feature| {
        let mut others = features.iter().enumerate();
        !others.any(|(place, other)| needs(one, other) && (place < at || !needs(other, one)))
    };
    let roots = features.iter().enumerate().map(|(at, one)| is_root(at, one));
    let mut roots = roots.collect::<Vec<_>>().into_iter();
    lacked.retain(|_| roots.next() == Some(true));
}

/// # Errors
/// [`RunError::RejectsAll`] where the outcome is a rejection.
fn rejects_all(engine: &Identity, case: &Case, outcome: &Outcome) -> Result<(), RunError> {
    let Outcome::Rejected { .. } = outcome else {
        return Ok(());
    };
    Err(RunError::RejectsAll {
        engine: engine.name.clone(),
        dialect: case.dialect,
        said: outcome.to_string(),
    })
}
