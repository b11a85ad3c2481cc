//! The rows of a table that names its dialects as `all`: one for each result that a source states, with the dialects that have it.

use crate::call::{Agreed, Call};
use crate::claim::OPEN;
use crate::table::{ProbeClaim, Table};
use stickler_suite::SourceKind;
use stickler_types::{Dialect, DialectName, Value, distinct, sorted};

/// The result of a call in a dialect, and the source that states it; `None` where none speaks of this dialect.
struct Statement {
    dialect: DialectName,
    value: Value,
    basis: Option<&'static str>,
}

impl Table {
    /// Returns each result that a source states of a call, with the dialects of which it does. Where all agree on one result, a second row
    /// has the dialects of which no source speaks and whose own choices give it: it cites what other systems document, so that a compiler
    /// with another result differs. Where the probes observe the type of the result, a last row has the other dialects, in which it is
    /// recorded.
    ///
    /// # Errors
    /// A sentence, where a probe asserts nothing, the table has no column `dialects`, or no source states a result.
    pub(crate) fn in_every_dialect(&self, call: &Call) -> Result<Vec<Agreed>, String> {
        if !self.has_column("dialects") {
            return Err("the table names its dialects as `all` and has no column `dialects`".to_owned());
        }
        let mut probes = self.probes.iter();
        if let Some(probe) = probes.find(|probe| probe.claim != Some(ProbeClaim::Value)) {
            let name = &probe.name;
            return Err(format!("`{name}` asserts no result, in dialects named as `all`"));
        }
        let statements = self.statements(call);
        let stated = statements.iter().filter(|statement| statement.basis.is_some());
        let values = distinct(stated.map(|statement| statement.value.clone()));
        let is_recorded = self.generate.is_none() && self.probes.iter().all(|probe| probe.may_be_open);
        if values.is_empty() && !is_recorded {
            return Err("no source states the result".to_owned());
        }
        let (stated, unstated): (Vec<Statement>, Vec<Statement>) = statements
            .into_iter()
            .partition(|statement| statement.basis.is_some());
        let mut agreed = Vec::new();
        for value in &values {
            let of_value: Vec<&Statement> = stated.iter().filter(|one| one.value == *value).collect();
            agreed.push(self.stated(value, &of_value, call)?);
        }
        let elsewhere = match &values[..] {
            [value] => self.only_elsewhere(&stated).map(|basis| (value, basis)),
            _ => None,
        };
        let follows = |one: &Statement| {
            elsewhere.as_ref().is_some_and(|(value, basis)| {
                one.value == **value && self.chosen(basis, one.dialect).is_none()
            })
        };
        let (following, open): (Vec<Statement>, Vec<Statement>) = unstated.into_iter().partition(follows);
        if let Some((value, basis)) = elsewhere.filter(|_| !following.is_empty()) {
            agreed.push(Agreed {
                value: value.to_string(),
                basis,
                dialects: self.named(&dialects_of(&following), call),
            });
        }
        if is_recorded && !open.is_empty() {
            agreed.push(Agreed {
                value: OPEN.to_owned(),
                basis: String::new(),
                dialects: self.named(&dialects_of(&open), call),
            });
        }
        Ok(agreed)
    }

    /// Returns the bases of statements that are about single systems, as a cell has them: what a dialect cites of which no source speaks, so
    /// that the case binds nobody. `None` where only sources that speak for every dialect state the result.
    fn only_elsewhere(&self, stated: &[Statement]) -> Option<String> {
        let is_of_a_system = |basis: &&str| {
            let kind = self.kind_of(basis);
            kind.is_some_and(|kind| !matches!(kind, SourceKind::Standard | SourceKind::Rule))
        };
        let bases = stated.iter().filter_map(|statement| statement.basis);
        let bases = sorted(bases.filter(is_of_a_system));
        (!bases.is_empty()).then(|| bases.join(stickler_suite::OR))
    }

    /// Returns the dialects that any probe asks.
    fn dialects_of_probes(&self) -> impl Iterator<Item = DialectName> {
        let asks = |dialect: &DialectName| self.probes.iter().any(|probe| probe.dialects.contains(dialect));
        DialectName::ALL.into_iter().filter(asks)
    }

    /// Returns the statements of the dialects of the probes that have the function.
    fn statements(&self, call: &Call) -> Vec<Statement> {
        let statement = |dialect: DialectName| {
            let own = call.expected(dialect)?;
            let basis = own
                .basis
                .or_else(|| self.by_the_standard(call, dialect, &own.value));
            let value = own.value;
            Some(Statement {
                dialect,
                value,
                basis,
            })
        };
        self.dialects_of_probes().filter_map(statement).collect()
    }

    /// Returns the table of the third edition that states the result, for a dialect that declares this edition.
    fn by_the_standard(&self, call: &Call, dialect: DialectName, value: &Value) -> Option<&'static str> {
        let stated = call.expected(DialectName::IEC_ED3)?;
        let basis = stated.basis.filter(|_| stated.value == *value)?;
        let is_declared = Dialect::of(dialect).features.edition >= Some(3);
        let is_standard = self.kind_of(basis) == Some(SourceKind::Standard);
        (is_declared && is_standard).then_some(basis)
    }

    /// Returns the row of a result for the dialects of which a source states it.
    fn stated(&self, value: &Value, statements: &[&Statement], call: &Call) -> Result<Agreed, String> {
        let said: Vec<(DialectName, &'static str)> = statements
            .iter()
            .filter_map(|statement| Some((statement.dialect, statement.basis?)))
            .collect();
        let is_named = |&(dialect, basis): &(DialectName, &str)| {
            self.probes
                .iter()
                .all(|probe| self.chosen(&probe.basis, dialect) == Some(basis))
        };
        let basis = match said.iter().find(|said| !is_named(said)) {
            None => String::new(),
            Some(_) if self.has_column("basis") => self.bases(&said)?,
            Some((dialect, basis)) => {
                return Err(format!("no probe names {basis}, which says so in {dialect}"));
            }
        };
        Ok(Agreed {
            value: value.to_string(),
            basis,
            dialects: self.named(&dialects_of(statements.iter().copied()), call),
        })
    }

    /// Returns the names of dialects in the shorter way: nothing for all of the table that have the types of the call, all but some of
    /// these, or those.
    fn named(&self, dialects: &[DialectName], call: &Call) -> String {
        let others = self
            .dialects_of_probes()
            .filter(|dialect| !dialects.contains(dialect));
        let others: Vec<&str> = others
            .filter(|dialect| call.may_be_named(*dialect))
            .map(DialectName::as_str)
            .collect();
        let those: Vec<&str> = dialects.iter().map(|dialect| dialect.as_str()).collect();
        match others.len() {
            0 => String::new(),
            number if number < those.len() => format!("all but {}", others.join(" ")),
            _ => those.join(" "),
        }
    }
}

fn dialects_of<'s>(statements: impl IntoIterator<Item = &'s Statement>) -> Vec<DialectName> {
    statements
        .into_iter()
        .map(|statement| statement.dialect)
        .collect()
}
