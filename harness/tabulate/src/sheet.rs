//! A sheet: a table whose rows are calls of conversion functions. It asks the exact arithmetic for the values, and refuses to
//! assert what no document says, or to leave open what one does.

use crate::call::Call;
use crate::column::Column;
use crate::table::{Probe, Table};
use stickler_types::DialectName;

/// What a probe says of the result of the call.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Claim {
    /// It has the value of the column `expected`.
    Value,
    /// No document says what it is; it is recorded.
    Open,
    /// The program is accepted and runs to its end; what the call gives is not said.
    Accepted,
    /// The same, and what it gives is recorded.
    NeverFaults,
}

/// A probe of a sheet.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct CallProbe {
    /// Its name, which stands in ids.
    pub name: &'static str,
    /// What it says.
    pub claim: Claim,
    /// The dialects and groups in which it says so; empty where they are those of the sheet.
    pub dialects: Vec<&'static str>,
    /// The document that says so; empty where it is that of the sheet.
    pub basis: &'static str,
    /// Whether it may record what a document says; see [`CallProbe::also_where_said`].
    pub also_where_said: bool,
    /// The program, with the columns as placeholders.
    pub source: &'static str,
}

impl CallProbe {
    /// A probe that asserts the value.
    #[must_use]
    pub fn value(name: &'static str, dialects: &[&'static str], source: &'static str) -> CallProbe {
        CallProbe {
            name,
            claim: Claim::Value,
            dialects: dialects.to_vec(),
            basis: "",
            also_where_said: false,
            source,
        }
    }

    /// The probes of a table whose values the documents of the dialects `said` say: `variable` and `constant`, and `recorded` in
    /// the dialects `silent`, if there are any.
    #[must_use]
    pub fn variable_and_constant(
        said: &[&'static str],
        silent: &[&'static str],
        variable: &'static str,
        constant: &'static str,
    ) -> Vec<CallProbe> {
        let mut probes = vec![
            CallProbe::value("variable", said, variable),
            CallProbe::value("constant", said, constant),
        ];
        if !silent.is_empty() {
            probes.push(CallProbe::recorded(silent, variable));
        }
        probes
    }

    /// The probe `recorded`, which asserts nothing.
    #[must_use]
    pub fn recorded(dialects: &[&'static str], source: &'static str) -> CallProbe {
        CallProbe {
            name: "recorded",
            claim: Claim::Open,
            dialects: dialects.to_vec(),
            basis: "",
            also_where_said: false,
            source,
        }
    }

    /// The probe `never-faults`: the program is accepted and ends, and the value is recorded. Takes the program that
    /// [`CallProbe::recorded`] has; its call is marked.
    #[must_use]
    pub fn never_faults(dialects: &[&'static str], source: &'static str) -> CallProbe {
        CallProbe {
            name: "never-faults",
            claim: Claim::NeverFaults,
            dialects: dialects.to_vec(),
            basis: "",
            also_where_said: false,
            source,
        }
    }

    /// The same probe, but it records the value also in rows of which a document says what it is. For a table that is older
    /// than that knowledge: its ids keep their meaning, and another table asserts the value.
    #[must_use]
    pub fn also_where_said(self) -> CallProbe {
        CallProbe {
            also_where_said: true,
            ..self
        }
    }

    /// The same probe with a basis of its own.
    #[must_use]
    pub fn by(self, basis: &'static str) -> CallProbe {
        CallProbe { basis, ..self }
    }
}

/// A table whose rows are calls of conversion functions.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// The file's name without its extension.
    pub name: &'static str,
    /// The claim, in one line.
    pub title: &'static str,
    /// Where the claim comes from.
    pub basis: &'static str,
    /// The dialects and groups that the header names.
    pub dialects: Vec<&'static str>,
    /// A paragraph for a person; empty where there is none.
    pub summary: String,
    /// The columns.
    pub columns: &'static [Column],
    /// The calls, one a row.
    pub calls: Vec<Call>,
    /// The probes.
    pub probes: Vec<CallProbe>,
}

impl Sheet {
    /// The table.
    ///
    /// # Errors
    /// A sentence that names the call and the dialect, where a probe claims something else than the exact arithmetic has a
    /// basis for: asserts what is open, leaves open what a document says, or asserts two different values in one row.
    pub fn table(&self) -> Result<Table, String> {
        let mut rows = Vec::with_capacity(self.calls.len());
        for call in &self.calls {
            let expected = self
                .expected(call)
                .map_err(|what| format!("{}: {call}: {what}", self.name))?;
            let cells = self.columns.iter().map(|column| column.cell(call, &expected));
            rows.push(cells.collect());
        }
        Ok(Table {
            name: self.name.to_owned(),
            title: self.title.to_owned(),
            basis: self.basis.to_owned(),
            dialects: owned(&self.dialects),
            summary: self.summary.clone(),
            columns: self
                .columns
                .iter()
                .map(|column| column.name().to_owned())
                .collect(),
            rows,
            probes: self.probes.iter().map(CallProbe::written).collect(),
        })
    }

    /// The typed literal that all asserting probes agree on; empty where none asserts.
    fn expected(&self, call: &Call) -> Result<String, String> {
        let mut agreed: Option<String> = None;
        for probe in &self.probes {
            let mut is_named = false;
            for dialect in resolve(probe.dialects_in(self))? {
                let Some(said) = call.expected(dialect) else {
                    return Err(format!("{dialect} has no such function"));
                };
                match (probe.claim, said.basis) {
                    (Claim::Value, None) => {
                        return Err(format!("`{}` asserts what is open in {dialect}", probe.name));
                    }
                    (Claim::Open | Claim::NeverFaults, Some(basis)) if !probe.also_where_said => {
                        return Err(format!(
                            "`{}` leaves open in {dialect} what {basis} says",
                            probe.name
                        ));
                    }
                    (Claim::Value, Some(basis)) => {
                        is_named |= basis == probe.basis_in(self);
                        let value = said.value.to_string();
                        if agreed.get_or_insert_with(|| value.clone()) != &value {
                            return Err(format!("another value in {dialect}"));
                        }
                    }
                    (Claim::Open | Claim::Accepted | Claim::NeverFaults, _) => {}
                }
            }
            if probe.claim == Claim::Value && !is_named {
                return Err(format!(
                    "`{}` does not name the document that says so",
                    probe.name
                ));
            }
        }
        Ok(agreed.unwrap_or_default())
    }
}

impl CallProbe {
    fn basis_in(&self, sheet: &Sheet) -> &'static str {
        if self.basis.is_empty() {
            sheet.basis
        } else {
            self.basis
        }
    }

    /// The dialects and groups that it asks in.
    pub(crate) fn dialects_in<'a>(&'a self, sheet: &'a Sheet) -> &'a [&'static str] {
        if self.dialects.is_empty() {
            &sheet.dialects
        } else {
            &self.dialects
        }
    }

    fn written(&self) -> Probe {
        let (observe, expect) = match self.claim {
            Claim::Value => ("into", "{expected}"),
            Claim::Open => ("into : {to}", "open"),
            Claim::Accepted => ("into", "accepted"),
            Claim::NeverFaults => ("into : {to}", ""),
        };
        let source = if self.claim == Claim::NeverFaults {
            self.source.replacen(");\n", ");   (*! ok *)\n", 1)
        } else {
            self.source.to_owned()
        };
        Probe {
            name: self.name.to_owned(),
            basis: self.basis.to_owned(),
            observe: observe.to_owned(),
            expect: expect.to_owned(),
            dialects: owned(&self.dialects),
            source,
            ..Probe::default()
        }
    }
}

/// The words as a table keeps them.
#[must_use]
pub fn owned(words: &[&str]) -> Vec<String> {
    words.iter().map(|&word| word.to_owned()).collect()
}

/// The dialects that names of dialects and groups stand for, as `dialects.toml` of the suite has them.
///
/// # Errors
/// A sentence, where a name is neither.
pub fn resolve(names: &[&str]) -> Result<Vec<DialectName>, String> {
    let mut dialects = Vec::new();
    for &name in names {
        match name {
            "all" => dialects.extend(DialectName::ALL),
            "ironplc" => dialects.extend([
                DialectName::IronplcEd2,
                DialectName::IronplcEd3,
                DialectName::IronplcRusty,
            ]),
            _ => dialects.push(
                name.parse()
                    .map_err(|error| format!("neither a dialect nor a group: {error}"))?,
            ),
        }
    }
    Ok(dialects)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::operand::Operand;
    use stickler_types::ElementaryType::{Dint, Int};

    fn sheet(probes: Vec<CallProbe>) -> Sheet {
        Sheet {
            name: "example",
            title: "An example",
            basis: "forgeiec-conversion-functions: Range and precision",
            dialects: vec!["all"],
            summary: String::new(),
            columns: &[Column::From, Column::To, Column::Input, Column::Expected],
            calls: vec![Call::convert(Dint, Int, Operand::number(Dint, 100_000))],
            probes,
        }
    }

    #[test]
    fn the_expected_value_is_that_of_the_exact_arithmetic() {
        let table = sheet(vec![CallProbe::value("variable", &["matiec"], "")])
            .table()
            .unwrap();
        assert_eq!(table.rows, [["DINT", "INT", "100000", "INT#-31072"]]);
    }

    #[test]
    fn a_sheet_neither_asserts_what_is_open_nor_leaves_open_what_is_said() {
        for (probe, said) in [
            (
                CallProbe::value("p", &["plcnext"], ""),
                "asserts what is open in plcnext",
            ),
            (CallProbe::recorded(&["matiec"], ""), "leaves open in matiec"),
            (
                CallProbe::value("p", &["ironplc-ed2"], ""),
                "does not name the document",
            ),
            (
                CallProbe::recorded(&["codesys"], ""),
                "neither a dialect nor a group",
            ),
        ] {
            let error = sheet(vec![probe]).table().unwrap_err();
            assert!(error.contains(said), "{error}");
        }
    }
}
