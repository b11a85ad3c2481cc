//! Splits a program into parts that can be joined with those of others: the POUs and types beside its main program, the
//! variables of that program, and its statements.

use crate::names::{DeclaredKind, declared, separable};
use crate::token::{Token, TokenKind};
use crate::tree::VariableKind;
use crate::{parse, tokens};
use std::collections::HashSet;
use stickler_types::Dialect;

/// The reason for which a program cannot be joined with others.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Indivisible {
    /// The program shares variables with a configuration or with the machine, or is incomplete.
    Shares,
    /// The text has no program.
    NoProgram,
    /// The text has several programs.
    SeveralPrograms,
    /// The program may end before its last statement.
    Returns,
    /// The program has a section of variables that several programs cannot share.
    Section,
}

/// The parts of a program; all text is as the program has it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ProgramParts {
    /// The text outside the main program: types, functions, function blocks.
    pub units: String,
    /// The global names of the text, in capitals, without that of the main program.
    pub unit_names: HashSet<String>,
    /// The declarations of the main program's sections of variables, by section.
    pub variables: Vec<DeclaredSection>,
    /// The names of the main program's variables, in capitals.
    pub variable_names: HashSet<String>,
    /// The statements of the main program.
    pub statements: String,
}

/// A section of variables.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct DeclaredSection {
    /// Whether the variables are constants.
    pub constant: bool,
    /// The text between the section's keywords.
    pub text: String,
}

impl ProgramParts {
    /// Splits a program.
    ///
    /// # Errors
    /// The [`Indivisible`] reason why the program cannot be joined with others.
    pub fn of(source: &str, dialect: &Dialect) -> Result<ProgramParts, Indivisible> {
        let mut unit_names = separable(source, dialect, false).ok_or(Indivisible::Shares)?;
        let main = MainParts::of(source, &tokens(source, dialect).list)?;
        // The values of an enumeration that a variable declares in place count among the names of the text, but belong to
        // the program only.
        unit_names.remove(&main.name);
        let (unit, _) = parse(source, dialect);
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
    fn of(source: &str, tokens: &[Token]) -> Result<MainParts, Indivisible> {
        let mut tokens = tokens.iter().peekable();
        let begin = tokens.find(|token| token.kind == TokenKind::Program);
        let begin = begin.ok_or(Indivisible::NoProgram)?;
        let name = tokens.next().ok_or(Indivisible::NoProgram)?.span;
        let mut sections = Vec::new();
        let mut statements = name.end;
        while let Some(section) = tokens.next_if(|token| token.kind.opens_section()) {
            let constant = tokens.next_if(|token| token.kind == TokenKind::Constant);
            // Retained variables would keep their values from one run to the next.
            let retained = tokens.next_if(|token| {
                matches!(token.kind, TokenKind::Retain | TokenKind::NonRetain)
                    || token.is("PERSISTENT", source)
            });
            if section.kind != TokenKind::Var || retained.is_some() {
                return Err(Indivisible::Section);
            }
            let end = tokens.find(|token| token.kind == TokenKind::EndVar);
            let end = end.ok_or(Indivisible::NoProgram)?.span;
            let inside = constant.unwrap_or(section).span.end as usize..end.start as usize;
            sections.push(DeclaredSection {
                constant: constant.is_some(),
                text: source[inside].trim_matches(['\n', '\r']).trim_end().to_owned(),
            });
            statements = end.end;
        }
        let end = tokens.find(|token| matches!(token.kind, TokenKind::Return | TokenKind::EndProgram));
        let end = end.ok_or(Indivisible::NoProgram)?;
        if end.kind == TokenKind::Return {
            return Err(Indivisible::Returns);
        }
        if tokens.any(|token| token.kind == TokenKind::Program) {
            return Err(Indivisible::SeveralPrograms);
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

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_mdtest::assert_fits;
    use stickler_types::DialectName;

    #[test]
    fn a_program_is_taken_apart() {
        let source = "TYPE COLOR : (RED, GREEN); END_TYPE\nFUNCTION f : INT VAR_INPUT x : INT; END_VAR\n\
                      f := x; END_FUNCTION\nPROGRAM main\nVAR CONSTANT\n    k : INT := 3;\nEND_VAR\nVAR\n    a, b : ARRAY[1..2] OF \
                      INT := [1, 2]; c : COLOR;\nEND_VAR\n    a[1] := f(x := b[2]);\n    c := RED;\nEND_PROGRAM\n";
        let parts = ProgramParts::of(source, Dialect::of(DialectName::IRONPLC_RUSTY)).expect("parts");
        assert_fits(&parts.units, "TYPE COLOR…END_FUNCTION");
        assert_eq!(parts.statements, "a[1] := f(x := b[2]);\n    c := RED;");
        let set = |names: &[&str]| names.iter().map(ToString::to_string).collect::<HashSet<_>>();
        assert_eq!(parts.variable_names, set(&["K", "A", "B", "C"]));
        assert_eq!(parts.unit_names, set(&["COLOR", "RED", "GREEN", "F"]));
        let constant: Vec<bool> = parts.variables.iter().map(|section| section.constant).collect();
        assert_eq!(constant, [true, false]);
    }
}
