//! Recordings: what a compiler answered to implicit conversions and conversion functions, with its product, version and date,
//! to be shown where the compiler itself is not at hand.
//!
//! [`Recording::ask`] asks an engine, [`Recording::write`] writes the file, and [`Recording::parse`] reads it.

mod ask;
mod parse;
mod write;

use crate::implicit::{MatrixAnswer, TypePair};
use crate::session::{Refusal, RefusalKind};
use std::collections::HashMap;
use stickler_engines::{Ability, Grade, Identity};
use stickler_exact::Signature;
use stickler_types::{DialectName, Value};

pub use parse::RecordingError;

/// The answers of one version of a compiler.
#[derive(Clone, PartialEq, Debug)]
pub struct Recording {
    /// The origin of the answers.
    pub origin: RecordingOrigin,
    /// The dialects in which the compiler was asked.
    pub dialects: Vec<DialectName>,
    implicit: HashMap<(DialectName, TypePair), MatrixAnswer>,
    functions: HashMap<(DialectName, String), FunctionAnswers>,
}

/// The origin of a recording.
#[derive(Clone, PartialEq, Eq, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RecordingOrigin {
    /// The name of the compiler.
    pub product: String,
    /// The version of the compiler.
    pub version: String,
    /// The commit of the compiler's sources, where it is known.
    pub commit: Option<String>,
    /// The operating system and the processor on which the compiler ran.
    pub platform: String,
    /// The day, as in `2026-11-24`.
    pub date: String,
}

/// The answers to the calls of one signature.
#[derive(Clone, PartialEq, Debug)]
enum FunctionAnswers {
    /// Every call was refused in the same way.
    Refused(RefusalKind),
    /// The answer to each call.
    Calls(Vec<(Vec<Value>, Result<Value, RefusalKind>)>),
}

impl Recording {
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
        self.implicit.get(&(dialect, pair)).copied()
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
    use super::{Recording, RecordingOrigin};
    use crate::implicit::MatrixAnswer;
    use crate::session::RefusalKind;
    use stickler_engines::Reference;
    use stickler_types::{DialectName, ElementaryType, Value};

    const ORIGIN: &str =
        "[recording]\nproduct = \"p\"\nversion = \"1\"\nplatform = \"l\"\ndate = \"2026-11-24\"\n";
    const ANSWERS: &str = "[[answers]]\ndialects = [\"matiec\"]\n";

    fn parsed(text: &str) -> Result<Recording, String> {
        Recording::parse("r.toml", text).map_err(|error| error.to_string())
    }

    #[test]
    fn what_was_written_is_read_again() {
        let origin = parsed(ORIGIN).unwrap().origin;
        let with_commit = RecordingOrigin {
            commit: Some("a\"b".to_owned()),
            ..origin
        };
        let dialects = [DialectName::Matiec, DialectName::IronplcEd2];
        let reference = Reference::default();
        let recording = Recording::ask(&reference, with_commit, &dialects, 0, &|| {}).unwrap();
        let mut text = Vec::new();
        recording.write(&mut text).unwrap();
        let mut read = parsed(std::str::from_utf8(&text).unwrap()).unwrap();
        read.dialects
            .sort_by_key(|dialect| *dialect != DialectName::Matiec);
        assert_eq!(read, recording);
    }

    #[test]
    fn a_call_that_was_not_recorded_has_no_answer() {
        let text = format!(
            "{ORIGIN}{ANSWERS}[answers.implicit]\nINT = {{ accepts = \"INT DINT\" }}\n\
             [answers.functions]\n\"REAL_TO_INT(REAL) : INT\" = [[\"2.5\", \"3\"], [\"NaN\", \"crashed\"]]\n\
             \"INT_TO_BOOL(INT) : BOOL\" = \"rejected\"\n"
        );
        let recording = parsed(&text).unwrap();
        let implicit = |into| recording.implicit(DialectName::Matiec, (ElementaryType::Int, into));
        assert_eq!(implicit(ElementaryType::Dint), Some(MatrixAnswer::Accepts));
        assert_eq!(implicit(ElementaryType::Real), None);
        let results = |function, operands: &[&str]| -> Vec<Result<Value, RefusalKind>> {
            let signature = &stickler_exact::signatures(function, DialectName::Matiec)[0];
            let call = |literal: &&str| vec![Value::parse(literal).unwrap()];
            let calls: Vec<Vec<Value>> = operands.iter().map(call).collect();
            let results = recording.results(DialectName::Matiec, signature, &calls);
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
        ] {
            let message = parsed(&text).unwrap_err();
            assert!(
                message.starts_with(&format!("r.toml:{line}: ")) && message.contains(part),
                "{message}\nfor {text}"
            );
        }
    }
}
