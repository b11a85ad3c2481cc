//! Types as they are written in declarations.

use super::state::{ParseResult, Parser};
use crate::source::Span;
use crate::token::TokenKind;
use crate::tree::{
    ANY_ARGUMENTS, CaseFolded, ExpressionId, Name, PointerForm, TypeSpecification,
    TypeSpecificationKind as Kind,
};
use stickler_types::Code;

impl<'s> Parser<'s, '_> {
    /// A type.
    pub(super) fn type_specification(&mut self) -> ParseResult<TypeSpecification<'s>> {
        let start = self.token().span;
        let kind = self.nested(|parser| match parser.kind() {
            TokenKind::Name if parser.nth(1) == TokenKind::Name && parser.at_word("UNION") => {
                parser.union_type()
            }
            TokenKind::Name => parser.named_type(),
            TokenKind::DotDot if parser.at_any_arguments() => Ok(parser.any_arguments()),
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
        use TokenKind::{Assign, Comma, RightParen};
        if let Some(form) = self.pointer_form() {
            return self.pointer_type(form);
        }
        if self.at_word("__FPOINTER") && self.nth(1) == TokenKind::Name {
            let word = self.bump().span;
            self.unsupported(word, "pointers to functions (`__FPOINTER`)");
            self.path()?;
            return Ok(Kind::Error);
        }
        let name = self.name("a type")?;
        match self.kind() {
            TokenKind::DotDot if self.at_any_arguments() => Ok(self.any_arguments()),
            _ if self.generics.contains(&CaseFolded(name.text)) => Ok(Kind::Error),
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
            // No limit of a subrange is a name with one of these behind it.
            TokenKind::LeftParen
                if self.nth(1) == TokenKind::Name && matches!(self.nth(2), Comma | RightParen | Assign) =>
            {
                self.enumeration_type(Some(name))
            }
            TokenKind::LeftParen => {
                let limits = self.bracketed(TokenKind::RightParen, Self::limits)?;
                self.has("subrange", name.span.to(self.previous_span()), "TYPE(low..high)");
                Ok(Kind::Subrange { base: name, limits })
            }
            TokenKind::Dot => Ok(self.qualified_type(name.span)),
            _ => Ok(Kind::Named(name)),
        }
    }

    /// Returns whether `...` stands here, which the lexer reads as two tokens.
    fn at_any_arguments(&self) -> bool {
        self.dialect.external_functions && self.nth(1) == TokenKind::Dot
    }

    /// `...`, the type of an input that stands for any number of arguments, perhaps behind the type of each.
    fn any_arguments(&mut self) -> Kind<'s> {
        let span = self.bump().span.to(self.bump().span);
        Kind::Named(Name {
            text: ANY_ARGUMENTS,
            span,
        })
    }

    /// `STRING[n]`; `closer` closes what stands behind the name.
    fn text_type(&mut self, name: Name<'s>, closer: TokenKind) -> ParseResult<Kind<'s>> {
        let length = self.bracketed(closer, Self::expression)?;
        Ok(Kind::Text { name, length })
    }

    /// `low..high`.
    fn limits(&mut self) -> ParseResult<(ExpressionId, ExpressionId)> {
        let low = self.expression()?;
        self.require(TokenKind::DotDot)?;
        Ok((low, self.expression()?))
    }

    /// `(RED, GREEN := 5)`, perhaps with a base type behind it.
    fn enumeration_type(&mut self, base: Option<Name<'s>>) -> ParseResult<Kind<'s>> {
        let start = self.token().span;
        let value = |parser: &mut Self| {
            let name = parser.declared_name("the name of an enumerated value")?;
            Ok((name, parser.optional(TokenKind::Assign, Self::expression)?))
        };
        let values = self.bracketed(TokenKind::RightParen, |parser| parser.list(value))?;
        self.has("enumeration", start.to(self.previous_span()), "(NAME, …)");
        let base = match self.kind() {
            TokenKind::Name if self.dialect.bases_behind_values && base.is_none() => self.name("a type").ok(),
            _ => base,
        };
        Ok(Kind::Enumeration { base, values })
    }

    /// `ARRAY[low..high, …] OF element` or `ARRAY[*, …] OF element`.
    fn array_type(&mut self) -> ParseResult<Kind<'s>> {
        let start = self.bump().span;
        self.require(TokenKind::LeftBracket)?;
        self.open += 1;
        let mut dimensions = Vec::with_capacity(1);
        let mut stars = 0;
        loop {
            if dimensions.is_empty() && self.eat(TokenKind::Star) {
                stars += 1;
            } else if stars > 0 {
                return Err(self.expected("`*`, as for the other dimensions"));
            } else {
                dimensions.push(self.limits()?);
            }
            if !self.eat(TokenKind::Comma) {
                break;
            }
        }
        self.require(TokenKind::RightBracket)?;
        self.open -= 1;
        let has = stars == 0
            || self.has(
                "variable-length-array",
                start.to(self.previous_span()),
                "ARRAY[*]",
            );
        self.require(TokenKind::Of)?;
        let element = Box::new(self.type_specification()?);
        Ok(match stars {
            _ if !has => Kind::Error,
            0 => Kind::Array { dimensions, element },
            dimensions => Kind::VariableLengthArray { dimensions, element },
        })
    }

    /// Returns the form of the reference or pointer type that begins here; `None` where the word is a name like others.
    fn pointer_form(&mut self) -> Option<PointerForm> {
        use TokenKind::{Array, LeftParen, Name, Struct, To};
        let (behind, forms): (usize, &[PointerForm]) = match self.nth(1) {
            To => (2, &[PointerForm::PointerTo, PointerForm::ReferenceTo]),
            _ => (1, &[PointerForm::RefTo]),
        };
        let begins_type = matches!(self.nth(behind), Name | Array | LeftParen | Struct);
        let word = |form: &PointerForm| form.as_str().split(' ').next().unwrap_or_default();
        let mut forms = forms.iter().copied();
        forms.find(|form| begins_type && self.at_word(word(form)))
    }

    /// `REF_TO T`, `POINTER TO T` or `REFERENCE TO T`.
    fn pointer_type(&mut self, form: PointerForm) -> ParseResult<Kind<'s>> {
        let start = self.bump().span;
        self.eat(TokenKind::To);
        let span = start.to(self.previous_span());
        let has = self.has(form.feature(), span, form.as_str());
        let target = Box::new(self.type_specification()?);
        Ok(match has {
            true => Kind::Pointer { form, target },
            false => Kind::Error,
        })
    }

    /// `STRUCT … END_STRUCT`.
    fn structure_type(&mut self) -> ParseResult<Kind<'s>> {
        self.bump();
        let is_field = matches!(self.nth(1), TokenKind::Colon | TokenKind::Comma);
        let overlap = self.at_word("OVERLAP") && !is_field;
        if overlap {
            let word = self.bump().span;
            self.unsupported(word, "overlapping structures (STRUCT OVERLAP)");
        }
        let open = std::mem::take(&mut self.open);
        let fields = self.variable_groups(TokenKind::EndStruct);
        self.open = open;
        Ok(match overlap {
            true => Kind::Error,
            false => Kind::Structure(fields),
        })
    }

    /// `UNION … END_UNION`, an extension of CODESYS and others.
    fn union_type(&mut self) -> ParseResult<Kind<'s>> {
        let word = self.bump().span;
        let has = self.has("union", word, "UNION");
        let open = std::mem::take(&mut self.open);
        let fields = self.variable_groups(TokenKind::Name);
        self.open = open;
        Ok(if has { Kind::Union(fields) } else { Kind::Error })
    }

    /// `.name.name` behind the name of a namespace or a library.
    pub(super) fn qualified_type(&mut self, start: Span) -> Kind<'s> {
        match self.qualified_by(start) {
            Some(name) if self.dialect.library_namespaces || self.has("namespace", name.span, name.text) => {
                Kind::Named(name)
            }
            _ => Kind::Error,
        }
    }
}

fn is_text(name: &Name) -> bool {
    name.text.eq_ignore_ascii_case("STRING") || name.text.eq_ignore_ascii_case("WSTRING")
}
