//! Programs that differ from another in one property: of a literal, of a type, of an operand.

use crate::tokens::{ProgramToken, ProgramTokenKind, parsed, tokens};
use std::collections::BTreeSet;
use stickler_syntax::Edits;
use stickler_syntax::source::{LineIndex, Span};
use stickler_syntax::tree::{Expression, ExpressionId};
use stickler_syntax::visitor::{Context, Place, Visitor, walk};
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

/// Returns a program with quite another type in the place of what this line assigns, or else of another value that it gives to something:
/// a text where a number stands, a number where a text stands.
pub(crate) fn with_other_operand(program: &str, line: Option<u32>) -> Vec<String> {
    let unit = parsed(program);
    let mut given = GivenValues {
        lines: LineIndex::new(program),
        line,
        found: Vec::new(),
    };
    walk(&unit, &mut given);
    given.found.sort_by_key(|(place, _)| *place);
    let others = |(_, span): &(usize, Span)| {
        ["'a'", "T#1s"].map(|other| Edits::replacing(*span, other).apply(program))
    };
    given.found.iter().flat_map(others).collect()
}

/// The values that a line gives to something, each with the rank of its place.
struct GivenValues {
    lines: LineIndex,
    line: Option<u32>,
    found: Vec<(usize, Span)>,
}

impl<'t, 's: 't> Visitor<'t, 's> for GivenValues {
    fn expression(
        &mut self,
        (_, expression): (ExpressionId, &'t Expression<'s>),
        place: Place,
        _: Option<ExpressionId>,
        _: &Context<'t, 's>,
    ) {
        let places = [
            &[Place::Value][..],
            &[Place::NamedArgument],
            &[Place::InitialValue, Place::Argument, Place::Subscript],
        ];
        let rank = places.iter().position(|places| places.contains(&place));
        let is_here = Some(self.lines.line(expression.span.start)) == self.line;
        self.found
            .extend(rank.filter(|_| is_here).map(|rank| (rank, expression.span)));
    }
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
    let mut edits = Edits::new();
    for (place, token) in tokens(program).iter().enumerate() {
        edits.replace(token.start..token.end(), with(place, token));
    }
    edits.apply(program)
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
    fn a_value_of_quite_another_type_takes_the_place_of_one_that_is_given() {
        let program = |line: &str| format!("PROGRAM p\n{line}\nEND_PROGRAM");
        let of = |statement: &str| with_other_operand(&program(statement), Some(2));
        for (statement, place, changed) in [
            ("x := -5;", 0, "x := 'a';"),
            ("a[1].f := g(5);", 0, "a[1].f := 'a';"),
            ("fb(in := -5);", 1, "fb(in := T#1s);"),
            ("fb(in := r.a[1]);", 0, "fb(in := 'a');"),
            ("fb(n := 1, in := NOT f(r.7));", 2, "fb(n := 1, in := 'a');"),
            (
                "VAR a : R := (f := 5); END_VAR",
                0,
                "VAR a : R := (f := 'a'); END_VAR",
            ),
            ("x := y + 5;", 0, "x := 'a';"),
        ] {
            assert_eq!(of(statement)[place], program(changed));
        }
        assert!(of("EXIT;").is_empty());
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
