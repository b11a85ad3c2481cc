//! Tests the server of the wire protocol over an engine that executes nothing.

use serde_json::{Value as Json, json};
use stickler_engines::protocol::serve;
use stickler_engines::{Ability, Engine, EngineError, Grade, Identity, Outcome, RunRequest, Session};
use stickler_types::{DialectName, Fault, Value};

/// An engine that answers with the request it got, and panics where the source says so.
struct Parrot {
    identity: Identity,
}

struct Perch;

impl Engine for Parrot {
    fn identity(&self) -> &Identity {
        &self.identity
    }

    fn session(&self) -> Result<Box<dyn Session + '_>, EngineError> {
        Ok(Box::new(Perch))
    }
}

impl Session for Perch {
    fn run(&mut self, request: &RunRequest<'_>) -> Outcome {
        if request.source == "panic" {
            panic!("no more seeds");
        }
        let text = |text: String| Value::parse(&format!("STRING#'{text}'")).unwrap();
        let clock = request
            .clock
            .iter()
            .map(|step| format!("{}:{}ns", step.before, step.nanoseconds));
        let set = request
            .set
            .iter()
            .map(|set| format!("{}:{}={}", set.before, set.name, set.value));
        let reported: Vec<String> = clock.chain(set).collect();
        let mut values = vec![(format!("scans {}", request.scans), text(reported.join(" ")))];
        values.extend(
            request
                .observe
                .iter()
                .map(|asked| (asked.key().to_string(), text(asked.type_name.to_string()))),
        );
        match request.source {
            "fault" => Outcome::Faulted {
                fault: Fault::SubscriptRange,
                line: None,
                values,
                warnings: Vec::new(),
            },
            _ => Outcome::executed(values),
        }
    }

    fn check(&mut self, dialect: DialectName, source: &str) -> Outcome {
        let reason = format!("{dialect} {source}");
        match source {
            "later" => Outcome::NotImplemented { reason },
            _ => Outcome::Unsupported { reason },
        }
    }

    fn render(&mut self, _: DialectName, source: &str) -> Outcome {
        Outcome::Rendered {
            text: source.to_owned(),
        }
    }
}

fn talk_bytes(input: &[u8]) -> Vec<Json> {
    let identity = Identity {
        name: "parrot".to_owned(),
        version: "7".to_owned(),
        dialects: vec![DialectName::MATIEC],
        abilities: vec![Ability::Execute],
        grade: Grade::Line,
        lacks: Vec::new(),
    };
    let mut output = Vec::new();
    serve(&Parrot { identity }, input, &mut output).unwrap();
    let text = String::from_utf8(output).unwrap();
    assert!(text.is_empty() || text.ends_with('\n'));
    text.lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect()
}

fn talk(lines: &[Json]) -> Vec<Json> {
    let text: String = lines.iter().map(|line| format!("{line}\n")).collect();
    talk_bytes(text.as_bytes())
}

/// Returns the `id` and the message of the only reply, which must be an error.
fn complaint(input: &[u8]) -> (Option<u64>, String) {
    let replies = talk_bytes(input);
    assert_eq!(replies.len(), 1, "{replies:?}");
    assert_eq!(replies[0]["type"], "error");
    (
        replies[0].get("id").and_then(Json::as_u64),
        replies[0]["message"].as_str().unwrap().to_owned(),
    )
}

#[test]
fn hello_is_answered_by_the_identity() {
    let replies = talk(&[json!({"type":"hello","protocol":1,"from":"a later caller"})]);
    let expected = json!({"type":"hello","protocol":1,"name":"parrot","version":"7","dialects":["matiec"],
        "abilities":["execute"],"grade":"line"});
    assert_eq!(replies, [expected]);
}

#[test]
fn hello_of_another_protocol_is_told_which_one_is_spoken() {
    let (_, message) = complaint(br#"{"type":"hello","protocol":2}"#);
    assert_eq!(
        message,
        "protocol 2 is not spoken here; this engine speaks protocol 1"
    );
}

#[test]
fn requests_are_answered_in_order_until_bye_and_need_no_hello() {
    let check = |id: u64| json!({"type":"check","id":id,"dialect":"matiec","source":"x"});
    let replies = talk(&[check(9), check(3), json!({"type":"bye"}), check(4)]);
    let expected = |id: u64| json!({"type":"unsupported","id":id,"reason":"matiec x"});
    assert_eq!(replies, [expected(9), expected(3)]);
}

#[test]
fn a_construct_that_is_not_implemented_is_unsupported_with_a_key_of_its_own() {
    let check = json!({"type":"check","id":1,"dialect":"matiec","source":"later"});
    let expected = json!({"type":"unsupported","id":1,"reason":"matiec later","not_implemented":true});
    assert_eq!(talk(&[check]), [expected]);
}

#[test]
fn a_run_carries_scans_clock_settings_and_observations() {
    let replies = talk(&[
        json!({"type":"run","id":1,"dialect":"matiec","source":"","scans":3,
        "clock":[{"before":2,"value":"TIME#1.5ms"}], "set":[{"before":3,"name":"in","value":"BOOL#TRUE"}],
        "observe":[{"name":"q","type":"BOOL","after":3},{"name":"a[1]","type":"INT"},{"name":"n"}]}),
    ]);
    let expected = json!({"type":"executed","id":1,"values":{
        "scans 3":"STRING#'2:1500000ns 3:in=BOOL#TRUE'", "q@3":"STRING#'BOOL'", "a[1]":"STRING#'INT'",
        "n":"STRING#''"}});
    assert_eq!(replies, [expected]);
}

#[test]
fn a_run_that_says_no_more_than_it_must_is_one_scan() {
    let replies = talk(&[json!({"type":"run","id":1,"dialect":"plcnext","source":"fault"})]);
    let expected =
        json!({"type":"faulted","id":1,"fault":"subscript-range","values":{"scans 1":"STRING#''"}});
    assert_eq!(replies, [expected]);
}

#[test]
fn blank_lines_carriage_returns_and_a_byte_order_mark_are_passed_over() {
    let replies = talk_bytes(b"\xEF\xBB\xBF{\"type\":\"hello\",\"protocol\":1}\r\n\r\n  \n\t\r\n");
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
    let types: Vec<Json> = talk_bytes(&input)
        .into_iter()
        .map(|reply| reply["type"].clone())
        .collect();
    assert_eq!(types, ["error", "hello"].repeat(bad.len()));
}

#[test]
fn an_error_repeats_the_id_and_names_what_is_wrong() {
    let reported = |input: &str, id: Option<u64>, part: &str| {
        let (found, message) = complaint(input.as_bytes());
        assert_eq!(found, id, "{input}");
        assert!(message.contains(part), "{input}: {message}");
    };
    reported(
        r#"{"type":"run","id":5,"dialect":"matiec"}"#,
        Some(5),
        "missing field `source`",
    );
    reported(
        r#"{"type":"check","id":5,"source":""}"#,
        Some(5),
        "missing field `dialect`",
    );
    reported(
        r#"{"type":"check","dialect":"matiec","source":""}"#,
        None,
        "missing field `id`",
    );
    reported(
        r#"{"type":"check","id":-1,"dialect":"matiec","source":""}"#,
        None,
        "-1",
    );
    reported(
        r#"{"type":"check","id":"a","dialect":"matiec","source":""}"#,
        None,
        "\"a\"",
    );
    reported(
        r#"{"type":"check","id":18446744073709551616,"dialect":"matiec","source":""}"#,
        None,
        "u64",
    );
    reported(
        r#"{"type":"eval","id":6}"#,
        Some(6),
        "unknown variant `eval`, expected one of `hello`, `run`",
    );
    reported(r#"{"id":7}"#, Some(7), "missing field `type`");
    reported(
        r#"{"type":"check","id":8,"dialect":"melsec","source":""}"#,
        Some(8),
        "unknown dialect `melsec`",
    );
    reported(
        r#"{"type":"check","id":9,"dialect":"matiec","source":5}"#,
        Some(9),
        "expected a string",
    );
}

#[test]
fn a_run_that_asks_for_what_cannot_be_is_an_error_of_that_request() {
    let reported = |extra: &str, expected: &str| {
        let line =
            format!(r#"{{"type":"run","id":2,"dialect":"matiec","source":"","scans":2,{extra}}}"#) + "\n";
        assert_eq!(
            complaint(line.as_bytes()),
            (Some(2), expected.to_owned()),
            "{extra}"
        );
    };
    reported(
        r#""observe":[{"name":"q","after":3}]"#,
        "observe q: there is no scan 3 among 2 (the first is scan 1)",
    );
    reported(
        r#""set":[{"before":0,"name":"q","value":"INT#1"}]"#,
        "set q: there is no scan 0 among 2 (the first is scan 1)",
    );
    reported(
        r#""clock":[{"before":3,"value":"TIME#1s"}]"#,
        "clock: there is no scan 3 among 2 (the first is scan 1)",
    );
    reported(
        r#""clock":[{"before":1,"value":"INT#1"}]"#,
        "clock: INT#1 is neither TIME nor LTIME",
    );
}

#[test]
fn a_bad_literal_is_an_error_that_repeats_it() {
    for (extra, part) in [
        (
            r#""set":[{"before":1,"name":"q","value":"INT#x"}]"#,
            "set q: INT#x: ",
        ),
        (
            r#""set":[{"before":1,"name":"q","value":"INT#99999"}]"#,
            "set q: INT#99999: ",
        ),
        (r#""clock":[{"before":1,"value":"soon"}]"#, "clock: soon: "),
    ] {
        let line = format!(r#"{{"type":"run","id":2,"dialect":"matiec","source":"",{extra}}}"#);
        let (id, message) = complaint(line.as_bytes());
        assert_eq!(id, Some(2));
        assert!(message.starts_with(part), "{message}");
    }
}

#[test]
fn a_panic_of_the_engine_is_an_error_and_the_engine_lives_on() {
    let run = |id: u64, source: &str| json!({"type":"run","id":id,"dialect":"matiec","source":source});
    let replies = talk(&[run(1, "panic"), run(2, "")]);
    let message = "the engine crashed: panicked: no more seeds";
    assert_eq!(replies[0], json!({"type":"error","id":1,"message":message}));
    assert_eq!(replies[1]["type"], "executed");
}
