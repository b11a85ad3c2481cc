//! Numbers, and what begins with `%`.

use super::class::is_word;
use super::scan::Lexer;
use crate::token::TokenKind;

/// The form of a number.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum NumberForm {
    Integer,
    Based,
    Real,
}

impl Lexer<'_, '_> {
    /// A number without a type in front. Behind a point only an integer is read, so that `a.8.1` is two
    /// suffixes.
    #[inline]
    pub(super) fn number(&mut self) {
        let start = self.at;
        if self.previous() == Some(TokenKind::Dot) {
            self.skip(|byte| byte.is_ascii_digit() || byte == b'_');
            return self.finish_number(start, Ok(NumberForm::Integer), TokenKind::Integer);
        }
        let form = self.skip_number();
        let kind = match form {
            Ok(NumberForm::Based) => TokenKind::Based,
            Ok(NumberForm::Real) => TokenKind::Real,
            _ => TokenKind::Integer,
        };
        self.finish_number(start, form, kind);
    }

    /// Pushes a number, or where letters follow it or its form is wrong, a diagnostic.
    #[inline]
    pub(super) fn finish_number(
        &mut self,
        start: usize,
        form: Result<NumberForm, &'static str>,
        kind: TokenKind,
    ) {
        let trailing = is_word(self.peek(0));
        let reason = match form {
            Ok(_) if !trailing => return self.push(kind, start),
            Ok(NumberForm::Integer) if matches!(self.peek(0), b'e' | b'E') => {
                return self.real_without_point(start);
            }
            Ok(_) => "a literal and a name need something between them",
            Err(reason) => reason,
        };
        self.skip(is_word);
        self.push_malformed(start, || reason.to_owned());
    }

    /// Says how `1E5` is written, and moves over it.
    #[cold]
    fn real_without_point(&mut self, start: usize) {
        let integer = self.span_from(start).text(self.text);
        let exponent = self.at;
        if !self.exponent() || self.at == exponent {
            self.at = exponent;
        }
        self.skip(is_word);
        let exponent = self.span_from(exponent).text(self.text);
        self.push_malformed(start, || {
            format!("a real literal needs a point: `{integer}.0{exponent}`")
        });
    }

    /// Moves over digits and what belongs to them, and says which form of number that was, or what is wrong.
    ///
    /// Basis: Table 5 of the third edition.
    #[inline]
    pub(super) fn skip_number(&mut self) -> Result<NumberForm, &'static str> {
        let first = self.at;
        let mut sound = self.digits();
        match self.peek(0) {
            b'#' => self.based(first),
            b'.' if self.peek(1).is_ascii_digit() => {
                self.at += 1;
                sound &= self.digits();
                sound &= self.exponent();
                if sound {
                    Ok(NumberForm::Real)
                } else {
                    Err(self.wrong_digits(first))
                }
            }
            b'e' | b'E' if sound && self.dialect.reals_without_point => {
                let integer = self.at;
                match self.exponent() {
                    true if self.at > integer => Ok(NumberForm::Real),
                    true => Ok(NumberForm::Integer),
                    false => Err(self.wrong_digits(first)),
                }
            }
            _ if sound => Ok(NumberForm::Integer),
            _ => Err(self.wrong_digits(first)),
        }
    }

    /// Returns what is wrong with the digits of a number that begins at `first`.
    fn wrong_digits(&self, first: usize) -> &'static str {
        match self.bytes[first..self.at].contains(&b'_') {
            true => MISPLACED_UNDERSCORE,
            false => "digits are missing",
        }
    }

    /// Digits with single underscores between them; false where there are others.
    #[inline]
    fn digits(&mut self) -> bool {
        let start = self.at;
        self.skip(|byte| byte.is_ascii_digit());
        if self.peek(0) != b'_' {
            return self.at > start;
        }
        self.skip(|byte| byte.is_ascii_digit() || byte == b'_');
        well_spaced(self.bytes.get(start..self.at).unwrap_or(&[]))
    }

    /// `E5`, `e-5`, `E+05`, or nothing.
    fn exponent(&mut self) -> bool {
        if !matches!(self.peek(0), b'e' | b'E') {
            return true;
        }
        let signed = usize::from(matches!(self.peek(1), b'+' | b'-'));
        if !self.peek(1 + signed).is_ascii_digit() {
            return true; // The letter is what `finish_number` complains about.
        }
        self.at += 1 + signed;
        self.digits()
    }

    /// `#` and the digits behind it; the base begins at `first`.
    fn based(&mut self, first: usize) -> Result<NumberForm, &'static str> {
        let base = match self.bytes.get(first..self.at) {
            Some(b"2") => 2,
            Some(b"8") => 8,
            Some(b"16") => 16,
            _ => 0,
        };
        self.at += 1;
        let start = self.at;
        self.skip(is_word);
        let digits = self.bytes.get(start..self.at).unwrap_or(&[]);
        let known = |byte: &u8| *byte == b'_' || char::from(*byte).is_digit(base);
        match base {
            0 => Err("the base of an integer literal is 2, 8 or 16"),
            _ if digits.is_empty() => Err("digits are missing behind `#`"),
            _ if !digits.iter().all(known) => Err("a digit does not belong to the base"),
            _ if !well_spaced(digits) => Err(MISPLACED_UNDERSCORE),
            _ => Ok(NumberForm::Based),
        }
    }

    /// `%IX0.0`, `%MW5`, `%I*`; behind a point the `%X3` of partial access.
    pub(super) fn percent(&mut self) {
        let start = self.at;
        let dotted = self.previous() == Some(TokenKind::Dot);
        self.at += 1;
        self.skip(|byte| byte.is_ascii_alphabetic());
        let letters = self.at - start - 1;
        self.skip(|byte| byte.is_ascii_digit());
        if dotted {
            return self.partial_access(start, letters);
        }
        while self.peek(0) == b'.' && self.peek(1).is_ascii_digit() {
            self.at += 1;
            self.skip(|byte| byte.is_ascii_digit());
        }
        if self.peek(0) == b'*' && self.at == start + 1 + letters {
            self.at += 1;
        }
        let area = self.bytes.get(start + 1).map(u8::to_ascii_uppercase);
        if matches!(area, Some(b'I' | b'Q' | b'M')) && self.at > start + 2 {
            self.push(TokenKind::Direct, start);
        } else {
            self.push_unknown(start);
        }
    }

    /// Basis: `Multibit_Part_Access` in Annex A of the third edition; a missing letter means X.
    fn partial_access(&mut self, start: usize, letters: usize) {
        let letter = self.bytes.get(start + 1).map(u8::to_ascii_uppercase);
        let known = letters == 0 || letters == 1 && matches!(letter, Some(b'X' | b'B' | b'W' | b'D' | b'L'));
        if known && self.at > start + 1 + letters && !is_word(self.peek(0)) {
            self.push(TokenKind::Partial, start);
        } else {
            self.skip(is_word);
            self.push_unknown(start);
        }
    }
}

const MISPLACED_UNDERSCORE: &str = "an underscore does not stand between two digits";

/// Underscores stand singly and between digits.
fn well_spaced(digits: &[u8]) -> bool {
    let at_an_end = digits.first() == Some(&b'_') || digits.last() == Some(&b'_');
    !at_an_end && !digits.windows(2).any(|pair| pair == b"__")
}
