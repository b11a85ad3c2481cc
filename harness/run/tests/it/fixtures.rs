//! Fixtures: cases made by hand, and an engine whose answers the test states.

use std::path::Path;
use std::sync::{Arc, LazyLock};
use stickler_engines::{
    Ability, Diagnostic, Engine, EngineError, Grade, Identity, NamedValue, Outcome, RunRequest, Session,
};
use stickler_run::{AnswerStore, Event, Plan, RunSummary, run_with};
use stickler_suite::{
    Acceptance, Case, Expectation, ExpectedDiagnostic, ExpectedFault, ExpectedValue, Suite,
};
use stickler_types::{DialectName, Observation, Value};
use stickler_workers::{Cancellation, Shard};

/// The cases of this repository, which take seconds to load.
static SHIPPED: LazyLock<Suite> =
    LazyLock::new(|| Suite::load(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance-cases")));

/// Returns the events of a run of one part in twenty of the cases of this repository, which is quick and covers every kind of case.
pub fn events_of_a_twentieth(engine: &dyn Engine, jobs: usize) -> Vec<Event> {
    let plan = Plan {
        jobs,
        shard: Some(Shard::new(1, 20).unwrap()),
        ..Plan::default()
    };
    timeless_events(&plan, &SHIPPED, &[engine])
}

/// Returns the events of a run, without their durations.
pub fn timeless_events(plan: &Plan, suite: &Suite, engines: &[&dyn Engine]) -> Vec<Event> {
    timeless_run(plan, suite, engines, &[]).1
}

/// Returns the summary and the events of a run with these stores, without their durations.
pub fn timeless_run(
    plan: &Plan,
    suite: &Suite,
    engines: &[&dyn Engine],
    stores: &[Option<&dyn AnswerStore>],
) -> (RunSummary, Vec<Event>) {
    let mut events = Vec::new();
    let mut sink = |mut event: Event| {
        match &mut event {
            Event::Header(_) | Event::Cause(_) => {}
            Event::Case(case) => case.duration_us = 0,
            Event::Footer(footer) => footer.duration_ms = 0,
        }
        events.push(event);
    };
    let cancel = Cancellation::new();
    let summary = run_with(plan, suite, engines, stores, &mut sink, &cancel).unwrap();
    (summary, events)
}

/// Returns a case that expects nothing but to be accepted.
pub fn case(id: &str) -> Case {
    Case {
        title: "A title".into(),
        basis: "a-source: A section".into(),
        file: "conformance-cases/area/file.st".into(),
        area: "area".into(),
        ..Case::of_program(id, DialectName::MATIEC, id)
    }
}

/// Returns a case with this expectation, which observes all the values that it asserts.
pub fn expecting(expectation: Expectation) -> Case {
    let observe = |value: &ExpectedValue| Observation {
        name: value.name.clone(),
        type_name: value.value.type_name().into(),
        after: value.after,
    };
    let observe: Arc<[Observation]> = expectation.values.iter().map(observe).collect();
    Case {
        observe,
        expectation: Arc::new(expectation),
        ..case("area/file")
    }
}

/// Returns the expectation of a rejection at these places, `6 P4035`.
pub fn rejection(places: &[&str]) -> Expectation {
    let place = |place: &&str| {
        let (line, code) = place.split_once(' ').unwrap();
        ExpectedDiagnostic {
            line: line.parse().unwrap(),
            code: code.parse().unwrap(),
        }
    };
    Expectation {
        accepted: Acceptance::Rejected,
        diagnostics: places.iter().map(place).collect(),
        ..Expectation::default()
    }
}

/// Returns the expectation of these values, `q = INT#1`.
pub fn values(values: &[&str]) -> Expectation {
    let value = |(name, value): NamedValue| ExpectedValue {
        name: name.into(),
        after: None,
        value,
        line: 9,
    };
    Expectation {
        values: named(values).into_iter().map(value).collect(),
        ..Expectation::default()
    }
}

/// Returns the expectation of a fault, `9 division-by-zero`.
pub fn fault(place: &str) -> Expectation {
    let (line, fault) = place.split_once(' ').unwrap();
    let fault = ExpectedFault {
        fault: fault.parse().unwrap(),
        line: line.parse().unwrap(),
    };
    Expectation {
        fault: Some(fault),
        ..Expectation::default()
    }
}

/// Returns values as an engine gives them, from `q = INT#1`.
pub fn named(values: &[&str]) -> Vec<NamedValue> {
    let value = |text: &&str| {
        let (name, literal) = text.split_once(" = ").unwrap();
        (name.to_owned(), Value::parse(literal).unwrap())
    };
    values.iter().map(value).collect()
}

/// Returns the outcome of an execution that ends with these values.
pub fn executed(values: &[&str]) -> Outcome {
    Outcome::executed(named(values))
}

/// Returns the outcome of a rejection with diagnostics at these places: `6 P4035`, `6 -` without a code, `- P4035` without a
/// line.
pub fn rejected(places: &[&str]) -> Outcome {
    let diagnostic = |place: &&str| {
        let (line, code) = place.split_once(' ').unwrap();
        let code = (code != "-").then(|| code.to_owned());
        Diagnostic {
            line: line.parse().ok(),
            code,
            message: "told".to_owned(),
            ..Diagnostic::default()
        }
    };
    Outcome::Rejected {
        diagnostics: places.iter().map(diagnostic).collect(),
    }
}

/// Returns a suite of these cases.
pub fn suite(cases: Vec<Case>) -> Suite {
    let mut suite = Suite::default();
    suite.version = "0.9".to_owned();
    suite.cases = cases;
    suite
}

type Answer = Box<dyn Fn(&RunRequest<'_>) -> Outcome + Send + Sync>;

/// An engine whose answers to `run` the test states.
pub struct Puppet {
    identity: Identity,
    answer: Answer,
    /// The function that is called whenever a session is opened.
    pub open: Box<dyn Fn() -> Result<(), EngineError> + Send + Sync>,
}

impl Puppet {
    /// Creates an engine with this name that supports all dialects.
    pub fn new(name: &str, answer: impl Fn(&RunRequest<'_>) -> Outcome + Send + Sync + 'static) -> Puppet {
        let identity = Identity {
            name: name.to_owned(),
            version: "1".to_owned(),
            dialects: DialectName::ALL.to_vec(),
            abilities: vec![Ability::Execute],
            grade: Grade::Code,
            lacks: Vec::new(),
        };
        Puppet {
            identity,
            answer: Box::new(answer),
            open: Box::new(|| Ok(())),
        }
    }

    /// Restricts the engine to this dialect.
    pub fn only(mut self, dialect: DialectName) -> Puppet {
        self.identity.dialects = vec![dialect];
        self
    }
}

impl Engine for Puppet {
    fn identity(&self) -> &Identity {
        &self.identity
    }

    fn session(&self) -> Result<Box<dyn Session + '_>, EngineError> {
        (self.open)()?;
        Ok(Box::new(PuppetSession(self)))
    }
}

struct PuppetSession<'e>(&'e Puppet);

impl Session for PuppetSession<'_> {
    fn run(&mut self, request: &RunRequest<'_>) -> Outcome {
        (self.0.answer)(request)
    }

    fn check(&mut self, _: DialectName, _: &str) -> Outcome {
        Outcome::ACCEPTED
    }

    fn render(&mut self, _: DialectName, source: &str) -> Outcome {
        Outcome::Rendered {
            text: source.to_owned(),
        }
    }
}
