//! A source text under reduction: its changes, its weight, and the changes that are allowed.

use super::tree::lists;
use super::words::words;
use crate::reduce::Sites;
use std::cell::RefCell;
use std::collections::{BTreeSet, HashMap};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::ops::Range;
use std::rc::Rc;
use stickler_syntax as syntax;
use stickler_syntax::tree::SourceUnit;
use stickler_types::Dialect;
use stickler_types::{Code, Diagnostic, DialectName};

/// A candidate text, and the conditions for every text derived from it.
#[derive(Clone, Debug)]
pub(super) struct TextDraft {
    pub text: String,
    pub dialect: DialectName,
    /// The defects that the text may have: at most those of the first text.
    allowed: Rc<Allowed>,
    /// The changes that each pass has found for this text; finding them takes longer than applying them.
    found: Rc<RefCell<FoundChanges>>,
}

/// The defects of the first text, which every derived text may have.
#[derive(Debug)]
struct Allowed {
    /// The codes that the reference reports.
    codes: BTreeSet<Code>,
    /// Whether the text could not be read to its end.
    unreadable: bool,
    /// The number of empty lists of statements. The reference accepts them; the standard demands a statement, and a compiler
    /// that does so too would reject a candidate for a reason of its own.
    empty_lists: usize,
}

/// Changes by the name of the pass that found them.
type FoundChanges = HashMap<&'static str, Rc<Vec<TextChange>>>;

/// A change of a text: edits that are applied all or none.
#[derive(Clone, Debug)]
pub(super) struct TextChange(pub Vec<TextEdit>);

/// A range of a text and its replacement.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct TextEdit {
    pub at: Range<usize>,
    pub with: String,
}

impl TextEdit {
    pub fn new(at: Range<usize>, with: impl Into<String>) -> TextEdit {
        TextEdit {
            at,
            with: with.into(),
        }
    }
}

impl TextChange {
    pub fn of(at: Range<usize>, with: impl Into<String>) -> TextChange {
        TextChange(vec![TextEdit::new(at, with)])
    }

    pub fn drop(at: Range<usize>) -> TextChange {
        TextChange::of(at, "")
    }
}

impl TextDraft {
    /// Creates the first candidate of a reduction.
    pub fn new(text: &str, dialect: DialectName) -> TextDraft {
        TextDraft {
            text: text.to_owned(),
            dialect,
            allowed: Rc::new(Allowed::by(text, dialect)),
            found: Rc::default(),
        }
    }

    /// Parses the text.
    pub fn tree(&self) -> SourceUnit<'_> {
        syntax::parse(&self.text, Dialect::of(self.dialect)).0
    }

    /// Returns whether the reference accepts the text, or reports only codes that it reported for the first text.
    pub fn is_allowed(&self) -> bool {
        let now = Allowed::by(&self.text, self.dialect);
        now.codes.is_subset(&self.allowed.codes) && now.empty_lists <= self.allowed.empty_lists
    }

    /// Returns whether the first text was accepted.
    pub fn began_accepted(&self) -> bool {
        self.allowed.codes.is_empty()
    }

    /// Returns whether the first text could not be read.
    pub fn began_unreadable(&self) -> bool {
        self.allowed.unreadable
    }

    /// Applies the chosen changes of a pass. `find` returns all changes, in the order in which they are tried; it is called
    /// once for each text.
    pub fn change(
        &mut self,
        pass: &'static str,
        sites: &mut Sites,
        find: impl FnOnce(&TextDraft) -> Vec<TextChange>,
    ) {
        let known = self.found.borrow().get(pass).cloned();
        let changes = known.unwrap_or_else(|| {
            let changes = Rc::new(find(self));
            self.found.borrow_mut().insert(pass, Rc::clone(&changes));
            changes
        });
        let chosen: Vec<&TextEdit> = changes
            .iter()
            .filter(|_| sites.here())
            .flat_map(|change| &change.0)
            .collect();
        if !chosen.is_empty() {
            *self = self.after(chosen);
        }
    }

    /// Keeps the changes that leave an allowed text when applied alone.
    pub fn only_allowed(&self, mut changes: Vec<TextChange>) -> Vec<TextChange> {
        changes.retain(|change| self.after(change.0.iter().collect()).is_allowed());
        changes
    }

    /// Applies edits. Of overlapping edits the one that begins first is applied, and of two that begin together the longer
    /// one.
    fn after(&self, mut edits: Vec<&TextEdit>) -> TextDraft {
        edits.sort_by_key(|edit| (edit.at.start, usize::MAX - edit.at.end));
        let mut text = String::with_capacity(self.text.len());
        let mut copied = 0;
        for edit in edits {
            if edit.at.start < copied {
                continue;
            }
            let Some(kept) = self.text.get(copied..edit.at.start) else {
                continue;
            };
            text.push_str(kept);
            text.push_str(&edit.with);
            copied = edit.at.end;
        }
        text.push_str(self.text.get(copied..).unwrap_or_default());
        TextDraft {
            text: without_blank_lines(&text),
            dialect: self.dialect,
            allowed: Rc::clone(&self.allowed),
            found: Rc::default(),
        }
    }
}

impl Allowed {
    fn by(text: &str, dialect: DialectName) -> Allowed {
        let found = stickler_reference::errors(text, dialect);
        let (unit, diagnostics) = syntax::parse(text, Dialect::of(dialect));
        Allowed {
            codes: found.iter().filter_map(Diagnostic::registered_code).collect(),
            unreadable: !diagnostics.is_empty(),
            empty_lists: lists(&unit).into_iter().filter(|list| list.is_empty()).count(),
        }
    }
}

/// Removes the blank lines that edits leave.
fn without_blank_lines(text: &str) -> String {
    let lines = text.split_inclusive('\n').filter(|line| !line.trim().is_empty());
    lines.collect()
}

/// Returns the weight of a text: first the number of words and signs, then the number of their characters; blanks weigh
/// nothing, and literals little, because everything is to become a literal.
pub(super) fn weight(draft: &TextDraft) -> (u64, u128) {
    let mut parts = 0_u64;
    let mut size = 0_u128;
    for at in words(&draft.text) {
        let word = &draft.text[at];
        parts += if is_literal(word) { 1 } else { 2 };
        let digits = word.bytes().filter(u8::is_ascii_digit);
        let digits: u128 = digits.map(|digit| u128::from(digit - b'0')).sum();
        size += 100 * word.len() as u128 + digits;
    }
    (parts, size)
}

/// Returns whether a word is a number, a typed literal, TRUE or FALSE.
fn is_literal(word: &str) -> bool {
    word.starts_with(|first: char| first.is_ascii_digit())
        || word.contains('#')
        || word.eq_ignore_ascii_case("TRUE")
        || word.eq_ignore_ascii_case("FALSE")
}

/// Returns a key that is equal for equal texts.
pub(super) fn key(draft: &TextDraft) -> u64 {
    let mut hasher = DefaultHasher::new();
    draft.text.hash(&mut hasher);
    hasher.finish()
}
