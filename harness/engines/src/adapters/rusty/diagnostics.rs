//! Parses the diagnostics of `plc --error-format=clang`, and finds the file that each is about.

use super::FUNCTIONS;
use super::program::PackedProgram;
use crate::adapters::described::DiagnosticPattern;
use crate::adapters::locate::without_colours;
use crate::adapters::{Compiler, codes};
use crate::process::Ended;
use crate::{Diagnostic, Outcome};
use std::path::Path;

/// The pattern of an error or a warning in the list of diagnostics. Notes begin with other words.
const LISTED: &str = r"^(?:(?<file>[^:\n]+):(?<line>\d+):(?<column>\d+):(?:\{\d+:\d+-(?<end_line>\d+):(?<end_column>\d+)\}:)? )?(?<severity>error|warning)\[(?<code>\w+)\]: (?<message>.*)$";

/// The pattern of the last line about an error that prevents the object file, with or without a place.
const LAST: &str = r"\A(?<message>.+?)(?: at: (?<file>[^:\n]+):(?<line>\d+):(?<column>\d+):?(?:\{\d+:\d+-(?<end_line>\d+):(?<end_column>\d+)\}:?)?)?\s*\z";

/// A parser of the compiler's output.
pub(super) struct OutputParser {
    listed: DiagnosticPattern,
    last: DiagnosticPattern,
}

impl OutputParser {
    /// Compiles the patterns of the compiler's output.
    ///
    /// # Errors
    /// None in practice: the patterns are constants that the tests compile.
    pub(super) fn new() -> Result<OutputParser, String> {
        Ok(OutputParser {
            listed: LISTED.parse()?,
            last: LAST.parse()?,
        })
    }

    /// Parses the errors, at least one, or the warnings where the compiler accepts its input.
    ///
    /// # Errors
    /// [`Outcome::Crashed`] where the compiler neither accepts its input nor says why not.
    pub(super) fn diagnostics(&self, ended: &Ended) -> Result<Vec<LocatedDiagnostic>, Outcome> {
        let text = without_colours(&ended.stderr);
        let listed = self.listed.by_file(&text).into_iter().map(located);
        let (mut errors, warnings): (Vec<_>, Vec<_>) = listed.partition(|(_, reported)| reported.is_error());
        match ended.status.code() {
            Some(0) => Ok(warnings),
            Some(1) => {
                if errors.is_empty() {
                    let last = text.lines().rfind(|line| !line.is_empty() && !is_noise(line));
                    let read = self.last.by_file(last.unwrap_or_default()).into_iter();
                    errors.extend(read.map(|(file, one)| located((file, from_one(file, one)))));
                }
                match errors.is_empty() {
                    true => Err(ended.crashed()),
                    false => Ok(errors),
                }
            }
            _ => Err(died(ended, &text)),
        }
    }
}

/// Returns the outcome that says how the compiler ended, with its last lines of output.
fn died(ended: &Ended, text: &str) -> Outcome {
    let lines: Vec<&str> = text.lines().filter(|line| !is_noise(line)).collect();
    let ended = Ended {
        status: ended.status,
        stdout: String::new(),
        stderr: lines.join("\n"),
    };
    steady(ended.crashed())
}

/// Removes from a crash what differs from run to run and from machine to machine: the numbers of threads, addresses in memory, and
/// the folder in which Cargo kept the source of a library.
pub(super) fn steady(outcome: Outcome) -> Outcome {
    let is_of_this_run = |word: &&str| {
        let inside = word.strip_prefix('(').and_then(|rest| rest.strip_suffix(')'));
        inside.is_some_and(|inside| inside.bytes().all(|byte| byte.is_ascii_digit()))
    };
    let word = |word: &str| match word.split_once("/registry/src/") {
        // The folder is named after the registry.
        Some((_, path)) => path.split_once('/').map_or(path, |(_, path)| path).to_owned(),
        None if word.starts_with("0x") => "0x…".to_owned(),
        None => word.to_owned(),
    };
    let steady = |reason: &str| {
        let words = reason.split(' ').filter(|word| !is_of_this_run(word));
        words.map(word).collect::<Vec<String>>().join(" ")
    };
    match outcome {
        Outcome::Crashed { reason } => Outcome::crashed(steady(&reason)),
        Outcome::Unusable { reason } => Outcome::Unusable {
            reason: steady(&reason),
        },
        other => other,
    }
}

/// Tells whether a line says nothing about the cause of the end.
fn is_noise(line: &str) -> bool {
    ["warning[", "info[", "note: run with"]
        .iter()
        .any(|of| line.contains(of))
}

/// Translates the place in a last line, where the lines and columns of a file count from 0.
fn from_one(file: Option<&str>, diagnostic: Diagnostic) -> Diagnostic {
    let next = |number: Option<u32>| file.map(|_| number.unwrap_or(0).saturating_add(1));
    Diagnostic {
        line: next(diagnostic.line),
        column: next(diagnostic.column),
        end_line: next(diagnostic.end_line),
        end_column: next(diagnostic.end_column),
        ..diagnostic
    }
}

/// Returns an error with the part that it is about, instead of the file.
fn located((file, diagnostic): (Option<&str>, Diagnostic)) -> LocatedDiagnostic {
    let place = file.and_then(PackedProgram::place_of);
    let functions = || file.is_some_and(|file| Path::new(file).ends_with(FUNCTIONS));
    match (place, diagnostic.line) {
        (Some(place), _) => (ErrorPart::Program(place), diagnostic),
        (None, Some(line)) if functions() => (ErrorPart::Functions(line), diagnostic),
        (None, _) => (
            ErrorPart::Elsewhere,
            Diagnostic {
                message: diagnostic.message,
                code: diagnostic.code,
                ..Diagnostic::default()
            },
        ),
    }
}

/// Returns a rejection with these diagnostics.
pub(super) fn rejected(diagnostics: impl Iterator<Item = Diagnostic>) -> Outcome {
    Outcome::rejected(sorted(diagnostics))
}

/// The part of the compiled text that an error is about.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum ErrorPart {
    /// The program at this place of the pack.
    Program(usize),
    /// This line of the functions that show the values of programs.
    Functions(u32),
    /// Other text, or an unknown part.
    Elsewhere,
}

/// An error, and the part that it is about.
pub(super) type LocatedDiagnostic = (ErrorPart, Diagnostic);

/// Returns the diagnostics with the registry's codes, sorted, each once.
pub(super) fn sorted(diagnostics: impl Iterator<Item = Diagnostic>) -> Vec<Diagnostic> {
    let codes = &Compiler::Rusty.data().codes;
    codes::sorted(
        diagnostics
            .map(|diagnostic| codes.translated(diagnostic))
            .collect(),
    )
}
