//! Drivers: programs that run translated programs and print the observed values.

use super::locate::{self, failed, faulted};
use super::printed::{self, PrintedKind};
use crate::process::Folder;
use crate::{NamedValue, Outcome, RunRequest};
use std::fmt::Write;
use stickler_types::{Fault, Value};

/// A driver program, and how its output is read.
pub(super) struct Driver<'r> {
    /// The program in C or C++.
    pub(super) text: String,
    /// The programs that the driver runs, in order.
    pub(super) subjects: Vec<DrivenProgram<'r>>,
    /// Parses one printed value; returns `None` where the text is no such value.
    pub(super) read: fn(&PrintedKind<'_>, &str) -> Option<Value>,
    /// The exit codes by which the driver reports faults.
    pub(super) faults: &'static [(i32, Fault)],
}

/// A translated program that a driver runs.
pub(super) struct DrivenProgram<'r> {
    /// The request that the program answers.
    pub(super) request: RunRequest<'r>,
    /// The kind of each observed value, in the order of the observations.
    pub(super) kinds: Vec<PrintedKind<'r>>,
}

/// The C functions that run several programs, each for at most 5 seconds, after which a program is run alone.
const SEVERAL: &str = include_str!("driver/several.c");

/// Returns the end of the text of a driver, which calls `runs(number)` for one of `count` programs and returns its result as
/// the exit code. Where there are several programs, the driver takes the number of one, or else runs all of them one after the
/// other, each in a process of its own, so that none sees what another left behind, and a failing program does not affect the
/// others.
pub(super) fn main(count: usize, runs: impl Fn(usize) -> String) -> String {
    if count == 1 {
        return format!("int main(void) {{\n    return {};\n}}\n", runs(0));
    }
    let mut text = "static int run(int number) {\n    switch (number) {\n".to_owned();
    for number in 0..count {
        // Writing into a String does not fail.
        let _ = writeln!(text, "    case {number}: return {};", runs(number));
    }
    let _ = write!(
        text,
        "    }}\n    return 1;\n}}\n#define PROGRAMS {count}\n{SEVERAL}"
    );
    text
}

/// The mark before the output of a program that is run among others; its number follows.
const BEGINS: &str = "< ";

/// The mark behind the output of a program that ran to its end; its number follows.
const ENDS: &str = "> ";

impl<'r> Driver<'r> {
    /// Runs the driver's only program, which was built in a folder.
    ///
    /// # Errors
    /// [`Outcome::Unusable`] where the program dies, [`Outcome::Error`] for output that is no value, otherwise an outcome as
    /// [`locate::execute`] returns.
    pub(super) fn execute(&self, folder: &Folder) -> Result<Outcome, Outcome> {
        let only = self.subjects.first();
        let only = only.ok_or_else(|| failed("its driver runs nothing".to_owned()))?;
        let nothing: [&str; 0] = [];
        self.execute_one(only, &nothing, folder)
    }

    /// Runs all programs of the driver, which were built in a folder.
    pub(super) fn execute_all(&self, folder: &Folder) -> Vec<Outcome> {
        let nothing: [&str; 0] = [];
        let ended = locate::execute(&folder.path().join("driver"), &nothing, folder).ok();
        let printed = ended.filter(|ended| ended.status.success());
        let printed = printed.map_or_else(String::new, |ended| ended.stdout);
        let printed = parts(&printed, self.subjects.len());
        let alone = |number: usize, subject: &DrivenProgram<'_>| {
            let outcome = self.execute_one(subject, &[number.to_string()], folder);
            outcome.unwrap_or_else(|outcome| outcome)
        };
        let subjects = self.subjects.iter().zip(printed).enumerate();
        subjects
            .map(|(number, (subject, printed))| match printed {
                Some(printed) => match self.values(&printed, subject) {
                    Ok(values) => Outcome::executed(values),
                    Err(_) => alone(number, subject),
                },
                None => alone(number, subject),
            })
            .collect()
    }

    fn execute_one<A: AsRef<std::ffi::OsStr>>(
        &self,
        subject: &DrivenProgram<'_>,
        arguments: &[A],
        folder: &Folder,
    ) -> Result<Outcome, Outcome> {
        let ended = locate::execute(&folder.path().join("driver"), arguments, folder).map_err(unusable)?;
        if ended.stopped_by_arithmetic() {
            return Ok(faulted(Fault::DivisionByZero, Vec::new()));
        }
        let code = ended.code().map_err(unusable)?;
        if code == 0 {
            let values = self.values(&ended.stdout, subject).map_err(failed)?;
            return Ok(Outcome::executed(values));
        }
        let listed = self.faults.iter().find(|(of, _)| *of == code);
        listed
            .map(|(_, fault)| faulted(*fault, Vec::new()))
            .ok_or_else(|| unusable(ended.crashed()))
    }

    /// Parses the values that the driver printed of a program.
    ///
    /// # Errors
    /// A fragment that says what is wrong with the output.
    pub(super) fn values(
        &self,
        printed: &str,
        subject: &DrivenProgram<'_>,
    ) -> Result<Vec<NamedValue>, String> {
        printed::values(printed, &subject.request, &subject.kinds, self.read)
    }
}

/// Returns the outcome of a program that was accepted and built, from how its execution ended.
fn unusable(ended: Outcome) -> Outcome {
    match ended {
        Outcome::Crashed { reason } => Outcome::Unusable {
            reason: format!("the program that it made dies: {reason}"),
        },
        other => other,
    }
}

/// Splits the output of a driver that ran `count` programs one after the other. Returns the output of each program; `None` for
/// a program that did not run to its end.
fn parts(printed: &str, count: usize) -> Vec<Option<String>> {
    let mut parts: Vec<Option<String>> = vec![None; count];
    let mut part = String::new();
    for line in printed.lines().filter(|line| !line.is_empty()) {
        if line.starts_with(BEGINS) {
            part.clear();
        } else if let Some(number) = line.strip_prefix(ENDS) {
            let number = number.parse().ok();
            if let Some(whole) = number.and_then(|number: usize| parts.get_mut(number)) {
                *whole = Some(std::mem::take(&mut part));
            }
        } else {
            part.push_str(line);
            part.push('\n');
        }
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::parts;

    #[test]
    fn only_what_ran_to_its_end_has_printed_something() {
        let printed = "\n< 0\n0 1\n1 2\n\n> 0\n\n< 1\n0 \n< 2\n\n> 2\n\n> 9\n\n> x\n";
        let whole = Some("0 1\n1 2\n".to_owned());
        assert_eq!(parts(printed, 3), [whole, None, Some(String::new())]);
    }
}
