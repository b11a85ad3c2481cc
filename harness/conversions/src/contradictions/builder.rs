//! Gathers answers to questions, and groups those questions on which they differ.

use super::kind::kind_of;
use super::{AnswerOrigin, Contradictions, Topic};
use crate::recording::Recording;
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::sync::Arc;
use stickler_types::{DialectName, Question};

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
    #[must_use]
    pub const fn new(text: String, kind: String) -> AskedQuestion {
        let (case, program) = (None, None);
        AskedQuestion {
            text,
            kind,
            case,
            program,
        }
    }
}

/// Gathers answers. Their order does not matter.
#[derive(Default)]
pub struct ContradictionsBuilder {
    /// The questions with their answers, by what is asked, letter by letter.
    questions: HashMap<String, (AskedQuestion, Vec<GivenAnswer>)>,
}

/// What an answer rests on, and the answer.
type GivenAnswer = (Arc<AnswerOrigin>, String);

/// By system, kind of source and dialect, the answers to a question.
type Sides<'b> = BTreeMap<(&'b str, &'b str, Option<DialectName>), BTreeSet<&'b str>>;

/// A question with its answers.
type Answered<'b> = (&'b AskedQuestion, &'b [GivenAnswer], Sides<'b>);

impl ContradictionsBuilder {
    /// Adds an answer to the question of this key: a value, `accepted`, `rejected` …
    pub fn add(&mut self, key: String, asked: AskedQuestion, (origin, answer): (&Arc<AnswerOrigin>, String)) {
        let (_, answers) = self.questions.entry(key).or_insert((asked, Vec::new()));
        answers.push((Arc::clone(origin), answer));
    }

    /// Adds an answer to a question, which `case` asks.
    pub fn add_question(
        &mut self,
        question: &Question,
        case: Option<&Arc<str>>,
        given: (&Arc<AnswerOrigin>, String),
    ) {
        let case = case.cloned();
        let asked = AskedQuestion::new(question.to_string(), kind_of(question));
        self.add(asked.text.clone(), AskedQuestion { case, ..asked }, given);
    }

    /// Adds the answers of a recording; `address` is that of its file.
    pub fn add_recording(&mut self, recording: &Recording, address: &str) {
        let origin = &recording.origin;
        for (dialect, question, answer) in recording.answers() {
            let origin = Arc::new(AnswerOrigin {
                system: origin.product.clone(),
                kind: "recording".to_owned(),
                source: format!("recording: {}", recording.name),
                read: format!("{}, {}", origin.version, origin.date),
                address: address.to_owned(),
                dialect: Some(dialect),
            });
            self.add_question(&question, None, (&origin, answer));
        }
    }

    /// Returns the topics on which the answers differ, the `most` largest of those questions that are wanted.
    #[must_use]
    pub fn finish(mut self, most: usize, is_wanted: impl Fn(&AskedQuestion) -> bool) -> Contradictions {
        self.questions
            .retain(|_, (asked, answers)| is_wanted(asked) && differ(answers));
        let questions = self.questions.values();
        let mut questions: Vec<Answered<'_>> = questions
            .map(|(asked, answers)| (asked, &answers[..], sides_of(answers)))
            .collect();
        questions.sort_by_cached_key(|(asked, _, sides)| (Reverse(size(sides)), asked.text.len(), *asked));
        let mut topics: Vec<Vec<&Answered<'_>>> = Vec::new();
        let mut of_kind: HashMap<&str, Vec<usize>> = HashMap::new();
        for question in &questions {
            let known = of_kind.entry(&question.0.kind).or_default();
            match known
                .iter()
                .find(|topic| part_alike(&topics[**topic][0].2, &question.2))
            {
                Some(topic) => topics[*topic].push(question),
                None => {
                    known.push(topics.len());
                    topics.push(vec![question]);
                }
            }
        }
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
    let are_different = |answers: &[GivenAnswer]| answers.iter().any(|(_, answer)| *answer != answers[0].1);
    if !are_different(answers) {
        return false;
    }
    // The standard says the same in each dialect.
    let speaker = |origin: &AnswerOrigin| {
        let dialect = origin.dialect.filter(|_| !origin.kind.starts_with("standard"));
        (origin.source.clone(), dialect)
    };
    let mut given: HashMap<_, BTreeSet<String>> = HashMap::new();
    for (origin, answer) in &*answers {
        given.entry(speaker(origin)).or_default().insert(answer.clone());
    }
    answers.retain(|(origin, _)| given[&speaker(origin)].len() == 1);
    are_different(answers)
}

fn sides_of(answers: &[GivenAnswer]) -> Sides<'_> {
    let mut sides = Sides::new();
    for (origin, answer) in answers {
        let speaker = (&*origin.system, &*origin.kind, origin.dialect);
        sides.entry(speaker).or_default().insert(answer);
    }
    sides
}

/// Returns the numbers of different answers and of systems.
fn size(sides: &Sides<'_>) -> (usize, usize) {
    let answers: BTreeSet<_> = sides.values().flatten().collect();
    let systems: BTreeSet<_> = sides.keys().map(|(system, ..)| system).collect();
    (answers.len(), systems.len())
}

/// Returns whether those who answer both questions part alike: who agrees on one agrees on the other, and at least two disagree.
fn part_alike(one: &Sides<'_>, other: &Sides<'_>) -> bool {
    let common = one
        .iter()
        .filter_map(|(who, first)| Some((first, other.get(who)?)));
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
    let mut answers = Vec::from_iter(by_answer);
    answers.sort_by_key(|(_, by)| Reverse(by.len()));
    let answers = answers.into_iter();
    let others = questions[1..].iter().map(|(asked, ..)| asked.text.clone());
    Topic {
        question: asked.text.clone(),
        kind: asked.kind.clone(),
        case: asked.case.as_deref().map(str::to_owned),
        program: asked.program.as_deref().map(str::to_owned),
        answers: answers
            .map(|(answer, by)| (answer.to_owned(), Vec::from_iter(by)))
            .collect(),
        systems: size(sides).1,
        questions: questions.len(),
        others: others.take(MAX_OTHERS).collect(),
    }
}
