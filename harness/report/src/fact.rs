//! What a line of a judgement says. `expected` and `got` of a case have one fact a line, in the forms in which `stickler-run`
//! writes them down when it judges.

/// One line.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Fact<'t> {
    /// `line 6: error P4025`, `line 6: error without a code: no such bit`, `somewhere: error P4025: no such bit`
    Diagnostic(Diagnostic<'t>),
    /// `rejected`, `rejected, with no diagnostic`
    Rejected,
    /// `line 6: fault subrange`, `fault subrange`
    Fault(Fault<'t>),
    /// `r = INT#5`
    Value {
        /// The variable.
        name: &'t str,
        /// Its value.
        value: &'t str,
    },
    /// `r is missing`
    Missing,
    /// `accepted or rejected`
    Open,
    /// `accepted`, and the lines of a normalised source.
    Other,
}

/// What is wrong with the program, and where.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Diagnostic<'t> {
    /// `None` where the compiler tells none.
    pub(crate) line: Option<u32>,
    /// `None` where the compiler has none.
    pub(crate) code: Option<&'t str>,
    /// Empty where it is not written down.
    pub(crate) message: &'t str,
}

/// Where a program stops, and why.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Fault<'t> {
    /// `None` where the compiler tells none.
    pub(crate) line: Option<u32>,
    /// Such as `division-by-zero`.
    pub(crate) name: &'t str,
}

impl Fact<'_> {
    /// The facts of a text.
    pub(crate) fn all(text: &str) -> Vec<Fact<'_>> {
        text.lines().map(read).collect()
    }
}

/// The fact of one line.
pub(crate) fn read(text: &str) -> Fact<'_> {
    let (line, said) = placed(text);
    let is_placed = said.len() < text.len();
    if is_placed && let Some(told) = said.strip_prefix("error ") {
        return Fact::Diagnostic(diagnostic(line, told));
    }
    if let Some(name) = said.strip_prefix("fault ").filter(|name| !name.contains(' ')) {
        return Fact::Fault(Fault { line, name });
    }
    match text {
        "rejected" | "rejected, with no diagnostic" => return Fact::Rejected,
        "accepted or rejected" => return Fact::Open,
        _ => {}
    }
    if let Some((name, value)) = text.split_once(" = ").filter(|(name, _)| is_variable(name)) {
        return Fact::Value { name, value };
    }
    match text.strip_suffix(" is missing") {
        Some(name) if is_variable(name) => Fact::Missing,
        _ => Fact::Other,
    }
}

/// The line of a fact that names one, and what is behind its place.
fn placed(text: &str) -> (Option<u32>, &str) {
    if let Some(said) = text.strip_prefix("somewhere: ") {
        return (None, said);
    }
    let place = text
        .strip_prefix("line ")
        .and_then(|behind| behind.split_once(": "));
    let read = place.and_then(|(line, said)| Some((line.parse().ok()?, said)));
    read.map_or((None, text), |(line, said)| (Some(line), said))
}

fn diagnostic(line: Option<u32>, told: &str) -> Diagnostic<'_> {
    let (code, message) = told.split_once(": ").unwrap_or((told, ""));
    let code = Some(code).filter(|code| *code != "without a code");
    Diagnostic { line, code, message }
}

/// Whether it is the name of a variable or a part of one, and not the beginning of a statement.
fn is_variable(name: &str) -> bool {
    let mut depth = 0;
    !name.is_empty()
        && name.chars().all(|character| {
            match character {
                '[' => depth += 1,
                ']' => depth -= 1,
                _ => return depth > 0 || character.is_alphanumeric() || "_.@".contains(character),
            }
            true
        })
}

#[cfg(test)]
mod tests {
    use super::{Diagnostic, Fact, Fault, read};

    #[test]
    fn every_form_of_a_judgement_is_read() {
        let said = |line, code, message| Fact::Diagnostic(Diagnostic { line, code, message });
        let stopped = |line| {
            let name = "subrange";
            Fact::Fault(Fault { line, name })
        };
        for (text, fact) in [
            ("line 6: error P4025", said(Some(6), Some("P4025"), "")),
            ("line 6: error E7: a: b", said(Some(6), Some("E7"), "a: b")),
            ("line 6: error without a code: a", said(Some(6), None, "a")),
            ("somewhere: error P4025: a", said(None, Some("P4025"), "a")),
            ("somewhere: error without a code: a", said(None, None, "a")),
            ("rejected, with no diagnostic", Fact::Rejected),
            ("line 3: fault subrange", stopped(Some(3))),
            ("fault subrange", stopped(None)),
            ("a.total@1 is missing", Fact::Missing),
            ("accepted", Fact::Other),
            ("accepted, and not executed", Fact::Other),
        ] {
            assert_eq!(read(text), fact, "{text}");
        }
    }

    #[test]
    fn variables_may_have_any_name_and_statements_are_no_values() {
        for (name, value) in [
            ("error", "INT#5"),
            ("fault", "INT#5"),
            ("g[0, -1].x@3", "STRING#'a = b'"),
        ] {
            let text = format!("{name} = {value}");
            assert_eq!(read(&text), Fact::Value { name, value });
        }
        for text in ["same := a = b;", "IF a = b THEN", "a := b;", "error it is", ""] {
            assert_eq!(read(text), Fact::Other, "{text}");
        }
    }
}
