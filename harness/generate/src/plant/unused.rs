//! Removal of declarations that an error has left unused: a variable that stood where the error stands now, a function that
//! was called there.
//!
//! The sound program needs the declaration, so it can only go once the error is planted. It is removed from the text, whose
//! lines can be counted: an unused declaration cannot be what makes the program wrong, unless it is itself the error.

use std::ops::Range;

/// Returns the texts that lack one unused declaration, each with the line of the error in it; `line` is its line in `text`.
///
/// The declaration is that of a local variable, a function, a function block or a type, as [`write`](crate::writer::write)
/// writes it in its plain style, whose name occurs on no other line. The line of the error always stays.
pub fn without_unused(text: &str, line: u32) -> impl Iterator<Item = (String, u32)> {
    let lines: Vec<&str> = text.lines().collect();
    let error = usize::try_from(line).unwrap_or(usize::MAX).saturating_sub(1);
    let unused: Vec<Range<usize>> = declarations(&lines)
        .filter(|(name, place)| !place.contains(&error) && !occurs_outside(&lines, name, place))
        .map(|(_, place)| with_empty_section(&lines, place))
        .collect();
    unused.into_iter().map(move |place| {
        let above = if place.start <= error { place.len() } else { 0 };
        let kept = lines.iter().enumerate();
        let kept = kept.filter(|(number, _)| !place.contains(number));
        let text: String = kept.flat_map(|(_, line)| [*line, "\n"]).collect();
        (text, line.saturating_sub(u32::try_from(above).unwrap_or(0)))
    })
}

/// Returns the names of removable declarations, and their lines.
fn declarations<'t>(lines: &'t [&'t str]) -> impl Iterator<Item = (&'t str, Range<usize>)> {
    let mut section = "";
    lines.iter().enumerate().filter_map(move |(at, line)| {
        let line = line.trim();
        let end = |word: &str| {
            let length = lines.iter().skip(at).position(|line| line.trim() == word);
            length.map(|length| at..at + length + 1)
        };
        let mut words = line.split_whitespace();
        match (words.next()?, words.next(), words.next()) {
            (word @ ("VAR" | "VAR_INPUT" | "VAR_OUTPUT" | "VAR_IN_OUT" | "TYPE"), kind, None) => {
                section = if kind == Some("CONSTANT") { "VAR" } else { word };
                None
            }
            ("FUNCTION_BLOCK", Some(name), None) => Some((name, end("END_FUNCTION_BLOCK")?)),
            ("FUNCTION", Some(name), Some(":")) => Some((name, end("END_FUNCTION")?)),
            (name, Some(":"), Some("STRUCT")) if section == "TYPE" => {
                section = "STRUCT";
                Some((name, end("END_STRUCT;")?))
            }
            ("END_STRUCT;", None, _) => {
                section = "TYPE";
                None
            }
            (name, Some(":"), Some(_)) if line.ends_with(';') && matches!(section, "VAR" | "TYPE") => {
                Some((name, at..at + 1))
            }
            ("END_VAR" | "END_TYPE", None, _) => {
                section = "";
                None
            }
            _ => None,
        }
    })
}

/// Returns whether a line outside of `place` contains a name, in any case of its letters.
fn occurs_outside(lines: &[&str], name: &str, place: &Range<usize>) -> bool {
    let others = lines
        .iter()
        .enumerate()
        .filter(|(number, _)| !place.contains(number));
    let mut words = others.flat_map(|(_, line)| line.split(|c: char| !c.is_alphanumeric() && c != '_'));
    words.any(|word| word.eq_ignore_ascii_case(name))
}

/// Extends a range of lines to its section if the section contains nothing else.
fn with_empty_section(lines: &[&str], place: Range<usize>) -> Range<usize> {
    let at = |number: Option<usize>| {
        number
            .and_then(|number| lines.get(number))
            .map(|line| line.trim())
    };
    let opened = at(place.start.checked_sub(1)).is_some_and(|line| {
        let mut words = line.split_whitespace();
        matches!(words.next(), Some("VAR" | "TYPE"))
    });
    let closed = matches!(at(Some(place.end)), Some("END_VAR" | "END_TYPE"));
    if opened && closed {
        place.start - 1..place.end + 1
    } else {
        place
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "TYPE
    Unused : STRUCT
        m0 : INT;
    END_STRUCT;
END_TYPE
FUNCTION Idle : INT
VAR_INPUT
    in0 : INT;
END_VAR
    Idle := in0;
END_FUNCTION
PROGRAM main
VAR
    v0 : INT;
    v1 : INT := 2;
END_VAR
VAR CONSTANT
    planted : INT := INT#1;
END_VAR
    PLANTED := v1;
END_PROGRAM
";

    #[test]
    fn what_no_other_line_says_goes_and_takes_its_empty_section_with_it() {
        let found: Vec<(String, u32)> = without_unused(TEXT, 20).collect();
        let first_lines: Vec<usize> = found.iter().map(|(text, _)| text.lines().count()).collect();
        // The type with its section, the function, and a variable beside another; an input is no local variable.
        assert_eq!(first_lines, [16, 15, 20]);
        for (text, line) in &found {
            let error = text.lines().nth(*line as usize - 1);
            assert_eq!(error, Some("    PLANTED := v1;"), "{text}");
        }
    }

    #[test]
    fn the_line_of_the_error_stays() {
        let found = without_unused(TEXT, 14).map(|(text, _)| text);
        assert!(found.into_iter().all(|text| text.contains("v0 : INT")));
    }

    #[test]
    fn what_stands_below_the_error_does_not_move_it() {
        let text = "PROGRAM main\nVAR\n    a : missing;\n    b : INT;\nEND_VAR\n    ;\nEND_PROGRAM\n";
        let found: Vec<(String, u32)> = without_unused(text, 3).collect();
        assert_eq!(found, [(text.replace("    b : INT;\n", ""), 3)]);
    }
}
