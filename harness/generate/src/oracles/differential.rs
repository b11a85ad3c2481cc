//! Oracle `differential`: an engine that the environment names gives the values of the evaluator.
//!
//! A program that meets a question that documents leave open is skipped instead of failing.

use super::{InputOutcome, Judged, OracleFailure, failed};
use crate::evaluate::evaluate;
use crate::generator::{GeneratorSettings, program};
use crate::model::Program;
use crate::reduce::deviation;
use crate::writer::{Style, write};
use std::cell::RefCell;
use stickler_engines::{
    Compiler, Engine, Observation, Outcome, ProcessEngine, ProcessLimits, Reference, RunRequest, Session,
};
use stickler_types::DialectName;

/// The environment variable that names the engine: `reference`, the name of a compiler, or `cmd:` and the command line of an
/// adapter.
pub const ENGINE: &str = "STICKLER_ENGINE";

/// The name of the engine that is always available.
const REFERENCE: &str = "reference";

/// The prefix of a command line.
const COMMAND: &str = "cmd:";

/// Judges the engine of the environment by the program of an input; without an engine, the input is skipped.
///
/// The engine is started once a thread and lives as long as the process; its session restarts an engine that died.
///
/// # Errors
/// See [`judge_on`]; `engine` if the engine cannot be started.
pub fn differential(data: &[u8]) -> Judged {
    thread_local! {
        static OPEN: RefCell<Option<Result<Open, String>>> = const { RefCell::new(None) };
    }
    let Ok(name) = std::env::var(ENGINE) else {
        return Ok(InputOutcome::Skipped("no engine is named in STICKLER_ENGINE"));
    };
    OPEN.with_borrow_mut(|open| match open.get_or_insert_with(|| Open::new(&name)) {
        Ok(open) => judge_on(open.session.as_mut(), &program_for(&open.dialects, data)),
        Err(reason) => failed("engine", reason.clone()),
    })
}

/// A started engine.
struct Open {
    dialects: Vec<DialectName>,
    session: Box<dyn Session>,
}

impl Open {
    fn new(name: &str) -> Result<Open, String> {
        // A session borrows its engine. The engine is needed to the end of the process, so it is never given back.
        let engine: &'static dyn Engine = Box::leak(by_name(name)?);
        Ok(Open {
            dialects: engine.identity().dialects.clone(),
            session: engine.session().map_err(|error| error.to_string())?,
        })
    }
}

/// Creates the engine with a name.
fn by_name(name: &str) -> Result<Box<dyn Engine>, String> {
    let started = if name == REFERENCE {
        return Ok(Box::new(Reference::default()));
    } else if let Some(line) = name.strip_prefix(COMMAND) {
        ProcessEngine::start(line, ProcessLimits::default()).map(|engine| Box::new(engine) as Box<dyn Engine>)
    } else if let Some(compiler) = Compiler::from_word(name) {
        compiler.engine(name)
    } else {
        let compilers = Compiler::ALL
            .map(|compiler| format!("`{}`", compiler.as_str()))
            .join(", ");
        return Err(format!(
            "{ENGINE} is `{name}`; it must be `{REFERENCE}`, {compilers}, or `{COMMAND}` and the command line of an adapter"
        ));
    };
    started.map_err(|error| error.to_string())
}

/// Generates the program of an input in one of these dialects, which the first byte chooses.
#[must_use]
pub fn program_for(dialects: &[DialectName], data: &[u8]) -> Program {
    let (first, rest) = data
        .split_first()
        .map_or((0, data), |(first, rest)| (usize::from(*first), rest));
    let settings = GeneratorSettings {
        dialect: dialects.get(first % dialects.len().max(1)).copied(),
        ..GeneratorSettings::default()
    };
    program(rest, &settings)
}

/// Judges an engine by a program.
///
/// # Errors
/// The difference between the outcome of the engine and that of the evaluator; the symptom is that of [`deviation`].
pub fn judge_on(session: &mut dyn Session, program: &Program) -> Judged {
    let Ok(evaluation) = evaluate(program, 1) else {
        return Ok(InputOutcome::Skipped("the program has no values"));
    };
    if !evaluation.opened.is_empty() {
        return Ok(InputOutcome::Skipped("poisoned by what documents leave open"));
    }
    let text = write(program, &Style::default()).text;
    let observed = program.observed();
    let observe: Vec<Observation> = observed
        .iter()
        .map(|(name, ty)| Observation::last(name, ty.name()))
        .collect();
    let given = session.run(&RunRequest::once(program.dialect, &text, &observe));
    if let Outcome::Unsupported { .. } = given {
        return Ok(InputOutcome::Skipped("the engine does not support the program"));
    }
    match deviation(&evaluation.values, &given) {
        None => Ok(InputOutcome::Checked),
        Some((symptom, message)) => Err(OracleFailure::new(symptom.to_string(), message).of_program(text)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::variants::tests::everything;
    use stickler_engines::ClosureEngine;
    use stickler_types::Value;

    /// Judges an engine that always gives the same answer.
    fn judged(outcome: Outcome) -> Result<InputOutcome, String> {
        let engine = ClosureEngine::new("stubborn", move |_, _| outcome.clone());
        let judged = judge_on(engine.session().unwrap().as_mut(), &everything());
        judged.map_err(|failure| failure.symptom)
    }

    #[test]
    fn an_engine_that_gives_the_documented_values_is_right() {
        let values = evaluate(&everything(), 1).unwrap().values;
        assert_eq!(judged(Outcome::executed(values)), Ok(InputOutcome::Checked));
        let reference = Reference::default();
        let mut session = reference.session().unwrap();
        assert_eq!(
            judge_on(session.as_mut(), &everything()),
            Ok(InputOutcome::Checked)
        );
    }

    #[test]
    fn whatever_else_it_does_is_told_by_its_kind() {
        let mut values = evaluate(&everything(), 1).unwrap().values;
        values[1].1 = Value::parse("INT#-1").unwrap();
        assert_eq!(judged(Outcome::executed(values)), Err("value:INT".to_owned()));
        assert_eq!(
            judged(Outcome::crashed("segmentation fault")),
            Err("crash".to_owned())
        );
        assert_eq!(judged(Outcome::TimedOut { after_ms: 9 }), Err("hang".to_owned()));
        let reason = "no arrays".to_owned();
        let unsupported = judged(Outcome::Unsupported { reason });
        assert_eq!(
            unsupported,
            Ok(InputOutcome::Skipped("the engine does not support the program"))
        );
    }

    #[test]
    fn what_documents_leave_open_poisons_the_comparison() {
        let mut program = everything();
        // Without its assignment behind the loop, the loop's variable is open.
        program.main.body.truncate(1);
        assert_eq!(
            judge_on(Reference::default().session().unwrap().as_mut(), &program),
            Ok(InputOutcome::Skipped("poisoned by what documents leave open"))
        );
    }

    #[test]
    fn a_name_that_no_engine_has_is_told_with_what_it_may_be() {
        let reason = by_name("nobody").err().unwrap();
        assert!(
            reason.contains("`nobody`") && reason.contains("`matiec`"),
            "{reason}"
        );
        assert!(by_name("reference").is_ok());
        assert!(by_name("cmd:no-such-program-anywhere").is_err());
    }
}
