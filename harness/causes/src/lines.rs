//! The lines of a small program: which one matters, and how it is told.

use crate::program::{ReadProgram, elementary, tokens, words};
use crate::title::clipped;
use stickler_run::Fact;
use stickler_syntax::names::DeclaredName;
use stickler_syntax::source::Span;
use stickler_syntax::token::{Token, TokenKind};
use stickler_syntax::tree::{Declaration, PouKind, TypeSpecificationKind, VariableBlock};

/// The maximum number of variables whose types are named.
const MAX_TYPES: usize = 3;

/// Returns a line of a program in code quotes, with the types of its variables where these stand elsewhere.
pub(crate) fn described(program: &ReadProgram<'_, '_>, number: u32) -> String {
    let line = program.line_text(number).unwrap_or_default();
    // A reduced program may have its end on the line of a statement.
    let code = line.split_once(";END_").map_or(line, |(code, _)| code);
    let code = match code.trim().trim_end_matches(';').trim_end() {
        "" => code.trim(),
        code => code,
    };
    let is_here = |one: &&DeclaredName<'_, '_>| program.line(one.name.span) == number;
    let own: Vec<&str> = program
        .names
        .iter()
        .filter(is_here)
        .map(|one| one.name.text)
        .collect();
    let mut types: Vec<String> = Vec::new();
    for word in words(code) {
        let is_it = |one: &&DeclaredName<'_, '_>| one.name.is(word) && one.group.is_some();
        let is_own = own.iter().any(|name| name.eq_ignore_ascii_case(word));
        let declared = program.names.iter().find(is_it).filter(|_| !is_own);
        if let Some(entry) = declared.and_then(|one| declared_as(program, one))
            && types.len() < MAX_TYPES
            && !types.contains(&entry)
        {
            types.push(entry);
        }
    }
    let section = special_section(program, number).map_or(String::new(), |head| format!(" in {head}"));
    match types.is_empty() {
        true => format!("`{}`{section}", clipped(code)),
        false => format!("`{}`{section} ({})", clipped(code), types.join(", ")),
    }
}

/// Returns a name with the location, the type and the initial value with which a program declares it, as they are written; of what is
/// no plain variable the type alone, and nothing of a structure.
fn declared_as(program: &ReadProgram<'_, '_>, declared: &DeclaredName<'_, '_>) -> Option<String> {
    let (text, group) = (program.text, declared.group?);
    let value = match &group.specification.kind {
        TypeSpecificationKind::Structure(_) | TypeSpecificationKind::Error => return None,
        TypeSpecificationKind::Named(_) => group.initializer.as_ref(),
        _ => None,
    };
    let value = value.map_or(String::new(), |value| format!(" := {}", value.span.text(text)));
    let location = group
        .location
        .map_or(String::new(), |place| format!(" AT {}", place.text));
    let ty = clipped(&format!("{}{value}", group.specification.span.text(text)));
    (!ty.is_empty()).then(|| format!("{}{location} : {ty}", declared.name.text))
}

/// Returns the word of the section of variables that a line stands in, unless that is the plain one or that of the inputs.
fn special_section<'s>(program: &ReadProgram<'_, 's>, number: u32) -> Option<&'s str> {
    let is_inside = |section: &&VariableBlock<'s>| {
        let last = Span {
            start: section.span.end.saturating_sub(1),
            ..section.span
        };
        (program.line(section.span) + 1..program.line(last)).contains(&number)
    };
    let section = sections(program).find(is_inside)?;
    let head = words(section.span.text(program.text)).first().copied()?;
    (!matches!(head, "VAR" | "VAR_INPUT")).then_some(head)
}

/// Returns the sections of variables of the units of a program.
fn sections<'t, 's>(program: &ReadProgram<'t, 's>) -> impl Iterator<Item = &'t VariableBlock<'s>> {
    program
        .program
        .unit
        .declarations
        .iter()
        .flat_map(|declaration| match declaration {
            Declaration::Pou(pou) => pou.blocks.iter().collect(),
            Declaration::Globals(section) => vec![section],
            Declaration::Configuration(configuration) => configuration.globals.iter().collect(),
            Declaration::Types(_) => Vec::new(),
        })
}

/// Returns the kind of unit that a line of a program stands in, unless that is a PROGRAM.
pub(crate) fn unit_of(program: &ReadProgram<'_, '_>, number: u32) -> Option<&'static str> {
    let begins_before = |span: Span| program.line(span) <= number;
    match program.unit.pous().rfind(|pou| begins_before(pou.span))?.kind {
        PouKind::Program => None,
        PouKind::Function => Some("a FUNCTION"),
        PouKind::FunctionBlock => Some("a FUNCTION_BLOCK"),
    }
}

/// Returns the number of the line with a number that a message names; one of one digit stands in too many messages.
pub(crate) fn line_with_number(program: &ReadProgram<'_, '_>, message: &str) -> Option<u32> {
    let text = program.text;
    let all = tokens(text);
    let mut numbers = message.split(|character: char| !character.is_ascii_digit());
    numbers.find_map(|number| {
        let is_number = |token: &&Token| number.len() > 1 && token.is(number, text);
        Some(program.line(all.iter().find(is_number)?.span))
    })
}

/// Returns the line of a small program that an engine does not implement, by what it says: a statement with a variable that the
/// message quotes, best with a part of it, or else the first of the statements with most to them, since calls of a body stand behind it.
pub(crate) fn unimplemented(program: &ReadProgram<'_, '_>, got: &[Fact]) -> u32 {
    let statements = suspect::statements(program);
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
        let has_name = |number: &u32| crate::program::has_word(text(*number), name);
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
        (has_more, suspect::weight(text(number)))
    };
    let most = statements.iter().map(|number| much(*number)).max();
    let first = statements.into_iter().find(|number| Some(much(*number)) == most);
    first.unwrap_or_else(|| suspect::culprit(program))
}

/// Which line of a small program most probably matters, where the engine names none.
pub(crate) mod suspect {
    use super::{Declaration, ReadProgram, Token, TokenKind, elementary, sections, special_section, tokens};

    /// Returns the last of the lines with most to them, since a plain assignment may be there only because a program needs a statement;
    /// before a plain assignment a declaration in a section that not every program has.
    pub(crate) fn culprit(program: &ReadProgram<'_, '_>) -> u32 {
        let weighed = |(line, number): &(&str, u32)| match weight(line) {
            1 if special_section(program, *number).is_some() => 3,
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

    /// Returns the lines of statements of a program that are no frame.
    pub(crate) fn statements(program: &ReadProgram<'_, '_>) -> Vec<u32> {
        let line = |byte: u32| program.lines.line(byte);
        let mut declared: Vec<(u32, u32)> = sections(program)
            .map(|section| (section.span.start, section.span.end))
            .collect();
        for declaration in &program.unit.declarations {
            if let Declaration::Types(types) = declaration {
                declared.extend(
                    types
                        .iter()
                        .map(|one| (one.name.span.start, one.specification.span.end)),
                );
            }
        }
        let is_declared = |number: u32| {
            declared
                .iter()
                .any(|(start, end)| (line(*start)..=line(end.saturating_sub(1))).contains(&number))
        };
        let lines = program.text.lines().zip(1..);
        let statements = lines.filter(|(line, number)| weight(line) > 0 && !is_declared(*number));
        statements.map(|(_, number)| number).collect()
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
        if all.iter().all(|token| token.kind == Semicolon) || begins.is_keyword() && !is_statement {
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
}
