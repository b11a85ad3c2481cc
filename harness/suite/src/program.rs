//! A program with marks, read once and expanded many times.

use std::sync::Arc;

use stickler_types::{DialectName, grouped_by_key};

use crate::assemble::Assembler;
use crate::error::Mistake;
use crate::mark::{Mark, MarkClaim};
use crate::mark_reader::MarkReader;
use crate::place::TextPlace;
use crate::scan::{RawMark, scan};
use crate::template::Template;
use crate::unmarked::unmarked;

/// The number of mistakes in the marks of one program after which the rest is dropped, because they have one cause.
const MAX_MISTAKES: usize = 50;

/// A program or a template of programs, with its marks.
#[derive(Debug)]
pub(crate) struct ProgramTemplate {
    /// The program, with blanks in place of its marks.
    pub(crate) source: Template,
    pub(crate) marks: Vec<Mark>,
    /// The position of the source in the case file.
    pub(crate) place: TextPlace,
    /// The placeholders that the program uses outside its marks, by index.
    pub(crate) used: Vec<bool>,
    /// The placeholders that marks use, by index.
    used_in_marks: Vec<bool>,
}

impl ProgramTemplate {
    /// Reads `text`; comments before the byte `marks_from` (the header) are not read as marks. Adds warnings about a program that can be used to
    /// `remarks`.
    pub(crate) fn read(
        text: &str,
        marks_from: usize,
        place: TextPlace,
        reader: &MarkReader<'_>,
        remarks: &mut Vec<Mistake>,
    ) -> Result<ProgramTemplate, Vec<Mistake>> {
        let mut mistakes = Vec::new();
        let found = scan(text);
        if let Some(line) = found.unclosed {
            mistakes.push(Mistake::new(place.line(line), "the mark is not closed"));
        }
        for &line in found.hidden.iter().take(MAX_MISTAKES) {
            let message = "`(*!` stands in a string or in another comment, where it is no mark";
            remarks.push(Mistake::new(place.line(line), message));
        }
        let (unmarked, offsets) = unmarked(text, &found.marks);
        let source = read_source(text, place, reader)
            .and_then(|marked| Ok((marked, read_source(&unmarked, place, reader)?)))
            .map_err(|mistake| mistakes.push(mistake))
            .ok();
        let mut marks = Vec::new();
        let mut spans = Vec::new();
        let read = found.marks.iter().zip(offsets);
        for (raw, offset) in read.filter(|(raw, _)| raw.start >= marks_from) {
            if mistakes.len() > MAX_MISTAKES {
                mistakes.push(Mistake::new(
                    place.line(raw.line),
                    "further mistakes in marks are left out",
                ));
                break;
            }
            match reader.read(raw) {
                Ok(mark) => marks.push(Mark { offset, ..mark }),
                Err(mistake) => mistakes.push(Mistake::new(place.line(mistake.line), mistake.message)),
            }
            spans.push(*raw);
        }
        match source {
            Some((marked, source)) if mistakes.is_empty() => {
                let names = reader.testable.names.len();
                let (used, used_in_marks) = uses(&marked, &spans, names);
                Ok(ProgramTemplate {
                    source,
                    marks,
                    place,
                    used,
                    used_in_marks,
                })
            }
            _ => Err(mistakes),
        }
    }

    /// Returns the indices of the marks that apply in a dialect.
    pub(crate) fn active(&self, dialect: DialectName, texts: &[&str]) -> Vec<usize> {
        let applies = |mark: &Mark| {
            mark.dialects
                .as_ref()
                .is_none_or(|dialects| dialects.contains(&dialect))
                && mark.condition.holds(texts)
        };
        self.marks
            .iter()
            .enumerate()
            .filter(|(_, mark)| applies(mark))
            .map(|(index, _)| index)
            .collect()
    }

    /// Groups the dialects in which the same marks apply, in the order of the first dialect of each group.
    pub(crate) fn groups(
        &self,
        dialects: &[DialectName],
        texts: &[&str],
    ) -> Vec<(Vec<usize>, Vec<DialectName>)> {
        let dialects = dialects.iter();
        grouped_by_key(dialects.map(|&dialect| (self.active(dialect, texts), dialect)))
    }

    /// Returns whether one of these marks claims that the program is rejected.
    pub(crate) fn rejects(&self, active: &[usize]) -> bool {
        self.claims(active)
            .any(|claim| matches!(claim, MarkClaim::Error(_)))
    }

    /// Returns whether one of these marks claims a warning.
    pub(crate) fn warns(&self, active: &[usize]) -> bool {
        self.claims(active)
            .any(|claim| matches!(claim, MarkClaim::Warning(_)))
    }

    /// Returns whether one of these marks claims that execution stops with a fault.
    pub(crate) fn faults(&self, active: &[usize]) -> bool {
        self.claims(active)
            .any(|claim| matches!(claim, MarkClaim::Fault(_)))
    }

    fn claims(&self, active: &[usize]) -> impl Iterator<Item = &MarkClaim> {
        active.iter().map(|&index| &self.marks[index].claim)
    }

    /// Adds the claims of these marks to an assembler.
    pub(crate) fn apply(
        &self,
        active: &[usize],
        texts: &[&str],
        assembler: &mut Assembler,
    ) -> Result<(), Mistake> {
        let moved = texts.iter().any(|text| text.contains('\n'));
        for &index in active {
            let mark = &self.marks[index];
            let line = mark.line
                + if moved {
                    self.lines_before(mark.offset, texts)
                } else {
                    0
                };
            assembler.mark(mark, line, |line| self.place.line(line), texts)?;
        }
        Ok(())
    }

    /// Returns the number of line breaks that placeholders add before an offset of the template.
    fn lines_before(&self, offset: usize, texts: &[&str]) -> u32 {
        let slots = self.source.placed_slots().take_while(|&(_, at)| at < offset);
        let lines = slots
            .map(|(slot, _)| texts[slot].matches('\n').count())
            .sum::<usize>();
        u32::try_from(lines).unwrap_or(u32::MAX)
    }

    /// Returns the placeholder whose text would close or open a comment inside a mark, if there is one.
    pub(crate) fn breaks_a_mark(&self, texts: &[&str]) -> Option<usize> {
        let breaks = |text: &str| text.contains("*)") || text.contains("(*");
        (0..texts.len()).find(|&slot| self.used_in_marks.get(slot) == Some(&true) && breaks(texts[slot]))
    }

    /// Returns whether the program uses a placeholder, inside or outside marks.
    pub(crate) fn uses(&self, slot: usize) -> bool {
        self.used.get(slot) == Some(&true) || self.used_in_marks.get(slot) == Some(&true)
    }

    /// Returns the program with its placeholders replaced.
    pub(crate) fn fill(&self, scratch: &mut String, texts: &[&str]) -> Arc<str> {
        self.source.fill(scratch, texts)
    }
}

fn read_source(text: &str, place: TextPlace, reader: &MarkReader<'_>) -> Result<Template, Mistake> {
    if !reader.is_template {
        return Ok(Template::plain(text));
    }
    Template::parse(text, reader.testable.names).map_err(|mistake| {
        let line = 1 + text.as_bytes()[..mistake.offset]
            .iter()
            .filter(|&&byte| byte == b'\n')
            .count();
        Mistake::new(
            place.line(u32::try_from(line).unwrap_or(u32::MAX)),
            mistake.message,
        )
    })
}

/// Returns which placeholders are used outside marks, and which inside.
fn uses(source: &Template, marks: &[RawMark<'_>], names: usize) -> (Vec<bool>, Vec<bool>) {
    let mut outside = vec![false; names];
    let mut inside = vec![false; names];
    for (slot, at) in source.placed_slots() {
        let before = marks.partition_point(|mark| mark.start <= at);
        let in_mark = before
            .checked_sub(1)
            .is_some_and(|last| at < marks[last].text_start() + marks[last].text.len());
        let list = if in_mark { &mut inside } else { &mut outside };
        if let Some(used) = list.get_mut(slot) {
            *used = true;
        }
    }
    (outside, inside)
}
