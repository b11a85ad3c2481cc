//! The answers of engines to the questions about conversions that the cases of a run ask, and those of recorded compilers.

use crate::answers::{answer_of, shortened};
use serde::Serialize;
use std::collections::{BTreeMap, HashMap};
use stickler_conversions::overview::{ComparedAnswer, QuestionNumber, RecordedAnswers, Statements};
use stickler_conversions::recording::extreme;
use stickler_run::{CaseEvent, Fact};
use stickler_types::{Question, RecordingOrigin, TypePair, WordTable};

/// The answers of a run, by engine and dialect.
#[derive(Default)]
pub(crate) struct PageAnswers {
    words: WordTable,
    columns: Vec<AnswerColumn>,
    /// The index of the column of an engine and a dialect, by the numbers of their words.
    numbers: HashMap<(u32, u32), usize>,
}

/// The answers of an engine in a dialect.
#[derive(Default)]
struct AnswerColumn {
    engine: u32,
    dialect: u32,
    /// The origin of the answers where they were recorded before the run.
    recording: Option<RecordingOrigin>,
    comparisons: Vec<(TypePair, &'static str)>,
    answers: HashMap<QuestionNumber, EngineAnswer>,
}

/// An answer. Several cases may ask the same; the greatest answer counts, so that what deviates is seen.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum EngineAnswer {
    /// The engine rejects the program of a pair of types that must be accepted, as [`EngineAnswer::Other`]. Where it accepts another program
    /// of the pair, something else is the cause, such as a literal.
    Rejected(u32, Option<usize>),
    /// The engine answers as the source of the case says.
    Met,
    /// No source in Stickler says what the answer must be; holds the word of the recorded answer.
    Recorded(u32),
    /// The engine answers something else; holds the word of the answer, and the number of the case among those that did not pass.
    Other(u32, Option<usize>),
}

/// The data of the answers.
#[derive(Serialize)]
pub(super) struct AnswersData {
    words: Vec<String>,
    columns: Vec<ColumnData>,
    /// The values that recordings compare, by their type; empty where there are none.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    compared: BTreeMap<&'static str, String>,
}

/// The answers of an engine in a dialect, in the order of the questions.
#[derive(Serialize)]
struct ColumnData {
    engine: u32,
    dialect: u32,
    #[serde(skip_serializing_if = "Option::is_none")]
    recording: Option<RecordingOrigin>,
    /// Of a recording, the types in the order of their comparisons: by the type at the left and the word of the answer, the types at the right.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    comparisons: BTreeMap<&'static str, BTreeMap<&'static str, Vec<&'static str>>>,
    /// The questions that were answered as a source says; each number is the distance from the one before.
    met: Vec<QuestionNumber>,
    /// The questions with recorded answers, in the same way, and the words of the answers.
    recorded: (Vec<QuestionNumber>, Vec<u32>),
    /// The questions with other answers, the words of the answers, and the numbers of the cases.
    other: (Vec<QuestionNumber>, Vec<u32>, Vec<Option<usize>>),
}

impl EngineAnswer {
    fn of(answer: &ComparedAnswer, number: Option<usize>, words: &mut WordTable) -> EngineAnswer {
        match answer {
            ComparedAnswer::Met => EngineAnswer::Met,
            ComparedAnswer::Open(text) => EngineAnswer::Recorded(words.number(shortened(text))),
            ComparedAnswer::Other(text) => EngineAnswer::Other(words.number(shortened(text)), number),
        }
    }
}

/// Returns whether an engine rejects a program that must be accepted.
fn is_rejected_wrongly(case: &CaseEvent) -> bool {
    let rejects = |facts: &[Fact]| facts.iter().any(|fact| fact.diagnostic().is_some());
    rejects(&case.got) && !rejects(&case.expected) && !case.expected.contains(&Fact::Rejected)
}

impl PageAnswers {
    /// Adds the answer of a case to a question. `number` is that of the case among those that did not pass.
    pub(crate) fn take(&mut self, case: &CaseEvent, question: QuestionNumber, number: Option<usize>) {
        let Some(answer) = answer_of(case) else {
            return;
        };
        let mut answer = EngineAnswer::of(&answer, number, &mut self.words);
        let is_pair = matches!(case.question, Some(Question::Implicit(_)));
        if let EngineAnswer::Other(word, number) = answer
            && is_pair
            && is_rejected_wrongly(case)
        {
            answer = EngineAnswer::Rejected(word, number);
        }
        let key = (self.words.number(&case.engine), self.words.number(&case.dialect));
        let next = self.columns.len();
        let column = *self.numbers.entry(key).or_insert(next);
        if column == next {
            self.columns.push(AnswerColumn {
                engine: key.0,
                dialect: key.1,
                ..AnswerColumn::default()
            });
        }
        let known = self.columns[column].answers.entry(question).or_insert(answer);
        *known = answer.max(*known);
    }

    /// Adds the answers of the recorded compilers that are none of these engines: what an engine answers now is worth more than what
    /// it answered once.
    pub(crate) fn add_recordings(&mut self, statements: &Statements, engines: &[&str]) {
        let ran = |recorded: &&RecordedAnswers| engines.iter().any(|engine| recorded.is_of(engine));
        let others = statements.recorded().iter().filter(|recorded| !ran(recorded));
        others.for_each(|recorded| self.add_recorded(recorded));
    }

    /// Adds the answers of a recorded compiler in a dialect.
    fn add_recorded(&mut self, recorded: &RecordedAnswers) {
        let RecordingOrigin { product, version, .. } = &recorded.origin;
        let words = &mut self.words;
        let answers = recorded.answers.iter();
        let answers = answers
            .map(|(question, given)| (*question, EngineAnswer::of(given, None, words)))
            .collect();
        self.columns.push(AnswerColumn {
            engine: self.words.number(&format!("{product} {version}")),
            dialect: self.words.number(recorded.dialect.as_str()),
            recording: Some(recorded.origin.clone()),
            comparisons: recorded.comparisons.clone(),
            answers,
        });
    }

    /// Returns the data for the page.
    pub(super) fn into_data(self) -> AnswersData {
        let pairs = self.columns.iter().flat_map(|column| &column.comparisons);
        let compared = pairs.map(|((left, _), _)| (left.name(), extreme(*left).to_string()));
        AnswersData {
            compared: compared.collect(),
            columns: self.columns.into_iter().map(AnswerColumn::into_data).collect(),
            words: self.words.all().cloned().collect(),
        }
    }
}

impl AnswerColumn {
    fn into_data(self) -> ColumnData {
        let mut answers: Vec<(QuestionNumber, EngineAnswer)> = self.answers.into_iter().collect();
        answers.sort_unstable();
        let mut comparisons: BTreeMap<_, BTreeMap<_, Vec<_>>> = BTreeMap::new();
        for ((left, right), word) in self.comparisons {
            let of_left = comparisons.entry(left.name()).or_default();
            of_left.entry(word).or_default().push(right.name());
        }
        let mut data = ColumnData {
            engine: self.engine,
            dialect: self.dialect,
            recording: self.recording,
            comparisons,
            met: Vec::new(),
            recorded: (Vec::new(), Vec::new()),
            other: (Vec::new(), Vec::new(), Vec::new()),
        };
        let mut last = [0; 3];
        let mut distance = |list: usize, question: QuestionNumber| {
            let distance = question - last[list];
            last[list] = question;
            distance
        };
        for (question, answer) in answers {
            match answer {
                EngineAnswer::Met => data.met.push(distance(0, question)),
                EngineAnswer::Recorded(word) => {
                    data.recorded.0.push(distance(1, question));
                    data.recorded.1.push(word);
                }
                EngineAnswer::Other(word, case) | EngineAnswer::Rejected(word, case) => {
                    data.other.0.push(distance(2, question));
                    data.other.1.push(word);
                    data.other.2.push(case);
                }
            }
        }
        data
    }
}

#[cfg(test)]
mod tests {
    use super::PageAnswers;
    use crate::sample;
    use serde_json::json;
    use stickler_run::{CaseEvent, Fact, Verdict};

    #[test]
    fn a_pair_of_types_that_converts_somewhere_is_not_rejected() {
        let implicit = "implicit(TIME,TIME)".parse().expect("a question");
        let rejected = CaseEvent {
            expected: vec![Fact::Accepted],
            got: vec![sample::reported(3, "P0002", "")],
            question: Some(implicit),
            ..sample::case("a::p(-1)", Verdict::Fail)
        };
        let other = |cases: &[&CaseEvent]| {
            let mut answers = PageAnswers::default();
            cases.iter().for_each(|case| answers.take(case, 7, Some(3)));
            let data = serde_json::to_value(answers.into_data()).expect("JSON");
            data["columns"][0]["other"][0].clone()
        };
        let met = sample::case("a::p(1)", Verdict::Pass);
        assert_eq!(other(&[&rejected]), json!([7]));
        assert_eq!(other(&[&rejected, &met]), json!([]));
        assert_eq!(other(&[&met, &rejected]), json!([]));
        assert_eq!(
            other(&[&met, &sample::case("a::p(2)", Verdict::Fail)]),
            json!([7])
        );
    }

    #[test]
    fn what_deviates_is_seen_whichever_case_comes_first() {
        for order in [[Verdict::Pass, Verdict::Fail], [Verdict::Fail, Verdict::Pass]] {
            let mut answers = PageAnswers::default();
            for verdict in order {
                answers.take(&sample::case("a::p(1)", verdict), 7, Some(3));
            }
            answers.take(&sample::case("a::p(2)", Verdict::Pass), 9, None);
            answers.take(&sample::open_case("a::p(3)"), 12, None);
            let data = serde_json::to_value(answers.into_data()).expect("JSON");
            let column = &data["columns"][0];
            let word = |text: &str| {
                data["words"]
                    .as_array()
                    .expect("words")
                    .iter()
                    .position(|word| word == text)
            };
            assert_eq!(column["met"], json!([9]));
            assert_eq!(column["other"], json!([[7], [word("INT#128")], [3]]));
            assert_eq!(column["recorded"], json!([[12], [word("INT#3")]]));
        }
    }
}
