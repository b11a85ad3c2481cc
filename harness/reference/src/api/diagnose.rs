//! Checking and rendering: all that can be said about a source text without running it.

use super::located::locate;
use crate::library::{has_block, with_blocks};
use crate::semantics::{self, CheckedProgram};
use stickler_syntax::decoding::decode;
use stickler_syntax::diagnostic::{SpannedDiagnostic, has_errors};
use stickler_syntax::source::LineIndex;
use stickler_types::{Code, Diagnostic, Dialect, DialectName};

/// A source text after all stages but the last.
pub(super) struct Checked {
    /// The program that can be run; `None` where the text has an error or no PROGRAM.
    pub program: Option<CheckedProgram>,
    /// The errors and warnings of the text.
    pub diagnostics: Vec<SpannedDiagnostic>,
    /// Lines and columns of the text.
    pub lines: LineIndex,
}

impl Checked {
    /// Checks a source text, with those standard function blocks that it uses and does not declare.
    pub fn new(source: &str, dialect: &Dialect) -> Checked {
        let mut alone = Checked::alone(source, dialect);
        let Some(text) = with_blocks(source, &alone.diagnostics, dialect) else {
            return alone;
        };
        // Behind a comment that is not closed nothing is declared.
        let is_open = |one: &SpannedDiagnostic| one.code == Code::OpenComment;
        if alone.diagnostics.iter().any(is_open) {
            alone
                .diagnostics
                .retain(|one| is_open(one) || !has_block(one.span.text(source)));
            return alone;
        }
        let whole = Checked::alone(&text, dialect);
        // A dialect may lack the types of a block, and a text may not be closed.
        let end = source.len() as u32;
        if whole.diagnostics.iter().any(|one| one.span.end > end) {
            return alone;
        }
        Checked {
            lines: alone.lines,
            ..whole
        }
    }

    fn alone(source: &str, dialect: &Dialect) -> Checked {
        let lines = LineIndex::new(source);
        let (mut unit, mut diagnostics) = stickler_syntax::parse(source, dialect);
        let is_standard = |name: &str| semantics::is_standard_function(name, dialect);
        stickler_syntax::resolve_qualifiers(&mut unit, source, dialect, is_standard);
        let (program, found) = semantics::check(&unit, source, &lines, dialect);
        diagnostics.extend(found);
        Checked {
            program,
            diagnostics,
            lines,
        }
    }

    /// Returns whether the text is rejected.
    pub fn is_rejected(&self) -> bool {
        has_errors(&self.diagnostics)
    }
}

/// Checks a source text: gives all its errors and warnings, sorted by line, column and code; no error where the dialect accepts
/// it. A text without a PROGRAM is acceptable.
pub fn check(source: &str, dialect: DialectName) -> Vec<Diagnostic> {
    let checked = Checked::new(source, Dialect::of(dialect));
    locate(checked.diagnostics, source, &checked.lines)
}

/// Checks a source text, as [`check`] does, and gives its errors alone: nothing where the dialect accepts it.
pub fn errors(source: &str, dialect: DialectName) -> Vec<Diagnostic> {
    let mut diagnostics = check(source, dialect);
    diagnostics.retain(Diagnostic::is_error);
    diagnostics
}

/// Checks a source text that may be no text: gives it as it was read (see [`decode`]), which is
/// what the positions refer to, and everything that is wrong with it.
pub fn check_bytes(bytes: &[u8], dialect: DialectName) -> (String, Vec<Diagnostic>) {
    let (text, mut diagnostics) = decode(bytes);
    let checked = Checked::new(&text, Dialect::of(dialect));
    diagnostics.extend(checked.diagnostics);
    let located = locate(diagnostics, &text, &checked.lines);
    (text.into_owned(), located)
}

/// The names of all elementary values that [`run`](super::run()) can observe in a program, as paths in the order of
/// their declarations, at most `most` of them; none where the text is not acceptable or has nothing to run.
pub fn variables(source: &str, dialect: DialectName, most: usize) -> Vec<String> {
    let checked = Checked::new(source, Dialect::of(dialect));
    let rejected = checked.is_rejected();
    checked
        .program
        .filter(|_| !rejected)
        .map_or_else(Vec::new, |program| program.variables(most))
}

/// Gives a source text back in its normal form (harness/engines/README.md). What can be read is rendered, whether or
/// not its names and types are right.
///
/// # Errors
/// The diagnostics where the text cannot be read, or uses what its dialect does not enable.
pub fn render(source: &str, dialect: DialectName) -> Result<String, Vec<Diagnostic>> {
    let dialect = Dialect::of(dialect);
    let lines = LineIndex::new(source);
    let (unit, mut diagnostics) = stickler_syntax::parse(source, dialect);
    let (_, found) = semantics::check(&unit, source, &lines, dialect);
    diagnostics.extend(
        found
            .into_iter()
            .filter(|diagnostic| diagnostic.code.not_enabled()),
    );
    if diagnostics.is_empty() {
        Ok(stickler_syntax::render(&unit, source))
    } else {
        Err(locate(diagnostics, source, &lines))
    }
}

/// Returns the diagnostic for a text that is acceptable and has nothing to run, at its last token.
pub(super) fn nothing_to_run(source: &str, dialect: &Dialect) -> SpannedDiagnostic {
    let span = stickler_syntax::last_token(source, dialect);
    if dialect.external_functions && source.contains("{external}") {
        let message = "what calls functions behind `{external}`, whose bodies are elsewhere, cannot run: this is not implemented";
        return SpannedDiagnostic::new(Code::NotImplemented, span, message);
    }
    SpannedDiagnostic::new(Code::NoProgramDeclaration, span, "there is no PROGRAM to run")
}
