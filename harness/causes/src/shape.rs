//! The shape of a program: a form in which names are equal, as are types of one kind and literals of one kind.

use crate::program::Program;
use crate::words::{elementary, is_number, opens_declarations, tokens, type_of_word};
use crate::work::{exponent, families};
use std::collections::BTreeMap;
use stickler_syntax::token::{Token, TokenKind};
use stickler_types::ElementaryType;

/// The amount of detail in which a shape keeps its types.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum KeptTypes {
    /// Types of one family are equal: those that differ in width or range.
    Families,
    /// All elementary types are equal.
    Equal,
}

/// Returns the shape of a program.
///
/// Names are numbered in the order in which the bodies use them, and the declarations of a section are sorted, so that
/// neither the choice of names nor the order of declarations matters. The names of functions stay, since they say what is
/// computed; of a conversion function the families of its types stay.
pub(crate) fn shape(text: &str, types: KeptTypes) -> String {
    let program = Program::new(text);
    let program = program.read();
    let all = tokens(text);
    let mut numbers = BTreeMap::new();
    let declared = in_declarations(&all);
    // First the names of bodies, then those only declared.
    for wanted in [false, true] {
        let here = all
            .iter()
            .zip(&declared)
            .filter(|(_, declared)| **declared == wanted);
        for (token, _) in here.filter(|(token, _)| is_name(token, text)) {
            let next = numbers.len() + 1;
            numbers
                .entry(token.span.text(text).to_ascii_uppercase())
                .or_insert(next);
        }
    }
    let word = |(at, token): (usize, &Token)| {
        let written = token.span.text(text);
        let is_called = all
            .get(at + 1)
            .is_some_and(|next| next.kind == TokenKind::LeftParen);
        match numbers.get(&written.to_ascii_uppercase()) {
            Some(_) if is_called && !program.declares(written) => families(written),
            Some(number) => format!("v{number}"),
            None => form(written, token.kind, types),
        }
    };
    let words: Vec<String> = all.iter().enumerate().map(word).collect();
    sorted_sections(&all, &words)
}

/// Returns the form of the token at a place, for telling messages apart; empty where no token begins there.
pub(crate) fn token_at(text: &str, line: u32, column: u32) -> String {
    let program = Program::new(text);
    let is_there = |token: &&Token| {
        let place = program.lines.position(text, token.span.start);
        (place.line, place.column) == (line, column)
    };
    match tokens(text).iter().find(is_there) {
        Some(token) if is_name(token, text) => "name".to_owned(),
        Some(token) => form(token.span.text(text), token.kind, KeptTypes::Equal),
        None => String::new(),
    }
}

/// Returns for each token whether it stands in a section of variables or of types.
fn in_declarations(tokens: &[Token]) -> Vec<bool> {
    let mut inside = false;
    let is_inside = |token: &Token| {
        let was = inside;
        inside = match token.kind {
            TokenKind::EndVar | TokenKind::EndType => false,
            kind => inside || opens_declarations(kind),
        };
        was || inside
    };
    tokens.iter().map(is_inside).collect()
}

/// Returns whether a token is a name, and neither a keyword nor an elementary type.
pub(crate) fn is_name(token: &Token, text: &str) -> bool {
    token.kind == TokenKind::Name && elementary(token.span.text(text)).is_none()
}

/// Returns the form of a word or sign.
fn form(written: &str, kind: TokenKind, types: KeptTypes) -> String {
    let upper = written.to_ascii_uppercase();
    match kind {
        TokenKind::True | TokenKind::False => "bool".to_owned(),
        TokenKind::Partial | TokenKind::Direct => upper
            .trim_end_matches(|last: char| last.is_ascii_digit() || last == '.')
            .to_owned(),
        _ if upper.starts_with(['\'', '"']) => text_form(&upper),
        _ if upper.starts_with(|first: char| first.is_ascii_digit()) => number(&upper),
        _ => match (upper.split_once('#'), type_of_word(&upper)) {
            (None, Some(ty)) => type_form(ty, types),
            (Some((_, value)), Some(ty)) if is_number(ty) => {
                format!(
                    "{}#{}",
                    type_form(ty, types),
                    number(value.trim_start_matches(['-', '+']))
                )
            }
            (Some((prefix, value)), _) if value.starts_with(['\'', '"']) => {
                format!("{prefix}#{}", text_form(value))
            }
            // The prefix of a date or time is a part of its form.
            (Some((prefix, _)), _) => format!("{prefix}#literal"),
            _ => upper,
        },
    }
}

fn type_form(ty: ElementaryType, types: KeptTypes) -> String {
    match types {
        KeptTypes::Equal => "type".to_owned(),
        KeptTypes::Families => format!("{:?}", ty.family()).to_lowercase(),
    }
}

/// Returns the form of a number: its base, and whether it is a real number and how large its exponent is.
fn number(upper: &str) -> String {
    match upper.split_once('#') {
        Some((base, _)) => format!("{base}#digits"),
        None if upper.contains('E') => exponent(upper).to_owned(),
        None if upper.contains('.') => "real".to_owned(),
        None => "integer".to_owned(),
    }
}

/// Returns the form of a character string: its kind of quotes, and the kind of its escapes.
fn text_form(text: &str) -> String {
    let quote = text.get(..1).unwrap_or_default();
    format!("{quote}{}{quote}", escape(text).unwrap_or_default())
}

/// Returns the kind of the escapes of a character string: one by a number may take a digit behind it for its own. `None` where it has none.
pub(crate) fn escape(text: &str) -> Option<&'static str> {
    let digits = if text.starts_with('"') { 4 } else { 2 };
    let mut pieces = text.split('$').skip(1).peekable();
    pieces.peek()?;
    let runs_on = |piece: &str| piece.chars().take_while(char::is_ascii_hexdigit).count() > digits;
    Some(match pieces.any(runs_on) {
        true => "escape by a number before a digit",
        false => "escape in a text",
    })
}

/// Joins the words of a program, and sorts the declarations of each section of variables; each name gets a declaration of its own.
fn sorted_sections(tokens: &[Token], words: &[String]) -> String {
    let mut parts: Vec<String> = Vec::new();
    let mut rest = tokens.iter().map(|token| token.kind).zip(words).peekable();
    while let Some((kind, word)) = rest.next() {
        parts.push(word.clone());
        if !kind.opens_section() {
            continue;
        }
        let is_option = |(kind, _): &(TokenKind, &String)| {
            matches!(
                kind,
                TokenKind::Constant | TokenKind::Retain | TokenKind::NonRetain
            )
        };
        while let Some((_, option)) = rest.next_if(is_option) {
            parts.push(option.clone());
        }
        let mut declarations = Vec::new();
        let mut one: Vec<&str> = Vec::new();
        while let Some((kind, word)) = rest.next_if(|(kind, _)| *kind != TokenKind::EndVar) {
            match kind {
                TokenKind::Semicolon => declarations.extend(one_a_name(&std::mem::take(&mut one))),
                _ => one.push(word),
            }
        }
        if !one.is_empty() {
            declarations.extend(one_a_name(&one));
        }
        declarations.sort();
        parts.extend(declarations);
    }
    parts.join(" ")
}

/// Returns a declaration of several names as one declaration for each.
fn one_a_name(declaration: &[&str]) -> Vec<String> {
    let colon = declaration
        .iter()
        .position(|word| *word == ":")
        .unwrap_or_default();
    let (names, rest) = declaration.split_at(colon);
    let names = names.split(|word| *word == ",");
    names
        .map(|name| format!("{} {} ;", name.join(" "), rest.join(" ")))
        .collect()
}
