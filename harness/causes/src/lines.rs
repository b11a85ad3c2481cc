//! The lines of a small program: which one matters, and how it is told.

use crate::program::{Part, ReadProgram};
use crate::words::{tokens, words};
use stickler_syntax::names::{DeclaredKind, DeclaredName};
use stickler_syntax::source::Span;
use stickler_syntax::token::Token;
use stickler_syntax::tree::{
    Argument, Declaration, Initializer, Pou, PouKind, StatementKind, TypeDeclaration, TypeSpecification,
    TypeSpecificationKind, VariableBlock, VariableKind,
};
use stickler_syntax::visitor::Place;

/// The maximum number of characters that are shown of a line, a message or a value.
const MAX_LENGTH: usize = 160;
/// The maximum number of variables whose types are named.
const MAX_TYPES: usize = 5;

/// The maximum number of times that a title repeats a sign.
const MAX_REPEATED: usize = 16;

/// Returns a line of a program in code quotes, with the types of its variables where these stand elsewhere.
pub(crate) fn described(program: &ReadProgram<'_, '_>, number: u32) -> String {
    let line = program.line_text(number).unwrap_or_default();
    // A reduced program may have its end on the line of a statement.
    let code = line.split_once(";END_").map_or(line, |(code, _)| code);
    let code = match code.trim().trim_end_matches(';').trim_end() {
        "" => code.trim(),
        code => code,
    };
    let code = &whole_statement(program, number, code);
    let is_here = |one: &&DeclaredName<'_, '_>| program.line(one.name.span) == number;
    let own: Vec<&str> = program
        .names
        .iter()
        .filter(is_here)
        .map(|one| one.name.text)
        .collect();
    let is_in =
        |unit: Span| (program.line(unit)..=program.lines.line(unit.end.saturating_sub(1))).contains(&number);
    let mut types: Vec<String> = Vec::new();
    // A line may have many thousands of words, of which nobody sees more than the first.
    let shown = clipped(code);
    let all = words(&shown);
    for (word, next) in all.iter().copied().zip(all.iter().skip(1).chain([&""])) {
        let is_it = |one: &&DeclaredName<'_, '_>| one.name.is(word) && one.group.is_some();
        let is_own = own.iter().any(|name| name.eq_ignore_ascii_case(word));
        let is_inside = |one: &&DeclaredName<'_, '_>| one.inside.is_some_and(|unit| is_in(unit.span));
        let of_unit = program.names.iter().filter(is_it).find(is_inside);
        let declared = of_unit.or_else(|| program.names.iter().find(is_it));
        let section = of_unit.and_then(|one| special_section(program, program.line(one.name.span)));
        let section = section.map_or(String::new(), |head| format!(" in {head}"));
        let entry = declared
            .filter(|_| !is_own)
            .and_then(|one| declared_as(program, one))
            .or_else(|| result_of(program, number, word))
            .or_else(|| {
                let ty = program.declared_type(word).filter(|_| !is_own)?;
                let written = written_type(program, &ty.specification, ty.initializer.as_ref())?;
                Some(format!("{} : {written}", ty.name.text))
            })
            .or_else(|| {
                let mut units = program.unit.pous();
                let unit = units.find(|pou| pou.name.is(word) && !is_in(pou.name.span))?;
                let kind = match unit.kind {
                    PouKind::FunctionBlock => "FUNCTION_BLOCK",
                    PouKind::Function if *next != "(" => "FUNCTION",
                    _ => return None,
                };
                Some(format!("{} : {kind}", unit.name.text))
            })
            .or_else(|| enumeration_of(program, word).filter(|_| declared.is_none()));
        let group = declared.filter(|_| !is_own).and_then(|one| one.group);
        let definition = group.and_then(|group| definition(program, &group.specification));
        for entry in entry.map(|entry| entry + &section).into_iter().chain(definition) {
            if types.len() < MAX_TYPES && !types.contains(&entry) {
                types.push(entry);
            }
        }
    }
    for entry in declared_in_empty(program, &shown)
        .into_iter()
        .chain(parameters(program, number))
        .chain(left_out(program, number))
    {
        if types.len() < MAX_TYPES && !types.contains(&entry) {
            types.push(entry);
        }
    }
    let is_field = program
        .names
        .iter()
        .any(|one| is_here(&one) && one.group.is_some());
    let section = match place_of(program, number) {
        LinePlace::Types if is_field => Some("STRUCT"),
        LinePlace::Types => Some("TYPE"),
        _ => section(program, number),
    };
    // The first line of a section says itself which one it is.
    let section = section.filter(|head| !shown.starts_with(head));
    let section = section.map_or(String::new(), |head| format!(" in {head}"));
    match types.is_empty() {
        true => format!("`{shown}`{section}"),
        false => format!("`{shown}`{section} ({})", types.join(", ")),
    }
}

/// Returns what the block declares that a line calls by a name without arguments, where it does nothing: only that can matter.
fn declared_in_empty(program: &ReadProgram<'_, '_>, code: &str) -> Vec<String> {
    let block = match words(code)[..] {
        [name, "(", ")"] => program.unit_of(name).filter(|block| block.body.is_empty()),
        _ => None,
    };
    let is_inside = |one: &&DeclaredName<'_, '_>| {
        block.is_some_and(|block| one.inside.is_some_and(|unit| unit.span == block.span))
    };
    let declared = program.names.iter().filter(is_inside).filter_map(|one| {
        let section = section(program, program.line(one.name.span));
        let section = section.map_or(String::new(), |head| format!(" in {head}"));
        Some(declared_as(program, one)? + &section)
    });
    declared.collect()
}

/// Returns the enumeration that has a value of this name, as it is declared.
fn enumeration_of(program: &ReadProgram<'_, '_>, value: &str) -> Option<String> {
    let has_value = |one: &&TypeDeclaration<'_>| match &one.specification.kind {
        TypeSpecificationKind::Enumeration { values, .. } => values.iter().any(|(name, _)| name.is(value)),
        _ => false,
    };
    let declared = program.unit.types().find(has_value)?;
    let written = written_type(program, &declared.specification, None)?;
    Some(format!("{} : {written}", declared.name.text))
}

/// Returns the parameters to which a line gives values without their names, with their types.
fn parameters(program: &ReadProgram<'_, '_>, number: u32) -> Vec<String> {
    let here = |part: &&Part<'_, '_>| program.line(part.expression.span) == number;
    let given = program.at(Place::Argument).filter(here);
    let parameter = |part: &Part<'_, '_>| {
        let specification = program.target_specification(part)?;
        let is_it = |one: &&DeclaredName<'_, '_>| {
            one.group
                .is_some_and(|group| group.specification.span == specification.span)
        };
        declared_as(program, program.names.iter().find(is_it)?)
    };
    given.filter_map(parameter).collect()
}

/// Returns the inputs that the calls of the program's own functions in a line leave out, with their types; none where they give values
/// without names.
fn left_out(program: &ReadProgram<'_, '_>, number: u32) -> Vec<String> {
    let here = |part: &&Part<'_, '_>| program.line(part.expression.span) == number;
    let left_out = |part: &Part<'_, '_>| {
        let (callee, arguments) = program.call(part.id)?;
        let unit = program
            .unit_of(callee)
            .filter(|unit| unit.kind == PouKind::Function)?;
        let is_input = |one: &&DeclaredName<'_, '_>| {
            let is_given = |argument: &Argument<'_>| match argument {
                Argument::Named { name, .. } => one.name.is(name.text),
                _ => true,
            };
            one.kind == DeclaredKind::Variable(VariableKind::Input)
                && one.inside.is_some_and(|pou| pou.span == unit.span)
                && !arguments.iter().any(is_given)
        };
        let name = program.names.iter().find(is_input)?;
        Some(declared_as(program, name)? + " left out")
    };
    program.parts.iter().filter(here).filter_map(left_out).collect()
}

/// Returns the code of a line with what it says nothing without: the selector of a CASE label, and the end of what has no statements.
fn whole_statement(program: &ReadProgram<'_, '_>, number: u32, code: &str) -> String {
    let is_here = |part: &&Part<'_, '_>| program.line(part.expression.span) == number;
    let label = program.at(Place::Label).find(is_here);
    if let Some(StatementKind::Case { selector, .. }) = label.and_then(|part| Some(&part.statement?.kind))
        && !code.contains(" OF ")
    {
        return format!("CASE {} OF {code}", program.text(*selector));
    }
    let next = program.line_text(number + 1).unwrap_or_default().trim();
    let opens = |line: &str| [" DO", " THEN", "ELSE"].iter().any(|word| line.ends_with(word));
    let before = program
        .line_text(number.saturating_sub(1))
        .unwrap_or_default()
        .trim();
    // What ends too early or too late is what stands before it.
    if code.starts_with("END_") && !before.starts_with("END_") {
        return format!("{before} {code}").trim_start().to_owned();
    }
    // A CASE says little without its first label.
    if code.ends_with(" OF") && next.ends_with(':') {
        return format!("{code} {next}");
    }
    let opens = opens(code);
    match next.split(';').next() {
        Some(end) if opens && end.starts_with("END_") => format!("{code} {end}"),
        _ => code.to_owned(),
    }
}

/// Returns the name of a function with the type of its result, where a line of the function assigns or reads it.
fn result_of(program: &ReadProgram<'_, '_>, number: u32, name: &str) -> Option<String> {
    let is_here = |part: &&Part<'_, '_>| {
        let is_named = part.name().is_some_and(|one| one.eq_ignore_ascii_case(name));
        is_named && part.place != Place::Callee && program.line(part.expression.span) == number
    };
    let pou = program.parts.iter().find(is_here)?.pou?;
    let result = pou.result.as_ref().filter(|_| pou.name.is(name))?;
    let ty = written_type(program, result, None)?;
    Some(format!("result {} : {ty}", pou.name.text))
}

/// Returns a name with the location, the type and the initial value with which a program declares it, as they are written; of what is
/// no plain variable the type alone, and nothing of a structure.
fn declared_as(program: &ReadProgram<'_, '_>, declared: &DeclaredName<'_, '_>) -> Option<String> {
    let group = declared.group?;
    let is_plain = matches!(group.specification.kind, TypeSpecificationKind::Named(_));
    let location = group
        .location
        .map_or(String::new(), |place| format!(" AT {}", place.text));
    let value = group.initializer.as_ref().filter(|_| is_plain);
    let ty = written_type(program, &group.specification, value)?;
    Some(format!("{}{location} : {ty}", declared.name.text))
}

/// Returns the name and the kind of a type of the program's own that variables have; `None` of another type.
fn definition(program: &ReadProgram<'_, '_>, ty: &TypeSpecification<'_>) -> Option<String> {
    let TypeSpecificationKind::Named(name) = &ty.kind else {
        return None;
    };
    if let Some(pou) = program.unit.pous().find(|pou| pou.name.is(name.text)) {
        let implements: Vec<&str> = pou.implements.iter().map(|name| name.text).collect();
        let implements = match &implements[..] {
            [] => String::new(),
            names => format!(" IMPLEMENTS {}", names.join(", ")),
        };
        let kind = words(pou.span.text(program.text)).into_iter().next()?;
        return Some(format!("{} : {kind}{implements}", pou.name.text));
    }
    let declared = program.declared_type(name.text)?;
    let written = match declared.specification.kind {
        TypeSpecificationKind::Structure(_) => "STRUCT".to_owned(),
        _ => written_type(program, &declared.specification, declared.initializer.as_ref())?,
    };
    Some(format!("{} : {written}", declared.name.text))
}

/// Returns a type with an initial value, as they are written; nothing of a structure.
fn written_type(
    program: &ReadProgram<'_, '_>,
    ty: &TypeSpecification<'_>,
    value: Option<&Initializer<'_>>,
) -> Option<String> {
    if let TypeSpecificationKind::Structure(_) | TypeSpecificationKind::Error = ty.kind {
        return None;
    }
    let text = |span: Span| span.text(program.text);
    let value = value.map_or(String::new(), |value| format!(" := {}", text(value.span)));
    Some(clipped(&format!("{}{value}", text(ty.span)))).filter(|ty| !ty.is_empty())
}

/// Where a line of a program stands.
#[derive(Clone, Copy)]
pub(crate) enum LinePlace<'t, 's> {
    /// In a declaration of types.
    Types,
    /// In a section of variables.
    Section(&'t VariableBlock<'s>),
    /// In a body, or outside of all.
    Statement,
}

/// Returns where a line of a program stands.
pub(crate) fn place_of<'t, 's>(program: &ReadProgram<'t, 's>, number: u32) -> LinePlace<'t, 's> {
    let line = |byte: u32| program.lines.line(byte);
    let covers = |start: u32, end: u32| (line(start)..=line(end.saturating_sub(1))).contains(&number);
    // The statements of a body stand in the order of the text; a program may have many thousands.
    let is_stated = |pou: &Pou<'_>| {
        let before = pou
            .body
            .partition_point(|statement| line(statement.span.start) < number);
        let first = pou.body.get(before);
        first.is_some_and(|statement| line(statement.span.start) == number)
    };
    for declaration in &program.program.unit.declarations {
        let sections = match declaration {
            Declaration::Types(types) => {
                let mut spans = types
                    .iter()
                    .map(|one| (one.name.span.start, one.specification.span.end));
                if spans.any(|(start, end)| covers(start, end)) {
                    return LinePlace::Types;
                }
                &[]
            }
            Declaration::Pou(pou) if is_stated(pou) => &[],
            Declaration::Pou(pou) => &pou.blocks[..],
            Declaration::Globals(section) => std::slice::from_ref(section),
            Declaration::Configuration(configuration) => &configuration.globals[..],
            Declaration::Namespace(_) | Declaration::EndNamespace(_) | Declaration::Using(_) => &[],
        };
        let mut sections = sections.iter();
        if let Some(section) = sections.find(|section| covers(section.span.start, section.span.end)) {
            return LinePlace::Section(section);
        }
    }
    LinePlace::Statement
}

/// Returns the word of the section of variables that a line stands in, unless that is the plain one or that of the inputs; of constants, that
/// they are.
pub(crate) fn special_section<'s>(program: &ReadProgram<'_, 's>, number: u32) -> Option<&'s str> {
    section(program, number).filter(|section| *section != "VAR_INPUT")
}

/// Returns the word of the section of variables that a line stands in, unless that is the plain one; of constants, that they are.
fn section<'s>(program: &ReadProgram<'_, 's>, number: u32) -> Option<&'s str> {
    let LinePlace::Section(section) = place_of(program, number) else {
        return None;
    };
    let text = section.span.text(program.program.text);
    let head = text
        .split(|sign: char| !sign.is_ascii_alphanumeric() && sign != '_')
        .next()?;
    match head {
        "VAR" if section.constant => Some("VAR CONSTANT"),
        "VAR_EXTERNAL" if section.constant => Some("VAR_EXTERNAL CONSTANT"),
        "VAR_GLOBAL" if section.constant => Some("VAR_GLOBAL CONSTANT"),
        "VAR" => None,
        _ => Some(head),
    }
}

/// Returns the kind of unit or member that a line of a program stands in, unless that is a PROGRAM.
pub(crate) fn unit_of(program: &ReadProgram<'_, '_>, number: u32) -> Option<&'static str> {
    let begins_before = |pou: &&Pou<'_>| program.line(pou.span) <= number;
    let unit = program.unit.pous().rfind(begins_before)?;
    let is_around = |pou: &&Pou<'_>| begins_before(pou) && program.line(pou.end) >= number;
    match unit.members.iter().rfind(is_around).unwrap_or(unit).kind {
        PouKind::Program => None,
        PouKind::Method => Some("a METHOD"),
        PouKind::Getter => Some("a GET"),
        PouKind::Setter => Some("a SET"),
        PouKind::Function => Some("a FUNCTION"),
        PouKind::Interface => Some("an INTERFACE"),
        _ => Some("a FUNCTION_BLOCK"),
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

/// Returns a text of one line and no more than a title has room for. Of a sign that is repeated many times the number is told.
pub(crate) fn clipped(text: &str) -> String {
    let line = text.lines().next().unwrap_or_default().trim();
    let same = |from: &usize| {
        let mut behind = line[*from..].chars();
        let first = behind.next();
        1 + behind.take_while(|sign| Some(*sign) == first).count()
    };
    let mut places = line.char_indices().map(|(at, _)| at);
    let is_sign = |from: &usize| line.as_bytes()[*from].is_ascii_punctuation();
    let repeated = places.find(|from| is_sign(from) && same(from) > MAX_REPEATED);
    if let Some(from) = repeated {
        let (before, number) = (&line[..from], same(&from));
        let mut behind = line[from..].chars();
        let sign = behind.next().unwrap_or_default();
        let rest: String = behind.skip(number - 1).collect();
        return clipped(&format!("{before}{sign}{sign}… ({number} times){rest}"));
    }
    match line.char_indices().nth(MAX_LENGTH) {
        Some((end, _)) => format!("{}…", &line[..end]),
        None => line.to_owned(),
    }
}
