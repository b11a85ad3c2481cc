//! Tests of the lexer on each kind of token.

use super::lex;
use crate::token::TokenKind;
use crate::token::TokenKind::*;
use stickler_types::Code;
use stickler_types::{Dialect, DialectName};

fn ed2() -> &'static Dialect {
    Dialect::of(DialectName::IRONPLC_ED2)
}

fn ed3() -> &'static Dialect {
    Dialect::of(DialectName::IRONPLC_ED3)
}

fn kinds(text: &str) -> Vec<TokenKind> {
    let lexed = lex(text, ed2());
    let mut kinds: Vec<_> = lexed.tokens.iter().map(|token| token.kind).collect();
    assert_eq!(kinds.pop(), Some(End));
    kinds
}

fn texts(text: &str) -> Vec<&str> {
    let lexed = lex(text, ed2());
    let tokens = lexed.tokens.iter().filter(|token| token.kind != End);
    tokens.map(|token| token.span.text(text)).collect()
}

fn codes<'t>(text: &'t str, dialect: &Dialect) -> Vec<(Code, &'t str)> {
    let list = lex(text, dialect).diagnostics.into_list();
    list.iter()
        .map(|diagnostic| (diagnostic.code, diagnostic.span.text(text)))
        .collect()
}

#[test]
fn punctuation_takes_the_longest_match() {
    assert_eq!(
        kinds(":= : = => <> <= < >= > ** * ?= .. . & ^"),
        [
            Assign,
            Colon,
            Equal,
            Arrow,
            NotEqual,
            LessOrEqual,
            Less,
            GreaterOrEqual,
            Greater,
            Power,
            Star,
            AssignAttempt,
            DotDot,
            Dot,
            Ampersand,
            Caret
        ]
    );
}

#[test]
fn numbers_have_three_forms() {
    assert_eq!(
        kinds("0 1_000 16#FF_ff 2#1010 8#17"),
        [Integer, Integer, Based, Based, Based]
    );
    assert_eq!(kinds("1.5 1.0E-3 1_0.2_5e+10"), [Real, Real, Real]);
}

#[test]
fn a_range_is_no_real_number() {
    assert_eq!(kinds("1..9"), [Integer, DotDot, Integer]);
    assert_eq!(kinds("INT#1..INT#9"), [TypedInteger, DotDot, TypedInteger]);
    assert_eq!(kinds("T#1s..T#2s"), [Duration, DotDot, Duration]);
}

#[test]
fn behind_a_point_only_an_integer_is_read() {
    assert_eq!(texts("a.8.1"), ["a", ".", "8", ".", "1"]);
    assert_eq!(texts("a[1].5..7"), ["a", "[", "1", "]", ".", "5", "..", "7"]);
    assert_eq!(
        kinds("a.%X8 b.%b1 c.%5"),
        [Name, Dot, Partial, Name, Dot, Partial, Name, Dot, Partial]
    );
}

#[test]
fn what_is_no_number_is_one_malformed_token() {
    for text in [
        "5abc", "1E5", "1__0", "1_", "1.5E", "1.5_", "16#", "16#G", "2#12", "9#1", "16#F__F", "INT#",
        "INT#x5", "INT#--5",
    ] {
        assert_eq!(kinds(text).first(), Some(&Malformed), "{text}");
        assert_eq!(codes(text, ed2()).len(), 1, "{text}");
    }
}

#[test]
fn literals_may_have_a_type_in_front() {
    assert_eq!(
        kinds("INT#-5 WORD#16#FF byte#2#1010"),
        [TypedInteger, TypedBased, TypedBased]
    );
    assert_eq!(
        kinds("REAL#-1.5E3 BOOL#true BOOL#1"),
        [TypedReal, TypedBoolean, TypedInteger]
    );
    assert_eq!(
        kinds("STRING#'x' WCHAR#\"x\""),
        [TypedSingleByteText, TypedDoubleByteText]
    );
    assert_eq!(kinds("COLOR#RED LDATE#RED"), [Enumerated, Enumerated]);
}

#[test]
fn durations_have_every_form() {
    for text in [
        "T#-1.5ms",
        "t#25h_15m",
        "TIME#5d14h12m18s3.5ms",
        "LT#14.7s",
        "ltime#1us2ns",
        "T#+1s",
    ] {
        assert_eq!(
            (kinds(text).as_slice(), texts(text)),
            ([Duration].as_slice(), vec![text])
        );
    }
    assert_eq!(texts("T#1s-T#500ms"), ["T#1s", "-", "T#500ms"]);
}

#[test]
fn dates_and_times_end_where_their_form_does() {
    assert_eq!(kinds("D#2024-02-29 LDATE#2024-02-29"), [Date, Date]);
    assert_eq!(
        kinds("TOD#12:34:56.789 LTIME_OF_DAY#00:00:00"),
        [TimeOfDay, TimeOfDay]
    );
    assert_eq!(
        kinds("DT#2024-02-29-12:34:56.5 LDT#2024-02-29-12:34:56"),
        [DateAndTime, DateAndTime]
    );
    assert_eq!(
        texts("D#2024-02-29-D#2024-01-01"),
        ["D#2024-02-29", "-", "D#2024-01-01"]
    );
    assert_eq!(texts("TOD#12:34:56: x"), ["TOD#12:34:56", ":", "x"]);
    assert_eq!(kinds("D#2024 T#5 TOD#12 DT#2024-01-01"), [Malformed; 4]);
}

#[test]
fn strings_end_with_their_quote() {
    assert_eq!(
        texts("'a''b' '$'' \"$\"\" '$$'"),
        ["'a'", "'b'", "'$''", "\"$\"\"", "'$$'"]
    );
    assert_eq!(kinds("'' \"\""), [SingleByteText, DoubleByteText]);
}

#[test]
fn a_string_does_not_go_on_over_the_line() {
    assert_eq!(codes("'abc\nx", ed2()), [(Code::UnexpectedToken, "'abc")]);
    assert_eq!(kinds("'abc\nx"), [Malformed, Name]);
    assert_eq!(codes("'abc", ed2()), [(Code::UnexpectedToken, "'abc")]);
    assert_eq!(codes("'a$\n", ed2()), [(Code::UnexpectedToken, "'a$")]);
}

#[test]
fn escapes_are_checked() {
    assert_eq!(codes("'$0A$n$Q'", ed2()), [(Code::InvalidStringEscape, "$")]);
    assert_eq!(codes("\"$000A$0A\"", ed2()), [(Code::InvalidStringEscape, "$")]);
    assert_eq!(codes("'\u{1}'", ed2()), [(Code::UnexpectedToken, "\u{1}")]);
}

#[test]
fn unknown_characters_are_reported_once_a_run() {
    assert_eq!(
        codes("a @@ b ä€\0 # ?", ed2()),
        ["@@", "ä€\0", "#", "?"].map(|run| (Code::UnexpectedToken, run))
    );
    assert_eq!(
        codes("\u{FEFF}a \u{FEFF}", ed2()),
        [(Code::UnexpectedToken, "\u{FEFF}")]
    );
    assert_eq!(codes("a.%Z3 %5 %", ed2()).len(), 3);
}

#[test]
fn bytes_that_are_no_text_are_reported_in_the_same_words_as_by_their_decoder() {
    let (text, diagnostics) = crate::decoding::decode(b"a \xFF\xFE b");
    assert_eq!(lex(&text, ed2()).diagnostics.into_list(), diagnostics);
}

#[test]
fn comments_nest_where_the_dialect_nests_them() {
    assert_eq!(kinds("(* a (* b *) x"), [Name]);
    let nested = lex("(* a (* b *) x *) y", ed3());
    assert_eq!(nested.tokens.len(), 2);
    assert_eq!(codes("(*(* b *) x", ed3()), [(Code::OpenComment, "(*")]);
    assert_eq!(kinds("(*) x *) y (***) z"), [Name, Name]);
}

#[test]
fn an_open_comment_is_reported_where_it_opens() {
    assert_eq!(codes("x (* a\n\n*", ed2()), [(Code::OpenComment, "(*")]);
    assert!(lex("x (* a", ed2()).truncated);
    assert_eq!(codes("{ a", ed2()), [(Code::OpenComment, "{")]);
    assert_eq!(kinds("{ a } b"), [Name]);
}

#[test]
fn other_comments_are_skipped_and_reported_where_they_are_not_enabled() {
    let text = "a // b (* c\nd /* e // f */ g";
    let comments = [
        (Code::CStyleComment, "// b (* c"),
        (Code::CStyleComment, "/* e // f */"),
    ];
    assert_eq!(codes(text, ed2()), comments);
    assert_eq!(kinds(text), [Name, Name, Name]);
    assert_eq!(codes(text, Dialect::of(DialectName::IRONPLC_RUSTY)), []);
}

#[test]
fn direct_variables_are_one_token() {
    assert_eq!(kinds("%IX0.0 %mw5 %Q*"), [Direct, Direct, Direct]);
}

#[test]
fn a_text_beyond_the_limit_is_not_read() {
    let text = " ".repeat(crate::source::MAX_LENGTH + 1);
    assert_eq!(codes(&text, ed2()), [(Code::LimitExceeded, "")]);
}

#[test]
fn hostile_tokens_take_linear_time() {
    let deep = "(*".repeat(500_000);
    assert_eq!(codes(&deep, ed3()).len(), 1);
    let stars = format!("(*{}", "*".repeat(1_000_000));
    assert_eq!(codes(&stars, ed2()).len(), 1);
    let digits = "9".repeat(1_000_000);
    assert_eq!(kinds(&digits), [Integer]);
    assert!(codes(&"@ ".repeat(100_000), ed2()).len() < 100_000);
}
