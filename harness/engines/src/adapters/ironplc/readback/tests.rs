//! Tests of `readback.rs`.

use super::characters::{escaped, plain};
use super::*;
use std::fmt::Write;
use stickler_types::DialectName;

const SOURCE: &str = "TYPE COLOR : (RED, GREEN); END_TYPE PROGRAM main END_PROGRAM";

fn observation(name: &str, type_name: &str) -> Observation {
    Observation::last(name, type_name)
}

fn request(observe: &[Observation]) -> RunRequest<'_> {
    RunRequest::once(DialectName::IRONPLC_ED2, SOURCE, observe)
}

fn seen(readbacks: &Readbacks, asked: &Observation, dump: &str) -> String {
    match readbacks.value(asked, &Dump::read(dump)) {
        Ok(value) => value.to_string(),
        Err(ReadbackError::Unsupported(reason)) => reason,
        Err(ReadbackError::Failed(reason)) => format!("failed: {reason}"),
        Err(ReadbackError::Retry(_)) => "again".to_owned(),
    }
}

/// Returns what the dump shows of a text of these characters, for a compiler that does or does not know escapes.
fn dumped(readbacks: &Readbacks, text: &[u8], knows_escapes: bool) -> String {
    let ty = ElementaryType::String;
    let literal = escaped_literal(ty);
    let others: Vec<u8> = match knows_escapes {
        true => escaped(ty).collect(),
        false => literal.trim_matches('\'').bytes().collect(),
    };
    let find = |all: Vec<u8>, at: usize| {
        let sought = text.get(at);
        sought
            .and_then(|sought| all.iter().position(|other| other == sought))
            .map_or(0, |at| at + 1)
    };
    let mut dump = String::new();
    let mut at = 0;
    for probe in readbacks.probes() {
        let shown = match &probe.expression {
            length if length.starts_with("LEN") => text.len(),
            first if first.starts_with("FIND(stickler_probe_0,") => find(plain(ty).collect(), at),
            second if second.starts_with("FIND(stickler_probe_1,") => {
                at += 1;
                find(others.clone(), at - 1)
            }
            _ => continue,
        };
        writeln!(dump, "{}: {shown}", probe.name).unwrap();
    }
    dump
}

#[test]
fn a_text_is_spelled_from_the_places_of_its_characters() {
    let observe = [observation("s", "STRING")];
    let readbacks = Readbacks::of(&request(&observe), RunHints::default());
    let names: BTreeSet<&str> = readbacks.probes().iter().map(|probe| &*probe.name).collect();
    // Two alphabets, the character that is sought, the length, and two places a character.
    assert_eq!(names.len(), 4 + 2 * INITIAL_CHARACTERS);
    for knows_escapes in [true, false] {
        let dump = dumped(&readbacks, b"a~$41 \"", knows_escapes);
        assert_eq!(seen(&readbacks, &observe[0], &dump), "STRING#'a~$$41 \"'");
    }
    let dump = dumped(&readbacks, b"\n'", true);
    assert_eq!(seen(&readbacks, &observe[0], &dump), "STRING#'$0A$''");
    let dump = dumped(&readbacks, b"\xE9", true);
    assert_eq!(
        seen(&readbacks, &observe[0], &dump),
        "s holds a character that is not seen"
    );
    let dump = dumped(&readbacks, &[b'x'; 40], true);
    let Err(ReadbackError::Retry(hints)) = readbacks.value(&observe[0], &Dump::read(&dump)) else {
        panic!("no second look")
    };
    let long = Readbacks::of(&request(&observe), hints);
    let dump = dumped(&long, &[b'x'; 40], true);
    assert_eq!(
        seen(&long, &observe[0], &dump),
        format!("STRING#'{}'", "x".repeat(40))
    );
}

#[test]
fn nothing_is_asked_of_calls_that_do_not_work() {
    let observe = [observation("s", "STRING"), observation("w", "WSTRING")];
    let hints = RunHints::without(BTreeMap::from([(ElementaryType::Wstring, "no".to_owned())]));
    let readbacks = Readbacks::of(&request(&observe), hints);
    assert_eq!(seen(&readbacks, &observe[1], ""), "no");
    assert!(
        !readbacks
            .probes()
            .iter()
            .any(|probe| probe.expression.contains("(w"))
    );
}
