//! Looks up what the header of a run states about an engine.

use stickler_run::{CaseEvent, EngineHeader, Grade};

/// Returns the engine with this name, where the header names it.
pub(crate) fn named<'h>(engines: &'h [EngineHeader], name: &str) -> Option<&'h EngineHeader> {
    engines.iter().find(|engine| engine.name == name)
}

/// Returns the worst grade of a rejection by an engine that still passed; [`Grade::Code`] for an engine that the header does
/// not name.
pub(crate) fn strictness(engine: Option<&EngineHeader>) -> Grade {
    engine.map_or(Grade::Code, |engine| engine.strict)
}

/// Returns the command that runs a case again; empty for an engine that the header does not name.
pub(crate) fn rerun(engine: Option<&EngineHeader>, case: &CaseEvent) -> String {
    engine.map_or_else(String::new, |engine| engine.rerun(&case.id, &case.dialect))
}
