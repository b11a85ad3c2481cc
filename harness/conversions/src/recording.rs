//! Recordings: what a compiler answered to implicit conversions, bit access, comparisons and conversion functions, with its product,
//! version and date, to be shown where the compiler itself is not at hand.
//!
//! [`Recording::ask`] asks an engine, and a [`RecordingBuilder`] takes what a person copied out of an editor; [`Recording::write`]
//! writes the file, and [`Recording::parse`] reads it. A [`Question`] is what is asked.

mod ask;
mod imported;
mod parse;
mod questions;
mod tables;
mod write;

use crate::implicit::{MatrixAnswer, TypePair};
use crate::session::{Refusal, RefusalKind};
use std::collections::HashMap;
use stickler_engines::{Ability, Grade, Identity};
use stickler_exact::Signature;
use stickler_types::{DialectName, ElementaryType, RecordingOrigin, Value};

pub use imported::RecordingBuilder;
pub use parse::RecordingError;
pub use questions::{Question, extreme};
pub use tables::{RecordedTable, RecordedTables};

/// The answers of one version of a compiler.
#[derive(Clone, PartialEq, Debug)]
pub struct Recording {
    /// The name of its file without the ending, by which runs name the engine.
    pub name: String,
    /// The origin of the answers.
    pub origin: RecordingOrigin,
    /// The dialects in which the compiler was asked.
    pub dialects: Vec<DialectName>,
    /// The words of answers, by dialect.
    words: HashMap<(DialectName, WordKey), &'static str>,
    functions: HashMap<(DialectName, String), FunctionAnswers>,
}

/// The place of a word in a recording: its section, its row, and in that another type or a part.
type WordKey = (RecordedSection, ElementaryType, String);

/// Whether the [`extreme`] value of one type is less than that of another, or why there is no answer.
pub type ComparisonAnswer = Result<bool, RefusalKind>;

/// Calls by their operands, each with its result or the reason why there is none.
type AnsweredCalls = Vec<(Vec<Value>, Result<Value, RefusalKind>)>;

/// The answers to the calls of one signature.
#[derive(Clone, PartialEq, Debug)]
enum FunctionAnswers {
    /// Every call was refused in the same way.
    Refused(RefusalKind),
    /// The answer to each call.
    Calls(AnsweredCalls),
}

/// A section of the answers of a recording.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum RecordedSection {
    /// The pairs of types that convert implicitly.
    Implicit,
    /// The bits and parts of a type that can be read.
    Bits,
    /// The results of comparisons of different types.
    Comparisons,
    /// The results of conversion functions.
    Functions,
}

impl RecordedSection {
    /// Every section, in the order in which a file has them.
    pub const ALL: [RecordedSection; 4] = [
        RecordedSection::Implicit,
        RecordedSection::Bits,
        RecordedSection::Comparisons,
        RecordedSection::Functions,
    ];

    /// Returns the name of the section in a file.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            RecordedSection::Implicit => "implicit",
            RecordedSection::Bits => "bits",
            RecordedSection::Comparisons => "comparisons",
            RecordedSection::Functions => "functions",
        }
    }
}

impl FunctionAnswers {
    /// Returns the answers to calls, as one word where all were refused in the same way.
    fn of(calls: AnsweredCalls) -> FunctionAnswers {
        match &calls[..] {
            [(_, Err(kind)), rest @ ..] if rest.iter().all(|(_, answer)| *answer == Err(*kind)) => {
                FunctionAnswers::Refused(*kind)
            }
            _ => FunctionAnswers::Calls(calls),
        }
    }

    /// Returns the answers call by call; the key says the dialect and the signature.
    fn of_calls(self, (dialect, row): &(DialectName, String)) -> AnsweredCalls {
        match self {
            FunctionAnswers::Calls(calls) => calls,
            FunctionAnswers::Refused(kind) => {
                let signatures = questions::signatures(*dialect).into_iter();
                signatures
                    .filter(|signature| key(signature) == *row)
                    .flat_map(|signature| crate::overview::boundary_calls(&signature))
                    .map(|call| (call, Err(kind)))
                    .collect()
            }
        }
    }
}

impl Recording {
    /// Returns a recording without answers.
    fn empty(name: &str, origin: RecordingOrigin, dialects: Vec<DialectName>) -> Recording {
        Recording {
            name: name.to_owned(),
            origin,
            dialects,
            words: HashMap::new(),
            functions: HashMap::new(),
        }
    }

    /// Adds the answers of an older recording of the same compiler where this one has none.
    pub fn complete_from(&mut self, older: Recording) {
        for dialect in older.dialects {
            if !self.dialects.contains(&dialect) {
                self.dialects.push(dialect);
            }
        }
        for (key, word) in older.words {
            self.words.entry(key).or_insert(word);
        }
        for (key, answers) in older.functions {
            match (self.functions.get_mut(&key), answers) {
                (None, answers) => {
                    self.functions.insert(key, answers);
                }
                (Some(FunctionAnswers::Calls(known)), answers) => {
                    let calls = answers.of_calls(&key);
                    let is_new = |call: &(Vec<Value>, _)| known.iter().all(|(known, _)| *known != call.0);
                    let new: Vec<_> = calls.into_iter().filter(is_new).collect();
                    known.extend(new);
                }
                // The new answers are to every call.
                (Some(FunctionAnswers::Refused(_)), _) => {}
            }
        }
    }

    /// Returns the identity under which the answers are shown beside those of engines.
    #[must_use]
    pub fn identity(&self) -> Identity {
        let RecordingOrigin {
            product,
            version,
            date,
            ..
        } = &self.origin;
        Identity {
            name: format!("{product} {version}"),
            version: format!("(recorded {date})"),
            dialects: self.dialects.clone(),
            abilities: vec![Ability::Check, Ability::Execute],
            grade: Grade::Rejected,
            lacks: Vec::new(),
        }
    }

    /// Returns the recorded reaction to a value of one type in a variable of another; `None` where it was not asked.
    #[must_use]
    pub fn implicit(&self, dialect: DialectName, pair: TypePair) -> Option<MatrixAnswer> {
        let word = self.word(
            dialect,
            (RecordedSection::Implicit, pair.0, pair.1.name().to_owned()),
        );
        word.and_then(MatrixAnswer::from_word)
    }

    /// Returns the recorded reaction to a program that reads a bit or a part of a variable, such as `7` or `%B1`; `None` where it was not
    /// asked.
    #[must_use]
    pub fn part(&self, dialect: DialectName, ty: ElementaryType, part: &str) -> Option<MatrixAnswer> {
        let word = self.word(dialect, (RecordedSection::Bits, ty, part.to_owned()));
        word.and_then(MatrixAnswer::from_word)
    }

    /// Returns whether the [`extreme`] value of the first type is less than that of the second; `None` where it was not asked.
    #[must_use]
    pub fn comparison(&self, dialect: DialectName, pair: TypePair) -> Option<ComparisonAnswer> {
        let key = (RecordedSection::Comparisons, pair.0, pair.1.name().to_owned());
        match self.word(dialect, key)? {
            "true" => Some(Ok(true)),
            "false" => Some(Ok(false)),
            word => RefusalKind::from_word(word).map(Err),
        }
    }

    /// Returns each pair of types of which a comparison was asked, in order, with the word of the answer: `true`, `false`, `rejected` …
    #[must_use]
    pub fn all_comparisons(&self, dialect: DialectName) -> Vec<(TypePair, &'static str)> {
        let pairs = questions::pairs_compared().into_iter();
        let answered = pairs.filter_map(|pair| {
            let key = (RecordedSection::Comparisons, pair.0, pair.1.name().to_owned());
            Some((pair, self.word(dialect, key)?))
        });
        answered.collect()
    }

    fn word(&self, dialect: DialectName, key: WordKey) -> Option<&'static str> {
        self.words.get(&(dialect, key)).copied()
    }

    /// Returns the recorded result of each call of a function. A call that was not recorded is a refusal of the kind
    /// [`RefusalKind::NotAsked`].
    #[must_use]
    pub fn results(
        &self,
        dialect: DialectName,
        signature: &Signature,
        calls: &[Vec<Value>],
    ) -> Vec<Result<Value, Refusal>> {
        let answers = self.functions.get(&(dialect, key(signature)));
        let answer = |call: &Vec<Value>| match answers {
            Some(FunctionAnswers::Refused(kind)) => Err(*kind),
            Some(FunctionAnswers::Calls(known)) => known
                .iter()
                .find(|(operands, _)| operands == call)
                .map_or(Err(RefusalKind::NotAsked), |(_, answer)| answer.clone()),
            None => Err(RefusalKind::NotAsked),
        };
        let refusal = |kind| Refusal {
            kind,
            detail: format!("recorded {}", self.origin.date),
            line: None,
        };
        calls.iter().map(|call| answer(call).map_err(refusal)).collect()
    }
}

/// Returns the word for the answer to a comparison.
fn comparison_word(answer: ComparisonAnswer) -> &'static str {
    match answer {
        Ok(true) => "true",
        Ok(false) => "false",
        Err(kind) => kind.word(),
    }
}

/// Returns the key of a signature in a file: `REAL_TO_INT(REAL) : INT`.
fn key(signature: &Signature) -> String {
    let operands: Vec<&str> = signature.operands.iter().map(|ty| ty.name()).collect();
    format!(
        "{}({}) : {}",
        signature.function,
        operands.join(", "),
        signature.result
    )
}

#[cfg(test)]
mod tests {
    use super::{RecordedSection, Recording, RecordingOrigin};
    use crate::implicit::MatrixAnswer;
    use crate::session::RefusalKind;
    use stickler_engines::Reference;
    use stickler_types::{DialectName, ElementaryType, Value};

    const ORIGIN: &str =
        "[recording]\nproduct = \"p\"\nversion = \"1\"\nplatform = \"l\"\ndate = \"2026-11-24\"\n";
    const ANSWERS: &str = "[[answers]]\ndialects = [\"matiec\"]\n";

    fn parsed(text: &str) -> Result<Recording, String> {
        Recording::parse("reference.toml", text).map_err(|error| error.to_string())
    }

    #[test]
    fn what_was_written_is_read_again() {
        let origin = parsed(ORIGIN).unwrap().origin;
        let with_commit = RecordingOrigin {
            commit: Some("a\"b".to_owned()),
            ..origin
        };
        let dialects = [DialectName::MATIEC, DialectName::IRONPLC_ED2];
        let reference = Reference::default();
        let sections = &RecordedSection::ALL;
        let recording = Recording::ask(&reference, with_commit, &dialects, sections, 0, &|| {}).unwrap();
        let mut text = Vec::new();
        recording.write(&mut text).unwrap();
        let mut read = parsed(std::str::from_utf8(&text).unwrap()).unwrap();
        read.dialects
            .sort_by_key(|dialect| *dialect != DialectName::MATIEC);
        assert_eq!(read, recording);
    }

    #[test]
    fn what_an_older_recording_knows_stays_where_the_new_one_has_no_answer() {
        let of = |answers: &str| parsed(&format!("{ORIGIN}{ANSWERS}{answers}")).unwrap();
        let mut new = of("[answers.bits]\nINT = { accepts = \"0\" }\n\
             [answers.functions]\n\"INT_TO_SINT(INT) : SINT\" = [[\"1\", \"1\"]]\n");
        new.complete_from(of("[answers.bits]\nINT = { rejects = \"0 16\" }\n\
             [answers.comparisons]\nINT = { false = \"UINT\", \"timed out\" = \"REAL\" }\n\
             [answers.functions]\n\"INT_TO_SINT(INT) : SINT\" = [[\"1\", \"7\"], [\"2\", \"2\"]]\n"));
        let expected = of("[answers.bits]\nINT = { accepts = \"0\", rejects = \"16\" }\n\
             [answers.comparisons]\nINT = { false = \"UINT\", \"timed out\" = \"REAL\" }\n\
             [answers.functions]\n\"INT_TO_SINT(INT) : SINT\" = [[\"1\", \"1\"], [\"2\", \"2\"]]\n");
        assert_eq!(new, expected);
        let mut new = of("[answers.functions]\n\"INT_TO_SINT(INT) : SINT\" = [[\"1\", \"1\"]]\n");
        new.complete_from(of(
            "[answers.functions]\n\"INT_TO_SINT(INT) : SINT\" = \"rejected\"\n",
        ));
        let signature = &stickler_exact::signatures("INT_TO_SINT", DialectName::MATIEC)[0];
        let calls = [["INT#1"], ["INT#0"]].map(|call| call.map(|text| Value::parse(text).unwrap()).to_vec());
        let results = new.results(DialectName::MATIEC, signature, &calls);
        let results = results
            .into_iter()
            .map(|result| result.map_err(|refusal| refusal.kind));
        assert!(results.eq([Ok(Value::parse("SINT#1").unwrap()), Err(RefusalKind::Rejected)]));
    }

    #[test]
    fn a_call_that_was_not_recorded_has_no_answer() {
        let text = format!(
            "{ORIGIN}{ANSWERS}[answers.implicit]\nINT = {{ accepts = \"INT DINT\" }}\n\
             [answers.functions]\n\"REAL_TO_INT(REAL) : INT\" = [[\"2.5\", \"3\"], [\"NaN\", \"crashed\"]]\n\
             \"INT_TO_BOOL(INT) : BOOL\" = \"rejected\"\n"
        );
        let recording = parsed(&text).unwrap();
        let implicit = |into| recording.implicit(DialectName::MATIEC, (ElementaryType::Int, into));
        assert_eq!(implicit(ElementaryType::Dint), Some(MatrixAnswer::Accepts));
        assert_eq!(implicit(ElementaryType::Real), None);
        let results = |function, operands: &[&str]| -> Vec<Result<Value, RefusalKind>> {
            let signature = &stickler_exact::signatures(function, DialectName::MATIEC)[0];
            let call = |literal: &&str| vec![Value::parse(literal).unwrap()];
            let calls: Vec<Vec<Value>> = operands.iter().map(call).collect();
            let results = recording.results(DialectName::MATIEC, signature, &calls);
            let kind = |result: Result<Value, crate::Refusal>| result.map_err(|refusal| refusal.kind);
            results.into_iter().map(kind).collect()
        };
        assert_eq!(
            results("REAL_TO_INT", &["REAL#2.5", "REAL#NaN", "REAL#7.5"]),
            [
                Ok(Value::parse("INT#3").unwrap()),
                Err(RefusalKind::Crashed),
                Err(RefusalKind::NotAsked)
            ]
        );
        assert_eq!(results("INT_TO_BOOL", &["INT#7"]), [Err(RefusalKind::Rejected)]);
        assert_eq!(results("INT_TO_DINT", &["INT#7"]), [Err(RefusalKind::NotAsked)]);
    }

    #[test]
    fn a_mistake_is_refused_with_its_line_and_what_to_do() {
        let row = |kind: &str, row: &str| format!("{ORIGIN}{ANSWERS}[answers.{kind}]\n{row}\n");
        let function = |row_text: &str| row("functions", row_text);
        for (text, line, part) in [
            (
                ORIGIN.replace("product = \"p\"\n", ""),
                1,
                "missing field `product`; a recording says",
            ),
            (
                ORIGIN.replace("version = \"1\"\n", ""),
                1,
                "missing field `version`; a recording says",
            ),
            (
                ORIGIN.replace("\"1\"", "\" \""),
                1,
                "`version` is empty; say there",
            ),
            (format!("{ORIGIN}prodct = \"p\"\n"), 6, "unknown field `prodct`"),
            (
                format!("{ORIGIN}{}", ANSWERS.replace("matiec", "mattiec")),
                6,
                "mattiec",
            ),
            (
                row("implicit", "INTT = { accepts = \"INT\" }"),
                9,
                "`INTT` is no elementary type",
            ),
            (
                row("implicit", "INT = { likes = \"INT\" }"),
                9,
                "`likes` is no answer of a compiler; one of accepts, ",
            ),
            (
                function("\"REAL_TO_INT\" = \"rejected\""),
                9,
                "is no signature such as",
            ),
            (function("\"F(INT) : INT\" = \"sad\""), 9, "`sad` is neither"),
            (
                function("\"F(INT) : INT\" = [[\"1\", \"99999\"]]"),
                9,
                "`99999` is neither",
            ),
            (
                function("\"F(INT) : INT\" = [[\"x\", \"1\"]]"),
                9,
                "`x` is no value of type INT",
            ),
            (function("\"F(INT) : INT\" = [[\"1\"]]"), 9, "a list of 2 texts"),
            (
                row("bits", "INT = { accepts = \"0 %Q1\" }"),
                9,
                "`%Q1` is no bit or part such as `7`, `%X7` or `%B1`",
            ),
            (
                row("comparisons", "INT = { maybe = \"DINT\" }"),
                9,
                "`maybe` is neither `true` nor `false` nor one of unsupported, ",
            ),
            (
                ORIGIN.replace("2026-11-24", "24.11.2026"),
                1,
                "`24.11.2026` is no date such as 2026-11-24",
            ),
        ] {
            let message = parsed(&text).unwrap_err();
            assert!(
                message.starts_with(&format!("reference.toml:{line}: ")) && message.contains(part),
                "{message}\nfor {text}"
            );
        }
    }
}
