//! The cases that did not pass, in columns of numbers.

use super::texts::{TextNumber, TextTable};
use crate::groups::{Group, GroupNumber, Groups};
use crate::text::{noted, visible};
use indexmap::IndexSet;
use serde::Serialize;
use stickler_run::{CaseEvent, Fact, Grade, Verdict, clip_facts};
use stickler_types::WordTable;

/// The maximum number of cases that are listed; the others are counted, and the event log has them all.
const MAX_CASES: usize = 50_000;

/// The maximum number of lines of what was expected or came.
const MAX_LINES: usize = 60;

/// The cases that did not pass, gathered while the run goes on.
#[derive(Default)]
pub(super) struct MissedCases {
    texts: TextTable,
    /// The groups of the listed cases, in the order of their first cases.
    groups: IndexSet<GroupNumber>,
    columns: Columns,
    left_out: u64,
}

/// The properties of the listed cases, each a list with an element for each case.
#[derive(Default, Serialize)]
struct Columns {
    /// The index of the case's group.
    group: Vec<usize>,
    /// The rest of the case's id behind that of its group, a number of a word.
    arguments: Vec<u32>,
    /// The index of the verdict in [`Verdict::ALL`].
    verdict: Vec<usize>,
    /// The line in the case file; 0 where it is not known.
    line: Vec<u32>,
    expected: Vec<TextNumber>,
    got: Vec<TextNumber>,
    /// The program; `null` where the verdict needs none, or where it is left out.
    program: Vec<TextNumber>,
    /// The number of the word with what a baseline says; `null` where it says nothing.
    baseline: Vec<Option<u32>>,
}

/// The properties of the groups, each a list with an element for each group: numbers of words, unless it says otherwise.
#[derive(Default, Serialize)]
struct GroupColumns {
    id: Vec<u32>,
    dialect: Vec<u32>,
    engine: Vec<u32>,
    title: Vec<u32>,
    basis: Vec<u32>,
    file: Vec<u32>,
    area: Vec<u32>,
    /// The word of the grade; `null` for cases without one.
    grade: Vec<Option<Grade>>,
    /// Whether the document leaves the result open: 1 or 0.
    open: Vec<u8>,
}

/// The data of the cases that did not pass, and of their groups.
#[derive(Serialize)]
pub(super) struct CasesData {
    verdicts: Vec<&'static str>,
    groups: GroupColumns,
    words: Vec<String>,
    /// Texts of several lines, as numbers of words.
    texts: Vec<Vec<u32>>,
    cases: Columns,
    /// The number of cases that did not pass and are not listed.
    cases_left_out: u64,
    /// The number of programs, expectations and outcomes that listed cases lack, since the page has no room for them.
    texts_left_out: u64,
}

impl GroupColumns {
    fn push(&mut self, group: &Group, words: &mut WordTable) {
        self.id.push(words.number(&group.id));
        self.dialect.push(words.number(&group.dialect));
        self.engine.push(words.number(&group.engine));
        self.title.push(words.number(&group.title));
        self.basis.push(words.number(&group.basis));
        self.file.push(words.number(&group.file));
        self.area.push(words.number(&group.area));
        self.grade.push(group.grade);
        self.open.push(u8::from(group.open));
    }
}

impl MissedCases {
    /// Adds a case, and returns its number; `None` where the list has no room for it.
    pub(super) fn take(&mut self, case: &CaseEvent, group: GroupNumber) -> Option<usize> {
        let MissedCases {
            texts,
            groups,
            columns,
            left_out,
        } = self;
        if columns.group.len() >= MAX_CASES {
            *left_out += 1;
            return None;
        }
        let mut facts = |facts: &[Fact]| {
            let clipped = clip_facts(facts, MAX_LINES);
            texts.number(&visible(&Fact::text(&clipped)))
        };
        columns.expected.push(facts(&case.expected));
        columns.got.push(facts(&case.got));
        let program = case.program.as_deref();
        columns
            .program
            .push(program.and_then(|program| texts.number(&visible(program))));
        columns.group.push(groups.insert_full(group).0);
        columns
            .arguments
            .push(texts.words.number(Group::arguments(&case.id)));
        let verdict = Verdict::ALL.iter().position(|verdict| *verdict == case.verdict);
        columns.verdict.push(verdict.unwrap_or_default());
        columns.line.push(case.line.unwrap_or_default());
        let note = case.baseline.as_ref().map(noted);
        columns.baseline.push(note.map(|note| texts.words.number(&note)));
        Some(columns.baseline.len() - 1)
    }

    /// Returns the data for the page, with the groups of the cases.
    pub(super) fn into_data(mut self, groups: &Groups) -> CasesData {
        let mut columns = GroupColumns::default();
        for &number in &self.groups {
            columns.push(groups.of_number(number), &mut self.texts.words);
        }
        let (words, texts, texts_left_out) = self.texts.into_parts();
        CasesData {
            verdicts: Verdict::ALL.iter().map(|verdict| verdict.as_str()).collect(),
            groups: columns,
            words: words.all().cloned().collect(),
            texts,
            cases: self.columns,
            cases_left_out: self.left_out,
            texts_left_out,
        }
    }
}
