//! Drivers: short C and C++ programs that run translated programs and print the observed values by name.
//!
//! A driver of one program is what a person gets to reproduce it, and what an adapter builds and runs itself. One of several
//! programs is the same for each, and runs each in a process of its own.

use super::Compiler;
use super::builder::Language;
use super::locate::{failed, faulted};
use super::recipe::{Purpose, Recipe, Workplace};
use super::values::{self, ObservedKind};
use crate::{Outcome, RunRequest};
use std::collections::BTreeMap;
use std::ffi::OsStr;
use stickler_types::Fault;

/// A translated program as a driver runs it.
pub(super) struct DrivenProgram<'r> {
    /// The request that the program answers.
    pub(super) request: RunRequest<'r>,
    /// The kind of each observed value, in the order of the observations.
    pub(super) kinds: Vec<ObservedKind<'r>>,
    /// The declarations that the statements need.
    pub(super) declarations: String,
    /// The statements before the first scan.
    pub(super) start: Vec<String>,
    /// The statements before a scan, each with the number of the scan.
    pub(super) before: Vec<(u32, String)>,
    /// The statement that makes a scan.
    pub(super) scan: String,
    /// The statements that print values, each with the number of the scan after which it does; `None` for the last.
    pub(super) after: Vec<(Option<u32>, String)>,
    /// The namespace that the declarations open, where they open one.
    pub(super) namespace: Option<String>,
}

impl DrivenProgram<'_> {
    /// Returns the function that runs the program, without a loop where there is nothing to repeat.
    fn function(&self, head: &str) -> String {
        let mut text = format!("{head} {{\n");
        for statement in &self.start {
            text.push_str(&format!("    {statement}\n"));
        }
        let between = self.after.iter().any(|(scan, _)| scan.is_some());
        if self.request.scans == 1 && self.before.is_empty() && !between {
            text.push_str(&format!("    {}\n", self.scan));
        } else {
            self.write_loop(&mut text);
        }
        for (_, statement) in self.after.iter().filter(|(scan, _)| scan.is_none()) {
            text.push_str(&format!("    {statement}\n"));
        }
        text.push_str("    return 0;\n}\n");
        text
    }

    fn write_loop(&self, text: &mut String) {
        let scans = self.request.scans;
        text.push_str(&format!(
            "    for (unsigned scan = 1; scan <= {scans}; scan++) {{\n"
        ));
        write_by_scan(text, self.before.iter().map(|(scan, one)| (Some(*scan), one)));
        text.push_str(&format!("        {}\n", self.scan));
        write_by_scan(text, self.after.iter().map(|(scan, one)| (*scan, one)));
        text.push_str("    }\n");
    }
}

/// Returns the statements that set the clock of a request before its scans, each with the number of its scan.
pub(super) fn clock(request: &RunRequest<'_>, statement: impl Fn(i64) -> String) -> Vec<(u32, String)> {
    let clock = request.clock.iter();
    clock
        .map(|step| (step.before, statement(step.nanoseconds)))
        .collect()
}

/// Writes the statements of the scan that it is: a choice, for a program may have thousands of scans.
fn write_by_scan<'s>(text: &mut String, statements: impl Iterator<Item = (Option<u32>, &'s String)>) {
    let mut by_scan: BTreeMap<u32, String> = BTreeMap::new();
    for (scan, statement) in statements {
        let Some(scan) = scan else { continue };
        *by_scan.entry(scan).or_default() += &format!(" {{ {statement} }}");
    }
    if by_scan.is_empty() {
        return;
    }
    text.push_str("        switch (scan) {\n");
    for (scan, statements) in by_scan {
        text.push_str(&format!("        case {scan}:{statements} break;\n"));
    }
    text.push_str("        }\n");
}

/// A driver of programs.
pub(super) struct Driver<'r> {
    pub(super) language: &'static Language,
    /// The text before the programs: headers, and the translated text where one file has all of it.
    pub(super) head: String,
    /// The programs, in order.
    pub(super) programs: Vec<DrivenProgram<'r>>,
    /// The compiler that translated the programs.
    pub(super) compiler: Compiler,
}

/// The file of a driver, and its text.
pub(super) struct DriverText {
    pub(super) file: &'static str,
    pub(super) text: String,
}

/// The C functions that run several programs, each for at most 5 seconds, after which a program is run alone. Given the number of
/// a program, they run only that one; otherwise each runs in a process of its own, so that none sees what another left behind, and
/// a failing program does not affect the others.
const SEVERAL: &str = include_str!("driver/several.c");

/// The mark before the output of a program that is run among others; its number follows.
const BEGINS: &str = "< ";

/// The mark behind the output of a program that ran to its end; its number follows.
const ENDS: &str = "> ";

impl Driver<'_> {
    /// Returns the text of the driver.
    pub(super) fn text(&self) -> DriverText {
        let mut programs = String::new();
        let mut cases = String::new();
        for (number, program) in self.programs.iter().enumerate() {
            let head = match self.programs.len() {
                1 => "int main(void)".to_owned(),
                _ => format!("static int run_{number}(void)"),
            };
            programs.push_str(&program.declarations);
            programs.push_str(&program.function(&head));
            let scope = match &program.namespace {
                Some(namespace) => {
                    programs.push_str("}\n");
                    format!("{namespace}::")
                }
                None => String::new(),
            };
            cases.push_str(&format!("    case {number}: return {scope}run_{number}();\n"));
        }
        let mut text = format!("{}{}{programs}", self.head, values::functions(&programs));
        let count = self.programs.len();
        if count > 1 {
            text.push_str(&format!(
                "static int run(int number) {{\n    switch (number) {{\n{cases}    }}\n    return 1;\n}}\n\
                 #define PROGRAMS {count}\n{SEVERAL}"
            ));
        }
        DriverText {
            file: self.language.driver,
            text,
        }
    }

    /// Runs the driver's only program, which was built by a recipe.
    ///
    /// # Errors
    /// [`Outcome::Unusable`] where the program dies, [`Outcome::Error`] for output that is no value, otherwise an outcome as
    /// [`Workplace::step`] returns.
    pub(super) fn execute(&self, recipe: &Recipe, workplace: &Workplace<'_>) -> Result<Outcome, Outcome> {
        let only = self.programs.first();
        let only = only.ok_or_else(|| failed("its driver runs nothing".to_owned()))?;
        self.execute_one(only, &[], recipe, workplace)
    }

    /// Runs all programs of the driver, which were built by a recipe.
    pub(super) fn execute_all(&self, recipe: &Recipe, workplace: &Workplace<'_>) -> Vec<Outcome> {
        let ended = workplace.step(recipe, Purpose::Execute(None), &[]).ok();
        let printed = ended.filter(|ended| ended.status.success());
        let printed = printed.map_or_else(String::new, |ended| ended.stdout);
        let printed = parts(&printed, self.programs.len());
        let programs = self.programs.iter().zip(printed).enumerate();
        programs
            .map(|(number, (program, printed))| {
                let values =
                    printed.map(|printed| values::values(&printed, &program.request, &program.kinds));
                match values {
                    Some(Ok(values)) => Outcome::executed(values),
                    _ => self
                        .execute_one(program, &[number.to_string().as_ref()], recipe, workplace)
                        .unwrap_or_else(|outcome| outcome),
                }
            })
            .collect()
    }

    fn execute_one(
        &self,
        program: &DrivenProgram<'_>,
        arguments: &[&OsStr],
        recipe: &Recipe,
        workplace: &Workplace<'_>,
    ) -> Result<Outcome, Outcome> {
        let ended = workplace
            .step(recipe, Purpose::Execute(None), arguments)
            .map_err(unusable)?;
        if ended.stopped_by_arithmetic() {
            return Ok(faulted(Fault::DivisionByZero, Vec::new()));
        }
        if ended.status.success() {
            let values = values::values(&ended.stdout, &program.request, &program.kinds).map_err(failed)?;
            return Ok(Outcome::executed(values));
        }
        let fault = self.compiler.data().fault(&ended.stderr);
        fault
            .map(|fault| faulted(fault, Vec::new()))
            .ok_or_else(|| unusable(ended.crashed()))
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
pub(super) fn parts(printed: &str, count: usize) -> Vec<Option<String>> {
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
