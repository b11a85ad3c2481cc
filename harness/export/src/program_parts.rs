//! Splits a case's program into the parts of a page: the POUs and types beside its main program, the variables of
//! that program, and its statements.
//!
//! A case whose program cannot be split is left out of the export, with the reason.

use crate::Reason;
use std::collections::HashSet;
use stickler_syntax::names::{DeclaredKind, declared, separable};
use stickler_syntax::token::{Token, TokenKind};
use stickler_syntax::tree::VariableKind;
use stickler_syntax::{parse, tokens};
use stickler_types::{Dialect, DialectName};

/// The parts of a program. All text is as the case has it, without the marks of the suite.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct ProgramParts {
    /// The text outside the main program: types, functions, function blocks.
    pub(crate) units: String,
    /// The global names of the text, in capitals, without that of the main program.
    pub(crate) unit_names: HashSet<String>,
    /// The declarations of the main program's sections of variables, by section.
    pub(crate) variables: Vec<DeclaredSection>,
    /// The names of the main program's variables, in capitals.
    pub(crate) variable_names: HashSet<String>,
    /// The statements of the main program.
    pub(crate) statements: String,
}

/// A section of variables.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct DeclaredSection {
    /// Whether the variables are constants.
    pub(crate) constant: bool,
    /// The text between the section's keywords.
    pub(crate) text: String,
}

impl ProgramParts {
    /// Splits the program of a case of a dialect.
    ///
    /// # Errors
    /// The [`Reason`] why the program cannot share a page with others.
    pub(crate) fn of(source: &str, dialect: DialectName) -> Result<ProgramParts, Reason> {
        let source = without_marks(source);
        let dialect = Dialect::of(dialect);
        let mut unit_names = separable(&source, dialect, false).ok_or(Reason::Shares)?;
        let main = MainParts::of(&source, &tokens(&source, dialect).list)?;
        // The values of an enumeration that a variable declares in place count among the names of the text, but belong to
        // the program only.
        unit_names.remove(&main.name);
        let (unit, _) = parse(&source, dialect);
        let names = declared(&unit).into_iter();
        let is_of_main = |name: &str| name.eq_ignore_ascii_case(&main.name);
        let variables = names.filter(|one| {
            one.kind == DeclaredKind::Variable(VariableKind::Local)
                && one.inside.is_some_and(|pou| is_of_main(pou.name.text))
        });
        Ok(ProgramParts {
            units: [&source[..main.begins], &source[main.ends..]]
                .map(str::trim)
                .join("\n")
                .trim()
                .to_owned(),
            unit_names,
            variable_names: variables.map(|one| one.name.text.to_ascii_uppercase()).collect(),
            variables: main.sections,
            statements: main.statements,
        })
    }
}

/// The parts of the only program of a text.
struct MainParts {
    /// The name of the program, in capitals.
    name: String,
    begins: usize,
    ends: usize,
    sections: Vec<DeclaredSection>,
    statements: String,
}

impl MainParts {
    fn of(source: &str, tokens: &[Token]) -> Result<MainParts, Reason> {
        let mut tokens = tokens.iter().peekable();
        let begin = tokens.find(|token| token.kind == TokenKind::Program);
        let begin = begin.ok_or(Reason::NoProgram)?;
        let name = tokens.next().ok_or(Reason::NoProgram)?.span;
        let mut sections = Vec::new();
        let mut statements = name.end;
        while let Some(section) = tokens.next_if(|token| token.kind.opens_section()) {
            let constant = tokens.next_if(|token| token.kind == TokenKind::Constant);
            // Retained variables would keep their values from one page to the next.
            let retained = tokens.next_if(|token| {
                matches!(token.kind, TokenKind::Retain | TokenKind::NonRetain)
                    || token.is("PERSISTENT", source)
            });
            if section.kind != TokenKind::Var || retained.is_some() {
                return Err(Reason::Section);
            }
            let end = tokens.find(|token| token.kind == TokenKind::EndVar);
            let end = end.ok_or(Reason::NoProgram)?.span;
            let inside = constant.unwrap_or(section).span.end as usize..end.start as usize;
            sections.push(DeclaredSection {
                constant: constant.is_some(),
                text: source[inside].trim_matches(['\n', '\r']).trim_end().to_owned(),
            });
            statements = end.end;
        }
        let end = tokens.find(|token| matches!(token.kind, TokenKind::Return | TokenKind::EndProgram));
        let end = end.ok_or(Reason::NoProgram)?;
        if end.kind == TokenKind::Return {
            return Err(Reason::Returns);
        }
        if tokens.any(|token| token.kind == TokenKind::Program) {
            return Err(Reason::SeveralPrograms);
        }
        Ok(MainParts {
            name: name.text(source).to_ascii_uppercase(),
            begins: begin.span.start as usize,
            ends: end.span.end as usize,
            sections,
            statements: source[statements as usize..end.span.start as usize]
                .trim()
                .to_owned(),
        })
    }
}

/// Removes the marks of the suite from a text: comments `(*! … *)`, which do not nest.
fn without_marks(source: &str) -> String {
    let mut text = String::with_capacity(source.len());
    let mut rest = source;
    while let Some(at) = rest.find("(*!") {
        let Some(length) = rest[at..].find("*)") else {
            break;
        };
        text.push_str(&rest[..at]);
        rest = &rest[at + length + 2..];
    }
    text.push_str(rest);
    let lines: Vec<&str> = text.lines().map(str::trim_end).collect();
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_program_is_taken_apart() {
        let source = "(*!\ntitle = \"t\"\n*)\nTYPE COLOR : (RED, GREEN); END_TYPE\nFUNCTION f : INT VAR_INPUT x : INT; END_VAR\n\
                      f := x; END_FUNCTION\nPROGRAM main\nVAR CONSTANT\n    k : INT := 3;\nEND_VAR\nVAR\n    a, b : ARRAY[1..2] OF \
                      INT := [1, 2]; c : COLOR;\nEND_VAR\n    a[1] := f(x := b[2]);    (*! ok *)\n    c := RED;\nEND_PROGRAM\n(*! values\n\
                      a[1] = INT#2\n*)\n";
        let parts = ProgramParts::of(source, DialectName::IRONPLC_RUSTY).expect("parts");
        assert!(
            parts.units.starts_with("TYPE COLOR") && parts.units.ends_with("END_FUNCTION"),
            "{}",
            parts.units
        );
        assert_eq!(parts.statements, "a[1] := f(x := b[2]);\n    c := RED;");
        let set = |names: &[&str]| names.iter().map(ToString::to_string).collect::<HashSet<_>>();
        assert_eq!(parts.variable_names, set(&["K", "A", "B", "C"]));
        assert_eq!(parts.unit_names, set(&["COLOR", "RED", "GREEN", "F"]));
        let constant: Vec<bool> = parts.variables.iter().map(|section| section.constant).collect();
        assert_eq!(constant, [true, false]);
    }

    #[test]
    fn a_part_of_a_variable_is_taken_apart_like_any_other_program() {
        let source = "PROGRAM main VAR w : WORD; b : BYTE; END_VAR b := w.%B1; END_PROGRAM";
        let parts = ProgramParts::of(source, DialectName::CODESYS).expect("parts");
        assert_eq!(parts.statements, "b := w.%B1;");
        assert!(parts.unit_names.is_empty());
    }

    #[test]
    fn what_a_page_cannot_hold_is_told_with_its_reason() {
        for (source, reason) in [
            ("FUNCTION f : INT f := 1; END_FUNCTION", Reason::NoProgram),
            (
                "PROGRAM p END_PROGRAM PROGRAM main END_PROGRAM",
                Reason::SeveralPrograms,
            ),
            (
                "PROGRAM main VAR x : BOOL; END_VAR IF x THEN RETURN; END_IF; END_PROGRAM",
                Reason::Returns,
            ),
            (
                "PROGRAM main VAR_TEMP x : BOOL; END_VAR x := TRUE; END_PROGRAM",
                Reason::Section,
            ),
            (
                "PROGRAM main VAR RETAIN x : BOOL; END_VAR x := TRUE; END_PROGRAM",
                Reason::Section,
            ),
            (
                "PROGRAM main VAR x AT %IX0.0 : BOOL; END_VAR END_PROGRAM",
                Reason::Shares,
            ),
            (
                "VAR_GLOBAL x : INT; END_VAR PROGRAM main END_PROGRAM",
                Reason::Shares,
            ),
        ] {
            assert_eq!(
                ProgramParts::of(source, DialectName::IRONPLC_RUSTY),
                Err(reason),
                "{source}"
            );
        }
    }
}
