//! What `plc` says with `--error-format=clang`, and of which file.

use super::FUNCTIONS;
use super::program::Program;
use crate::adapters::described::DiagnosticPattern;
use crate::adapters::plain::without_colours;
use crate::process::Ended;
use crate::{Diagnostic, Outcome};
use std::path::Path;
use stickler_types::Code;

/// How it writes an error that it finds. Warnings and notes have their own words.
const LISTED: &str = r"^(?:(?<file>[^:\n]+):(?<line>\d+):(?<column>\d+):(?:\{\d+:\d+-(?<end_line>\d+):(?<end_column>\d+)\}:)? )?error\[(?<code>\w+)\]: (?<message>.*)$";

/// How it writes what stops it when it makes the object file: in a last line, with or without a place.
const LAST: &str = r"\A(?<message>.+?)(?: at: (?<file>[^:\n]+):(?<line>\d+):(?<column>\d+):?(?:\{\d+:\d+-(?<end_line>\d+):(?<end_column>\d+)\}:?)?)?\s*\z";

/// What an error is about.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum About {
    /// The program of this place.
    Program(usize),
    /// The functions that show the values of the program of this number.
    Functions(usize),
    /// Something else, or nobody knows.
    Elsewhere,
}

/// An error, and what it is about.
pub(super) type Found = (About, Diagnostic);

/// Reads what the compiler writes.
pub(super) struct Reader {
    listed: DiagnosticPattern,
    last: DiagnosticPattern,
}

impl Reader {
    /// # Errors
    /// Never, as the tests show.
    pub(super) fn new() -> Result<Reader, String> {
        Ok(Reader {
            listed: LISTED.parse()?,
            last: LAST.parse()?,
        })
    }

    /// The errors that it tells, at least one; none where it accepts what it was given.
    ///
    /// # Errors
    /// [`Outcome::Crashed`] where it neither accepts that nor says why not.
    pub(super) fn errors(&self, ended: &Ended) -> Result<Vec<Found>, Outcome> {
        let text = without_colours(&ended.stderr);
        match ended.status.code() {
            Some(0) => Ok(Vec::new()),
            Some(1) => {
                let mut found: Vec<Found> = self.listed.by_file(&text).into_iter().map(located).collect();
                if found.is_empty() {
                    let last = text.lines().rfind(|line| !line.is_empty() && !is_noise(line));
                    let told = self.last.by_file(last.unwrap_or_default()).into_iter();
                    found = told
                        .map(|(file, told)| located((file, from_one(file, told))))
                        .collect();
                }
                match found.is_empty() {
                    true => Err(ended.crashed()),
                    false => Ok(found),
                }
            }
            _ => Err(died(ended, &text)),
        }
    }
}

/// The outcome that says how it ended and what it said last.
fn died(ended: &Ended, text: &str) -> Outcome {
    let lines: Vec<&str> = text.lines().filter(|line| !is_noise(line)).collect();
    steady(
        Ended {
            status: ended.status,
            stdout: String::new(),
            stderr: lines.join("\n"),
        }
        .crashed(),
    )
}

/// An outcome that is the same each time: of a crash, without the numbers of threads and of places in memory.
pub(super) fn steady(outcome: Outcome) -> Outcome {
    let is_of_this_run = |word: &&str| {
        let inside = word.strip_prefix('(').and_then(|rest| rest.strip_suffix(')'));
        inside.is_some_and(|inside| inside.bytes().all(|byte| byte.is_ascii_digit()))
    };
    let word = |word| {
        if str::starts_with(word, "0x") {
            "0x…"
        } else {
            word
        }
    };
    match outcome {
        Outcome::Crashed { reason } => {
            let words = reason.split(' ').filter(|word| !is_of_this_run(word));
            let words: Vec<&str> = words.map(word).collect();
            Outcome::Crashed {
                reason: words.join(" "),
            }
        }
        other => other,
    }
}

/// Tells whether a line says nothing of what stopped it.
fn is_noise(line: &str) -> bool {
    ["warning[", "info[", "note: run with"]
        .iter()
        .any(|of| line.contains(of))
}

/// Returns what a last line tells, in which the lines and columns of a file count from 0.
fn from_one(file: Option<&str>, told: Diagnostic) -> Diagnostic {
    let next = |number: Option<u32>| file.map(|_| number.unwrap_or(0).saturating_add(1));
    Diagnostic {
        line: next(told.line),
        column: next(told.column),
        end_line: next(told.end_line),
        end_column: next(told.end_column),
        ..told
    }
}

/// An error with what it is about, in place of the file.
fn located((file, told): (Option<&str>, Diagnostic)) -> Found {
    let place = file.and_then(Program::place_of);
    let functions = || file.is_some_and(|file| Path::new(file).ends_with(FUNCTIONS));
    match (place, told.line) {
        (Some(place), _) => (About::Program(place), told),
        // Those of each program have a line.
        (None, Some(line)) if functions() => (About::Functions(line as usize - 1), told),
        (None, _) => (
            About::Elsewhere,
            Diagnostic {
                message: told.message,
                code: told.code,
                ..Diagnostic::default()
            },
        ),
    }
}

/// A rejection by these diagnostics.
pub(super) fn rejected(told: impl Iterator<Item = Diagnostic>) -> Outcome {
    let mut diagnostics: Vec<Diagnostic> = told.map(translated).collect();
    diagnostics.sort_by(|a, b| (a.line, a.column, &a.code).cmp(&(b.line, b.column, &b.code)));
    diagnostics.dedup();
    Outcome::Rejected { diagnostics }
}

/// The compiler's codes that say what one of the registry says.
///
/// Basis: rusty: its reference of error codes, `plc explain`. Others, such as E048 of anything that is not declared, stand for
/// several of the registry.
const CODES: [(&str, Code); 5] = [
    ("E032", Code::FunctionCallWrongArgCount),
    ("E037", Code::AssignmentTypeMismatch),
    ("E052", Code::UndeclaredUnknownType),
    ("E057", Code::BitAccessOutOfRange),
    ("E058", Code::ArrayIndexOutOfBounds),
];

/// A diagnostic with the registry's code where one of the compiler's says the same.
fn translated(diagnostic: Diagnostic) -> Diagnostic {
    let own = diagnostic.code.as_deref().unwrap_or_default();
    match CODES.iter().find(|(code, _)| *code == own) {
        Some((own, code)) => Diagnostic {
            code: Some(code.as_str().to_owned()),
            message: format!("{own}: {}", diagnostic.message),
            ..diagnostic
        },
        None => diagnostic,
    }
}
