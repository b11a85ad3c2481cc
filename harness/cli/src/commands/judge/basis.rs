//! Counts, for each standard function and function block that a program uses, the results in the dialect that a source states, and those that
//! are choices of the reference.

use crate::case_folder::CaseFolder;
use crate::documented::asserted_results;
use serde::Serialize;
use std::collections::BTreeMap;
use stickler_conversions::overview::{AssertedResult, boundary_calls};
use stickler_exact::{expected, signatures};
use stickler_reference::has_block;
use stickler_reference::semantics::is_standard_function;
use stickler_suite::Suite;
use stickler_syntax::names::{UseKind, used};
use stickler_types::{Dialect, DialectName, sorted};

/// A standard function or function block, and what is known of its results in the dialect: those of a conversion function for the boundary values
/// of its types, of others the cases that use them.
#[derive(Clone, Serialize)]
pub(super) struct Used {
    /// The name in capitals.
    pub name: String,
    /// The number of results that a source states.
    pub stated: usize,
    /// The number of results that no source states, so that the reference has a choice of its own.
    pub open: usize,
}

/// The cases of the suite by the functions and function blocks that programs use; the new ones of a program are looked up together, once.
pub(super) struct Basis {
    dialect: DialectName,
    cases: Option<CaseFolder>,
    known: BTreeMap<String, Used>,
}

impl Basis {
    /// Looks things up in a folder of cases; without one only conversion functions are known.
    pub(super) fn new(dialect: DialectName, cases: Option<CaseFolder>) -> Basis {
        Basis {
            dialect,
            cases,
            known: BTreeMap::new(),
        }
    }

    /// Returns the standard functions and function blocks that a text uses and does not declare, in the order of their names.
    pub(super) fn of(&mut self, text: &str) -> Vec<Used> {
        let dialect = Dialect::of(self.dialect);
        let (unit, _) = stickler_syntax::parse(text, dialect);
        let own =
            |name: &str| unit.pous().any(|pou| pou.name.is(name)) || unit.types().any(|ty| ty.name.is(name));
        let is_standard = |kind, name: &str| match kind {
            UseKind::Callee => is_standard_function(dialect.standard_name(name), dialect),
            UseKind::Type => has_block(name),
            UseKind::Value | UseKind::Field | UseKind::Parameter => false,
        };
        let names = used(&unit).into_iter();
        let names = names.filter(|one| is_standard(one.kind, one.name.text) && !own(one.name.text));
        let names = sorted(names.map(|one| one.name.text.to_ascii_uppercase()));
        let new = names.iter().filter(|name| !self.known.contains_key(*name));
        let new: Vec<&String> = new.collect();
        if !new.is_empty() {
            let mut words: Vec<&str> = new.iter().map(|name| name.as_str()).collect();
            if words.iter().any(|name| name.contains("TO_")) {
                // Tables put the names of conversion functions together of those of types.
                words.extend(["}_TO_", "TO_{"]);
            }
            let load = |folder: &CaseFolder| folder.load_mentioning(&words, &[self.dialect]);
            let suite = self.cases.as_ref().map(load);
            let found: Vec<Used> = new.iter().map(|name| self.used(name, suite.as_ref())).collect();
            let found = found.into_iter().map(|used| (used.name.clone(), used));
            self.known.extend(found);
        }
        let known = names.iter().filter_map(|name| self.known.get(name));
        known.cloned().collect()
    }

    /// Counts the results of a function or function block; the suite has the cases that mention it.
    fn used(&self, name: &str, suite: Option<&Suite>) -> Used {
        let mut found = Used {
            name: name.to_owned(),
            stated: 0,
            open: 0,
        };
        let mut count = |is_stated: bool| match is_stated {
            true => found.stated += 1,
            false => found.open += 1,
        };
        let standard = Dialect::of(self.dialect).standard_name(name).to_ascii_uppercase();
        let conversions = signatures(&standard, self.dialect);
        let asserted = suite.map(|suite| asserted_results(suite, &standard));
        let asserted = asserted.unwrap_or_default();
        let is_source = |basis: &str| !basis.starts_with("rule:");
        for signature in &conversions {
            for operands in boundary_calls(signature) {
                let basis = expected(signature, &operands, self.dialect).basis;
                // Recordings and single values of pages stand in the cases.
                let is_asserted = |one: &AssertedResult| {
                    one.dialect == self.dialect && one.operands == operands && is_source(&one.basis)
                };
                count(basis.is_some_and(is_source) || asserted.iter().any(is_asserted));
            }
        }
        let suite = suite.filter(|_| conversions.is_empty());
        for case in suite.iter().flat_map(|suite| &suite.cases) {
            if case.dialect == self.dialect && mentions(&case.source, name) {
                count(!case.is_open());
            }
        }
        found
    }
}

/// Returns whether a name is a word of a text.
fn mentions(text: &str, name: &str) -> bool {
    let is_word = |character: char| character.is_ascii_alphanumeric() || character == '_';
    text.split(|character| !is_word(character))
        .any(|word| word.eq_ignore_ascii_case(name))
}
