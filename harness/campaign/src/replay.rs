//! A finding, or an input alone, judged once more.

use crate::differential::{Agreement, EngineUnderTest, JudgedProgram, ask, compare, describe};
use crate::finding::{EngineReport, ExpectedBehavior, Finding};
use stickler_engines::{EngineError, EngineSession, Outcome};
use stickler_generate::oracles::{InputOutcome, OracleFailure};
use stickler_types::{DialectName, Value};

/// The result of judging a finding again.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Replayed {
    /// The outcome of each engine on the saved program, and how it differs from what must happen, where it does.
    pub answers: Vec<(EngineReport, Option<String>)>,
    /// The target's verdict on the saved input; `None` where the finding has no input.
    pub judged: Option<Result<InputOutcome, OracleFailure>>,
}

impl Replayed {
    /// Returns whether anything is still wrong.
    pub fn shows(&self) -> bool {
        self.answers.iter().any(|(_, wrong)| wrong.is_some()) || matches!(self.judged, Some(Err(_)))
    }
}

/// Judges a finding again: its program by these engines, its input by its target.
///
/// # Errors
/// [`EngineError`] where an engine cannot be started.
pub fn replay(finding: &Finding, engines: &[EngineUnderTest<'_>]) -> Result<Replayed, EngineError> {
    let mut replayed = Replayed::default();
    if let (Some(program), Some(dialect)) = (&finding.program, finding.dialect()) {
        for engine in engines {
            if let Some(answer) = again(&finding.expected, program, dialect, *engine)? {
                replayed.answers.push(answer);
            }
        }
    }
    if let Some(target) = finding.target().filter(|_| !finding.input.is_empty()) {
        replayed.judged = Some(target.judge(&finding.input));
    }
    Ok(replayed)
}

/// Asks one engine about the saved program; `None` where the finding expects nothing of a program.
fn again(
    expected: &ExpectedBehavior,
    program: &str,
    dialect: DialectName,
    engine: EngineUnderTest<'_>,
) -> Result<Option<(EngineReport, Option<String>)>, EngineError> {
    let mut session = EngineSession::open(engine.engine)?;
    let (outcome, wrong) = match expected {
        ExpectedBehavior::Values { values, opened, .. } => {
            let values: Vec<(String, Value)> = values
                .iter()
                .filter_map(|observed| Some((observed.name.clone(), Value::parse(&observed.value).ok()?)))
                .collect();
            let question = JudgedProgram {
                dialect,
                text: program,
                values: &values,
                binds: opened.is_empty(),
            };
            let outcome = ask(&mut session, question);
            let wrong = match compare(question, &outcome) {
                Agreement::Disagrees { message, .. } => Some(message),
                Agreement::Agrees | Agreement::Unsupported => None,
            };
            (outcome, wrong)
        }
        ExpectedBehavior::Rejected { code, line, .. } => {
            let outcome = session.check(dialect, program)?;
            let wrong = not_rejected_so(&outcome, code, *line);
            (outcome, wrong)
        }
        ExpectedBehavior::Property { .. } => return Ok(None),
    };
    Ok(Some((describe(engine.info(), &outcome), wrong)))
}

fn not_rejected_so(outcome: &Outcome, code: &str, line: u32) -> Option<String> {
    let must = format!("expected {code} on line {line} and nothing else");
    match outcome {
        Outcome::Unsupported { .. } | Outcome::NotImplemented { .. } => None,
        Outcome::Rejected { diagnostics } => match &diagnostics[..] {
            // A foreign engine may have neither our codes nor lines; what it does not tell contradicts nothing.
            [one]
                if one.code.as_deref().is_none_or(|own| own == code)
                    && one.line.is_none_or(|own| own == line) =>
            {
                None
            }
            several => Some(format!("{must}, got {} diagnostics", several.len())),
        },
        _ => Some(format!("{must}, and it was not rejected")),
    }
}
