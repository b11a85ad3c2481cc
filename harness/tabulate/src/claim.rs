//! Whether the documents say of a call what the probes of its table claim.

use crate::call::{Agreed, Call};
use crate::table::{ProbeClaim, Table, TableProbe};
use stickler_exact::{Expected, Operation, page_has_truncation};
use stickler_types::{DialectName, ElementaryType, distinct, sorted};

/// The tables whose probes may record a result that a document speaks of, because their ids are older than that knowledge, or
/// because the program asks something else beside it; other tables assert these results.
const RECORD_MORE: [&str; 5] = [
    "constant-initial-value",
    "string-borderline",
    "time-to-number-inexact",
    "to-string-text",
    "trunc-outside",
];

/// The dialects that differ in their documents; the three of IronPLC have one page on conversion functions. What other systems state
/// is asked in tables of their own.
const DOCUMENTED: [DialectName; 2] = [DialectName::MATIEC, DialectName::IRONPLC_ED3];

/// The word of a row whose result no document states.
pub(crate) const OPEN: &str = "open";

impl Table {
    /// Returns what the asserting probes agree on: one result, or, where they name the dialects as `all`, each result that a source states.
    ///
    /// # Errors
    /// A sentence that names the dialect, where a probe asserts what is open there and the table has no column `dialects`, leaves open what a document says, or names
    /// another document than the one that says so, and the table has no column `basis`; where two dialects give different
    /// results; and where the file leaves out a dialect that has the function.
    pub fn expected(&self, call: &Call) -> Result<Vec<Agreed>, String> {
        let is_of_all = |probe: &TableProbe| probe.is_of_all && probe.claim == Some(ProbeClaim::Value);
        match self.probes.iter().any(is_of_all) {
            true => self.in_every_dialect(call),
            false => Ok(vec![self.in_named_dialects(call)?]),
        }
    }

    fn in_named_dialects(&self, call: &Call) -> Result<Agreed, String> {
        self.check_dialects(call)?;
        let mut agreed: Option<String> = None;
        let mut bases: Vec<(DialectName, &'static str)> = Vec::new();
        let mut misnamed = None;
        let mut leaves_out = false;
        let mut leaves_open = Vec::new();
        for probe in &self.probes {
            for &dialect in probe.dialects.iter().filter(|dialect| !call.is_lacked(**dialect)) {
                let expected = call.expected(dialect);
                let expected = expected.ok_or_else(|| format!("{dialect} has no such function"))?;
                if probe.claim == Some(ProbeClaim::Value) && expected.basis.is_none() {
                    if self.has_column("dialects") {
                        leaves_out = true;
                        continue;
                    }
                    if self.generate.is_none() && probe.may_be_open {
                        leaves_open.push(dialect);
                        continue;
                    }
                }
                self.check(probe, call, dialect, &expected)?;
                let (Some(ProbeClaim::Value), Some(basis)) = (probe.claim, expected.basis) else {
                    continue;
                };
                let value = expected.value.to_string();
                if agreed.get_or_insert_with(|| value.clone()) != &value {
                    return Err(format!("another value in {dialect}"));
                }
                if self.chosen(&probe.basis, dialect) != Some(basis) {
                    misnamed.get_or_insert((probe, dialect, basis));
                }
                bases.push((dialect, basis));
            }
        }
        if let (Some(_), [dialect, ..]) = (&agreed, &leaves_open[..]) {
            return Err(format!("one dialect asserts what is open in {dialect}"));
        }
        let open = leaves_open.first().map_or("", |_| OPEN);
        let basis = match misnamed {
            None => String::new(),
            Some(_) if self.has_column("basis") => self.bases(&bases)?,
            Some((probe, dialect, basis)) => {
                return Err(format!(
                    "`{}` does not name {basis}, which says so in {dialect}",
                    probe.name
                ));
            }
        };
        let asserted: Vec<DialectName> = bases.iter().map(|(dialect, _)| *dialect).collect();
        let dialects = leaves_out.then(|| self.asked(&asserted));
        Ok(Agreed {
            value: agreed.unwrap_or_else(|| open.to_owned()),
            basis,
            dialects: dialects.unwrap_or_default(),
        })
    }

    /// Returns the dialects that ask a row: those that assert its result, and those of the probes that assert none.
    fn asked(&self, asserted: &[DialectName]) -> String {
        let recording = self
            .probes
            .iter()
            .filter(|probe| probe.claim != Some(ProbeClaim::Value));
        let recorded = recording.flat_map(|probe| &probe.dialects);
        let dialects = asserted.iter().chain(recorded);
        distinct(dialects.map(|dialect| dialect.as_str())).join(" ")
    }

    /// Returns the bases of a call as a cell has them: sources that speak for some dialects stand before those that speak for
    /// all.
    pub(crate) fn bases(&self, said: &[(DialectName, &'static str)]) -> Result<String, String> {
        let mut bases = sorted(said.iter().map(|(_, basis)| *basis));
        let speaks_for = |basis: &str| {
            let all = DialectName::ALL.into_iter();
            all.filter(|dialect| self.chosen(basis, *dialect).is_some())
                .count()
        };
        bases.sort_by_key(|basis| speaks_for(basis));
        let cell = bases.join(stickler_suite::OR);
        match said
            .iter()
            .find(|(dialect, basis)| self.chosen(&cell, *dialect) != Some(*basis))
        {
            None => Ok(cell),
            Some((dialect, basis)) => Err(format!("`{cell}` is not {basis} in {dialect}")),
        }
    }

    /// Checks what a probe claims in one dialect.
    fn check(
        &self,
        probe: &TableProbe,
        call: &Call,
        dialect: DialectName,
        expected: &Expected,
    ) -> Result<(), String> {
        let name = &probe.name;
        let may_record = RECORD_MORE.contains(&self.name.as_str());
        match (probe.claim, expected.basis) {
            (None, _) => Err(format!("`{name}` neither asserts a result nor records one")),
            (Some(ProbeClaim::Value), None) => Err(format!("`{name}` asserts what is open in {dialect}")),
            (Some(ProbeClaim::Open | ProbeClaim::NeverFaults), Some(basis)) if !may_record => {
                Err(format!("`{name}` leaves open in {dialect} what {basis} says"))
            }
            (Some(ProbeClaim::Open), None) if is_named(call, dialect) && !may_record => {
                Err(format!("`{name}` does not say that {dialect} never faults here"))
            }
            (Some(ProbeClaim::NeverFaults), None) if !is_named(call, dialect) => {
                Err(format!("no document of {dialect} names the function"))
            }
            _ => Ok(()),
        }
    }

    /// Checks the dialects in which no probe asks: those of the file must leave the result open, others not have the function.
    /// A table of systems that state the result in their tests alone need not ask the others.
    fn check_dialects(&self, call: &Call) -> Result<(), String> {
        let asked = |dialect| self.probes.iter().any(|probe| probe.dialects.contains(&dialect));
        if !DOCUMENTED.iter().any(|dialect| self.dialects.contains(dialect)) {
            return Ok(());
        }
        for dialect in DOCUMENTED.into_iter().filter(|&dialect| !asked(dialect)) {
            match call.expected(dialect) {
                Some(_) if !self.dialects.contains(&dialect) => {
                    return Err(format!("{dialect} has the function too"));
                }
                Some(Expected {
                    basis: Some(basis), ..
                }) => {
                    return Err(format!(
                        "nothing is asked in {dialect}, where {basis} says something"
                    ));
                }
                _ => {}
            }
        }
        Ok(())
    }
}

/// Returns whether the ForgeIEC page's table of names has the function: what it names, matiec has, and nothing that it
/// names stops a program.
///
/// Basis: forgeiec-conversion-functions: The naming pattern; matiec conformance ("implements every conversion in the table");
/// Range and precision ("silently truncate or wrap").
fn is_named(call: &Call, dialect: DialectName) -> bool {
    let (from, to) = (call.from(), call.to());
    if dialect != DialectName::MATIEC {
        return false;
    }
    match &*call.signature.function {
        "TRUNC" | "BCD_TO_INT" | "INT_TO_BCD" => true,
        name if name.starts_with("TRUNC_") => page_has_truncation(&call.signature),
        name if name.starts_with("TO_") || call.signature.operation != Operation::Convert => false,
        _ => match (from, to) {
            (ElementaryType::Bool | ElementaryType::Time, _)
            | (_, ElementaryType::Bool | ElementaryType::Time) => true,
            (ElementaryType::String, _) => to.is_number(),
            (_, ElementaryType::String) => from.is_number(),
            (ElementaryType::Dt, ElementaryType::Date) => true,
            _ => false,
        },
    }
}
