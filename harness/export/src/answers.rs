//! Reads `answers.txt`, in which a person notes the outcome of cases that no array of results can show, one line for each case.

use crate::ExportError;
use crate::paste::decoded;
use std::collections::BTreeMap;
use std::fs;
use std::io::ErrorKind;
use std::path::Path;
use stickler_types::{DialectName, words};

/// The name of the file of answers.
pub const ANSWERS: &str = "answers.txt";

pub(crate) const TEMPLATE: &str = include_str!("answers.txt");

words! {
    /// The outcome of a case that a person observed.
    ReportedOutcome {
        /// The compiler accepts the program.
        Accepted = "accepted",
        /// The compiler rejects the program.
        Rejected = "rejected",
        /// The compiler crashes over the program, or the controller stops in it.
        Crashed = "crashed",
    }
}

/// The answers of a person, by the id of the case, each with its place in the file.
pub(crate) type ReportedOutcomes = BTreeMap<String, (ReportedOutcome, String)>;

/// Reads the answers of a folder for cases of a dialect; none where there is no file of answers.
///
/// # Errors
/// [`ExportError::Read`]; [`ExportError::Answer`] with the line of a malformed answer, or of one that contradicts another.
pub(crate) fn read(folder: &Path, dialect: DialectName) -> Result<ReportedOutcomes, ExportError> {
    let path = folder.join(ANSWERS);
    match fs::read(&path) {
        Ok(bytes) => parse(&decoded(&bytes), &path, dialect),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(ReportedOutcomes::new()),
        Err(error) => Err(ExportError::Read(path, error)),
    }
}

fn parse(text: &str, path: &Path, dialect: DialectName) -> Result<ReportedOutcomes, ExportError> {
    let mut answers = ReportedOutcomes::new();
    // Reports write the dialect after each id.
    let dialect = format!("@{dialect}");
    for (number, line) in text.lines().enumerate() {
        let line = line.trim();
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        let at = format!("{}:{}", path.display(), number + 1);
        let broken = |what: &str| ExportError::Answer(at.clone(), what.to_owned());
        let (word, id) = line
            .split_once(char::is_whitespace)
            .ok_or_else(|| broken("a word and the id of a case are missing; such as `rejected widening/integer::assignment(SINT,INT,0)`"))?;
        let answer = ReportedOutcome::from_word(&word.to_ascii_lowercase()).ok_or_else(|| {
            broken(&format!(
                "`{word}` is no answer; the answers are `accepted`, `rejected` and `crashed`"
            ))
        })?;
        let id = id.trim();
        let id = id.strip_suffix(&dialect).unwrap_or(id);
        if let Some((other, before)) = answers.get(id)
            && *other != answer
        {
            return Err(broken(&format!("{id} has another answer at {before}")));
        }
        answers.insert(id.to_owned(), (answer, at));
    }
    Ok(answers)
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_mdtest::check_examples;

    #[test]
    fn answers_are_a_word_and_an_id() {
        let text = format!("{TEMPLATE}\r\n  Rejected  a/b::c(INT,*,1)\r\ncrashed x/y@matiec\naccepted z\n");
        let answers = parse(&text, Path::new("answers.txt"), DialectName::MATIEC).expect("answers");
        let reported: Vec<(&str, ReportedOutcome)> = answers
            .iter()
            .map(|(id, (answer, _))| (id.as_str(), *answer))
            .collect();
        let expected = [
            ("a/b::c(INT,*,1)", ReportedOutcome::Rejected),
            ("x/y", ReportedOutcome::Crashed),
            ("z", ReportedOutcome::Accepted),
        ];
        assert_eq!(reported, expected);
    }

    #[test]
    fn answers_may_be_written_by_any_editor() {
        let folder = tempfile::tempdir().expect("a folder");
        let text = "rejected a/b\r\n";
        let utf_16 = text.encode_utf16().flat_map(u16::to_le_bytes);
        for bytes in [
            format!("\u{feff}{text}").into_bytes(),
            [0xFF, 0xFE].into_iter().chain(utf_16).collect(),
        ] {
            fs::write(folder.path().join(ANSWERS), bytes).expect("written");
            let answers = read(folder.path(), DialectName::MATIEC).expect("answers");
            assert_eq!(answers["a/b"].0, ReportedOutcome::Rejected);
        }
    }

    #[test]
    fn golden_mistakes_of_answers() {
        check_examples("tests/answers.md", |example| {
            let parsed = parse(
                example.text("text"),
                Path::new("answers.txt"),
                DialectName::MATIEC,
            );
            parsed.expect_err("a mistake").to_string()
        });
    }
}
