//! A source text on its way to becoming smaller: changes to it, its weight, and which changes are allowed.

use super::tree::lists;
use super::words::words;
use crate::reduce::Sites;
use std::cell::RefCell;
use std::collections::{BTreeSet, HashMap};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::ops::Range;
use std::rc::Rc;
use stickler_reference::syntax::tree::SourceUnit;
use stickler_reference::{Dialect, syntax};
use stickler_types::{Code, Diagnostic, DialectName};

/// A text, and what must hold for every text made from it.
#[derive(Clone, Debug)]
pub(super) struct TextDraft {
    pub text: String,
    pub dialect: DialectName,
    /// What the text may have of what nobody wants: as much as the one that the reduction began with.
    allowed: Rc<Allowed>,
    /// The changes that each pass has found for just this text; finding them takes longer than making them.
    found: Rc<RefCell<FoundChanges>>,
}

/// What the first text had, and so every text made from it may have.
#[derive(Debug)]
struct Allowed {
    /// What the reference finds wrong with it.
    codes: BTreeSet<Code>,
    /// It could not be read to its end.
    unreadable: bool,
    /// Lists of statements with no statement in them. The reference takes them; the standard demands a statement, and a
    /// compiler that does so too would reject a candidate for a reason of its own.
    empty_lists: usize,
}

/// Changes by the name of the pass that found them.
type FoundChanges = HashMap<&'static str, Rc<Vec<TextChange>>>;

/// One thing to do to a text: pieces of it that are replaced, all or none.
#[derive(Clone, Debug)]
pub(super) struct TextChange(pub Vec<TextEdit>);

/// A piece of a text and what comes in its place.
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
    /// The draft that a reduction begins with.
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
        syntax::parse(&self.text, &Dialect::of(self.dialect)).0
    }

    /// Whether the reference accepts the text, or finds nothing wrong that it did not find in the first one.
    pub fn is_allowed(&self) -> bool {
        let now = Allowed::by(&self.text, self.dialect);
        now.codes.is_subset(&self.allowed.codes) && now.empty_lists <= self.allowed.empty_lists
    }

    /// Whether the first text was accepted.
    pub fn began_accepted(&self) -> bool {
        self.allowed.codes.is_empty()
    }

    /// Whether the first text could not be read.
    pub fn began_unreadable(&self) -> bool {
        self.allowed.unreadable
    }

    /// Makes those of a pass's changes that are chosen. `find` gives all of them, in the order in which they are to be tried;
    /// it is asked once for each text.
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

    /// Those of some changes that leave an allowed text when made alone.
    pub fn only_allowed(&self, mut changes: Vec<TextChange>) -> Vec<TextChange> {
        changes.retain(|change| self.after(change.0.iter().collect()).is_allowed());
        changes
    }

    /// The draft after some edits. Of those that overlap, the one that begins first is made, and of two that begin together
    /// the longer one.
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
        let found = stickler_reference::check(text, dialect);
        let (unit, diagnostics) = syntax::parse(text, &Dialect::of(dialect));
        Allowed {
            codes: found.iter().filter_map(Diagnostic::registered_code).collect(),
            unreadable: !diagnostics.is_empty(),
            empty_lists: lists(&unit).into_iter().filter(|list| list.is_empty()).count(),
        }
    }
}

/// Edits leave lines on which nothing stands.
fn without_blank_lines(text: &str) -> String {
    let lines = text.split_inclusive('\n').filter(|line| !line.trim().is_empty());
    lines.collect()
}

/// First how many words and signs there are, then how many characters stand in them; blanks weigh nothing, literals little,
/// for a literal is what everything is to become.
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

/// Whether a word is a number, or a value with the prefix of its type, or one of BOOL.
fn is_literal(word: &str) -> bool {
    word.starts_with(|first: char| first.is_ascii_digit())
        || word.contains('#')
        || word.eq_ignore_ascii_case("TRUE")
        || word.eq_ignore_ascii_case("FALSE")
}

/// The same for the same text.
pub(super) fn key(draft: &TextDraft) -> u64 {
    let mut hasher = DefaultHasher::new();
    draft.text.hash(&mut hasher);
    hasher.finish()
}
