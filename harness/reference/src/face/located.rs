//! Diagnostics as a person reads them: sorted, each said once, with lines and columns.
//!
//! Basis: stickler-design: §4 (order, positions; a code that says a construct is not enabled suppresses every
//! other diagnostic about that construct).

use crate::diagnostic::Diagnostic;
use crate::source::{LineIndex, Span};
use stickler_types::Code;

/// Something wrong with a source text, and where. Lines and columns count from 1, columns in Unicode scalar
/// values; the end is exclusive.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct LocatedDiagnostic {
    /// What kind of thing is wrong.
    pub code: Code,
    /// The line on which the place begins.
    pub line: u32,
    /// The column of its first character.
    pub column: u32,
    /// The line on which the place ends.
    pub end_line: u32,
    /// The column behind its last character.
    pub end_column: u32,
    /// What is wrong here, as a lower-case fragment without a full stop.
    pub message: String,
    /// Text that replaces exactly this place and makes the program acceptable.
    pub suggestion: Option<String>,
}

/// Drops what is suppressed, finds lines and columns, sorts by line, column and code, and says nothing twice.
pub(super) fn locate(
    mut diagnostics: Vec<Diagnostic>,
    text: &str,
    lines: &LineIndex,
) -> Vec<LocatedDiagnostic> {
    suppress(&mut diagnostics);
    let mut located: Vec<_> = diagnostics
        .into_iter()
        .map(|diagnostic| at_position(diagnostic, text, lines))
        .collect();
    located.sort_by(|a, b| order(a).cmp(&order(b)));
    located.dedup();
    located
}

type Order<'a> = (u32, u32, &'static str, u32, u32, &'a str);

fn order(diagnostic: &LocatedDiagnostic) -> Order<'_> {
    let LocatedDiagnostic {
        code,
        line,
        column,
        end_line,
        end_column,
        message,
        ..
    } = diagnostic;
    (*line, *column, code.as_str(), *end_line, *end_column, message)
}

fn at_position(diagnostic: Diagnostic, text: &str, lines: &LineIndex) -> LocatedDiagnostic {
    let start = lines.position(text, diagnostic.span.start);
    let end = lines.position(text, diagnostic.span.end.max(diagnostic.span.start));
    LocatedDiagnostic {
        code: diagnostic.code,
        line: start.line,
        column: start.column,
        end_line: end.line,
        end_column: end.column,
        message: diagnostic.message,
        suggestion: diagnostic.suggestion,
    }
}

/// Drops whatever is said about a construct that is not enabled, except that.
fn suppress(diagnostics: &mut Vec<Diagnostic>) {
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

    const TEXT: &str = "é := x.%X3;\nb := 5;\n";

    fn codes(diagnostics: &[(Code, u32, u32)]) -> Vec<(Code, u32, u32)> {
        let diagnostics = diagnostics
            .iter()
            .map(|&(code, start, end)| Diagnostic::new(code, Span { start, end }, code.as_str()));
        let located = locate(diagnostics.collect(), TEXT, &LineIndex::new(TEXT));
        located
            .iter()
            .map(|diagnostic| (diagnostic.code, diagnostic.line, diagnostic.column))
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
