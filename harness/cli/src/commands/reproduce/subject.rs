//! The programs that a reproduction may show: a case in each of its dialects, or a file.

use crate::arguments::ReproduceArguments;
use crate::named_case::NamedCase;
use crate::source_file;
use anyhow::{Context, bail};
use std::path::Path;
use stickler_engines::{Ability, Outcome};
use stickler_run::{Fact, expected_facts, shown_by};
use stickler_suite::{Case, Sources};
use stickler_syntax::decoding::decode;

/// A program that is reproduced, from a case or a file.
pub(super) struct ReproducedProgram {
    /// The case; of a file one that expects nothing.
    pub(super) case: Case,
    /// The address of its basis, where that has one.
    address: Option<String>,
    is_file: bool,
}

impl ReproducedProgram {
    /// Returns the programs that the command line names, of which one is shown.
    ///
    /// # Errors
    /// No such case or file; a file without a dialect.
    pub(super) fn all(arguments: &ReproduceArguments) -> anyhow::Result<Vec<ReproducedProgram>> {
        let path = Path::new(&arguments.case);
        if path.extension().is_some_and(|extension| extension == "st") {
            return Ok(vec![ReproducedProgram::file(arguments, path)?]);
        }
        match (arguments.dialect, arguments.case.contains('@')) {
            (Some(dialect), false) => {
                ReproducedProgram::of_case(&format!("{}@{dialect}", arguments.case), arguments)
            }
            (Some(dialect), true) if !arguments.case.ends_with(&format!("@{dialect}")) => {
                bail!(
                    "`{}` names another dialect than --dialect {dialect}",
                    arguments.case
                )
            }
            _ => ReproducedProgram::of_case(&arguments.case, arguments),
        }
    }

    /// Returns a case in each of its dialects, or in the one that its name ends in.
    ///
    /// # Errors
    /// No such case.
    pub(super) fn of_case(name: &str, arguments: &ReproduceArguments) -> anyhow::Result<Vec<Self>> {
        let named = NamedCase::load(name, arguments.cases.as_deref())?;
        let cases = named.cases().into_iter();
        Ok(cases
            .map(|case| ReproducedProgram {
                address: address(&named.suite.sources, &case.basis),
                case: case.without_blank_lines(),
                is_file: false,
            })
            .collect())
    }

    fn file(arguments: &ReproduceArguments, path: &Path) -> anyhow::Result<ReproducedProgram> {
        let (bytes, name) = source_file::read(path)?;
        let dialect = arguments.dialect;
        let dialect = dialect.context("name the dialect of the file with --dialect")?;
        let case = Case {
            observe: arguments.observe.clone().into(),
            scans: arguments.scans,
            ..Case::of_program(&name, dialect, &decode(&bytes).0)
        };
        Ok(ReproducedProgram {
            case,
            address: None,
            is_file: true,
        })
    }

    /// Returns the ability that shows what matters of the program; `outcome` is what the engine does, where it is here. What
    /// becomes of an accepted program shows only when it is executed.
    pub(super) fn ability(&self, outcome: Option<&Outcome>) -> Ability {
        match (shown_by(&self.case), outcome) {
            (Ability::Render, _) => Ability::Render,
            (
                _,
                Some(
                    Outcome::Crashed { .. }
                    | Outcome::Unusable { .. }
                    | Outcome::TimedOut { .. }
                    | Outcome::Faulted { .. },
                ),
            ) => Ability::Execute,
            (usual, _) => usual,
        }
    }

    /// Returns the heading of a page, and what stands below it.
    pub(super) fn heading(&self) -> (String, &str) {
        match self.is_file {
            true => (self.case.id.to_string(), ""),
            false => (self.case.key(), &self.case.title),
        }
    }

    /// Returns the expectation in the words of reports, and where it comes from.
    pub(super) fn expected(&self) -> Option<(String, String)> {
        if self.is_file {
            return None;
        }
        let from = self.address.as_ref().map(|address| format!(", {address}"));
        let basis = format!("{}{}", self.case.basis, from.unwrap_or_default());
        Some((Fact::text(&expected_facts(&self.case)), basis))
    }
}

/// Returns the address of a basis; for a file of the suite its path.
fn address(sources: &Sources, basis: &str) -> Option<String> {
    let (source, section) = sources.of(basis)?;
    Some(source.address_of(section))
}
