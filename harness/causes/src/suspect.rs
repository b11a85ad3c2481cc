//! Which line of a small program most probably matters, where the engine names none.

use crate::lines::{LinePlace, place_of, special_section};
use crate::program::ReadProgram;
use crate::words::{elementary, has_word, tokens, words};
use stickler_run::Fact;
use stickler_syntax::token::{Token, TokenKind};
use stickler_syntax::tree::{Pou, PouKind};

/// Returns the line of a small program that an engine does not implement, by what it says: a statement with a variable that the
/// message quotes, best with a part of it, or else the first of the statements with most to them, since calls of a body stand behind it.
pub(crate) fn unimplemented(program: &ReadProgram<'_, '_>, got: &[Fact]) -> u32 {
    let statements = statements(program);
    let text = |number: u32| program.line_text(number).unwrap_or_default();
    let message = got.iter().find_map(|fact| match fact {
        Fact::NotImplemented { reason, .. } => Some(reason.as_str()),
        _ => None,
    });
    let is_part = |sign: &str| matches!(sign, "." | "[" | "%");
    for name in message.unwrap_or_default().split('\'').skip(1).step_by(2) {
        let has_part = |number: &u32| {
            let words = words(text(*number));
            let mut pairs = words.windows(2);
            pairs.any(|pair| pair[0].eq_ignore_ascii_case(name) && is_part(pair[1]))
        };
        let has_name = |number: &u32| has_word(text(*number), name);
        let mut found = statements.iter().copied();
        if let Some(line) = found.clone().find(has_part).or_else(|| found.find(has_name)) {
            return line;
        }
    }
    // A part of a variable or a call may be missing rather than a condition.
    let much = |number: u32| {
        let has_more = words(text(number))
            .iter()
            .any(|sign| is_part(sign) || *sign == "(");
        (has_more, weight(text(number)))
    };
    let most = statements.iter().map(|number| much(*number)).max();
    let first = statements.into_iter().find(|number| Some(much(*number)) == most);
    first.unwrap_or_else(|| culprit(program))
}

/// Returns the last of the lines with most to them, since a plain assignment may be there only because a program needs a statement;
/// before a plain assignment a declaration in a section that not every program has.
pub(crate) fn culprit(program: &ReadProgram<'_, '_>) -> u32 {
    // A call without arguments only leads to the statements of its unit, where a unit has some.
    let is_called = |pou: &Pou<'_>| pou.kind != PouKind::Program && !pou.body.is_empty();
    let has_statements = program.unit.pous().any(is_called);
    let leads = |line: &str| match words(line)[..] {
        [name, "(", ")", ";"] => program.is_instance(name) && has_statements,
        [_, ":=", name, "(", ")", ";"] => program.unit_of(name).is_some(),
        _ => false,
    };
    // A statement that a program only needs to have one says less than a variable of a type of the program's own.
    let is_filling = |line: &str| matches!(words(line)[..], [_, ":=", "TRUE" | "0", ";"]);
    let is_of_own = |line: &str| matches!(words(line)[..], [_, ":", ty, ";"] if program.declares(ty));
    let is_begun = |line: &str| matches!(words(line)[..], [_, ":", ty, ":=", ..] if program.declares(ty));
    let weighed = |(line, number): &(&str, u32)| match weight(line) {
        _ if is_begun(line) => 5,
        _ if leads(line) || is_filling(line) => 1,
        1 if special_section(program, *number).is_some() => 3,
        1 if is_of_own(line) => 2,
        least @ (1 | 2) => least,
        most => most + 1,
    };
    let lines = program.text.lines().zip(1..);
    let heaviest = lines.filter(|(line, _)| weight(line) > 0).max_by_key(weighed);
    heaviest.map_or_else(|| program.last_statement(), |(_, number)| number)
}

/// Returns whether a line says something: one with a semicolon alone does where there is no other statement.
pub(crate) fn is_telling(program: &ReadProgram<'_, '_>, number: u32) -> bool {
    let line = program.line_text(number).unwrap_or_default();
    let is_told = !line.trim_matches([' ', '\t', ';']).is_empty();
    is_told || line.trim() == ";" && statements(program).is_empty()
}

/// Returns the line of the IF, CASE or loop, or of the ELSE, that a line stands behind, in the words of the program; `None` where it stands
/// in none.
pub(crate) fn guard_of<'s>(program: &ReadProgram<'_, 's>, number: u32) -> Option<&'s str> {
    use TokenKind::*;
    let mut closed = 0;
    let before: Vec<&str> = program
        .text
        .lines()
        .take(number.saturating_sub(1) as usize)
        .collect();
    before.into_iter().rev().map(str::trim).find(|line| {
        tokens(line).iter().rev().any(|token| match token.kind {
            EndIf | EndCase | EndFor | EndWhile | EndRepeat => {
                closed += 1;
                false
            }
            If | Case | For | While | Repeat if closed > 0 => {
                closed -= 1;
                false
            }
            If | Case | For | While | Repeat => true,
            Elsif | Else => closed == 0,
            _ => false,
        })
    })
}

/// Returns the line at which a program most probably stops: the last of the statements with most to them. A call of a unit that does
/// something only leads to the statements of the unit, and comes after them.
pub(crate) fn stopping(program: &ReadProgram<'_, '_>) -> u32 {
    let does_nothing = |name: &str| program.unit_of(name).is_none_or(|unit| unit.body.is_empty());
    let weighed = |number: &u32| {
        let line = program.line_text(*number).unwrap_or_default();
        let leads = match words(line)[..] {
            [name, "(", ..] | [_, ":=", name, "(", ..] => !does_nothing(name),
            _ => false,
        };
        (!leads, weight(line))
    };
    let most = statements(program).into_iter().max_by_key(weighed);
    most.unwrap_or_else(|| culprit(program))
}

/// Returns the lines of statements of a program that are no frame.
pub(crate) fn statements(program: &ReadProgram<'_, '_>) -> Vec<u32> {
    let lines = program.text.lines().zip(1..);
    let stated = lines.filter(|(_, number)| matches!(place_of(program, *number), LinePlace::Statement));
    stated
        .filter(|(line, _)| weight(line) > 0)
        .map(|(_, number)| number)
        .collect()
}

/// Returns how much there is to a line: nothing to a frame, little to a plain assignment.
pub(crate) fn weight(line: &str) -> u8 {
    use TokenKind::*;
    let all = tokens(line);
    let begins = all.first().map_or(Semicolon, |first| first.kind);
    let is_statement = matches!(
        begins,
        If | Elsif | Case | For | While | Repeat | Until | Return | Exit | True | False
    );
    let opens = all.last().is_some_and(|last| last.kind == Struct);
    if all.iter().all(|token| token.kind == Semicolon) || begins.is_keyword() && !is_statement || opens {
        return 0;
    }
    let is_plain = |token: &Token| {
        matches!(
            token.kind,
            Assign | Colon | Comma | Semicolon | True | False | Name | Integer
        )
    };
    let is_type = all
        .first()
        .is_some_and(|first| elementary(first.span.text(line)).is_some());
    match all.iter().all(is_plain) {
        _ if is_type => 0,
        true if all.iter().any(|token| token.kind == Assign) => 2,
        true => 1,
        false => 3,
    }
}
