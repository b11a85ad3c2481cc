//! Programs with one planted error, and the code and the line that documents give it.
//!
//! Each kind of error is an entry of one table, `kinds.toml`. The expectation comes from documents, never from the output of the
//! reference, and each entry or function names them: the registry of codes and the rule code-of-the-context, the cases, the
//! standard. Architecture Invariant: nothing here knows the reference.

mod fault_site;
mod kinds;
mod scope;
mod walk;

use crate::model::Program;
use crate::writer::{Style, WrittenProgram, write};
use arbitrary::Unstructured;
use fault_site::FaultSite;
use kinds::KINDS;
use stickler_syntax::features::features;
use stickler_types::Code;

/// A program with one error.
#[derive(Clone, PartialEq, Debug)]
pub struct Planted {
    /// The program with the error.
    pub program: Program,
    /// The code of the error.
    pub code: Code,
    /// The kind of the error in a few words, one of [`kind_names`].
    pub kind: &'static str,
    /// Whether the diagnostic must come with a suggestion: a value does not convert implicitly, but a function converts it.
    pub suggested: bool,
    mark: Option<String>,
}

impl Planted {
    /// Returns the line of the error in the text of the program; `sound` is the text of the program without the error in the
    /// same style.
    ///
    /// The line of the raw text is taken; else the line of the planted declaration; else the first line that differs. Lines
    /// count from 1.
    pub fn line(&self, sound: &WrittenProgram, broken: &WrittenProgram) -> u32 {
        if let Some(mark) = &self.mark {
            return number_of_first(broken.text.lines().map(|line| line.contains(mark.as_str())));
        }
        if let Some(&line) = broken.raw_lines.first() {
            return line;
        }
        let mut sound = sound.text.lines();
        number_of_first(broken.text.lines().map(|line| Some(line) != sound.next()))
    }
}

/// Returns the number of the first `true`, from 1; 0, which no line has, if there is none.
fn number_of_first(mut lines: impl Iterator<Item = bool>) -> u32 {
    lines.position(|found| found).map_or(0, |before| {
        // No written text has more lines.
        u32::try_from(before + 1).unwrap_or(u32::MAX)
    })
}

/// Returns the names of all kinds of errors.
pub fn kind_names() -> impl Iterator<Item = &'static str> {
    KINDS.iter().map(|kind| kind.name.as_str())
}

/// Plants one error in a sound program; the bytes choose the kind and the place. Returns `None` only if no kind finds a
/// place, which does not happen in a program whose main has a statement.
pub fn plant(program: &Program, bytes: &[u8]) -> Option<Planted> {
    let mut input = Unstructured::new(bytes);
    // When the bytes run out the first kind is tried first.
    let first = input.int_in_range(0..=KINDS.len() - 1).unwrap_or(0);
    // A kind without a place is replaced by another draw, so that its neighbour in the table is not favoured.
    let drawn = (0..8).map(|_| input.int_in_range(0..=KINDS.len() - 1).unwrap_or(0));
    let drawn: Vec<usize> = drawn.collect();
    let order = [first].into_iter().chain(drawn).chain(0..KINDS.len());
    order
        .into_iter()
        .find_map(|number| plant_number(program, number, &mut input))
}

/// Plants an error of the named kind; `None` if the program has no place for it.
pub fn plant_kind(program: &Program, kind: &str, bytes: &[u8]) -> Option<Planted> {
    let number = KINDS.iter().position(|known| known.name == kind)?;
    plant_number(program, number, &mut Unstructured::new(bytes))
}

fn plant_number(program: &Program, number: usize, input: &mut Unstructured<'_>) -> Option<Planted> {
    let kind = KINDS.get(number)?;
    let mut fault = FaultSite::new(program, input);
    kind.plant(&mut fault)?;
    let rules = program.dialect.rules();
    if !rules.features.lacked_types.is_empty() {
        // What the mistake brings in and the dialect lacks would be an error of its own.
        let used = |program: &Program| features(&write(program, &Style::default()).text, rules);
        let brought_in = &used(&fault.program) - &used(program);
        let mut lacked = rules.features.lacks.iter();
        (!lacked.any(|lacked| brought_in.contains(lacked.as_str()))).then_some(())?;
    }
    Some(Planted {
        program: fault.program,
        code: kind.code,
        kind: &kind.name,
        suggested: fault.suggested,
        mark: fault.mark,
    })
}

#[cfg(test)]
mod tests;
