//! Runs cases on engines, judges what they answer, and emits one stream of [`Event`]s.
//!
//! The way of a case: [`select`](select()) picks it, a worker of the [`schedule`](run()) asks an engine and
//! gets [`Answers`], [`judge`](judge()) holds them against the expectation, the engine's [`Baseline`] says whether that was
//! known, and the [`Judgement`] goes out as a [`CaseEvent`]. Of a dialect that was defined, [`leave_out`] takes out the cases
//! before, of which nobody says what must happen. This crate does not know how events are shown.
#![forbid(unsafe_code)]

mod answers;
mod baseline;
mod event;
mod fact;
mod filter;
mod judge;
mod memory;
mod pack;
mod plan;
mod schedule;
mod select;
mod tell;
mod unstated;

pub use answers::{Answers, Rendering, ask};
pub use baseline::{
    Baseline, BaselineError, Blessing, Change, ChangeKind, EngineRun, Entry, Held, bless, hold,
};
pub use event::{BaselineHeader, BaselineNote, DefinedHeader, OutdatedEntry};
pub use event::{CaseEvent, EngineHeader, EngineTotals, Event, FORMAT, Footer, Header, Observed, PROGRAM};
pub use event::{Totals, Verdict};
pub use fact::{Fact, ToldDiagnostic};
pub use filter::Filter;
pub use judge::{Judgement, is_open, judge, rendered_bodies};
pub use memory::Memory;
pub use pack::breaks_reading;
pub use plan::{Plan, RunError, Summary};
pub use schedule::{run, run_with};
pub use select::select;
pub use stickler_engines::Grade;
pub use tell::Teller;
pub use unstated::{defined, leave_out};
