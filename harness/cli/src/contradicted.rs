//! Collects what sources answer to the questions of cases, for [`stickler_conversions::contradictions`].
//!
//! An answer is what a document or the standard states, or what a product was recorded or measured to do. A case that rests on one of
//! Stickler's own rules has none, nor has one of another system's document, nor the reference.

use std::collections::HashMap;
use std::fmt::Write;
use std::sync::Arc;
use stickler_conversions::contradictions::{AnswerOrigin, AskedQuestion, ContradictionsBuilder, kind_of};
use stickler_conversions::recording::Recording;
use stickler_suite::{Acceptance, Case, Expectation, Source, SourceKind, Suite};
use stickler_types::{DialectName, MatrixWord, Question};

/// The answer to a program that must be taken, and to one that must not.
const ACCEPTED: &str = "accepted";
const REJECTED: &str = "rejected";

/// Returns the answers that these cases of a suite, its statements and the recordings have.
pub fn gather(cases: &[&Case], suite: &Suite, recordings: &[Recording]) -> ContradictionsBuilder {
    let mut gathering = Gathering {
        suite,
        builder: ContradictionsBuilder::default(),
        origins: HashMap::new(),
    };
    for case in cases {
        if let Some(origin) = gathering.origin_of_case(case) {
            gathering.add(case, origin);
        }
    }
    for stated in &suite.statements {
        gathering.add_statement(&stated.asks, &stated.answers);
    }
    let address = |name: &str| {
        suite
            .sources
            .get("recording")
            .map(|source| source.address_of(name))
    };
    for recording in recordings {
        let address = address(&recording.name).unwrap_or_default();
        gathering.builder.recording(recording, &address);
    }
    gathering.builder
}

/// Answers as they are gathered.
struct Gathering<'s> {
    suite: &'s Suite,
    builder: ContradictionsBuilder,
    /// The number of the origin of a basis in a dialect; `None` where it is none.
    origins: HashMap<(Arc<str>, DialectName), Option<u32>>,
}

impl Gathering<'_> {
    /// Returns the origin of what a case states; `None` where no source of its own system states anything.
    fn origin_of_case(&mut self, case: &Case) -> Option<u32> {
        let is_variant = case.dialect.is_variant() || case.dialect.is_custom();
        if is_variant || case.placement.is_some() || case.is_open() {
            return None;
        }
        let key = (Arc::clone(&case.basis), case.dialect);
        if let Some(known) = self.origins.get(&key) {
            return *known;
        }
        let origin = self.origin(&case.basis, Some(case.dialect));
        self.origins.insert(key, origin);
        origin
    }

    /// Returns the origin of a basis in a dialect, or, of a statement, in the dialect for which its source speaks first.
    fn origin(&mut self, basis: &str, dialect: Option<DialectName>) -> Option<u32> {
        let (source, section) = self.suite.sources.of(basis)?;
        let speaks = dialect.is_none_or(|dialect| source.speaks_for(section, dialect));
        if source.kind == SourceKind::Rule || !speaks {
            return None;
        }
        let dialect = dialect.or_else(|| source.dialects_of(section).first().copied());
        let origin = AnswerOrigin {
            system: system(source, dialect),
            kind: source.kind.as_str(),
            source: basis.to_owned(),
            publisher: source.relation.map(|_| source.publisher.clone()),
            read: source.read_of(section).into_owned(),
            address: source.address_of(section),
        };
        Some(self.builder.origin(origin, dialect))
    }

    fn add(&mut self, case: &Case, origin: u32) {
        match case.question.as_deref() {
            Some(question @ Question::Call(call)) => {
                self.add_question(question, origin, result(&case.expectation), case);
                let signature = stickler_exact::signature_of(call, case.dialect);
                let page = signature
                    .and_then(|found| stickler_exact::stated_by_vendor(&found, &call.operands, case.dialect));
                if let Some((value, basis)) = page
                    && let Some(origin) = self.origin(basis, Some(case.dialect))
                {
                    self.add_question(question, origin, Some(value.to_string()), case);
                }
            }
            Some(question) => {
                let answer = match (&case.cell, case.expectation.accepted) {
                    (Some(cell), _) if cell.word == MatrixWord::No => Some(REJECTED),
                    (Some(cell), _) if cell.word == MatrixWord::Open => None,
                    (None, Acceptance::Rejected) => Some(REJECTED),
                    (None, Acceptance::Observed) => None,
                    _ => Some(ACCEPTED),
                };
                self.add_question(question, origin, answer.map(str::to_owned), case);
            }
            None => self.add_program(case, origin),
        }
    }

    fn add_question(&mut self, question: &Question, origin: u32, answer: Option<String>, case: &Case) {
        let Some(answer) = answer else { return };
        let text = question.to_string();
        let number = self.builder.question(&text, || AskedQuestion {
            text: text.clone(),
            kind: kind_of(question),
            case: Some(Arc::clone(&case.id)),
            program: None,
        });
        self.builder.answer(number, origin, &answer, Some(&case.id));
    }

    /// Adds the answers of a program without a question of its own: whether it is accepted, and the value of each variable.
    fn add_program(&mut self, case: &Case, origin: u32) {
        let Expectation {
            accepted,
            values,
            fault,
            rendered,
            ..
        } = &*case.expectation;
        if rendered.is_some() || !case.set.is_empty() || !case.clock.is_empty() {
            return;
        }
        match accepted {
            Acceptance::Required => self.add_asked(case, None, origin, ACCEPTED),
            Acceptance::Rejected => self.add_asked(case, None, origin, REJECTED),
            Acceptance::Observed => {}
        }
        for expected in values {
            let variable = (&*expected.name, expected.after);
            self.add_asked(case, Some(variable), origin, &expected.value.to_string());
        }
        if let Some(expected) = fault {
            let stops = format!("stops: {}", expected.fault);
            for observed in case.observe.iter() {
                self.add_asked(case, Some((&observed.name, observed.after)), origin, &stops);
            }
        }
    }

    /// Adds what a case answers to the question whether its program is accepted, or which value a variable has after a scan.
    fn add_asked(&mut self, case: &Case, variable: Option<(&str, Option<u32>)>, origin: u32, answer: &str) {
        let mut asked = String::new();
        if let Some((name, after)) = variable {
            asked = format!(", {name}");
            if let Some(scan) = after {
                let _ = write!(asked, " after scan {scan}");
            }
        }
        let key = format!("{}\n{}{asked}", case.source, case.scans);
        let number = self.builder.question(&key, || AskedQuestion {
            text: format!("{}{asked}", case.title),
            // The cases of one probe vary one thing.
            kind: case.id.split('(').next().unwrap_or_default().to_owned(),
            case: Some(Arc::clone(&case.id)),
            program: Some(Arc::clone(&case.source)),
        });
        self.builder.answer(number, origin, answer, Some(&case.id));
    }

    fn add_statement(&mut self, asks: &str, answers: &[(String, Vec<String>)]) {
        let kind = || match asks.parse::<Question>() {
            Ok(question) => kind_of(&question),
            Err(_) => "statement".to_owned(),
        };
        let number = self.builder.question(asks, || AskedQuestion {
            text: asks.to_owned(),
            kind: kind(),
            case: None,
            program: None,
        });
        for (answer, by) in answers {
            for basis in by {
                if let Some(origin) = self.origin(basis, None) {
                    self.builder.answer(number, origin, answer, None);
                }
            }
        }
    }
}

/// Returns the system of which a source speaks in a dialect: the title of the dialect up to its flavour, of a standard the edition.
fn system(source: &Source, dialect: Option<DialectName>) -> String {
    let title = |dialect: DialectName| dialect.rules().title.as_str();
    if source.kind == SourceKind::Standard {
        let edition = dialect.filter(|dialect| source.dialects.contains(dialect));
        let edition = edition.or_else(|| source.dialects.first().copied());
        return edition.map_or_else(|| source.key.clone(), |dialect| title(dialect).to_owned());
    }
    match dialect {
        Some(dialect) => title(dialect).split(',').next().unwrap_or_default().to_owned(),
        None => source.publisher.clone(),
    }
}

/// Returns the result of a call that a case asserts; `None` where it asserts only acceptance, or a rejection, which may be that of the name.
fn result(expectation: &Expectation) -> Option<String> {
    match (&expectation.values[..], &expectation.fault) {
        ([only], _) => Some(only.value.to_string()),
        (_, Some(expected)) => Some(format!("stops: {}", expected.fault)),
        _ => None,
    }
}
