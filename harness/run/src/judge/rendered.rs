//! Compares a rendered text with the expected lines, and with the results of rendering and running it again.

use super::Findings;
use super::bodies::rendered_bodies;
use crate::{Fact, Rendering};
use stickler_engines::{Diagnostic, Outcome};
use stickler_suite::ExpectedText;
use stickler_syntax::token::tokens;
use stickler_types::{Dialect, DialectName};

/// Compares the bodies in the rendered text with the expected lines, whose blanks do not matter, and requires that rendering again
/// changes nothing and that the rendered program does what the program did.
pub(super) fn compare(
    expected: &ExpectedText,
    run: &Outcome,
    rendering: &Rendering,
    findings: &mut Findings,
) {
    let Outcome::Rendered { text } = &rendering.first else {
        findings.require(false);
        return findings.add(not_rendered(&rendering.first, None));
    };
    let bodies = rendered_bodies(text);
    let wanted = expected.lines.iter().map(|line| line.trim());
    let wanted: Vec<&str> = wanted.filter(|line| !line.is_empty()).collect();
    let is_alike = |wanted: &str, body: &str| words(wanted) == words(body);
    findings.require(wanted.len() == bodies.len());
    let mut wanted = wanted.into_iter();
    // A line that differs in its blanks alone is told as it was expected, so that it hides no line that says something else.
    let told = bodies.into_iter().map(|body| match wanted.next() {
        Some(line) if is_alike(line, body) => line,
        _ => {
            findings.require(false);
            body
        }
    });
    let told = lines(told);
    told.into_iter().for_each(|fact| findings.add(fact));
    if let Some(again) = &rendering.again {
        compare_again(text, again, findings);
    }
    if rendering
        .rerun
        .as_ref()
        .is_some_and(|rerun| !run.ends_like(rerun))
    {
        findings.require(false);
        findings.add(Fact::RenderedMeansOther);
    }
}

fn compare_again(text: &str, again: &Outcome, findings: &mut Findings) {
    match again {
        Outcome::Rendered { text: second } if second == text => {}
        Outcome::Rendered { text: second } => {
            findings.require(false);
            let differs = text
                .lines()
                .zip(second.lines())
                .position(|(first, second)| first != second);
            let at = differs.unwrap_or_else(|| text.lines().count().min(second.lines().count()));
            let line = second.lines().nth(at).unwrap_or_default().trim();
            findings.add(Fact::RenderedOtherwise {
                line: at + 1,
                text: line.to_owned(),
            });
        }
        refusal => {
            findings.require(false);
            findings.add(not_rendered(refusal, Some(text)));
        }
    }
}

/// Returns whether rendered lines have the expected accesses of bits, in the expected form: that is all a document says of what is
/// rendered.
pub fn renders_bit_access(expected: &[Fact], got: &[Fact]) -> bool {
    let rendered = |facts: &[Fact]| {
        let lines = facts.iter().find_map(|fact| match fact {
            Fact::Rendered { lines } => Some(lines.iter().flat_map(|line| bits(line)).collect::<Vec<_>>()),
            _ => None,
        });
        lines.filter(|bits| !bits.is_empty())
    };
    let expected = rendered(expected);
    expected.is_some() && expected == rendered(got)
}

/// Returns the accesses of bits of a line, such as `3` of `v.3` and `%X3` of `v.%X3`.
fn bits(line: &str) -> Vec<String> {
    let words = words(line);
    let is_bit = |pair: &&[&str]| {
        pair[0] == "." && pair[1].starts_with(|sign: char| sign == '%' || sign.is_ascii_digit())
    };
    words
        .windows(2)
        .filter(is_bit)
        .map(|pair| pair[1].to_owned())
        .collect()
}

/// Returns the words, signs and literals of a line, which no blanks change.
fn words(line: &str) -> Vec<&str> {
    let tokens = tokens(line, Dialect::of(DialectName::IEC_ED3)).list;
    tokens.iter().map(|token| token.span.text(line)).collect()
}

/// Returns the lines as a fact; `None` where there is no line.
pub(super) fn lines<'l>(lines: impl Iterator<Item = &'l str>) -> Option<Fact> {
    let lines: Vec<String> = lines.map(str::to_owned).collect();
    (!lines.is_empty()).then_some(Fact::Rendered { lines })
}

/// Returns the fact that a program was not rendered; where it is itself a rendered text, with the line that is rejected.
fn not_rendered(outcome: &Outcome, rendered: Option<&str>) -> Fact {
    let said = |diagnostic: &Diagnostic| {
        let line = diagnostic.line.and_then(|line| line.checked_sub(1));
        let line = line.and_then(|line| rendered?.lines().nth(line as usize));
        match line {
            Some(line) => format!("{}, at `{}`", diagnostic.message, line.trim()),
            None => diagnostic.message.clone(),
        }
    };
    let rejection = match outcome {
        Outcome::Rejected { diagnostics } => Some(diagnostics.first().map(said).unwrap_or_default()),
        _ => None,
    };
    Fact::NotRendered {
        again: rendered.is_some(),
        rejection,
    }
}
