//! Renames the names of a program, so that they differ from those of every other program in one text.

use crate::token::TokenKind;
use crate::{Edits, tokens, words};
use std::collections::HashSet;
use stickler_types::Dialect;

/// The suffixes for the names of a program.
pub struct Renaming<'n> {
    /// The dialect of the program.
    pub dialect: &'n Dialect,
    /// The names of the program's POUs, types and enumerated values, in capitals, and their suffix.
    pub units: (&'n HashSet<String>, String),
    /// The names of the program's variables, in capitals, and their suffix; `None` in the text of a POU.
    pub variables: Option<(&'n HashSet<String>, String)>,
}

impl Renaming<'_> {
    /// Returns a text with its names changed.
    ///
    /// A name after a point is that of a field, and one before `:=` or `=>` in a call or a list of fields that of a parameter
    /// or field: neither is a variable, even where a variable has the same name.
    #[must_use]
    pub fn of(&self, text: &str) -> String {
        let mut edits = Edits::new();
        let is_of = |names: &HashSet<String>, word: &str| names.contains(&word.to_ascii_uppercase());
        let (units, suffix) = &self.units;
        for word in words(text, self.dialect).filter(|word| is_of(units, word.text)) {
            edits.replace(word.span.after(), &**suffix);
        }
        let Some((variables, suffix)) = &self.variables else {
            return edits.apply(text);
        };
        let mut before = None;
        let mut depth = 0_u32;
        let mut tokens = tokens(text, self.dialect).list.into_iter().peekable();
        while let Some(token) = tokens.next() {
            let behind = tokens.peek().map(|token| token.kind);
            let opens = matches!(before, Some(TokenKind::LeftParen | TokenKind::Comma));
            let takes = matches!(behind, Some(TokenKind::Assign | TokenKind::Arrow));
            let is_parameter = depth > 0 && opens && takes;
            let name = token.span.text(text);
            match token.kind {
                TokenKind::LeftParen => depth += 1,
                TokenKind::RightParen => depth = depth.saturating_sub(1),
                TokenKind::Name if before == Some(TokenKind::Dot) || is_parameter => {}
                TokenKind::Name if is_of(variables, name) && !is_of(units, name) => {
                    edits.replace(token.span.after(), &**suffix);
                }
                _ => {}
            }
            before = Some(token.kind);
        }
        edits.apply(text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_types::DialectName;

    fn renamed(text: &str, units: &[&str], variables: &[&str]) -> String {
        let set = |names: &[&str]| names.iter().map(ToString::to_string).collect::<HashSet<_>>();
        let (units, variables) = (set(units), set(variables));
        let renaming = Renaming {
            dialect: Dialect::of(DialectName::IRONPLC_ED2),
            units: (&units, "_u1".to_owned()),
            variables: Some((&variables, "_7".to_owned())),
        };
        renaming.of(text)
    }

    #[test]
    fn variables_are_renamed_and_fields_and_parameters_are_not() {
        for (text, expected) in [
            ("X := x + r.x;", "X_7 := x_7 + r.x;"),
            ("x := f(x := x, y => X);", "x_7 := f_u1(x := x_7, y => X_7);"),
            ("fb(x := x.y); a[x].x := 1;", "fb(x := x_7.y); a[x_7].x := 1;"),
            (
                "FOR x := 1 TO x DO (* x *) s := 'x'; END_FOR;",
                "FOR x_7 := 1 TO x_7 DO (* x *) s := 'x'; END_FOR;",
            ),
            (
                "CASE y OF 1..x: x.0 := TRUE; END_CASE;",
                "CASE y OF 1..x_7: x_7.0 := TRUE; END_CASE;",
            ),
            (
                "c := COLOR#RED; c := RED; t := T#1s;",
                "c := COLOR_u1#RED_u1; c := RED_u1; t := T#1s;",
            ),
            ("x := (x);", "x_7 := (x_7);"),
            ("WORD := WORD#16#FF;", "WORD_7 := WORD#16#FF;"),
            (
                "IF (x) THEN (x) := 1; END_IF;",
                "IF (x_7) THEN (x_7) := 1; END_IF;",
            ),
        ] {
            assert_eq!(
                renamed(text, &["F", "COLOR", "RED"], &["X", "S1", "WORD"]),
                expected
            );
        }
    }

    #[test]
    fn declarations_are_renamed_with_what_they_name() {
        let text = "x, y : COLOR := RED; r : REC := (x := 1, y := 2);";
        assert_eq!(
            renamed(text, &["COLOR", "RED", "REC"], &["X", "Y", "R"]),
            "x_7, y_7 : COLOR_u1 := RED_u1; r_7 : REC_u1 := (x := 1, y := 2);"
        );
    }
}
