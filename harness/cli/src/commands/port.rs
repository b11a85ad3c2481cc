//! `stickler port`: what another system rejects of a program, and what it accepts and computes otherwise.

mod by_run;
mod by_type;
mod compare;
mod fix;

use crate::arguments::PortArguments;
use crate::case_folder::CaseFolder;
use crate::exit::Exit;
use crate::run_plan::now;
use crate::source_file::Program;
use crate::{interrupt, output, shell, snippet};
use anyhow::{Context, ensure};
use by_type::Typed;
use serde::Serialize;
use std::fs;
use std::io::Write;
use stickler_syntax::source::{LineIndex, Span};
use stickler_types::{Diagnostic, DialectName, Severity, Value, counted};

/// The kinds of findings.
#[derive(Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
enum Kind {
    /// The dialect from which the program moves rejects it.
    Mistake,
    /// The dialect to which the program moves rejects a place, or warns of it.
    Rejected,
    /// Both accept it, and it means something else.
    Differs,
}

/// What is to be done at a place of the program.
#[derive(Serialize)]
struct Finding {
    kind: Kind,
    /// The file; the lines are those of the whole program where it is empty.
    file: String,
    diagnostic: Diagnostic,
    /// What stands in the program, with a value that shows the difference.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    inputs: Vec<(String, String)>,
    /// The result in each dialect, from the one to the other; `null` where the program stops with a fault.
    #[serde(skip_serializing_if = "Option::is_none")]
    results: Option<[Option<String>; 2]>,
    /// The source that states each result of a conversion, or that the other dialect rejects the place; `null` where no source does.
    #[serde(skip_serializing_if = "Option::is_none")]
    basis: Option<[Option<String>; 2]>,
}

/// The values of inputs, by the text that stands for each, and the results.
type Example = (Vec<(String, Value)>, [Option<Value>; 2]);

impl Finding {
    fn new(kind: Kind, diagnostic: Diagnostic) -> Finding {
        Finding {
            kind,
            file: String::new(),
            diagnostic,
            inputs: Vec::new(),
            results: None,
            basis: None,
        }
    }

    /// Makes the finding that `what` gives other results.
    fn differs(
        text: &str,
        span: Span,
        what: &str,
        (inputs, results): Example,
        dialects: [DialectName; 2],
        basis: Option<[Option<String>; 2]>,
    ) -> Finding {
        let literal = |value: &Value| value.literal();
        let results = [0, 1].map(|at| results[at].as_ref().map(literal));
        let shown = [0, 1].map(|at| {
            let basis = match basis.as_ref().map(|basis| &basis[at]) {
                Some(Some(basis)) => format!(" (documented: {})", basis.split(':').next().unwrap_or(basis)),
                Some(None) => " (our choice)".to_owned(),
                None => String::new(),
            };
            let result = results[at].as_deref().unwrap_or("a fault that stops the program");
            format!("{result} in {}{basis}", dialects[at])
        });
        let inputs: Vec<_> = inputs
            .iter()
            .map(|(name, value)| (name.clone(), literal(value)))
            .collect();
        let values: Vec<String> = inputs
            .iter()
            .map(|(name, value)| format!("`{name}` is {value}"))
            .collect();
        let values = match values.is_empty() {
            true => String::new(),
            false => format!(", where {}", values.join(" and ")),
        };
        let lines = LineIndex::new(text);
        let [start, end] = [span.start, span.end].map(|byte| lines.position(text, byte));
        let diagnostic = Diagnostic {
            severity: Severity::Warning,
            line: Some(start.line),
            column: Some(start.column),
            end_line: Some(end.line),
            end_column: Some(end.column),
            message: format!("{what} is {}{values}", shown.join(" and ")),
            ..Diagnostic::default()
        };
        Finding {
            inputs,
            results: Some(results),
            basis,
            ..Finding::new(Kind::Differs, diagnostic)
        }
    }

    /// Returns the lines that mean something else in the other dialect, and for which nothing is suggested.
    fn lines_left(findings: &[Finding]) -> Vec<u32> {
        let differing = findings.iter().filter(|finding| finding.kind == Kind::Differs);
        let left = differing.filter(|finding| finding.diagnostic.suggestion.is_none());
        left.filter_map(|finding| finding.diagnostic.line).collect()
    }

    /// Returns whether something is to be done; a warning of the other dialect asks for nothing.
    fn is_open(&self) -> bool {
        self.kind == Kind::Differs || self.diagnostic.is_error()
    }
}

/// Shows what is to be done to move a program from a dialect to another, and does it where it can with `--fix`.
///
/// # Errors
/// A file that cannot be read or written, the same dialect twice, a folder of cases that is not there.
pub fn execute(arguments: &PortArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let dialects @ [from, to] = [arguments.from, arguments.to];
    ensure!(
        from != to,
        "--from and --to are both {to}; name the dialect to which the program moves"
    );
    interrupt::at_once()?;
    let program = Program::read(&arguments.files)?;
    let (text, mistakes) = stickler_reference::check_bytes(&program.bytes, from);
    let mut typed = Typed::new(
        &text,
        dialects,
        CaseFolder::locate_any(arguments.cases.as_deref())?,
    );
    let differing = typed.findings();
    let mut findings = rejected(&text, mistakes, &mut typed, dialects);
    let part = by_run::accepted_part(&text, dialects, Finding::lines_left(&differing));
    let (mended, _) = fix::applied(&part, differing.iter().map(|finding| &finding.diagnostic));
    findings.extend(differing);
    findings.extend(by_run::findings([&part, &mended], dialects));
    findings.sort_by_key(|finding| (finding.diagnostic.line, finding.diagnostic.column));
    if !arguments.json {
        let shown: Vec<Diagnostic> = findings
            .iter()
            .map(|finding| finding.diagnostic.clone())
            .collect();
        snippet::write(&shown, &text, |line| program.file_of(line), out)?;
        let [mistakes, errors, others] = [Kind::Mistake, Kind::Rejected, Kind::Differs].map(|kind| {
            let open = findings
                .iter()
                .filter(|finding| finding.kind == kind && finding.is_open());
            open.count() as u64
        });
        let (mistakes, errors) = (
            counted(mistakes, "mistake", "mistakes"),
            counted(errors, "error", "errors"),
        );
        let others = counted(others, "place means", "places mean");
        let name = program.name();
        writeln!(
            out,
            "{name}: {mistakes} in {from} already, {errors} in {to}, {others} something else there"
        )?;
        out.flush()?;
    }
    if arguments.fix {
        fix::fix(&program, &text, &findings, dialects)?;
    }
    for finding in &mut findings {
        let (file, before) = program.file_of(finding.diagnostic.line.unwrap_or(1));
        finding.file = file.to_owned();
        for line in [&mut finding.diagnostic.line, &mut finding.diagnostic.end_line] {
            *line = line.map(|line| line - before);
        }
        if arguments.json {
            output::json_line(out, finding)?;
        }
    }
    if let Some(path) = &arguments.sarif {
        let found = findings
            .iter()
            .map(|finding| (&*finding.file, &finding.diagnostic));
        let document =
            stickler_report::diagnostics_as_sarif(found, &shell::command_line(), &now().to_string())?;
        fs::write(path, document).with_context(|| format!("cannot write {}", path.display()))?;
    }
    Ok(Exit::Failures.when(findings.iter().any(Finding::is_open)))
}

/// Returns the mistakes of a program, and what else the other dialect rejects or warns of, with suggestions.
fn rejected(
    text: &str,
    mistakes: Vec<Diagnostic>,
    typed: &mut Typed<'_>,
    dialects: [DialectName; 2],
) -> Vec<Finding> {
    let mut findings = Vec::new();
    for mut diagnostic in stickler_reference::check(text, dialects[1]) {
        let place = |one: &Diagnostic| (one.line, one.column, one.code.clone());
        if mistakes
            .iter()
            .all(|mistake| place(mistake) != place(&diagnostic))
        {
            let better = match &diagnostic.suggestion {
                None => fix::renamed(&diagnostic, text, dialects),
                Some(_) => fix::span(&diagnostic, text).and_then(|span| typed.mended_at(span)),
            };
            diagnostic.suggestion = better.or(diagnostic.suggestion);
            let basis = fix::span(&diagnostic, text).and_then(|span| typed.rejected_by(span));
            diagnostic.message += &match &basis {
                Some(basis) => format!(" (documented: {})", basis.split(':').next().unwrap_or(basis)),
                None => " (our reading)".to_owned(),
            };
            findings.push(Finding {
                basis: Some([None, basis]),
                ..Finding::new(Kind::Rejected, diagnostic)
            });
        }
    }
    for mut diagnostic in mistakes.into_iter().filter(Diagnostic::is_error) {
        diagnostic.message += &format!(" (in {} already)", dialects[0]);
        findings.push(Finding::new(Kind::Mistake, diagnostic));
    }
    findings
}
