//! The top level of a text, and the program organization units.

use super::state::{OpenBlock, Parser};
use crate::source::Span;
use crate::token::TokenKind;
use crate::tree::{
    Declaration, Name, Pou, PouKind, Statement, TypeDeclaration, TypeSpecification, TypeSpecificationKind,
    VariableBlock,
};
use stickler_types::Code;

impl<'s> Parser<'s, '_> {
    /// All declarations up to the end of the text.
    pub(super) fn source_unit(&mut self) -> Vec<Declaration<'s>> {
        let mut declarations = Vec::new();
        while self.kind() != TokenKind::End {
            let start = self.position();
            if self.at_namespace() {
                self.namespace(&mut declarations);
            } else {
                declarations.extend(self.declaration());
            }
            if self.position() == start {
                self.bump();
            }
        }
        if !self.namespaces.is_empty() {
            self.expected("`END_NAMESPACE`");
        }
        declarations
    }

    /// One declaration of the top level; `None` where there is nothing that the tree could hold.
    fn declaration(&mut self) -> Option<Declaration<'s>> {
        let kind = self.kind();
        if matches!(
            kind,
            TokenKind::Program | TokenKind::Configuration | TokenKind::VarGlobal
        ) && !self.namespaces.is_empty()
        {
            self.expected(
                "`END_NAMESPACE` (a namespace has types, functions, function blocks, classes and interfaces)",
            );
        }
        match kind {
            TokenKind::Program => self.pou(PouKind::Program),
            TokenKind::Function => self.pou(PouKind::Function),
            TokenKind::FunctionBlock => self.pou(PouKind::FunctionBlock),
            TokenKind::Type => Some(Declaration::Types(self.type_declarations())),
            TokenKind::Configuration => self.configuration().map(Declaration::Configuration),
            TokenKind::VarGlobal => self.variable_block().map(Declaration::Globals),
            TokenKind::VarAccess => {
                self.variable_block();
                None
            }
            TokenKind::VarConfig if self.dialect.configured_outside => {
                let span = self.token().span;
                self.unsupported(span, "VAR_CONFIG sections outside of a CONFIGURATION");
                self.variable_block();
                None
            }
            kind if kind.opens_section() => {
                self.expected(match kind {
                    TokenKind::VarConfig => "a declaration (VAR_CONFIG stands in a CONFIGURATION)",
                    _ => "a declaration (variables other than VAR_GLOBAL stand in a POU)",
                });
                self.variable_block();
                None
            }
            _ => {
                if let Some(kind) = self.at_object() {
                    return self.pou(kind);
                }
                if self.at_any_word(&["ACTIONS", "ACTION"]) {
                    self.unsupported(self.token().span, "actions");
                } else {
                    self.expected(
                        "a declaration (PROGRAM, FUNCTION, FUNCTION_BLOCK, TYPE, VAR_GLOBAL or CONFIGURATION)",
                    );
                }
                self.bump();
                self.skip_to_declaration();
                None
            }
        }
    }

    /// PROGRAM, FUNCTION, FUNCTION_BLOCK, CLASS or INTERFACE. One that has no name is read, but cannot be held by the tree; of a
    /// function block with parts that are not implemented only the name is kept.
    fn pou(&mut self, kind: PouKind) -> Option<Declaration<'s>> {
        let start = self.bump().span;
        (self.incomplete, self.refused) = (false, false);
        self.generics.clear();
        self.in_interface = kind == PouKind::Interface;
        match kind {
            PouKind::Class => self.requires("class", start, "CLASS"),
            PouKind::Interface => self.requires("interface", start, "INTERFACE"),
            _ => {}
        }
        let modifiers = self.modifiers();
        let mut blocks = Vec::new();
        let mut using = Vec::new();
        let (name, bases, result) = self.pou_header(kind, &mut using, &mut blocks);
        self.blocks.push(OpenBlock::Pou);
        loop {
            if self.at_member() {
                self.member_declaration();
                continue;
            }
            if !self.at_section() {
                break;
            }
            if self.kind() == TokenKind::VarGlobal {
                self.expected("variables of the POU (VAR_GLOBAL stands outside of it)");
            }
            blocks.extend(self.variable_block());
            self.stray_semicolon();
        }
        let mut body = self.statements();
        self.blocks.clear();
        (self.refused, self.in_interface) = (false, false);
        blocks.append(&mut self.late_sections);
        let members = std::mem::take(&mut self.members);
        self.check_parts(kind, &members, &mut body);
        let end = self.token().span;
        self.close(kind.closer());
        let name = name?;
        if self.incomplete && kind == PouKind::FunctionBlock {
            return Some(unknown_type(name));
        }
        let span = start.to(self.previous_span());
        let [extends, implements] = bases;
        Some(Declaration::Pou(Pou {
            kind,
            modifiers,
            name,
            using,
            extends,
            implements,
            result,
            blocks,
            body,
            members,
            span,
            end,
        }))
    }

    /// The name, and the result type of a function; the third edition lets a function do without. Parameters that
    /// stand in parentheses there, as other languages have them, are taken for inputs.
    fn pou_header(
        &mut self,
        kind: PouKind,
        using: &mut Vec<Name<'s>>,
        blocks: &mut Vec<VariableBlock<'s>>,
    ) -> (
        Option<Name<'s>>,
        [Vec<Name<'s>>; 2],
        Option<TypeSpecification<'s>>,
    ) {
        let Ok(name) = self.declared_name("a name") else {
            self.skip_line();
            return (None, Default::default(), None);
        };
        self.using_in_head(using);
        self.unsupported_generics();
        let bases = [
            self.names_behind("EXTENDS", "extends"),
            self.names_behind("IMPLEMENTS", "implements"),
        ];
        if self.kind() == TokenKind::LeftParen {
            self.expected("variables (parameters stand between VAR_INPUT and END_VAR)");
            blocks.push(self.parameters_in_parentheses());
        }
        let mut result = None;
        if kind == PouKind::Function && self.eat(TokenKind::Colon) {
            result = Some(self.result_type());
        } else if self.kind() == TokenKind::Colon || kind == PouKind::Function && self.stray_result() {
            let is_function = kind == PouKind::Function;
            let what = ["variables, statements or the end", "`:`"][usize::from(is_function)];
            self.expected(what);
            result = is_function.then(|| error_specification(self.token().span));
            self.skip_line();
        }
        self.using_in_head(using);
        self.stray_semicolon();
        (Some(name), bases, result)
    }

    /// Reports statements where the POU has none, and methods where it has none.
    fn check_parts(&mut self, kind: PouKind, members: &[Pou<'s>], body: &mut Vec<Statement>) {
        let has_body = !matches!(kind, PouKind::Class | PouKind::Interface);
        if let (Some(first), false) = (body.first(), has_body) {
            self.report(Code::SyntaxError, first.span, || {
                "a class or interface has methods, and no statements of its own".to_owned()
            });
            body.clear();
        }
        if let (Some(first), PouKind::Function) = (members.first(), kind) {
            self.report(Code::SyntaxError, first.name.span, || {
                "a function has no methods and properties".to_owned()
            });
        }
    }

    /// A `;` in front of a variable section, which is no empty statement yet.
    pub(super) fn stray_semicolon(&mut self) {
        if self.kind() == TokenKind::Semicolon && self.nth(1).opens_section() {
            self.expected("variables, statements or the end");
            self.bump();
        }
    }

    pub(super) fn result_type(&mut self) -> TypeSpecification<'s> {
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
        self.refused = false;
        let extends = self.names_behind("EXTENDS", "structure-extends").first().copied();
        let (specification, initializer) = match self
            .require(TokenKind::Colon)
            .and_then(|_| self.type_specification())
        {
            Ok(specification) => {
                if let TypeSpecificationKind::Named(_) | TypeSpecificationKind::Text { .. } =
                    specification.kind
                {
                    self.has("type-alias", name.span, "NAME : TYPE");
                }
                let initializer = self.optional_initializer(&specification);
                if let Some(initializer) = &initializer {
                    self.has("type-initial-value", initializer.span, ":=");
                }
                (specification, initializer)
            }
            Err(_) => {
                self.skip_declaration();
                (error_specification(name.span), None)
            }
        };
        TypeDeclaration {
            name,
            extends,
            specification,
            initializer,
        }
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
        extends: None,
        specification,
        initializer: None,
    }])
}
