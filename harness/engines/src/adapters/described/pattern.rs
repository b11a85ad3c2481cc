//! Regular expressions with named groups: how a compiler writes diagnostics and values.

use crate::{Diagnostic, Severity};
use regex_lite::{Captures, Regex, RegexBuilder};
use std::str::FromStr;
use stickler_types::join;

/// The pattern of a compiler's diagnostics. Groups: `severity`, `code`, `line`, `column`, `end_line`,
/// `end_column`, `message` and `file`.
#[derive(Clone, Debug)]
pub struct DiagnosticPattern(Regex);

/// The pattern of the values that a program prints. Groups: `name` and `value`.
#[derive(Clone, Debug)]
pub struct ValuePattern(Regex);

impl FromStr for DiagnosticPattern {
    type Err = String;

    /// Compiles a regular expression in which `^` and `$` match at line ends of any kind.
    fn from_str(text: &str) -> Result<DiagnosticPattern, String> {
        let known = [
            "severity",
            "code",
            "line",
            "column",
            "end_line",
            "end_column",
            "message",
            "file",
        ];
        Ok(DiagnosticPattern(compiled(text, &known)?))
    }
}

impl FromStr for ValuePattern {
    type Err = String;

    /// Compiles a regular expression, in which `^` and `$` match at line ends of any kind; both groups must be there.
    fn from_str(text: &str) -> Result<ValuePattern, String> {
        let regex = compiled(text, &["name", "value"])?;
        match regex.capture_names().flatten().count() {
            2 => Ok(ValuePattern(regex)),
            _ => Err("it needs both groups, `(?<name>…)` and `(?<value>…)`".to_owned()),
        }
    }
}

fn compiled(text: &str, known: &[&str]) -> Result<Regex, String> {
    let regex = RegexBuilder::new(text)
        .multi_line(true)
        .crlf(true)
        .build()
        .map_err(|error| error.to_string())?;
    for name in regex.capture_names().flatten() {
        if !known.contains(&name) {
            let known = join(known.iter().map(|name| format!("`{name}`")), ", ");
            return Err(format!("the group `{name}` means nothing; there are {known}"));
        }
    }
    Ok(regex)
}

impl DiagnosticPattern {
    /// Tells whether the pattern has this group.
    pub(super) fn tells(&self, group: &str) -> bool {
        self.0.capture_names().flatten().any(|name| name == group)
    }

    /// Returns the diagnostics of a text about the file `program`, in the order of the text. A diagnostic about another file
    /// loses its place, which is no line of the program.
    pub(in crate::adapters) fn diagnostics(&self, text: &str, program: &str) -> Vec<Diagnostic> {
        let here =
            |file: Option<&str>| file.is_none_or(|file| file.rsplit(['/', '\\']).next() == Some(program));
        let read = |captures: Captures<'_>| diagnostic(&captures, here(file(&captures)));
        self.0.captures_iter(text).map(read).collect()
    }

    /// Returns the diagnostics of a text about any file, each with its file where it names one.
    pub(in crate::adapters) fn by_file<'t>(&self, text: &'t str) -> Vec<(Option<&'t str>, Diagnostic)> {
        let read = |captures: Captures<'t>| (file(&captures), diagnostic(&captures, true));
        self.0.captures_iter(text).map(read).collect()
    }
}

/// Returns the file that a diagnostic is about, where it names one.
fn file<'t>(captures: &Captures<'t>) -> Option<&'t str> {
    captures.name("file").map(|group| group.as_str().trim())
}

/// Returns a diagnostic; its place is kept only where `here` says that it is in the program.
fn diagnostic(captures: &Captures<'_>, here: bool) -> Diagnostic {
    let group = |name: &str| captures.name(name).map(|group| group.as_str().trim());
    // Some compilers write line 0 for an unknown line.
    let number = |name: &str| {
        let number = group(name).filter(|_| here)?.parse().ok();
        number.filter(|&number: &u32| number > 0)
    };
    let whole = captures.get(0).map_or("", |whole| whole.as_str()).trim();
    Diagnostic {
        severity: group("severity").map_or(Severity::Error, severity),
        code: group("code").map(str::to_owned),
        line: number("line"),
        column: number("column"),
        end_line: number("end_line"),
        end_column: number("end_column"),
        message: group("message").unwrap_or(whole).to_owned(),
        suggestion: None,
    }
}

/// Returns the weight of a diagnostic by the compiler's word for it: an error where the word begins with `err` or `fatal`, in any
/// case; whatever is less than an error (`warning`, `note`, `info`) is a warning.
fn severity(word: &str) -> Severity {
    let word = word.to_ascii_lowercase();
    match word.starts_with("err") || word.starts_with("fatal") {
        true => Severity::Error,
        false => Severity::Warning,
    }
}

impl ValuePattern {
    /// Returns the names and values of a text, in the order of the text.
    pub(super) fn values<'t>(&self, text: &'t str) -> Vec<(&'t str, &'t str)> {
        let both = |captures: Captures<'t>| {
            Some((captures.name("name")?.as_str(), captures.name("value")?.as_str()))
        };
        self.0.captures_iter(text).filter_map(both).collect()
    }
}
