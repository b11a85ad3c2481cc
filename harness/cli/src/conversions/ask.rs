//! Getting values from an engine: a program that calls the function, and what became of it.

use super::spelling;
use anyhow::Result;
use std::fmt::Write;
use stickler_engines::{Diagnostic, Engine, Observation, Outcome, RunRequest, Session, guard};
use stickler_exact::Signature;
use stickler_types::{DialectName, ElementaryType, Value};

/// The longest text that a STRING of default length holds in every system.
const DEFAULT_LENGTH: usize = 80;

/// What an engine did with one call.
#[derive(Clone, PartialEq, Debug)]
pub enum Got {
    /// It gave a value.
    Value(Value),
    /// It gave none.
    None {
        /// What it did, in a word that fits a cell: `rejected`, `crashed` …
        word: &'static str,
        /// What is known about it.
        detail: String,
    },
}

impl Got {
    fn none(word: &'static str, detail: impl Into<String>) -> Got {
        Got::None {
            word,
            detail: detail.into(),
        }
    }

    /// Whether the engine says that it cannot do this, which is no wrong answer.
    pub fn is_unsupported(&self) -> bool {
        matches!(self, Got::None { word, .. } if *word == UNSUPPORTED)
    }
}

const UNSUPPORTED: &str = "unsupported";

/// An engine and the session kept to it.
pub struct Asker<'e> {
    engine: &'e dyn Engine,
    session: Box<dyn Session + 'e>,
}

impl<'e> Asker<'e> {
    /// # Errors
    /// Where no session can be opened.
    pub fn new(engine: &'e dyn Engine) -> Result<Asker<'e>> {
        let session = engine.session()?;
        Ok(Asker { engine, session })
    }

    /// What each call gives. All are tried in one program, since compilers take their time to start; where that does not
    /// come to its end, each in a program of its own.
    ///
    /// # Errors
    /// Where the engine crashed and cannot be started again.
    pub fn calls(
        &mut self,
        dialect: DialectName,
        signature: &Signature,
        calls: &[Vec<Value>],
    ) -> Result<Vec<Got>> {
        if let Some(values) = self.together(dialect, signature, calls)? {
            return Ok(values.into_iter().map(Got::Value).collect());
        }
        calls
            .iter()
            .map(|call| self.alone(dialect, signature, call))
            .collect()
    }

    fn together(
        &mut self,
        dialect: DialectName,
        signature: &Signature,
        calls: &[Vec<Value>],
    ) -> Result<Option<Vec<Value>>> {
        let Outcome::Executed { mut values } = self.run(dialect, signature, calls)? else {
            return Ok(None);
        };
        let mut found = Vec::with_capacity(calls.len());
        for number in 1..=calls.len() {
            let name = result_name(number);
            match values.iter().position(|(key, _)| *key == name) {
                Some(at) => found.push(values.swap_remove(at).1),
                None => return Ok(None),
            }
        }
        Ok(Some(found))
    }

    fn alone(&mut self, dialect: DialectName, signature: &Signature, call: &[Value]) -> Result<Got> {
        let outcome = self.run(dialect, signature, &[call.to_vec()])?;
        Ok(match outcome {
            Outcome::Executed { values } => match values.into_iter().next() {
                Some((_, value)) => Got::Value(value),
                None => Got::none("no value", "the program ran, and the engine told no value"),
            },
            Outcome::Accepted => Got::none(UNSUPPORTED, "the engine accepts the program and executes none"),
            Outcome::Rejected { diagnostics } => Got::none("rejected", told(&diagnostics)),
            Outcome::Faulted { fault, .. } => Got::none("faulted", fault.as_str()),
            Outcome::Unsupported { reason } => Got::none(UNSUPPORTED, reason),
            Outcome::Crashed { reason } => Got::none("crashed", reason),
            Outcome::TimedOut { after_ms } => Got::none(
                "timed out",
                format!("no answer within {}", Outcome::limit(after_ms)),
            ),
            Outcome::Error { message } => Got::none("error", message),
            Outcome::Rendered { .. } => Got::none("error", "the engine rendered what it was to run"),
        })
    }

    fn run(&mut self, dialect: DialectName, signature: &Signature, calls: &[Vec<Value>]) -> Result<Outcome> {
        let source = program(signature, calls);
        let names: Vec<String> = (1..=calls.len()).map(result_name).collect();
        let observe: Vec<Observation<'_>> = names
            .iter()
            .map(|name| Observation::last(name, signature.result.name()))
            .collect();
        let request = RunRequest::once(dialect, &source, &observe);
        let outcome = guard(|| self.session.run(&request));
        if let Outcome::Crashed { .. } = outcome {
            self.session = self.engine.session()?;
        }
        Ok(outcome)
    }
}

fn told(diagnostics: &[Diagnostic]) -> String {
    match diagnostics.first() {
        Some(Diagnostic {
            code: Some(code),
            message,
            ..
        }) => format!("{code}: {message}"),
        Some(first) => first.message.clone(),
        None => "without a diagnostic".to_owned(),
    }
}

fn result_name(number: usize) -> String {
    format!("into{number}")
}

/// A program with one variable for each operand and one for each result. What no literal can say, NaN and the infinities,
/// is computed before the calls: an engine that does that otherwise than IEC 60559 gives the function other operands.
fn program(signature: &Signature, calls: &[Vec<Value>]) -> String {
    let (mut declarations, mut statements) = (String::new(), String::new());
    for (index, call) in calls.iter().enumerate() {
        let number = index + 1;
        let mut operands = Vec::with_capacity(call.len());
        for (position, value) in call.iter().enumerate() {
            let name = format!("{}{number}", ["from", "with"][position.min(1)]);
            declare(&mut declarations, &mut statements, &name, value);
            operands.push(name);
        }
        let (result, ty) = (result_name(number), signature.result);
        let arguments = operands.join(", ");
        // Writing to a String cannot fail.
        let _ = writeln!(declarations, "    {result} : {ty};");
        let _ = writeln!(statements, "    {result} := {}({arguments});", signature.function);
    }
    let prelude = infinite(signature, calls);
    format!(
        "PROGRAM main\nVAR\n{}{declarations}END_VAR\n{}{statements}END_PROGRAM\n",
        prelude.0, prelude.1
    )
}

fn declare(declarations: &mut String, statements: &mut String, name: &str, value: &Value) {
    // As in `program`.
    let _ = match (value, computed(value)) {
        (Value::Plain { ty, .. }, Some(term)) => {
            let _ = writeln!(statements, "    {name} := {term};");
            writeln!(declarations, "    {name} : {ty};")
        }
        (Value::Text { ty, units }, _) if units.len() > DEFAULT_LENGTH => {
            let literal = spelling::literal(value);
            writeln!(declarations, "    {name} : {ty}[{}] := {literal};", units.len())
        }
        _ => {
            let literal = spelling::literal(value);
            writeln!(declarations, "    {name} : {} := {literal};", value.type_name())
        }
    };
}

/// The term that makes a value which no literal has.
fn computed(value: &Value) -> Option<&'static str> {
    match spelling::number(value)? {
        number if number.is_nan() => Some("infinite - infinite"),
        f64::INFINITY => Some("infinite"),
        f64::NEG_INFINITY => Some("-infinite"),
        _ => None,
    }
}

/// The declarations and the statement that give `infinite` its value, where a call needs it.
fn infinite(signature: &Signature, calls: &[Vec<Value>]) -> (String, String) {
    if !calls.iter().flatten().any(|value| computed(value).is_some()) {
        return (String::new(), String::new());
    }
    let ty = signature.operands[0];
    let large = match ty {
        ElementaryType::Real => "3.0E38",
        _ => "1.0E308",
    };
    (
        format!("    large : {ty} := {large};\n    infinite : {ty};\n"),
        "    infinite := large * large;\n".to_owned(),
    )
}

#[cfg(test)]
mod tests {
    use super::{Asker, Got, program};
    use stickler_engines::Reference;
    use stickler_types::{DialectName, Value};

    fn value(literal: &str) -> Value {
        Value::parse(literal).unwrap()
    }

    #[test]
    fn what_no_literal_says_is_computed_in_the_program() {
        let signature = &stickler_exact::signatures("REAL_TO_REAL_COPY", DialectName::Matiec);
        assert!(signature.is_empty());
        let signature = &stickler_exact::signatures("REAL_TO_LREAL", DialectName::Matiec)[0];
        let calls = ["REAL#NaN", "REAL#Infinity", "REAL#-Infinity", "REAL#-0.0"];
        let calls: Vec<_> = calls.iter().map(|literal| vec![value(literal)]).collect();
        let text = program(signature, &calls);
        assert!(text.contains("from1 := infinite - infinite;"), "{text}");
        let reference = Reference::default();
        let mut asker = Asker::new(&reference).unwrap();
        let got = asker.calls(DialectName::Matiec, signature, &calls).unwrap();
        let expected = ["LREAL#NaN", "LREAL#Infinity", "LREAL#-Infinity", "LREAL#-0.0"];
        assert_eq!(got, expected.map(|literal| Got::Value(value(literal))));
    }

    #[test]
    fn a_call_that_is_rejected_does_not_take_the_others_with_it() {
        // An enumeration is no operand of any conversion function.
        let signature = &stickler_exact::signatures("INT_TO_DINT", DialectName::Matiec)[0];
        let reference = Reference::default();
        let mut asker = Asker::new(&reference).unwrap();
        let calls = [vec![value("INT#5")], vec![value("COLOR#RED")]];
        let got = asker.calls(DialectName::Matiec, signature, &calls).unwrap();
        assert_eq!(got[0], Got::Value(value("DINT#5")));
        assert!(
            matches!(&got[1], Got::None { word: "rejected", .. }),
            "{:?}",
            got[1]
        );
    }
}
