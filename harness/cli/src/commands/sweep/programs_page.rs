//! The part of the page for sweeps through programs: mismatches, observations and inputs without an answer.

use super::page::{SweepPage, shown};
use std::io;
use std::time::Duration;
use stickler_conversions::sweep::foreign::{ForeignError, ForeignFindings, Unanswered};
use stickler_types::{Value, join, wrap};
use stickler_types::{counted, grouped};

impl SweepPage<'_> {
    /// Writes the findings of a sweep through programs.
    pub fn end_of_programs(&mut self, found: &ForeignFindings, took: Duration) -> io::Result<()> {
        self.sweeps += 1;
        self.inputs += found.answered();
        self.mismatches += found.mismatches;
        if !found.is_complete() {
            let (done, inputs) = (grouped(found.done), grouped(found.inputs));
            writeln!(self.out, "  stopped by Ctrl-C after {done} of {inputs} inputs")?;
        }
        let answered = counted(found.answered(), "answered input", "answered inputs");
        let programs = counted(found.programs, "program", "programs");
        let about = format!(" among {answered}, {programs}, {:.1} s", took.as_secs_f64());
        self.mismatches(found.mismatches, &about, &found.first)?;
        self.unexamined(found.unexamined)?;
        if found.unexplained > 0 {
            let inputs = counted(found.unexplained, "input has", "inputs have");
            self.paragraph(&format!(
                "{inputs} a wrong sum although each result is right: the engine fails in what the programs rely on \
                 beside the function"
            ))?;
        }
        if found.observed > 0 {
            let results = counted(found.observed, "result differs", "results differ");
            writeln!(
                self.out,
                "  {results} where no source in Stickler says what must come:"
            )?;
            self.differences(&found.first_observed, found.observed)?;
            self.unexamined(found.unexamined_observed)?;
        }
        if found.left_out > 0 {
            let inputs = counted(found.left_out, "input was", "inputs were");
            writeln!(self.out, "  {inputs} left out: no literal says NaN or infinity")?;
        }
        found
            .unanswered
            .iter()
            .try_for_each(|reason| self.unanswered(reason))
    }

    /// Writes the reason why the engine executed nothing of a sweep.
    pub fn not_run(&mut self, error: &ForeignError) -> io::Result<()> {
        self.paragraph(&error.to_string())
    }

    fn unexamined(&mut self, inputs: u64) -> io::Result<()> {
        if inputs == 0 {
            return Ok(());
        }
        let inputs = grouped(inputs);
        self.paragraph(&format!(
            "{inputs} more went through programs with a wrong sum and were not looked at one by one"
        ))
    }

    fn unanswered(&mut self, reason: &Unanswered) -> io::Result<()> {
        let inputs = counted(reason.inputs, "input", "inputs");
        let example = join(reason.example.iter().map(shown as fn(&Value) -> String), ", ");
        self.paragraph(&format!(
            "{inputs} without an answer, first {example}: the engine {}",
            reason.refusal
        ))
    }

    /// Writes a paragraph that may need several lines.
    fn paragraph(&mut self, words: &str) -> io::Result<()> {
        let wrapped = wrap(words);
        wrapped
            .lines()
            .try_for_each(|line| writeln!(self.out, "  {line}"))
    }
}
