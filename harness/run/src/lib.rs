//! Runs cases on engines, judges what they answer, and emits one stream of [`Event`]s.
//!
//! The way of a case: [`select`](select()) picks it, a worker of the [`schedule`](run()) asks an engine and
//! gets [`Answers`], [`judge`](judge()) holds them against the expectation, the engine's [`Baseline`] says whether that was
//! known, and the [`Judgement`], a list of [`Fact`]s beside what was expected, goes out as a [`CaseEvent`]. Before that,
//! [`drop_changed_cases`] drops the cases of a custom dialect whose result its overrides change. This crate does not know how
//! events are shown.

mod answer_store;
mod answers;
mod baseline;
mod binding;
mod case_judge;
mod clip;
mod event;
mod fact;
mod filter;
mod inherited;
mod judge;
mod lacks;
mod pack;
mod plan;
mod schedule;
mod symptom;

pub use answer_store::{AnswerStore, ask_stored, ask_stored_together, question};
pub use answers::{Answers, Rendering, ask, shown_by};
pub use baseline::{
    Baseline, BaselineError, Blessing, ChangeKind, EngineRun, Entry, EntryChange, MatchedBaseline, bless,
};
pub use binding::{Binding, Claim, binding, is_asked, promise, promise_of, promises, versions};
pub use case_judge::CaseJudge;
pub use clip::{clip_facts, clip_line};
pub use event::{BaselineHeader, BaselineNote, DefinedHeader, OutdatedEntry};
pub use event::{CaseEvent, EngineHeader, EngineTotals, Event, FORMAT, Footer, Header, Observed, PROGRAM};
pub use event::{Cause, ExplainedCases, Neighbour, Reduced, RepeatedOutcome, Repeats, Reproducer};
pub use event::{Totals, Verdict};
pub use fact::Fact;
pub use filter::{Filter, pattern_fits, select};
pub use inherited::{dialect_headers, drop_changed_cases};
pub use judge::{Judgement, expected_facts, judge, rendered_bodies};
pub use lacks::Lacks;
pub use pack::breaks_reading;
pub use plan::{Plan, RunError, RunSummary};
pub use schedule::{run, run_with};
pub use stickler_engines::Grade;
pub use stickler_suite::{Source, SourceKind};
pub use symptom::Symptom;
