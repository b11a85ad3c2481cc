//! A matrix becomes a case for every cell × probe × value × dialect.
//!
//! Basis: stickler-design §3.2.

use std::collections::BTreeMap;
use std::sync::Arc;

use stickler_types::{DialectName, ElementaryType, Value};
use toml::Spanned;

use crate::arrival::{Arrival, arrives};
use crate::assemble::{Assembler, Assembly};
use crate::error::Mistake;
use crate::frame::{Group, Harvest};
use crate::ident;
use crate::model::{MatrixCell, Word};
use crate::place::TextPlace;
use crate::program::Remarks;
use crate::table::budget::Budget;
use crate::table::keys::{MatrixKey, MatrixTable};
use crate::table::matrix::{Matrix, MatrixRow};
use crate::table::probe::{self, Placeholders, Probe};
use crate::table::read::{MOST_MISTAKES, Table};
use crate::table::types::{self, Input, TypeInfo};
use crate::template::Template;
use crate::toml_text::TextOr;

/// The placeholders of a matrix, by index.
pub(crate) const PLACEHOLDERS: [&str; 8] = [
    "row", "column", "cell", "types", "value", "typed", "expected", "other",
];
const TYPES: usize = 3;
const VALUE: usize = 4;
const TYPED: usize = 5;
const EXPECTED: usize = 6;
const OTHER: usize = 7;

/// Conditions may test the row, the column and the cell.
const TESTABLE: usize = 3;
const CELL: usize = 2;

/// What a placeholder stands for where there is nothing to say.
const UNKNOWN: &str = "?";

/// One matrix of the file with what is special to it.
struct Section<'a> {
    key: Option<&'a MatrixTable>,
    matrix: Matrix,
    dialects: Vec<DialectName>,
    title: Option<Template>,
    basis: Option<Template>,
}

/// One cell in one probe.
struct Cell<'a> {
    row: &'a TypeInfo,
    column: &'a TypeInfo,
    word: Word,
    line: u32,
    /// The id up to the value.
    prefix: String,
    place: Arc<MatrixCell>,
    basis: Arc<str>,
}

/// Expands the matrices of a file.
pub(crate) fn expand(
    table: &Table<'_>,
    key: &MatrixKey,
    names: &[Box<str>],
    harvest: &mut Harvest,
    remarks: &mut Remarks,
) {
    let placeholders = Placeholders {
        names,
        known: TESTABLE,
        unnamed: Some(CELL),
    };
    let declared = types::declared(&table.file.types, table.context, &mut harvest.mistakes);
    let mut probes = probe::read(
        table.file,
        table.context,
        placeholders,
        &mut harvest.mistakes,
        remarks,
    );
    let sections = sections(table, key, names, &mut harvest.mistakes);
    let mut expander = Expander {
        table,
        harvest,
        budget: Budget::default(),
        scratch: String::new(),
    };
    expander.check_keys(&probes);
    let mut counts = vec![0; probes.len()];
    for section in &sections {
        let Some(types) = expander.types(&section.matrix, &declared) else {
            continue;
        };
        for (probe, count) in probes.iter_mut().zip(&mut counts) {
            let before = expander.harvest.cases.len() + expander.harvest.withdrawn.len();
            if let Err(mistake) = expander.section(section, probe, &types) {
                expander.harvest.mistakes.push(mistake);
                return;
            }
            *count += expander.harvest.cases.len() + expander.harvest.withdrawn.len() - before;
        }
    }
    if harvest.mistakes.is_empty() {
        for (probe, count) in probes.iter().zip(counts) {
            probe.remarks(count, &mut harvest.remarks);
        }
    }
}

/// Reads the matrices; those with mistakes are left out.
fn sections<'a>(
    table: &Table<'_>,
    key: &'a MatrixKey,
    names: &[Box<str>],
    mistakes: &mut Vec<Mistake>,
) -> Vec<Section<'a>> {
    let texts: Vec<(Option<&MatrixTable>, &Spanned<String>)> = match key {
        MatrixKey::One(text) => vec![(None, text)],
        MatrixKey::Several(tables) => tables.iter().map(|table| (Some(table), &table.table)).collect(),
    };
    let mut sections = Vec::new();
    for (key, text) in texts {
        let context = table.context;
        let start = text.span().start;
        let line = context.lines.line(start);
        let place = TextPlace::of_toml_string(context.text, &context.lines, start);
        let own = key.and_then(|key| key.dialects.as_ref());
        let own = own.map(|names| context.resolve(names, "matrix.dialects", mistakes));
        let dialects = match (&table.dialects, own) {
            (Some(all), Some(own)) => own.into_iter().filter(|dialect| all.contains(dialect)).collect(),
            (Some(all), None) => all.clone(),
            (None, Some(own)) => own,
            (None, None) => {
                mistakes.push(Mistake::new(
                    line,
                    "the file has no dialects, and the matrix has none either",
                ));
                continue;
            }
        };
        if dialects.is_empty() {
            mistakes.push(
                Mistake::new(line, "none of the matrix's dialects is one of the file's").key("dialects"),
            );
        }
        if let Some(name) = key.and_then(|key| key.name.as_ref())
            && let Err(message) = ident::check(name.get_ref())
        {
            mistakes.push(Mistake::new(context.lines.line(name.span().start), message).key("matrix.name"));
        }
        let mut template = |text: &str, key: &str| {
            let template = Template::parse(text, names);
            template
                .map_err(|mistake| mistakes.push(Mistake::new(line, mistake.message).key(key)))
                .ok()
        };
        let title = key
            .and_then(|key| key.title.as_ref())
            .and_then(|title| template(title, "matrix.title"));
        let basis = key
            .and_then(|key| key.basis.as_ref())
            .and_then(|basis| template(basis.get_ref(), "matrix.basis"));
        match Matrix::read(text.get_ref(), place) {
            Ok(matrix) => sections.push(Section {
                key,
                matrix,
                dialects,
                title,
                basis,
            }),
            Err(more) => mistakes.extend(more),
        }
    }
    sections
}

struct Expander<'a, 'h> {
    table: &'a Table<'a>,
    harvest: &'h mut Harvest,
    budget: Budget,
    scratch: String,
}

impl Expander<'_, '_> {
    /// Keys that a matrix has no use for.
    fn check_keys(&mut self, probes: &[Probe<'_>]) {
        let file = self.table.file;
        if let Some(expect) = &file.expect {
            let line = self.table.context.lines.line(expect.span().start);
            self.wrong(Mistake::new(
                line,
                "`expect` belongs to a table of rows; a matrix says it by its words",
            ));
        }
        for probe in probes {
            if probe.key.expect.is_some() {
                self.wrong(
                    Mistake::new(probe.line, "`expect` belongs to a table of rows").key("probe.expect"),
                );
            }
            let late = |template: &Option<Template>| {
                template
                    .as_ref()
                    .is_some_and(|template| template.slots().any(|slot| slot >= TYPES))
            };
            if late(&probe.basis) {
                let message = "a basis may use {row}, {column} and {cell} only";
                self.wrong(Mistake::new(probe.line, message).key("probe.basis"));
            }
        }
    }

    /// The types of all rows and columns by name; nothing where one is unknown.
    fn types(
        &mut self,
        matrix: &Matrix,
        declared: &BTreeMap<Box<str>, TypeInfo>,
    ) -> Option<BTreeMap<Arc<str>, TypeInfo>> {
        let mut types = BTreeMap::new();
        let first = matrix.rows.first().map_or(1, |row| row.line.saturating_sub(1));
        let rows = matrix.rows.iter().map(|row| (row.line, &row.name));
        for (line, name) in matrix.columns.iter().map(|name| (first, name)).chain(rows) {
            if types.contains_key(name) {
                continue;
            }
            match TypeInfo::find(name, declared) {
                Ok(info) => {
                    types.insert(Arc::clone(name), info);
                }
                Err(message) => {
                    self.wrong(Mistake::new(line, message).key("matrix"));
                    return None;
                }
            }
        }
        Some(types)
    }

    /// Expands one matrix in one probe.
    fn section(
        &mut self,
        section: &Section<'_>,
        probe: &mut Probe<'_>,
        types: &BTreeMap<Arc<str>, TypeInfo>,
    ) -> Result<(), Mistake> {
        let dialects = probe.narrowed(&section.dialects);
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
            let inputs = self.inputs(probe, row_type, row.line);
            for (column, word) in columns.iter().zip(&row.words) {
                self.budget
                    .look()
                    .map_err(|message| Mistake::new(row.line, message))?;
                if let Some(word) = word {
                    self.cell(
                        section,
                        probe,
                        (row, row_type),
                        (column, *word),
                        &inputs,
                        &dialects,
                    )?;
                }
                if self.harvest.mistakes.len() > MOST_MISTAKES {
                    return Err(Mistake::new(
                        row.line,
                        "further mistakes in this table are left out",
                    ));
                }
            }
        }
        Ok(())
    }

    /// The values that a row takes in a probe: at least one, if only a placeholder for none.
    fn inputs(&mut self, probe: &Probe<'_>, row: &TypeInfo, line: u32) -> Vec<Input> {
        let ordinary = || row.ordinary.iter().cloned().collect::<Vec<_>>();
        let inputs = match &probe.key.values {
            None if takes_values(probe) => row.boundaries.clone(),
            None => ordinary(),
            Some(values) => match values.get_ref() {
                TextOr::Text(word) if word == "boundaries" => row.boundaries.clone(),
                TextOr::Text(word) if word == "one" => ordinary(),
                TextOr::Text(word) => {
                    let message =
                        format!("`{word}` is no set of values; there are boundaries and one, and lists");
                    let line = self.table.context.lines.line(values.span().start);
                    self.wrong(Mistake::new(line, message).key("probe.values"));
                    Vec::new()
                }
                TextOr::List(list) => {
                    let mut inputs = Vec::new();
                    for item in list {
                        let written = self.table.context.text.get(item.span()).unwrap_or_default();
                        let literal = item.get_ref().spelling(written);
                        match row.input(&literal) {
                            Some(input) => inputs.push(input),
                            None => {
                                let message = format!("`{literal}` is no literal of {}", row.name);
                                let line = self.table.context.lines.line(item.span().start);
                                self.wrong(Mistake::new(line, message).key("probe.values"));
                            }
                        }
                    }
                    inputs
                }
            },
        };
        if inputs.is_empty() && takes_values(probe) {
            let message = format!("{} has no values for the probe `{}`", row.name, probe.name);
            self.wrong(Mistake::new(line, message).hint(format!("give [types.{}] `values`", row.name)));
        }
        inputs
    }

    fn cell(
        &mut self,
        section: &Section<'_>,
        probe: &mut Probe<'_>,
        (row, row_type): (&MatrixRow, &TypeInfo),
        (column, word): (&TypeInfo, Word),
        inputs: &[Input],
        dialects: &[DialectName],
    ) -> Result<(), Mistake> {
        let types = declarations(row_type, column);
        let mut texts = [
            &*row.name,
            &*column.name,
            word.as_str(),
            &types,
            UNKNOWN,
            UNKNOWN,
            UNKNOWN,
            UNKNOWN,
        ];
        if !probe.only.holds(&texts[..TESTABLE]) {
            return Ok(());
        }
        let cell = Cell {
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
            basis: self.basis(section, probe, &texts, row.line),
        };
        for (active, members) in probe.program.groups(dialects, &texts) {
            probe.note_applied(&active);
            let rejected = probe.program.rejects(&active);
            if word == Word::No && !rejected {
                let message = format!(
                    "{} to {} says no, but no `error` mark applies",
                    row.name, column.name
                );
                let hint = format!("in the probe `{}`, add `(*! error CODE if no *)`", probe.name);
                self.wrong(Mistake::new(row.line, message).hint(hint));
                continue;
            }
            let case = CaseOf {
                section,
                probe,
                cell: &cell,
                active: &active,
                members: &members,
                rejected,
            };
            if takes_values(probe) && !rejected {
                for input in inputs {
                    self.case(&case, Some(input), true, &mut texts)?;
                }
            } else {
                self.case(&case, one_of(inputs, row_type), false, &mut texts)?;
            }
        }
        Ok(())
    }

    fn prefix(&self, section: &Section<'_>, probe: &Probe<'_>, row: &str, column: &str) -> String {
        let mut id = String::with_capacity(96);
        id.push_str(&self.table.context.id);
        id.push_str("::");
        if let Some(name) = section.key.and_then(|key| key.name.as_ref()) {
            id.push_str(name.get_ref());
            id.push('.');
        }
        id.push_str(&probe.name);
        id.push('(');
        ident::push_cell(&mut id, row);
        id.push(',');
        ident::push_cell(&mut id, column);
        id
    }

    fn basis(&mut self, section: &Section<'_>, probe: &Probe<'_>, texts: &[&str], line: u32) -> Arc<str> {
        let template = probe
            .basis
            .as_ref()
            .or(section.basis.as_ref())
            .unwrap_or(&self.table.basis);
        let basis = template.fill(&mut self.scratch, texts);
        self.table.check_basis(&basis, line, self.harvest);
        basis
    }

    /// Makes the cases of one value in the dialects of one group.
    fn case<'t>(
        &mut self,
        of: &CaseOf<'_, 't>,
        input: Option<&'t Input>,
        value_in_id: bool,
        texts: &mut [&'t str; PLACEHOLDERS.len()],
    ) -> Result<(), Mistake> {
        let CaseOf {
            section, probe, cell, ..
        } = of;
        let arrival = input
            .filter(|_| !of.rejected)
            .map(|input| what_arrives(input, cell.row, cell.column));
        let expected = match &arrival {
            Some(Some(Arrival::Exactly(value))) => Some(value),
            _ => None,
        };
        let expected_text = expected
            .filter(|_| probe.program.uses(EXPECTED))
            .map(Value::to_string);
        let other = if probe.program.uses(OTHER) {
            cell.column.other(expected)
        } else {
            None
        };
        let mut texts = *texts;
        texts[VALUE] = input.map_or(UNKNOWN, |input| &input.literal);
        texts[TYPED] = input.map_or(UNKNOWN, |input| &input.typed);
        texts[EXPECTED] = expected_text.as_deref().unwrap_or(UNKNOWN);
        texts[OTHER] = other.as_deref().unwrap_or(UNKNOWN);
        if probe.program.uses(OTHER) && other.is_none() {
            let message = format!(
                "{} has no other value for the probe `{}`",
                cell.column.name, probe.name
            );
            self.wrong(
                Mistake::new(cell.line, message).hint(format!("give [types.{}] `values`", cell.column.name)),
            );
            return Ok(());
        }
        let mut assembler = Assembler::new(self.table.context.type_names);
        let applied = probe.program.apply(of.active, &texts, &mut assembler);
        if !of.rejected
            && !probe.program.faults(of.active)
            && let Some(input) = input
            && let Err(message) = self.targets(of, input, &texts, &mut assembler)
        {
            self.wrong(Mistake::new(probe.line, message).key("probe.observe"));
            return Ok(());
        }
        let assembly = match applied.and_then(|()| assembler.finish(probe.frame.scans)) {
            Ok(assembly) => assembly,
            Err(mistake) => {
                let line = probe.program.place.line(mistake.line.max(1));
                let hint = format!("in the cell {} to {}", cell.row.name, cell.column.name);
                self.wrong(Mistake::new(line, mistake.message).key("probe.source").hint(hint));
                return Ok(());
            }
        };
        if assembly.claims_nothing() {
            self.note_claims_nothing(probe, cell);
        }
        if let Some(slot) = probe.program.breaks_a_mark(&texts) {
            let message = format!(
                "`{{{}}}` has `(*` or `*)` in it and stands in a mark",
                PLACEHOLDERS[slot]
            );
            self.wrong(Mistake::new(cell.line, message).hint("write `($2A` and `*$29`"));
            return Ok(());
        }
        let id = self.id(cell, value_in_id.then_some(texts[VALUE]));
        let source = probe.program.fill(&mut self.scratch, &texts);
        self.budget
            .program(source.len())
            .map_err(|message| Mistake::new(cell.line, message))?;
        let title = probe
            .title
            .as_ref()
            .or(section.title.as_ref())
            .unwrap_or(&self.table.title);
        let group = Group {
            id,
            title: title.fill(&mut self.scratch, &texts),
            basis: Arc::clone(&cell.basis),
            line: cell.line,
            source,
            assembly,
            cell: Some(&cell.place),
        };
        self.harvest
            .add(self.table.context, &probe.frame, &group, of.members);
        Ok(())
    }

    fn id(&mut self, cell: &Cell<'_>, value: Option<&str>) -> Arc<str> {
        self.scratch.clear();
        self.scratch.push_str(&cell.prefix);
        if let Some(value) = value {
            self.scratch.push(',');
            ident::push_cell(&mut self.scratch, value);
        }
        self.scratch.push(')');
        Arc::from(self.scratch.as_str())
    }

    /// Adds what must arrive in the observed variables, or what is recorded of them.
    fn targets(
        &mut self,
        of: &CaseOf<'_, '_>,
        input: &Input,
        texts: &[&str],
        assembler: &mut Assembler<'_>,
    ) -> Result<(), String> {
        let cell = of.cell;
        let open = cell.word == Word::Open;
        if open {
            assembler.observe_acceptance();
        }
        for target in &of.probe.observe {
            let name = target.name.fill(&mut self.scratch, texts);
            let own = target.ty.as_ref().map(|ty| ty.fill(&mut self.scratch, texts));
            let base = match &own {
                Some(own) => {
                    let bare = own.split_once('[').map_or(&**own, |(bare, _)| bare);
                    Some(
                        ElementaryType::from_name(bare)
                            .ok_or_else(|| format!("`{own}` is no elementary type"))?,
                    )
                }
                None => cell.column.base,
            };
            if !open && !takes_values(of.probe) {
                return Err(
                    "nothing says what must arrive: the source has no `{value}` or `{typed}`".to_owned(),
                );
            }
            if own.is_none() && !input.arrives.is_empty() && cell.row.name == cell.column.name {
                for (path, value) in input.arrives.iter() {
                    let name = format!("{name}{path}").into();
                    self.target(name, value, open, cell.line, assembler);
                }
                continue;
            }
            let arrival = match (base, &own) {
                (Some(ty), Some(_)) => input.value.as_ref().and_then(|value| arrives(value, ty)),
                _ => what_arrives(input, cell.row, cell.column),
            };
            let ty = || match (base, observable(cell.column)) {
                (Some(ty), _) => Some(self.table.context.type_names.elementary(ty)),
                (None, true) => Some(Arc::clone(&cell.column.name)),
                (None, false) => None,
            };
            match arrival {
                Some(Arrival::Exactly(value)) if !open => {
                    self.target(name, &value, open, cell.line, assembler)
                }
                None if !open => {
                    return Err(format!(
                        "nothing says what arrives in a {} from a {}; say it with a mark, and leave out `observe`",
                        cell.column.name, cell.row.name
                    ));
                }
                _ => {
                    if let Some(ty) = ty() {
                        assembler.observe(name, ty);
                    }
                }
            }
        }
        Ok(())
    }

    fn target(&self, name: Arc<str>, value: &Value, open: bool, line: u32, assembler: &mut Assembler<'_>) {
        if open {
            assembler.observe(name, self.table.context.type_names.of(value));
        } else {
            assembler.value(name, value.clone(), line);
        }
    }

    /// Says of a probe and a word once that their cases claim nothing.
    fn note_claims_nothing(&mut self, probe: &Probe<'_>, cell: &Cell<'_>) {
        let message = format!(
            "in `{}` cells the probe `{}` {}",
            cell.word.as_str(),
            probe.name,
            Assembly::NOTHING
        );
        self.harvest.doubt(
            Mistake::new(probe.line, message)
                .key("probe")
                .hint(Assembly::SAY_OK),
        );
    }

    fn wrong(&mut self, mistake: Mistake) {
        self.harvest.mistakes.push(mistake);
    }
}

/// What the cases of one cell in one group of dialects have in common.
struct CaseOf<'a, 't> {
    section: &'a Section<'a>,
    probe: &'a Probe<'a>,
    cell: &'a Cell<'t>,
    active: &'a [usize],
    members: &'a [DialectName],
    rejected: bool,
}

/// Whether a probe's program depends on the value.
fn takes_values(probe: &Probe<'_>) -> bool {
    [VALUE, TYPED].iter().any(|&slot| probe.program.used[slot])
}

/// The one value of a cell that takes one: the ordinary one, unless the probe lists its own.
fn one_of<'a>(inputs: &'a [Input], row: &'a TypeInfo) -> Option<&'a Input> {
    let listed = |ordinary: &&Input| inputs.iter().any(|input| input.literal == ordinary.literal);
    row.ordinary.as_ref().filter(listed).or(inputs.first())
}

fn what_arrives(input: &Input, row: &TypeInfo, column: &TypeInfo) -> Option<Arrival> {
    let value = input.value.as_ref()?;
    match column.base {
        Some(ty) => arrives(value, ty),
        None => (row.name == column.name).then(|| Arrival::Exactly(value.clone())),
    }
}

/// Whether a variable of the type has a value that can be given back.
fn observable(ty: &TypeInfo) -> bool {
    ty.base.is_some() || ty.ordinary.as_ref().is_some_and(|input| input.value.is_some())
}

/// The declarations that a row and a column need, on one line if they are.
fn declarations(row: &TypeInfo, column: &TypeInfo) -> String {
    let (first, second) = (&*row.declaration, &*column.declaration);
    match (first.is_empty(), second.is_empty() || row.name == column.name) {
        (_, true) => first.to_owned(),
        (true, false) => second.to_owned(),
        (false, false) => format!("{first} {second}"),
    }
}
