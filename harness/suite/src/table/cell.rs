//! One cell of a matrix in one probe: the words that apply to it, the values that it takes, and the results that are expected.
//!
//! Basis: conformance-cases/README.md (a matrix of types).

use std::sync::Arc;

use stickler_exact::{ImplicitResult, implicit_result};
use stickler_types::{DialectName, ElementaryType, MatrixWord, Value};

use crate::assemble::Assembler;
use crate::assembly::{elementary_name, type_name};
use crate::citations::WrittenBasis;
use crate::condition::Testable;
use crate::defined::converted;
use crate::model::MatrixCell;
use crate::table::probe::{Probe, Target};
use crate::table::types::{RowInput, TypeInfo};

/// The placeholders of a matrix, by index.
pub(crate) const PLACEHOLDERS: [&str; 10] = [
    "row", "column", "cell", "types", "value", "typed", "expected", "other", "below", "above",
];
const CELL: usize = 2;
pub(crate) const TYPES: usize = 3;
pub(crate) const VALUE: usize = 4;
pub(crate) const TYPED: usize = 5;
pub(crate) const EXPECTED: usize = 6;
pub(crate) const OTHER: usize = 7;
pub(crate) const BELOW: usize = 8;
pub(crate) const ABOVE: usize = 9;

/// The number of placeholders that conditions may test: the row, the column and the cell.
const TESTABLE: usize = 3;

/// Returns the placeholders of a matrix as conditions may test them.
pub(crate) fn testable(names: &[Box<str>]) -> Testable<'_> {
    Testable {
        names,
        known: TESTABLE,
        unnamed: Some(CELL),
    }
}

/// The texts that replace the placeholders of a matrix.
pub(crate) type CellTexts<'t> = [&'t str; PLACEHOLDERS.len()];

/// One cell of a matrix in one probe.
pub(crate) struct PlacedCell<'a> {
    pub(crate) row: &'a TypeInfo,
    pub(crate) column: &'a TypeInfo,
    pub(crate) word: MatrixWord,
    /// The 1-based line of the case file.
    pub(crate) line: u32,
    /// The part of the id before the value.
    pub(crate) prefix: String,
    pub(crate) place: Arc<MatrixCell>,
    pub(crate) basis: Option<WrittenBasis>,
    /// The dialect whose definition states the word of this cell in place of the matrix, if one does.
    pub(crate) stated_by: Option<DialectName>,
}

/// The properties that the cases of one cell share in one group of dialects.
pub(crate) struct CaseGroup<'a, 't> {
    pub(crate) probe: &'a Probe<'a>,
    pub(crate) cell: &'a PlacedCell<'t>,
    /// The indices of the marks that apply.
    pub(crate) active: &'a [usize],
    pub(crate) dialects: &'a [DialectName],
    /// Whether one of the marks claims that the program is rejected.
    pub(crate) rejected: bool,
}

impl Probe<'_> {
    /// Returns whether the program depends on the value.
    pub(crate) fn takes_values(&self) -> bool {
        [VALUE, TYPED].iter().any(|&slot| self.program.used[slot])
    }
}

/// Returns the only value of a cell that takes one: the ordinary value of the row if it is among the inputs, or else the
/// first input.
pub(crate) fn one_of<'a>(inputs: &'a [RowInput], row: &'a TypeInfo) -> Option<&'a RowInput> {
    let listed = |ordinary: &&RowInput| inputs.iter().any(|input| input.literal == ordinary.literal);
    row.ordinary.as_ref().filter(listed).or(inputs.first())
}

/// Returns the declarations that a row and a column need, on one line if each of them is on one line.
pub(crate) fn declarations(row: &TypeInfo, column: &TypeInfo) -> String {
    let (first, second) = (&*row.declaration, &*column.declaration);
    match (first.is_empty(), second.is_empty() || row.name == column.name) {
        (_, true) => first.to_owned(),
        (true, false) => second.to_owned(),
        (false, false) => format!("{first} {second}"),
    }
}

impl PlacedCell<'_> {
    /// Returns what a value becomes in an elementary type. A pair that converts because a definition states it follows the
    /// conversion function for the pair.
    fn implicit_result(&self, value: &Value, ty: ElementaryType) -> Option<ImplicitResult> {
        let documented = implicit_result(value, ty);
        match (self.stated_by, &documented) {
            (None, _) | (_, Some(ImplicitResult::Exactly(_))) => documented,
            (Some(dialect), _) => Some(converted(value, ty, dialect)),
        }
    }

    /// Returns what an input becomes in a variable of the column's type; `None` where no rule decides.
    pub(crate) fn result_in_column(&self, input: &RowInput) -> Option<ImplicitResult> {
        let value = input.value.as_ref()?;
        match self.column.base {
            Some(ty) => self.implicit_result(value, ty),
            None => (self.row.name == self.column.name).then(|| ImplicitResult::Exactly(value.clone())),
        }
    }
}

impl CaseGroup<'_, '_> {
    /// Adds the expected values of the observed variables to an assembler, or records the variables without asserting a
    /// value.
    ///
    /// # Errors
    /// A message, if a value must be asserted and no rule decides which.
    pub(crate) fn targets(
        &self,
        input: Option<&RowInput>,
        texts: &[&str],
        assembler: &mut Assembler,
    ) -> Result<(), String> {
        if self.rejected || self.probe.program.faults(self.active) {
            return Ok(());
        }
        let open = self.cell.word == MatrixWord::Open;
        if open {
            assembler.observe_acceptance();
        }
        for target in &self.probe.observe {
            match open {
                true => self.record(target, input, texts, assembler),
                false => self.assert(target, input, texts, assembler)?,
            }
        }
        Ok(())
    }

    /// Asserts the value of `target`.
    fn assert(
        &self,
        target: &Target,
        input: Option<&RowInput>,
        texts: &[&str],
        assembler: &mut Assembler,
    ) -> Result<(), String> {
        let cell = self.cell;
        let Some(input) = input.filter(|_| self.probe.takes_values()) else {
            return Err("nothing says what must arrive: the source has no `{value}` or `{typed}`".to_owned());
        };
        let (name, own) = self.name_and_type(target, texts);
        if let Some(below) = self.below(input, own.as_deref()) {
            for (path, value) in below {
                assembler.value(format!("{name}{path}").into(), value.clone(), cell.line);
            }
            return Ok(());
        }
        let result = match &own {
            Some(own) => {
                ElementaryType::declared(own).and_then(|ty| cell.implicit_result(input.value.as_ref()?, ty))
            }
            None => cell.result_in_column(input),
        };
        let column = own.as_deref().unwrap_or(&cell.column.name);
        match result {
            Some(ImplicitResult::Exactly(value)) => assembler.value(name, value, cell.line),
            Some(ImplicitResult::Open) => self.observe(name, own, assembler),
            None => {
                let row = &cell.row.name;
                return Err(format!(
                    "nothing says what arrives in a {column} from a {row}; say it with a mark, and leave out `observe`"
                ));
            }
        }
        Ok(())
    }

    /// Records the value of `target` without asserting it.
    fn record(&self, target: &Target, input: Option<&RowInput>, texts: &[&str], assembler: &mut Assembler) {
        let (name, own) = self.name_and_type(target, texts);
        match input.and_then(|input| self.below(input, own.as_deref())) {
            Some(below) => {
                for (path, value) in below {
                    assembler.observe(format!("{name}{path}").into(), type_name(value));
                }
            }
            None => self.observe(name, own, assembler),
        }
    }

    /// Records a variable, if its type has values that can be observed.
    fn observe(&self, name: Arc<str>, own: Option<Arc<str>>, assembler: &mut Assembler) {
        let column = self.cell.column;
        let is_enumeration = |ordinary: &RowInput| ordinary.value.is_some();
        let ty = match (own, column.base) {
            (Some(own), _) => Some(ElementaryType::declared(&own).map_or(own, elementary_name)),
            (None, Some(ty)) => Some(elementary_name(ty)),
            (None, None) if column.ordinary.as_ref().is_some_and(is_enumeration) => {
                Some(Arc::clone(&column.name))
            }
            (None, None) => None,
        };
        if let Some(ty) = ty {
            assembler.observe(name, ty);
        }
    }

    /// Returns the paths below a variable whose own value cannot be observed (`arrives`), with the values that they must
    /// have.
    fn below<'i>(&self, input: &'i RowInput, own: Option<&str>) -> Option<&'i [(Box<str>, Value)]> {
        let applies =
            own.is_none() && !input.arrives.is_empty() && self.cell.row.name == self.cell.column.name;
        applies.then_some(&input.arrives)
    }

    fn name_and_type(&self, target: &Target, texts: &[&str]) -> (Arc<str>, Option<Arc<str>>) {
        let mut scratch = String::new();
        let name = target.name.fill(&mut scratch, texts);
        (name, target.ty.as_ref().map(|ty| ty.fill(&mut scratch, texts)))
    }
}

/// The word that applies to a cell, and its origin.
#[derive(Clone, Copy)]
pub(super) struct CellWord {
    pub(super) word: MatrixWord,
    /// The dialect whose definition states the word, with the basis; `None` if the word is that of the matrix.
    pub(super) stated: Option<(DialectName, &'static str)>,
}

/// Returns the words that apply to a cell, each with its dialects: that of the matrix, or that of a dialect's definition. A
/// definition overrides only the words about implicit conversion.
pub(super) fn words(
    probe: &Probe<'_>,
    row: &str,
    column: &TypeInfo,
    word: MatrixWord,
    dialects: &[DialectName],
) -> Vec<(CellWord, Vec<DialectName>)> {
    let stated = |dialect: &DialectName| {
        let pair = (
            ElementaryType::from_name(row)?,
            ElementaryType::from_name(&column.name)?,
        );
        // The tables that name a variant say what its documents do.
        let own = dialect.definition().filter(|_| !dialect.is_variant())?;
        let stated = own.implicit(pair.0, pair.1)?;
        let basis = stated.basis.as_deref()?;
        Some(CellWord {
            word: stated.value,
            stated: Some((*dialect, basis)),
        })
    };
    let by_matrix = CellWord { word, stated: None };
    if dialects.iter().all(|dialect| dialect.definition().is_none()) || !probe.is_implicit_conversion() {
        return vec![(by_matrix, dialects.to_vec())];
    }
    let (others, overriding): (Vec<DialectName>, Vec<DialectName>) =
        dialects.iter().partition(|dialect| stated(dialect).is_none());
    let mut words = vec![(by_matrix, others)];
    words.extend(
        overriding
            .iter()
            .filter_map(|dialect| Some((stated(dialect)?, vec![*dialect]))),
    );
    words
}
