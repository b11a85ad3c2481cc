//! Drops the inherited cases of a custom dialect whose result its overrides change.
//!
//! A custom dialect inherits the cases of the dialect that it extends. The cases already expect what the definition itself
//! states. Whatever else depends on the overridden rules, the reference shows: it is asked under both dialects. Where the
//! results differ, the documents of the base dialect do not apply to the custom one, and no document says what happens
//! instead. Such a case is dropped and counted.

use crate::{DefinedHeader, Grade, Plan, RunError, ask, judge, select};
use stickler_engines::{EngineSession, Reference};
use stickler_suite::Case;
use stickler_types::DialectName;
use stickler_workers::WorkerPool;

/// The number of cases that a worker is given at a time.
const BATCH_LEN: usize = 64;

/// Removes the selected cases that a custom dialect inherits and whose result its overrides change, and returns them in the order
/// of the suite.
///
/// # Errors
/// [`RunError::Workers`] where the system gives no threads; [`RunError::Engine`] where the reference has no session.
pub fn drop_changed_cases(plan: &Plan, cases: &mut Vec<Case>) -> Result<Vec<Case>, RunError> {
    let taken_over = |case: &&Case| case.dialect.is_custom() && !case.is_stated() && !case.is_open();
    let selected: Vec<&Case> = select(plan, cases).into_iter().filter(taken_over).collect();
    if selected.is_empty() {
        return Ok(Vec::new());
    }
    let reference = Reference::new();
    let changed: Vec<Vec<bool>> = WorkerPool::new(plan.jobs).map(
        selected.chunks(BATCH_LEN),
        || Ok(EngineSession::new(&reference)),
        |session, cases| {
            cases
                .iter()
                .map(|case| is_changed(session, case))
                .collect::<Result<_, RunError>>()
        },
    )?;
    let gone = selected
        .iter()
        .zip(changed.iter().flatten())
        .filter(|(_, changed)| **changed);
    let gone: Vec<Case> = gone.map(|(case, _)| (*case).clone()).collect();
    let mut next = gone.iter().peekable();
    cases.retain(|case| {
        let is_next = |gone: &&Case| (&gone.id, gone.dialect) == (&case.id, case.dialect);
        next.next_if(is_next).is_none()
    });
    Ok(gone)
}

/// Returns the entries for custom dialects in the header of a run, with the number of dropped cases of each.
pub fn dialect_headers(dialects: &[DialectName], left_out: &[Case]) -> Vec<DefinedHeader> {
    let header = |dialect: &DialectName| {
        let definition = dialect.definition().filter(|_| dialect.is_custom())?;
        Some(DefinedHeader {
            name: definition.spelling.clone(),
            extends: definition.base.as_str().to_owned(),
            about: definition.about.clone(),
            overrides: definition.overrides(),
            left_out: left_out.iter().filter(|case| case.dialect == *dialect).count() as u64,
        })
    };
    dialects.iter().filter_map(header).collect()
}

/// Returns whether the reference does something else with a case in its dialect than in the dialect's base.
fn is_changed(session: &mut EngineSession<'_>, case: &Case) -> Result<bool, RunError> {
    let in_base = Case {
        dialect: case.dialect.base(),
        ..case.clone()
    };
    let mut happens = |case: &Case| {
        let judgement = judge(case, &ask(session, case)?, Grade::Code);
        Ok::<_, RunError>((judgement.verdict, judgement.got))
    };
    Ok(happens(&in_base)? != happens(case)?)
}
