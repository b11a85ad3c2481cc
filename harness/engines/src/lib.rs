//! Engines: whatever can take an ST program and say what it does, and the wire protocol they speak.
//!
//! An engine is handed a program and what to observe, never an expectation; what it answers is an
//! [`Outcome`]. This crate knows neither cases nor verdicts nor reports.
#![forbid(unsafe_code)]

mod adapters;
mod digest;
mod engine;
mod grade;
mod process;
pub mod protocol;
mod reference;
mod session;
mod validate;

pub use adapters::{
    Compiler, CompilerSearch, Dependency, DependencyPaths, DescribedEngine, Description, FoundBy,
    FoundDependency,
};
pub use adapters::{Token, Tokens, Word, declared, tokens};
pub use digest::Digest;
pub use engine::{Ability, Engine, EngineError, Identity, Packed, Session};
pub use grade::Grade;
pub use process::{ProcessEngine, ProcessLimits, kill_all_processes, stop_all_processes};
pub use reference::Reference;
pub use session::EngineSession;
pub use stickler_types::{ClockSetting, Diagnostic, NamedValue, Observation, Outcome, RunRequest, Setting};
pub use validate::{Check, CheckVerdict, Validation, validate};
