//! Annotations: lines in the log of a CI job by which its service shows the unexpected results of a run beside the sources.
//!
//! Basis: GitHub, "Workflow commands for GitHub Actions", <https://docs.github.com/actions/reference/workflows-and-actions/workflow-commands>: the form of
//! a line and what is escaped in it. A step shows ten errors; further ones stand in the log only, so they are left to the reports.

use crate::overview::Overview;
use crate::unexpected::Unexpected;
use std::io::{self, Write};

/// The number of errors of a step that GitHub shows.
const MAX_ERRORS: usize = 10;

/// Writes an error for each of the first unexpected results of a run, as workflow commands of GitHub, and the number of further ones.
///
/// # Errors
/// Errors of writing to `out`.
pub fn write_github(overview: &Overview, out: &mut dyn Write) -> io::Result<()> {
    let mut unexpected = Unexpected::all(overview);
    for one in unexpected.by_ref().take(MAX_ERRORS) {
        let mut properties = Vec::new();
        if !one.file.is_empty() {
            properties.push(format!("file={}", property(&one.file)));
            properties.extend(one.line.map(|line| format!("line={line}")));
        }
        properties.push(format!("title={}", property(&one.title)));
        writeln!(out, "::error {}::{}", properties.join(","), message(&one.text))?;
    }
    match unexpected.count() {
        0 => Ok(()),
        more => writeln!(
            out,
            "::notice::... and {more} more that are not as expected; the reports have all"
        ),
    }
}

/// Escapes a message, which may have several lines.
fn message(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

/// Escapes the value of a property.
fn property(text: &str) -> String {
    message(text).replace(':', "%3A").replace(',', "%2C")
}

#[cfg(test)]
mod tests {
    use super::{MAX_ERRORS, write_github};

    use crate::sample;
    use stickler_run::{CaseEvent, Verdict};

    fn annotations(cases: Vec<CaseEvent>) -> String {
        let overview = sample::overview(&sample::run_of(cases));
        let mut bytes = Vec::new();
        write_github(&overview, &mut bytes).expect("a vector takes all");
        String::from_utf8(bytes).expect("text")
    }

    #[test]
    fn an_error_names_the_case_file_and_escapes_what_would_end_it() {
        let failing = CaseEvent {
            title: "100 % of 1,5: wrong".to_owned(),
            ..sample::case("t::a(1)", Verdict::Fail)
        };
        let shown = annotations(vec![sample::case("t::a(2)", Verdict::Pass), failing]);
        let start = "::error file=conformance-cases/widening/integer.toml,line=7,\
             title=reference%3A widening/t%3A%3Aa(1)@ironplc-ed2%3A fail%3A 100 %25 of 1%2C5%3A wrong::basis: ";
        assert!(shown.starts_with(start), "{shown}");
        assert!(shown.contains("%0Aexpected:%0A"), "{shown}");
        assert_eq!(shown.lines().count(), 1, "{shown}");
    }

    #[test]
    fn no_more_errors_are_written_than_the_service_shows() {
        let failing = |number| sample::case(&format!("t::a({number})"), Verdict::Fail);
        let shown = annotations((0..MAX_ERRORS + 3).map(failing).collect());
        assert_eq!(shown.matches("::error ").count(), MAX_ERRORS);
        assert!(
            shown.ends_with("::notice::... and 3 more that are not as expected; the reports have all\n"),
            "{shown}"
        );
        assert_eq!(annotations(vec![sample::case("t::a(1)", Verdict::Differs)]), "");
    }
}
