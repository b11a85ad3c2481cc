//! What the header of a run says of one engine, for those who show its cases.

use stickler_run::{CaseEvent, EngineHeader, Grade};

/// Returns the engine of a case, where the header names it.
pub(crate) fn of<'h>(engines: &'h [EngineHeader], case: &CaseEvent) -> Option<&'h EngineHeader> {
    engines.iter().find(|engine| engine.name == case.engine)
}

/// Returns how exact the rejections of an engine had to be. One that the header does not name is held to the code.
pub(crate) fn strictness(engine: Option<&EngineHeader>) -> Grade {
    engine.map_or(Grade::Code, |engine| engine.strict)
}

/// Returns the command that runs a case again.
pub(crate) fn rerun(engine: Option<&EngineHeader>, case: &CaseEvent) -> String {
    engine.map_or_else(String::new, |engine| engine.rerun(&case.id, &case.dialect))
}
