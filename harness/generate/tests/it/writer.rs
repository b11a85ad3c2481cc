//! Tests of the promises of the writer: every style of a program is accepted by its dialect, and the lines of raw text are
//! recorded.
use stickler_generate::generator::{GeneratorSettings, program};
use stickler_generate::model::{AssignmentTarget, Expression, ExpressionKind, Program, Statement};
use stickler_generate::writer::{Keywords, Style, write};
use stickler_types::{DialectName, Value};

fn made(dialect: DialectName, seed: u8) -> Program {
    let bytes: Vec<u8> = (0..1500_u32)
        .map(|place| (place.wrapping_mul(2_654_435_761) >> 13) as u8 ^ seed)
        .collect();
    let settings = GeneratorSettings::of(dialect);
    program(&bytes, &settings)
}

/// Returns the canonical style with a change.
fn with(change: impl FnOnce(&mut Style)) -> Style {
    let mut style = Style::default();
    change(&mut style);
    style
}

/// Each thing that a style can change, alone.
fn styles(dialect: DialectName) -> Vec<Style> {
    let changes: [fn(&mut Style); 8] = [
        |style| style.keywords = Keywords::Lower,
        |style| (style.keywords, style.seed) = (Keywords::Mixed, 7),
        |style| (style.comments, style.seed) = (true, 3),
        |style| (style.comments, style.carriage_returns, style.seed) = (true, true, 4),
        |style| style.varied_notation = true,
        |style| (style.varied_notation, style.seed) = (true, 1),
        |style| style.explicit_conversions = true,
        |style| style.named_arguments = true,
    ];
    let mut styles = changes.map(with).to_vec();
    if matches!(dialect, DialectName::IRONPLC_ED3 | DialectName::IRONPLC_RUSTY) {
        styles.push(with(|style| style.percent_bits = true));
    }
    styles
}

/// Returns the values that the reference gives for a text of this program.
fn run(program: &Program, text: &str) -> Result<Vec<(String, Value)>, String> {
    let observed = program.observed();
    let names: Vec<_> = observed
        .iter()
        .map(|(name, _)| stickler_types::Observation::last(name, ""))
        .collect();
    let outcome = stickler_reference::run(
        &stickler_types::RunRequest::once(program.dialect, text, &names),
        stickler_reference::Limits::default(),
    );
    match outcome {
        Ok(stickler_types::Outcome::Executed { values, .. }) => Ok(values),
        other => Err(format!("{other:?}\n{text}")),
    }
}

#[test]
fn every_style_is_accepted_and_means_the_same() {
    for &dialect in DialectName::ALL.iter() {
        for seed in 0..12 {
            let program = made(dialect, seed * 19);
            let canonical = run(&program, &write(&program, &Style::default()).text);
            assert!(canonical.is_ok(), "{dialect}: {canonical:?}");
            for style in styles(dialect) {
                let text = write(&program, &style).text;
                assert_eq!(run(&program, &text), canonical, "{dialect}, {style:?}:\n{text}");
            }
        }
    }
}

#[test]
fn a_style_changes_the_text() {
    let program = made(DialectName::IRONPLC_RUSTY, 5);
    let canonical = write(&program, &Style::default()).text;
    let written = |change: fn(&mut Style)| write(&program, &with(change)).text;
    let lower = written(|style| style.keywords = Keywords::Lower);
    assert_ne!(canonical, lower);
    assert!(canonical.eq_ignore_ascii_case(&lower));
    let ends = written(|style| style.carriage_returns = true);
    assert_eq!(ends.replace("\r\n", "\n"), canonical);
    assert!(written(|style| style.comments = true).contains("(*"));
}

#[test]
fn the_lines_of_raw_text_are_remembered() {
    let mut program = made(DialectName::IRONPLC_ED3, 1);
    let broken = Statement::Raw("rubbish\n    ;".to_owned());
    let target = program.main.body.iter().find_map(|statement| match statement {
        Statement::Assign(AssignmentTarget::Place(place), _) => Some(place.clone()),
        _ => None,
    });
    let target = target.expect("every program assigns something");
    let value = Expression::new(target.ty.clone(), ExpressionKind::Raw("nonsense".to_owned()));
    let assigned = Statement::Assign(AssignmentTarget::Place(target), value);
    program.main.body.extend([broken, assigned]);
    let other = with(|style| (style.comments, style.carriage_returns) = (true, true));
    for style in [Style::default(), other] {
        let written = write(&program, &style);
        let line_of = |part: &str| {
            written
                .text
                .lines()
                .position(|line| line.contains(part))
                .map(|line| line as u32 + 1)
        };
        let expected = [line_of("rubbish"), line_of("nonsense")].map(|line| line.expect("it is in the text"));
        assert_eq!(written.raw_lines, expected);
    }
}

#[test]
fn every_observed_path_can_be_observed() {
    for &dialect in DialectName::ALL.iter() {
        for seed in 0..12 {
            let program = made(dialect, seed * 21);
            let text = write(&program, &Style::default()).text;
            let values = run(&program, &text).expect("it runs");
            let observed = program.observed();
            assert_eq!(observed.len(), values.len());
            for ((name, ty), (_, value)) in observed.iter().zip(&values) {
                assert_eq!(value.type_name(), ty.name(), "{name}");
            }
        }
    }
}
