//! Asks an engine to execute the minimal programs of features, cases that use them, and the programs that measure parameters.

use super::CompliancePlan;
use serde::Deserialize;
use std::collections::BTreeMap;
use stickler_engines::{EngineSession, Observation, Outcome, RunRequest};
use stickler_run::{Event, Fact, Plan, RunError, Verdict, clip_line};
use stickler_suite::{Acceptance, Case, Feature, Suite};
use stickler_types::DialectName;
use stickler_workers::{Cancellation, WorkerPool};

/// The maximum number of cases that are run for a feature: those first that must be accepted, and of them those with the fewest features.
const MAX_CASES: usize = 4;

/// The maximum length of what a message is quoted of, in characters.
const MAX_QUOTE: usize = 160;

/// The results of asking an engine for features: a word for each, and an example where that is not `has`.
#[derive(Default)]
pub(super) struct MeasuredFeatures(BTreeMap<String, (&'static str, String)>);

impl MeasuredFeatures {
    /// Asks the engine for the minimal program of each feature, and for cases that use those that it has; nothing where there is no engine.
    ///
    /// # Errors
    /// An engine or a thread that cannot be started.
    pub(super) fn ask(plan: &CompliancePlan<'_>, features: &[&Feature]) -> Result<Self, RunError> {
        let Some(engine) = plan.engine else {
            return Ok(MeasuredFeatures::default());
        };
        let open = || Ok::<_, RunError>(EngineSession::open(engine)?);
        let asked = WorkerPool::new(0).map(features.iter(), open, |session, feature| {
            let outcome = outcome(session, plan.dialect, &feature.program, &[])?;
            let word = match outcome {
                Outcome::Accepted { .. } | Outcome::Executed { .. } => {
                    return Ok((feature.key.clone(), ("has", String::new())));
                }
                Outcome::Unsupported { .. } => "not asked",
                Outcome::Rejected { .. } | Outcome::NotImplemented { .. } => "lacks",
                _ => "differs",
            };
            Ok((feature.key.clone(), (word, quoted(&outcome))))
        })?;
        let mut measured = MeasuredFeatures(asked.into_iter().collect());
        let chosen = measured.choose(plan)?;
        let mut suite = Suite::default();
        let cases = chosen.values().flatten();
        suite.cases = cases.map(|case| (*case).clone()).collect();
        suite.sources = plan.suite.sources.clone();
        suite.features = plan.suite.features.clone();
        let mut failing = BTreeMap::new();
        let mut sink = |event| {
            if let Event::Case(case) = event
                && matches!(
                    case.verdict,
                    Verdict::Fail | Verdict::Differs | Verdict::Crash | Verdict::Timeout | Verdict::Error
                )
            {
                let text = |facts| clip_line(&Fact::text(facts).replace('\n', "; "), MAX_QUOTE);
                let example = format!("{}: {}, not {}", case.id, text(&case.got), text(&case.expected));
                failing.insert(case.id, example);
            }
        };
        if !suite.cases.is_empty() {
            stickler_run::run(
                &Plan::default(),
                &suite,
                &[engine],
                &mut sink,
                &Cancellation::default(),
            )?;
        }
        for (key, cases) in chosen {
            if let Some(example) = cases.iter().find_map(|case| failing.get(&*case.id)) {
                measured.0.insert(key, ("differs", example.clone()));
            }
        }
        Ok(measured)
    }

    /// Returns for each feature that the engine has up to [`MAX_CASES`] cases of the dialect that use it.
    ///
    /// # Errors
    /// No threads.
    fn choose<'a>(&self, plan: &CompliancePlan<'a>) -> Result<BTreeMap<String, Vec<&'a Case>>, RunError> {
        let is_judged = |case: &Case| !case.is_open() && case.expectation.rendered.is_none();
        let is_asked = |case: &&Case| case.dialect == plan.dialect && is_judged(case);
        let cases: Vec<&Case> = plan.suite.cases.iter().filter(is_asked).collect();
        let features = |(): &mut (), case: &&'a Case| Ok::<_, RunError>((case.features(), *case));
        let mut used = WorkerPool::new(0).map(cases.iter(), || Ok(()), features)?;
        used.sort_by_key(|(used, case)| (case.expectation.accepted == Acceptance::Rejected, used.len()));
        let mut chosen: BTreeMap<String, Vec<&Case>> = BTreeMap::new();
        for (used, case) in used {
            for key in used {
                let best = chosen.entry(key.into_owned()).or_default();
                if best.len() < MAX_CASES {
                    best.push(case);
                }
            }
        }
        chosen.retain(|key, _| self.0.get(key).is_some_and(|(word, _)| *word == "has"));
        Ok(chosen)
    }

    /// Takes what was measured of a feature.
    pub(super) fn take(&mut self, key: &str) -> (&'static str, String) {
        self.0.remove(key).unwrap_or(("not asked", String::new()))
    }
}

/// Returns what an engine does with a program: it runs it, or where it cannot, checks it.
///
/// # Errors
/// An engine that cannot be started again.
fn outcome(
    session: &mut EngineSession<'_>,
    dialect: DialectName,
    program: &str,
    observe: &[Observation],
) -> Result<Outcome, RunError> {
    Ok(match session.run(&RunRequest::once(dialect, program, observe))? {
        Outcome::Unsupported { .. } if observe.is_empty() => session.check(dialect, program)?,
        run => run,
    })
}

fn quoted(outcome: &Outcome) -> String {
    clip_line(outcome.to_string().lines().next().unwrap_or_default(), MAX_QUOTE)
}

/// A parameter that the standard leaves to the implementer, and the program that measures it, as `parameters.toml` describes both.
#[derive(Deserialize)]
struct Parameter {
    title: String,
    program: Option<String>,
    #[serde(default)]
    sizes: Vec<usize>,
    #[serde(default)]
    repeat: Vec<String>,
    observe: Option<String>,
    #[serde(default)]
    means: BTreeMap<String, String>,
}

/// Returns the parameters, each with what was measured on the engine.
///
/// # Errors
/// An engine or a thread that cannot be started.
pub(super) fn parameters(plan: &CompliancePlan<'_>) -> Result<Vec<Vec<String>>, RunError> {
    let file: BTreeMap<String, Vec<Parameter>> =
        toml::from_str(include_str!("parameters.toml")).unwrap_or_default();
    let all: Vec<&Parameter> = file.values().flatten().collect();
    let open = || Ok::<_, RunError>(plan.engine.map(EngineSession::open).transpose()?);
    WorkerPool::new(0).map(all.iter(), open, |session, parameter| {
        let measured = match (session, &parameter.program) {
            (Some(session), Some(program)) => parameter.measure(session, plan.dialect, program)?,
            _ => "not measured".to_owned(),
        };
        Ok(vec![parameter.title.clone(), measured])
    })
}

impl Parameter {
    /// Returns what an engine does: the greatest size that it takes, or the value of the variable.
    ///
    /// # Errors
    /// An engine that cannot be started again.
    fn measure(
        &self,
        session: &mut EngineSession<'_>,
        dialect: DialectName,
        program: &str,
    ) -> Result<String, RunError> {
        if let Some((name, ty)) = self.observe.as_deref().and_then(|text| text.split_once(" : ")) {
            return Ok(
                match outcome(session, dialect, program, &[Observation::last(name, ty)])? {
                    Outcome::Executed { values, .. } => {
                        let value = values
                            .first()
                            .map_or_else(String::new, |(_, value)| value.to_string());
                        self.means.get(&value).cloned().unwrap_or(value)
                    }
                    other => quoted(&other),
                },
            );
        }
        let mut taken = String::new();
        for &size in &self.sizes {
            let mut text = program.replace("{n}", &size.to_string());
            for (index, repeated) in self.repeat.iter().enumerate() {
                text = text.replace(&format!("{{{index}}}"), &repeated.repeat(size));
            }
            match outcome(session, dialect, &text, &[])? {
                Outcome::Accepted { .. } | Outcome::Executed { .. } => taken = format!("at least {size}"),
                other => {
                    return Ok(format!("{taken}, not {size}: {}", quoted(&other))
                        .trim_start_matches(", ")
                        .to_owned());
                }
            }
        }
        Ok(taken)
    }
}
