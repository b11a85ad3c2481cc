//! The rows of `tests/literals`: a text, and what it stands for or where it goes wrong.
//!
//! The word behind the fence names the function that reads the text (`values`: a typed literal, written back in its canonical
//! spelling; `integer`, `date`, …: the number), or writes a number (`write-…`). A dash means that the text is none.

use std::fmt;
use stickler_mdtest::{Difference, same};
use stickler_types::boundaries::boundaries;
use stickler_types::literal::{self, LiteralError};
use stickler_types::{
    ClockSetting, ElementaryType, Question, Value, Versions, WrittenValue, counted, grouped, join,
};

#[test]
fn every_text_is_read_as_its_row_says() {
    stickler_mdtest::check(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/literals"), |block| {
        let Some(answer) = answers(block.kind()) else {
            return vec![Difference::new(1, "no test reads such a block")];
        };
        block.rows(|text, expected| same(answer(text), expected.to_owned()))
    });
}

fn answers(kind: &str) -> Option<fn(&str) -> String> {
    Some(match kind {
        "values" => |text| read(Value::parse(text)),
        "unsigned" => |text| read(literal::unsigned_integer(text)),
        "integer" => |text| read(literal::integer(text)),
        "real" => |text| real(text, ElementaryType::Real),
        "lreal" => |text| real(text, ElementaryType::Lreal),
        "duration" => |text| read(literal::duration(text)),
        "date" => |text| read(literal::date(text)),
        "time-of-day" => |text| read(literal::time_of_day(text)),
        "date-and-time" => |text| read(literal::date_and_time(text)),
        "text" => |text| match literal::text(text) {
            Ok(units) if units.is_empty() => "-".to_owned(),
            Ok(units) => join(units.iter().map(|unit| format!("{unit:X}")), " "),
            Err(error) => described(error),
        },
        "write-milliseconds" => |number| written(literal::write_milliseconds, number),
        "write-time-of-day" => |number| written(literal::write_time_of_day, number),
        "write-date-and-time" => |number| written(literal::write_date_and_time, number),
        "write-text" => |units| written_text(units, false),
        "write-wide-text" => |units| written_text(units, true),
        "questions" => |text| shown(text.parse::<Question>().ok()),
        "observed" => |text| shown(Value::parse_observed(text).ok()),
        "written" => |text| {
            WrittenValue::of(Value::parse(text).expect("a literal"))
                .literal
                .to_string()
        },
        "spelled" => spelled,
        "names" => |text| shown(ElementaryType::from_name(text)),
        "prefixes" => |text| shown(ElementaryType::from_literal_prefix(text)),
        "long-forms" => |text| shown(ty(text).long_form()),
        "ranges" => |text| {
            let range = ty(text).integer_range();
            shown(range.map(|(least, greatest)| format!("{least} to {greatest}")))
        },
        "boundaries" => |name| boundaries_of(ty(name)).join(" "),
        "has-boundaries" => |text| {
            let (name, literals) = text.split_once(' ').expect("a type and literals");
            let known = boundaries_of(ty(name));
            let mut literals = literals.split(' ');
            let all = literals.all(|literal| known.iter().any(|one| one == literal));
            if all { "yes" } else { "no" }.to_owned()
        },
        "near" => near,
        "versions" => versions,
        "clock" => |text| {
            let clock = ClockSetting::at(2, &Value::parse(text).expect("a literal"));
            shown(clock.map(|clock| clock.nanoseconds))
        },
        "grouped" => |number| grouped(number.parse().expect("a number")),
        "counted" => |number| counted(number.parse().expect("a number"), "case", "cases"),
        "wraps" => |text| {
            let (name, number) = text.split_once(' ').expect("a type and a number");
            ty(name)
                .integer_value(ty(name).wrap(number.parse().expect("a number")))
                .to_string()
        },
        _ => return None,
    })
}

fn ty(name: &str) -> ElementaryType {
    ElementaryType::from_name(name).expect("a type")
}

fn boundaries_of(ty: ElementaryType) -> Vec<String> {
    let values = boundaries(ty).into_iter();
    values.map(|value| value.literal.to_string()).collect()
}

/// Shows what was found; a dash stands for nothing.
fn shown<T: fmt::Display>(found: Option<T>) -> String {
    found.map_or_else(|| "-".to_owned(), |one| one.to_string())
}

fn read<T: fmt::Display>(result: Result<T, LiteralError>) -> String {
    result.map_or_else(described, |value| value.to_string())
}

/// The kind of an error, and the byte at which it is found.
fn described(error: LiteralError) -> String {
    let kind = match error {
        LiteralError::Malformed { .. } => "malformed",
        LiteralError::Overflow { .. } => "overflow",
        LiteralError::Escape { .. } => "escape",
        LiteralError::Character { .. } => "character",
    };
    format!("{kind} at {}", error.offset())
}

/// Reads a real number, and writes it in its canonical spelling.
fn real(text: &str, ty: ElementaryType) -> String {
    literal::real(text, ty).map_or_else(described, |raw| {
        let mut out = String::new();
        literal::write_real(&mut out, raw, ty).expect("a text takes everything");
        out
    })
}

fn written(write: fn(&mut String, i64) -> fmt::Result, number: &str) -> String {
    let mut out = String::new();
    write(&mut out, number.parse().expect("a number")).expect("a text takes everything");
    out
}

fn written_text(units: &str, wide: bool) -> String {
    let units: Vec<u16> = units
        .split(' ')
        .map(|unit| u16::from_str_radix(unit, 16).expect("a unit"))
        .collect();
    let mut out = String::new();
    literal::write_text(&mut out, &units, wide).expect("a text takes everything");
    out
}

/// Reads a literal of a type, as it stands in a program: `REAL 1.5`.
fn spelled(text: &str) -> String {
    let (ty, literal) = text.split_once(' ').expect("a type and a literal");
    let written = WrittenValue::parse(self::ty(ty), literal).ok();
    shown(written.map(|one| format!("{} | {}", one.literal, one.value)))
}

/// Says whether a value is near one that is expected, `REAL#1.0 within 1 | REAL#1.0000001`; a dash where none is near that.
fn near(text: &str) -> String {
    let (expected, given) = text.split_once(" | ").expect("two values");
    let Ok(expected) = Value::parse_expected(expected) else {
        return "-".to_owned();
    };
    assert_eq!(Value::parse_expected(&expected.to_string()), Ok(expected.clone()));
    let is_near = expected.admits(&Value::parse(given).expect("a literal"));
    if is_near { "yes" } else { "no" }.to_owned()
}

/// Says where a version lies that is compared with those from one on, `0.244 | 0.244.0`.
fn versions(text: &str) -> String {
    let (since, version) = text.split_once(" | ").expect("two versions");
    let versions = Versions {
        since: Some(since.to_owned()),
        until: None,
    };
    assert!(
        Versions::default().include(version),
        "all versions have {version}"
    );
    match (versions.include(version), versions.begin_after(version)) {
        (true, false) => "among them",
        (false, true) => "before them",
        _ => "neither",
    }
    .to_owned()
}
