//! The answers of engines to the questions about conversions that the cases of a run ask, and those of recorded compilers.

use serde::Serialize;
use std::collections::{BTreeMap, HashMap};
use stickler_conversions::implicit::TypePair;
use stickler_conversions::overview::{QuestionNumber, RecordedAnswer, RecordedAnswers};
use stickler_conversions::recording::{RecordingOrigin, extreme};
use stickler_run::{CaseEvent, Fact, Observed, Verdict};
use stickler_types::{Diagnostic, Value, WordTable};

/// The maximum number of characters of an answer.
const MAX_CHARACTERS: usize = 80;

/// The answers of a run, by engine and dialect.
#[derive(Default)]
pub(super) struct PageAnswers {
    words: WordTable,
    columns: Vec<AnswerColumn>,
    /// The index of the column of an engine and a dialect, by the numbers of their words.
    numbers: HashMap<(u32, u32), usize>,
}

/// The answers of an engine in a dialect.
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
    /// The engine answers as the source of the case says.
    Met,
    /// No source says what the answer must be; holds the word of the recorded answer.
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

impl PageAnswers {
    /// Adds the answer of a case to a question. `number` is that of the case among those that did not pass.
    pub(super) fn take(&mut self, case: &CaseEvent, question: QuestionNumber, number: Option<usize>) {
        let answer = match case.verdict {
            Verdict::Pass | Verdict::Xpass if case.open => match recorded(case) {
                Some(recorded) => EngineAnswer::Recorded(self.words.number(recorded)),
                None => return,
            },
            Verdict::Pass | Verdict::Xpass => EngineAnswer::Met,
            _ => EngineAnswer::Other(self.words.number(&other(case)), number),
        };
        let key = (self.words.number(&case.engine), self.words.number(&case.dialect));
        let next = self.columns.len();
        let column = *self.numbers.entry(key).or_insert(next);
        if column == next {
            self.columns.push(AnswerColumn {
                engine: key.0,
                dialect: key.1,
                recording: None,
                comparisons: Vec::new(),
                answers: HashMap::new(),
            });
        }
        let known = self.columns[column].answers.entry(question).or_insert(answer);
        *known = answer.max(*known);
    }

    /// Adds the answers of a recorded compiler in a dialect.
    pub(super) fn add_recorded(&mut self, recorded: &RecordedAnswers) {
        let RecordingOrigin { product, version, .. } = &recorded.origin;
        let words = &mut self.words;
        let mut answer = |answer: &RecordedAnswer| match answer {
            RecordedAnswer::Met => EngineAnswer::Met,
            RecordedAnswer::Open(text) => EngineAnswer::Recorded(words.number(shortened(text))),
            RecordedAnswer::Other(text) => EngineAnswer::Other(words.number(shortened(text)), None),
        };
        let answers = recorded.answers.iter();
        let answers = answers
            .map(|(question, given)| (*question, answer(given)))
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
            words: self.words.all().to_vec(),
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
                EngineAnswer::Other(word, case) => {
                    data.other.0.push(distance(2, question));
                    data.other.1.push(word);
                    data.other.2.push(case);
                }
            }
        }
        data
    }
}

/// Returns what was recorded of a case: the value of a variable, or else whether it was accepted, or the fault.
fn recorded(case: &CaseEvent) -> Option<&str> {
    let is_value = |observed: &&Observed| Value::parse(&observed.value).is_ok();
    let value = case.observations.iter().find(is_value);
    let observed = value.or_else(|| case.observations.first())?;
    Some(shortened(&observed.value))
}

/// Returns what an engine did, in a word or a value: `rejected P4035`, or else what it did otherwise than expected.
fn other(case: &CaseEvent) -> String {
    let diagnostic = case.got.iter().find_map(Fact::diagnostic);
    if let Some(diagnostic) = diagnostic {
        return with_code("rejected", diagnostic);
    }
    let deviating = case.got.iter().find(|fact| !case.expected.contains(fact));
    let missing = |fact: &Fact| matches!(fact, Fact::Warning(_)) && !case.got.contains(fact);
    if deviating.is_none() && case.expected.iter().any(missing) {
        return "no warning".to_owned();
    }
    match deviating.or(case.got.first()) {
        Some(Fact::Value { value, .. }) => shortened(&value.to_string()).to_owned(),
        Some(Fact::Warning(warning)) => with_code("warned", warning),
        Some(Fact::Unsupported { .. }) => "unsupported".to_owned(),
        Some(Fact::Crashed { .. }) => "crashed".to_owned(),
        Some(fact) => {
            let text = fact.to_string();
            let (first, _) = text.split_once([':', '\n']).unwrap_or((&text, ""));
            shortened(first).to_owned()
        }
        None => "nothing".to_owned(),
    }
}

/// Returns a word with the code of a diagnostic behind it, if it has one.
fn with_code(word: &str, diagnostic: &Diagnostic) -> String {
    let code = diagnostic.code.as_deref().unwrap_or_default();
    format!("{word} {code}").trim_end().to_owned()
}

fn shortened(text: &str) -> &str {
    let end = text
        .char_indices()
        .nth(MAX_CHARACTERS)
        .map_or(text.len(), |(end, _)| end);
    &text[..end]
}

#[cfg(test)]
mod tests {
    use super::{PageAnswers, other};
    use crate::sample;
    use serde_json::json;
    use stickler_run::{CaseEvent, Fact, Verdict};

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

    #[test]
    fn an_answer_names_what_departs_from_the_expectation() {
        let value = |literal| sample::value("into", literal);
        let warning = || sample::warning(6, "C0195");
        let of = |expected, got| {
            other(&CaseEvent {
                expected,
                got,
                ..sample::case("a::p(1)", Verdict::Fail)
            })
        };
        assert_eq!(
            of(vec![Fact::Accepted], vec![Fact::Accepted, warning()]),
            "warned C0195"
        );
        assert_eq!(
            of(vec![Fact::Accepted, warning()], vec![Fact::Accepted]),
            "no warning"
        );
        assert_eq!(
            of(vec![value("INT#3"), warning()], vec![value("INT#3")]),
            "no warning"
        );
        assert_eq!(of(vec![value("INT#3"), warning()], vec![value("INT#4")]), "INT#4");
        assert_eq!(
            of(vec![value("INT#3"), warning()], vec![value("INT#4"), warning()]),
            "INT#4"
        );
        assert_eq!(
            of(vec![Fact::Accepted, warning()], vec![sample::error(6, "P4035")]),
            "rejected P4035"
        );
    }
}
