//! Programs with other statements in a body: one that only names a variable, or two in the place of one.

use crate::names::DeclaredNames;
use crate::operands::without_unused;
use crate::operations::{calculates, is_comparison};
use crate::shape::path;
use crate::tokens::{ProgramToken, tokens};
use std::ops::Range;

/// Returns a program with one of its bodies replaced by a single statement, for each body: a call of each instance of a function
/// block that the body uses, the assignment of each field and element that it uses to itself, and each of its own statements where
/// none stands in another.
pub(crate) fn with_one_statement(program: &str) -> Vec<String> {
    let all = tokens(program);
    let names = DeclaredNames::new(&all);
    let mut found = Vec::new();
    for body in bodies(&all) {
        let is_instance = |token: &&ProgramToken<'_>| {
            let ty = names.words.get(&token.text.to_ascii_uppercase());
            ty.is_some_and(|ty| is_block(&all, ty))
        };
        let used = &all[body.clone()];
        let calls = used
            .iter()
            .filter(is_instance)
            .map(|token| format!("{}();", token.text));
        let parts = body.clone().filter_map(|at| {
            let end = path(&all, at).filter(|end| *end > at + 1)?;
            let path = &program[all[at].start..all[end - 1].end()];
            Some(format!("{path} := {path};"))
        });
        let own: Vec<&str> = used.iter().map(|token| token.text).collect();
        let begins = |word: &str| ["IF", "CASE", "FOR", "WHILE", "REPEAT"].contains(&word);
        let is_flat = !used.iter().any(|token| begins(&token.text.to_ascii_uppercase()));
        let statements = used.split(|token| token.text == ";").filter(|_| is_flat);
        let statements = statements.filter_map(|statement| {
            let (first, last) = (statement.first()?, statement.last()?);
            Some(format!("{};", &program[first.start..last.end()]))
        });
        for statement in calls.chain(parts).chain(statements) {
            let is_own = tokens(&statement)
                .iter()
                .map(|token| token.text)
                .eq(own.iter().copied());
            let (Some(first), Some(last)) = (used.first(), used.last()) else {
                continue;
            };
            let (from, until) = (first.start, last.end());
            let changed = format!("{}{statement}{}", &program[..from], &program[until..]);
            if !is_own && !found.contains(&changed) {
                found.push(changed);
            }
        }
    }
    found
}

/// Returns a program with an operation on two values of one type in a statement of its own, before what it gives is converted to
/// the type of the target; `None` where it has no statement that does both.
pub(crate) fn in_two_steps(program: &str) -> Option<String> {
    let all = tokens(program);
    let names = DeclaredNames::new(&all);
    for body in bodies(&all) {
        for at in body.clone() {
            let [left, operator, right, end] = all.get(at + 1..at + 5)? else {
                break;
            };
            if all[at].text != ":=" || !calculates(operator) || end.text != ";" {
                continue;
            }
            let (Some(own), Some(target)) = (names.type_of_operand(left), names.assigned(&all, at)) else {
                continue;
            };
            if names.type_of_operand(right) != Some(own) || target == own {
                continue;
            }
            let (first, from, until) = (all[body.start].start, left.start, end.start);
            let start = statement(&all, at);
            let start = all[start.max(body.start)].start;
            return Some(format!(
                "{}VAR\n    partial : {};\nEND_VAR\n    {}partial := {};\n    {}partial{}",
                &program[..first],
                own.name(),
                &program[first..start],
                &program[from..until],
                &program[start..from],
                &program[until..],
            ));
        }
    }
    None
}

/// Returns a program with a comparison turned round, whose operands have different types; `None` where it has none.
pub(crate) fn turned_round(program: &str) -> Option<String> {
    let all = tokens(program);
    let names = DeclaredNames::new(&all);
    let mut comparisons = all.windows(4);
    let found = comparisons.find(|four| {
        four[0].text == ":="
            && is_comparison(four[2].text)
            && match (names.type_of_operand(&four[1]), names.type_of_operand(&four[3])) {
                (Some(left), Some(right)) => left != right,
                _ => false,
            }
    })?;
    let turned = match found[2].text {
        "<" => ">",
        ">" => "<",
        "<=" => ">=",
        ">=" => "<=",
        same => same,
    };
    let (left, right) = (&found[1], &found[3]);
    let end = right.end();
    // Behind the second operand may come a part of it, or another operation.
    program[end..].trim_start().starts_with(';').then(|| {
        let (before, behind) = (&program[..left.start], &program[end..]);
        format!("{before}{} {turned} {}{behind}", right.text, left.text)
    })
}

/// Returns a program in which outputs of calls are given to a variable of their own in the place of bits; `None` where none is given to
/// a bit.
pub(crate) fn with_whole_outputs(program: &str) -> Option<String> {
    let all = tokens(program);
    let arrow = all.iter().position(|token| token.text == "=>")?;
    let end = path(&all, arrow + 1)?;
    let (point, bit) = (all.get(end)?, all.get(end + 1)?);
    if point.text != "." {
        return None;
    }
    let section = all[..arrow].iter().rfind(|token| token.is("END_VAR"))?;
    let end = section.start;
    Some(without_unused(&format!(
        "{}    received : BOOL;\n{}received{}",
        &program[..end],
        &program[end..all[arrow + 1].start],
        &program[bit.end()..],
    )))
}

/// Returns the place of the first token of the statement that a token stands in.
fn statement(all: &[ProgramToken<'_>], at: usize) -> usize {
    let ends = |token: &ProgramToken<'_>| {
        let words = ["THEN", "ELSE", "DO", "REPEAT", "OF", "END_VAR"];
        matches!(token.text, ";" | ":") || words.iter().any(|word| token.is(word))
    };
    all[..at].iter().rposition(ends).map_or(0, |end| end + 1)
}

/// Returns where each body of a program organization unit stands, in tokens; bodies without a statement are left out.
pub(crate) fn bodies(all: &[ProgramToken<'_>]) -> Vec<Range<usize>> {
    let mut found = Vec::new();
    let mut start = 0;
    for (at, token) in all.iter().enumerate() {
        if token.is("END_VAR") {
            start = at + 1;
        } else if token.is("FUNCTION") {
            // A function may have no variables: its body begins behind `FUNCTION name : type`.
            start = at + 4;
        } else if token.is("PROGRAM") || token.is("FUNCTION_BLOCK") {
            start = at + 2;
        } else if ["END_PROGRAM", "END_FUNCTION", "END_FUNCTION_BLOCK"]
            .iter()
            .any(|end| token.is(end))
            && start < at
        {
            found.push(start..at);
        }
    }
    found
}

/// Returns whether a program declares a function block with this name.
pub(crate) fn is_block(all: &[ProgramToken<'_>], name: &str) -> bool {
    let mut pairs = all.windows(2);
    pairs.any(|pair| pair[0].is("FUNCTION_BLOCK") && pair[1].is(name))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_body_becomes_a_statement_that_only_names_a_variable() {
        let block = "FUNCTION_BLOCK b VAR_INPUT v : WORD; END_VAR v := v; END_FUNCTION_BLOCK ";
        let main = |body: &str| {
            format!("{block}PROGRAM p VAR fb : b; a : ARRAY[0..1] OF R; i : INT; END_VAR {body} END_PROGRAM")
        };
        let found = with_one_statement(&main("IF a[i].f.7 THEN fb.v.0 := TRUE; END_IF;"));
        assert_eq!(
            found,
            [main("fb();"), main("a[i].f := a[i].f;"), main("fb.v := fb.v;")]
        );
        assert!(with_one_statement(&main("fb();")).is_empty());
        assert_eq!(
            with_one_statement(&main("i := 0 + 0; fb(v => i.4);")),
            [main("fb();"), main("i := 0 + 0;"), main("fb(v => i.4);")]
        );
    }

    #[test]
    fn an_operation_and_a_conversion_become_two_statements() {
        let of = |body: &str| {
            let program =
                format!("PROGRAM p VAR a : INT; into : DINT; same : INT; END_VAR {body} END_PROGRAM");
            in_two_steps(&program)
        };
        assert_eq!(
            of("same := a; into := a * INT#5;").as_deref(),
            Some(
                "PROGRAM p VAR a : INT; into : DINT; same : INT; END_VAR VAR\n    partial : INT;\nEND_VAR\n    same := a; partial := a * INT#5;\n    \
                 into := partial; END_PROGRAM"
            )
        );
        assert_eq!(of("same := a + a;"), None);
        assert_eq!(of("into := a;"), None);
        assert_eq!(of("into := a + into;"), None);
    }

    #[test]
    fn a_comparison_of_two_types_is_turned_round() {
        let of = |body: &str| turned_round(&format!("VAR a : BYTE; b : INT; r : BOOL; END_VAR {body}"));
        assert_eq!(
            of("r := BYTE#0 <= b;").as_deref(),
            Some("VAR a : BYTE; b : INT; r : BOOL; END_VAR r := b >= BYTE#0;")
        );
        assert!(of("r := a < b;").is_some_and(|turned| turned.ends_with("r := b > a;")));
        assert!(of("r := a = b;").is_some_and(|turned| turned.ends_with("r := b = a;")));
        assert_eq!(of("r := b < b;"), None);
        assert_eq!(of("r := a < b + b;"), None);
    }

    #[test]
    fn an_output_is_given_to_a_variable_in_the_place_of_a_bit() {
        let program = |declared: &str, argument: &str| {
            format!("PROGRAM p\nVAR\n{declared}END_VAR\nf(in := x, q => {argument});\nEND_PROGRAM\n")
        };
        let (word, other) = ("    w : WORD;\n", "    x : INT;\n");
        let found = with_whole_outputs(&program(&format!("{word}{other}"), "w.3"));
        let received = format!("{other}    received : BOOL;\n");
        assert_eq!(found, Some(program(&received, "received")));
        assert_eq!(with_whole_outputs(&program(word, "w")), None);
    }
}
