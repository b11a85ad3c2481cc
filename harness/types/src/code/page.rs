//! Parses the Markdown page of a diagnostic code.

use crate::dialect_name::DialectName;

/// The contents of the page of a diagnostic code.
pub(super) struct CodePage {
    pub summary: &'static str,
    pub explanation: String,
    /// The dialect in which the reference gives the code for the example; `None` where only other compilers give it.
    pub dialect: Option<DialectName>,
    pub example: &'static str,
    pub fix: String,
    pub repaired: Option<&'static str>,
}

/// The line above the example of a code that the reference never gives.
const GIVEN_ELSEWHERE: &str = "Only other compilers give this code.";

/// Parses a page: heading, summary, explanation, dialect and example, fix and repaired example, as
/// `harness/types/README.md` describes them.
///
/// # Errors
/// A message about the first part that is missing or has another form.
pub(super) fn parse(code: &str, name: &str, text: &'static str) -> Result<CodePage, String> {
    let rest = text
        .strip_prefix(&format!("# {code} {name}\n\n"))
        .ok_or_else(|| format!("the first line must be `# {code} {name}`, with an empty line after it"))?;
    let (summary, rest) = part(rest, "\n\n", "a summary and an empty line")?;
    let (explanation, rest) = part(
        rest,
        "\n\n## Example\n\n",
        "an explanation and the heading `## Example`",
    )?;
    let (given, rest) = part(rest, "\n\n```st\n", "a line on the dialect and a fence ```st")?;
    let (example, rest) = program(rest)?;
    let rest = rest
        .strip_prefix("\n## Fix\n\n")
        .ok_or("the heading `## Fix` must follow the example")?;
    let (fix, repaired) = match rest.split_once("\n\n```st\n") {
        None => (rest, None),
        Some((fix, rest)) => match program(rest)? {
            (repaired, "") => (fix, Some(repaired)),
            (_, more) => {
                return Err(format!(
                    "nothing may follow the repaired example, but `{more}` does"
                ));
            }
        },
    };
    Ok(CodePage {
        summary,
        explanation: unwrapped(explanation),
        dialect: dialect(given)?,
        example,
        fix: unwrapped(fix),
        repaired,
    })
}

/// Splits the text at `end`.
fn part(text: &'static str, end: &str, expected: &str) -> Result<(&'static str, &'static str), String> {
    text.split_once(end)
        .filter(|(part, _)| !part.is_empty() && !part.contains("```"))
        .ok_or_else(|| {
            format!(
                "expected {expected}, found `{}`",
                text.lines().next().unwrap_or_default()
            )
        })
}

/// Splits the text after the fence that closes a program; returns the program with its last line break, and the rest.
fn program(text: &'static str) -> Result<(&'static str, &'static str), String> {
    let end = text.find("\n```\n").ok_or("a program is not closed with ```")?;
    Ok((&text[..=end], &text[end + "\n```\n".len()..]))
}

/// Parses the line above an example.
fn dialect(given: &str) -> Result<Option<DialectName>, String> {
    if given == GIVEN_ELSEWHERE {
        return Ok(None);
    }
    given
        .strip_prefix("Stickler's reference gives this code in the dialect `")
        .and_then(|rest| rest.strip_suffix("`.")?.parse().ok())
        .filter(|dialect| DialectName::ALL.contains(dialect))
        .map(Some)
        .ok_or_else(|| format!("`{given}` must name a dialect, or be `{GIVEN_ELSEWHERE}`"))
}

/// Joins the lines of a paragraph.
fn unwrapped(paragraph: &str) -> String {
    paragraph.trim_end().replace('\n', " ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_mdtest::check_examples;

    /// Parses the page of a code without the first occurrence of a text, and returns the error.
    fn error_without(removed: &str) -> String {
        let text = include_str!("../../codes/P4035.md");
        assert!(text.contains(removed), "{removed}");
        let text = String::leak(text.replacen(removed, "", 1));
        parse("P4035", "AssignmentTypeMismatch", text)
            .err()
            .unwrap_or_default()
    }

    #[test]
    fn golden_errors_name_what_is_missing() {
        check_examples("tests/pages.md", |example| error_without(example.text("removed")));
    }

    #[test]
    fn nothing_follows_the_repaired_example() {
        let text = String::leak(format!("{}More.\n", include_str!("../../codes/P4035.md")));
        let error = parse("P4035", "AssignmentTypeMismatch", text)
            .err()
            .unwrap_or_default();
        assert!(error.contains("nothing may follow"), "{error}");
    }
}
