//! Expands a matrix into a case for every cell × probe × value × dialect.
//!
//! Basis: conformance-cases/README.md (a matrix of types).

use std::collections::BTreeMap;
use std::sync::Arc;

use stickler_exact::ImplicitResult;
use stickler_types::{DialectName, ElementaryType, MatrixWord, Value};

use crate::assemble::Assembler;
use crate::assembly::Assembly;
use crate::citations::WrittenBasis;
use crate::condition::Testable;
use crate::error::Mistake;
use crate::frame::{DialectGroup, Harvest};
use crate::ident;
use crate::model::MatrixCell;
use crate::table::cell::{
    ABOVE, BELOW, CaseGroup, CellTexts, CellWord, EXPECTED, OTHER, PLACEHOLDERS, PlacedCell, TYPED, TYPES,
    VALUE, declarations, one_of, words,
};
use crate::table::expansion::{CaseMaker, TableExpansion};
use crate::table::inputs::{self, beside};
use crate::table::keys::{KeyReader, MatrixKey};
use crate::table::matrix::{self, Matrix, MatrixRow, Section};
use crate::table::probe::Probe;
use crate::table::probes::{self, ProbePrograms};
use crate::table::types::{self, RowInput, TypeInfo};

/// The text that replaces a placeholder without a value.
const UNKNOWN: &str = "?";

/// Expands the matrices of a file.
pub(crate) fn expand(
    table: &TableExpansion<'_>,
    key: &MatrixKey,
    testable: Testable<'_>,
    harvest: &mut Harvest,
) {
    let declared = types::declared(&table.file.types, table.context, &mut harvest.mistakes);
    let mut probes = probes::read(table.file, table.context, testable, harvest);
    let mut reader = KeyReader::new(table.context, testable);
    let sections = matrix::read(&mut reader, table, key);
    harvest.mistakes.append(&mut reader.mistakes);
    let mut expander = MatrixExpander(CaseMaker::new(table, harvest));
    expander.check_keys(&mut probes);
    let mut counts = vec![0; probes.len()];
    for section in &sections {
        let Some(types) = expander.types(&section.matrix, &declared) else {
            continue;
        };
        for (probe, count) in probes.iter_mut().zip(&mut counts) {
            let before = expander.0.harvest.cases.len();
            if let Err(mistake) = expander.section(section, probe, &types) {
                return expander.0.wrong(mistake);
            }
            *count += expander.0.harvest.cases.len() - before;
        }
    }
    if harvest.mistakes.is_empty() {
        for (probe, count) in probes.iter().zip(counts) {
            probe.remarks(count, &mut harvest.remarks);
        }
    }
}

/// Returns the texts of the placeholders that all cases of a cell share.
fn cell_texts<'t>(
    row: &'t MatrixRow,
    column: &'t TypeInfo,
    word: MatrixWord,
    types: &'t str,
) -> CellTexts<'t> {
    let mut texts = [UNKNOWN; PLACEHOLDERS.len()];
    texts[..=TYPES].copy_from_slice(&[&*row.name, &*column.name, word.as_str(), types]);
    texts
}

/// Returns a number that tells the cells of a matrix apart and depends on their types alone.
fn number(row: &MatrixRow, column: &TypeInfo) -> usize {
    let position = |name: &str| {
        let all = ElementaryType::ALL.iter();
        all.map(|ty| ty.name()).position(|known| known == name)
    };
    let number = |name: &str| position(name).unwrap_or_else(|| name.len() + ElementaryType::ALL.len());
    31 * number(&row.name) + number(&column.name)
}

struct MatrixExpander<'a, 'h>(CaseMaker<'a, 'h>);

impl MatrixExpander<'_, '_> {
    /// Reports the keys that have no meaning in a matrix.
    fn check_keys(&mut self, probes: &mut [ProbePrograms<'_>]) {
        let CaseMaker { table, .. } = self.0;
        if let Some(expect) = &table.file.expect {
            let message = "`expect` belongs to a table of rows; a matrix says it by its words";
            self.0
                .wrong(table.context.lines.mistake(expect, "expect", message));
        }
        for ProbePrograms { probe, .. } in probes {
            if probe.key.expect.is_some() {
                let message = "`expect` belongs to a table of rows";
                self.0
                    .wrong(Mistake::new(probe.line, message).key("probe.expect"));
            }
            if probe
                .basis
                .as_ref()
                .is_some_and(|basis| basis.template.slots().any(|slot| slot >= TYPES))
            {
                let message = "a basis may use {row}, {column} and {cell} only";
                self.0.wrong(Mistake::new(probe.line, message).key("probe.basis"));
                probe.basis = None;
            }
        }
    }

    /// Returns the types of all rows and columns by name; `None` if one of them is unknown.
    fn types(
        &mut self,
        matrix: &Matrix,
        declared: &BTreeMap<Box<str>, TypeInfo>,
    ) -> Option<BTreeMap<Arc<str>, TypeInfo>> {
        let mut types = BTreeMap::new();
        let columns = matrix.columns.iter().map(|name| (matrix.line, name));
        let rows = matrix.rows.iter().map(|row| (row.line, &row.name));
        for (line, name) in columns.chain(rows) {
            if types.contains_key(name) {
                continue;
            }
            match TypeInfo::find(name, declared) {
                Ok(info) => {
                    types.insert(Arc::clone(name), info);
                }
                Err(message) => {
                    self.0.wrong(Mistake::new(line, message).key("matrix"));
                    return None;
                }
            }
        }
        Some(types)
    }

    /// Expands one matrix in one probe.
    ///
    /// # Errors
    /// A mistake that makes it pointless to go on.
    fn section(
        &mut self,
        section: &Section<'_>,
        probe: &mut ProbePrograms<'_>,
        types: &BTreeMap<Arc<str>, TypeInfo>,
    ) -> Result<(), Mistake> {
        let dialects = probe.probe.narrowed(&section.dialects);
        let columns: Vec<&TypeInfo> = section
            .matrix
            .columns
            .iter()
            .filter_map(|name| types.get(name))
            .collect();
        for row in &section.matrix.rows {
            let Some(row_type) = types.get(&row.name) else {
                continue;
            };
            let inputs = inputs::of_row(
                &probe.probe,
                row_type,
                row.line,
                self.0.table.context,
                &mut self.0.harvest.mistakes,
            );
            for (column, word) in columns.iter().zip(&row.words) {
                self.0.visit(row.line)?;
                if let Some(word) = word {
                    for (said, dialects) in words(&probe.probe, &row.name, column, *word, &dialects) {
                        let texts = cell_texts(row, column, said.word, "");
                        if !probe.probe.only.holds(&texts) {
                            continue;
                        }
                        let (context, place) = (self.0.table.context, (row, row_type));
                        let number = number(row, column);
                        for (index, dialects) in probe.chosen(context.places, number, dialects, &texts) {
                            if let Some(probe) = probe.at(index, context, self.0.harvest) {
                                self.cell(section, probe, place, (column, said), &inputs, &dialects)?;
                            }
                        }
                    }
                }
            }
        }
        Ok(())
    }

    fn cell(
        &mut self,
        section: &Section<'_>,
        probe: &mut Probe<'_>,
        (row, row_type): (&MatrixRow, &TypeInfo),
        (column, CellWord { word, stated }): (&TypeInfo, CellWord),
        inputs: &[RowInput],
        dialects: &[DialectName],
    ) -> Result<(), Mistake> {
        let types = declarations(row_type, column);
        let texts = cell_texts(row, column, word, &types);
        let cell = PlacedCell {
            row: row_type,
            column,
            word,
            line: row.line,
            prefix: self.prefix(section, probe, &row.name, &column.name),
            place: Arc::new(MatrixCell {
                probe: Arc::clone(&probe.name),
                row: Arc::clone(&row.name),
                column: Arc::clone(&column.name),
                word,
            }),
            basis: match stated {
                Some((_, basis)) => Some(WrittenBasis {
                    text: basis.into(),
                    line: row.line,
                }),
                None => self.0.basis(probe, section.basis.as_ref(), &texts),
            },
            stated_by: stated.map(|(dialect, _)| dialect),
        };
        for (active, members) in probe.program.groups(dialects, &texts) {
            probe.note_applied(&active);
            let rejected = probe.program.rejects(&active);
            let missing = match word {
                MatrixWord::No if !rejected => Some("error"),
                MatrixWord::Warn if stated.is_none() && !probe.program.warns(&active) => Some("warning"),
                _ => None,
            };
            if let Some(mark) = missing {
                let (row_name, column_name, says) = (&row.name, &column.name, word.as_str());
                let message =
                    format!("{row_name} to {column_name} says {says}, but no `{mark}` mark applies");
                let hint = format!(
                    "in the probe `{}`, add `(*! {mark} CODE if {says} *)`",
                    probe.name
                );
                self.0.wrong(Mistake::new(row.line, message).hint(hint));
                continue;
            }
            let case = CaseGroup {
                probe,
                cell: &cell,
                active: &active,
                dialects: &members,
                rejected,
            };
            if probe.takes_values() && !rejected {
                for input in inputs {
                    self.case(section, &case, Some(input), &texts)?;
                }
            } else {
                self.case(section, &case, one_of(inputs, row_type), &texts)?;
            }
        }
        Ok(())
    }

    fn prefix(&self, section: &Section<'_>, probe: &Probe<'_>, row: &str, column: &str) -> String {
        let mut id = String::with_capacity(96);
        id.push_str(&self.0.table.context.id);
        id.push_str("::");
        if let Some(name) = section.name {
            id.push_str(name);
            id.push('.');
        }
        id.push_str(&probe.name);
        id.push('(');
        ident::push_cell(&mut id, row);
        id.push(',');
        ident::push_cell(&mut id, column);
        id
    }

    /// Makes the cases of one value in the dialects of one group.
    ///
    /// # Errors
    /// A mistake that makes it pointless to go on.
    fn case(
        &mut self,
        section: &Section<'_>,
        of: &CaseGroup<'_, '_>,
        input: Option<&RowInput>,
        texts: &CellTexts<'_>,
    ) -> Result<(), Mistake> {
        let CaseGroup { probe, cell, .. } = of;
        let (program, column) = (&probe.program, cell.column);
        let result = input
            .filter(|_| !of.rejected)
            .and_then(|input| cell.result_in_column(input));
        let expected = match &result {
            Some(ImplicitResult::Exactly(value)) => Some(value),
            _ => None,
        };
        let expected_text = expected.filter(|_| program.uses(EXPECTED)).map(Value::to_string);
        let other = if program.uses(OTHER) {
            Some(column.other(expected))
        } else {
            None
        };
        if let Some(None) = other {
            let message = format!(
                "{} has no other value for the probe `{}`",
                column.name, probe.name
            );
            self.0.wrong(
                Mistake::new(cell.line, message).hint(format!("give [types.{}] `values`", column.name)),
            );
            return Ok(());
        }
        let other = other.flatten();
        let mut texts: CellTexts<'_> = *texts;
        texts[VALUE] = input.map_or(UNKNOWN, |input| &input.literal);
        texts[TYPED] = input.map_or(UNKNOWN, |input| &input.typed);
        texts[EXPECTED] = expected_text.as_deref().unwrap_or(UNKNOWN);
        texts[OTHER] = other.as_deref().unwrap_or(UNKNOWN);
        let value = input.and_then(|input| input.value.as_ref());
        let beside = value
            .filter(|_| program.uses(BELOW) || program.uses(ABOVE))
            .map(beside);
        if let Some([below, above]) = &beside {
            (texts[BELOW], texts[ABOVE]) = (below, above);
        }
        let assembly = match self.assemble(of, input, &texts) {
            Ok(assembly) => assembly,
            Err(mistake) => {
                self.0.wrong(mistake);
                return Ok(());
            }
        };
        let value_in_id = probe.takes_values() && !of.rejected;
        let title = match cell.stated_by {
            Some(dialect) => {
                let (row, column, word) = (&cell.row.name, &column.name, cell.word.as_str());
                format!("{row} to {column} is `{word}` in {dialect}").into()
            }
            None => self.0.title(probe, section.title.as_ref(), &texts),
        };
        let group = DialectGroup {
            id: self.id(of, value_in_id.then_some(texts[VALUE])),
            line: cell.line,
            title,
            basis: cell.basis.clone(),
            assembly,
            cell: Some(&cell.place),
            ..DialectGroup::default()
        };
        self.0.add(probe, &texts, group, of.dialects)
    }

    fn assemble(
        &mut self,
        of: &CaseGroup<'_, '_>,
        input: Option<&RowInput>,
        texts: &[&str],
    ) -> Result<Assembly, Mistake> {
        let CaseGroup {
            probe, cell, active, ..
        } = of;
        let targets = |assembler: &mut Assembler| {
            let targets = of.targets(input, texts, assembler);
            targets.map_err(|message| Mistake::new(probe.line, message).key("probe.observe"))
        };
        let hint = || format!("in the cell {} to {}", cell.row.name, cell.column.name);
        let assembly = self
            .0
            .assembly(probe, active, (texts, cell.line), targets, hint)?;
        if assembly.claims_nothing() {
            let word = cell.word.as_str();
            let message = format!(
                "in `{word}` cells the probe `{}` {}",
                probe.name,
                Assembly::NOTHING
            );
            let remark = Mistake::new(probe.line, message).key("probe");
            self.0.harvest.remark(remark.hint(Assembly::SAY_OK));
        }
        Ok(assembly)
    }

    fn id(&mut self, of: &CaseGroup<'_, '_>, value: Option<&str>) -> Arc<str> {
        self.0.scratch.clear();
        self.0.scratch.push_str(&of.cell.prefix);
        if let Some(value) = value {
            self.0.scratch.push(',');
            ident::push_cell(&mut self.0.scratch, value);
        }
        if let Some(placement) = &of.probe.placement {
            for name in placement.names() {
                self.0.scratch.push(',');
                self.0.scratch.push_str(name);
            }
        }
        self.0.scratch.push(')');
        Arc::from(self.0.scratch.as_str())
    }
}
