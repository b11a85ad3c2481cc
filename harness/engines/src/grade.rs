//! Grades: how exactly an engine can say what is wrong with a program.

use serde::{Deserialize, Serialize};
use std::str::FromStr;
use stickler_types::words;

words! {
    /// The degree to which a rejection or a fault is right, the best first.
    ///
    /// An engine claims one of them as the best that can be asked of it: a compiler without codes of its own, or whose adapter
    /// cannot map them onto those of the registry, is right to the line at best.
    #[derive(Default, Serialize, Deserialize)]
    #[cfg_attr(any(test, feature = "schema"), derive(schemars::JsonSchema))]
    #[serde(rename_all = "lowercase")]
    Grade {
        /// The right codes on the right lines, and no others.
        #[default]
        Code = "code",
        /// The right lines, and no others.
        Line = "line",
        /// Rejected, the place unknown or wrong.
        Rejected = "rejected",
    }
}

impl Grade {
    /// Tells whether this grade is as good as `needed`, or better.
    pub fn suffices(self, needed: Grade) -> bool {
        self <= needed
    }
}

impl FromStr for Grade {
    type Err = String;

    /// Parses `code`, `line` or `rejected`; the error lists them.
    fn from_str(text: &str) -> Result<Grade, String> {
        Grade::from_word(text)
            .ok_or_else(|| format!("unknown grade `{text}`; the grades are `code`, `line` and `rejected`"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_better_grade_suffices_where_a_worse_one_is_needed_and_not_the_other_way_round() {
        assert!(Grade::Code.suffices(Grade::Rejected));
        assert!(Grade::Line.suffices(Grade::Line));
        assert!(!Grade::Rejected.suffices(Grade::Line));
    }

    #[test]
    fn grades_have_one_spelling() {
        for grade in Grade::ALL {
            assert_eq!(serde_json::to_string(&grade).unwrap(), format!("\"{grade}\""));
            assert_eq!(grade.to_string().parse(), Ok(grade));
        }
        assert!("lines".parse::<Grade>().unwrap_err().contains("`line`"));
    }
}
