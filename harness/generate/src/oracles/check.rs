//! Oracle `check`: the reference reports exactly one planted error, on its line, and its suggestion helps.

use super::{InputOutcome, Judged, OracleFailure};
use crate::generator::{GeneratorSettings, program};
use crate::model::Program;
use crate::plant::{Planted, plant};
use crate::writer::{Keywords, Style, write};
use stickler_types::{Diagnostic, DialectName, join};

/// The number of bytes that choose the style and the error; the others choose the program.
const OF_THE_ERROR: usize = 48;

/// Judges one input: its first bytes choose an error and its place, the others a sound program.
///
/// Without the error the program is accepted. With it there is exactly one diagnostic, of the planted code on the planted
/// line; where a conversion function is missing it suggests the call, and applying the suggestion makes the program valid.
///
/// # Errors
/// The first of these conditions that does not hold.
pub fn check(data: &[u8]) -> Judged {
    let Some(SoundProgram { sound, style, error }) = SoundProgram::of(data) else {
        return Ok(InputOutcome::Skipped("too short"));
    };
    match plant(&sound, error) {
        Some(planted) => judge(&sound, &planted, &style),
        None => Ok(InputOutcome::Skipped("no place for an error")),
    }
}

/// The decoded input of [`check`].
pub struct SoundProgram<'d> {
    /// The program without an error.
    pub sound: Program,
    /// The spelling of the program.
    pub style: Style,
    /// The bytes that choose the error and its place.
    pub error: &'d [u8],
}

impl<'d> SoundProgram<'d> {
    /// Decodes an input; `None` if it is too short.
    pub fn of(data: &'d [u8]) -> Option<SoundProgram<'d>> {
        let (of_the_error, of_the_program) = data.split_at_checked(OF_THE_ERROR)?;
        let (&of_the_style, error) = of_the_error.split_first()?;
        Some(SoundProgram {
            sound: program(of_the_program, &GeneratorSettings::default()),
            style: style(of_the_style),
            error,
        })
    }
}

/// Returns a spelling that cannot hide the error, as comments would in a program with an unclosed one.
fn style(choice: u8) -> Style {
    Style {
        keywords: [Keywords::Upper, Keywords::Lower, Keywords::Mixed, Keywords::Upper]
            [usize::from(choice & 3)],
        carriage_returns: choice & 4 != 0,
        seed: u64::from(choice),
        ..Style::default()
    }
}

/// Judges the reference on a sound program and on the same program with an error, both written with positional arguments.
///
/// # Errors
/// Fails as [`check`] does.
pub fn judge(sound: &Program, planted: &Planted, style: &Style) -> Judged {
    let without = write(sound, style);
    judge_sound_text(sound.dialect, &without.text)?;
    let with = write(&planted.program, style);
    let line = planted.line(&without, &with);
    judge_planted_text(planted, &with.text, line).map(|()| InputOutcome::Checked)
}

/// Judges the reference on the text of a sound program.
///
/// # Errors
/// The text is rejected.
pub fn judge_sound_text(dialect: DialectName, text: &str) -> Judged<()> {
    match stickler_reference::errors(text, dialect).first() {
        None => Ok(()),
        Some(said) => {
            let symptom = format!("rejected:{}", code_of(said));
            let message = format!("a sound program of {dialect} is rejected: {said}");
            Err(OracleFailure::new(symptom, message).of_program(text))
        }
    }
}

/// Judges the reference on a text of a program with an error on the given line.
///
/// # Errors
/// The error is not the only diagnostic, or its suggestion does not help.
pub fn judge_planted_text(planted: &Planted, text: &str, line: u32) -> Judged<()> {
    let dialect = planted.program.dialect;
    let said = stickler_reference::errors(text, dialect);
    let verdict =
        one_error(planted, line, &said).and_then(|said| suggestion_helps(planted, said, text, dialect));
    verdict.map_err(|(symptom, message)| {
        let (code, kind) = (planted.code, planted.kind);
        let message = format!("{message}\nplanted in a program of {dialect}: {kind}, {code} on line {line}");
        OracleFailure::new(symptom, message).of_program(text)
    })
}

/// A symptom and a message for a person.
type Wrong = (String, String);

/// Returns the planted diagnostic if it is the only one.
fn one_error<'d>(planted: &Planted, line: u32, said: &'d [Diagnostic]) -> Result<&'d Diagnostic, Wrong> {
    let code = planted.code;
    let Some(right) = said
        .iter()
        .find(|said| said.registered_code() == Some(code) && said.line == Some(line))
    else {
        return Err(match said {
            [] => (
                format!("not-rejected:{code}"),
                "the program is accepted".to_owned(),
            ),
            [first, ..] if first.registered_code() == Some(code) => {
                (format!("other-line:{code}"), listed(said))
            }
            [first, ..] => (format!("other-code:{code}:{}", code_of(first)), listed(said)),
        });
    };
    match said.iter().find(|other| !std::ptr::eq(*other, right)) {
        Some(other) => Err((format!("more:{code}:{}", code_of(other)), listed(said))),
        None => Ok(right),
    }
}

/// Checks that there is a suggestion where there must be, and that it makes the program valid.
fn suggestion_helps(
    planted: &Planted,
    said: &Diagnostic,
    text: &str,
    dialect: DialectName,
) -> Result<(), Wrong> {
    let code = planted.code;
    let Some(suggestion) = &said.suggestion else {
        return if planted.suggested {
            let symptom = format!("no-suggestion:{code}");
            Err((symptom, format!("no conversion is suggested: {said}")))
        } else {
            Ok(())
        };
    };
    let Some(apply_suggestion) = apply_suggestion(text, said, suggestion) else {
        let symptom = format!("span:{code}");
        return Err((symptom, format!("the span is not in the text: {said}")));
    };
    match stickler_reference::errors(&apply_suggestion, dialect).first() {
        None => Ok(()),
        Some(still) => {
            let symptom = format!("suggestion:{code}:{}", code_of(still));
            let message = format!("with `{suggestion}` in its place there is still {still}");
            Err((symptom, message))
        }
    }
}

/// Applies a suggestion to the text; `None` if the span of the diagnostic is not in the text.
fn apply_suggestion(text: &str, said: &Diagnostic, suggestion: &str) -> Option<String> {
    let start = offset(text, said.line?, said.column?)?;
    let end = offset(text, said.end_line?, said.end_column?)?;
    Some([text.get(..start)?, suggestion, text.get(end..)?].concat())
}

/// Returns the byte at a line and column, both counted from 1, columns in Unicode scalar values.
fn offset(text: &str, line: u32, column: u32) -> Option<usize> {
    let before = usize::try_from(line).ok()?.checked_sub(1)?;
    let mut lines = text.split_inclusive('\n');
    let start: usize = lines.by_ref().take(before).map(str::len).sum();
    let characters = usize::try_from(column).ok()?.checked_sub(1)?;
    let line = lines.next().unwrap_or_default();
    let ends = [line.len()];
    let mut offsets = line.char_indices().map(|(offset, _)| offset).chain(ends);
    offsets.nth(characters).map(|within| start + within)
}

fn listed(said: &[Diagnostic]) -> String {
    format!("the reference says {}", join(said, "; "))
}

/// The code of a diagnostic; empty where it has none.
fn code_of(said: &Diagnostic) -> &str {
    said.code.as_deref().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_types::Code;

    /// Returns a program and an error of a kind planted in it.
    fn planted(kind: &str) -> (Program, Planted) {
        let mut tries = (0..=u8::MAX).filter_map(|byte| {
            let bytes: Vec<u8> = (0..400u16)
                .map(|place| byte.wrapping_mul(29).wrapping_add(place.to_le_bytes()[0]))
                .collect();
            let sound = program(&bytes, &GeneratorSettings::default());
            let planted = crate::plant::plant_kind(&sound, kind, &bytes)?;
            Some((sound, planted))
        });
        tries
            .next()
            .expect("one of the programs has a place for the error")
    }

    const UNKNOWN: &str = "an unknown variable assigned";

    #[test]
    fn each_way_of_missing_an_error_has_its_symptom() {
        let (sound, planted) = planted(UNKNOWN);
        let symptom = |sound: &Program, change: &dyn Fn(&mut Planted)| {
            let mut changed = planted.clone();
            change(&mut changed);
            let judged = judge(sound, &changed, &Style::default());
            judged.err().map(|failure| failure.symptom)
        };
        let second = |planted: &mut Planted| {
            let again = crate::model::Statement::Raw("missing := 1;".to_owned());
            planted.program.main.body.push(again);
        };
        type Change<'c> = &'c dyn Fn(&mut Planted);
        let changes: [(Change<'_>, Option<&str>); 5] = [
            (&|_| {}, None),
            (
                &|planted| planted.program = sound.clone(),
                Some("not-rejected:P4007"),
            ),
            (
                &|planted| planted.code = Code::AssignmentTypeMismatch,
                Some("other-code:P4035:P4007"),
            ),
            (&second, Some("more:P4007:P4007")),
            (&|planted| planted.suggested = true, Some("no-suggestion:P4007")),
        ];
        for (change, expected) in changes {
            assert_eq!(symptom(&sound, change).as_deref(), expected);
        }
        assert_eq!(
            symptom(&planted.program, &|_| {}).as_deref(),
            Some("rejected:P4007")
        );
    }

    #[test]
    fn a_suggestion_that_does_not_help_is_told() {
        let (_, planted) = planted(UNKNOWN);
        let text = "PROGRAM main\r\n    missing := 1;\r\nEND_PROGRAM\r\n";
        let said = stickler_reference::errors(text, DialectName::MATIEC).remove(0);
        let with = |suggestion: &str| {
            let said = Diagnostic {
                suggestion: Some(suggestion.to_owned()),
                ..said.clone()
            };
            suggestion_helps(&planted, &said, text, DialectName::MATIEC)
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
        assert_eq!(check(&[0; 10]), Ok(InputOutcome::Skipped("too short")));
    }
}
