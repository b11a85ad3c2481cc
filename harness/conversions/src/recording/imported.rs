//! Makes a recording of programs whose outcomes were told, such as those that a person copied out of an editor.

use super::questions::{self, Question, is_true};
use super::{AnsweredCalls, FunctionAnswers, Recording, comparison_word, key};
use crate::implicit::MatrixAnswer;
use crate::session::{RefusalKind, refusal_kind};
use std::collections::HashMap;
use stickler_engines::Outcome;
use stickler_exact::{Signature, call_of_program, part_of_program};
use stickler_types::{DialectName, ElementaryType, RecordingOrigin, Value};

/// Gathers the answers of a compiler in one dialect.
pub struct RecordingBuilder {
    dialect: DialectName,
    recording: Recording,
    /// The questions of the dialect by their programs.
    questions: HashMap<String, Question>,
    calls: HashMap<String, AnsweredCalls>,
}

impl RecordingBuilder {
    /// Begins a recording of a compiler that is asked in a dialect; `name` is that of its file.
    #[must_use]
    pub fn new(name: &str, origin: RecordingOrigin, dialect: DialectName) -> RecordingBuilder {
        let questions = Question::all(dialect).into_iter();
        RecordingBuilder {
            dialect,
            recording: Recording::empty(name, origin, vec![dialect]),
            questions: questions
                .map(|question| (question.program().source, question))
                .collect(),
            calls: HashMap::new(),
        }
    }

    /// Adds what the compiler did with a program, if it asks a question of a recording: whether a type converts implicitly, a part can be
    /// read, or a value is less than another, or for the result of a conversion function. Returns whether it does. Of several programs that
    /// ask the same question, the answer to the first counts.
    pub fn take(&mut self, source: &str, outcome: &Outcome) -> bool {
        let known = self.questions.get(source).cloned();
        let asked = known.map(|question| {
            let observed = question.program().observed;
            (question, observed.into_iter().next().unwrap_or_default())
        });
        let taken = asked
            .or_else(|| recognized(source, self.dialect))
            .and_then(|(question, observed)| self.add(question, outcome, &observed));
        taken.is_some()
    }

    /// Returns the number of questions that have an answer.
    #[must_use]
    pub fn number(&self) -> usize {
        self.recording.words.len() + self.calls.values().map(Vec::len).sum::<usize>()
    }

    /// Returns the recording.
    #[must_use]
    pub fn finish(mut self) -> Recording {
        for signature in questions::signatures(self.dialect) {
            let row = key(&signature);
            if let Some(calls) = self.calls.remove(&row) {
                // Some refused calls say nothing about the others.
                let asked = crate::overview::boundary_calls(&signature);
                let is_whole = asked
                    .iter()
                    .all(|call| calls.iter().any(|(known, _)| known == call));
                let answers = match is_whole {
                    true => FunctionAnswers::of(calls),
                    false => FunctionAnswers::Calls(calls),
                };
                self.recording.functions.insert((self.dialect, row), answers);
            }
        }
        self.recording
    }

    /// Adds an answer; `None` where the outcome has none.
    fn add(&mut self, question: Question, outcome: &Outcome, observed: &str) -> Option<()> {
        let place = question.word_key();
        let word = match question {
            Question::Implicit(_) | Question::Part(..) => accepted(outcome)?.as_str(),
            Question::Comparison(_) => {
                comparison_word(result(outcome, observed)?.map(|value| is_true(&value)))
            }
            Question::Call(signature, operands) => {
                let answer = result(outcome, observed)?;
                let calls = self.calls.entry(key(&signature)).or_default();
                if calls.iter().all(|(known, _)| *known != operands) {
                    calls.push((operands, answer));
                }
                return Some(());
            }
        };
        self.recording.words.entry((self.dialect, place?)).or_insert(word);
        Some(())
    }
}

/// Returns the question of a program that is none of those that a recording asks by itself, such as that of a case, and the variable that
/// it observes.
fn recognized(source: &str, dialect: DialectName) -> Option<(Question, String)> {
    if let Some(access) = part_of_program(source) {
        let question = Question::Part(access.ty, access.part.to_owned());
        return Some((question, String::new()));
    }
    let call = call_of_program(source)?;
    let from = ElementaryType::from_name(call.operand.type_name())?;
    let function = call.function.to_ascii_uppercase();
    let fits = |one: &Signature| one.operands == [from] && one.result == call.result;
    let signature = stickler_exact::signatures(&function, dialect)
        .into_iter()
        .find(fits)?;
    let target = call.target.to_owned();
    Some((Question::Call(signature, vec![call.operand]), target))
}

/// Returns whether an outcome is one of an accepted program; `None` where it is neither accepted nor refused.
fn accepted(outcome: &Outcome) -> Option<MatrixAnswer> {
    match outcome {
        Outcome::Executed { .. } | Outcome::Faulted { .. } => Some(MatrixAnswer::Accepts),
        Outcome::Error { .. } => None,
        other => Some(crate::implicit::answer(other)),
    }
}

/// Returns the value of a variable after the run, or the reason why there is none; `None` where nothing tells.
fn result(outcome: &Outcome, name: &str) -> Option<Result<Value, RefusalKind>> {
    match outcome {
        Outcome::Executed { values, .. } => {
            let mut values = values.iter();
            let (_, value) = values.find(|(key, _)| key == name)?;
            Some(Ok(value.clone()))
        }
        Outcome::Accepted { .. } | Outcome::Error { .. } | Outcome::Rendered { .. } => None,
        refused => Some(Err(refusal_kind(refused))),
    }
}

#[cfg(test)]
mod tests {
    use super::RecordingBuilder;
    use crate::recording::{Question, RecordedSection, Recording, RecordingOrigin};
    use stickler_engines::{Engine, EngineSession, Outcome, Reference, RunRequest};
    use stickler_types::DialectName;

    const DIALECT: DialectName = DialectName::MATIEC;

    fn origin() -> RecordingOrigin {
        RecordingOrigin {
            product: "p".to_owned(),
            version: "1".to_owned(),
            commit: None,
            platform: "l".to_owned(),
            date: "2026-11-24".to_owned(),
        }
    }

    #[test]
    fn the_questions_asked_one_by_one_make_the_recording_of_the_engine() {
        let reference = Reference::default();
        let mut session = EngineSession::open(&reference).unwrap();
        let mut builder = RecordingBuilder::new(&reference.identity().name, origin(), DIALECT);
        for question in Question::all(DIALECT) {
            let program = question.program();
            let observed = program.observations();
            let outcome = match observed.is_empty() {
                true => session.check(DIALECT, &program.source).unwrap(),
                false => session
                    .run(&RunRequest::once(DIALECT, &program.source, &observed))
                    .unwrap(),
            };
            assert!(builder.take(&program.source, &outcome), "{}", question.id());
        }
        let asked = Recording::ask(&reference, origin(), &[DIALECT], &RecordedSection::ALL, 0, &|| {});
        let asked = asked.unwrap();
        assert_eq!(builder.finish(), asked);
    }

    #[test]
    fn a_case_that_asks_the_same_counts_and_another_program_does_not() {
        let mut builder = RecordingBuilder::new("n", origin(), DIALECT);
        let case = "PROGRAM main\nVAR\n    data : REAL := 2.25;\n    into : INT;\nEND_VAR\n    into := REAL_TO_INT(data);\nEND_PROGRAM\n";
        let value = stickler_types::Value::parse("INT#7").unwrap();
        let executed = Outcome::executed(vec![("into".to_owned(), value)]);
        assert!(builder.take(case, &executed));
        // The answer to the first counts, and questions are counted once.
        assert!(builder.take(
            case,
            &Outcome::Rejected {
                diagnostics: Vec::new()
            }
        ));
        assert!(!builder.take("PROGRAM main END_PROGRAM", &executed));
        assert_eq!(builder.number(), 1);
        let mut text = Vec::new();
        builder.finish().write(&mut text).unwrap();
        let text = String::from_utf8(text).unwrap();
        assert!(text.contains("= [[\"2.25\", \"7\"]]"), "{text}");
    }

    #[test]
    fn one_refused_call_says_nothing_about_the_others() {
        let mut builder = RecordingBuilder::new("n", origin(), DIALECT);
        let is_call = |question: &Question| question.id().starts_with("REAL_TO_INT(");
        let question = Question::all(DIALECT).into_iter().find(is_call).unwrap();
        let diagnostics = Vec::new();
        builder.take(&question.program().source, &Outcome::Rejected { diagnostics });
        let mut text = Vec::new();
        builder.finish().write(&mut text).unwrap();
        let text = String::from_utf8(text).unwrap();
        assert!(text.contains("\"rejected\"]]"), "{text}");
    }
}
