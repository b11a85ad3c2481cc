//! Compares the diagnostics that are reported with those that marks demand.

use crate::Difference;
use crate::marks::DiagnosticMark;
use std::fmt;

/// A diagnostic that was reported.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Reported {
    /// The line on which it begins, from 1.
    pub line: u32,
    /// `error` or `warning`.
    pub severity: &'static str,
    /// The code of the diagnostic.
    pub code: String,
    /// The text at which it points.
    pub at: String,
    /// The message of the diagnostic.
    pub message: String,
    /// What it suggests to write there.
    pub suggestion: Option<String>,
}

impl fmt::Display for Reported {
    /// Writes the diagnostic as a mark.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {} at `{}`", self.severity, self.code, self.at)?;
        if let Some(suggestion) = &self.suggestion {
            write!(f, " suggests `{suggestion}`")?;
        }
        write!(f, " says {}", self.message)
    }
}

impl fmt::Display for DiagnosticMark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.severity, self.code)?;
        for (word, text) in [(" at", &self.at), (" suggests", &self.suggests)] {
            if let Some(text) = text {
                write!(f, "{word} `{text}`")?;
            }
        }
        self.says
            .as_ref()
            .map_or(Ok(()), |says| write!(f, " says {says}"))
    }
}

impl DiagnosticMark {
    fn is_met_by(&self, reported: &Reported) -> bool {
        let suggestion = reported.suggestion.as_deref().unwrap_or_default();
        [0, reported.line].contains(&self.line)
            && (&*self.severity, &self.code) == (reported.severity, &reported.code)
            && self.at.as_ref().is_none_or(|at| *at == reported.at)
            && self.suggests.as_ref().is_none_or(|text| text == suggestion)
            && self
                .says
                .as_ref()
                .is_none_or(|says| is_message(says, &reported.message))
    }
}

/// Returns whether a message is the one that a mark wants.
fn is_message(wanted: &str, message: &str) -> bool {
    let end = wanted.strip_prefix('…').map(str::trim_start);
    match (end.unwrap_or(wanted), end) {
        (wanted, Some(_)) if wanted.ends_with('…') => {
            message.contains(wanted.trim_end_matches('…').trim_end())
        }
        (wanted, Some(_)) => message.ends_with(wanted),
        (wanted, None) if wanted.ends_with('…') => {
            message.starts_with(wanted.trim_end_matches('…').trim_end())
        }
        (wanted, None) => message == wanted,
    }
}

/// Returns the marks that no diagnostic meets, and the diagnostics that no mark wants.
pub fn differences(marks: &[DiagnosticMark], reported: &[Reported]) -> Vec<Difference> {
    let mut left: Vec<&Reported> = reported.iter().collect();
    let mut missing = Vec::new();
    // A mark that says more chooses first.
    let mut in_order: Vec<&DiagnosticMark> = marks.iter().collect();
    in_order.sort_by_key(|mark| mark.at.is_none() && mark.suggests.is_none() && mark.says.is_none());
    for mark in in_order {
        match left.iter().position(|reported| mark.is_met_by(reported)) {
            Some(met) => drop(left.remove(met)),
            None => missing.push(Difference::new(mark.line as usize, format!("missing: {mark}"))),
        }
    }
    let unwanted = left
        .iter()
        .map(|one| Difference::new(one.line as usize, format!("reported: {one}")));
    missing.extend(unwanted);
    missing.sort_by_key(|difference| difference.line);
    missing
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Marks;

    #[test]
    fn every_diagnostic_needs_its_mark_and_every_mark_its_diagnostic() {
        let reported = |line, at: &str| Reported {
            line,
            severity: "error",
            code: "P1".to_owned(),
            at: at.to_owned(),
            message: "no `x` here".to_owned(),
            suggestion: None,
        };
        let said = [reported(1, "a"), reported(1, "b"), reported(2, "c")];
        let found = |text: &str| {
            let marks = Marks::of(text).expect("marks");
            differences(&marks.diagnostics, &said).len()
        };
        assert_eq!(
            found("(*! error P1 P1 at `a` says no … *)\n(*! error P1 says … here *)"),
            0
        );
        assert_eq!(
            found("(*! error P1 at `b` P1 suggests nothing *)\n(*! error P1 says … `x` … *)"),
            0
        );
        assert_eq!(found("(*! error P1 P1 *)"), 1);
        assert_eq!(found("(*! error P1 P1 *)\n(*! warning P1 *)"), 2);
        assert_eq!(found("(*! error P1 P1 at `c` *)\n(*! error P1 says here *)"), 4);
    }
}
