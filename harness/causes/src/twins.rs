//! Programs that differ from another in one property: of a literal, of a type, of an operand.

use crate::shape::path;
use crate::tokens::{ProgramToken, ProgramTokenKind, tokens};
use std::collections::BTreeSet;
use stickler_types::ElementaryType;

/// The numeric types in the order in which they are tried for another.
const PLAIN: [&str; 13] = [
    "INT", "DINT", "UINT", "UDINT", "WORD", "DWORD", "LINT", "ULINT", "LWORD", "SINT", "USINT", "BYTE",
    "REAL",
];

/// The bit strings and the unsigned integers of the same size.
const UNSIGNED: [(&str, &str); 4] = [
    ("BYTE", "USINT"),
    ("WORD", "UINT"),
    ("DWORD", "UDINT"),
    ("LWORD", "ULINT"),
];

/// The replacement of types by others.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct TypeChange(Vec<(&'static str, &'static str)>);

impl TypeChange {
    /// Returns a program with the types replaced in declarations, prefixes and names of functions; as it is where it has one
    /// of the other types already, since then two types would become one.
    pub(crate) fn of(&self, program: &str) -> String {
        let types = types(program);
        match self.0.iter().any(|(_, into)| types.contains(into)) {
            true => program.to_owned(),
            false => self.everywhere(program),
        }
    }

    /// Returns the type that takes the place of a type, which may be itself.
    pub(crate) fn changed<'n>(&self, name: &'n str) -> &'n str {
        let change = self.0.iter().find(|(from, _)| *from == name);
        change.map_or(name, |(_, into)| into)
    }

    fn everywhere(&self, program: &str) -> String {
        let changed = |token: &ProgramToken<'_>| match token.kind {
            ProgramTokenKind::Word => {
                let parts: Vec<&str> = token.text.split('_').map(|part| self.changed(part)).collect();
                parts.join("_")
            }
            ProgramTokenKind::Typed => match token.text.split_once('#') {
                Some((prefix, value)) => format!("{}#{value}", self.changed(prefix)),
                None => token.text.to_owned(),
            },
            _ => token.text.to_owned(),
        };
        replaced(program, |_, token| changed(token))
    }
}

/// Returns the changes of numeric types to those that come first among their neighbours, in the order in which they are tried.
pub(crate) fn plainer_types(program: &str) -> Vec<TypeChange> {
    let there = types(program);
    let bit_strings: Vec<_> = UNSIGNED
        .into_iter()
        .filter(|(bits, _)| there.contains(bits))
        .collect();
    let mut found = Vec::new();
    // A conversion between two of them has to keep both sizes.
    if bit_strings.len() > 1 {
        found.push(TypeChange(bit_strings));
    }
    for name in there {
        let Some(ty) = ElementaryType::from_name(name) else {
            continue;
        };
        let plainer = PLAIN.iter().take_while(|plain| **plain != name);
        let is_neighbour = |plain: &&&str| {
            ElementaryType::from_name(plain).is_some_and(|other| other.is_real() == ty.is_real())
        };
        let is_number = ty.is_integer() || ty.is_bit_string() || ty.is_real();
        found.extend(
            plainer
                .filter(is_neighbour)
                .filter(|_| is_number)
                .map(|plain| TypeChange(vec![(name, *plain)])),
        );
    }
    found
}

/// Returns a program with one of its types in the place of another, for each pair of types that it has.
pub(crate) fn with_same_types(program: &str) -> Vec<String> {
    let types: Vec<&'static str> = types(program).into_iter().collect();
    let mut found = Vec::new();
    for from in &types {
        for into in types.iter().filter(|into| *into != from) {
            found.push(TypeChange(vec![(*from, *into)]).everywhere(program));
        }
    }
    found
}

/// Returns the elementary types that a program names anywhere.
fn types(program: &str) -> BTreeSet<&'static str> {
    let mut found = BTreeSet::new();
    for token in tokens(program) {
        let upper = token.text.to_ascii_uppercase();
        let parts: Vec<&str> = match token.kind {
            ProgramTokenKind::Word => upper.split('_').collect(),
            ProgramTokenKind::Typed => upper.split('#').take(1).collect(),
            _ => continue,
        };
        let known = parts.into_iter().filter_map(ElementaryType::from_name);
        found.extend(known.map(ElementaryType::name));
    }
    found
}

/// Returns a program with the number at this place, counted in tokens, made plainer: with fewer of sign, fraction and size,
/// the plainest first. Empty where no such number stands there.
pub(crate) fn plainer_literals(program: &str, place: usize) -> Vec<String> {
    let tokens = tokens(program);
    let Some(number) = PlainNumber::at(&tokens, place) else {
        return Vec::new();
    };
    let mut found = Vec::new();
    for (negative, fraction, large) in [
        (false, false, false),
        (true, false, false),
        (false, true, false),
        (false, false, true),
        (true, true, false),
        (true, false, true),
        (false, true, true),
    ] {
        let plainer = number.with(negative, fraction, large);
        let Some(text) = plainer.filter(|text| *text != number.text()) else {
            continue;
        };
        found.push(replaced(program, |at, token| match at {
            _ if at == place => format!("{}{text}", number.prefix),
            _ if number.sign == Some(at) => String::new(),
            _ => token.text.to_owned(),
        }));
    }
    found
}

/// Returns what is special about the numbers and the numeric types of a program that computes a wrong value.
pub(crate) fn value_features(program: &str) -> BTreeSet<String> {
    let tokens = tokens(program);
    let mut found = BTreeSet::new();
    for place in 0..tokens.len() {
        if let Some(number) = PlainNumber::at(&tokens, place) {
            let features = [
                (number.negative, "negative number"),
                (number.fraction.is_some(), "fraction"),
                (number.whole.len() > 1 || number.exponent, "large number"),
            ];
            let there = features.iter().filter(|(there, _)| *there);
            found.extend(there.map(|(_, feature)| (*feature).to_owned()));
        }
    }
    let special = types(program)
        .into_iter()
        .filter(|name| !matches!(*name, "INT" | "REAL" | "BOOL"));
    let numbers = special.filter(|name| PLAIN.contains(name) || *name == "LREAL");
    found.extend(numbers.map(str::to_owned));
    found
}

/// A decimal number of a program.
struct PlainNumber<'t> {
    prefix: String,
    /// The place of a minus before the number.
    sign: Option<usize>,
    negative: bool,
    /// The digits before the point.
    whole: &'t str,
    /// The digits behind the point, where they are not zero.
    fraction: Option<&'t str>,
    is_real: bool,
    exponent: bool,
    digits: &'t str,
}

impl<'t> PlainNumber<'t> {
    fn at(tokens: &[ProgramToken<'t>], place: usize) -> Option<PlainNumber<'t>> {
        let token = tokens.get(place)?;
        let before = place.checked_sub(1).map(|before| tokens[before].text);
        let behind = tokens.get(place + 1).map(|behind| behind.text);
        // Bounds, subscripts and bits are no values.
        if matches!(before, Some("[" | "." | "..")) || matches!(behind, Some("]" | "..")) {
            return None;
        }
        let (prefix, text) = match token.kind {
            ProgramTokenKind::Number if !token.text.contains('#') => ("", token.text),
            ProgramTokenKind::Typed => token.text.split_once('#')?,
            _ => return None,
        };
        let is_number = prefix.is_empty()
            || ElementaryType::from_name(prefix)
                .is_some_and(|ty| ty.is_integer() || ty.is_bit_string() || ty.is_real());
        let digits = text.trim_start_matches(['-', '+']);
        if !is_number || !digits.starts_with(|first: char| first.is_ascii_digit()) || digits.contains('#') {
            return None;
        }
        let is_signed = before == Some("-")
            && place.checked_sub(2).is_some_and(|before| {
                tokens[before].kind == ProgramTokenKind::Sign && !matches!(tokens[before].text, ")" | "]")
            });
        let (whole, rest) = digits.split_once('.').unwrap_or((digits, ""));
        Some(PlainNumber {
            prefix: if prefix.is_empty() {
                String::new()
            } else {
                format!("{prefix}#")
            },
            sign: place.checked_sub(1).filter(|_| is_signed),
            negative: is_signed || text.starts_with('-'),
            whole,
            fraction: Some(rest)
                .filter(|rest| !rest.contains(['E', 'e']) && !rest.trim_matches('0').is_empty()),
            is_real: digits.contains('.'),
            exponent: digits.contains(['E', 'e']),
            digits,
        })
    }

    /// Returns the number with its sign.
    fn text(&self) -> String {
        format!("{}{}", if self.negative { "-" } else { "" }, self.digits)
    }

    /// Returns the number with these of its properties only; `None` where it does not have one of them.
    fn with(&self, negative: bool, fraction: bool, large: bool) -> Option<String> {
        let is_large = self.whole.len() > 1 || self.exponent;
        let has = |wanted: bool, there: bool| !wanted || there;
        let is_there =
            has(negative, self.negative) && has(fraction, self.fraction.is_some()) && has(large, is_large);
        // The digits of a number with an exponent stay together.
        if !is_there || self.exponent && (large || fraction) {
            return None;
        }
        let whole = if large { self.whole } else { "1" };
        let rest = match (self.is_real, self.fraction.filter(|_| fraction)) {
            (true, Some(_)) if !large => ".5".to_owned(),
            (true, Some(digits)) => format!(".{digits}"),
            (true, None) => ".0".to_owned(),
            (false, _) => String::new(),
        };
        Some(format!("{}{whole}{rest}", if negative { "-" } else { "" }))
    }
}

/// Returns a program with quite another type in the place of what this line assigns, or else of an operand of the line: a text where
/// a number stands, a number where a text stands.
pub(crate) fn with_other_operand(program: &str, line: Option<u32>) -> Vec<String> {
    let all = tokens(program);
    let mut found = Vec::new();
    let offset = |token: &ProgramToken<'_>| token.text.as_ptr() as usize - program.as_ptr() as usize;
    let mut replace = |from: usize, until: usize| {
        let last = &all[until - 1];
        let (from, until) = (offset(&all[from]), offset(last) + last.text.len());
        for other in ["'a'", "T#1s"] {
            found.push(format!("{}{other}{}", &program[..from], &program[until..]));
        }
    };
    for (from, until) in assigned(&all, line).into_iter().chain(arguments(&all, line)) {
        replace(from, until);
    }
    for (at, token) in all.iter().enumerate() {
        let sign = usize::from(at > 0 && all[at - 1].text == "-");
        let is_behind = at > sign && matches!(all[at - sign - 1].text, ":=" | "(" | "[");
        let end = path(&all, at).unwrap_or(at + 1);
        let ends = all
            .get(end)
            .is_some_and(|next| matches!(next.text, ";" | ")" | "]" | ","));
        if Some(token.line) == line && is_behind && ends && token.kind != ProgramTokenKind::Sign {
            replace(at - sign, end);
        }
    }
    found
}

/// Returns where the expression begins and ends that a statement of this line assigns.
fn assigned(all: &[ProgramToken<'_>], line: Option<u32>) -> Option<(usize, usize)> {
    let start = all.iter().position(|token| Some(token.line) == line)?;
    let mut depth = 0_i32;
    let mut sign = None;
    for (at, token) in all.iter().enumerate().skip(start) {
        match token.text {
            "(" | "[" => depth += 1,
            ")" | "]" => depth -= 1,
            // The value of a declaration is looked at part by part.
            ":" => return None,
            ":=" if depth == 0 => sign = Some(at),
            ";" => return Some((sign? + 1, at)),
            _ => {}
        }
    }
    None
}

/// Returns where each argument begins and ends that is given by its name to a call on this line.
fn arguments(all: &[ProgramToken<'_>], line: Option<u32>) -> Vec<(usize, usize)> {
    let mut found = Vec::new();
    let mut depth = 0_i32;
    // The depth and the beginning of the argument that is open.
    let mut open = None;
    for (at, token) in all
        .iter()
        .enumerate()
        .filter(|(_, token)| Some(token.line) == line)
    {
        match (token.text, open) {
            ("," | ")", Some((of, from))) if of == depth => {
                found.extend((from < at).then_some((from, at)));
                open = None;
            }
            (":=", None) if depth > 0 => open = Some((depth, at + 1)),
            _ => {}
        }
        depth += match token.text {
            "(" | "[" => 1,
            ")" | "]" => -1,
            _ => 0,
        };
    }
    found
}

/// Returns a program in which each partial access selects the first bit or byte, which are there in every type; `None` where it
/// has none.
pub(crate) fn with_first_parts(program: &str) -> Option<String> {
    let first = |token: &ProgramToken<'_>| match token.kind {
        ProgramTokenKind::Partial if token.text.to_ascii_uppercase().starts_with("%X") => "%X0".to_owned(),
        ProgramTokenKind::Partial => "%B0".to_owned(),
        _ => token.text.to_owned(),
    };
    let found = replaced(program, |_, token| first(token));
    (found != program).then_some(found)
}

/// Returns a program with each token replaced by what `with` returns for it; blanks and comments stay.
fn replaced(program: &str, with: impl Fn(usize, &ProgramToken<'_>) -> String) -> String {
    let mut text = String::with_capacity(program.len());
    let start = program.as_ptr() as usize;
    let mut end = 0;
    for (place, token) in tokens(program).iter().enumerate() {
        let at = token.text.as_ptr() as usize - start;
        text.push_str(&program[end..at]);
        text.push_str(&with(place, token));
        end = at + token.text.len();
    }
    text.push_str(&program[end..]);
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_type_is_replaced_in_declarations_prefixes_and_names_of_functions() {
        let program = "PROGRAM main VAR UINT_a : UINT; END_VAR x := REAL_TO_UINT(UINT#5); END_PROGRAM";
        let change = TypeChange(vec![("UINT", "INT")]);
        assert_eq!(
            change.of(program),
            "PROGRAM main VAR INT_a : INT; END_VAR x := REAL_TO_INT(INT#5); END_PROGRAM"
        );
        assert_eq!(change.of("x : UINT; y : INT;"), "x : UINT; y : INT;");
        let changes: Vec<TypeChange> = plainer_types(program);
        let plainer = ["INT", "DINT"].map(|plain| TypeChange(vec![("UINT", plain)]));
        assert_eq!(changes, plainer, "REAL is the plainest of its kind");
        assert_eq!(
            plainer_types("x : LWORD; y : DWORD;")[0].of("x : LWORD; y : DWORD;"),
            "x : ULINT; y : UDINT;"
        );
        assert_eq!(
            with_same_types("x : REAL; y : INT;"),
            ["x : REAL; y : REAL;", "x : INT; y : INT;"]
        );
    }

    #[test]
    fn numbers_lose_their_sign_fraction_and_size_and_nothing_is_added() {
        let of = |line: &str, place: usize| plainer_literals(line, place);
        assert_eq!(
            of("x := -16384.0;", 3),
            ["x := 1.0;", "x := -1.0;", "x := 16384.0;"]
        );
        assert_eq!(of("x := REAL#3.25;", 2), ["x := REAL#1.0;", "x := REAL#1.5;"]);
        assert_eq!(of("x := 5;", 2), ["x := 1;"]);
        assert_eq!(of("x := y - 40;", 4), ["x := y - 1;"]);
        assert_eq!(of("x := -1.5E30;", 3), ["x := 1.0;", "x := -1.0;"]);
        for (line, place) in [
            ("a[7] := 1;", 2),
            ("x := w.3;", 4),
            ("a : ARRAY[0..3]", 6),
            ("t := T#7s;", 2),
        ] {
            assert_eq!(of(line, place), [""; 0], "{line}");
        }
    }

    #[test]
    fn what_is_special_of_values_is_told() {
        let of = |line: &str| value_features(line).into_iter().collect::<Vec<_>>().join(", ");
        assert_eq!(of("x := REAL_TO_UINT(-1.0);"), "UINT, negative number");
        assert_eq!(of("x := REAL_TO_INT(REAL#1.5);"), "fraction");
        assert_eq!(of("x := REAL_TO_LINT(3.4E38);"), "LINT, large number");
    }

    #[test]
    fn an_operand_of_quite_another_type_takes_the_place_of_the_last() {
        let found = with_other_operand("x : INT;\nx := -5;", Some(2));
        assert_eq!(found[0], "x : INT;\nx := 'a';");
        assert_eq!(
            with_other_operand("a[1].f := g(5);", Some(1))[0],
            "a[1].f := 'a';"
        );
        assert_eq!(with_other_operand("fb(in := -5);", Some(1))[1], "fb(in := T#1s);");
        assert_eq!(
            with_other_operand("fb(in := r.a[1]);", Some(1))[0],
            "fb(in := 'a');"
        );
        assert_eq!(
            with_other_operand("a : R := (f := 5);", Some(1))[0],
            "a : R := (f := 'a');"
        );
        assert_eq!(
            with_other_operand("fb(n := 1, in := NOT f(r.7));", Some(1))[2],
            "fb(n := 1, in := 'a');"
        );
        assert!(with_other_operand("fb(in := );", Some(1)).is_empty());
        assert_eq!(with_other_operand("x := y + 5;", Some(1))[0], "x := 'a';");
        assert!(with_other_operand("g(x + y);", Some(1)).is_empty());
    }

    #[test]
    fn the_first_part_takes_the_place_of_another() {
        assert_eq!(
            with_first_parts("v.%D2 := w.%X17;").as_deref(),
            Some("v.%B0 := w.%X0;")
        );
        assert_eq!(with_first_parts("v.2 := 17;"), None);
    }
}
