//! A source text under reduction: its changes, and its weight.

use crate::rules::TextRules;
use crate::{Sites, TextView};
use std::cell::RefCell;
use std::collections::HashMap;
use std::hash::{Hash, Hasher};
use std::rc::Rc;
use stickler_syntax::{Edits, tokens};
use stickler_types::{Dialect, DialectName};

/// A candidate text, and the rules for every text derived from it.
#[derive(Clone)]
pub struct TextDraft {
    text: String,
    dialect: DialectName,
    rules: Rc<dyn TextRules>,
    /// The changes that each pass has found for this text; finding them takes longer than making them.
    found: Rc<RefCell<FoundChanges>>,
}

/// Changes by the name of the pass that found them.
type FoundChanges = HashMap<&'static str, Rc<Vec<Edits>>>;

impl TextDraft {
    /// Creates the first candidate of a reduction.
    pub fn new(text: &str, dialect: DialectName, rules: Rc<dyn TextRules>) -> TextDraft {
        TextDraft {
            text: text.to_owned(),
            dialect,
            rules,
            found: Rc::default(),
        }
    }

    /// Returns the text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Returns the dialect in which the text is read.
    pub fn dialect(&self) -> DialectName {
        self.dialect
    }

    /// Returns the rules that every text of the reduction keeps.
    pub fn rules(&self) -> &dyn TextRules {
        &*self.rules
    }

    /// Returns whether the text keeps the rules.
    pub fn is_allowed(&self) -> bool {
        self.rules.allow(&self.text, self.dialect)
    }

    /// Takes another text in the place of this one.
    pub fn replace_text(&mut self, text: String) {
        self.text = text;
        self.found = Rc::default();
    }

    /// Makes the chosen changes of a pass. `find` lists all changes, in the order in which they are tried; it is called once
    /// for each text.
    pub fn change(
        &mut self,
        pass: &'static str,
        sites: &mut Sites,
        find: impl FnOnce(&TextView<'_>) -> Vec<Edits>,
    ) {
        let known = self.found.borrow().get(pass).cloned();
        let changes = known.unwrap_or_else(|| {
            let changes = Rc::new(self.view(find));
            self.found.borrow_mut().insert(pass, Rc::clone(&changes));
            changes
        });
        let mut chosen = Edits::new();
        chosen.extend(changes.iter().filter(|_| sites.here()).cloned());
        if !chosen.is_empty() {
            *self = self.after(&chosen);
        }
    }

    /// Returns the text after a change, without the blank lines that it leaves.
    pub(crate) fn after(&self, change: &Edits) -> TextDraft {
        let text = change.apply(&self.text);
        let lines = text.split_inclusive('\n').filter(|line| !line.trim().is_empty());
        TextDraft {
            text: lines.collect(),
            dialect: self.dialect,
            rules: Rc::clone(&self.rules),
            found: Rc::default(),
        }
    }
}

/// Equal texts are the same candidate.
impl Hash for TextDraft {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.text.hash(state);
    }
}

/// Returns the weight of a text: first the number of its tokens, then that of their characters; blanks weigh nothing, and
/// literals little, because everything is to become a literal.
pub(crate) fn weight(draft: &TextDraft) -> (u64, u128) {
    let mut parts = 0_u64;
    let mut size = 0_u128;
    for token in tokens(&draft.text, Dialect::of(draft.dialect)).list {
        let word = token.span.text(&draft.text);
        parts += if token.kind.is_literal() { 1 } else { 2 };
        let digits = word.bytes().filter(u8::is_ascii_digit);
        let digits: u128 = digits.map(|digit| u128::from(digit - b'0')).sum();
        size += 100 * word.len() as u128 + digits;
    }
    (parts, size)
}
