//! The shape of a program: a form in which names, and types and literals of one kind, are equal.

use crate::tokens::{ProgramToken, ProgramTokenKind, tokens};
use std::collections::{BTreeMap, BTreeSet};
use stickler_syntax::token::TokenKind;
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
pub(crate) fn shape(program: &str, types: KeptTypes) -> String {
    let tokens = tokens(program);
    let declared = in_declarations(&tokens);
    let mut names = NameNumbers::default();
    let body = tokens.iter().zip(&declared).filter(|(_, declared)| !**declared);
    let rest = tokens.iter().zip(&declared).filter(|(_, declared)| **declared);
    let own = own_functions(&tokens);
    for (token, _) in body.chain(rest) {
        if token.kind == ProgramTokenKind::Word {
            names.number(token.text);
        }
    }
    let calls = calls(&tokens);
    let words: Vec<String> = (0..tokens.len())
        .map(|at| {
            let is_foreign = calls[at] && !own.contains(&tokens[at].text.to_ascii_uppercase());
            normal(&tokens[at], types, is_foreign, &names)
        })
        .collect();
    sorted_sections(&tokens, &words)
}

/// Returns the elementary types that a program names, in the order of their first appearance in its shape.
pub(crate) fn types_of(program: &str) -> Vec<&'static str> {
    let mut found = Vec::new();
    for token in tokens(program) {
        let ty = match token.kind {
            ProgramTokenKind::Word => elementary(token.text),
            _ => None,
        };
        if let Some(ty) = ty
            && !found.contains(&ty.name())
        {
            found.push(ty.name());
        }
    }
    found
}

/// Returns the normal form of the token at a place, for telling messages apart; empty where no token begins there.
pub(crate) fn token_at(program: &str, line: u32, column: u32) -> String {
    let tokens = tokens(program);
    let at = tokens
        .iter()
        .find(|token| token.line == line && token.column == column);
    match at {
        Some(token) if token.kind == ProgramTokenKind::Word && !is_fixed(token.text) => "name".to_owned(),
        Some(token) => normal(token, KeptTypes::Equal, false, &NameNumbers::default()),
        None => String::new(),
    }
}

/// The numbers of the names of a program.
#[derive(Default)]
struct NameNumbers(BTreeMap<String, usize>);

impl NameNumbers {
    fn number(&mut self, name: &str) {
        let next = self.0.len() + 1;
        if !is_fixed(name) {
            self.0.entry(name.to_ascii_uppercase()).or_insert(next);
        }
    }
}

fn elementary(word: &str) -> Option<ElementaryType> {
    ElementaryType::from_name(&word.to_ascii_uppercase())
}

/// Returns whether a word is a keyword, a type or a truth value.
pub(crate) fn is_fixed(word: &str) -> bool {
    TokenKind::of_word(word).is_keyword() || elementary(word).is_some()
}

/// Returns for each token whether it stands in a section of variables or of types.
pub(crate) fn in_declarations(tokens: &[ProgramToken<'_>]) -> Vec<bool> {
    let mut inside = false;
    let of = |token: &ProgramToken<'_>| {
        let upper = token.text.to_ascii_uppercase();
        match token.kind {
            ProgramTokenKind::Word if upper == "END_VAR" || upper == "END_TYPE" => inside = false,
            ProgramTokenKind::Word if upper == "VAR" || upper.starts_with("VAR_") || upper == "TYPE" => {
                inside = true
            }
            _ => return inside,
        }
        true
    };
    tokens.iter().map(of).collect()
}

/// Returns for each token whether it is a name before an opening bracket.
fn calls(tokens: &[ProgramToken<'_>]) -> Vec<bool> {
    let behind = tokens
        .iter()
        .skip(1)
        .map(|token| token.text == "(")
        .chain([false]);
    let words = tokens.iter().map(|token| token.kind == ProgramTokenKind::Word);
    words.zip(behind).map(|(word, call)| word && call).collect()
}

/// Returns the names that the program declares: of program organization units, variables and types.
pub(crate) fn own_functions(tokens: &[ProgramToken<'_>]) -> BTreeSet<String> {
    let mut own = BTreeSet::new();
    for pair in tokens.windows(2) {
        let heads = ["FUNCTION", "FUNCTION_BLOCK", "PROGRAM", "TYPE"];
        if heads.iter().any(|head| pair[0].is(head)) {
            own.insert(pair[1].text.to_ascii_uppercase());
        }
        if pair[0].kind == ProgramTokenKind::Word && matches!(pair[1].text, ":" | ",") {
            own.insert(pair[0].text.to_ascii_uppercase());
        }
    }
    own
}

/// Returns the normal form of a token. `is_foreign` where it is the name of a function that the program does not declare.
fn normal(token: &ProgramToken<'_>, types: KeptTypes, is_foreign: bool, names: &NameNumbers) -> String {
    let upper = token.text.to_ascii_uppercase();
    match token.kind {
        ProgramTokenKind::Word if is_foreign => function(&upper),
        ProgramTokenKind::Word => match elementary(&upper) {
            Some(ty) => type_word(ty, types),
            None if upper == "TRUE" || upper == "FALSE" => "bool".to_owned(),
            None => names.0.get(&upper).map_or(upper, |number| format!("v{number}")),
        },
        ProgramTokenKind::Number => number(&upper),
        ProgramTokenKind::Text => text(token.text),
        ProgramTokenKind::Typed => {
            let (prefix, value) = upper.split_once('#').unwrap_or(("", &upper));
            let prefix = match ElementaryType::from_literal_prefix(prefix) {
                // The prefix of a date or time is a part of its form.
                Some(ty) if ty.is_integer() || ty.is_bit_string() || ty.is_real() => type_word(ty, types),
                _ => prefix.to_owned(),
            };
            let value = match value.trim_start_matches(['-', '+']) {
                text_value if text_value.starts_with(['\'', '"']) => text(text_value),
                digits if prefix.len() > 1 && digits.starts_with(|c: char| c.is_ascii_digit()) => {
                    number(digits)
                }
                _ => "literal".to_owned(),
            };
            format!("{prefix}#{value}")
        }
        ProgramTokenKind::Partial => upper.trim_end_matches(|c: char| c.is_ascii_digit()).to_owned(),
        ProgramTokenKind::Sign => upper,
    }
}

fn type_word(ty: ElementaryType, types: KeptTypes) -> String {
    match types {
        KeptTypes::Equal => "type".to_owned(),
        KeptTypes::Families => format!("{:?}", ty.family()).to_lowercase(),
    }
}

/// Returns the name of a function with the types in it replaced by their families: `INT_TO_REAL` is `signed_TO_real`, and
/// `TRUNC_LINT` is `TRUNC_signed`.
pub(crate) fn function(upper: &str) -> String {
    let part = |part: &str| match elementary(part) {
        Some(ty) => type_word(ty, KeptTypes::Families),
        None => part.to_owned(),
    };
    let side = |side: &str| match elementary(side) {
        Some(ty) => type_word(ty, KeptTypes::Families),
        None => side.split('_').map(part).collect::<Vec<_>>().join("_"),
    };
    let sides: Vec<String> = upper.split("_TO_").map(side).collect();
    sides.join("_TO_")
}

/// Returns the form of a number: its base, and whether it is a real number and how large its exponent is.
pub(crate) fn number(upper: &str) -> String {
    if let Some((base, _)) = upper.split_once('#') {
        return format!("{base}#digits");
    }
    let is_real = upper.contains('.');
    match upper.split_once('E').map(|(_, exponent)| exponent.parse::<i32>()) {
        // REAL ends at 3.4E38.
        Some(Ok(exponent)) if exponent.abs() > 37 => "real-beyond-REAL".to_owned(),
        Some(_) => "real-with-exponent".to_owned(),
        None if is_real => "real".to_owned(),
        None => "integer".to_owned(),
    }
}

/// Returns the form of a character string: its kind of quotes, and whether it has an escape.
pub(crate) fn text(text: &str) -> String {
    let kind = if text.starts_with('\'') {
        "'text'"
    } else {
        "\"text\""
    };
    match text.contains('$') {
        true => format!("{kind}-with-escape"),
        false => kind.to_owned(),
    }
}

/// Joins the words of a program, and sorts the declarations of each section of variables; each name has its own.
fn sorted_sections(tokens: &[ProgramToken<'_>], words: &[String]) -> String {
    let mut parts: Vec<String> = Vec::new();
    let mut at = 0;
    while at < tokens.len() {
        let upper = tokens[at].text.to_ascii_uppercase();
        let opens =
            tokens[at].kind == ProgramTokenKind::Word && (upper == "VAR" || upper.starts_with("VAR_"));
        if !opens {
            parts.push(words[at].clone());
            at += 1;
            continue;
        }
        let end = (at..tokens.len()).find(|&end| tokens[end].is("END_VAR"));
        let end = end.unwrap_or(tokens.len());
        let mut head = at + 1;
        while head < end && ["CONSTANT", "RETAIN", "NON_RETAIN"].contains(&&*words[head]) {
            head += 1;
        }
        parts.push(words[at..head].join(" "));
        let mut declarations: Vec<String> = Vec::new();
        for declaration in words[head..end]
            .split(|word| word == ";")
            .filter(|one| !one.is_empty())
        {
            declarations.extend(one_a_name(declaration));
        }
        declarations.sort();
        parts.extend(declarations);
        at = end;
    }
    parts.join(" ")
}

/// Returns a declaration of several names as one declaration for each.
fn one_a_name(declaration: &[String]) -> Vec<String> {
    let colon = declaration.iter().position(|word| word == ":");
    let Some(colon) = colon else {
        return vec![declaration.join(" ")];
    };
    let (names, rest) = declaration.split_at(colon);
    let names = names.split(|word| word == ",");
    names
        .map(|name| format!("{} {} ;", name.join(" "), rest.join(" ")))
        .collect()
}

/// Returns the end of the variable that begins at a token, with its fields and subscripts and without a bit; `None` where none
/// begins there.
pub(crate) fn path(all: &[ProgramToken<'_>], at: usize) -> Option<usize> {
    let token = all.get(at)?;
    let is_behind_point = at > 0 && all[at - 1].text == ".";
    if token.kind != ProgramTokenKind::Word || is_fixed(token.text) || is_behind_point {
        return None;
    }
    let mut end = at + 1;
    loop {
        match all.get(end).map(|token| token.text) {
            Some("[") => end = closed(all, end)?,
            Some(".")
                if all
                    .get(end + 1)
                    .is_some_and(|next| next.kind == ProgramTokenKind::Word) =>
            {
                end += 2
            }
            _ => return Some(end),
        }
    }
}

/// Returns the place behind the bracket that closes the one at a place.
fn closed(all: &[ProgramToken<'_>], open: usize) -> Option<usize> {
    let mut depth = 0_usize;
    for (at, token) in all.iter().enumerate().skip(open) {
        match token.text {
            "[" => depth += 1,
            "]" => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return Some(at + 1);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::{KeptTypes, shape, token_at};

    fn same(one: &str, other: &str, types: KeptTypes) -> bool {
        shape(one, types) == shape(other, types)
    }

    #[test]
    fn names_and_the_order_of_declarations_do_not_matter() {
        let one = "PROGRAM main VAR from : INT := 5; into : REAL; END_VAR into := from; END_PROGRAM";
        let other = "PROGRAM p VAR r : REAL; (* c *) x : DINT := -1; END_VAR r := x; END_PROGRAM";
        assert!(
            !same(one, other, KeptTypes::Families),
            "the sign of a literal matters"
        );
        let other = other.replace('-', "");
        assert!(same(one, &other, KeptTypes::Families));
        let swapped = "PROGRAM p VAR r : INT; x : REAL := 1; END_VAR r := x; END_PROGRAM";
        assert!(!same(one, swapped, KeptTypes::Families));
        assert!(same(one, swapped, KeptTypes::Equal));
        let several = "PROGRAM p VAR a, b : INT; END_VAR a := b; END_PROGRAM";
        let single = "PROGRAM p VAR b : INT; a : INT; END_VAR a := b; END_PROGRAM";
        assert!(same(several, single, KeptTypes::Families));
    }

    #[test]
    fn the_forms_of_literals_and_the_names_of_functions_matter() {
        let of = |value: &str| {
            shape(
                &format!("PROGRAM p VAR x : LREAL; END_VAR x := {value}; END_PROGRAM"),
                KeptTypes::Equal,
            )
        };
        for (one, other, alike) in [
            ("1.0", "2.5", true),
            ("1.0", "1.0E300", false),
            ("1.0E5", "1.0E300", false),
            ("16#FF", "2#1", false),
            ("INT#5", "DINT#7", true),
            ("T#5ms", "LTIME#5ms", false),
            ("'a'", "'$L'", false),
            ("INT_TO_LREAL(y)", "DINT_TO_REAL(z)", true),
            ("INT_TO_LREAL(y)", "BOOL_TO_LREAL(y)", false),
            ("SIN(y)", "COS(y)", false),
        ] {
            assert_eq!(of(one) == of(other), alike, "{one} {other}");
        }
    }

    #[test]
    fn the_token_at_a_place_is_told_by_its_kind() {
        let program = "PROGRAM p\nVAR x : INT := c; END_VAR";
        assert_eq!(token_at(program, 2, 16), "name");
        assert_eq!(token_at(program, 2, 13), ":=");
        assert_eq!(token_at(program, 2, 9), "type");
        assert_eq!(token_at(program, 2, 10), "");
    }
}
