//! Literals with a type in front: `INT#-5`, `T#1h30m`, `DT#2024-02-29-12:34:56`, `STRING#'x'`, `COLOR#RED`.

use super::class::{ByteClass, class, is_word};
use super::number::NumberForm;
use super::scan::Lexer;
use crate::token::TokenKind;
use stickler_types::literal::{date, date_and_time, duration, time_of_day, with_seconds};
use stickler_types::{ElementaryType, Family, LiteralError};

/// A reader of `stickler_types`.
type TemporalReader = fn(&str) -> Result<i64, LiteralError>;

impl Lexer<'_, '_> {
    /// Reads on at the `#` behind a word that begins at `start`.
    ///
    /// Basis: Tables 5, 6, 8 and 9 of the third edition; enumerated values: 6.4.4.3.
    pub(super) fn typed_literal(&mut self, start: usize) {
        use Family::{
            BitString, Boolean, Character, Date, DateAndTime, Duration, Real, Signed, Text, TimeOfDay,
            Unsigned,
        };
        let name = self.span_from(start).text(self.text);
        let elementary = ElementaryType::from_literal_prefix(name);
        self.at += 1;
        match (class(self.peek(0)), elementary.map(ElementaryType::family)) {
            (ByteClass::Letter, Some(Boolean)) if self.boolean() => self.push(TokenKind::TypedBoolean, start),
            (ByteClass::Letter, _) => self.enumerated(start, elementary),
            (ByteClass::Quote, Some(Text | Character)) => self.quoted(
                start,
                [TokenKind::TypedSingleByteText, TokenKind::TypedDoubleByteText],
            ),
            (_, Some(Duration)) => self.temporal(start, TokenKind::Duration, duration),
            (_, Some(Date)) => self.temporal(start, TokenKind::Date, date),
            (_, Some(TimeOfDay)) => self.temporal(start, TokenKind::TimeOfDay, time_of_day),
            (_, Some(DateAndTime)) => self.temporal(start, TokenKind::DateAndTime, date_and_time),
            (_, Some(Boolean | Signed | Unsigned | BitString | Real)) => self.typed_number(start),
            (_, Some(Text | Character)) => self.push_malformed(start, || {
                format!("a character string is missing behind `{name}#`")
            }),
            // An enumeration's name, as far as the lexer can know.
            (_, None) => self.misfit(start, name),
        }
    }

    /// Moves over TRUE or FALSE, if one of them stands here.
    fn boolean(&mut self) -> bool {
        let start = self.at;
        self.skip(is_word);
        let word = self.bytes.get(start..self.at).unwrap_or(&[]);
        let known = word.eq_ignore_ascii_case(b"TRUE") || word.eq_ignore_ascii_case(b"FALSE");
        if !known {
            self.at = start;
        }
        known
    }

    /// A name stands here. A type of the third edition may be an enumeration's name where the dialect does not
    /// have it, so only those that every edition has are certain not to be one.
    fn enumerated(&mut self, start: usize, elementary: Option<ElementaryType>) {
        self.skip(is_word);
        match elementary {
            Some(ty) if !ty.is_third_edition() => {
                self.push_malformed(start, || format!("this is no literal of {}", ty.name()));
            }
            _ => self.push(TokenKind::Enumerated, start),
        }
    }

    fn typed_number(&mut self, start: usize) {
        if matches!(self.peek(0), b'+' | b'-') {
            self.at += 1;
        }
        if !self.peek(0).is_ascii_digit() {
            return self.push_malformed(start, || "a number is missing behind `#`".to_owned());
        }
        let form = self.skip_number();
        let kind = match form {
            Ok(NumberForm::Based) => TokenKind::TypedBased,
            Ok(NumberForm::Real) => TokenKind::TypedReal,
            _ => TokenKind::TypedInteger,
        };
        self.finish_number(start, form, kind);
    }

    /// A duration, a date or a time. `read` decides about the form; a value outside the range is not the
    /// lexer's concern.
    fn temporal(&mut self, start: usize, kind: TokenKind, read: TemporalReader) {
        let body = self.at;
        self.skip_temporal(kind);
        let text = self.span_from(body).text(self.text);
        let text = match kind {
            TokenKind::TimeOfDay | TokenKind::DateAndTime if self.dialect.short_times_of_day => {
                with_seconds(text)
            }
            _ => text.into(),
        };
        match read(&text) {
            Err(LiteralError::Malformed { expected, .. }) => {
                self.push_malformed(start, || {
                    format!("{} is malformed: expected {expected}", kind.text())
                });
            }
            _ => self.push(kind, start),
        }
    }

    /// Moves over digits and letters, and over the marks that such a literal has between digits.
    fn skip_temporal(&mut self, kind: TokenKind) {
        if kind == TokenKind::Duration && matches!(self.peek(0), b'+' | b'-') {
            self.at += 1;
        }
        let mut dashes = match kind {
            TokenKind::Date => 2,
            TokenKind::DateAndTime => 3,
            _ => 0,
        };
        loop {
            self.skip(is_word);
            let mark = match self.peek(0) {
                b'.' => kind != TokenKind::Date,
                b':' => matches!(kind, TokenKind::TimeOfDay | TokenKind::DateAndTime),
                b'-' if dashes > 0 => {
                    dashes -= 1;
                    true
                }
                _ => false,
            };
            if !mark || !self.peek(1).is_ascii_digit() {
                return;
            }
            self.at += 1;
        }
    }

    /// A number or a text behind a name that is no elementary type's.
    fn misfit(&mut self, start: usize, name: &str) {
        let quote = self.peek(0);
        if class(quote) == ByteClass::Quote {
            self.skip_quoted(quote);
        } else {
            self.skip(|byte| is_word(byte) || matches!(byte, b'#' | b'-' | b'+'));
        }
        self.push_malformed(start, || {
            format!(
                "behind `{name}#` a value's name is missing; only an elementary type stands before a literal"
            )
        });
    }
}
