//! The oracle can fail.

use super::*;
use stickler_types::Code;

/// Bytes, and what they plant in which program.
fn planted(kind: &str) -> (Program, Planted) {
    let mut tries = (0..=u8::MAX).filter_map(|byte| {
        let bytes: Vec<u8> = (0..400u16)
            .map(|place| byte.wrapping_mul(29).wrapping_add(place.to_le_bytes()[0]))
            .collect();
        let sound = program(&mut Unstructured::new(&bytes), &GeneratorSettings::default());
        let planted = crate::plant::plant_kind(&sound, kind, &mut Unstructured::new(&bytes))?;
        Some((sound, planted))
    });
    tries
        .next()
        .expect("one of the programs has a place for the error")
}

fn symptom(sound: &Program, planted: &Planted) -> Option<String> {
    judge(sound, planted, &Style::default())
        .err()
        .map(|failure| failure.symptom)
}

const UNKNOWN: &str = "an unknown variable assigned";

#[test]
fn an_error_that_is_found_is_well() {
    let (sound, planted) = planted(UNKNOWN);
    assert_eq!(symptom(&sound, &planted), None);
}

#[test]
fn an_error_that_is_not_found_is_told() {
    let (sound, mut planted) = planted(UNKNOWN);
    planted.program = sound.clone();
    assert_eq!(symptom(&sound, &planted).as_deref(), Some("not-rejected:P4007"));
}

#[test]
fn another_code_is_told() {
    let (sound, mut planted) = planted(UNKNOWN);
    planted.code = Code::AssignmentTypeMismatch;
    assert_eq!(
        symptom(&sound, &planted).as_deref(),
        Some("other-code:P4035:P4007")
    );
}

#[test]
fn a_second_diagnostic_is_told() {
    let (sound, mut planted) = planted(UNKNOWN);
    let again = crate::model::StatementKind::Raw("missing := 1;".to_owned());
    planted
        .program
        .main
        .body
        .push(crate::model::Statement { kind: again });
    assert_eq!(symptom(&sound, &planted).as_deref(), Some("more:P4007:P4007"));
}

#[test]
fn a_sound_program_that_is_rejected_is_told() {
    let (_, planted) = planted(UNKNOWN);
    assert_eq!(
        symptom(&planted.program, &planted).as_deref(),
        Some("rejected:P4007")
    );
}

#[test]
fn a_suggestion_that_is_wanted_is_missed() {
    let (sound, mut planted) = planted(UNKNOWN);
    planted.suggested = true;
    assert_eq!(symptom(&sound, &planted).as_deref(), Some("no-suggestion:P4007"));
}

#[test]
fn a_suggestion_that_does_not_help_is_told() {
    let (_, planted) = planted(UNKNOWN);
    let text = "PROGRAM main\r\n    missing := 1;\r\nEND_PROGRAM\r\n";
    let said = stickler_reference::check(text, DialectName::Matiec).remove(0);
    let with = |suggestion: &str| {
        let said = LocatedDiagnostic {
            suggestion: Some(suggestion.to_owned()),
            ..said.clone()
        };
        suggestion_helps(&planted, &said, text, DialectName::Matiec)
            .err()
            .map(|(symptom, _)| symptom)
    };
    assert_eq!(with("gone").as_deref(), Some("suggestion:P4007:P4007"));
    assert_eq!(with("(*").as_deref(), Some("suggestion:P4007:P0001"));
}

#[test]
fn places_count_characters_and_any_end_of_a_line() {
    let text = "é := 1;\r\nab\n";
    assert_eq!(offset(text, 1, 1), Some(0));
    assert_eq!(offset(text, 1, 2), Some(2));
    assert_eq!(offset(text, 2, 2), Some(text.find('b').expect("it is there")));
    assert_eq!(offset(text, 3, 1), Some(text.len()));
    assert_eq!(offset(text, 1, 100), None);
    assert_eq!(offset(text, 0, 1), None);
}

#[test]
fn a_short_input_is_passed_over() {
    assert_eq!(check(&[0; 10]), Ok(Tried::PassedOver("too short")));
}
