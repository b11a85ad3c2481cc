//! Finds the last token of a source text, where it ends for a person.

use super::lexer;
use crate::source::Span;
use stickler_types::dialect::Dialect;

/// The span of the last token of a text, to which belongs what is wrong at its end; the empty span at the
/// start where the text has no token.
pub fn last_token(text: &str, dialect: &Dialect) -> Span {
    let tokens = lexer::lex(text, dialect).tokens;
    // The very last one stands for the end itself.
    tokens
        .iter()
        .rev()
        .nth(1)
        .map_or(Span::default(), |token| token.span)
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_types::DialectName;

    #[test]
    fn comments_and_blanks_behind_it_do_not_matter() {
        let dialect = Dialect::of(DialectName::IRONPLC_ED2);
        assert_eq!(last_token("a b (* c *)\n", dialect), Span { start: 2, end: 3 });
        assert_eq!(last_token("(* c *)", dialect), Span::default());
    }
}
