//! Parses the diagnostics that `ironplcc` writes to stderr, with colours whether or not a terminal reads them.
//!
//! Basis: ironplc: measured on version 0.239, which has errors alone and no warnings; each begins `error[P4035]: message`, and a later line `┌─ file:line:column` names
//! the place. Where the compiler does not know the place, it shows 1:1 without a file, or marks nothing there.

use crate::adapters::plain::without_colours;
use crate::{Diagnostic, Outcome};

/// Returns all diagnostics of a text, sorted by line, column and code, each once. One whose place the compiler does not tell
/// has no line.
pub(super) fn read(stderr: &str) -> Vec<Diagnostic> {
    let plain = without_colours(stderr);
    let mut diagnostics: Vec<Diagnostic> = Vec::new();
    let mut lines = plain.lines();
    while let Some(line) = lines.next() {
        if let Some(diagnostic) = heading(line) {
            diagnostics.push(diagnostic);
        } else if let (Some(place), Some(last)) = (place(line), diagnostics.last_mut())
            && last.line.is_none()
            && !(place == BEGINNING && (has_no_file(line) || marks_nothing(lines.clone())))
        {
            (last.line, last.column) = (Some(place.0), Some(place.1));
        } else if let (Some(label), Some(last)) = (label(line), diagnostics.last_mut())
            && matches!(about(last), About::NotImplemented)
        {
            // The heading is the same for everything that is not implemented; the label tells what it is.
            last.message = format!("{}: {label}", last.message);
        }
    }
    diagnostics.sort_by(|a, b| (a.line, a.column, &a.code).cmp(&(b.line, b.column, &b.code)));
    diagnostics.dedup();
    diagnostics
}

/// The place that the compiler shows where it knows none.
const BEGINNING: (u32, u32) = (1, 1);

/// Tells whether the line of a place names no file.
fn has_no_file(line: &str) -> bool {
    line.split_once("┌─ ")
        .is_some_and(|(_, place)| place.starts_with(':'))
}

/// Tells whether the lines below the place 1:1 mark an empty range: one mark under the beginning of a word or comment, which is
/// longer. A mistake in the first word of a program has as many marks as the word has characters.
fn marks_nothing<'l>(mut below: impl Iterator<Item = &'l str>) -> bool {
    let source = below.find_map(|line| line.strip_prefix("1 │ "));
    let marks = below.next().and_then(|line| line.split_once("│ "));
    let (Some(source), Some((_, marks))) = (source, marks) else {
        return false;
    };
    let of_a_word = |character: char| character.is_alphanumeric() || character == '_';
    let word = source.chars().take_while(|&character| of_a_word(character));
    let is_one_character = match word.count() {
        0 => {
            !["(*", "/*", "//", "{", " ", "\t"]
                .iter()
                .any(|begin| source.starts_with(begin))
                && !source.is_empty()
        }
        length => length == 1,
    };
    !is_one_character && marks.starts_with('^') && !marks.starts_with("^^")
}

/// Returns the words behind the marks of a line such as `  │  ^^^ Not implemented at codegen/src/compile.rs#L7`.
fn label(line: &str) -> Option<&str> {
    let marks = line.trim_start().strip_prefix("│ ")?;
    let (before, label) = marks.split_once("^ ")?;
    let is_marks = before
        .chars()
        .all(|character| matches!(character, ' ' | '^' | '│' | '╰' | '─'));
    Some(label.trim()).filter(|label| is_marks && !label.is_empty())
}

/// Parses a heading such as `error[P4035]: message`.
fn heading(line: &str) -> Option<Diagnostic> {
    let (code, message) = line.strip_prefix("error[")?.split_once("]: ")?;
    Some(Diagnostic {
        code: Some(code.to_owned()),
        message: message.trim_end().to_owned(),
        ..Diagnostic::default()
    })
}

/// Parses a place such as `  ┌─ program.st:6:13`.
fn place(line: &str) -> Option<(u32, u32)> {
    let (_, place) = line.split_once("┌─ ")?;
    let mut parts = place.trim_end().rsplitn(3, ':');
    let column = parts.next()?.parse().ok()?;
    let line = parts.next()?.parse().ok()?;
    Some((line, column))
}

/// The subject of a diagnostic: the program, or the compiler itself.
///
/// Basis: ironplc: `problem-codes.csv`: P9001 and P9997 to P9999.
enum About {
    Program,
    NotImplemented,
    Itself,
}

fn about(diagnostic: &Diagnostic) -> About {
    match diagnostic.code.as_deref() {
        Some("P9001" | "P9003" | "P9997" | "P9999") => About::NotImplemented,
        Some("P9998") => About::Itself,
        _ => About::Program,
    }
}

/// Returns the outcome of these diagnostics: a rejection where one is about the program; otherwise [`Outcome::Crashed`] where
/// the compiler reports a failure of its own, and [`Outcome::NotImplemented`] where it reports that something is not implemented.
pub(super) fn outcome(diagnostics: Vec<Diagnostic>) -> Outcome {
    let first = |kind: fn(&About) -> bool| {
        let found = diagnostics.iter().find(|diagnostic| kind(&about(diagnostic)));
        found.map(described)
    };
    if first(|about| matches!(about, About::Program)).is_some() {
        return Outcome::Rejected { diagnostics };
    }
    if let Some(reason) = first(|about| matches!(about, About::Itself)) {
        return Outcome::Crashed { reason };
    }
    let reason = first(|_| true).unwrap_or_default();
    Outcome::NotImplemented { reason }
}

fn described(diagnostic: &Diagnostic) -> String {
    let code = diagnostic.code.as_deref().unwrap_or_default();
    format!("{code}: {}", diagnostic.message)
}

/// The output of `ironplcc compile` 0.239 on the program `a := b; c := a; q := 1;` of three types.
#[cfg(test)]
pub(super) const RECORDED: &str = "\u{1b}[0m\u{1b}[1m\u{1b}[38;5;9merror[P4035]\u{1b}[0m\u{1b}[1m: Assignment value type does not match \
    assignment target type (target=a, target_type=int, value_type=dint)\u{1b}[0m\n  \
    \u{1b}[0m\u{1b}[36m┌─\u{1b}[0m program.st:5:7\n  \u{1b}[0m\u{1b}[36m│\u{1b}[0m\n\
    \u{1b}[0m\u{1b}[36m5\u{1b}[0m \u{1b}[0m\u{1b}[36m│\u{1b}[0m  a := \u{1b}[0m\u{1b}[31mb\u{1b}[0m; \n  \
    \u{1b}[0m\u{1b}[36m=\u{1b}[0m Learn more: https://www.ironplc.com/reference/P4035.html\n\n\
    \u{1b}[0m\u{1b}[1m\u{1b}[38;5;9merror[P4007]\u{1b}[0m\u{1b}[1m: Variable not defined before used (variable=q)\u{1b}[0m\n  \
    \u{1b}[0m\u{1b}[36m┌─\u{1b}[0m C:\\x\\program.st:3:2\n\nError: \"Compile failed with 2 problem(s)\"\n";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn code_place_and_message_are_read_without_the_colours() {
        let found = read(RECORDED);
        let found: Vec<_> = found
            .iter()
            .map(|d| (d.code.as_deref().unwrap(), d.line, d.column, d.message.as_str()))
            .collect();
        assert_eq!(
            found,
            [
                (
                    "P4007",
                    Some(3),
                    Some(2),
                    "Variable not defined before used (variable=q)"
                ),
                (
                    "P4035",
                    Some(5),
                    Some(7),
                    "Assignment value type does not match assignment target type (target=a, target_type=int, value_type=dint)"
                )
            ]
        );
    }

    #[test]
    fn a_place_that_the_compiler_does_not_tell_is_none() {
        let shown = |place: &str, source: &str, marks: &str| {
            let text = format!("error[P4025]: m\n  ┌─ {place}\n  │\n1 │ {source}\n  │ {marks}\n  │\n");
            read(&text)[0].line
        };
        // As version 0.239 shows `x := b.9;` on line 5, and `b := -1;`.
        assert_eq!(
            shown(
                "/x/program.st:1:1",
                "PROGRAM main",
                "^ Bit index 9 is out of range"
            ),
            None
        );
        assert_eq!(shown(":1:1", "", "^ Assignment value"), None);
        assert_eq!(
            shown("/x/program.st:1:1", "PROGRAM main", "^^^^^^^ label"),
            Some(1)
        );
        assert_eq!(
            shown("/x/program.st:1:1", ") PROGRAM main", "^ Expected"),
            Some(1)
        );
        assert_eq!(
            shown("/x/program.st:1:1", "x PROGRAM main", "^ Expected"),
            Some(1)
        );
        assert_eq!(shown("/x/program.st:1:9", "PROGRAM main", "^ label"), Some(1));
        assert_eq!(shown("/x/program.st:5:7", "  x := b.9;", "^ label"), Some(5));
    }

    #[test]
    fn what_is_not_implemented_is_told_with_its_label_and_no_other_diagnostic_is() {
        let shown = |code: &str| {
            let text = format!(
                "error[{code}]: Capability is not implemented (yet!)\n  ┌─ program.st:5:7\n  │\n5 │   x := y^ z;\n  │        ^^^ no pointers at a.rs#L7\n  │\n  = Learn more: x\n"
            );
            match outcome(read(&text)) {
                Outcome::NotImplemented { reason } => reason,
                Outcome::Rejected { diagnostics } => diagnostics[0].message.clone(),
                other => other.to_string(),
            }
        };
        assert_eq!(
            shown("P9999"),
            "P9999: Capability is not implemented (yet!): no pointers at a.rs#L7"
        );
        assert_eq!(shown("P4035"), "Capability is not implemented (yet!)");
    }

    #[test]
    fn what_is_no_diagnostic_is_none() {
        for text in [
            "",
            "thread 'main' panicked at src/main.rs:1:1\n",
            "┌─ a:1:1\n",
            "error[P4035\n",
            "\u{1b}[",
        ] {
            assert_eq!(read(text), [], "{text}");
        }
    }

    #[test]
    fn a_compiler_that_finds_fault_with_itself_has_not_rejected_the_program() {
        let outcome_of = |codes: &[&str]| {
            let all = codes
                .iter()
                .map(|code| format!("error[{code}]: words\n"))
                .collect::<String>();
            outcome(read(&all))
        };
        assert!(
            matches!(outcome_of(&["P9999", "P4035"]), Outcome::Rejected { diagnostics } if diagnostics.len() == 2)
        );
        let reason = "P9998: words".to_owned();
        assert_eq!(outcome_of(&["P9999", "P9998"]), Outcome::Crashed { reason });
        let reason = "P9999: words".to_owned();
        assert_eq!(outcome_of(&["P9999"]), Outcome::NotImplemented { reason });
    }
}
