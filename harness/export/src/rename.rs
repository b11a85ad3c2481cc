//! Renames the names of a case, so that they differ from those of every other case of its page.

use std::collections::HashSet;
use stickler_engines::{SourceToken, tokens};

/// The suffixes for the names of a case.
pub(crate) struct Renaming<'n> {
    /// The names of the case's POUs, types and enumerated values, in capitals, and their suffix.
    pub(crate) units: (&'n HashSet<String>, String),
    /// The names of the case's variables, in capitals, and their suffix; `None` in the text of a POU.
    pub(crate) variables: Option<(&'n HashSet<String>, String)>,
}

impl Renaming<'_> {
    /// Returns a text with its names changed.
    ///
    /// A name after a point is that of a field, and one before `:=` or `=>` in a call or a list of fields that of a parameter
    /// or field: neither is a variable, even where a variable has the same name.
    pub(crate) fn of(&self, text: &str) -> String {
        let mut renamed = String::with_capacity(text.len() + text.len() / 4);
        let mut written = 0;
        let mut before = Before::default();
        for token in tokens(text) {
            if let SourceToken::Word(word) = token {
                let name = word.text.to_ascii_uppercase();
                let suffix = self.suffix(&name, &before, &text[word.end()..]);
                if let Some(suffix) = suffix {
                    renamed.push_str(&text[written..word.end()]);
                    renamed.push_str(suffix);
                    written = word.end();
                }
            }
            before.take(&token);
        }
        renamed.push_str(&text[written..]);
        renamed
    }

    fn suffix(&self, name: &str, before: &Before, behind: &str) -> Option<&str> {
        if self.units.0.contains(name) {
            return Some(&self.units.1);
        }
        let (variables, suffix) = self.variables.as_ref()?;
        let is_field = before.last == Some(b'.') && before.last_but_one != Some(b'.');
        // A name beside `#` is a type, or an enumerated value.
        let is_typed = before.last == Some(b'#') || behind.starts_with('#');
        let opens = matches!(before.last, Some(b'(' | b','));
        let is_parameter = before.depth > 0 && opens && takes(behind);
        let is_variable = variables.contains(name) && !is_field && !is_typed && !is_parameter;
        is_variable.then_some(suffix)
    }
}

/// Returns whether the text after a name is `:=` or `=>`, which assigns a parameter or field.
fn takes(behind: &str) -> bool {
    let behind = behind.trim_start();
    behind.starts_with(":=") || behind.starts_with("=>")
}

/// The context of a token: the signs before it.
#[derive(Default)]
struct Before {
    last: Option<u8>,
    last_but_one: Option<u8>,
    /// The number of open parentheses.
    depth: u32,
}

impl Before {
    fn take(&mut self, token: &SourceToken<'_>) {
        self.last_but_one = self.last;
        self.last = match token {
            SourceToken::Sign(sign) => Some(*sign),
            _ => None,
        };
        match token {
            SourceToken::Sign(b'(') => self.depth += 1,
            SourceToken::Sign(b')') => self.depth = self.depth.saturating_sub(1),
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn renamed(text: &str, units: &[&str], variables: &[&str]) -> String {
        let set = |names: &[&str]| names.iter().map(ToString::to_string).collect::<HashSet<_>>();
        let (units, variables) = (set(units), set(variables));
        let renaming = Renaming {
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
