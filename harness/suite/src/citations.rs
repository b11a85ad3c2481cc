//! The bases that the cases of a file cite: one that asserts cites a source, one that only records cites none.

use std::collections::BTreeMap;
use std::sync::Arc;

use rustc_hash::{FxHashMap, FxHashSet};
use stickler_types::DialectName;

use crate::bases::OR;
use crate::error::Mistake;
use crate::sources::Sources;

/// The basis of every case that asserts nothing. The suite gives it to them; case files do not write it.
pub const NOT_STATED: &str = "rule: not-stated";

/// The bases that a case file writes at one place, with [`OR`] between them.
#[derive(Clone, Debug)]
pub(crate) struct WrittenBasis {
    pub(crate) text: Arc<str>,
    /// The line of the case file.
    pub(crate) line: u32,
}

/// The bases that the cases of a file cite.
#[derive(Debug, Default)]
pub(crate) struct Citations {
    /// The basis that a dialect has of several.
    chosen: FxHashMap<(Arc<str>, DialectName), Arc<str>>,
    /// The lines whose basis a case cites that asserts something.
    used: FxHashSet<u32>,
    /// The bases, by line, that stand where a case asserts nothing.
    idle: BTreeMap<u32, Arc<str>>,
    not_stated: Option<Arc<str>>,
    mistakes: FxHashSet<Mistake>,
}

impl Citations {
    /// Returns the basis of a case that asserts nothing, for which a basis may be written all the same.
    pub(crate) fn none(&mut self, written: Option<&WrittenBasis>) -> Arc<str> {
        if let Some(basis) = written {
            self.idle
                .entry(basis.line)
                .or_insert_with(|| Arc::clone(&basis.text));
        }
        Arc::clone(self.not_stated.get_or_insert_with(|| NOT_STATED.into()))
    }

    /// Returns the basis of a case of a dialect that asserts something: the first of those written whose source speaks for the
    /// dialect; `None` where none is written. Where no source does, a dialect that the file does not name itself has the first: what another
    /// system documents, which binds no compiler of this dialect. Keeps a mistake where none is written, and for each that the case cannot
    /// cite. Without `sources` the first of those written is taken.
    pub(crate) fn cite(
        &mut self,
        written: Option<&WrittenBasis>,
        (dialect, is_named): (DialectName, bool),
        sources: Option<&Sources>,
    ) -> Option<Arc<str>> {
        let is_filled =
            |written: &&WrittenBasis| written.text.split(OR).any(|basis| !basis.trim().is_empty());
        let Some(written) = written.filter(is_filled) else {
            let mistake = Mistake::new(1, "a case asserts something and has no basis").key("basis");
            let hint = "say where the claim comes from: `basis = \"source: section\"`";
            self.mistakes.insert(mistake.hint(hint));
            return None;
        };
        let key = (Arc::clone(&written.text), dialect);
        self.used.insert(written.line);
        if let Some(chosen) = self.chosen.get(&key) {
            return Some(Arc::clone(chosen));
        }
        let all = || written.text.split(OR);
        let mistakes = all().filter_map(|basis| wrong(basis, dialect, sources?));
        let mistakes = mistakes.map(|message| Mistake::new(written.line, message).key("basis"));
        let mut mistakes: Vec<Mistake> = mistakes.collect();
        let chosen = sources.and_then(|sources| sources.choose(&written.text, dialect));
        let stated = all().any(|basis| is_stated(basis, dialect));
        if is_named && sources.is_some() && chosen.is_none() && !stated && mistakes.is_empty() {
            let message = format!("`{}` does not speak for {dialect}", written.text);
            let hint = "cite what says it of this dialect; where nothing does, leave it open";
            mistakes.push(Mistake::new(written.line, message).key("basis").hint(hint));
        }
        self.mistakes.extend(mistakes);
        let first = || all().find(|basis| !basis.trim().is_empty());
        let chosen = match chosen.or_else(first) {
            Some(chosen) if chosen.len() < written.text.len() => chosen.into(),
            _ => Arc::clone(&written.text),
        };
        self.chosen.insert(key, Arc::clone(&chosen));
        Some(chosen)
    }

    /// Returns the mistakes, by line.
    pub(crate) fn mistakes(&self) -> Vec<Mistake> {
        let mut mistakes: Vec<Mistake> = self.mistakes.iter().cloned().collect();
        mistakes.sort();
        mistakes
    }

    /// Returns a warning for each basis that stands only where nothing is asserted.
    pub(crate) fn idle(&self) -> impl Iterator<Item = Mistake> {
        let idle = self.idle.iter().filter(|(line, _)| !self.used.contains(line));
        idle.map(|(&line, text)| {
            let message = format!("`{text}` stands where nothing is asserted");
            Mistake::new(line, message).key("basis").hint("leave it out")
        })
    }
}

/// Returns whether a basis is the definition of the dialect itself.
pub(crate) fn is_stated(basis: &str, dialect: DialectName) -> bool {
    let source = basis.split_once(':').map(|(source, _)| source);
    dialect.definition().is_some() && source == Some(dialect.as_str())
}

/// Returns what is wrong with a basis of a case of this dialect that asserts something.
fn wrong(basis: &str, dialect: DialectName, sources: &Sources) -> Option<String> {
    if is_stated(basis, dialect) {
        return None;
    }
    if basis == NOT_STATED {
        return Some("a case asserts something, so a source must state it".to_owned());
    }
    sources.check(basis).err()
}
