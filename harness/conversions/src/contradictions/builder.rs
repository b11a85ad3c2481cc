//! Gathers answers to questions, and groups those questions on which they differ.

use super::{AnswerOrigin, Contradictions, Topic, TopicAnswer, kind_of};
use crate::recording::Recording;
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::sync::Arc;
use stickler_types::{DialectName, WordTable};

/// The maximum number of other questions that a topic names.
const MAX_OTHERS: usize = 5;

/// A question: what is asked, and how a person is told it.
#[derive(Clone, PartialEq, Eq, Debug)]
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

/// Gathers answers. Their order does not matter.
#[derive(Default)]
pub struct ContradictionsBuilder {
    questions: Vec<GatheredQuestion>,
    /// The index of a question by what is asked, letter by letter.
    numbers: HashMap<Box<str>, usize>,
    words: WordTable,
    origins: Vec<(AnswerOrigin, Option<DialectName>)>,
    origin_numbers: HashMap<(AnswerOrigin, Option<DialectName>), u32>,
}

struct GatheredQuestion {
    asked: AskedQuestion,
    answers: Vec<GivenAnswer>,
}

struct GivenAnswer {
    origin: u32,
    /// The word of the answer.
    answer: u32,
    /// The case that states it.
    case: Option<Arc<str>>,
}

/// The words of the answers that each [speaker](ContradictionsBuilder::speaker) gives to a question.
type Sides<'b> = BTreeMap<(&'b str, &'static str, Option<DialectName>), BTreeSet<u32>>;

impl ContradictionsBuilder {
    /// Returns the index of the question with this key, which is added where it is new.
    pub fn question(&mut self, key: &str, asked: impl FnOnce() -> AskedQuestion) -> usize {
        if let Some(number) = self.numbers.get(key) {
            return *number;
        }
        let number = self.questions.len();
        self.numbers.insert(key.into(), number);
        self.questions.push(GatheredQuestion {
            asked: asked(),
            answers: Vec::new(),
        });
        number
    }

    /// Returns the number of an origin of answers in a dialect, which is added where it is new.
    pub fn origin(&mut self, origin: AnswerOrigin, dialect: Option<DialectName>) -> u32 {
        let next = u32::try_from(self.origins.len()).unwrap_or(u32::MAX);
        let number = *self
            .origin_numbers
            .entry((origin.clone(), dialect))
            .or_insert(next);
        if number == next {
            self.origins.push((origin, dialect));
        }
        number
    }

    /// Adds an answer to a question; `case` is the case that states it.
    pub fn answer(&mut self, question: usize, origin: u32, answer: &str, case: Option<&Arc<str>>) {
        let answer = self.words.number(answer);
        self.questions[question].answers.push(GivenAnswer {
            origin,
            answer,
            case: case.cloned(),
        });
    }

    /// Adds the answers of a recording; `address` is that of its file.
    pub fn recording(&mut self, recording: &Recording, address: &str) {
        let origin = AnswerOrigin {
            system: recording.origin.product.clone(),
            kind: "recording",
            source: format!("recording: {}", recording.name),
            publisher: None,
            read: format!("{}, {}", recording.origin.version, recording.origin.date),
            address: address.to_owned(),
        };
        for (dialect, question, answer) in recording.answers() {
            let origin = self.origin(origin.clone(), Some(dialect));
            let text = question.to_string();
            let number = self.question(&text, || AskedQuestion {
                text: text.clone(),
                kind: kind_of(&question),
                case: None,
                program: None,
            });
            self.answer(number, origin, &answer, None);
        }
    }

    /// Returns the topics on which the answers differ. Where `is_wanted` refuses a question, it is left out.
    #[must_use]
    pub fn finish(mut self, is_wanted: impl Fn(&AskedQuestion) -> bool) -> Contradictions {
        let mut questions = std::mem::take(&mut self.questions);
        questions.retain_mut(|question| self.differs(question) && is_wanted(&question.asked));
        questions.sort_by_cached_key(|question| {
            let (answers, systems) = self.size(question);
            let AskedQuestion { text, kind, case, .. } = &question.asked;
            (
                Reverse((answers, systems)),
                text.len(),
                text.clone(),
                kind.clone(),
                case.clone(),
            )
        });
        let mut groups: Vec<(Sides<'_>, Vec<&GatheredQuestion>)> = Vec::new();
        let mut of_kind: HashMap<&str, Vec<usize>> = HashMap::new();
        for question in &questions {
            let sides = self.sides(question);
            let known = of_kind.entry(&question.asked.kind).or_default();
            match known.iter().find(|group| part_alike(&groups[**group].0, &sides)) {
                Some(group) => groups[*group].1.push(question),
                None => {
                    known.push(groups.len());
                    groups.push((sides, vec![question]));
                }
            }
        }
        groups.sort_by_key(|(_, questions)| (Reverse(self.size(questions[0])), Reverse(questions.len())));
        let mut cases = HashMap::new();
        for (topic, (_, questions)) in groups.iter().enumerate() {
            for given in &questions[0].answers {
                if let (Some(case), Some(dialect)) = (&given.case, self.origins[given.origin as usize].1) {
                    let answer = self.words.word(given.answer).to_owned();
                    cases.insert((Arc::clone(case), dialect), (topic, answer));
                }
            }
        }
        let topics = groups.iter().map(|(_, questions)| self.topic(questions));
        let topics: Vec<Topic> = topics.collect();
        Contradictions {
            number: topics.len(),
            questions: questions.len(),
            topics,
            cases,
        }
    }

    /// Returns whether the answers to a question differ, after those of origins were taken out that give several answers themselves: they
    /// were asked more than the question says.
    fn differs(&self, question: &mut GatheredQuestion) -> bool {
        let first = question.answers.first().map(|given| given.answer);
        if question.answers.iter().all(|given| Some(given.answer) == first) {
            return false;
        }
        let mut of_origin: HashMap<(&AnswerOrigin, Option<DialectName>), BTreeSet<u32>> = HashMap::new();
        let origin = |given: &GivenAnswer| {
            let (origin, dialect) = &self.origins[given.origin as usize];
            // The standard says the same in each dialect.
            (origin, dialect.filter(|_| origin.kind != "standard"))
        };
        for given in &question.answers {
            of_origin.entry(origin(given)).or_default().insert(given.answer);
        }
        question
            .answers
            .retain(|given| of_origin[&origin(given)].len() == 1);
        self.size(question).0 > 1
    }

    /// Returns the numbers of different answers and of systems.
    fn size(&self, question: &GatheredQuestion) -> (usize, usize) {
        let answers: BTreeSet<u32> = question.answers.iter().map(|given| given.answer).collect();
        let systems: BTreeSet<&str> = question
            .answers
            .iter()
            .map(|given| self.speaker(given).0)
            .collect();
        (answers.len(), systems.len())
    }

    /// Returns who gives an answer: a system by its documents, or as it was recorded, in a dialect.
    fn speaker(&self, given: &GivenAnswer) -> (&str, &'static str, Option<DialectName>) {
        let (origin, dialect) = &self.origins[given.origin as usize];
        (&origin.system, origin.kind, *dialect)
    }

    fn sides(&self, question: &GatheredQuestion) -> Sides<'_> {
        let mut sides = Sides::new();
        for given in &question.answers {
            sides.entry(self.speaker(given)).or_default().insert(given.answer);
        }
        sides
    }

    /// Returns the topic of questions, the first of which is shown.
    fn topic(&self, questions: &[&GatheredQuestion]) -> Topic {
        let shown = questions[0];
        let mut by_answer: BTreeMap<u32, BTreeSet<&AnswerOrigin>> = BTreeMap::new();
        for given in &shown.answers {
            let (origin, _) = &self.origins[given.origin as usize];
            by_answer.entry(given.answer).or_default().insert(origin);
        }
        let answers = by_answer.into_iter().map(|(answer, by)| TopicAnswer {
            answer: self.words.word(answer).to_owned(),
            by: by.into_iter().cloned().collect(),
        });
        let mut answers: Vec<TopicAnswer> = answers.collect();
        answers.sort_by(|a, b| (b.by.len(), &a.answer).cmp(&(a.by.len(), &b.answer)));
        let others = questions[1..].iter().map(|question| question.asked.text.clone());
        let AskedQuestion {
            text,
            kind,
            case,
            program,
            ..
        } = shown.asked.clone();
        Topic {
            question: text,
            kind,
            case: case.map(|id| id.to_string()),
            program: program.map(|text| text.to_string()),
            answers,
            systems: self.size(shown).1,
            questions: questions.len(),
            others: others.take(MAX_OTHERS).collect(),
        }
    }
}

/// Returns whether those who answer both questions part alike: whoever agrees on one agrees on the other, and at least two disagree.
fn part_alike(one: &Sides<'_>, other: &Sides<'_>) -> bool {
    let common = one
        .iter()
        .filter_map(|(who, first)| Some((first, other.get(who)?)));
    let pairs: BTreeSet<_> = common.collect();
    let firsts: BTreeSet<_> = pairs.iter().map(|(first, _)| first).collect();
    let seconds: BTreeSet<_> = pairs.iter().map(|(_, second)| second).collect();
    firsts.len() > 1 && firsts.len() == pairs.len() && seconds.len() == pairs.len()
}
