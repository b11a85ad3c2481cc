//! Splits a program into words and signs, just enough to know where its main program begins and ends.
//!
//! No grammar takes part, so that the main program is also found in a text that only one compiler accepts.

use std::ops::Range;

/// A word of a program: a keyword or a name; no word of a comment, a text or a number.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Word<'s> {
    /// The word as it is written.
    pub text: &'s str,
    /// The offset of the word, in bytes.
    pub at: usize,
}

impl Word<'_> {
    /// Tells whether the word is this keyword or name, in any case.
    #[must_use]
    pub fn is(&self, name: &str) -> bool {
        self.text.eq_ignore_ascii_case(name)
    }

    /// Returns the offset of the end of the word, in bytes.
    #[must_use]
    pub fn end(&self) -> usize {
        self.at + self.text.len()
    }
}

/// A token of a program; comments are none.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SourceToken<'s> {
    /// A keyword or a name.
    Word(Word<'s>),
    /// Any other character; for a number its first digit, for a text its first quote.
    Sign(u8),
    /// A pragma.
    Pragma,
    /// A comment, a pragma or a text that does not end.
    Unfinished,
}

/// An iterator over the tokens of a program, in order.
pub struct Tokens<'s> {
    source: &'s str,
    at: usize,
}

/// Returns the tokens of a program, in order.
#[must_use]
pub fn tokens(source: &str) -> Tokens<'_> {
    Tokens { source, at: 0 }
}

/// Returns the words of a program, in order.
pub(super) fn words(source: &str) -> impl Iterator<Item = Word<'_>> {
    tokens(source).filter_map(|token| match token {
        SourceToken::Word(word) => Some(word),
        SourceToken::Sign(_) | SourceToken::Pragma | SourceToken::Unfinished => None,
    })
}

impl<'s> Iterator for Tokens<'s> {
    type Item = SourceToken<'s>;

    fn next(&mut self) -> Option<SourceToken<'s>> {
        let bytes = self.source.as_bytes();
        while let Some(&byte) = bytes.get(self.at) {
            let rest = &bytes[self.at..];
            let at = self.at;
            let (length, token) = match byte {
                b'(' if rest.starts_with(b"(*") => skipped(rest, enclosed(rest, 2, b"*)"), None),
                b'/' if rest.starts_with(b"/*") => skipped(rest, enclosed(rest, 2, b"*/"), None),
                // The end of the text ends it as well.
                b'/' if rest.starts_with(b"//") => (enclosed(rest, 2, b"\n").unwrap_or(rest.len()), None),
                b'{' => skipped(rest, enclosed(rest, 1, b"}"), Some(SourceToken::Pragma)),
                b'\'' | b'"' => skipped(rest, quoted(rest, byte), Some(SourceToken::Sign(byte))),
                b'0'..=b'9' => {
                    let length = length(rest, |byte| is_of_a_word(byte) || byte == b'#');
                    (length, Some(SourceToken::Sign(byte)))
                }
                byte if is_of_a_word(byte) => {
                    let length = length(rest, is_of_a_word);
                    let text = &self.source[at..at + length];
                    (length, Some(SourceToken::Word(Word { text, at })))
                }
                byte if byte.is_ascii_whitespace() => (1, None),
                byte => (1, Some(SourceToken::Sign(byte))),
            };
            self.at += length;
            if token.is_some() {
                return token;
            }
        }
        None
    }
}

/// Returns the length of a construct and its token; where the construct does not end, the rest of the text and
/// [`SourceToken::Unfinished`].
fn skipped<'s>(
    rest: &[u8],
    length: Option<usize>,
    token: Option<SourceToken<'s>>,
) -> (usize, Option<SourceToken<'s>>) {
    match length {
        Some(length) => (length, token),
        None => (rest.len(), Some(SourceToken::Unfinished)),
    }
}

fn is_of_a_word(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || byte == b'_'
}

fn length(rest: &[u8], belongs: impl Fn(u8) -> bool) -> usize {
    rest.iter().take_while(|&&byte| belongs(byte)).count()
}

/// Returns the length of a construct that ends with `close`; `None` where that is missing.
fn enclosed(rest: &[u8], open: usize, close: &[u8]) -> Option<usize> {
    let inside = &rest[open.min(rest.len())..];
    let found = inside.windows(close.len()).position(|window| window == close);
    found.map(|found| open + found + close.len())
}

/// Returns the length of a text in quotes, in which `$` escapes the next character; `None` where the text does not end.
fn quoted(rest: &[u8], quote: u8) -> Option<usize> {
    let mut at = 1;
    while let Some(&byte) = rest.get(at) {
        at += match byte {
            b'$' => 2,
            byte if byte == quote => return Some(at + 1),
            _ => 1,
        };
    }
    None
}

/// The place of the main program in a source text: the program that is called `main`, otherwise the first.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct MainProgram {
    /// The name of the program, as it is declared.
    pub(super) name: String,
    /// The range from behind its name, where sections of variables may stand, to before its `END_PROGRAM`.
    pub(super) inside: Range<usize>,
    /// Whether the program may end before its last statement.
    pub(super) returns: bool,
}

/// Finds the main program; `None` where there is none.
pub(super) fn main_program(source: &str) -> Option<MainProgram> {
    let mut words = words(source);
    let mut first = None;
    while let Some(word) = words.next() {
        if word.is("CONFIGURATION") {
            // A program within it is an instance, and no declaration.
            words.find(|word| word.is("END_CONFIGURATION"));
        }
        if !word.is("PROGRAM") {
            continue;
        }
        let Some(program) = program(&mut words) else {
            continue;
        };
        if program.name.eq_ignore_ascii_case("main") {
            return Some(program);
        }
        first = first.or(Some(program));
    }
    first
}

/// Reads the rest of a program after its first word.
fn program<'s>(words: &mut impl Iterator<Item = Word<'s>>) -> Option<MainProgram> {
    let name = words.next()?;
    let mut returns = false;
    let end = words.find(|word| {
        returns |= word.is("RETURN");
        word.is("END_PROGRAM")
    })?;
    Some(MainProgram {
        name: name.text.to_owned(),
        inside: name.end()..end.at,
        returns,
    })
}

/// The place of a program in the configuration that a source text brings; the names are as they are declared.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct OwnConfiguration {
    /// The name of the configuration.
    pub(super) name: String,
    /// The name of the resource in which the program is.
    pub(super) resource: String,
    /// The name of the instance of the program.
    pub(super) instance: String,
}

/// Finds the configuration in which a program has an instance; `None` where there is none.
pub(super) fn own_configuration(source: &str, program: &str) -> Option<OwnConfiguration> {
    let mut words = words(source).skip_while(|word| !word.is("CONFIGURATION")).skip(1);
    let name = words.next()?.text.to_owned();
    let mut resource = None;
    while let Some(word) = words.next() {
        if word.is("RESOURCE") {
            resource = Some(words.next()?.text.to_owned());
        } else if word.is("PROGRAM") {
            let mut instance = words.next()?;
            if instance.is("RETAIN") || instance.is("NON_RETAIN") {
                instance = words.next()?;
            }
            let mut ty = words.next()?;
            if ty.is("WITH") {
                // The task stands between.
                ty = words.nth(1)?;
            }
            if ty.is(program) {
                let (resource, instance) = (resource?, instance.text.to_owned());
                return Some(OwnConfiguration {
                    name,
                    resource,
                    instance,
                });
            }
        }
    }
    None
}

/// Returns the names of the values of an enumeration that is declared as `NAME : (A, B, C)`, in order; `None` where it is not
/// declared so.
pub(super) fn enumeration(source: &str, name: &str) -> Option<Vec<String>> {
    words(source)
        .filter(|word| word.is(name))
        .find_map(|word| values(&source[word.end()..]))
}

fn values(behind_the_name: &str) -> Option<Vec<String>> {
    let list = behind_the_name
        .trim_start()
        .strip_prefix(':')?
        .trim_start()
        .strip_prefix('(')?;
    let (list, _) = list.split_once(')')?;
    // Explicit numbers of the values are not supported.
    let plain = !list.contains(['=', '*', '#']);
    plain.then(|| words(list).map(|word| word.text.to_owned()).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_those_of_the_program_and_of_nothing_else() {
        let source = "a (* b *) 'c $' d' \"e\" // f\n/* g */ {h} 16#FF h2 ä T#1s (* i";
        let found: Vec<&str> = words(source).map(|word| word.text).collect();
        assert_eq!(found, ["a", "h2", "T"]);
        for unfinished in ["'open", "(*", "{", "'$", "/*", "\"$"] {
            assert!(tokens(unfinished).eq([SourceToken::Unfinished]), "{unfinished}");
        }
        assert_eq!(tokens("// the end").count(), 0);
    }

    #[test]
    fn signs_stand_between_words() {
        let found: Vec<SourceToken<'_>> = tokens("a:=5;{p}'t'").collect();
        let word = Word { text: "a", at: 0 };
        let signs = [b':', b'=', b'5', b';'].map(SourceToken::Sign);
        let expected = [
            &[SourceToken::Word(word)],
            &signs[..],
            &[SourceToken::Pragma, SourceToken::Sign(b'\'')],
        ]
        .concat();
        assert_eq!(found, expected);
    }

    #[test]
    fn the_main_program_is_found_wherever_it_stands() {
        let source = "PROGRAM other END_PROGRAM (* PROGRAM main *)\nprogram Main VAR x : INT; END_VAR x := 1;\nend_program";
        let main = main_program(source).unwrap();
        assert_eq!(main.name, "Main");
        assert_eq!(&source[main.inside], " VAR x : INT; END_VAR x := 1;\n");
        assert!(!main.returns);
        let other = main_program("PROGRAM p IF a THEN RETURN; END_IF; END_PROGRAM").unwrap();
        assert_eq!((other.name.as_str(), other.returns), ("p", true));
        for none in [
            "",
            "FUNCTION f : INT END_FUNCTION",
            "PROGRAM",
            "PROGRAM main",
            "'PROGRAM p END_PROGRAM'",
        ] {
            assert_eq!(main_program(none), None, "{none}");
        }
    }

    #[test]
    fn a_configuration_tells_where_the_instance_of_a_program_is() {
        let configuration = "CONFIGURATION Plant VAR_GLOBAL g : INT; END_VAR RESOURCE Station ON PLC\n\
                             TASK t(INTERVAL := T#1s); PROGRAM RETAIN a WITH t : other; PROGRAM b : Main;\n\
                             END_RESOURCE END_CONFIGURATION ";
        let program = "PROGRAM main ; END_PROGRAM ";
        let found = OwnConfiguration {
            name: "Plant".to_owned(),
            resource: "Station".to_owned(),
            instance: "b".to_owned(),
        };
        for source in [
            [configuration, program].concat(),
            [program, configuration].concat(),
        ] {
            assert_eq!(main_program(&source).unwrap().name, "main");
            assert_eq!(own_configuration(&source, "main"), Some(found.clone()));
            assert_eq!(own_configuration(&source, "OTHER").unwrap().instance, "a");
            assert_eq!(own_configuration(&source, "t"), None);
        }
        assert_eq!(own_configuration(program, "main"), None);
    }

    #[test]
    fn the_values_of_an_enumeration_are_told_in_order() {
        let source = "VAR c : COLOR; END_VAR TYPE Color : (RED, Green,\nblue) := Green; END_TYPE";
        assert_eq!(
            enumeration(source, "COLOR"),
            Some(vec!["RED".to_owned(), "Green".to_owned(), "blue".to_owned()])
        );
        assert_eq!(enumeration("TYPE C : (A := 1, B); END_TYPE", "C"), None);
        assert_eq!(enumeration("TYPE C : INT; END_TYPE", "C"), None);
    }
}
