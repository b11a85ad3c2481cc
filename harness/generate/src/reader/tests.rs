//! Tests that the reader reads what the writer writes.

use super::read;
use crate::evaluate::evaluate;
use crate::generator::{GeneratorSettings, program};
use crate::random::bytes;
use crate::writer::{Style, write};
use stickler_mdtest::check_examples;
use stickler_types::{Dialect, DialectName};

#[test]
fn what_is_written_is_read_back_as_the_same_program() {
    for (seed, dialect) in
        (0..40).flat_map(|seed| DialectName::ALL.iter().map(move |dialect| (seed, *dialect)))
    {
        let settings = GeneratorSettings {
            open: seed % 4 == 3,
            ..GeneratorSettings::of(dialect)
        };
        let made = program(&bytes(seed, 1500), &settings);
        let text = write(&made, &Style::default()).text;
        let read = read(&text, dialect).unwrap_or_else(|| panic!("not read:\n{text}"));
        assert_eq!(write(&read, &Style::default()).text, text);
        assert_eq!(evaluate(&read, 1), evaluate(&made, 1), "{text}");
    }
}

/// Returns what the writer makes of a statement that is read between these declarations.
fn statement(text: &str) -> Option<String> {
    let (before, after) = (
        "PROGRAM main\nVAR\n    i : INT;\n    d : DINT;\n    r : REAL;\n    w : WORD;\n    b : BOOL;\n    s : STRING;\n    \
         a : ARRAY[1..2] OF INT;\nEND_VAR\n    ",
        "\nEND_PROGRAM\n",
    );
    let read = read(&format!("{before}{text}{after}"), DialectName::IRONPLC_ED3)?;
    let written = write(&read, &Style::default()).text;
    Some(written.strip_prefix(before)?.strip_suffix(after)?.to_owned())
}

#[test]
fn golden_statements() {
    check_examples("tests/statements.md", |example| {
        statement(example.text("text")).unwrap_or_else(|| "none".to_owned())
    });
}

#[test]
fn the_standard_blocks_are_read_in_every_dialect() {
    for dialect in DialectName::ALL {
        let names: Vec<String> = { super::standard_blocks(dialect).into_iter() }
            .map(|block| block.name)
            .collect();
        let all = [
            "SR", "RS", "R_TRIG", "F_TRIG", "CTU", "CTD", "CTUD", "TP", "TON", "TOF",
        ];
        let counts_words = Dialect::of(dialect).set_and_reset_inputs;
        let all = all
            .into_iter()
            .filter(|name| !(counts_words && name.starts_with("CT")));
        assert!(names.iter().eq(all), "{dialect}: {names:?}");
    }
}
