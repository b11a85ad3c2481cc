//! Fixtures: cases made by hand, and an engine whose answers the test states.

use crate::words::expecting;
use std::collections::HashMap;
use std::ops::Range;
use std::path::Path;
use std::sync::{LazyLock, Mutex};
use stickler_engines::{Ability, ClosureEngine, Engine, Grade, Identity, Outcome, RunRequest};
use stickler_run::{
    AnswerStore, Answers, CaseEvent, EngineHeader, Event, Footer, Plan, Rendering, RunError, RunSummary,
    Verdict, run_with,
};
use stickler_suite::{Case, Sources, Suite, Wanted};
use stickler_types::DialectName;
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

/// Returns the end and the events of a run.
pub fn go(plan: &Plan, suite: &Suite, engines: &[&dyn Engine]) -> (Result<RunSummary, RunError>, Vec<Event>) {
    let mut events = Vec::new();
    let mut sink = |event| events.push(event);
    let ended = run_with(plan, suite, engines, &[], &mut sink, &Cancellation::new());
    (ended, events)
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
        id: id.into(),
        source: id.into(),
        ..expecting("")
    }
}

/// Returns a suite of so many cases, each with its number at the end of its id, which is its program.
pub fn numbered(numbers: Range<usize>) -> Suite {
    suite(numbers.map(|number| case(&format!("area/{number}"))).collect())
}

/// Returns the number at the end of the id of a case of [`numbered`].
pub fn number(source: &str) -> usize {
    source.rsplit('/').next().unwrap().parse().unwrap()
}

/// Returns the sources of Stickler's own suite.
pub fn sources(folder: &str) -> Sources {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    Suite::load_files(&cases, Wanted::default(), |_, _| false).sources
}

/// Returns the plan of so many workers.
pub fn with_jobs(jobs: usize) -> Plan {
    Plan {
        jobs,
        ..Plan::default()
    }
}

/// Returns the ids, dialects and engines of the cases among some events.
pub fn ids(events: &[Event]) -> Vec<String> {
    let id = |event: &Event| match event {
        Event::Case(case) => Some(format!("{}@{} {}", case.id, case.dialect, case.engine)),
        Event::Header(_) | Event::Cause(_) | Event::Footer(_) => None,
    };
    events.iter().filter_map(id).collect()
}

/// Returns the ids, dialects and engines of the cases of [`numbered`] on `puppet`.
pub fn numbered_ids(numbers: Range<usize>) -> Vec<String> {
    numbers
        .map(|number| format!("area/{number}@matiec puppet"))
        .collect()
}

/// Returns the footer of a whole run.
pub fn footer(events: &[Event]) -> Option<&Footer> {
    match events.last() {
        Some(Event::Footer(footer)) => Some(footer),
        _ => None,
    }
}

/// An answer store that lasts as long as the test.
#[derive(Default)]
pub struct Book {
    /// The answers that were stored before the run began.
    pub before: HashMap<String, String>,
    pub now: Mutex<HashMap<String, String>>,
}

impl Book {
    /// Returns the store for the next run.
    pub fn turned(self) -> Book {
        let mut before = self.before;
        before.extend(self.now.into_inner().unwrap());
        Book {
            before,
            now: Mutex::default(),
        }
    }
}

impl AnswerStore for Book {
    fn get(&self, question: &str) -> Option<&str> {
        self.before.get(question).map(String::as_str)
    }

    fn put(&self, question: &str, answers: &str) {
        let mut now = self.now.lock().unwrap();
        now.insert(question.to_owned(), answers.to_owned());
    }
}

/// Returns a suite of these cases.
pub fn suite(cases: Vec<Case>) -> Suite {
    let mut suite = Suite::default();
    suite.version = "0.9".to_owned();
    suite.cases = cases;
    suite
}

/// Returns an engine with this name that supports all dialects, and renders every program as it is.
pub fn puppet(
    name: &str,
    run: impl Fn(&RunRequest<'_>) -> Outcome + Send + Sync + 'static,
) -> ClosureEngine<'static> {
    let mut engine = ClosureEngine::new(name, move |_, request| run(request));
    engine.identity = Identity {
        name: name.to_owned(),
        version: "1".to_owned(),
        dialects: DialectName::ALL.to_vec(),
        abilities: vec![Ability::Execute],
        grade: Grade::Code,
        lacks: Vec::new(),
    };
    engine.render = Some(Box::new(|_, source| Outcome::Rendered {
        text: source.to_owned(),
    }));
    engine
}

/// Returns an engine that gives these answers about any case.
pub fn answering(name: &str, answers: Answers) -> ClosureEngine<'static> {
    let Answers { run, rendering } = answers;
    let Some(Rendering { first, again, rerun }) = rendering else {
        return puppet(name, move |_| run.clone());
    };
    let is_rendered =
        |source: &str, first: &Outcome| matches!(first, Outcome::Rendered { text } if text == source);
    let of_run = first.clone();
    let mut engine = puppet(name, move |request| match &rerun {
        Some(rerun) if is_rendered(request.source, &of_run) => rerun.clone(),
        _ => run.clone(),
    });
    engine.render = Some(Box::new(move |_, source| match &again {
        Some(again) if is_rendered(source, &first) => again.clone(),
        _ => first.clone(),
    }));
    engine
}

/// Returns what a run says about an engine of this name.
pub fn engine_header(name: &str) -> EngineHeader {
    EngineHeader {
        name: name.to_owned(),
        version: "1.2".to_owned(),
        dialects: vec!["ironplc-ed2".to_owned(), "ironplc-ed3".to_owned()],
        strict: Grade::Code,
        rerun: String::new(),
        commands: std::collections::BTreeMap::new(),
    }
}

/// Returns the event of a case on `iron`.
pub fn event(id: &str, dialect: DialectName, verdict: Verdict) -> CaseEvent {
    CaseEvent {
        id: id.to_owned(),
        dialect: dialect.to_string(),
        engine: "iron".to_owned(),
        verdict,
        ..CaseEvent::default()
    }
}
