//! Variable sections, and the groups of names in them; also the fields of a structure.

use super::declarations::error_specification;
use super::state::{ParseResult, Parser};
use super::unsupported::INCOMPLETE_LOCATIONS;
use crate::token::TokenKind;
use crate::tree::{
    Initializer, Name, TypeSpecification, TypeSpecificationKind, VariableBlock, VariableGroup, VariableKind,
};

impl<'s> Parser<'s, '_> {
    /// VAR… to END_VAR; `None` for a section that is not implemented.
    pub(super) fn variable_block(&mut self) -> Option<VariableBlock<'s>> {
        let Some(kind) = variable_kind(self.kind()) else {
            self.unsupported_section();
            return None;
        };
        let start = self.bump().span;
        let (constant, retention) = self.qualifiers(kind);
        self.section_end = None;
        let groups = self.variable_groups(TokenKind::EndVar);
        Some(VariableBlock {
            kind,
            constant,
            retention,
            groups,
            span: start.to(self.previous_span()),
        })
    }

    /// CONSTANT, RETAIN, NON_RETAIN and PERSISTENT, in any order.
    ///
    /// Basis: 6.5.2 of the third edition: inputs and outputs may be retained, but are no constants. PERSISTENT
    /// is no word of the standard, but of many compilers.
    fn qualifiers(&mut self, section: VariableKind) -> (bool, Option<&'s str>) {
        use VariableKind::{External, Global, Input, Local, Output};
        let (mut constant, mut retention) = (false, None);
        loop {
            let allowed = match self.kind() {
                TokenKind::Constant => {
                    constant = true;
                    matches!(section, Local | External | Global)
                }
                TokenKind::Retain | TokenKind::NonRetain => {
                    retention = retention.or(Some(self.word()));
                    matches!(section, Local | Input | Output | Global)
                }
                TokenKind::Name if self.names_a_variable() => return (constant, retention),
                TokenKind::Name if self.at_word("PERSISTENT") => {
                    retention = Some(self.word());
                    matches!(section, Local | Global)
                }
                TokenKind::Name if self.unsupported_access() => continue,
                _ => return (constant, retention),
            };
            if !allowed {
                self.expected("a variable's name");
            }
            self.bump();
        }
    }

    /// The next token is a name which a declaration begins with.
    fn names_a_variable(&self) -> bool {
        matches!(self.nth(1), TokenKind::Colon | TokenKind::Comma | TokenKind::At)
    }

    /// Groups up to END_VAR or END_STRUCT.
    pub(super) fn variable_groups(&mut self, closer: TokenKind) -> Vec<VariableGroup<'s>> {
        let mut groups = Vec::new();
        loop {
            match self.kind() {
                kind if kind == closer => {
                    self.bump();
                    return groups;
                }
                TokenKind::Name if closer == TokenKind::EndVar && self.at_statement() => {
                    self.expected("`END_VAR`");
                    return groups;
                }
                TokenKind::Name => groups.push(self.variable_group(closer)),
                TokenKind::At => {
                    self.unsupported_location();
                    self.skip_declaration();
                }
                kind if self.ends_groups(kind) => {
                    self.expected(if closer == TokenKind::EndVar {
                        "`END_VAR`"
                    } else {
                        "`END_STRUCT`"
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

    /// No declaration goes on over a token of this kind, unless it is a keyword that is taken for a name.
    fn ends_groups(&self, kind: TokenKind) -> bool {
        let statement = kind.opens_statement() && !self.names_a_variable();
        statement || kind.ends_statements() || kind.opens_section()
    }

    /// A statement begins here, and no END_VAR follows: it is missing. Where one follows, it is the declaration
    /// that is wrong.
    fn at_statement(&mut self) -> bool {
        use TokenKind::{Assign, Dot, LeftBracket, LeftParen};
        matches!(self.nth(1), Assign | LeftParen | LeftBracket | Dot) && !self.section_goes_on()
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
        let mut group = VariableGroup {
            names: Vec::with_capacity(1),
            location: None,
            specification: error_specification(self.previous_span()),
            initializer: None,
        };
        match self.names_and_type(&mut group, closer) {
            Ok(specification) => {
                self.unsupported_edge();
                group.initializer = self.optional_initializer(&specification);
                group.specification = specification;
            }
            Err(_) => {
                group.specification = error_specification(self.previous_span());
                self.skip_declaration();
            }
        }
        group
    }

    /// `(a : INT; b, c : REAL)` behind the name of a POU, which is wrong there, and has been said to be.
    pub(super) fn parameters_in_parentheses(&mut self) -> VariableBlock<'s> {
        let start = self.bump().span;
        let mut groups = Vec::new();
        while self.kind() == TokenKind::Name {
            self.suppress();
            let mut group = VariableGroup {
                names: Vec::with_capacity(1),
                location: None,
                specification: error_specification(self.previous_span()),
                initializer: None,
            };
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
            group.names.push(self.declared_name("a variable's name")?);
            if !self.eat(TokenKind::Comma) {
                break;
            }
        }
        if self.kind() == TokenKind::At {
            group.location = self.location(&group.names, closer)?;
        }
        if self.kind() == TokenKind::Assign {
            return Err(self.expected("`:` and a type"));
        }
        self.require(TokenKind::Colon)?;
        self.type_specification()
    }

    /// `AT %IX0.0`: the location of one variable of a section. Those that a configuration completes (`%I*`), and those within
    /// structures, are not implemented.
    ///
    /// Basis: Loc_Var_Decl, Located_At and Direct_Variable in Annex A of the third edition.
    fn location(&mut self, names: &[Name<'s>], closer: TokenKind) -> ParseResult<Option<Name<'s>>> {
        if names.len() > 1 {
            return Err(self.expected("`:` and a type"));
        }
        let within = closer != TokenKind::EndVar;
        if within || self.nth(1) != TokenKind::Direct {
            self.unsupported_location();
            return Ok(None);
        }
        let start = self.bump().span;
        let location = Name {
            text: self.word(),
            span: self.token().span,
        };
        if location.text.ends_with('*') {
            self.bump();
            self.unsupported(start.to(location.span), INCOMPLETE_LOCATIONS);
            return Ok(None);
        }
        if !is_location(location.text) {
            return Err(self.expected("a location such as `%IX0.0`"));
        }
        self.bump();
        Ok(Some(location))
    }

    /// `:= initializer`, if it is there, and the `;` behind a declaration. Of a type that is not known nothing
    /// can be initialized.
    pub(super) fn optional_initializer(&mut self, of: &TypeSpecification) -> Option<Initializer<'s>> {
        let read = if self.eat(TokenKind::Assign) {
            self.initializer().map(Some)
        } else {
            Ok(None)
        };
        let read = read.and_then(|initializer| match self.semicolon(TokenKind::Colon) {
            Ok(()) => Ok(initializer),
            Err(broken) => Err(broken),
        });
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

/// The section that a keyword opens; `None` for one that is not implemented.
fn variable_kind(keyword: TokenKind) -> Option<VariableKind> {
    match keyword {
        TokenKind::Var => Some(VariableKind::Local),
        TokenKind::VarTemp => Some(VariableKind::Temporary),
        TokenKind::VarInput => Some(VariableKind::Input),
        TokenKind::VarOutput => Some(VariableKind::Output),
        TokenKind::VarInOut => Some(VariableKind::InOut),
        TokenKind::VarExternal => Some(VariableKind::External),
        TokenKind::VarGlobal => Some(VariableKind::Global),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use crate::parser::testing::{accepted, errors, pou};
    use crate::tree::{TypeSpecificationKind, VariableKind};

    #[test]
    fn sections_have_kinds_and_qualifiers() {
        let unit = accepted(
            "FUNCTION_BLOCK b VAR END_VAR VAR CONSTANT c : INT := 5; END_VAR VAR_INPUT RETAIN i : INT; END_VAR
             VAR_OUTPUT END_VAR VAR_IN_OUT END_VAR VAR_TEMP END_VAR VAR_EXTERNAL CONSTANT END_VAR
             var retain persistent r : INT; end_var END_FUNCTION_BLOCK",
        );
        let blocks: Vec<_> = pou(&unit, 0)
            .blocks
            .iter()
            .map(|block| (block.kind, block.constant, block.retention))
            .collect();
        assert_eq!(
            blocks,
            [
                (VariableKind::Local, false, None),
                (VariableKind::Local, true, None),
                (VariableKind::Input, false, Some("RETAIN")),
                (VariableKind::Output, false, None),
                (VariableKind::InOut, false, None),
                (VariableKind::Temporary, false, None),
                (VariableKind::External, true, None),
                (VariableKind::Local, false, Some("persistent")),
            ]
        );
    }

    #[test]
    fn qualifiers_stand_only_where_the_standard_has_them() {
        assert_eq!(
            errors("FUNCTION f : INT VAR_INPUT CONSTANT x : INT; END_VAR END_FUNCTION").len(),
            1
        );
        assert_eq!(
            errors("FUNCTION f : INT VAR_TEMP RETAIN x : INT; END_VAR END_FUNCTION").len(),
            1
        );
    }

    #[test]
    fn words_that_are_no_keywords_name_variables() {
        let text =
            "PROGRAM p VAR step, class, method, persistent, public : INT; action : INT; ref_to : INT; END_VAR
            step := class + method; action := step; END_PROGRAM";
        assert_eq!(pou(&accepted(text), 0).blocks[0].groups.len(), 3);
    }

    #[test]
    fn a_broken_declaration_keeps_its_names_and_costs_one_error() {
        for declaration in [
            "x : ;",
            "x y : INT;",
            "x := 5;",
            "x : INT = 5;",
            "x : 5;",
            "x, : INT;",
            "x : INT 5;",
            "x : ARRAY[1..] OF INT;",
        ] {
            let text = format!("PROGRAM p VAR\n{declaration}\nz : INT;\nEND_VAR END_PROGRAM");
            assert_eq!(errors(&text).len(), 1, "{declaration}: {:?}", errors(&text));
            let (unit, _) = crate::parse(
                &text,
                stickler_types::Dialect::of(stickler_types::DialectName::IRONPLC_ED2),
            );
            let groups = &pou(&unit, 0).blocks[0].groups;
            assert_eq!(
                (groups.len(), groups[0].names[0].text, groups[1].names[0].text),
                (2, "x", "z"),
                "{declaration}"
            );
        }
    }

    #[test]
    fn a_keyword_is_no_name() {
        let text = "PROGRAM p VAR\n  on : INT;\n  exit : INT;\n  a : INT; END_VAR END_PROGRAM";
        assert_eq!(
            errors(text),
            [
                "2:3 P0002 expected a variable's name, found the keyword `ON`",
                "3:3 P0002 expected a variable's name, found the keyword `EXIT`"
            ]
        );
    }

    #[test]
    fn the_name_of_a_data_type_is_no_name() {
        let text = "PROGRAM p VAR\n  word, left : INT;\n  s : STRUCT dt : INT; END_STRUCT;\n  e : (red, Real);\n  ltime : INT;\nEND_VAR
            word := 1; END_PROGRAM FUNCTION tod : INT tod := 1; END_FUNCTION";
        assert_eq!(
            errors(text),
            [
                "2:3 P0002 expected a variable's name, found the data type `WORD`",
                "3:14 P0002 expected a variable's name, found the data type `DT`",
                "4:13 P0002 expected the name of an enumerated value, found the data type `REAL`",
                "7:45 P0002 expected a name, found the data type `TOD`",
            ]
        );
    }

    #[test]
    fn a_missing_end_var_is_one_error() {
        for rest in [
            "x := 5;\ny := 6;",
            "f(x);",
            "IF a THEN END_IF;",
            "",
            "VAR b : INT; END_VAR",
            "a.b := 3;",
        ] {
            let text = format!("PROGRAM p\nVAR\n  a : INT;\n{rest}\nEND_PROGRAM");
            assert_eq!(errors(&text).len(), 1, "{rest}: {:?}", errors(&text));
        }
    }

    #[test]
    fn a_type_that_could_not_be_read_takes_its_initial_value_along() {
        let (unit, _) = crate::parse(
            "PROGRAM p VAR q : REF_TO INT := REF(x); END_VAR END_PROGRAM",
            stickler_types::Dialect::of(stickler_types::DialectName::IRONPLC_ED3),
        );
        let group = &pou(&unit, 0).blocks[0].groups[0];
        assert!(
            matches!(group.specification.kind, TypeSpecificationKind::Error) && group.initializer.is_none()
        );
    }

    #[test]
    fn a_location_belongs_to_one_variable() {
        let unit = accepted("PROGRAM p VAR x AT %mw5 : INT := 3; y AT %I0.1 : BOOL; END_VAR END_PROGRAM");
        let groups = pou(&unit, 0).blocks[0].groups.iter();
        let locations: Vec<_> = groups
            .map(|group| group.location.map(|location| location.text))
            .collect();
        assert_eq!(locations, [Some("%mw5"), Some("%I0.1")]);
        for declaration in [
            "a, b AT %MW5 : INT;",
            "a AT %MZ5 : INT;",
            "a AT %MW : INT;",
            "a AT %MW5;",
        ] {
            let found = errors(&format!("PROGRAM p VAR {declaration} END_VAR END_PROGRAM"));
            assert!(
                matches!(found.as_slice(), [only] if only.contains("P0002")),
                "{declaration}: {found:?}"
            );
        }
    }
}
