//! Diagnostics as a person reads them: sorted, each said once, with lines and columns.
//!
//! Basis: harness/engines/README.md (order, positions); rule: not-enabled-hides-the-rest (a code that says a construct is not
//! enabled suppresses every other diagnostic about that construct).

use stickler_syntax::diagnostic::SpannedDiagnostic;
use stickler_syntax::source::{LineIndex, Span};
use stickler_types::Diagnostic;

/// Returns the diagnostics of a text as a person reads them: without those that another one suppresses, with lines and columns,
/// sorted by line, column and code, and none twice.
pub fn locate(mut diagnostics: Vec<SpannedDiagnostic>, text: &str, lines: &LineIndex) -> Vec<Diagnostic> {
    suppress(&mut diagnostics);
    let mut located: Vec<_> = diagnostics
        .into_iter()
        .map(|diagnostic| at_position(diagnostic, text, lines))
        .collect();
    located.sort_by(|a, b| order(a).cmp(&order(b)));
    located.dedup();
    located
}

/// Returns the key that diagnostics are sorted by.
type Order<'a> = (
    Option<u32>,
    Option<u32>,
    &'a Option<String>,
    Option<u32>,
    Option<u32>,
    &'a str,
);

fn order(diagnostic: &Diagnostic) -> Order<'_> {
    let Diagnostic {
        code,
        line,
        column,
        end_line,
        end_column,
        message,
        ..
    } = diagnostic;
    (*line, *column, code, *end_line, *end_column, message)
}

fn at_position(diagnostic: SpannedDiagnostic, text: &str, lines: &LineIndex) -> Diagnostic {
    let start = lines.position(text, diagnostic.span.start);
    let end = lines.position(text, diagnostic.span.end.max(diagnostic.span.start));
    Diagnostic {
        severity: diagnostic.code.severity(),
        code: Some(diagnostic.code.as_str().to_owned()),
        line: Some(start.line),
        column: Some(start.column),
        end_line: Some(end.line),
        end_column: Some(end.column),
        message: diagnostic.message,
        suggestion: diagnostic.suggestion,
    }
}

/// Drops whatever is said about a construct that is not enabled, except that.
fn suppress(diagnostics: &mut Vec<SpannedDiagnostic>) {
    let not_enabled = diagnostics
        .iter()
        .filter(|diagnostic| diagnostic.code.not_enabled());
    let constructs = joined(not_enabled.map(|diagnostic| extent(diagnostic.span)).collect());
    if constructs.is_empty() {
        return;
    }
    diagnostics.retain(|diagnostic| {
        diagnostic.code.not_enabled() || !overlaps(&constructs, extent(diagnostic.span))
    });
}

/// A place of no bytes still is one.
fn extent(span: Span) -> (u32, u32) {
    (span.start, span.end.max(span.start.saturating_add(1)))
}

/// The extents in order, those that overlap made one.
fn joined(mut extents: Vec<(u32, u32)>) -> Vec<(u32, u32)> {
    extents.sort_unstable();
    extents.dedup_by(|next, last| {
        let touches = next.0 < last.1;
        if touches {
            last.1 = last.1.max(next.1);
        }
        touches
    });
    extents
}

fn overlaps(constructs: &[(u32, u32)], (start, end): (u32, u32)) -> bool {
    let first_behind = constructs.partition_point(|construct| construct.1 <= start);
    constructs
        .get(first_behind)
        .is_some_and(|construct| construct.0 < end)
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_types::Code;

    const TEXT: &str = "é := x.%X3;\nb := 5;\n";

    fn codes(diagnostics: &[(Code, u32, u32)]) -> Vec<(Code, u32, u32)> {
        let diagnostics = diagnostics
            .iter()
            .map(|&(code, start, end)| SpannedDiagnostic::new(code, Span { start, end }, code.as_str()));
        let located = locate(diagnostics.collect(), TEXT, &LineIndex::new(TEXT));
        located
            .iter()
            .filter_map(|found| Some((found.registered_code()?, found.line?, found.column?)))
            .collect()
    }

    #[test]
    fn columns_count_characters_and_the_order_is_that_of_the_text() {
        let found = codes(&[(Code::AssignmentTypeMismatch, 18, 19), (Code::SyntaxError, 6, 7)]);
        assert_eq!(
            found,
            [(Code::SyntaxError, 1, 6), (Code::AssignmentTypeMismatch, 2, 6)]
        );
    }

    #[test]
    fn codes_on_one_place_are_sorted_and_said_once() {
        let mismatch = (Code::AssignmentTypeMismatch, 6, 7);
        let found = codes(&[mismatch, (Code::SyntaxError, 6, 9), mismatch]);
        assert_eq!(
            found,
            [(Code::SyntaxError, 1, 6), (Code::AssignmentTypeMismatch, 1, 6)]
        );
    }

    #[test]
    fn a_construct_that_is_not_enabled_silences_what_else_is_said_about_it() {
        let disabled = (Code::PartialAccessSyntaxDisabled, 7, 11);
        let inside = (Code::SyntaxError, 8, 8);
        let around = (Code::AssignmentTypeMismatch, 6, 11);
        let before = (Code::SyntaxError, 6, 7);
        let behind = (Code::SyntaxError, 11, 11);
        let nested = (Code::CStyleComment, 8, 9);
        let found = codes(&[before, inside, disabled, around, behind, nested]);
        let left = [
            (Code::SyntaxError, 1, 6),
            (Code::PartialAccessSyntaxDisabled, 1, 7),
            (Code::CStyleComment, 1, 8),
            (Code::SyntaxError, 1, 11),
        ];
        assert_eq!(found, left);
    }
}
