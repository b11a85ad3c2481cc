//! Writes diagnostics with the source lines to which they point, as compilers do.

use annotate_snippets::{AnnotationKind, Group, Level, Origin, Patch, Renderer, Report, Snippet};
use std::io::{self, Write};
use std::ops::Range;
use stickler_types::{Diagnostic, Severity, counted, joined, sorted};

/// The maximum number of diagnostics that are shown; a broken file has more than anyone reads.
const MAX_DIAGNOSTICS: usize = 200;

/// The maximum length of a line that is shown, in bytes.
const MAX_LINE_LEN: usize = 400;

/// The maximum number of lines of a diagnostic's place that is shown.
const MAX_EXCERPT_LINES: usize = 6;

/// Writes the diagnostics of a text, nothing where there are none; `file_of` gives the name to show for the file of a line, and the lines
/// before that file.
///
/// # Errors
/// Errors of writing to `out`.
pub fn write<'f>(
    diagnostics: &[Diagnostic],
    text: &str,
    file_of: impl Fn(u32) -> (&'f str, u32),
    out: &mut dyn Write,
) -> io::Result<()> {
    if diagnostics.is_empty() {
        return Ok(());
    }
    let lines: Vec<&str> = text.split('\n').collect();
    let renderer = Renderer::styled();
    for diagnostic in diagnostics.iter().take(MAX_DIAGNOSTICS) {
        let groups = groups(diagnostic, &lines, file_of(diagnostic.line.unwrap_or(1)));
        writeln!(out, "{}\n", renderer.render(Report::from(&groups[..])))?;
    }
    let number = diagnostics.len();
    if number > MAX_DIAGNOSTICS {
        writeln!(out, "... and {} more diagnostics\n", number - MAX_DIAGNOSTICS)?;
    }
    let found = counted(number as u64, "diagnostic", "diagnostics");
    let codes = sorted(diagnostics.iter().filter_map(|one| one.code.as_deref()));
    match codes[..] {
        [] => writeln!(out, "{found}"),
        [code] => writeln!(out, "{found}; `stickler explain {code}` says more about a code."),
        _ => {
            let codes = joined(&codes, "and");
            writeln!(
                out,
                "{found}; `stickler explain CODE` says more about a code: {codes}."
            )
        }
    }
}

fn groups<'a>(diagnostic: &'a Diagnostic, lines: &[&str], (path, before): (&'a str, u32)) -> Vec<Group<'a>> {
    let level = match diagnostic.severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
    };
    let title = level.primary_title(&diagnostic.message);
    let title = match &diagnostic.code {
        Some(code) => title.id(code),
        None => title,
    };
    let line = diagnostic.line.unwrap_or_default().saturating_sub(before) as usize;
    let Some(excerpt) = Excerpt::of(diagnostic, lines) else {
        let origin = Origin::path(path)
            .line(line)
            .char_column(diagnostic.column.unwrap_or_default() as usize);
        return vec![title.element(origin)];
    };
    let place = AnnotationKind::Primary.span(excerpt.span.clone());
    let snippet = Snippet::source(excerpt.text.clone())
        .line_start(line)
        .path(path)
        .annotation(place);
    let mut groups = vec![title.element(snippet)];
    if let Some(suggestion) = &diagnostic.suggestion {
        let patch = Patch::new(excerpt.span.clone(), suggestion);
        let patched = Snippet::source(excerpt.text.clone())
            .line_start(line)
            .path(path)
            .patch(patch);
        let is_converted = suggestion.contains(&excerpt.text[excerpt.span.clone()]);
        let title = match is_converted {
            true => "convert it explicitly",
            false => "write this instead",
        };
        groups.push(Level::HELP.secondary_title(title).element(patched));
    }
    groups
}

/// The source lines of a diagnostic, and the place in them to which it points.
struct Excerpt {
    text: String,
    span: Range<usize>,
}

impl Excerpt {
    /// Returns the excerpt of a diagnostic; `None` where its place is not in the text, or its lines are too many or too long.
    fn of(diagnostic: &Diagnostic, lines: &[&str]) -> Option<Excerpt> {
        let first = (diagnostic.line? as usize).checked_sub(1)?;
        let last = (diagnostic.end_line? as usize).checked_sub(1)?.max(first);
        let shown = lines.get(first..=last)?;
        if shown.len() > MAX_EXCERPT_LINES || shown.iter().any(|line| line.len() > MAX_LINE_LEN) {
            return None;
        }
        let text = shown.join("\n");
        let start = byte_of_column(shown.first()?, diagnostic.column?);
        let before_last: usize = shown[..shown.len() - 1].iter().map(|line| line.len() + 1).sum();
        let end = before_last + byte_of_column(shown.last()?, diagnostic.end_column?);
        Some(Excerpt {
            text,
            span: start..end.max(start),
        })
    }
}

/// Returns the byte offset of a column, which counts Unicode scalar values from 1; a column behind the line is its end.
fn byte_of_column(line: &str, column: u32) -> usize {
    let index = (column as usize).saturating_sub(1);
    line.char_indices()
        .nth(index)
        .map_or(line.len(), |(byte, _)| byte)
}
