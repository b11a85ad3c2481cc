//! Suggests what to write instead of what another dialect rejects, and writes it.

use super::{Finding, Kind, by_run};
use crate::output;
use crate::source_file::Program;
use stickler_reference::semantics::is_standard_function;
use stickler_syntax::Edits;
use stickler_syntax::source::Span;
use stickler_types::{Diagnostic, Dialect, DialectName, counted};

/// The maximum number of times that suggestions are made for a text with earlier ones.
const MAX_ROUNDS: usize = 10;

/// Returns the place in a text to which a diagnostic points.
pub(super) fn span(diagnostic: &Diagnostic, text: &str) -> Option<Span> {
    let byte = |line: u32, column: u32| {
        let lines = text.split_inclusive('\n').take(line as usize - 1);
        let before: usize = lines.map(str::len).sum();
        let characters = text[before..].char_indices().map(|(byte, _)| byte);
        let in_line = characters.chain([text.len() - before]).nth(column as usize - 1)?;
        u32::try_from(before + in_line).ok()
    };
    Some(Span::new(
        byte(diagnostic.line?, diagnostic.column?)?,
        byte(diagnostic.end_line?, diagnostic.end_column?)?,
    ))
}

/// Returns the name in the other dialect of the function or type that a diagnostic points to: that of the standard, or its own.
pub(super) fn renamed(diagnostic: &Diagnostic, text: &str, dialects: [DialectName; 2]) -> Option<String> {
    let [from, to] = dialects.map(Dialect::of);
    let span = span(diagnostic, text)?;
    let name = span.text(text);
    let standard = from.standard_name(name);
    let is_known = |other: &String| {
        let is_type = to.elementary(other).is_some_and(|ty| to.has(ty));
        let is_function = is_standard_function(to.standard_name(other), to);
        (is_type || is_function) && !other.eq_ignore_ascii_case(name)
    };
    let own = to.names.iter().filter(|(_, known)| *known == standard);
    let own = own.map(|(own, _)| own.clone());
    [standard.to_owned()].into_iter().chain(own).find(is_known)
}

/// Returns a text with what is suggested for its places, and the number of the changes. A blank place has none, nor one within another.
pub(super) fn applied<'d>(
    text: &str,
    diagnostics: impl IntoIterator<Item = &'d Diagnostic>,
) -> (String, u64) {
    let (mut edits, mut changes, mut last) = (Edits::new(), 0, 0);
    for diagnostic in diagnostics {
        let span = span(diagnostic, text).filter(|span| !span.text(text).trim().is_empty());
        if let (Some(suggestion), Some(span)) = (&diagnostic.suggestion, span)
            && span.start >= last
        {
            edits.replace(span, suggestion);
            (changes, last) = (changes + 1, span.end);
        }
    }
    (edits.apply(text), changes)
}

/// Makes the suggested changes in the files of a program, unless the other dialect still rejects it then, or a program, block or function
/// computes something else there that did not before; says on stderr what was done.
///
/// # Errors
/// A file that cannot be written.
pub(super) fn fix(
    program: &Program,
    text: &str,
    findings: &[Finding],
    dialects: [DialectName; 2],
) -> anyhow::Result<()> {
    let open = findings.iter().filter(|finding| finding.kind != Kind::Mistake);
    let mut suggested: Vec<Diagnostic> = open.map(|finding| finding.diagnostic.clone()).collect();
    let (mut fixed, mut changes) = (text.to_owned(), 0);
    // What is mended may show what else is wrong.
    for _ in 0..MAX_ROUNDS {
        let (edited, made) = applied(&fixed, &suggested);
        if made == 0 {
            break;
        }
        fixed = edited;
        changes += made;
        suggested = stickler_reference::errors(&fixed, dialects[1]);
    }
    let errors = stickler_reference::errors(&fixed, dialects[1]);
    let place = |one: &Diagnostic| (one.line, one.column);
    let is_new = |one: &Diagnostic| {
        findings
            .iter()
            .all(|known| place(&known.diagnostic) != place(one))
    };
    let part = by_run::accepted_part(text, [dialects[0]; 2], Finding::lines_left(findings));
    let found = by_run::findings([&part, &fixed], dialects).into_iter();
    let differs = found.map(|finding| finding.diagnostic).find(is_new);
    let told = match (changes, errors.first().or(differs.as_ref())) {
        (0, _) => "nothing is changed, for there is no suggestion".to_owned(),
        (_, None) => {
            let changes = counted(changes, "suggested change", "suggested changes");
            format!(
                "{changes} made in {}",
                counted(program.write(&fixed)?, "file", "files")
            )
        }
        (_, Some(wrong)) => {
            let (file, before) = program.file_of(wrong.line.unwrap_or(1));
            let line = wrong.line.unwrap_or(1) - before;
            format!(
                "nothing is changed; with the suggested changes, {file}:{line}: {}",
                wrong.message
            )
        }
    };
    output::note(told);
    Ok(())
}
