//! Tokens: what the lexer makes of the text, and the parser reads.

use super::lexer;
use crate::lexer::lex;
use crate::source::{Span, saturating_u32};
use crate::tree::Name;
use stickler_types::Dialect;

/// A token: its kind and where it stands. Its text is a slice of the source.
#[derive(Clone, Copy, Debug)]
pub struct Token {
    /// The kind.
    pub kind: TokenKind,
    /// The place in the text.
    pub span: Span,
}

/// The tokens of a text that no parser need understand.
#[derive(Clone, Debug)]
pub struct Tokens {
    /// The tokens in the order of the text; there is none for the end.
    pub list: Vec<Token>,
    /// Whether the text ends where it seems to: no comment and no pragma is left open.
    pub is_complete: bool,
    /// The comments and pragmas in the order of the text.
    pub comments: Vec<Span>,
}

impl Tokens {
    /// Returns whether a text, of which these are the tokens, has a pragma.
    pub fn has_pragma(&self, text: &str) -> bool {
        self.comments
            .iter()
            .any(|comment| comment.text(text).starts_with('{'))
    }
}

/// Splits a text into its tokens, by the comments that a dialect has. Never fails: what begins no token becomes one of the kind
/// [`TokenKind::Unknown`] or [`TokenKind::Malformed`].
pub fn tokens(text: &str, dialect: &Dialect) -> Tokens {
    let mut lexer = lex(text, dialect);
    lexer.tokens.retain(|token| token.kind != TokenKind::End);
    Tokens {
        is_complete: !lexer.truncated,
        list: lexer.tokens,
        comments: lexer.comments,
    }
}

/// Returns the keywords and names of a text in its order, also those beside the `#` of a literal or an enumerated value; no word
/// of a comment, a character string or a direct variable.
pub fn words<'s>(text: &'s str, dialect: &Dialect) -> impl Iterator<Item = Name<'s>> {
    let tokens = tokens(text, dialect).list.into_iter();
    tokens.flat_map(move |token| {
        let mut start = token.span.start;
        token.span.text(text).split('#').map_while(move |part| {
            let is_word = part.starts_with(|first: char| first.is_ascii_alphabetic() || first == '_')
                && part
                    .bytes()
                    .all(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
            let end = start + saturating_u32(part.len());
            let span = Span { start, end };
            start = end + 1;
            is_word.then_some(Name { text: part, span })
        })
    })
}

impl Token {
    /// Returns whether the token is this word, in any ASCII case.
    pub fn is(&self, word: &str, text: &str) -> bool {
        self.span.text(text).eq_ignore_ascii_case(word)
    }
}

macro_rules! token_kinds {
    ($($group:literal { $($kind:ident = $text:literal,)* })*) => {
        /// The kind of a token. Keywords are those of every edition; the words of constructs that are not
        /// implemented are names to the lexer, so that `step` or `class` can name a variable.
        #[derive(Clone, Copy, PartialEq, Eq, Debug)]
        pub enum TokenKind { $($(#[doc = concat!($group, ": `", $text, "`")] $kind,)*)* }

        impl TokenKind {
            /// Returns the spelling of the kind, or what it is called where its text differs.
            pub const fn text(self) -> &'static str {
                match self { $($(TokenKind::$kind => $text,)*)* }
            }
        }
    };
}

/// The keywords, once: kinds, and the table that the lexer looks words up in.
macro_rules! keywords {
    ($callback:ident) => {
        $callback! {
            And = "AND", Array = "ARRAY", At = "AT", By = "BY", Case = "CASE",
            Configuration = "CONFIGURATION", Constant = "CONSTANT", Do = "DO", Else = "ELSE",
            Elsif = "ELSIF", EndCase = "END_CASE", EndClass = "END_CLASS",
            EndConfiguration = "END_CONFIGURATION", EndFor = "END_FOR", EndFunction = "END_FUNCTION",
            EndFunctionBlock = "END_FUNCTION_BLOCK", EndGet = "END_GET", EndIf = "END_IF",
            EndInterface = "END_INTERFACE", EndMethod = "END_METHOD", EndProgram = "END_PROGRAM",
            EndProperty = "END_PROPERTY", EndRepeat = "END_REPEAT", EndResource = "END_RESOURCE",
            EndSet = "END_SET", EndStruct = "END_STRUCT", EndType = "END_TYPE",
            EndVar = "END_VAR", EndWhile = "END_WHILE", Exit = "EXIT", False = "FALSE", For = "FOR",
            Function = "FUNCTION", FunctionBlock = "FUNCTION_BLOCK", If = "IF", Mod = "MOD",
            NonRetain = "NON_RETAIN", Not = "NOT", Of = "OF", On = "ON", Or = "OR",
            Program = "PROGRAM", Repeat = "REPEAT", Resource = "RESOURCE", Retain = "RETAIN",
            Return = "RETURN", Struct = "STRUCT", Task = "TASK", Then = "THEN", To = "TO",
            True = "TRUE", Type = "TYPE", Until = "UNTIL", Var = "VAR", VarAccess = "VAR_ACCESS",
            VarConfig = "VAR_CONFIG", VarExternal = "VAR_EXTERNAL", VarGlobal = "VAR_GLOBAL",
            VarInOut = "VAR_IN_OUT", VarInput = "VAR_INPUT", VarInst = "VAR_INST", VarOutput = "VAR_OUTPUT", VarStat = "VAR_STAT",
            VarTemp = "VAR_TEMP", While = "WHILE", With = "WITH", Xor = "XOR",
        }
    };
}
pub(crate) use keywords;

macro_rules! with_keywords {
    ($($kind:ident = $text:literal,)*) => {
        token_kinds! {
            "keyword" { $($kind = $text,)* }
            "punctuation" {
                Assign = ":=", Arrow = "=>", AssignAttempt = "?=", Colon = ":", Semicolon = ";",
                Comma = ",", LeftParen = "(", RightParen = ")", LeftBracket = "[", RightBracket = "]",
                Dot = ".", DotDot = "..", Caret = "^", Plus = "+", Minus = "-", Star = "*",
                Power = "**", Slash = "/", Equal = "=", NotEqual = "<>", Less = "<",
                LessOrEqual = "<=", Greater = ">", GreaterOrEqual = ">=", Ampersand = "&",
            }
            "word" { Name = "a name", Enumerated = "an enumerated value", }
            "literal" {
                Integer = "an integer", Based = "a based integer", Real = "a real number",
                SingleByteText = "a character string", DoubleByteText = "a double-byte character string",
                TypedInteger = "a typed integer", TypedBased = "a typed based integer",
                TypedReal = "a typed real number", TypedBoolean = "a typed Boolean",
                TypedSingleByteText = "a typed character string",
                TypedDoubleByteText = "a typed double-byte character string", Duration = "a duration",
                Date = "a date", TimeOfDay = "a time of day", DateAndTime = "a date and time",
            }
            "suffix" { Partial = "a partial access", Direct = "a direct variable", }
            "other" {
                Malformed = "a malformed literal", Unknown = "an unknown character",
                End = "the end of the text",
            }
        }
    };
}
keywords!(with_keywords);

impl TokenKind {
    /// Returns the kind of a word: a keyword in any ASCII case, or a name.
    pub fn of_word(word: &str) -> TokenKind {
        crate::keyword::classify(word.as_bytes())
    }

    /// The keywords come first in the enumeration.
    pub const fn is_keyword(self) -> bool {
        (self as u8) < (TokenKind::Assign as u8)
    }

    /// The lexer has already said that this token is wrong.
    pub const fn is_reported(self) -> bool {
        matches!(self, TokenKind::Malformed | TokenKind::Unknown)
    }

    /// Every form of literal, and what stands for one that could not be read.
    pub const fn is_literal(self) -> bool {
        use TokenKind::*;
        matches!(self, True | False | Malformed)
            || (self as u8 >= Integer as u8 && self as u8 <= DateAndTime as u8)
    }

    /// The keyword opens a variable section.
    pub const fn opens_section(self) -> bool {
        use TokenKind::*;
        matches!(
            self,
            Var | VarInput
                | VarOutput
                | VarInOut
                | VarInst
                | VarStat
                | VarTemp
                | VarExternal
                | VarGlobal
                | VarAccess
                | VarConfig
        )
    }

    /// The keyword opens a declaration at the top level.
    pub const fn opens_declaration(self) -> bool {
        use TokenKind::*;
        matches!(
            self,
            Program | Function | FunctionBlock | Type | Configuration | VarGlobal
        )
    }

    /// The keyword begins a statement.
    pub const fn opens_statement(self) -> bool {
        use TokenKind::*;
        matches!(self, If | Case | For | While | Repeat | Exit | Return)
    }

    /// The keyword begins a statement that an END_… closes.
    pub const fn opens_block(self) -> bool {
        use TokenKind::*;
        matches!(self, If | Case | For | While | Repeat)
    }

    /// The keyword closes a statement.
    pub const fn closes_block(self) -> bool {
        use TokenKind::*;
        matches!(self, EndIf | EndCase | EndFor | EndWhile | EndRepeat)
    }

    /// The keyword closes a POU.
    pub const fn closes_pou(self) -> bool {
        use TokenKind::*;
        matches!(
            self,
            EndProgram | EndFunction | EndFunctionBlock | EndClass | EndInterface
        )
    }

    /// The keyword closes a method, a property, or a part of one.
    pub const fn closes_member(self) -> bool {
        use TokenKind::*;
        matches!(self, EndMethod | EndProperty | EndGet | EndSet)
    }

    /// The keyword closes anything at all.
    pub const fn closes(self) -> bool {
        use TokenKind::*;
        self.closes_block()
            || self.closes_pou()
            || self.closes_member()
            || matches!(
                self,
                EndVar | EndStruct | EndType | EndConfiguration | EndResource
            )
    }

    /// No list of statements goes on over this token.
    pub const fn ends_statements(self) -> bool {
        use TokenKind::*;
        self.closes() || self.opens_declaration() || matches!(self, Else | Elsif | Until | End | Resource)
    }
}

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
    fn a_text_that_no_dialect_reads_has_tokens() {
        let text = "x ^:= 'a' \u{e4}; (* PROGRAM *) {p} T#1s";
        let dialect = Dialect::of(DialectName::IRONPLC_ED2);
        let found_tokens = tokens(text, dialect);
        let list = &found_tokens.list;
        let found: Vec<&str> = list.iter().map(|token| token.span.text(text)).collect();
        assert_eq!(found, ["x", "^", ":=", "'a'", "\u{e4}", ";", "T#1s"]);
        assert!(found_tokens.is_complete && found_tokens.has_pragma(text) && list[0].is("X", text));
        assert_eq!(found_tokens.comments[0].text(text), "(* PROGRAM *)");
        let literals =
            "a (* b *) 'c $' d' \"e\" // f\n/* g */ {h} 16#FF h2 \u{e4} T#1s COLOR#red SUB#5 x.%X0 %IX1";
        let found: Vec<&str> = words(literals, dialect).map(|word| word.text).collect();
        assert_eq!(found, ["a", "h2", "T", "COLOR", "red", "SUB", "x"]);
        for open in ["(* a", "{ a"] {
            assert!(!tokens(open, dialect).is_complete, "{open}");
        }
    }

    #[test]
    fn comments_and_blanks_behind_the_last_token_do_not_matter() {
        let dialect = Dialect::of(DialectName::IRONPLC_ED2);
        assert_eq!(last_token("a b (* c *)\n", dialect), Span { start: 2, end: 3 });
        assert_eq!(last_token("(* c *)", dialect), Span::default());
    }
}
