//! Splits literals into their digits. No limits apply here: the caller decides what fits.
//!
//! Basis: iec-61131-3: Tables 5, 8 and 9 (numeric, duration, date and time literals).

/// A text that is being read from its beginning.
#[derive(Clone, Copy)]
pub(super) struct LiteralScanner<'t> {
    rest: &'t [u8],
}

/// Digits of a base with single underscores between them.
#[derive(Clone, Copy)]
pub(super) struct Digits<'t> {
    spelling: &'t [u8],
}

impl<'t> Digits<'t> {
    /// Returns the value of each digit, the highest first.
    pub(super) fn values(self) -> impl DoubleEndedIterator<Item = u8> + 't {
        let digits = self.spelling.iter().filter(|&&byte| byte != b'_');
        // Every other byte was found to be a digit.
        digits
            .filter_map(|&byte| char::from(byte).to_digit(16))
            .map(|digit| digit as u8)
    }

    /// Returns the number that decimal digits spell, or the greatest of 64 bits if it is greater.
    pub(super) fn saturated(self) -> i64 {
        self.values().fold(0_i64, |number, digit| {
            number.saturating_mul(10).saturating_add(digit.into())
        })
    }
}

impl<'t> LiteralScanner<'t> {
    pub(super) const fn new(text: &'t [u8]) -> LiteralScanner<'t> {
        LiteralScanner { rest: text }
    }

    pub(super) const fn is_at_end(self) -> bool {
        self.rest.is_empty()
    }

    /// Reads one of these bytes and returns it, if it is next.
    pub(super) fn any_of(&mut self, bytes: &[u8]) -> Option<u8> {
        let (&first, rest) = self.rest.split_first()?;
        if !bytes.contains(&first) {
            return None;
        }
        self.rest = rest;
        Some(first)
    }

    /// Reads these bytes, letters in any case, if they are next.
    pub(super) fn word(&mut self, word: &str) -> Option<()> {
        let (here, rest) = self.rest.split_at_checked(word.len())?;
        if !here.eq_ignore_ascii_case(word.as_bytes()) {
            return None;
        }
        self.rest = rest;
        Some(())
    }

    /// Reads all letters that are next.
    pub(super) fn letters(&mut self) -> &'t [u8] {
        let length = self
            .rest
            .iter()
            .take_while(|byte| byte.is_ascii_alphabetic())
            .count();
        let (letters, rest) = self.rest.split_at(length);
        self.rest = rest;
        letters
    }

    /// Reads as many digits of a base as possible, at least one; a single underscore may stand between two.
    pub(super) fn digits(&mut self, base: u32) -> Option<Digits<'t>> {
        let is_digit = |at: usize| {
            let byte = self.rest.get(at);
            byte.is_some_and(|&byte| char::from(byte).is_digit(base))
        };
        let mut length = 0;
        while is_digit(length) || (length > 0 && self.rest.get(length) == Some(&b'_') && is_digit(length + 1))
        {
            length += 1;
        }
        let (spelling, rest) = self.rest.split_at(length);
        if spelling.is_empty() {
            return None;
        }
        self.rest = rest;
        Some(Digits { spelling })
    }

    /// Reads an optional plus or minus; returns whether it was a minus.
    pub(super) fn sign(&mut self) -> bool {
        self.any_of(b"+-") == Some(b'-')
    }
}

/// An integer: an unsigned one in base 2, 8, 10 or 16, or a decimal one behind a sign.
#[derive(Clone, Copy)]
pub(super) struct Integer<'t> {
    pub(super) negative: bool,
    pub(super) base: u32,
    pub(super) digits: Digits<'t>,
}

impl<'t> Integer<'t> {
    /// Reads the longest integer at the current position.
    pub(super) fn read(scanner: &mut LiteralScanner<'t>) -> Option<Integer<'t>> {
        for (prefix, base) in [("16#", 16), ("8#", 8), ("2#", 2)] {
            let mut behind = *scanner;
            // Without digits behind it the prefix is a decimal number and something else.
            if behind.word(prefix).is_some()
                && let Some(digits) = behind.digits(base)
            {
                *scanner = behind;
                return Some(Integer {
                    negative: false,
                    base,
                    digits,
                });
            }
        }
        Integer::read_decimal(scanner)
    }

    /// Reads the longest decimal integer at the current position.
    pub(super) fn read_decimal(scanner: &mut LiteralScanner<'t>) -> Option<Integer<'t>> {
        let mut behind = *scanner;
        let negative = behind.sign();
        let digits = behind.digits(10)?;
        *scanner = behind;
        Some(Integer {
            negative,
            base: 10,
            digits,
        })
    }
}

/// A real number: decimal digits, perhaps with a fraction, perhaps with an exponent.
#[derive(Clone, Copy)]
pub(super) struct Decimal<'t> {
    pub(super) negative: bool,
    pub(super) whole: Digits<'t>,
    pub(super) fraction: Option<Digits<'t>>,
    /// The digits of the exponent, and whether it is negative.
    pub(super) exponent: Option<(bool, Digits<'t>)>,
}

impl<'t> Decimal<'t> {
    /// Reads the longest real number at the current position; with a loose point, either side of the point may be empty.
    pub(super) fn read(scanner: &mut LiteralScanner<'t>, has_loose_point: bool) -> Option<Decimal<'t>> {
        const NONE: Digits<'_> = Digits { spelling: &[] };
        let mut behind = *scanner;
        let negative = behind.sign();
        let whole = behind.digits(10);
        whole.or(has_loose_point.then_some(NONE))?;
        *scanner = behind;
        let fraction = behind.any_of(b".").and_then(|_| behind.digits(10));
        if fraction.is_some() || has_loose_point {
            *scanner = behind;
        }
        whole.or(fraction)?;
        behind = *scanner;
        let exponent = behind.any_of(b"eE").and_then(|_| {
            let negative = behind.sign();
            Some((negative, behind.digits(10)?))
        });
        if exponent.is_some() {
            *scanner = behind;
        }
        Some(Decimal {
            negative,
            whole: whole.unwrap_or(NONE),
            fraction,
            exponent,
        })
    }
}
