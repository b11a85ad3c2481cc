//! Variable sections, and the groups of names in them; also the fields of a structure.

use super::declarations::error_specification;
use super::state::{OpenBlock, ParseResult, Parser};
use crate::token::TokenKind;
use crate::tree::{
    Access, CaseFolded, Edge, Initializer, Name, PointerForm, TypeSpecification, TypeSpecificationKind,
    VariableBlock, VariableGroup, VariableKind,
};
use stickler_types::Code;

impl<'s> Parser<'s, '_> {
    /// VAR… to END_VAR; `None` for a section that is not implemented.
    pub(super) fn variable_block(&mut self) -> Option<VariableBlock<'s>> {
        let misspelt = self.misspelt_section();
        let Some(kind) = misspelt.or_else(|| self.section()) else {
            self.unsupported_section();
            return None;
        };
        let is_constant = misspelt.is_some() && self.at_word("VAR_CONSTANT");
        let start = self.bump().span;
        if kind == VariableKind::Instance {
            match self.blocks.last() {
                Some(OpenBlock::Member) => self.requires("var-inst", start, "VAR_INST"),
                _ => self.report(Code::SyntaxError, start, || {
                    "VAR_INST stands in methods only".to_owned()
                }),
            }
        }
        if kind == VariableKind::Static {
            self.requires("var-stat", start, "VAR_STAT");
        }
        if kind == VariableKind::Configured && !self.blocks.is_empty() {
            self.report(Code::SyntaxError, start, || {
                "VAR_CONFIG stands in a CONFIGURATION".to_owned()
            });
        }
        let (access, constant, retention) = match misspelt {
            Some(_) => (None, is_constant, None),
            None => self.qualifiers(kind),
        };
        self.section_end = None;
        self.names_are_paths = kind == VariableKind::Configured;
        let groups = self.variable_groups(TokenKind::EndVar);
        self.names_are_paths = false;
        Some(VariableBlock {
            kind,
            access,
            constant,
            retention: retention.map(CaseFolded),
            groups,
            span: start.to(self.previous_span()),
        })
    }

    /// The section that the next token opens; `None` for one that is not implemented.
    fn section(&self) -> Option<VariableKind> {
        let kind = self.kind();
        let opens = kind.opens_section();
        opens.then(|| VariableKind::from_word(kind.text())).flatten()
    }

    /// CONSTANT, RETAIN, NON_RETAIN and PERSISTENT, in any order.
    ///
    /// Basis: 6.5.2 of the third edition: inputs and outputs may be retained, but are no constants; codesys-pages:
    /// _cds_vartypes_constant, by which inputs may be. PERSISTENT is no word of the standard, but of many compilers.
    fn qualifiers(&mut self, section: VariableKind) -> (Option<Access>, bool, Option<&'s str>) {
        use VariableKind::{External, Global, InOut, Input, Instance, Local, Output, Static};
        let may_be_constant = match section {
            Local | Instance | Static | External | Global => true,
            Input | InOut => self.dialect.constant_parameters,
            _ => false,
        };
        let (mut access, mut constant, mut retention) = (None, false, None);
        loop {
            let allowed = match self.kind() {
                TokenKind::Constant => !std::mem::replace(&mut constant, true) && may_be_constant,
                TokenKind::Retain | TokenKind::NonRetain => {
                    let is_new = retention.is_none_or(|known: &str| known.eq_ignore_ascii_case("PERSISTENT"));
                    retention = retention.or(Some(self.word()));
                    is_new && matches!(section, Local | Instance | Static | Input | Output | Global)
                }
                TokenKind::Name if self.names_a_variable() => return (access, constant, retention),
                TokenKind::Name if self.at_word("PERSISTENT") => {
                    retention = Some(self.word());
                    matches!(section, Local | Global | Input)
                }
                TokenKind::Name if self.access().is_some() => {
                    let (span, word) = (self.token().span, self.word());
                    self.requires("access-specifier", span, word);
                    std::mem::replace(&mut access, self.access()).is_none()
                }
                _ => return (access, constant, retention),
            };
            if !allowed {
                self.expected("a variable's name");
            }
            self.bump();
        }
    }

    /// The next token is a name which a declaration begins with.
    pub(super) fn names_a_variable(&self) -> bool {
        matches!(self.nth(1), TokenKind::Colon | TokenKind::Comma | TokenKind::At)
    }

    /// Groups up to END_VAR, END_STRUCT or END_UNION, which is a name to the lexer.
    pub(super) fn variable_groups(&mut self, closer: TokenKind) -> Vec<VariableGroup<'s>> {
        use TokenKind::{Assign, Dot, LeftBracket, LeftParen};
        let mut groups = Vec::new();
        loop {
            match self.kind() {
                kind if kind == closer && (kind != TokenKind::Name || self.at_word("END_UNION")) => {
                    self.bump();
                    return groups;
                }
                TokenKind::Name if closer == TokenKind::EndVar && self.at_misspelt_section_end() => {
                    self.expected("`END_VAR`");
                    self.bump();
                    self.eat(TokenKind::Semicolon);
                    return groups;
                }
                // A statement begins here, and no END_VAR follows: it is missing. Where one follows, it is the declaration that is wrong.
                TokenKind::Name
                    if closer == TokenKind::EndVar
                        && matches!(self.nth(1), Assign | LeftParen | LeftBracket | Dot)
                        && !self.section_goes_on() =>
                {
                    self.expected("`END_VAR`");
                    return groups;
                }
                TokenKind::Name => groups.push(self.variable_group(closer)),
                TokenKind::At => {
                    self.unsupported_location();
                    self.skip_declaration();
                }
                // A keyword may be taken for a name.
                kind if kind.opens_statement() && !self.names_a_variable()
                    || kind.ends_statements()
                    || kind.opens_section() =>
                {
                    self.expected(match closer {
                        TokenKind::EndVar => "`END_VAR`",
                        TokenKind::EndStruct => "`END_STRUCT`",
                        _ => "`END_UNION`",
                    });
                    let mistaken = matches!(kind, TokenKind::EndStruct | TokenKind::EndType);
                    if mistaken && closer == TokenKind::EndVar {
                        self.bump();
                    }
                    return groups;
                }
                _ => {
                    self.expected("a variable's name");
                    if self.bump().kind != TokenKind::Semicolon {
                        self.skip_declaration();
                    }
                }
            }
        }
    }

    /// An END_VAR stands ahead. It is looked for once a section, and the answer kept.
    fn section_goes_on(&mut self) -> bool {
        if self.section_end.is_some_and(|end| end >= self.position()) {
            return true;
        }
        let mut ahead = 0;
        let closer = loop {
            let kind = self.far_ahead(ahead);
            if kind.closes() || kind.opens_section() || kind == TokenKind::End {
                break kind;
            }
            ahead += 1;
        };
        let found = closer == TokenKind::EndVar;
        self.section_end = found.then_some(self.position() + ahead);
        found
    }

    /// `a, b : TYPE := initializer;`. The names and the location are kept whatever becomes of the rest.
    fn variable_group(&mut self, closer: TokenKind) -> VariableGroup<'s> {
        self.open = 0;
        let mut group = self.empty_group();
        match self.names_and_type(&mut group, closer) {
            Ok(specification) => {
                group.edge = Edge::from_word(&self.word().to_ascii_uppercase());
                if group.edge.is_some() {
                    self.bump();
                }
                let initializer = self.optional_initializer(&specification);
                group.initializer = group.initializer.take().or(initializer);
                group.specification = specification;
            }
            Err(_) => {
                group.specification = error_specification(self.previous_span());
                self.skip_declaration();
            }
        }
        group
    }

    /// A group of which nothing has been read yet.
    fn empty_group(&self) -> VariableGroup<'s> {
        VariableGroup {
            names: Vec::with_capacity(1),
            location: None,
            specification: error_specification(self.previous_span()),
            edge: None,
            initializer: None,
        }
    }

    /// `(a : INT; b, c : REAL)` behind the name of a POU, which is wrong there, and has been said to be.
    pub(super) fn parameters_in_parentheses(&mut self) -> VariableBlock<'s> {
        let start = self.bump().span;
        let mut groups = Vec::new();
        while self.kind() == TokenKind::Name {
            self.suppress();
            let mut group = self.empty_group();
            let specification = self.names_and_type(&mut group, TokenKind::RightParen);
            let sound = specification.is_ok();
            group.specification = specification.unwrap_or_else(|_| error_specification(self.previous_span()));
            groups.push(group);
            if !sound || !(self.eat(TokenKind::Semicolon) || self.eat(TokenKind::Comma)) {
                break;
            }
        }
        if !self.eat(TokenKind::RightParen) {
            self.skip_line();
        }
        VariableBlock {
            kind: VariableKind::Input,
            access: None,
            constant: false,
            retention: None,
            groups,
            span: start.to(self.previous_span()),
        }
    }

    /// Reads names, location and type; the first two go into the group.
    fn names_and_type(
        &mut self,
        group: &mut VariableGroup<'s>,
        closer: TokenKind,
    ) -> ParseResult<TypeSpecification<'s>> {
        loop {
            let mut name = self.declared_name("a variable's name")?;
            while self.names_are_paths && self.kind() == TokenKind::Dot && self.nth(1) == TokenKind::Name {
                self.bump();
                name.span = name.span.to(self.bump().span);
                name.text = name.span.text(self.text);
            }
            group.names.push(name);
            if !self.eat(TokenKind::Comma) {
                break;
            }
        }
        if self.kind() == TokenKind::At && self.nth(1) == TokenKind::Name && self.dialect.aliases {
            self.bump();
            group.initializer = Some(self.initializer()?);
        } else if self.kind() == TokenKind::At {
            group.location = self.location(&group.names, closer)?;
        }
        if self.kind() == TokenKind::Assign {
            return Err(self.expected("`:` and a type"));
        }
        self.require(TokenKind::Colon)?;
        let mut specification = self.type_specification()?;
        if group.initializer.is_some() {
            let span = specification.span;
            let (form, target) = (PointerForm::ReferenceTo, Box::new(specification));
            let kind = TypeSpecificationKind::Pointer { form, target };
            specification = TypeSpecification { kind, span };
        }
        Ok(specification)
    }

    /// `AT %IX0.0`: the location of one variable of a section, or `AT %I*`, which a VAR_CONFIG completes. Those within structures are not
    /// implemented.
    ///
    /// Basis: Loc_Var_Decl, Located_At, Direct_Variable and Loc_Partly_Var in Annex A of the third edition.
    fn location(&mut self, names: &[Name<'s>], closer: TokenKind) -> ParseResult<Option<Name<'s>>> {
        if names.len() > 1 {
            return Err(self.expected("`:` and a type"));
        }
        let within = closer != TokenKind::EndVar;
        if within || self.nth(1) != TokenKind::Direct {
            self.unsupported_location();
            return Ok(None);
        }
        self.bump();
        let location = Name {
            text: self.word(),
            span: self.token().span,
        };
        let areas = ["%I*", "%Q*", "%M*"];
        let is_incomplete = areas.iter().any(|area| location.is(area)) && !self.names_are_paths;
        if !is_incomplete && !is_location(location.text) {
            return Err(self.expected("a location such as `%IX0.0`"));
        }
        self.bump();
        Ok(Some(location))
    }

    /// `:= initializer`, if it is there, and the `;` behind a declaration. Of a type that is not known nothing
    /// can be initialized.
    pub(super) fn optional_initializer(&mut self, of: &TypeSpecification) -> Option<Initializer<'s>> {
        // What an initial value gives to a reference is a variable, so that both signs mean the same.
        let binds = self.kind() == TokenKind::Name && self.nth(1) == TokenKind::Equal && self.at_word("REF");
        let binds = binds && matches!(of.kind, TypeSpecificationKind::Pointer { .. });
        if binds {
            self.bump();
            self.bump();
        }
        let read = match binds || self.eat(TokenKind::Assign) {
            true => self.initializer().map(Some),
            false => Ok(None),
        };
        use TypeSpecificationKind::{Structure, Union};
        let is_structure = matches!(of.kind, Structure(_) | Union(_));
        if is_structure && self.dialect.ends_without_semicolon && self.kind() == TokenKind::EndType {
            return None;
        }
        let read = read.and_then(|initializer| self.semicolon(TokenKind::Colon).map(|()| initializer));
        let initializer = read.unwrap_or_else(|_| {
            self.skip_declaration();
            None
        });
        initializer.filter(|_| !matches!(of.kind, TypeSpecificationKind::Error))
    }
}

/// Returns whether a text is the location of a directly represented variable: an area, a size where it is more than a bit, and
/// numbers with points between them.
///
/// Basis: Direct_Variable in Annex A of the third edition.
fn is_location(text: &str) -> bool {
    let sized = text.strip_prefix('%').unwrap_or("").to_ascii_uppercase();
    let numbers = sized.trim_start_matches(['I', 'Q', 'M']);
    let letters = sized.len() - numbers.len();
    let numbers = numbers.strip_prefix(['X', 'B', 'W', 'D', 'L']).unwrap_or(numbers);
    letters == 1
        && numbers
            .split('.')
            .all(|number| !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit()))
}
