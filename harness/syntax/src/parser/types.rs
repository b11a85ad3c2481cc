//! Types as they are written in declarations.

use super::state::{ParseResult, Parser};
use crate::source::Span;
use crate::token::TokenKind;
use crate::tree::{ExpressionId, Name, TypeSpecification, TypeSpecificationKind as Kind};
use stickler_types::Code;

impl<'s> Parser<'s, '_> {
    /// A type.
    pub(super) fn type_specification(&mut self) -> ParseResult<TypeSpecification<'s>> {
        let start = self.token().span;
        let kind = self.nested(|parser| match parser.kind() {
            TokenKind::Name => parser.named_type(),
            TokenKind::Array => parser.array_type(),
            TokenKind::Struct => parser.structure_type(),
            TokenKind::LeftParen => parser.enumeration_type(None),
            _ => Err(parser.missing("a type")),
        })?;
        Ok(TypeSpecification {
            kind,
            span: start.to(self.previous_span()),
        })
    }

    /// A type that begins with a name.
    fn named_type(&mut self) -> ParseResult<Kind<'s>> {
        if self.unsupported_reference()? {
            return Ok(Kind::Error);
        }
        let name = self.name("a type")?;
        match self.kind() {
            TokenKind::LeftBracket if is_text(&name) => self.text_type(name, TokenKind::RightBracket),
            TokenKind::LeftParen if is_text(&name) => {
                let start = self.token().span;
                let specification = self.text_type(name, TokenKind::RightParen)?;
                let span = start.to(self.previous_span());
                if !self.dialect.lengths_in_parentheses {
                    self.report(Code::ParenStringLengthNotAllowed, span, || {
                        "the length of a string stands in square brackets".to_owned()
                    });
                }
                Ok(specification)
            }
            TokenKind::LeftParen if self.at_enumeration() => self.enumeration_type(Some(name)),
            TokenKind::LeftParen => self.subrange_type(name),
            TokenKind::Dot => {
                self.unsupported_qualified_type(name.span);
                Ok(Kind::Error)
            }
            _ => Ok(Kind::Named(name)),
        }
    }

    /// `STRING[n]`; `closer` closes what stands behind the name.
    fn text_type(&mut self, name: Name<'s>, closer: TokenKind) -> ParseResult<Kind<'s>> {
        self.bump();
        self.open += 1;
        let length = self.expression()?;
        self.require(closer)?;
        self.open -= 1;
        Ok(Kind::Text { name, length })
    }

    /// Behind the parenthesis stands a name, and behind that something else than a limit could have.
    fn at_enumeration(&self) -> bool {
        self.nth(1) == TokenKind::Name
            && matches!(
                self.nth(2),
                TokenKind::Comma | TokenKind::RightParen | TokenKind::Assign
            )
    }

    /// `INT(low..high)`.
    fn subrange_type(&mut self, base: Name<'s>) -> ParseResult<Kind<'s>> {
        self.bump();
        self.open += 1;
        let limits = self.limits()?;
        self.require(TokenKind::RightParen)?;
        self.open -= 1;
        Ok(Kind::Subrange { base, limits })
    }

    /// `low..high`.
    fn limits(&mut self) -> ParseResult<(ExpressionId, ExpressionId)> {
        let low = self.expression()?;
        self.require(TokenKind::DotDot)?;
        Ok((low, self.expression()?))
    }

    /// `(RED, GREEN := 5)`.
    fn enumeration_type(&mut self, base: Option<Name<'s>>) -> ParseResult<Kind<'s>> {
        self.bump();
        self.open += 1;
        let mut values = Vec::new();
        loop {
            let name = self.declared_name("the name of an enumerated value")?;
            let value = if self.eat(TokenKind::Assign) {
                Some(self.expression()?)
            } else {
                None
            };
            values.push((name, value));
            if !self.eat(TokenKind::Comma) {
                break;
            }
        }
        self.require(TokenKind::RightParen)?;
        self.open -= 1;
        Ok(Kind::Enumeration { base, values })
    }

    /// `ARRAY[low..high, …] OF element`.
    fn array_type(&mut self) -> ParseResult<Kind<'s>> {
        let start = self.bump().span;
        self.require(TokenKind::LeftBracket)?;
        self.open += 1;
        let mut dimensions = Vec::with_capacity(1);
        let mut variable_length = None;
        loop {
            if self.kind() == TokenKind::Star {
                variable_length = Some(self.bump().span);
            } else {
                dimensions.push(self.limits()?);
            }
            if !self.eat(TokenKind::Comma) {
                break;
            }
        }
        self.require(TokenKind::RightBracket)?;
        self.open -= 1;
        self.require(TokenKind::Of)?;
        let element = Box::new(self.type_specification()?);
        if let Some(star) = variable_length {
            self.unsupported(start.to(star), "arrays of variable length (`ARRAY[*]`)");
            return Ok(Kind::Error);
        }
        Ok(Kind::Array { dimensions, element })
    }

    /// `STRUCT … END_STRUCT`.
    fn structure_type(&mut self) -> ParseResult<Kind<'s>> {
        self.bump();
        let overlap = self.unsupported_overlap();
        let open = std::mem::take(&mut self.open);
        let fields = self.variable_groups(TokenKind::EndStruct);
        self.open = open;
        Ok(if overlap {
            Kind::Error
        } else {
            Kind::Structure(fields)
        })
    }

    /// Moves over `.name.name` behind a namespace's name.
    fn unsupported_qualified_type(&mut self, start: Span) {
        while self.kind() == TokenKind::Dot && self.nth(1) == TokenKind::Name {
            self.bump();
            self.bump();
        }
        self.unsupported(start.to(self.previous_span()), "names qualified by a namespace");
    }

    /// Moves over a type whose use is not implemented.
    pub(super) fn ignored_type(&mut self) -> ParseResult<()> {
        self.type_specification().map(|_| ())
    }
}

fn is_text(name: &Name) -> bool {
    name.text.eq_ignore_ascii_case("STRING") || name.text.eq_ignore_ascii_case("WSTRING")
}

#[cfg(test)]
mod tests {
    use crate::parser::testing::{errors, shape};

    fn shape_of(specification: &str) -> String {
        shape(&format!("TYPE T : {specification}; END_TYPE"))
    }

    #[test]
    fn each_form_of_a_type_is_read() {
        for (text, form) in [
            ("INT", "Named"),
            ("STRING", "Named"),
            ("wstring[20]", "Text"),
            ("INT(-5..5)", "Subrange"),
            ("INT (LOW..HIGH)", "Subrange"),
            ("(RED, GREEN := 5, BLUE)", "Enumeration"),
            ("INT (RED := 1, GREEN)", "Enumeration"),
            ("INT (RED)", "Enumeration"),
            ("ARRAY[0..3, -1..N + 1] OF ARRAY [1..2] OF STRING[5]", "Array"),
            ("STRUCT a, b : INT; c : REAL := 1.0; END_STRUCT", "Structure"),
            ("STRUCT END_STRUCT", "Structure"),
        ] {
            assert!(
                shape_of(text).contains(&format!("kind: {form}")),
                "{text}: {}",
                shape_of(text)
            );
        }
    }

    #[test]
    fn the_length_of_a_string_stands_in_square_brackets() {
        let found = errors("TYPE T : STRING(10); END_TYPE");
        assert_eq!(
            found,
            ["1:16 P4042 the length of a string stands in square brackets"]
        );
    }

    #[test]
    fn what_is_no_type_is_one_error() {
        for text in [
            "ARRAY[1..2] INT",
            "ARRAY 1..2 OF INT",
            "ARRAY[5] OF INT",
            "()",
            "(5)",
            "INT(1..)",
            "IF",
            "STRING[]",
            "(A, )",
        ] {
            assert_eq!(
                errors(&format!("TYPE T : {text}; U : INT; END_TYPE")).len(),
                1,
                "{text}"
            );
        }
    }

    #[test]
    fn structures_and_arrays_nest_to_the_limit_only() {
        let nested = |depth: usize| format!("TYPE T : {} INT; END_TYPE", "ARRAY[1..2] OF ".repeat(depth));
        assert_eq!(errors(&nested(199)), [""; 0]);
        assert_eq!(errors(&nested(100_000)).len(), 1);
        let open = format!("TYPE T : {}", "STRUCT a : ".repeat(100_000));
        assert_eq!(errors(&open).len(), 1);
    }
}
