//! Constructs of the standard, or of what is often taken for it, that are not implemented: each construct is
//! named in one diagnostic, and reading goes on behind it. The words are no keywords here, so that they remain
//! names where they cannot begin the construct.

use super::declarations::unknown_type;
use super::state::{Broken, ParseResult, Parser};
use crate::source::Span;
use crate::token::TokenKind;
use crate::tree::{Declaration, Name};
use stickler_types::Code;

/// Words that begin an instruction of an instruction list.
const INSTRUCTIONS: [&str; 12] = [
    "LD", "LDN", "ST", "STN", "S", "R", "CAL", "CALC", "CALCN", "RET", "RETC", "RETCN",
];

/// Words that begin an element of a sequential function chart.
const CHART: [&str; 4] = ["STEP", "INITIAL_STEP", "TRANSITION", "ACTION"];

/// The feature that a location such as `%I*` belongs to.
pub(super) const INCOMPLETE_LOCATIONS: &str = "locations that a configuration completes (`%I*`)";

impl<'s> Parser<'s, '_> {
    /// Says that the construct at `span` is not implemented; `features` names its kind in the plural.
    #[cold]
    pub(super) fn unsupported(&mut self, span: Span, features: &str) {
        self.report(Code::NotImplemented, span, || {
            format!("{features} are not implemented")
        });
    }

    fn at_any_word(&self, words: &[&str]) -> bool {
        words.iter().any(|word| self.at_word(word))
    }

    /// CLASS, INTERFACE, NAMESPACE or USING begins a declaration here.
    pub(super) fn at_foreign_declaration(&self) -> bool {
        self.kind() == TokenKind::Name
            && (self.nth(1) == TokenKind::Name
                && self.at_any_word(&["CLASS", "INTERFACE", "NAMESPACE", "USING"])
                || self.at_word("END_NAMESPACE"))
    }

    /// Moves over such a declaration. Of a class or an interface the name is kept; the contents of a namespace
    /// are read as if it were not there.
    pub(super) fn foreign_declaration(&mut self) -> Option<Declaration<'s>> {
        let start = self.token().span;
        if self.at_word("END_NAMESPACE") {
            self.bump();
            self.eat(TokenKind::Semicolon);
            return None;
        }
        if self.at_any_word(&["NAMESPACE", "USING"]) {
            let using = self.at_word("USING");
            self.bump();
            self.qualified_name();
            if using {
                self.eat(TokenKind::Semicolon);
            }
            self.unsupported(start.to(self.previous_span()), "namespaces (NAMESPACE, USING)");
            return None;
        }
        let class = self.at_word("CLASS");
        self.bump();
        while self.nth(1) == TokenKind::Name && self.at_any_word(&["FINAL", "ABSTRACT"]) {
            self.bump();
        }
        let name = Name {
            text: self.word(),
            span: self.bump().span,
        };
        let span = start.to(name.span);
        self.unsupported(
            span,
            if class {
                "classes (CLASS)"
            } else {
                "interfaces (INTERFACE)"
            },
        );
        self.skip_past_word(if class { "END_CLASS" } else { "END_INTERFACE" });
        Some(unknown_type(name))
    }

    fn qualified_name(&mut self) {
        self.bump();
        while self.kind() == TokenKind::Dot && self.nth(1) == TokenKind::Name {
            self.bump();
            self.bump();
        }
    }

    /// FINAL or ABSTRACT in front of a POU's name.
    pub(super) fn unsupported_modifiers(&mut self) {
        while self.nth(1) == TokenKind::Name && self.at_any_word(&["FINAL", "ABSTRACT"]) {
            let span = self.bump().span;
            self.unsupported(span, "object-oriented function blocks (FINAL, ABSTRACT)");
        }
    }

    /// EXTENDS or IMPLEMENTS and the names behind it; says whether there was one.
    pub(super) fn unsupported_inheritance(&mut self) -> bool {
        let start = self.token().span;
        let mut found = false;
        while self.nth(1) == TokenKind::Name && self.at_any_word(&["EXTENDS", "IMPLEMENTS"]) {
            found = true;
            self.bump();
            self.qualified_name();
            while self.kind() == TokenKind::Comma && self.nth(1) == TokenKind::Name {
                self.bump();
                self.qualified_name();
            }
        }
        if found {
            self.incomplete = true;
            self.unsupported(
                start.to(self.previous_span()),
                "inherited types (EXTENDS, IMPLEMENTS)",
            );
        }
        found
    }

    /// VAR_ACCESS or VAR_CONFIG, up to its END_VAR.
    pub(super) fn unsupported_section(&mut self) {
        let token = self.bump();
        let keyword = token.kind.text();
        self.unsupported(token.span, &format!("{keyword} sections"));
        while !self.kind().closes() && !self.kind().opens_section() && !self.kind().opens_declaration() {
            if self.kind() == TokenKind::End {
                return;
            }
            self.bump();
        }
        self.eat(TokenKind::EndVar);
    }

    /// PUBLIC, PRIVATE, PROTECTED or INTERNAL behind a section's keyword.
    pub(super) fn unsupported_access(&mut self) -> bool {
        let found = self.at_any_word(&["PUBLIC", "PRIVATE", "PROTECTED", "INTERNAL"]);
        if found {
            let span = self.bump().span;
            self.unsupported(span, "access specifiers (PUBLIC, PRIVATE, PROTECTED, INTERNAL)");
        }
        found
    }

    /// `AT` and a location where none is implemented: without a name, in a structure, or by the name of a variable.
    pub(super) fn unsupported_location(&mut self) {
        if self.kind() == TokenKind::At {
            let start = self.bump().span;
            if matches!(
                self.kind(),
                TokenKind::Direct | TokenKind::Unknown | TokenKind::Name
            ) {
                self.bump();
            }
            self.unsupported(
                start.to(self.previous_span()),
                "locations (`AT`) of anything but a variable of a section",
            );
        }
    }

    /// R_EDGE or F_EDGE behind the type of an input.
    pub(super) fn unsupported_edge(&mut self) {
        if self.at_any_word(&["R_EDGE", "F_EDGE"]) {
            let span = self.bump().span;
            self.unsupported(span, "edge qualifiers (R_EDGE, F_EDGE)");
        }
    }

    /// OVERLAP behind STRUCT.
    pub(super) fn unsupported_overlap(&mut self) -> bool {
        let found = self.at_word("OVERLAP") && !matches!(self.nth(1), TokenKind::Colon | TokenKind::Comma);
        if found {
            let span = self.bump().span;
            self.unsupported(span, "overlapping structures (STRUCT OVERLAP)");
        }
        found
    }

    /// `REF_TO T`, `POINTER TO T` or `REFERENCE TO T`; says whether there was one.
    pub(super) fn unsupported_reference(&mut self) -> ParseResult<bool> {
        let start = self.token().span;
        let to = usize::from(self.nth(1) == TokenKind::To);
        let words: &[&str] = if to == 1 {
            &["POINTER", "REFERENCE"]
        } else {
            &["REF_TO"]
        };
        let begins_type = matches!(
            self.nth(1 + to),
            TokenKind::Name | TokenKind::Array | TokenKind::LeftParen
        );
        if !begins_type || !self.at_any_word(words) {
            return Ok(false);
        }
        for _ in 0..=to {
            self.bump();
        }
        let end = self.previous_span();
        self.unsupported(
            start.to(end),
            "references and pointers (REF_TO, POINTER TO, REFERENCE TO)",
        );
        self.ignored_type()?;
        Ok(true)
    }

    /// Recognizes what begins with a name, stands where a statement is expected, and is none: an instruction list, an element
    /// of a chart, a method, a jump or a label.
    pub(super) fn unsupported_statement(&mut self) -> ParseResult<()> {
        let next = self.nth(1);
        let start = self.token().span;
        if (next == TokenKind::Name || next == TokenKind::Direct || next.is_literal())
            && self.at_any_word(&INSTRUCTIONS)
            && !(self.at_any_word(&["S", "R"]) && self.nth(2) == TokenKind::Equal)
        {
            self.unsupported(start, "instruction lists");
            self.skip_body();
            return Err(Broken);
        }
        if next == TokenKind::Name && self.at_word("JMP") {
            self.bump();
            self.bump();
            self.unsupported(start.to(self.previous_span()), "jumps and labels (JMP)");
            return Err(Broken);
        }
        if matches!(next, TokenKind::Name | TokenKind::Colon | TokenKind::LeftParen)
            && self.at_any_word(&CHART)
        {
            if next == TokenKind::Colon {
                return self.unsupported_label();
            }
            self.unsupported(start, "sequential function charts (STEP, TRANSITION, ACTION)");
            self.incomplete = true;
            self.skip_body();
            return Err(Broken);
        }
        if next == TokenKind::Name && self.at_word("METHOD") {
            self.unsupported(start, "methods (METHOD)");
            self.incomplete = true;
            self.skip_past_word("END_METHOD");
            return Err(Broken);
        }
        self.unsupported_label()
    }

    /// `label:`, told from a mistaken `:=` by the statement behind it.
    fn unsupported_label(&mut self) -> ParseResult<()> {
        use TokenKind::{Assign, Colon, Dot, LeftBracket, LeftParen, Name, Semicolon};
        let statement = match self.nth(2) {
            Name => matches!(self.nth(3), Assign | LeftParen | LeftBracket | Dot),
            kind => kind == Semicolon || kind.opens_statement(),
        };
        if self.nth(1) != Colon || !statement {
            return Ok(());
        }
        let start = self.bump().span;
        self.bump();
        self.unsupported(start, "jumps and labels (JMP)");
        Err(Broken)
    }

    /// `?=`, `S=`, `R=` or `REF=` behind the variable that begins at `start`.
    pub(super) fn unsupported_assignment(&mut self, start: Span) -> ParseResult<()> {
        let features = match self.kind() {
            TokenKind::AssignAttempt => "assignment attempts (`?=`)",
            TokenKind::Name if self.nth(1) == TokenKind::Equal && self.at_any_word(&["S", "R"]) => {
                "set and reset assignments (`S=`, `R=`)"
            }
            TokenKind::Name if self.nth(1) == TokenKind::Equal && self.at_word("REF") => {
                "references and pointers (`REF=`)"
            }
            _ => return Ok(()),
        };
        self.unsupported(start.to(self.token().span), features);
        Err(Broken)
    }

    /// AND_THEN or OR_ELSE between operands: its precedence.
    pub(super) fn unsupported_operator(&mut self) -> Option<u8> {
        let precedence = if self.at_word("AND_THEN") {
            3
        } else if self.at_word("OR_ELSE") {
            1
        } else {
            return None;
        };
        self.unsupported(self.token().span, "short-circuit operators (AND_THEN, OR_ELSE)");
        Some(precedence)
    }

    /// Arguments behind the type of a program instance.
    pub(super) fn unsupported_connections(&mut self) {
        if self.kind() == TokenKind::LeftParen {
            let start = self.bump().span;
            while !matches!(self.kind(), TokenKind::RightParen | TokenKind::Semicolon)
                && !self.kind().ends_statements()
            {
                self.bump();
            }
            self.eat(TokenKind::RightParen);
            self.unsupported(start.to(self.previous_span()), "connections of program instances");
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::parser::testing::{body_errors, errors};

    /// Exactly one P9999, which names `feature`.
    fn names(text: &str, feature: &str) {
        let errors = errors(text);
        assert!(
            matches!(errors.as_slice(), [only] if only.contains("P9999") && only.contains(feature)),
            "{text}: {errors:?}"
        );
    }

    fn body_names(body: &str, feature: &str) {
        names(&format!("PROGRAM p {body}\nEND_PROGRAM"), feature);
    }

    #[test]
    fn object_orientation_is_named() {
        names(
            "CLASS c VAR x : INT; END_VAR METHOD PUBLIC m : INT m := ; END_METHOD END_CLASS PROGRAM p END_PROGRAM",
            "classes",
        );
        names("CLASS FINAL c EXTENDS d END_CLASS", "classes");
        names("INTERFACE i METHOD m END_METHOD END_INTERFACE", "interfaces");
        names(
            "FUNCTION_BLOCK b EXTENDS c, d.e IMPLEMENTS f VAR x : INT; END_VAR x := 1; END_FUNCTION_BLOCK",
            "EXTENDS",
        );
        names("FUNCTION_BLOCK FINAL b END_FUNCTION_BLOCK", "FINAL");
        names(
            "FUNCTION_BLOCK b METHOD m VAR x : INT; END_VAR x := ; END_METHOD END_FUNCTION_BLOCK",
            "methods",
        );
        names("PROGRAM p VAR PRIVATE x : INT; END_VAR END_PROGRAM", "access");
        names(
            "TYPE t EXTENDS u : STRUCT x : INT; END_STRUCT; END_TYPE",
            "EXTENDS",
        );
    }

    #[test]
    fn namespaces_are_named_and_their_contents_read() {
        names(
            "NAMESPACE a.b FUNCTION f : INT END_FUNCTION END_NAMESPACE",
            "namespaces",
        );
        names("USING a.b; PROGRAM p END_PROGRAM", "namespaces");
        names("PROGRAM p VAR x : a.b; END_VAR END_PROGRAM", "namespace");
        assert_eq!(
            errors("NAMESPACE a PROGRAM p x := ; END_PROGRAM END_NAMESPACE").len(),
            2
        );
    }

    #[test]
    fn references_are_named() {
        for text in [
            "REF_TO INT",
            "POINTER TO ARRAY[1..2] OF INT",
            "REFERENCE TO t",
            "REF_TO REF_TO INT",
        ] {
            let errors = errors(&format!("TYPE t : {text}; END_TYPE"));
            assert!(
                errors.iter().all(|error| error.contains("P9999")) && !errors.is_empty(),
                "{errors:?}"
            );
        }
        names(
            "PROGRAM p VAR q : REF_TO INT := REF(x); END_VAR END_PROGRAM",
            "REF_TO",
        );
        body_names("q^ := 5;", "^");
        body_names("x := q^.a + 1;", "^");
        body_names("a ?= b;", "?=");
        body_names("a REF= b;", "REF=");
    }

    #[test]
    fn located_variables_and_edges_are_named() {
        names("PROGRAM p VAR AT %Q* : BOOL; END_VAR END_PROGRAM", "`AT`");
        names("PROGRAM p VAR AT %QX1 : BOOL; END_VAR END_PROGRAM", "`AT`");
        names("PROGRAM p VAR a : INT; b AT a : INT; END_VAR END_PROGRAM", "`AT`");
        names("PROGRAM p VAR x AT %Q* : BOOL; END_VAR END_PROGRAM", "%I*");
        names(
            "TYPE t : STRUCT a AT %MB0 : BYTE; END_STRUCT; END_TYPE PROGRAM p END_PROGRAM",
            "`AT`",
        );
        body_names("x := %IX0.0 OR y;", "%IX0.0");
        body_names("%QW5 := 1;", "%IX0.0");
        names(
            "FUNCTION_BLOCK b VAR_INPUT c : BOOL R_EDGE; END_VAR END_FUNCTION_BLOCK",
            "R_EDGE",
        );
        names(
            "VAR_ACCESS a : b.c : INT READ_ONLY; END_VAR PROGRAM p END_PROGRAM",
            "VAR_ACCESS",
        );
        names(
            "CONFIGURATION c VAR_CONFIG a.b AT %IX0 : INT; END_VAR END_CONFIGURATION",
            "VAR_CONFIG",
        );
        names(
            "PROGRAM p VAR x : ARRAY[*] OF INT; END_VAR END_PROGRAM",
            "ARRAY[*]",
        );
        names("TYPE t : STRUCT OVERLAP a : INT; END_STRUCT; END_TYPE", "OVERLAP");
    }

    #[test]
    fn other_languages_are_named() {
        body_names("LD x\nADD y\nST z", "instruction lists");
        body_names("LD 5", "instruction lists");
        body_names(
            "INITIAL_STEP start: END_STEP TRANSITION FROM a TO b := x; END_TRANSITION",
            "charts",
        );
        body_names("ACTION a: x := 1; END_ACTION", "charts");
        body_names("JMP l;", "jumps");
        body_names("x := 1;\nl: y := 2;", "jumps");
        body_names("l: IF a THEN END_IF;", "jumps");
        body_names("x S= y;", "S=");
        body_names("r R= y;", "R=");
    }

    #[test]
    fn short_circuit_operators_are_named_once_each() {
        body_names("x := a AND_THEN b;", "AND_THEN");
        body_names("IF a OR_ELSE b THEN x := 1; END_IF;", "OR_ELSE");
        assert_eq!(body_errors("x := a AND_THEN b OR_ELSE c;").len(), 2);
    }
}
