//! Makes a recording of programs whose outcomes were told, such as those that a person copied out of an editor.

use super::questions::{self, is_true, word_key};
use super::{AnsweredCalls, FunctionAnswers, Recording, comparison_word};
use crate::implicit::MatrixAnswer;
use crate::session::{RefusalKind, refusal_kind};
use std::collections::HashMap;
use stickler_engines::Outcome;
use stickler_exact::signature_of;
use stickler_types::{DialectName, Question, RecordingOrigin, Value};

/// Gathers the answers of a compiler in one dialect.
pub struct RecordingBuilder {
    dialect: DialectName,
    recording: Recording,
    calls: HashMap<String, AnsweredCalls>,
}

impl RecordingBuilder {
    /// Begins a recording of a compiler that is asked in a dialect; `name` is that of its file.
    pub fn new(name: &str, origin: RecordingOrigin, dialect: DialectName) -> RecordingBuilder {
        RecordingBuilder {
            dialect,
            recording: Recording::empty(name, origin, vec![dialect]),
            calls: HashMap::new(),
        }
    }

    /// Adds what the compiler did with a program that asks a question and shows the answer in the variable `observed`. Returns whether
    /// that is an answer. Of several programs that ask the same question, the answer to the first counts.
    pub fn take(&mut self, question: &Question, observed: &str, outcome: &Outcome) -> bool {
        self.add(question, observed, outcome).is_some()
    }

    /// Returns the number of questions that have an answer.
    pub fn number(&self) -> usize {
        self.recording.words.len() + self.calls.values().map(Vec::len).sum::<usize>()
    }

    /// Returns the recording.
    pub fn finish(mut self) -> Recording {
        for signature in questions::signatures(self.dialect) {
            let row = signature.to_string();
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
    fn add(&mut self, question: &Question, observed: &str, outcome: &Outcome) -> Option<()> {
        let word = match question {
            Question::Implicit(_) | Question::Part(..) => accepted(outcome)?.as_str(),
            Question::Comparison(_) => {
                comparison_word(result(outcome, observed)?.map(|value| is_true(&value)))
            }
            Question::Call(call) => {
                let signature = signature_of(call, self.dialect)?;
                let answer = result(outcome, observed)?;
                let calls = self.calls.entry(signature.to_string()).or_default();
                if calls.iter().all(|(known, _)| *known != call.operands) {
                    calls.push((call.operands.clone(), answer));
                }
                return Some(());
            }
        };
        let place = word_key(question)?;
        self.recording.words.entry((self.dialect, place)).or_insert(word);
        Some(())
    }
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
    use crate::recording::{RecordedSection, Recording, RecordingOrigin, all_questions, program_of};
    use stickler_engines::{Engine, EngineSession, Outcome, Reference, RunRequest};
    use stickler_types::{DialectName, Question};

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
        for question in all_questions(DIALECT) {
            let program = program_of(&question);
            let (source, observed) = (program.source(), program.observations());
            let outcome = match observed.is_empty() {
                true => session.check(DIALECT, &source).unwrap(),
                false => session
                    .run(&RunRequest::once(DIALECT, &source, &observed))
                    .unwrap(),
            };
            let name = program.observed.first().map_or("", String::as_str);
            assert!(builder.take(&question, name, &outcome), "{question}");
        }
        let asked = Recording::ask(&reference, origin(), &[DIALECT], &RecordedSection::ALL, 0, &|| {});
        let asked = asked.unwrap();
        assert_eq!(builder.finish(), asked);
    }

    fn question(text: &str) -> Question {
        text.parse().unwrap()
    }

    #[test]
    fn the_first_answer_to_a_question_counts() {
        let mut builder = RecordingBuilder::new("n", origin(), DIALECT);
        let asked = question("REAL_TO_INT(REAL#2.25) : INT");
        let value = stickler_types::Value::parse("INT#7").unwrap();
        let executed = Outcome::executed(vec![("into".to_owned(), value)]);
        assert!(!builder.take(&asked, "given", &executed), "another variable");
        assert!(builder.take(&asked, "into", &executed));
        let diagnostics = Vec::new();
        assert!(builder.take(&asked, "into", &Outcome::Rejected { diagnostics }));
        let unknown = question("REAL_TO_INTEGER(REAL#2.25) : INT");
        assert!(!builder.take(&unknown, "into", &executed));
        assert_eq!(builder.number(), 1);
        let mut text = Vec::new();
        builder.finish().write(&mut text).unwrap();
        let text = String::from_utf8(text).unwrap();
        assert!(text.contains("= [[\"2.25\", \"7\"]]"), "{text}");
    }

    #[test]
    fn one_refused_call_says_nothing_about_the_others() {
        let mut builder = RecordingBuilder::new("n", origin(), DIALECT);
        let diagnostics = Vec::new();
        let asked = question("REAL_TO_INT(REAL#0.5) : INT");
        builder.take(&asked, "given1", &Outcome::Rejected { diagnostics });
        let mut text = Vec::new();
        builder.finish().write(&mut text).unwrap();
        let text = String::from_utf8(text).unwrap();
        assert!(text.contains("\"rejected\"]]"), "{text}");
    }
}
