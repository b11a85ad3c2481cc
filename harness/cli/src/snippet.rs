//! Diagnostics with the lines that they are about, as compilers show them.

use annotate_snippets::{AnnotationKind, Group, Level, Origin, Patch, Renderer, Report, Snippet};
use std::io::{self, Write};
use std::ops::Range;
use stickler_types::Diagnostic;

/// How many diagnostics are shown; a broken file has more than anyone reads.
const MOST: usize = 200;

/// Lines longer than this are not shown.
const LONGEST_LINE: usize = 400;

/// How many lines of a place are shown.
const MOST_LINES: usize = 6;

/// Writes the diagnostics of a text; `path` is the name to show for it.
///
/// # Errors
/// Those of `out`.
pub fn write(diagnostics: &[Diagnostic], text: &str, path: &str, out: &mut dyn Write) -> io::Result<()> {
    let lines: Vec<&str> = text.split('\n').collect();
    let renderer = Renderer::styled();
    for diagnostic in diagnostics.iter().take(MOST) {
        let groups = groups(diagnostic, &lines, path);
        writeln!(out, "{}\n", renderer.render(Report::from(&groups[..])))?;
    }
    let number = diagnostics.len();
    if number > MOST {
        writeln!(out, "... and {} more diagnostics\n", number - MOST)?;
    }
    let first = diagnostics.first().and_then(|first| first.code.as_deref());
    let code = first.unwrap_or("P4035");
    let found = if number == 1 {
        "1 diagnostic".to_owned()
    } else {
        format!("{number} diagnostics")
    };
    writeln!(out, "{found}; `stickler explain {code}` says more about a code.")
}

fn groups<'a>(diagnostic: &'a Diagnostic, lines: &[&str], path: &'a str) -> Vec<Group<'a>> {
    let title = Level::ERROR
        .primary_title(&diagnostic.message)
        .id(diagnostic.code.as_deref().unwrap_or_default());
    let line = diagnostic.line.unwrap_or_default() as usize;
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
        let patched = Snippet::source(excerpt.text)
            .line_start(line)
            .path(path)
            .patch(Patch::new(excerpt.span, suggestion));
        groups.push(
            Level::HELP
                .secondary_title("convert it explicitly")
                .element(patched),
        );
    }
    groups
}

/// The lines of a diagnostic, and where in them its place is.
struct Excerpt {
    text: String,
    span: Range<usize>,
}

impl Excerpt {
    /// `None` where the place is not in the text, or its lines are too many or too long to be shown.
    fn of(diagnostic: &Diagnostic, lines: &[&str]) -> Option<Excerpt> {
        let first = (diagnostic.line? as usize).checked_sub(1)?;
        let last = (diagnostic.end_line? as usize).checked_sub(1)?.max(first);
        let shown = lines.get(first..=last)?;
        if shown.len() > MOST_LINES || shown.iter().any(|line| line.len() > LONGEST_LINE) {
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

/// Columns count Unicode scalar values from 1; a column behind the line is its end.
fn byte_of_column(line: &str, column: u32) -> usize {
    let index = (column as usize).saturating_sub(1);
    line.char_indices()
        .nth(index)
        .map_or(line.len(), |(byte, _)| byte)
}
