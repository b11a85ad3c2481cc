//! Texts that a test file cannot hold; tokens and their diagnostics are tested by `tests/syntax/lexer.md`.

use super::lex;
use crate::token::TokenKind;
use stickler_types::{Code, Dialect, DialectName};

fn ed2() -> &'static Dialect {
    Dialect::of(DialectName::IRONPLC_ED2)
}

fn codes<'t>(text: &'t str, dialect: &Dialect) -> Vec<(Code, &'t str)> {
    let list = lex(text, dialect).diagnostics.into_list();
    list.iter()
        .map(|diagnostic| (diagnostic.code, diagnostic.span.text(text)))
        .collect()
}

#[test]
fn characters_that_are_not_seen_are_reported() {
    for (text, run) in [
        ("ä€\0 b", "ä€\0"),
        ("'\u{1}'", "\u{1}"),
        ("\u{FEFF}a \u{FEFF}", "\u{FEFF}"),
    ] {
        assert_eq!(codes(text, ed2()), [(Code::UnexpectedToken, run)]);
    }
}

#[test]
fn bytes_that_are_no_text_are_reported_in_the_same_words_as_by_their_decoder() {
    let (text, diagnostics) = crate::decoding::decode(b"a \xFF\xFE b");
    assert_eq!(lex(&text, ed2()).diagnostics.into_list(), diagnostics);
}

#[test]
fn a_text_beyond_the_limit_is_not_read() {
    let text = " ".repeat(crate::source::MAX_LENGTH + 1);
    assert_eq!(codes(&text, ed2()), [(Code::LimitExceeded, "")]);
    assert!(lex("x (* a", ed2()).truncated);
}

#[test]
fn hostile_tokens_take_linear_time() {
    let deep = "(*".repeat(500_000);
    assert_eq!(codes(&deep, Dialect::of(DialectName::IRONPLC_ED3)).len(), 1);
    let stars = format!("(*{}", "*".repeat(1_000_000));
    assert_eq!(codes(&stars, ed2()).len(), 1);
    let digits = "9".repeat(1_000_000);
    let kinds: Vec<_> = lex(&digits, ed2())
        .tokens
        .iter()
        .map(|token| token.kind)
        .collect();
    assert_eq!(kinds, [TokenKind::Integer, TokenKind::End]);
    assert!(codes(&"@ ".repeat(100_000), ed2()).len() < 100_000);
}
