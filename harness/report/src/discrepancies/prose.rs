//! Causes without text of a program, for trackers that want none.

use stickler_run::{Cause, Fact};

/// Takes the text of programs out of a cause: its program, what the compiler printed of it, and the pieces of it in titles and messages.
pub(super) fn without_program(cause: &mut Cause) {
    cause.title = without_quotes(&cause.title);
    let shown = &mut cause.shown;
    shown.about = without_quotes(&shown.about);
    shown.program.clear();
    shown.reproduction = None;
    shown.printed.clear();
    let outcomes = cause.flaky.iter_mut().flat_map(|repeats| &mut repeats.outcomes);
    let repeated = outcomes.flat_map(|outcome| &mut outcome.got);
    for fact in shown.expected.iter_mut().chain(&mut shown.got).chain(repeated) {
        without_text(fact);
    }
}

/// Takes the text of programs out of a fact. The names of variables and their values remain: they are the claim.
fn without_text(fact: &mut Fact) {
    match fact {
        Fact::Diagnostic(reported) | Fact::Warning(reported) => {
            reported.message = without_quotes(&reported.message);
            reported.suggestion = None;
        }
        Fact::Rendered { lines } => *lines = vec!["…".to_owned()],
        Fact::RenderedOtherwise { text, .. } => "…".clone_into(text),
        Fact::NotRendered { rejection, .. } => *rejection = rejection.as_deref().map(without_quotes),
        Fact::Unsupported { reason }
        | Fact::NotImplemented { reason, .. }
        | Fact::Unusable { reason }
        | Fact::Crashed { reason } => *reason = without_quotes(reason),
        Fact::Error { message } => *message = without_quotes(message),
        // The others have words of ours alone.
        _ => {}
    }
}

/// Returns the first line of a text with `…` for what stands in quotes, and for the rest where a quote is not closed. Compilers show lines of the
/// program below their message.
fn without_quotes(text: &str) -> String {
    let mut rest = text.lines().next().unwrap_or_default();
    let mut kept = String::new();
    loop {
        let opens = |(at, sign): &(usize, char)| match sign {
            // Others are apostrophes within a word.
            '\'' => !rest[..*at].ends_with(char::is_alphanumeric),
            sign => matches!(sign, '`' | '"'),
        };
        let Some((at, sign)) = rest.char_indices().find(opens) else {
            return kept + rest;
        };
        kept.push_str(&rest[..at]);
        kept.push('…');
        rest = rest[at + 1..].split_once(sign).map_or("", |(_, behind)| behind);
    }
}
