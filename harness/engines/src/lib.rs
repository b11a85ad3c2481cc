//! Engines: the implementations of Structured Text under test, and the wire protocol that they speak.
//!
//! An [`Engine`] says [who it is](Identity) and opens a [`Session`]; an [`EngineSession`] keeps one for a worker and opens it again
//! after a crash. A session is handed a [`RunRequest`], the program and what to observe of it, never an expectation, and answers
//! with an [`Outcome`]. There are these engines:
//!
//! - [`Reference`]: the reference implementation, in this process;
//! - [`Compiler`]: the real compilers for which there is an adapter;
//! - [`DescribedEngine`]: a compiler whose command line a table in `stickler.toml` describes;
//! - [`ClosureEngine`]: the reference with planted defects;
//! - [`ProcessEngine`]: any program that speaks the wire [`protocol`]; [`validate()`] checks one.
//!
//! Architecture Invariant: this crate knows neither cases nor verdicts nor reports.

mod adapters;
mod closures;
mod digest;
mod engine;
mod grade;
mod process;
pub mod protocol;
mod reference;
mod reproduction;
mod session;
mod shell;
mod validate;

pub use adapters::{
    Compiler, CompilerSearch, Dependency, DependencyPaths, DescribedEngine, Description, FoundBy,
    FoundDependency,
};
pub use closures::ClosureEngine;
pub use digest::Digest;
pub use engine::{Ability, Engine, EngineError, Identity, Packed, Session};
pub use grade::Grade;
pub use process::{
    ProcessEngine, ProcessLimits, end_questions_at, kill_all_processes, limit_programs, stop_all_processes,
};
pub use reference::Reference;
pub use reproduction::{
    NoReproduction, Reproduction, ReproductionFile, ReproductionTool, ScriptOutput, reproduce_and_run,
};
pub use session::EngineSession;
pub use shell::shell_quote;
pub use stickler_types::{
    ClockSetting, Diagnostic, NamedValue, Observation, Outcome, RunRequest, Setting, Severity,
};
pub use validate::{Check, CheckVerdict, OTHER_TYPE, Validation, validate};
