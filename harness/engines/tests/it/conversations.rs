//! Tests the wire protocol by conversations: those of `tests/conversations/*.md` and of the README, and texts that are no lines.

use crate::fixture::block;
use serde_json::{Value as Json, json};
use std::path::Path;
use stickler_engines::protocol::serve;
use stickler_engines::{Ability, ClosureEngine, Engine, Grade, Identity, Outcome, Reference, RunRequest};
use stickler_mdtest::{fits, sections};
use stickler_types::{DialectName, Fault, Value};

/// Returns an engine that answers with the request it got, and otherwise where the source says so.
fn parrot() -> ClosureEngine<'static> {
    let mut engine = ClosureEngine::new("parrot", |_, request| repeat(request));
    engine.identity = Identity {
        name: "parrot".to_owned(),
        version: "7".to_owned(),
        dialects: vec![DialectName::MATIEC],
        abilities: vec![Ability::Execute],
        grade: Grade::Line,
        lacks: Vec::new(),
    };
    engine.render = Some(Box::new(|_, source| Outcome::Rendered {
        text: source.to_owned(),
    }));
    engine
}

fn repeat(request: &RunRequest<'_>) -> Outcome {
    let text = |text: String| Value::parse(&format!("STRING#'{text}'")).unwrap();
    let clock = request.clock.iter();
    let clock = clock.map(|step| format!("{}:{}ns", step.before, step.nanoseconds));
    let set = request.set.iter();
    let set = set.map(|set| format!("{}:{}={}", set.before, set.name, set.value));
    let settings: Vec<String> = clock.chain(set).collect();
    let observed = request.observe.iter();
    let observed = observed.map(|asked| (asked.key().to_string(), text(asked.type_name.to_string())));
    let scans = (format!("scans {}", request.scans), text(settings.join(" ")));
    let values = [scans].into_iter().chain(observed).collect();
    let reason = format!("{} {}", request.dialect, request.source);
    match request.source {
        "panic" => panic!("no more seeds"),
        "x" => Outcome::Unsupported { reason },
        "later" => Outcome::NotImplemented { reason },
        "fault" => Outcome::Faulted {
            fault: Fault::SubscriptRange,
            line: None,
            values,
            warnings: Vec::new(),
        },
        _ => Outcome::executed(values),
    }
}

/// Returns the replies of an engine.
fn talk(engine: &dyn Engine, input: &[u8]) -> Vec<Json> {
    let mut output = Vec::new();
    serve(engine, input, &mut output).unwrap();
    let text = String::from_utf8(output).unwrap();
    assert!(text.is_empty() || text.ends_with('\n'));
    text.lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect()
}

/// Tells whether a reply is as expected: each `…` in a text stands for anything, and a reply may have further keys where `open`.
fn is(expected: &Json, reply: &Json, open: bool) -> bool {
    match (expected, reply) {
        (Json::String(expected), Json::String(text)) => fits(expected, text),
        (Json::Object(expected), Json::Object(found)) => {
            let as_expected = |(key, value)| found.get(key).is_some_and(|found| is(value, found, open));
            (open || expected.len() == found.len()) && expected.iter().all(as_expected)
        }
        (Json::Array(expected), Json::Array(found)) => {
            expected.len() == found.len()
                && expected
                    .iter()
                    .zip(found)
                    .all(|(one, other)| is(one, other, open))
        }
        _ => expected == reply,
    }
}

/// Holds a conversation, whose requests have this program where they have none. Returns what does not come back as expected.
fn differences(engine: &dyn Engine, conversation: &str, source: Option<&str>) -> Vec<String> {
    let mut input = String::new();
    for line in conversation.lines().filter_map(|line| line.strip_prefix("→ ")) {
        let mut request: Json = serde_json::from_str(line).unwrap();
        match (request.get("source"), source) {
            (None, Some(source)) if request.get("dialect").is_some() => request["source"] = source.into(),
            _ => {}
        }
        input.push_str(&if source.is_some() {
            request.to_string()
        } else {
            line.to_owned()
        });
        input.push('\n');
    }
    let expected: Vec<&str> = conversation
        .lines()
        .filter_map(|line| line.strip_prefix("← "))
        .collect();
    let replies = talk(engine, input.as_bytes());
    assert_eq!(replies.len(), expected.len(), "{conversation}\n{replies:?}");
    let pairs = expected.into_iter().zip(replies);
    let different = pairs.filter(|(line, reply)| {
        let (json, open) = line
            .strip_suffix(" …")
            .map_or((*line, false), |json| (json, true));
        !is(&serde_json::from_str(json).unwrap(), reply, open)
    });
    different
        .map(|(line, reply)| format!("← {line}\ngives\n← {reply}"))
        .collect()
}

/// Holds the conversations of a file.
fn converse(engine: &dyn Engine, file: &str) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/conversations");
    let text = std::fs::read_to_string(folder.join(file)).unwrap();
    let mut failures = Vec::new();
    for test in &sections(&text).unwrap()[1..] {
        let source = block(test, "st");
        let differences = differences(engine, &block(test, "json").unwrap(), source.as_deref());
        failures.extend(
            differences
                .iter()
                .map(|difference| format!("{file}: {}\n{difference}", test.heading)),
        );
    }
    assert!(failures.is_empty(), "\n{}", failures.join("\n"));
}

#[test]
fn conversations_with_the_server() {
    converse(&parrot(), "server.md");
}

#[test]
fn conversations_with_the_reference() {
    converse(&Reference::new(), "reference.md");
}

#[test]
fn the_conversation_in_the_readme_is_what_the_reference_says() {
    let readme = include_str!("../../README.md");
    assert_eq!(readme.matches("\n← ").count(), 6);
    assert_eq!(differences(&Reference::new(), readme, None), [""; 0]);
}

#[test]
fn blank_lines_carriage_returns_and_a_byte_order_mark_are_passed_over() {
    let replies = talk(
        &parrot(),
        b"\xEF\xBB\xBF{\"type\":\"hello\",\"protocol\":1}\r\n\r\n  \n\t\r\n",
    );
    assert_eq!(replies.len(), 1);
    assert_eq!(replies[0]["type"], "hello");
}

#[test]
fn a_malformed_line_is_an_error_and_the_next_is_answered() {
    let mut input = Vec::new();
    let bad: [&[u8]; 9] = [
        b"{",
        b"[]",
        b"null",
        b"hello",
        b"{\"type\":\"run\"",
        b"\xFF\xFE",
        b"{\"type\":\"hello\xFF\",\"protocol\":1}",
        b"\0",
        &[b'['; 100_000],
    ];
    for line in bad {
        input.extend_from_slice(line);
        input.extend_from_slice(b"\n{\"type\":\"hello\",\"protocol\":1}\n");
    }
    let types: Vec<Json> = talk(&parrot(), &input)
        .into_iter()
        .map(|reply| reply["type"].clone())
        .collect();
    assert_eq!(types, ["error", "hello"].repeat(bad.len()));
}

#[test]
fn any_text_as_a_program_is_answered_by_a_reply_with_its_id() {
    let sources = [
        String::new(),
        "\u{0}\u{FEFF}\u{FFFD}é".to_owned(),
        "(*".repeat(1000),
        "PROGRAM main\nVAR x : INT; END_VAR\nx := ".to_owned() + &"(".repeat(20_000),
        "'".to_owned() + &"x".repeat(100_000),
        "PROGRAM PROGRAM PROGRAM ; ; END_IF END_VAR".to_owned(),
    ];
    for source in &sources {
        for verb in ["run", "check", "render"] {
            let request = json!({"type":verb,"id":11,"dialect":"ironplc-rusty","source":source});
            let reply = &talk(&Reference::new(), request.to_string().as_bytes())[0];
            assert_eq!(reply["id"], 11, "{reply}");
            assert_ne!(reply["type"], "error", "{reply}");
        }
    }
}
