//! The rules that every text of a reduction keeps, so that no candidate is ill-formed unless the start was.

use std::collections::{BTreeSet, HashMap};
use stickler_reference::{Limits, errors, run, variables};
use stickler_syntax::parse;
use stickler_syntax::tree::{SourceUnit, Statement};
use stickler_syntax::visitor::{Context, Visitor, walk};
use stickler_types::{Code, Diagnostic, Dialect, DialectName, Observation, Outcome, RunRequest, Value};

/// Says which texts may be tried in the place of the first one.
pub trait TextRules {
    /// Returns whether a text may be tried.
    fn allow(&self, text: &str, dialect: DialectName) -> bool;

    /// Returns what the first text was.
    fn start(&self) -> TextState;

    /// Returns the values of variables after some scans, as literals, by their names in lower case; of some variables, or of
    /// none.
    fn values(&self, text: &str, dialect: DialectName, scans: u32) -> HashMap<String, String>;
}

/// How far a text is well-formed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TextState {
    /// The text is accepted.
    Accepted,
    /// The text is rejected, but was read to its end.
    Rejected,
    /// The text could not be read to its end.
    Unreadable,
}

/// The rules of the reference: it accepts a text, or reports only codes that it reported for the first one.
#[derive(Debug)]
pub struct ReferenceRules {
    codes: BTreeSet<Code>,
    is_unreadable: bool,
    /// The number of empty lists of statements. The reference accepts them; the standard demands a statement, and a compiler
    /// that does so too would reject a candidate for a reason of its own.
    empty_lists: usize,
}

/// The maximum number of variables that are observed.
const MAX_VARIABLES: usize = 300;

impl ReferenceRules {
    /// Returns the rules for the texts that are made of this one.
    pub fn new(text: &str, dialect: DialectName) -> ReferenceRules {
        let (unit, diagnostics) = parse(text, Dialect::of(dialect));
        ReferenceRules {
            codes: codes(text, dialect),
            is_unreadable: !diagnostics.is_empty(),
            empty_lists: empty_lists(&unit),
        }
    }
}

impl TextRules for ReferenceRules {
    fn allow(&self, text: &str, dialect: DialectName) -> bool {
        codes(text, dialect).is_subset(&self.codes)
            && empty_lists(&parse(text, Dialect::of(dialect)).0) <= self.empty_lists
    }

    fn start(&self) -> TextState {
        match (self.is_unreadable, self.codes.is_empty()) {
            (true, _) => TextState::Unreadable,
            (false, false) => TextState::Rejected,
            (false, true) => TextState::Accepted,
        }
    }

    fn values(&self, text: &str, dialect: DialectName, scans: u32) -> HashMap<String, String> {
        let names = variables(text, dialect, MAX_VARIABLES);
        let observe: Vec<Observation> = names.iter().map(|name| Observation::last(name, "")).collect();
        let request = RunRequest {
            scans,
            ..RunRequest::once(dialect, text, &observe)
        };
        let values = match run(&request, Limits { steps: 100_000 }) {
            Ok(Outcome::Executed { values, .. } | Outcome::Faulted { values, .. }) => values,
            _ => Vec::new(),
        };
        let values = values.into_iter();
        values
            .map(|(name, value)| (name.to_ascii_lowercase(), spell(&value)))
            .collect()
    }
}

/// Returns the codes of the errors of a text.
fn codes(text: &str, dialect: DialectName) -> BTreeSet<Code> {
    let found = errors(text, dialect);
    found.iter().filter_map(Diagnostic::registered_code).collect()
}

/// Returns the number of empty lists of statements of a text.
fn empty_lists(unit: &SourceUnit<'_>) -> usize {
    struct Empty(usize);
    impl<'t, 's: 't> Visitor<'t, 's> for Empty {
        fn statements(&mut self, statements: &'t [Statement], _: &Context<'t, 's>) {
            self.0 += usize::from(statements.is_empty());
        }
    }
    let mut empty = Empty(0);
    walk(unit, &mut empty);
    empty.0
}

/// Spells a value; BOOL and texts without the prefix of their type, which not every compiler reads.
fn spell(value: &Value) -> String {
    let canonical = value.to_string();
    let bare = ["BOOL#", "STRING#", "WSTRING#"]
        .into_iter()
        .find_map(|prefix| canonical.strip_prefix(prefix));
    bare.map_or_else(|| canonical.clone(), str::to_owned)
}
