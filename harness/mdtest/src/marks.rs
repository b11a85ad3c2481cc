//! The marks of a program: comments that say what must come of it.
//!
//! The marks are those of the conformance cases (`conformance-cases/README.md`):
//!
//! | mark | says |
//! |---|---|
//! | `(*! error P4035 P4007 *)` | exactly these diagnostics begin on this line |
//! | `(*! warning S0003 *)` | the same of warnings |
//! | ``(*! error P4035 at `d` suggests `DINT_TO_INT(d)` *)`` | the diagnostic points at this text, and suggests to replace it; `suggests nothing` |
//! | `(*! error P4017 says … did you mean … *)` | its message; an ellipsis at either end stands for any text |
//! | `(*! values` … `*)` | a line `path = literal` for each value after the last scan; `values after 2`: after the second |
//! | `(*! fault subrange *)` | execution stops on this line |
//! | `(*! set name = INT#5 before 2 *)` | the environment writes before the second scan |

/// The marks of a program.
#[derive(Default, Debug)]
pub struct Marks {
    /// The diagnostics that must be reported.
    pub diagnostics: Vec<DiagnosticMark>,
    /// The values that must be observed.
    pub values: Vec<Value>,
    /// The fault that must happen, and its line.
    pub fault: Option<(String, u32)>,
    /// What the environment writes: before which scan, the name, and the literal.
    pub settings: Vec<(u32, String, String)>,
}

/// A value that must be observed.
#[derive(PartialEq, Eq, Debug)]
pub struct Value {
    /// The line of the program on which it stands, from 1.
    pub line: usize,
    /// The scan after which it is observed; `None` for the last.
    pub after: Option<u32>,
    /// The path of the variable.
    pub path: String,
    /// The typed literal.
    pub literal: String,
}

/// A diagnostic that must be reported.
#[derive(PartialEq, Eq, Default, Debug)]
pub struct DiagnosticMark {
    /// The line on which it begins, from 1; 0 for any.
    pub line: u32,
    /// `error` or `warning`.
    pub severity: String,
    /// The code of the diagnostic.
    pub code: String,
    /// The text at which it points.
    pub at: Option<String>,
    /// What it suggests; empty for nothing.
    pub suggests: Option<String>,
    /// The message of the diagnostic.
    pub says: Option<String>,
}

impl Marks {
    /// Reads the marks of a program.
    ///
    /// # Errors
    /// What is wrong with a mark.
    pub fn of(program: &str) -> Result<Marks, String> {
        let mut marks = Marks::default();
        let mut rest = 0;
        while let Some(start) = program[rest..].find("(*!").map(|at| rest + at) {
            let end = program[start..].find("*)").ok_or("a mark does not end")? + start;
            let line = program[..start].matches('\n').count() + 1;
            marks.read(&program[start + 3..end], line)?;
            rest = end;
        }
        Ok(marks)
    }

    pub(crate) fn on_any_line(mut self) -> Marks {
        self.diagnostics.iter_mut().for_each(|mark| mark.line = 0);
        self
    }

    fn read(&mut self, mark: &str, line: usize) -> Result<(), String> {
        let (word, rest) = mark.trim().split_once([' ', '\n']).unwrap_or((mark.trim(), ""));
        let wrong = || format!("`{}` is no mark", mark.trim());
        match word {
            "error" | "warning" => self.diagnostics.extend(diagnostics(word, rest, line as u32)?),
            "fault" => self.fault = Some((rest.to_owned(), line as u32)),
            "values" => {
                let first = mark.trim_start().lines().next().unwrap_or_default();
                let after = first
                    .strip_prefix("values after ")
                    .map(|scan| scan.trim().parse());
                let after = after.transpose().map_err(|_| wrong())?;
                for (index, row) in mark.trim_start().lines().enumerate().skip(1) {
                    if let Some((path, literal)) = row.split_once(" = ") {
                        self.values.push(Value {
                            line: line + index,
                            after,
                            path: path.trim().to_owned(),
                            literal: literal.trim().to_owned(),
                        });
                    }
                }
            }
            "set" => {
                let (name, rest) = rest.split_once(" = ").ok_or_else(wrong)?;
                let (literal, scan) = rest.rsplit_once(" before ").ok_or_else(wrong)?;
                let scan = scan.trim().parse().map_err(|_| wrong())?;
                self.settings.push((scan, name.to_owned(), literal.to_owned()));
            }
            _ => return Err(wrong()),
        }
        Ok(())
    }
}

/// Reads the words of an `error` or a `warning`.
fn diagnostics(severity: &str, words: &str, line: u32) -> Result<Vec<DiagnosticMark>, String> {
    let (words, says) = match words.split_once("says ") {
        Some((words, message)) => (words, Some(message.trim().to_owned())),
        None => (words, None),
    };
    let mut found: Vec<DiagnosticMark> = Vec::new();
    let mut rest = words.trim();
    while !rest.is_empty() {
        let (word, after) = rest.split_once(' ').unwrap_or((rest, ""));
        rest = after.trim_start();
        let Some(last) = found.last_mut().filter(|_| matches!(word, "at" | "suggests")) else {
            found.push(DiagnosticMark {
                line,
                severity: severity.to_owned(),
                code: word.to_owned(),
                ..DiagnosticMark::default()
            });
            continue;
        };
        let text = if let Some(after) = rest.strip_prefix("nothing") {
            rest = after.trim_start();
            ""
        } else {
            let quoted = rest.strip_prefix('`').and_then(|rest| rest.split_once('`'));
            let (text, after) = quoted.ok_or_else(|| format!("`{word}` needs a text between backticks"))?;
            rest = after.trim_start();
            text
        };
        let place = if word == "at" {
            &mut last.at
        } else {
            &mut last.suggests
        };
        *place = Some(text.to_owned());
    }
    let last = found.last_mut().ok_or("a mark names no code")?;
    last.says = says;
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_mark_is_read_with_its_line() {
        let text = "PROGRAM p\nx := y; (*! error P1 at `a b` suggests nothing P2 says … z *)\n(*! set x = INT#5 before 2 *)\n\
                    (*! fault subrange *)\n(*! values after 2\n a[1]  = INT#5\n*)\n(*! values\ns = STRING#' = '\n*)";
        let marks = Marks::of(text).expect("marks");
        let mark = |code: &str| DiagnosticMark {
            line: 2,
            severity: "error".to_owned(),
            code: code.to_owned(),
            ..DiagnosticMark::default()
        };
        let first = DiagnosticMark {
            at: Some("a b".to_owned()),
            suggests: Some(String::new()),
            ..mark("P1")
        };
        let second = DiagnosticMark {
            says: Some("… z".to_owned()),
            ..mark("P2")
        };
        assert_eq!(marks.diagnostics, [first, second]);
        assert_eq!(marks.fault, Some(("subrange".to_owned(), 4)));
        assert_eq!(marks.settings, [(2, "x".to_owned(), "INT#5".to_owned())]);
        let value = |line, after, path: &str, literal: &str| Value {
            line,
            after,
            path: path.to_owned(),
            literal: literal.to_owned(),
        };
        let values = [
            value(6, Some(2), "a[1]", "INT#5"),
            value(9, None, "s", "STRING#' = '"),
        ];
        assert_eq!(marks.values, values);
    }

    #[test]
    fn what_is_no_mark_is_told() {
        for wrong in [
            "(*! eror P1 *)",
            "(*! error *)",
            "(*! error P1 at b *)",
            "(*! set x = 5 *)",
            "(*! error P1",
        ] {
            assert!(Marks::of(wrong).is_err(), "{wrong}");
        }
    }
}
