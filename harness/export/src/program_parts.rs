//! Splits a case's program into the parts of a page: the POUs and types beside its main program, the variables of
//! that program, and its statements.
//!
//! The splitter parses words and signs only, so that it does not depend on the dialect. A case whose program it cannot split is
//! left out of the export, with the reason.

use crate::Reason;
use std::collections::HashSet;
use stickler_engines::{SourceToken, declared, tokens};

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
    /// Splits the program of a case.
    ///
    /// # Errors
    /// The [`Reason`] why the program cannot share a page with others.
    pub(crate) fn of(source: &str) -> Result<ProgramParts, Reason> {
        let source = without_marks(source);
        // A part of a variable (`x.%X7`) shares nothing, other than a variable of the machine (`%IX0.0`).
        let without_parts = source.replace(".%", "._");
        let mut unit_names = declared(&without_parts, &HashSet::new()).ok_or(Reason::Shares)?;
        let mut reader = PartsReader::new(&source);
        let main = reader.main()?;
        let mut parts = ProgramParts {
            units: [&source[..main.begins], &source[main.ends..]]
                .map(str::trim)
                .join("\n")
                .trim()
                .to_owned(),
            unit_names: HashSet::new(),
            variables: main.sections,
            variable_names: HashSet::new(),
            statements: source[main.statements..main.statements_end].trim().to_owned(),
        };
        for section in &parts.variables {
            parts.variable_names.extend(names(&section.text));
        }
        unit_names.remove(&main.name);
        // The values of an enumeration that a variable declares in place count among the names of the text, but belong to
        // the program only.
        parts.unit_names = unit_names;
        Ok(parts)
    }
}

/// The places of the main program's parts in the text.
struct MainParts {
    /// The name of the program, in capitals.
    name: String,
    begins: usize,
    ends: usize,
    sections: Vec<DeclaredSection>,
    statements: usize,
    statements_end: usize,
}

/// A reader that goes through a text word by word.
struct PartsReader<'s> {
    source: &'s str,
    words: Vec<(&'s str, usize)>,
    next: usize,
}

impl<'s> PartsReader<'s> {
    fn new(source: &'s str) -> PartsReader<'s> {
        let words = tokens(source).filter_map(|token| match token {
            SourceToken::Word(word) => Some((word.text, word.at)),
            _ => None,
        });
        PartsReader {
            source,
            words: words.collect(),
            next: 0,
        }
    }

    fn word(&mut self) -> Option<(&'s str, usize)> {
        let word = self.words.get(self.next).copied();
        self.next += 1;
        word
    }

    fn seek(&mut self, keyword: &str) -> Option<usize> {
        while let Some((word, at)) = self.word() {
            if word.eq_ignore_ascii_case(keyword) {
                return Some(at);
            }
        }
        None
    }

    /// Finds the only program of the text.
    fn main(&mut self) -> Result<MainParts, Reason> {
        let begins = self.seek("PROGRAM").ok_or(Reason::NoProgram)?;
        let (name, at) = self.word().ok_or(Reason::NoProgram)?;
        let mut sections = Vec::new();
        let mut statements = at + name.len();
        while let Some(section) = self.section()? {
            statements = section.1;
            sections.push(section.0);
        }
        let mut statements_end = None;
        while let Some((word, at)) = self.word() {
            if word.eq_ignore_ascii_case("RETURN") {
                return Err(Reason::Returns);
            }
            if word.eq_ignore_ascii_case("END_PROGRAM") {
                statements_end = Some(at);
                break;
            }
        }
        let statements_end = statements_end.ok_or(Reason::NoProgram)?;
        let ends = statements_end + "END_PROGRAM".len();
        if self.seek("PROGRAM").is_some() {
            return Err(Reason::SeveralPrograms);
        }
        Ok(MainParts {
            name: name.to_ascii_uppercase(),
            begins,
            ends,
            sections,
            statements,
            statements_end,
        })
    }

    /// Reads a section of variables, if one comes next; also returns the place of its end.
    fn section(&mut self) -> Result<Option<(DeclaredSection, usize)>, Reason> {
        let Some(&(word, at)) = self.words.get(self.next) else {
            return Ok(None);
        };
        if !word
            .get(..3)
            .is_some_and(|start| start.eq_ignore_ascii_case("VAR"))
            || !is_section(word)
        {
            return Ok(None);
        }
        if !word.eq_ignore_ascii_case("VAR") {
            return Err(Reason::Section);
        }
        self.next += 1;
        let mut inside = at + word.len();
        let mut constant = false;
        if let Some(&(qualifier, at)) = self.words.get(self.next)
            && is_qualifier(qualifier)
        {
            // Retained variables would keep their values from one page to the next.
            if !qualifier.eq_ignore_ascii_case("CONSTANT") {
                return Err(Reason::Section);
            }
            constant = true;
            inside = at + qualifier.len();
        }
        let end = self.seek("END_VAR").ok_or(Reason::NoProgram)?;
        let text = self.source[inside..end].trim_matches(['\n', '\r']).trim_end();
        let section = DeclaredSection {
            constant,
            text: text.to_owned(),
        };
        Ok(Some((section, end + "END_VAR".len())))
    }
}

fn is_section(word: &str) -> bool {
    word.len() == 3 || word.as_bytes().get(3) == Some(&b'_')
}

fn is_qualifier(word: &str) -> bool {
    ["CONSTANT", "RETAIN", "NON_RETAIN", "PERSISTENT"]
        .iter()
        .any(|qualifier| word.eq_ignore_ascii_case(qualifier))
}

/// Returns the names that a section declares, in capitals: those before a colon.
fn names(section: &str) -> HashSet<String> {
    let mut names = HashSet::new();
    let mut in_names = true;
    let mut depth = 0_u32;
    for token in tokens(section) {
        match token {
            SourceToken::Word(word) if in_names => {
                names.insert(word.text.to_ascii_uppercase());
            }
            SourceToken::Sign(b'(' | b'[') => depth += 1,
            SourceToken::Sign(b')' | b']') => depth = depth.saturating_sub(1),
            SourceToken::Sign(b':') => in_names = false,
            SourceToken::Sign(b';') if depth == 0 => in_names = true,
            _ => {}
        }
    }
    names
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
        let parts = ProgramParts::of(source).expect("parts");
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
        let parts = ProgramParts::of(source).expect("parts");
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
            assert_eq!(ProgramParts::of(source), Err(reason), "{source}");
        }
    }
}
