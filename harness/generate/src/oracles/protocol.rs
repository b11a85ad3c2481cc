//! Oracle `protocol`: every line that arrives over the wire is answered.

use super::{InputOutcome, Judged, OracleFailure, failed};
use serde_json::Value as Json;
use std::collections::BTreeMap;
use std::sync::LazyLock;
use stickler_engines::Reference;
use stickler_engines::protocol::{Reply, serve};
use stickler_types::{Diagnostic, Value};

/// The reference, limited to few steps for each run, because only the presence of an answer matters here.
static ENGINE: LazyLock<Reference> = LazyLock::new(|| Reference::with_step_limit(20_000));

/// Serves the reference over these bytes, and checks the answers to the lines.
///
/// 1. Each line that is not blank gets one reply, in order, until `bye` or the end.
/// 2. A reply is one line of JSON of the protocol's form, and repeats the id of a request that has one.
/// 3. A request is answered by a reply that fits it; each value that was asked for is there, in its canonical spelling.
/// 4. Diagnostics are sorted, and each has a known code, a message and a place in the program.
/// 5. Nothing makes the engine crash, or contradict itself.
///
/// Basis: harness/engines/README.md (the wire protocol).
///
/// # Errors
/// Symptoms: `io`, `replies`, `reply`, `id`, `kind`, `values`, `diagnostics`, `crash`, `internal-error`.
pub(super) fn judge(data: &[u8]) -> Judged {
    let mut output = Vec::new();
    serve(&*ENGINE, data, &mut output).map_err(|error| OracleFailure::new("io", error.to_string()))?;
    let lines = asked(data);
    let replies: Vec<&[u8]> = output.split_inclusive(|byte| *byte == b'\n').collect();
    check_count(&lines, replies.len())?;
    for (line, reply) in lines.iter().zip(replies) {
        check_reply(line, reply).map_err(|failure| {
            let [line, reply] = [line, reply].map(String::from_utf8_lossy);
            let message = format!("{}\n→ {line}\n← {reply}", failure.message);
            OracleFailure { message, ..failure }
        })?;
    }
    Ok(InputOutcome::Checked)
}

/// Returns the lines that are requests.
fn asked(data: &[u8]) -> Vec<&[u8]> {
    data.split(|byte| *byte == b'\n')
        .map(|line| line.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(line).trim_ascii())
        .filter(|line| !line.is_empty())
        .collect()
}

/// Checks that every line is answered up to the first that may say `bye`.
fn check_count(lines: &[&[u8]], replies: usize) -> Judged<()> {
    let says_bye = |line: &&[u8]| {
        // An escape may spell it in other bytes.
        line.windows(3).any(|word| word == b"bye") || line.contains(&b'\\')
    };
    let least = lines.iter().position(says_bye).unwrap_or(lines.len());
    if (least..=lines.len()).contains(&replies) {
        return Ok(());
    }
    let message = format!("{} lines ask something, and {replies} replies came", lines.len());
    failed("replies", message)
}

fn check_reply(line: &[u8], reply: &[u8]) -> Judged<()> {
    let read: Reply =
        serde_json::from_slice(reply).map_err(|error| OracleFailure::new("reply", error.to_string()))?;
    if !reply.ends_with(b"\n") {
        return failed("reply", "the reply does not end its line");
    }
    if let Reply::Error { message, .. } = &read {
        check_error(message)?;
    }
    let Ok(Json::Object(request)) = serde_json::from_slice::<Json>(line) else {
        return match read {
            // A number beyond the range of a JSON reader may still stand in a part that is not read.
            Reply::Error { .. } => Ok(()),
            _ => failed("kind", "no JSON object is answered by an error"),
        };
    };
    let id = request.get("id").and_then(Json::as_u64);
    let answers = |kinds: &[&str]| {
        if kinds.contains(&read.word()) {
            Ok(())
        } else {
            failed("kind", format!("a request is answered by `{}`", read.word()))
        }
    };
    let verb = request.get("type").and_then(Json::as_str);
    match verb {
        Some("hello") => answers(&["hello", "error"])?,
        Some("check") => answers(&["accepted", "rejected", "error"])?,
        Some("render") => answers(&["rendered", "rejected", "error"])?,
        Some("run") => answers(&["executed", "rejected", "faulted", "error"])?,
        _ => answers(&["error"])?,
    }
    // A greeting has no id; if there is one, it need not be read.
    let without = verb == Some("hello") && read.id().is_none();
    if read.id() != id && !without {
        return failed("id", format!("the request's id is {id:?}"));
    }
    match &read {
        Reply::Executed { values, .. } => check_values(&request, values, true),
        Reply::Faulted { values, .. } => check_values(&request, values, false),
        Reply::Rejected { diagnostics, .. } => check_diagnostics(&request, diagnostics),
        _ => Ok(()),
    }
}

/// Checks that an error is about a request, never about the engine itself.
fn check_error(message: &str) -> Judged<()> {
    if message.starts_with("the engine crashed: ") {
        return failed("crash", message);
    }
    if message.starts_with("defect of the reference: ") {
        return failed("internal-error", message);
    }
    Ok(())
}

/// Checks that exactly the requested values are there under their names, in their canonical spelling.
fn check_values(
    request: &serde_json::Map<String, Json>,
    values: &BTreeMap<String, String>,
    all: bool,
) -> Judged<()> {
    for (name, value) in values {
        let canonical = Value::parse(value).is_ok_and(|read| read.to_string() == *value);
        if !canonical {
            return failed(
                "values",
                format!("the value of {name} is {value}, which is not canonical"),
            );
        }
    }
    let asked = request
        .get("observe")
        .and_then(Json::as_array)
        .map_or(&[][..], Vec::as_slice);
    let names: Vec<String> = asked
        .iter()
        .filter_map(|asked| {
            let name = asked.get("name")?.as_str()?;
            Some(match asked.get("after").and_then(Json::as_u64) {
                Some(scan) => format!("{name}@{scan}"),
                None => name.to_owned(),
            })
        })
        .collect();
    let missing = names.iter().find(|name| all && !values.contains_key(*name));
    let surplus = values.keys().find(|name| !names.contains(name));
    match (missing, surplus) {
        (None, None) => Ok(()),
        (Some(name), _) => failed("values", format!("the value of {name} is missing")),
        (_, Some(name)) => failed("values", format!("nobody asked for {name}")),
    }
}

/// Checks that there are diagnostics, sorted, each with a code, a message and a place in the text.
fn check_diagnostics(request: &serde_json::Map<String, Json>, diagnostics: &[Diagnostic]) -> Judged<()> {
    let source = request.get("source").and_then(Json::as_str).unwrap_or_default();
    let lines = source.bytes().filter(|byte| *byte == b'\n').count() + 1;
    let sound = |said: &Diagnostic| {
        let (start, end) = ((said.line, said.column), (said.end_line, said.end_column));
        said.registered_code().is_some()
            && !said.message.is_empty()
            && start >= (Some(1), Some(1))
            && said.column >= Some(1)
            && end >= start
            && said.end_line <= u32::try_from(lines).ok()
    };
    let order = |said: &Diagnostic| (said.line, said.column, said.code.clone());
    if !diagnostics.is_empty() && diagnostics.iter().all(sound) && diagnostics.is_sorted_by_key(order) {
        return Ok(());
    }
    let message = "no diagnostic, or one without code, message or place, or out of order";
    failed("diagnostics", message)
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_mdtest::check_examples;

    #[test]
    fn a_conversation_holds() {
        assert_eq!(
            judge(include_bytes!("conversation.jsonl")),
            Ok(InputOutcome::Checked)
        );
        assert_eq!(judge(b"\xFF\n\xEF\xBB\xBF\n{}\r\n"), Ok(InputOutcome::Checked));
    }

    #[test]
    fn golden_replies() {
        check_examples("tests/replies.md", |example| {
            let judged = check_reply(
                example.text("request").as_bytes(),
                example.text("reply").as_bytes(),
            );
            judged.map_or_else(|failure| failure.symptom, |()| "none".to_owned())
        });
        assert!(check_count(&[b"a", b"b"], 1).is_err());
    }
}
