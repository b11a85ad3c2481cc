//! Reads `*.st` files: a header and one annotated program become a case in each of its dialects.
//!
//! Basis: conformance-cases/README.md (marks).

use std::sync::Arc;

use stickler_types::{Setting, Value, join};
use toml::Spanned;

use crate::assemble::Assembler;
use crate::assembly::Assembly;
use crate::bases::Bases;
use crate::citations::WrittenBasis;
use crate::condition::Testable;
use crate::error::Mistake;
use crate::frame::{self, DialectGroup, FileContext, Harvest, ProbeFrame};
use crate::mark::MarkWord;
use crate::mark_reader::{MARKS, MarkReader};
use crate::place::TextPlace;
use crate::program::ProgramTemplate;
use crate::scan::{RawMark, scan};
use crate::toml_text;
use serde::Deserialize;

/// Reads a program file.
pub(crate) fn read(context: &FileContext<'_>) -> Harvest {
    let mut harvest = Harvest::default();
    match read_header(context) {
        Ok((header, program_start)) => expand(context, &header, program_start, &mut harvest),
        Err(mistake) => harvest.mistakes.push(mistake),
    }
    harvest
}

/// Returns the header, and the byte offset after its text.
fn read_header(context: &FileContext<'_>) -> Result<(FileHeader, usize), Mistake> {
    let found = scan(context.text);
    let hint = "the first mark is the header: `(*!`, TOML with title, basis and dialects, `*)`";
    let Some(first) = found.marks.first() else {
        let (line, message) = match found.unclosed {
            Some(line) => (line, "the header is not closed"),
            None => (1, "the file has no header"),
        };
        return Err(Mistake::new(line, message).hint(hint));
    };
    if is_other_mark(first) {
        return Err(Mistake::new(first.line, "the first mark is not the header").hint(hint));
    }
    let header = toml_text::read(first.text, first.text_start(), &context.lines)?;
    Ok((header, first.text_start() + first.text.len()))
}

/// Returns whether the text begins like another kind of mark, and so is not a header in TOML.
fn is_other_mark(mark: &RawMark<'_>) -> bool {
    let mut words = mark.text.split_whitespace();
    let word = words.next().unwrap_or_default();
    MARKS.contains(&word) && words.next() != Some("=")
}

fn expand(context: &FileContext<'_>, header: &FileHeader, program_start: usize, harvest: &mut Harvest) {
    let lines = &context.lines;
    let mistakes = &mut harvest.mistakes;
    let dialects = context.resolve(&header.dialects, "dialects", mistakes);
    if dialects.is_empty() && mistakes.is_empty() {
        mistakes.push(Mistake::new(1, "a case needs at least one dialect").key("dialects"));
    }
    let frame = ProbeFrame {
        summary: header.summary.as_deref().map(Arc::from),
        tags: tags(header.tags.iter()),
        scans: frame::scans(header.scans.as_ref(), lines, mistakes),
    };
    let id: Arc<str> = context.id.as_str().into();
    let (set, clock) = settings(context, header, mistakes);
    let testable = Testable {
        names: &[],
        known: 0,
        unnamed: None,
    };
    let reader = MarkReader {
        dialects: context.dialects,
        testable,
        is_template: false,
    };
    let program = match ProgramTemplate::read(
        context.text,
        program_start,
        TextPlace::FILE,
        &reader,
        &mut harvest.remarks,
    ) {
        Ok(program) => program,
        Err(more) => {
            mistakes.extend(more);
            return;
        }
    };
    if !mistakes.is_empty() {
        return;
    }
    note_marks_without_dialect(&program, &dialects, harvest);
    let basis = header.basis.as_ref().map(|basis| WrittenBasis {
        text: basis.get_ref().text().into(),
        line: lines.of(basis),
    });
    let title: Arc<str> = header.title.as_str().into();
    let source = program.fill(&mut String::new(), &[]);
    for (active, members) in program.groups(&dialects, &[]) {
        let mut assembler = Assembler::default();
        assembler.settings(&set, &clock);
        let assembled = program
            .apply(&active, &[], &mut assembler)
            .and_then(|()| assembler.finish(frame.scans, || Arc::clone(&source)));
        match assembled {
            Ok(assembly) => {
                if assembly.claims_nothing() {
                    let message = format!("the case {}", Assembly::NOTHING);
                    harvest.remark(Mistake::new(1, message).hint(Assembly::SAY_OK));
                }
                let group = DialectGroup {
                    id: Arc::clone(&id),
                    title: Arc::clone(&title),
                    basis: basis.clone(),
                    line: 1,
                    source: Arc::clone(&source),
                    assembly,
                    ..DialectGroup::default()
                };
                harvest.add(context, &frame, &group, &members);
            }
            Err(mistake) => {
                let hint = format!("in {}", join(members, ", "));
                let line = mistake.line.max(1);
                harvest.mistakes.push(Mistake { line, ..mistake }.hint(hint));
            }
        }
    }
}

/// Returns the settings of the header.
fn settings(
    context: &FileContext<'_>,
    header: &FileHeader,
    mistakes: &mut Vec<Mistake>,
) -> (Vec<Setting>, Vec<(u32, Value)>) {
    let mut read = |key: &str, before: &Spanned<u32>, value: &Spanned<String>| -> Option<(u32, Value)> {
        let mut wrong = |at: usize, message: String| {
            mistakes.push(Mistake::new(context.lines.line(at), message).key(key));
        };
        if *before.get_ref() == 0 {
            wrong(before.span().start, "scans count from 1".to_owned());
        }
        let parsed = Value::read(value.get_ref()).map_err(|message| wrong(value.span().start, message));
        Some((*before.get_ref(), parsed.ok()?))
    };
    let set = header.set.iter().filter_map(|key| {
        let (before, value) = read("set", &key.before, &key.value)?;
        Some(Setting {
            before,
            name: key.name.as_str().into(),
            value,
        })
    });
    let set = set.collect();
    let clock = header
        .clock
        .iter()
        .filter_map(|key| read("clock", &key.before, &key.value));
    (set, clock.collect())
}

/// Adds a warning for each mark that applies in none of the file's dialects.
fn note_marks_without_dialect(
    program: &ProgramTemplate,
    dialects: &[stickler_types::DialectName],
    harvest: &mut Harvest,
) {
    for mark in &program.marks {
        let applies = mark
            .dialects
            .as_ref()
            .is_none_or(|own| own.iter().any(|dialect| dialects.contains(dialect)));
        if !applies {
            harvest.remarks.push(Mistake::new(
                mark.line,
                "the mark applies in none of the file's dialects",
            ));
        }
    }
}

/// The header of a `.st` file.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct FileHeader {
    pub(crate) title: String,
    pub(crate) basis: Option<Spanned<Bases>>,
    pub(crate) dialects: Vec<Spanned<String>>,
    pub(crate) scans: Option<Spanned<u32>>,
    #[serde(default)]
    pub(crate) tags: Vec<String>,
    pub(crate) summary: Option<String>,
    #[serde(default)]
    pub(crate) set: Vec<SetKey>,
    #[serde(default)]
    pub(crate) clock: Vec<ClockKey>,
}

/// `[[set]]`: a variable that is written before a scan.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct SetKey {
    pub(crate) before: Spanned<u32>,
    pub(crate) name: String,
    pub(crate) value: Spanned<String>,
}

/// `[[clock]]`: the time before a scan.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ClockKey {
    pub(crate) before: Spanned<u32>,
    pub(crate) value: Spanned<String>,
}

/// Converts tags to the form that cases share.
pub(crate) fn tags<'a>(tags: impl Iterator<Item = &'a String>) -> Arc<[Arc<str>]> {
    tags.map(|tag| Arc::from(tag.as_str())).collect()
}
