//! The page of a sweep: its inputs before it begins, its findings after it ended.

use crate::output::{BAD, BOLD, DIM};
use std::io::{self, Write};
use std::time::Duration;
use stickler_conversions::dialect_list;
use stickler_conversions::sweep::{Difference, MAX_DIFFERENCES, Sampling, Sweep, SweepFindings};
use stickler_engines::Identity;
use stickler_types::{DialectName, Value, counted, grouped, shortened};

/// The maximum number of characters that are shown of a value; texts can be long.
const MAX_VALUE_LEN: usize = 60;

/// The page that is being written, and the totals over its sweeps.
pub struct SweepPage<'p> {
    pub(super) out: &'p mut dyn Write,
    engine: String,
    pub(super) sweeps: usize,
    pub(super) inputs: u64,
    pub(super) mismatches: u64,
}

impl<'p> SweepPage<'p> {
    /// Makes an empty page.
    pub fn new(out: &'p mut dyn Write, engine: &Identity) -> SweepPage<'p> {
        SweepPage {
            out,
            engine: format!("{} {}", engine.name, engine.version),
            sweeps: 0,
            inputs: 0,
            mismatches: 0,
        }
    }

    /// Writes the requested dialects that lack the function.
    pub fn lacking(&mut self, function: &str, dialects: &[DialectName]) -> io::Result<()> {
        match dialects {
            [] => Ok(()),
            _ => writeln!(self.out, "{} has no {function}\n", dialect_list(dialects)),
        }
    }

    /// Writes the function and its inputs, before they are swept: a sweep may take long.
    pub fn begin(&mut self, sweep: &Sweep, sampling: Sampling) -> io::Result<()> {
        let signature = &sweep.signature;
        let operands: Vec<&str> = signature.operands.iter().map(|ty| ty.name()).collect();
        writeln!(
            self.out,
            "{BOLD}{signature}{BOLD:#}  on {}, in {}",
            self.engine,
            dialect_list(&sweep.dialects),
        )?;
        let inputs = grouped(sweep.domain.len());
        match sweep.domain.parts() {
            None => writeln!(self.out, "  {inputs} inputs: every {}", operands.join(", "))?,
            Some((chosen, sampled)) => {
                let (chosen, sampled, seed) = (grouped(chosen), grouped(sampled), sampling.seed);
                let all = match signature.operands[..] {
                    [ty] if !ty.is_text() && ty.bits() <= 32 => format!(", of {}", grouped(1 << ty.bits())),
                    _ => String::new(),
                };
                writeln!(
                    self.out,
                    "  {inputs} inputs: {chosen} at boundaries, {sampled} at random (seed {seed}){all}"
                )?;
            }
        }
        self.out.flush()
    }

    /// Writes the findings of a sweep.
    pub fn end(&mut self, sweep: &Sweep, found: &SweepFindings, took: Duration) -> io::Result<()> {
        self.sweeps += 1;
        self.inputs += found.done;
        self.mismatches += found.mismatches;
        if !found.is_complete() {
            self.cut_short(sweep, found)?;
        }
        let so_far = if found.is_complete() { "" } else { " so far" };
        let about = format!("{so_far}, {:.1} s", took.as_secs_f64());
        self.mismatches(found.mismatches, &about, &found.first)
    }

    /// Writes the number of mismatches and what is said `about` it, and the first of them.
    pub(super) fn mismatches(&mut self, number: u64, about: &str, first: &[Difference]) -> io::Result<()> {
        if number == 0 {
            return writeln!(self.out, "  no mismatch{about}");
        }
        let count = counted(number, "mismatch", "mismatches");
        writeln!(self.out, "  {BAD}{count}{BAD:#}{about}")?;
        self.differences(first, number)
    }

    /// Writes the first differences, and how many more there are.
    pub(super) fn differences(&mut self, first: &[Difference], all: u64) -> io::Result<()> {
        first
            .iter()
            .try_for_each(|difference| self.difference(difference))?;
        let more = all.saturating_sub(MAX_DIFFERENCES as u64);
        if more > 0 {
            writeln!(self.out, "    and {} more", grouped(more))?;
        }
        Ok(())
    }

    fn difference(&mut self, difference: &Difference) -> io::Result<()> {
        let operands: Vec<String> = difference.operands.iter().map(shown).collect();
        let basis = difference
            .basis
            .unwrap_or("open: no source in Stickler says what must come");
        writeln!(
            self.out,
            "    {} gives {BAD}{}{BAD:#}, not {}  {DIM}({basis}){DIM:#}",
            operands.join(", "),
            shown(&difference.got),
            shown(&difference.expected),
        )
    }

    fn cut_short(&mut self, sweep: &Sweep, found: &SweepFindings) -> io::Result<()> {
        // A percentage is at most 100, so it fits whatever the number of inputs.
        let percent = u128::from(found.done) * 100 / u128::from(found.inputs.max(1));
        write!(
            self.out,
            "  stopped by Ctrl-C after {} of {} inputs ({percent} %)",
            grouped(found.done),
            grouped(found.inputs)
        )?;
        match found.done.checked_sub(1) {
            None => writeln!(self.out),
            Some(last) => {
                let last: Vec<String> = sweep.domain.operands(last).iter().map(shown).collect();
                writeln!(self.out, ", the last of them {}", last.join(", "))
            }
        }
    }

    /// Writes how many sweeps were left out because of Ctrl-C.
    pub fn not_begun(&mut self, sweeps: usize) -> io::Result<()> {
        match sweeps {
            0 => Ok(()),
            _ => writeln!(
                self.out,
                "{} not begun",
                counted(sweeps as u64, "sweep was", "sweeps were")
            ),
        }
    }

    /// Writes the totals over all sweeps, where there are several.
    pub fn total(&mut self) -> io::Result<()> {
        if self.sweeps < 2 {
            return Ok(());
        }
        let mismatches = match self.mismatches {
            0 => "no mismatch".to_owned(),
            count => counted(count, "mismatch", "mismatches"),
        };
        writeln!(
            self.out,
            "\n{} sweeps, {} inputs: {mismatches}",
            self.sweeps,
            grouped(self.inputs)
        )
    }
}

/// Returns the shortened literal of a value.
pub(super) fn shown(value: &Value) -> String {
    shortened(&value.to_string(), MAX_VALUE_LEN)
}
