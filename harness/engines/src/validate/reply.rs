//! Judges one reply of an adapter: first against the protocol, as strictly as its schema, and then against the expected answer.

use super::CheckVerdict;
use super::smoke::SmokeExpectation;
use crate::process::excerpt;
use crate::protocol::Reply;
use crate::{Diagnostic, Grade};
use serde_json::Value as Json;
use stickler_types::{ElementaryType, Value};

/// Parses a line strictly: what the schema forbids is an error.
///
/// # Errors
/// A fragment that says what is wrong with the line.
pub(super) fn read(line: &[u8]) -> Result<Reply, String> {
    let no_reply = |error: serde_json::Error| format!("{} is no reply: {error}", excerpt(line));
    let reply: Reply = serde_json::from_slice(line).map_err(no_reply)?;
    match &reply {
        Reply::Rejected { diagnostics, .. } => diagnostics.iter().try_for_each(numbers)?,
        Reply::Faulted { line, .. } => from_one("line", *line)?,
        _ => {}
    }
    Ok(reply)
}

fn numbers(diagnostic: &Diagnostic) -> Result<(), String> {
    from_one("line", diagnostic.line)?;
    from_one("column", diagnostic.column)?;
    from_one("end_line", diagnostic.end_line)?;
    from_one("end_column", diagnostic.end_column)
}

fn from_one(key: &str, number: Option<u32>) -> Result<(), String> {
    match number {
        Some(0) => Err(format!("`{key}` is 0, and lines and columns count from 1")),
        _ => Ok(()),
    }
}

/// Returns the keys of a line that no reply has, the first of each place. They are ignored, and may be mistakes.
pub(super) fn further_keys(line: &[u8], reply: &Reply) -> Vec<String> {
    let mut further = Vec::new();
    if let (Ok(line), Ok(known)) = (serde_json::from_slice::<Json>(line), serde_json::to_value(reply)) {
        compare(&line, &known, &mut further);
    }
    further
}

/// Compares a line with its reply written back as JSON, which has every key that was understood.
fn compare(line: &Json, known: &Json, further: &mut Vec<String>) {
    match (line, known) {
        (Json::Object(line), Json::Object(known)) => {
            for (key, value) in line {
                match known.get(key) {
                    Some(known) => compare(value, known, further),
                    None if value.is_null() || further.contains(key) => {}
                    None => further.push(key.clone()),
                }
            }
        }
        (Json::Array(line), Json::Array(known)) => {
            line.iter()
                .zip(known)
                .for_each(|(line, known)| compare(line, known, further));
        }
        _ => {}
    }
}

/// The verdict on a reply, and what is amiss with it.
type ReplyVerdict = (CheckVerdict, Option<String>);

const RIGHT: ReplyVerdict = (CheckVerdict::Right, None);

fn broken(words: impl Into<String>) -> ReplyVerdict {
    (CheckVerdict::Broken, Some(words.into()))
}

fn wrong(words: impl Into<String>) -> ReplyVerdict {
    (CheckVerdict::Wrong, Some(words.into()))
}

/// Compares a reply, which answers the question at hand, with the expected answer. `grade` is what the adapter claims for its
/// rejections, and `types` gives the type of each observed value by its key.
pub(super) fn judge(
    reply: &Reply,
    expect: &SmokeExpectation,
    verb: &str,
    grade: Grade,
    types: &[(&str, &str)],
) -> ReplyVerdict {
    match (expect, reply) {
        (SmokeExpectation::Refused, Reply::Error { .. } | Reply::Unsupported { .. })
        | (SmokeExpectation::Error, Reply::Error { .. }) => RIGHT,
        (SmokeExpectation::Error, other) => broken(format!("it is answered by `{}`", other.word())),
        (_, Reply::Unsupported { reason, .. }) => {
            (CheckVerdict::Skipped, Some(format!("not supported: {reason}")))
        }
        (_, Reply::Error { message, .. }) => {
            broken(format!("it answers a sound request by an error: {message}"))
        }
        (SmokeExpectation::Accepted, Reply::Accepted { .. })
        | (SmokeExpectation::Rendered, Reply::Rendered { .. }) => RIGHT,
        (SmokeExpectation::Rejected { line }, Reply::Rejected { diagnostics, .. }) => {
            rejected(diagnostics, *line, grade)
        }
        (SmokeExpectation::Values(expected), Reply::Executed { values, .. }) => {
            let expected = expected.iter().filter_map(|value| value.split_once(" = "));
            let mut judged = expected.map(|(key, literal)| {
                let asked = types.iter().find(|(name, _)| *name == key);
                value(values.get(key), key, asked.map_or("", |(_, ty)| *ty), literal)
            });
            judged.find(|verdict| *verdict != RIGHT).unwrap_or(RIGHT)
        }
        (SmokeExpectation::Rejected { .. }, Reply::Accepted { .. } | Reply::Executed { .. }) => {
            wrong("the program is accepted, and must be rejected")
        }
        (SmokeExpectation::Refused, Reply::Executed { .. } | Reply::Accepted { .. }) => {
            broken(format!("it is answered by `{}`", reply.word()))
        }
        (SmokeExpectation::Values(_), Reply::Accepted { .. }) => {
            broken("it says that it can `execute`, and answers `run` by `accepted`")
        }
        (SmokeExpectation::Values(_), Reply::Faulted { fault, .. }) => {
            wrong(format!("the program stops with the fault {fault}"))
        }
        // A program that must be rejected came above; `Error` expects no reply but an error.
        (_, Reply::Rejected { diagnostics, .. }) => {
            let first = diagnostics
                .first()
                .map_or("without a word", |first| &first.message);
            wrong(format!("the program is rejected, and is sound: {first}"))
        }
        (_, other) => broken(format!("it answers `{verb}` by `{}`", other.word())),
    }
}

/// Judges a rejection, as far as the grade that the adapter claims.
fn rejected(diagnostics: &[Diagnostic], line: Option<u32>, grade: Grade) -> ReplyVerdict {
    if diagnostics.is_empty() {
        return broken("it rejects the program without a diagnostic");
    }
    let lines = diagnostics.iter().filter_map(|diagnostic| diagnostic.line);
    let named: Vec<u32> = lines.collect();
    if grade.suffices(Grade::Line) && named.is_empty() {
        return broken(format!(
            "no diagnostic names a line, and `hello` claims the grade `{grade}`; claim `rejected`"
        ));
    }
    if grade.suffices(Grade::Code) && diagnostics.iter().all(|diagnostic| diagnostic.code.is_none()) {
        return broken(format!(
            "no diagnostic has a code, and `hello` claims the grade `{grade}`; claim `line`"
        ));
    }
    match line {
        Some(line) if !named.is_empty() && !named.contains(&line) => wrong(format!(
            "the diagnostics name the lines {named:?}, and the mistake stands on line {line}"
        )),
        _ => RIGHT,
    }
}

/// The explanation of a value that has another type than was asked for, in the words that a run and a validation share.
pub const OTHER_TYPE: &str = "another type: the compiler gives the variable another one, or the adapter does not know the declared one";

/// Judges one value: its form, its type, and whether it is the expected one.
fn value(literal: Option<&String>, key: &str, ty: &str, expected: &str) -> ReplyVerdict {
    let Some(literal) = literal else {
        return broken(format!("`values` has no `{key}`, which was asked for"));
    };
    let value = match Value::parse(literal) {
        Ok(value) => value,
        Err(error) => {
            return broken(format!(
                "`{literal}` of `{key}` is no typed literal such as `{expected}`: {error}"
            ));
        }
    };
    if ElementaryType::from_name(value.type_name()) != ElementaryType::from_name(ty) {
        return wrong(format!(
            "`{literal}` of `{key}`, which was asked for as {ty}, has {OTHER_TYPE}"
        ));
    }
    match Value::parse(expected) {
        Ok(right) if right != value => wrong(format!("`{key}` is {literal}, and must be {expected}")),
        _ => RIGHT,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_schema_forbids_is_told() {
        let lines: [(&str, &str); 5] = [
            ("hello", "`hello` is no reply"),
            (r#"{"type":"accepted"}"#, "missing field `id`"),
            (
                r#"{"type":"rejected","id":1,"diagnostics":[{"line":0}]}"#,
                "`line` is 0, and lines and columns count from 1",
            ),
            (
                r#"{"type":"faulted","id":1,"fault":"bad luck","line":0}"#,
                "`line` is 0",
            ),
            (
                r#"{"type":"rejected","id":1,"diagnostics":[{"line":"5"}]}"#,
                "invalid type",
            ),
        ];
        for (line, part) in lines {
            let error = read(line.as_bytes()).unwrap_err();
            assert!(error.contains(part), "{error}");
        }
    }

    #[test]
    fn keys_that_no_reply_has_are_found_at_every_depth() {
        let line = br#"{"type":"rejected","id":1,"took":5,"diagnostics":[{"line":1,"colum":2,"code":null},{"colum":1}]}"#;
        let reply = read(line).unwrap();
        let mut further = further_keys(line, &reply);
        further.sort();
        assert_eq!(further, ["colum", "took"]);
    }

    #[test]
    fn a_wrong_value_is_the_compilers_and_a_wrong_literal_the_adapters() {
        let judge = |literal: &str| value(Some(&literal.to_owned()), "x", "INT", "INT#5").0;
        assert_eq!(judge("INT#5"), CheckVerdict::Right);
        assert_eq!(judge("INT#16#5"), CheckVerdict::Right);
        assert_eq!(judge("INT#6"), CheckVerdict::Wrong);
        assert_eq!(judge("5"), CheckVerdict::Broken);
        assert_eq!(judge("DINT#5"), CheckVerdict::Wrong);
        assert_eq!(value(None, "x", "INT", "INT#5").0, CheckVerdict::Broken);
    }
}
