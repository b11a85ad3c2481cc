//! The top level of a text, and the program organization units.

use super::open::OpenBlock;
use super::state::{ParseResult, Parser};
use crate::source::Span;
use crate::token::TokenKind;
use crate::tree::{
    Declaration, Name, Pou, PouKind, TypeDeclaration, TypeSpecification, TypeSpecificationKind, VariableBlock,
};

impl<'s> Parser<'s, '_> {
    /// All declarations up to the end of the text.
    pub(super) fn source_unit(&mut self) -> Vec<Declaration<'s>> {
        let mut declarations = Vec::new();
        while self.kind() != TokenKind::End {
            let start = self.position();
            if let Some(declaration) = self.declaration() {
                declarations.push(declaration);
            }
            if self.position() == start {
                self.bump();
            }
        }
        declarations
    }

    /// One declaration of the top level; `None` where there is nothing that the tree could hold.
    fn declaration(&mut self) -> Option<Declaration<'s>> {
        match self.kind() {
            TokenKind::Program => self.pou(PouKind::Program),
            TokenKind::Function => self.pou(PouKind::Function),
            TokenKind::FunctionBlock => self.pou(PouKind::FunctionBlock),
            TokenKind::Type => Some(Declaration::Types(self.type_declarations())),
            TokenKind::Configuration => self.configuration().map(Declaration::Configuration),
            TokenKind::VarGlobal => self.variable_block().map(Declaration::Globals),
            TokenKind::VarAccess | TokenKind::VarConfig => {
                self.variable_block();
                None
            }
            kind if kind.opens_section() => {
                self.expected("a declaration (variables other than VAR_GLOBAL stand in a POU)");
                self.variable_block();
                None
            }
            _ if self.at_foreign_declaration() => self.foreign_declaration(),
            _ => {
                self.expected(
                    "a declaration (PROGRAM, FUNCTION, FUNCTION_BLOCK, TYPE, VAR_GLOBAL or CONFIGURATION)",
                );
                self.bump();
                self.skip_to_declaration();
                None
            }
        }
    }

    /// PROGRAM, FUNCTION or FUNCTION_BLOCK. One that has no name is read, but cannot be held by the tree; of a
    /// function block with parts that are not implemented only the name is kept.
    fn pou(&mut self, kind: PouKind) -> Option<Declaration<'s>> {
        let start = self.bump().span;
        self.incomplete = false;
        self.unsupported_modifiers();
        let mut blocks = Vec::new();
        let (name, result) = self.pou_header(kind, &mut blocks);
        while self.at_section() {
            if self.kind() == TokenKind::VarGlobal {
                self.expected("variables of the POU (VAR_GLOBAL stands outside of it)");
            }
            blocks.extend(self.variable_block());
            self.stray_semicolon();
        }
        self.blocks.push(OpenBlock::Pou);
        let body = self.statements();
        self.blocks.clear();
        blocks.append(&mut self.late_sections);
        let end = self.token().span;
        self.close(closer(kind));
        let name = name?;
        if self.incomplete && kind == PouKind::FunctionBlock {
            return Some(unknown_type(name));
        }
        let span = start.to(self.previous_span());
        Some(Declaration::Pou(Pou {
            kind,
            name,
            result,
            blocks,
            body,
            span,
            end,
        }))
    }

    /// The name, and the result type of a function; the third edition lets a function do without. Parameters that
    /// stand in parentheses there, as other languages have them, are taken for inputs.
    fn pou_header(
        &mut self,
        kind: PouKind,
        blocks: &mut Vec<VariableBlock<'s>>,
    ) -> (Option<Name<'s>>, Option<TypeSpecification<'s>>) {
        let Ok(name) = self.declared_name("a name") else {
            self.skip_line();
            return (None, None);
        };
        self.unsupported_inheritance();
        if self.kind() == TokenKind::LeftParen {
            self.expected("variables (parameters stand between VAR_INPUT and END_VAR)");
            blocks.push(self.parameters_in_parentheses());
        }
        let mut result = None;
        if kind == PouKind::Function && self.eat(TokenKind::Colon) {
            result = Some(self.result_type());
        } else if self.kind() == TokenKind::Colon || kind == PouKind::Function && self.stray_result() {
            self.expected(if kind == PouKind::Function {
                "`:`"
            } else {
                "variables, statements or the end"
            });
            result = (kind == PouKind::Function).then(|| error_specification(self.token().span));
            self.skip_line();
        }
        self.stray_semicolon();
        (Some(name), result)
    }

    /// A `;` in front of a variable section, which is no empty statement yet.
    fn stray_semicolon(&mut self) {
        if self.kind() == TokenKind::Semicolon && self.nth(1).opens_section() {
            self.expected("variables, statements or the end");
            self.bump();
        }
    }

    fn result_type(&mut self) -> TypeSpecification<'s> {
        let start = self.token().span;
        self.type_specification().unwrap_or_else(|_| {
            self.skip_line();
            error_specification(start)
        })
    }

    /// A type's name stands where `:` is missing.
    fn stray_result(&self) -> bool {
        use TokenKind::*;
        self.kind() == Name
            && !self.starts_line()
            && !matches!(
                self.nth(1),
                Assign | LeftParen | LeftBracket | Dot | Equal | Caret
            )
    }

    /// TYPE … END_TYPE.
    fn type_declarations(&mut self) -> Vec<TypeDeclaration<'s>> {
        self.bump();
        let mut types = Vec::new();
        loop {
            match self.kind() {
                TokenKind::EndType => {
                    self.bump();
                    return types;
                }
                TokenKind::Name => types.push(self.type_declaration()),
                kind if kind.ends_statements() || kind.opens_section() || kind.opens_block() => {
                    self.expected("`END_TYPE`");
                    if matches!(kind, TokenKind::EndVar | TokenKind::EndStruct) {
                        self.bump();
                    }
                    return types;
                }
                _ => {
                    self.expected("a type's name");
                    if self.bump().kind != TokenKind::Semicolon {
                        self.skip_declaration();
                    }
                }
            }
        }
    }

    /// `name : specification := initializer;`. A name is kept whatever becomes of the rest.
    fn type_declaration(&mut self) -> TypeDeclaration<'s> {
        self.open = 0;
        let name = Name {
            text: self.word(),
            span: self.bump().span,
        };
        let (specification, initializer) = match self.type_of_declaration() {
            Ok(specification) => {
                let initializer = self.optional_initializer(&specification);
                (specification, initializer)
            }
            Err(_) => {
                self.skip_declaration();
                (error_specification(name.span), None)
            }
        };
        TypeDeclaration {
            name,
            specification,
            initializer,
        }
    }

    fn type_of_declaration(&mut self) -> ParseResult<TypeSpecification<'s>> {
        if self.unsupported_inheritance() {
            self.incomplete = false;
            self.require(TokenKind::Colon)?;
            let specification = self.type_specification()?;
            return Ok(error_specification(specification.span));
        }
        self.require(TokenKind::Colon)?;
        self.type_specification()
    }
}

/// The keyword that closes a POU.
fn closer(kind: PouKind) -> TokenKind {
    match kind {
        PouKind::Program => TokenKind::EndProgram,
        PouKind::Function => TokenKind::EndFunction,
        PouKind::FunctionBlock => TokenKind::EndFunctionBlock,
    }
}

/// The type of what could not be read.
pub(super) fn error_specification<'s>(span: Span) -> TypeSpecification<'s> {
    TypeSpecification {
        kind: TypeSpecificationKind::Error,
        span,
    }
}

/// Returns the declaration of a type of which only the name is known.
pub(super) fn unknown_type(name: Name<'_>) -> Declaration<'_> {
    let specification = error_specification(name.span);
    Declaration::Types(vec![TypeDeclaration {
        name,
        specification,
        initializer: None,
    }])
}
