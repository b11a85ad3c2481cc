//! Gathers answers to questions, and groups those questions on which they differ.

use super::{AnswerOrigin, Contradictions, Topic};
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::sync::Arc;
use stickler_types::{DialectName, ElementaryType, Family, Question, grouped_by};

/// The maximum number of other questions that a topic names.
const MAX_OTHERS: usize = 5;

/// A question: what is asked, and how a person is told it.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct AskedQuestion {
    /// What is asked, in a line.
    pub text: String,
    /// The kind by which questions are grouped.
    pub kind: String,
    /// The id of a case that asks it.
    pub case: Option<Arc<str>>,
    /// The program, where the text does not say all.
    pub program: Option<Arc<str>>,
}

impl AskedQuestion {
    /// Returns a question whose text says all, and which no case asks.
    pub const fn new(text: String, kind: String) -> AskedQuestion {
        AskedQuestion {
            text,
            kind,
            case: None,
            program: None,
        }
    }
}

/// Gathers answers. Their order does not matter.
#[derive(Default)]
pub struct ContradictionsBuilder {
    /// The questions with their answers, by what is asked, letter by letter.
    questions: HashMap<String, (AskedQuestion, Vec<GivenAnswer>)>,
}

/// An answer to be added: its origin, and the answer as text.
pub type NewAnswer<'o> = (&'o Arc<AnswerOrigin>, String);

/// An answer that was added: its origin, and the answer as text.
type GivenAnswer = (Arc<AnswerOrigin>, String);

/// By system, kind of source and dialect, the answers to a question.
type Sides<'b> = BTreeMap<(&'b str, &'b str, Option<DialectName>), BTreeSet<&'b str>>;

/// A question with its answers.
type Answered<'b> = (&'b AskedQuestion, &'b [GivenAnswer], Sides<'b>);

impl ContradictionsBuilder {
    /// Adds an answer to the question of this key: a value, `accepted`, `rejected` …
    pub fn add(&mut self, key: String, asked: AskedQuestion, (origin, answer): NewAnswer<'_>) {
        let (_, answers) = self.questions.entry(key).or_insert((asked, Vec::new()));
        answers.push((Arc::clone(origin), answer));
    }

    /// Adds an answer to a question, which `case` asks.
    pub fn add_question(&mut self, question: &Question, case: Option<&Arc<str>>, given: NewAnswer<'_>) {
        let case = case.cloned();
        let asked = AskedQuestion::new(question.to_string(), kind_of(question));
        self.add(asked.text.clone(), AskedQuestion { case, ..asked }, given);
    }

    /// Returns the topics on which the answers differ, the `most` largest of those questions that are wanted.
    pub fn finish(mut self, most: usize, is_wanted: impl Fn(&AskedQuestion) -> bool) -> Contradictions {
        let is_kept = |(asked, answers): &mut (AskedQuestion, _)| is_wanted(asked) && differ(answers);
        self.questions.retain(|_, question| is_kept(question));
        let questions = self.questions.values();
        let questions = questions.map(|(asked, answers)| (asked, &answers[..], sides_of(answers)));
        let mut questions: Vec<Answered<'_>> = questions.collect();
        questions.sort_by_cached_key(|(asked, _, sides)| (Reverse(size(sides)), asked.text.len(), *asked));
        let mut topics = grouped_by(&questions, |(first, _, sides), (asked, _, others)| {
            first.kind == asked.kind && part_alike(sides, others)
        });
        topics.sort_by_key(|topic| (Reverse(size(&topic[0].2)), Reverse(topic.len())));
        Contradictions {
            number: topics.len(),
            questions: questions.len(),
            topics: topics.iter().take(most).map(|topic| topic_of(topic)).collect(),
        }
    }
}

/// Returns whether answers differ, after those of a source that gives several were taken out: it was asked more than the question says.
fn differ(answers: &mut Vec<GivenAnswer>) -> bool {
    answers.sort_unstable();
    answers.dedup();
    let all = answers.clone();
    answers.retain(|given| all.iter().all(|other| other.0 != given.0 || other.1 == given.1));
    answers.iter().any(|(_, answer)| *answer != answers[0].1)
}

fn sides_of(answers: &[GivenAnswer]) -> Sides<'_> {
    let mut sides = Sides::new();
    for (origin, answer) in answers {
        let speaker = (&*origin.system, &*origin.kind, origin.dialect);
        sides.entry(speaker).or_default().insert(answer);
    }
    sides
}

/// Returns how large a disagreement is: the number of pairs of systems with different answers, a system that contradicts itself counted as one;
/// then the number of answers that documents and the standard give.
fn size(sides: &Sides<'_>) -> (usize, usize) {
    let systems: Vec<BTreeSet<&str>> = by_system(sides).into_values().collect();
    let pairs = systems.iter().enumerate().map(|(at, answers)| {
        let others = systems[at + 1..].iter().filter(|others| *others != answers);
        others.count() + usize::from(answers.len() > 1)
    });
    // Neither a recording nor a measurement.
    let stated = sides.keys().filter(|(_, kind, _)| kind.starts_with(['d', 's']));
    (pairs.sum(), stated.count())
}

/// Returns the answers of each system, whatever its flavour or edition.
fn by_system<'b>(sides: &Sides<'b>) -> BTreeMap<&'b str, BTreeSet<&'b str>> {
    let mut systems: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for ((system, ..), answers) in sides {
        let system = system.split(',').next().unwrap_or_default();
        systems.entry(system).or_default().extend(answers);
    }
    systems
}

/// Returns whether those who answer both questions part alike: who agrees on one agrees on the other, and at least two disagree.
fn part_alike(one: &Sides<'_>, other: &Sides<'_>) -> bool {
    let common = one.iter();
    let common = common.filter_map(|(who, first)| Some((first, other.get(who)?)));
    let pairs: BTreeSet<_> = common.collect();
    let firsts: BTreeSet<_> = pairs.iter().map(|(first, _)| first).collect();
    let seconds: BTreeSet<_> = pairs.iter().map(|(_, second)| second).collect();
    firsts.len() > 1 && firsts.len() == pairs.len() && seconds.len() == pairs.len()
}

/// Returns the topic of questions, the first of which is shown.
fn topic_of(questions: &[&Answered<'_>]) -> Topic {
    let (asked, given, sides) = questions[0];
    let mut by_answer: BTreeMap<&str, BTreeSet<AnswerOrigin>> = BTreeMap::new();
    for (origin, answer) in *given {
        let mut origin = AnswerOrigin::clone(origin);
        origin.dialect = None;
        by_answer.entry(answer).or_default().insert(origin);
    }
    let answers = by_answer.into_iter();
    let answers = answers.map(|(answer, by)| (answer.to_owned(), Vec::from_iter(by)));
    let mut answers = Vec::from_iter(answers);
    answers.sort_by_key(|(_, by)| Reverse(by.len()));
    let others = questions[1..].iter().map(|(asked, ..)| asked.text.clone());
    Topic {
        question: asked.text.clone(),
        kind: asked.kind.clone(),
        case: asked.case.as_deref().map(str::to_owned),
        program: asked.program.as_deref().map(str::to_owned),
        answers,
        systems: by_system(sides).len(),
        questions: questions.len(),
        others: others.take(MAX_OTHERS).collect(),
    }
}

/// Returns the kind of a question, in words: all conversions of real numbers to integers are one.
pub(super) fn kind_of(question: &Question) -> String {
    match question {
        Question::Implicit(_) => "implicit conversion".to_owned(),
        Question::Part(..) => "bits and parts of variables".to_owned(),
        Question::Comparison(_) => "comparison of two types".to_owned(),
        Question::Call(call) => {
            let operand = call.operands.first().map(|operand| operand.type_name());
            match (operand.and_then(ElementaryType::from_name), &call.function) {
                (Some(from), name) if name.contains("TO_") && !name.contains("BCD") => {
                    format!("conversion, {} to {}", family(from), family(call.result))
                }
                (_, name) => name.clone(),
            }
        }
    }
}

const fn family(ty: ElementaryType) -> &'static str {
    match ty.family() {
        Family::Boolean => "BOOL",
        Family::Signed | Family::Unsigned => "integer",
        Family::BitString => "bit string",
        Family::Real => "real",
        Family::Duration => "duration",
        Family::Date | Family::TimeOfDay | Family::DateAndTime => "date or time of day",
        Family::Text | Family::Character => "text",
    }
}
