//! Cases with all that their tables say filled in, in a form of which a judge reads only the cases that it comes to.
//!
//! The first line of the file is the number of cases; each line behind it is a case in JSON.

use serde::{Deserialize, Serialize};
use stickler_types::{Acceptance, ClockSetting, Observation, Setting};

/// One program in one dialect, and what must happen.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PreparedCase {
    /// `id@dialect`.
    pub key: String,
    /// The name of the dialect.
    pub dialect: String,
    /// The program.
    pub source: String,
    /// The number of scans.
    pub scans: u32,
    /// The values to observe.
    pub observe: Vec<Observation>,
    /// The variables that are set.
    pub set: Vec<Setting>,
    /// The times of scans.
    pub clock: Vec<ClockSetting>,
    /// The result that must come.
    pub expectation: PreparedExpectation,
}

/// The result that must come: a `stickler_suite::Expectation` in texts.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct PreparedExpectation {
    /// Whether the program must be accepted.
    pub acceptance: Acceptance,
    /// The line and code of each diagnostic that must be there.
    pub diagnostics: Vec<(u32, String)>,
    /// The line and code of each warning that must be there.
    pub warnings: Vec<(u32, String)>,
    /// Lines that no diagnostic may name.
    pub clean_lines: Vec<u32>,
    /// The key (`q`, or `q@3` after the third scan) and the typed literal of each value that must be there.
    pub values: Vec<(String, String)>,
    /// The line and kind of the fault that must end the run.
    pub fault: Option<(u32, String)>,
    /// The trimmed lines of the bodies of the rendered program.
    pub rendered: Option<Vec<String>>,
}

/// Returns the text of a file of cases.
///
/// # Errors
/// None that is known: all that a case has can be written as JSON.
pub fn write(cases: &[PreparedCase]) -> serde_json::Result<String> {
    let mut text = format!("{}\n", cases.len());
    for case in cases {
        text += &serde_json::to_string(case)?;
        text.push('\n');
    }
    Ok(text)
}

/// Returns the lines of a file of cases, each of which [`read`] reads; `None` where the file is cut short, or has another form.
pub fn lines(text: &str) -> Option<Vec<&str>> {
    let (count, cases) = text.strip_suffix('\n')?.split_once('\n')?;
    let lines: Vec<&str> = cases.lines().collect();
    (count.parse() == Ok(lines.len())).then_some(lines)
}

/// Reads the line of a case.
///
/// # Errors
/// The line was not written by [`write()`].
pub fn read(line: &str) -> serde_json::Result<PreparedCase> {
    serde_json::from_str(line)
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_types::Value;

    #[test]
    fn cases_are_read_as_they_were_written_and_a_file_that_is_cut_short_is_refused() {
        let case = PreparedCase {
            key: "folder/file@matiec".to_owned(),
            source: "PROGRAM main\n(* ä *) END_PROGRAM".to_owned(),
            set: vec![Setting {
                before: 2,
                name: "q".into(),
                value: Value::parse("STRING#'\"'").unwrap(),
            }],
            ..PreparedCase::default()
        };
        let cases = [case, PreparedCase::default()];
        let text = write(&cases).unwrap();
        let read: Vec<_> = lines(&text)
            .unwrap()
            .into_iter()
            .map(|line| read(line).unwrap())
            .collect();
        assert_eq!(read, cases);
        for length in (0..text.len()).filter(|&length| text.is_char_boundary(length)) {
            assert_eq!(lines(&text[..length]), None, "{length} bytes");
        }
        assert_eq!(lines(&(text + "{}\n")), None);
    }
}
