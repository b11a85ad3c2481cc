//! Splits a program into tokens, without a parser: programs of every dialect, and programs that nobody can read.

/// A token with its place in the text.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct ProgramToken<'t> {
    pub(crate) kind: ProgramTokenKind,
    pub(crate) text: &'t str,
    /// The line, from 1.
    pub(crate) line: u32,
    /// The column, from 1, in characters.
    pub(crate) column: u32,
    /// Whether it is the name of a directly represented variable where that is declared: `x` of `x AT %MW5 : INT;`.
    pub(crate) is_located: bool,
}

/// The kind of a token.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum ProgramTokenKind {
    /// A keyword, the name of a type, or another name.
    Word,
    /// A number without a type: `5`, `16#FF`, `1.0E300`.
    Number,
    /// A literal with a prefix: `INT#5`, `T#5ms`, `STRING#'a'`.
    Typed,
    /// A character string.
    Text,
    /// `%X7` and its like.
    Partial,
    /// An operator or another sign.
    Sign,
}

impl ProgramToken<'_> {
    /// Returns whether the token is this word, in any case of letters.
    pub(crate) fn is(&self, word: &str) -> bool {
        self.text.eq_ignore_ascii_case(word)
    }
}

/// Returns the tokens of a text. Comments and blanks are left out, and locations, so that the type of each variable stands behind its name.
pub(crate) fn tokens(text: &str) -> Vec<ProgramToken<'_>> {
    let mut found = Vec::new();
    let (mut line, mut column) = (1, 1);
    let mut rest = text;
    while !rest.is_empty() {
        let (kind, length) = next(rest);
        let (here, behind) = rest.split_at(length);
        if let Some(kind) = kind {
            found.push(ProgramToken {
                kind,
                text: here,
                line,
                column,
                is_located: false,
            });
            if let [.., name, at, _] = &mut found[..]
                && kind == ProgramTokenKind::Partial
                && at.is("AT")
            {
                name.is_located = true;
                found.truncate(found.len() - 2);
            }
        }
        for character in here.chars() {
            (line, column) = match character {
                '\n' => (line + 1, 1),
                _ => (line, column + 1),
            };
        }
        rest = behind;
    }
    found
}

/// Returns the kind and the length of the token at the start of a text that is not empty; no kind for blanks and comments.
fn next(text: &str) -> (Option<ProgramTokenKind>, usize) {
    let first = text.chars().next().unwrap_or(' ');
    let signs = [":=", "=>", "<=", ">=", "<>", "**", ".."];
    if first.is_whitespace() {
        (None, first.len_utf8())
    } else if let Some(comment) = text.strip_prefix("(*") {
        (None, comment.find("*)").map_or(text.len(), |end| end + 4))
    } else if text.starts_with("//") {
        (None, text.find('\n').unwrap_or(text.len()))
    } else if first == '\'' || first == '"' {
        (Some(ProgramTokenKind::Text), quoted(text, first))
    } else if first.is_ascii_digit() {
        (Some(ProgramTokenKind::Number), number(text))
    } else if first.is_alphabetic() || first == '_' {
        word(text)
    } else if first == '%' {
        (Some(ProgramTokenKind::Partial), location(text))
    } else if let Some(sign) = signs.iter().find(|sign| text.starts_with(**sign)) {
        (Some(ProgramTokenKind::Sign), sign.len())
    } else {
        (Some(ProgramTokenKind::Sign), first.len_utf8())
    }
}

/// Returns the length of a character string with its quotes; it ends with its line at the latest.
fn quoted(text: &str, quote: char) -> usize {
    let mut escaped = false;
    for (at, character) in text.char_indices().skip(1) {
        match character {
            '\n' => return at,
            _ if escaped => escaped = false,
            '$' => escaped = true,
            _ if character == quote => return at + quote.len_utf8(),
            _ => {}
        }
    }
    text.len()
}

/// Returns the length of the letters, digits and underscores at the start.
fn of_words(text: &str) -> usize {
    text.find(|character: char| !character.is_alphanumeric() && character != '_')
        .unwrap_or(text.len())
}

/// Returns the length of a location or a partial access: `%MW5`, `%IX0.0`, `%X7`.
fn location(text: &str) -> usize {
    let mut end = 1 + of_words(&text[1..]);
    let is_location = text[1..].starts_with(['I', 'Q', 'M', 'i', 'q', 'm']);
    while is_location
        && let Some(number) = text[end..].strip_prefix('.')
        && number.starts_with(|digit: char| digit.is_ascii_digit())
    {
        end += 1 + of_words(number);
    }
    end
}

/// Returns the length of a number: digits, with a base, a fraction, an exponent.
fn number(text: &str) -> usize {
    let mut end = of_words(text);
    if text[end..].starts_with('#') {
        return end + 1 + of_words(&text[end + 1..]);
    }
    let digit_behind = |at: usize| text[at..].starts_with(|behind: char| behind.is_ascii_digit());
    if text[end..].starts_with('.') && digit_behind(end + 1) {
        end += 1 + of_words(&text[end + 1..]);
    }
    let is_exponent = text[..end].ends_with(['E', 'e']) && text[end..].starts_with(['+', '-']);
    if is_exponent && digit_behind(end + 1) {
        end += 1 + of_words(&text[end + 1..]);
    }
    end
}

/// Returns the kind and length of a word, or of the typed literal that it begins.
fn word(text: &str) -> (Option<ProgramTokenKind>, usize) {
    let end = of_words(text);
    if !text[end..].starts_with('#') {
        return (Some(ProgramTokenKind::Word), end);
    }
    let value = &text[end + 1..];
    let length = match value.chars().next() {
        Some(quote @ ('\'' | '"')) => quoted(value, quote),
        _ => {
            let sign = usize::from(value.starts_with(['+', '-']));
            let date = ["D", "DATE", "DT", "TOD", "LDATE", "LD", "LDT", "LTOD"];
            let is_date = date.iter().any(|prefix| text[..end].eq_ignore_ascii_case(prefix))
                || text[..end].to_ascii_uppercase().contains("_OF_DAY")
                || text[..end].to_ascii_uppercase().contains("_AND_TIME");
            sign + match is_date {
                true => value[sign..]
                    .find(|character: char| !character.is_alphanumeric() && !"-:._".contains(character))
                    .unwrap_or(value.len() - sign),
                false => number(&value[sign..]),
            }
        }
    };
    (Some(ProgramTokenKind::Typed), end + 1 + length)
}

#[cfg(test)]
mod tests {
    use super::tokens;

    #[test]
    fn tokens_are_told_apart_by_what_they_are() {
        let text = "x:=-1.0E+5**INT#-5 (* c *) ; t := T#1d2h;\n d := D#2024-02-29-y; s:='it$'s';w.%X7:=a[1..2]; 16#FF";
        let found: Vec<&str> = tokens(text).iter().map(|token| token.text).collect();
        assert_eq!(
            found,
            [
                "x",
                ":=",
                "-",
                "1.0E+5",
                "**",
                "INT#-5",
                ";",
                "t",
                ":=",
                "T#1d2h",
                ";",
                "d",
                ":=",
                "D#2024-02-29-y",
                ";",
                "s",
                ":=",
                "'it$'s'",
                ";",
                "w",
                ".",
                "%X7",
                ":=",
                "a",
                "[",
                "1",
                "..",
                "2",
                "]",
                ";",
                "16#FF"
            ]
        );
    }

    #[test]
    fn every_text_is_read_to_its_end_and_places_are_counted_from_one() {
        for text in ["'open", "(* open", "\"$", "x#", "5.", "%", "ä#'", "1.0E-", "T#-"] {
            let length: usize = tokens(text).iter().map(|token| token.text.len()).sum();
            assert!(length == text.len() || text.starts_with("(*"), "{text}");
        }
        let places: Vec<(u32, u32)> = tokens("a\n  ä b").iter().map(|t| (t.line, t.column)).collect();
        assert_eq!(places, [(1, 1), (2, 3), (2, 5)]);
    }

    #[test]
    fn a_location_is_a_mark_of_its_variable() {
        let found = tokens("x AT %IX0.1 : BOOL; y AT %mw5 : INT; z : INT; w.%W1.5 := z");
        let texts: Vec<&str> = found.iter().map(|token| token.text).collect();
        assert_eq!(texts[..8], ["x", ":", "BOOL", ";", "y", ":", "INT", ";"]);
        assert_eq!(texts[12..], ["w", ".", "%W1", ".", "5", ":=", "z"]);
        let located = found.iter().filter(|token| token.is_located);
        assert!(located.map(|token| token.text).eq(["x", "y"]));
    }
}
