//! Drivers for a person: short C and C++ programs that run one translated program and print its observed values by name.
//!
//! An adapter's own [driver](super::driver) prints the bits of values, for any number of programs at a time. A reproduction has
//! the same calls in the same order, and prints what a person reads.

use super::printed::PrintedKind;
use crate::Observation;
use std::fmt::Write;
use stickler_types::ElementaryType;

/// The C or C++ expression for an observed value.
pub(super) enum ReadableExpression {
    /// A number.
    Number(String),
    /// A structure of seconds and nanoseconds.
    Timespec(String),
    /// A number of nanoseconds.
    Nanoseconds(String),
    /// A number of days.
    Days(String),
    /// A text: the condition under which it has a unit `at`, and that unit.
    Text { condition: String, unit: String },
}

/// The functions that print texts; only where a statement calls them.
const PRINT_CHARACTER: &str = include_str!("readable/print_character.c");

/// The function that prints dates and times of day; only where a statement calls it. The numbers behind the date keep apart what
/// the date shows alike.
const PRINT_DATE: &str = include_str!("readable/print_date.c");

/// Returns the functions that statements call.
pub(super) fn functions(statements: &str) -> String {
    let mut text = String::new();
    if statements.contains("print_character(") {
        text.push_str(PRINT_CHARACTER);
    }
    if statements.contains("print_date(") {
        text.push_str(PRINT_DATE);
    }
    text
}

/// Returns the statement that prints an observed value.
pub(super) fn statement(asked: &Observation, kind: &PrintedKind<'_>, value: &ReadableExpression) -> String {
    let name = asked.key().to_string().replace('\\', "\\\\").replace('"', "\\\"");
    let format = name.replace('%', "%%");
    match (kind, value) {
        (_, ReadableExpression::Text { condition, unit }) => format!(
            "printf(\"{format} = '\"); for (unsigned at = 0; {condition}; at++) print_character({unit}); printf(\"'\\n\");"
        ),
        (PrintedKind::Elementary(ty), ReadableExpression::Timespec(value)) if ty.is_duration() => format!(
            "printf(\"{format} = %lld s + %lld ns\\n\", (long long){value}.tv_sec, (long long){value}.tv_nsec);"
        ),
        (PrintedKind::Elementary(ty), ReadableExpression::Nanoseconds(value)) if ty.is_duration() => {
            format!("printf(\"{format} = %lld ns\\n\", (long long){value});")
        }
        (PrintedKind::Elementary(ty), ReadableExpression::Timespec(value)) => {
            format!(
                "print_date(\"{name}\", \"{}\", {value}.tv_sec, {value}.tv_nsec);",
                date(*ty)
            )
        }
        (PrintedKind::Elementary(ty), ReadableExpression::Nanoseconds(value)) => format!(
            "print_date(\"{name}\", \"{}\", {value} / 1000000000, {value} % 1000000000);",
            date(*ty)
        ),
        (PrintedKind::Elementary(ty), ReadableExpression::Days(value)) => {
            format!("print_date(\"{name}\", \"{}\", {value} * 86400LL, 0);", date(*ty))
        }
        (PrintedKind::Enumerated(_, values), value) => {
            let numbered = values.iter().enumerate();
            let numbered: Vec<String> = numbered
                .map(|(number, value)| format!("{number} {value}"))
                .collect();
            let value = value.number();
            format!(
                "printf(\"{format} = %d (of {})\\n\", (int){value});",
                numbered.join(", ")
            )
        }
        (PrintedKind::Elementary(ty), value) => {
            let (form, cast) = number(*ty);
            format!("printf(\"{format} = {form}\\n\", ({cast}){});", value.number())
        }
    }
}

impl ReadableExpression {
    fn number(&self) -> &str {
        match self {
            ReadableExpression::Number(value)
            | ReadableExpression::Timespec(value)
            | ReadableExpression::Nanoseconds(value)
            | ReadableExpression::Days(value)
            | ReadableExpression::Text { unit: value, .. } => value,
        }
    }
}

/// Returns the form in which C prints a value of a type, and the C type which that takes. Real numbers have as many digits as
/// tell them apart.
fn number(ty: ElementaryType) -> (&'static str, &'static str) {
    match ty {
        ElementaryType::Lint => ("%lld", "long long"),
        ElementaryType::Ulint => ("%llu", "unsigned long long"),
        ElementaryType::Usint | ElementaryType::Uint | ElementaryType::Udint => ("%u", "unsigned"),
        ElementaryType::Byte | ElementaryType::Char => ("16#%02X", "unsigned"),
        ElementaryType::Word | ElementaryType::Wchar => ("16#%04X", "unsigned"),
        ElementaryType::Dword => ("16#%08X", "unsigned"),
        ElementaryType::Lword => ("16#%016llX", "unsigned long long"),
        ElementaryType::Real => ("%.9g", "double"),
        ElementaryType::Lreal => ("%.17g", "double"),
        _ => ("%d", "int"),
    }
}

/// Returns the format of a date for `strftime`.
fn date(ty: ElementaryType) -> &'static str {
    match ty {
        ElementaryType::Date | ElementaryType::Ldate => "%Y-%m-%d",
        ElementaryType::Tod | ElementaryType::Ltod => "%H:%M:%S",
        _ => "%Y-%m-%d %H:%M:%S",
    }
}

/// The function `main` of a driver.
pub(super) struct DriverMain {
    /// The number of scans.
    pub(super) scans: u32,
    /// The statements before the first scan.
    pub(super) start: Vec<String>,
    /// The statements before a scan, each with the number of the scan.
    pub(super) before: Vec<(u32, String)>,
    /// The statement that makes a scan.
    pub(super) scan: String,
    /// The statements that print values, each with the number of the scan after which it does; `None` for the last.
    pub(super) after: Vec<(Option<u32>, String)>,
}

impl DriverMain {
    /// Returns the text of the function, without a loop where there is nothing to repeat.
    pub(super) fn text(&self) -> String {
        let mut text = "int main(void) {\n".to_owned();
        for statement in &self.start {
            // Writing into a String does not fail.
            let _ = writeln!(text, "    {statement}");
        }
        let between = self.after.iter().any(|(scan, _)| scan.is_some());
        if self.scans == 1 && self.before.is_empty() && !between {
            let _ = writeln!(text, "    {}", self.scan);
        } else {
            self.write_loop(&mut text);
        }
        for (_, statement) in self.after.iter().filter(|(scan, _)| scan.is_none()) {
            let _ = writeln!(text, "    {statement}");
        }
        text.push_str("    return 0;\n}\n");
        text
    }

    fn write_loop(&self, text: &mut String) {
        let _ = writeln!(
            text,
            "    for (unsigned scan = 1; scan <= {}; scan++) {{",
            self.scans
        );
        for (scan, statement) in &self.before {
            let _ = writeln!(text, "        if (scan == {scan}) {{ {statement} }}");
        }
        let _ = writeln!(text, "        {}", self.scan);
        for (scan, statement) in &self.after {
            if let Some(scan) = scan {
                let _ = writeln!(text, "        if (scan == {scan}) {{ {statement} }}");
            }
        }
        text.push_str("    }\n");
    }
}
