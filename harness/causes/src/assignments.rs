//! The lines of a small program that give a variable its value.

use crate::names::DeclaredNames;
use crate::reduction::Smallest;
use crate::shape::path;
use crate::tokens::{ProgramToken, ProgramTokenKind, tokens};
use stickler_run::Fact;

/// The maximum number of variables through which a value is followed.
const MAX_COPIES: usize = 4;

/// Returns the last line that assigns a variable, a field or an element of it, counts with it, or gives it to an output or an in-out variable
/// of a call; for a field that no line assigns, the line that initializes it.
pub(crate) fn assignment<'p>(program: &'p str, path: &str) -> Option<&'p str> {
    let path = path.split('@').next().unwrap_or(path);
    let name = path.split(['[', '.']).next().unwrap_or(path);
    let assigns = |line: &&str| {
        let tokens = tokens(line);
        let begins = |at: usize| at == 0 || tokens[at - 1].text == ";" || tokens[at - 1].is("FOR");
        let mut targets = (0..tokens.len()).filter(|at| begins(*at) && tokens[*at].is(name));
        let is_target = targets.any(|at| {
            let mut behind = tokens[at..].iter().map(|token| token.text);
            behind.find(|sign| matches!(*sign, ":" | ":=" | ";")) == Some(":=")
        });
        let mut triples = tokens.windows(3);
        // An argument that is the variable alone may be changed by the call.
        let passes = triples.any(|triple| {
            triple[1].is(name)
                && (triple[0].text == "=>" || triple[0].text == ":=" && matches!(triple[2].text, ")" | ","))
        });
        passes || is_target
    };
    let field = path
        .rsplit_once('.')
        .map(|(_, field)| field.split('[').next().unwrap_or(field));
    let initializes = |line: &&str| {
        let tokens = tokens(line);
        let mut triples = tokens.windows(3);
        triples.any(|triple| {
            matches!(triple[0].text, "(" | ",")
                && field.is_some_and(|field| triple[1].is(field))
                && triple[2].text == ":="
        })
    };
    program
        .lines()
        .rfind(assigns)
        .or_else(|| program.lines().rfind(initializes))
}

/// Returns the line that declares a variable, or the field that a path ends with.
pub(crate) fn declaration<'p>(program: &'p str, path: &str) -> &'p str {
    let last = path.split('@').next().and_then(|path| path.rsplit('.').next());
    let name = last.and_then(|last| last.split('[').next()).unwrap_or(path);
    let mut lines = program.lines();
    lines
        .find(|line| declares(line, name))
        .unwrap_or_else(|| last_statement(program))
}

/// Returns the line that computes the value of a variable: behind those that only copy it from another variable of its type, the
/// line that assigns that one. An output of a function block is computed from what the block is given last, and the result of a
/// function by its body.
pub(crate) fn computation<'p>(program: &'p str, path: &str) -> Option<&'p str> {
    let mut line = assignment(program, path)?;
    for _ in 0..MAX_COPIES {
        let source = copied(program, line).and_then(|source| assignment(program, &source));
        // A function that passes a literal on computes nothing.
        let is_passed_on = |source: &str| {
            let is_literal = |token: &ProgramToken<'_>| {
                matches!(
                    token.kind,
                    ProgramTokenKind::Number | ProgramTokenKind::Typed | ProgramTokenKind::Text
                )
            };
            tokens(source).len() == 4 && tokens(line).iter().any(is_literal)
        };
        match source {
            Some(source) if source.as_ptr() < line.as_ptr() && !is_passed_on(source) => line = source,
            _ => break,
        }
    }
    Some(line)
}

/// Returns the variable that a line of a program copies to another of the same type, or the function whose result it copies and that
/// it gives variables and literals only; `None` where the line does more.
fn copied(program: &str, line: &str) -> Option<String> {
    let all = tokens(program);
    let names = DeclaredNames::new(&all);
    let ends = |at: &usize| all.get(*at).is_some_and(|end| end.text == ";");
    let start = all
        .iter()
        .position(|token| token.text.as_ptr() >= line.as_ptr())?;
    let sign = path(&all, start).filter(|sign| all.get(*sign).is_some_and(|sign| sign.text == ":="))?;
    let source = all.get(sign + 1)?;
    let target = names.assigned(&all, sign)?;
    if let Some(end) = path(&all, sign + 1).filter(ends) {
        let words = all[sign + 1..end].iter().map(|token| token.text);
        return (names.whole(&all, sign + 1)? == target).then(|| words.collect());
    }
    let arguments = all.get(sign + 3..)?;
    let closing = arguments.iter().position(|token| token.text == ")")?;
    let is_plain = |token: &ProgramToken<'_>| {
        token.kind != ProgramTokenKind::Sign || matches!(token.text, ":=" | "," | ".")
    };
    let is_call = names.own.contains(&source.text.to_ascii_uppercase())
        && all[sign + 2].text == "("
        && arguments[..closing].iter().all(is_plain)
        && ends(&(sign + 4 + closing));
    (is_call && names.type_of(source)? == target).then(|| source.text.to_owned())
}

/// Returns whether the first value that a small program has wrong is one that a variable begins with, and nothing assigns.
pub(crate) fn shows_initial_value(smallest: &Smallest) -> bool {
    let Smallest {
        program, deviation, ..
    } = smallest;
    let differs = |fact: &&Fact| !deviation.got.contains(fact);
    let wrong = deviation.expected.iter().find(differs);
    let Some(Fact::Value { name, .. }) = wrong else {
        return false;
    };
    assignment(program, name).is_none() && declaration(program, name).contains(":=")
}

/// Returns whether a line itself declares this name.
pub(crate) fn declares(line: &str, name: &str) -> bool {
    let tokens = tokens(line);
    let mut pairs = tokens.windows(2);
    pairs.any(|pair| pair[0].is(name) && matches!(pair[1].text, ":" | ","))
}

/// Returns the last line of a program that is no end of anything.
pub(crate) fn last_statement(program: &str) -> &str {
    let mut lines = program.lines().rev();
    let is_statement = |line: &&str| {
        let first = line.trim().to_ascii_uppercase();
        !first.trim_matches(';').is_empty() && !first.starts_with("END_")
    };
    lines.find(is_statement).unwrap_or(program)
}

#[cfg(test)]
mod tests {
    use super::*;

    const PROGRAM: &str = "FUNCTION f : INT\nVAR_INPUT n : INT; END_VAR\nf := n;\nEND_FUNCTION\nPROGRAM main\nVAR a, b : REAL; c : ARRAY[1..2] OF INT := [1, 2]; END_VAR\na := b + f(c[1]);\nEND_PROGRAM\n";

    #[test]
    fn the_line_that_computes_a_value_is_found() {
        assert_eq!(assignment(PROGRAM, "a@3"), Some("a := b + f(c[1]);"));
        assert_eq!(assignment(PROGRAM, "c[1]"), None);
        assert!(declaration(PROGRAM, "c[1]").starts_with("VAR a, b"));
        assert_eq!(declaration("PROGRAM p\n  q();\nEND_PROGRAM", "x"), "  q();");
    }

    #[test]
    fn a_value_that_is_only_copied_is_computed_before() {
        let of = |ty: &str, body: &str| {
            let block = "FUNCTION_BLOCK w\nVAR_INPUT\ni : INT;\nEND_VAR\nVAR_OUTPUT\no : INT;\nEND_VAR\no := i;\nEND_FUNCTION_BLOCK\n";
            let function = "FUNCTION f : INT\nVAR_INPUT\ng : SINT;\nEND_VAR\nf := g;\nEND_FUNCTION\n";
            let variables = format!("VAR\nfb : w;\nx : {ty};\ny : INT;\nn : SINT;\nEND_VAR\n");
            let program = format!("{block}{function}PROGRAM p\n{variables}{body}END_PROGRAM\n");
            computation(&program, "x").map(str::to_owned)
        };
        let given = "fb.i := n;\nfb();\nx := fb.o;\n";
        assert_eq!(of("INT", given).as_deref(), Some("fb.i := n;"));
        assert_eq!(
            of("DINT", given).as_deref(),
            Some("x := fb.o;"),
            "it is converted"
        );
        assert_eq!(of("INT", "y := n;\nx := y;\n").as_deref(), Some("y := n;"));
        assert_eq!(
            of("INT", "y := n;\nx := y + 1;\n").as_deref(),
            Some("x := y + 1;")
        );
        assert_eq!(of("INT", "x := y;\ny := n;\n").as_deref(), Some("x := y;"));
        assert_eq!(of("INT", "fb();\n"), None);
        assert_eq!(of("INT", "y := 1; x := n;\n").as_deref(), Some("y := 1; x := n;"));
        assert_eq!(
            of("INT", "FOR y := 1 TO n DO\nx := y;\nEND_FOR;\n").as_deref(),
            Some("FOR y := 1 TO n DO")
        );
        assert_eq!(of("INT", "x := f(n);\n").as_deref(), Some("f := g;"));
        assert_eq!(of("INT", "x := f(5);\n").as_deref(), Some("x := f(5);"));
        assert_eq!(of("INT", "x := f(n + 1);\n").as_deref(), Some("x := f(n + 1);"));
    }
}
