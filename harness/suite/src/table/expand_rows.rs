//! Expands a table of rows into a case for every row × probe × dialect.
//!
//! Basis: conformance-cases/README.md (a table of rows).

use stickler_types::{DialectName, Value};
use toml::Spanned;

use crate::assemble::Assembler;
use crate::assembly::Assembly;
use crate::citations::WrittenBasis;
use crate::error::Mistake;
use crate::frame::{DialectGroup, Harvest};
use crate::ident;
use crate::mark::MarkWord;
use crate::program::Remarks;
use crate::table::budget::Budget;
use crate::table::expansion::{MAX_MISTAKES, TableExpansion};
use crate::table::keys::TableRow;
use crate::table::probe::{Placeholders, Probe};
use crate::table::probes::{self, ProbePrograms};

/// The indices of the columns that have a meaning of their own.
#[derive(Default)]
struct Special {
    id: Option<usize>,
    title: Option<usize>,
    basis: Option<usize>,
    dialects: Option<usize>,
}

/// The expectation of a row for the observed variables.
enum Expect {
    /// The observed variables must hold this value.
    Value(Value),
    Rejected,
    Fault,
    Open,
    Accepted,
    /// The row has no `expect`: only the marks state an expectation.
    Unsaid,
    /// The row stands for no case.
    None,
}

/// Expands the rows of a file.
pub(crate) fn expand(
    table: &TableExpansion<'_>,
    names: &[Box<str>],
    harvest: &mut Harvest,
    remarks: &mut Remarks,
) {
    let placeholders = Placeholders {
        names,
        known: names.len(),
        unnamed: None,
    };
    let mut probes = probes::read(
        table.file,
        table.context,
        placeholders,
        &mut harvest.mistakes,
        remarks,
    );
    let Some(dialects) = table.dialects.clone().filter(|dialects| !dialects.is_empty()) else {
        harvest
            .mistakes
            .push(Mistake::new(1, "the file has no dialects").key("dialects"));
        return;
    };
    let position = |name: &str| names.iter().position(|known| **known == *name);
    let special = Special {
        id: position("id"),
        title: position("title"),
        basis: position("basis"),
        dialects: position("dialects"),
    };
    let mut expander = RowExpander {
        table,
        names,
        special,
        harvest,
        budget: table.context.budget,
        scratch: String::new(),
    };
    expander.check_keys(&probes);
    if let Err(mistake) = expander.probes(&mut probes, &dialects) {
        expander.harvest.mistakes.push(mistake);
        return;
    }
    if harvest.mistakes.is_empty() {
        note_unused_columns(table, names, &probes, harvest);
    }
}

struct RowExpander<'a, 'h> {
    table: &'a TableExpansion<'a>,
    names: &'a [Box<str>],
    special: Special,
    harvest: &'h mut Harvest,
    budget: Budget,
    scratch: String,
}

impl RowExpander<'_, '_> {
    /// Reports columns that cannot be placeholders, and keys that have no meaning in a table of rows.
    fn check_keys(&mut self, probes: &[ProbePrograms<'_>]) {
        for (at, column) in self.table.file.columns.iter().flatten().enumerate() {
            let name = column.get_ref();
            let line = self.table.context.lines.line(column.span().start);
            let is_name = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | ' ');
            if name.is_empty() || !name.chars().all(is_name) {
                let message = format!("`{name}` is no name of a column; letters, digits, `_` and `-` are");
                self.wrong(Mistake::new(line, message).key("columns"));
            }
            if self.names[..at].iter().any(|known| **known == **name) {
                self.wrong(Mistake::new(line, format!("there are two columns `{name}`")).key("columns"));
            }
        }
        if !self.table.file.types.is_empty() {
            self.wrong(Mistake::new(1, "[types] belongs to a matrix").key("types"));
        }
        for ProbePrograms { probe, .. } in probes {
            if let Some(values) = &probe.key.values {
                let line = self.table.context.lines.line(values.span().start);
                self.wrong(
                    Mistake::new(line, "`values` belongs to a matrix; rows have theirs").key("probe.values"),
                );
            }
            let untyped = probe.observe.iter().any(|target| target.ty.is_none());
            if probe.expect.is_none() && untyped {
                let message = "`observe` needs `expect`, or a type: `observe = \"name : TYPE\"`";
                self.wrong(Mistake::new(probe.line, message).key("probe.observe"));
            }
        }
    }

    fn probes(&mut self, probes: &mut [ProbePrograms<'_>], dialects: &[DialectName]) -> Result<(), Mistake> {
        for probe in probes {
            let before = self.harvest.cases.len();
            let own = probe.probe.narrowed(dialects);
            for (number, row) in self.table.file.rows.iter().flatten().enumerate() {
                let line = self.table.context.lines.line(row.span().start);
                self.budget
                    .visit()
                    .map_err(|message| Mistake::new(line, message))?;
                self.row(probe, (number, row), line, &own)?;
                if self.harvest.mistakes.len() > MAX_MISTAKES {
                    return Err(Mistake::new(line, "further mistakes in this table are left out"));
                }
            }
            if self.harvest.mistakes.is_empty() {
                let cases = self.harvest.cases.len() - before;
                probe.remarks(cases, &mut self.harvest.remarks);
            }
        }
        Ok(())
    }

    fn row(
        &mut self,
        programs: &mut ProbePrograms<'_>,
        (number, row): (usize, &Spanned<TableRow>),
        line: u32,
        dialects: &[DialectName],
    ) -> Result<(), Mistake> {
        let cells: Vec<Box<str>> = row.get_ref().iter().map(|cell| self.spelling(cell)).collect();
        if cells.len() != self.names.len() {
            let message = format!(
                "the row has {} cells for {} columns",
                cells.len(),
                self.names.len()
            );
            self.wrong(Mistake::new(line, message).key("rows"));
            return Ok(());
        }
        let texts: Vec<&str> = cells.iter().map(|cell| &**cell).collect();
        let probe = &programs.probe;
        if !probe.only.holds(&texts) {
            return Ok(());
        }
        let dialects = match self.row_dialects(&texts, dialects) {
            Ok(dialects) => dialects,
            Err(message) => {
                self.wrong(Mistake::new(line, message).key("rows"));
                return Ok(());
            }
        };
        let expect = match self.expect(probe, &texts) {
            Ok(Expect::None) => return Ok(()),
            Ok(expect) => expect,
            Err(message) => {
                self.wrong(Mistake::new(line, message).key("expect"));
                return Ok(());
            }
        };
        let context = self.table.context;
        for (index, dialects) in programs.chosen(context.places, number, dialects, &texts) {
            if let Some(probe) = programs.at(index, context, self.harvest) {
                self.cases(probe, &texts, line, &expect, &dialects);
            }
        }
        Ok(())
    }

    /// Makes the cases of one program of a row in these dialects.
    fn cases(
        &mut self,
        probe: &mut Probe<'_>,
        texts: &[&str],
        line: u32,
        expect: &Expect,
        dialects: &[DialectName],
    ) {
        for (active, members) in probe.program.groups(dialects, texts) {
            probe.note_applied(&active);
            if let Err(mistake) = self.case(probe, texts, line, expect, &active, &members) {
                self.wrong(mistake);
            }
        }
    }

    fn spelling(&self, cell: &Spanned<crate::toml_text::Scalar>) -> Box<str> {
        cell.get_ref()
            .spelling(self.table.context.text.get(cell.span()).unwrap_or_default())
    }

    fn row_dialects(&self, texts: &[&str], dialects: &[DialectName]) -> Result<Vec<DialectName>, String> {
        let Some(names) = self
            .special
            .dialects
            .map(|column| texts[column])
            .filter(|names| !names.is_empty())
        else {
            return Ok(dialects.to_vec());
        };
        let mut own = Vec::new();
        for name in names.split_whitespace() {
            own.extend(self.table.context.dialects.resolve(name)?);
        }
        Ok(dialects
            .iter()
            .copied()
            .filter(|dialect| own.contains(dialect))
            .collect())
    }

    fn expect(&mut self, probe: &Probe<'_>, texts: &[&str]) -> Result<Expect, String> {
        let Some(template) = &probe.expect else {
            return Ok(Expect::Unsaid);
        };
        let text = template.fill(&mut self.scratch, texts);
        match &*text {
            "no" => Ok(Expect::Rejected),
            "fault" => Ok(Expect::Fault),
            "open" => Ok(Expect::Open),
            "accepted" => Ok(Expect::Accepted),
            "-" => Ok(Expect::None),
            literal if probe.observe.is_empty() => {
                Err(format!("`{literal}` is expected, but the probe has no `observe`"))
            }
            literal => Value::read(literal).map(Expect::Value).map_err(|message| {
                format!("{message}; beside literals there are no, fault, open, accepted and -")
            }),
        }
    }

    fn case(
        &mut self,
        probe: &Probe<'_>,
        texts: &[&str],
        line: u32,
        expect: &Expect,
        active: &[usize],
        members: &[DialectName],
    ) -> Result<(), Mistake> {
        let program = &probe.program;
        let rejected = program.rejects(active);
        let faults = program.faults(active);
        let here = |message: &str| Mistake::new(line, format!("{message}, in the probe `{}`", probe.name));
        match expect {
            Expect::Rejected if !rejected => {
                return Err(here("`no` is expected, but no `error` mark applies"));
            }
            Expect::Fault if !faults => return Err(here("`fault` is expected, but no `fault` mark applies")),
            _ => {}
        }
        if let Some(slot) = program.breaks_a_mark(texts) {
            let message = format!(
                "`{{{}}}` has `(*` or `*)` in it and stands in a mark",
                self.names[slot]
            );
            return Err(Mistake::new(line, message).hint("write `($2A` and `*$29`"));
        }
        let mut assembler = Assembler::new(self.table.context.type_names);
        let applied = program.apply(active, texts, &mut assembler);
        if !rejected && !faults {
            self.targets(probe, texts, line, expect, &mut assembler)?;
        }
        let assembly = applied
            .and_then(|()| assembler.finish(probe.frame.scans))
            .map_err(|mistake| {
                let place = program.place.line(mistake.line.max(1));
                Mistake::new(place, mistake.message)
                    .key("probe.source")
                    .hint(format!("for the row on line {line}"))
            })?;
        if assembly.claims_nothing() && !matches!(expect, Expect::Accepted) {
            let message = format!("the probe `{}` {} for this row", probe.name, Assembly::NOTHING);
            self.harvest
                .remark(Mistake::new(line, message).hint(Assembly::SAY_OK));
        }
        let source = program.fill(&mut self.scratch, texts);
        self.budget
            .program(source.len())
            .map_err(|message| Mistake::new(line, message))?;
        let basis = match self
            .special
            .basis
            .map(|column| texts[column])
            .filter(|basis| !basis.is_empty())
        {
            Some(basis) => Some(WrittenBasis {
                text: basis.into(),
                line,
            }),
            None => {
                let written = probe.basis.as_ref().or(self.table.basis.as_ref());
                written.map(|written| written.basis(&mut self.scratch, texts))
            }
        };
        let title = match self
            .special
            .title
            .map(|column| texts[column])
            .filter(|title| !title.is_empty())
        {
            Some(title) => title.into(),
            None => probe
                .title
                .as_ref()
                .unwrap_or(&self.table.title)
                .fill(&mut self.scratch, texts),
        };
        let group = DialectGroup {
            id: self.id(probe, texts).into(),
            title,
            basis,
            line,
            source,
            assembly,
            question: probe.question(&mut self.scratch, texts, line)?,
            cell: None,
            placement: probe.placement.as_ref(),
        };
        self.harvest
            .add(self.table.context, &probe.frame, &group, members);
        Ok(())
    }

    /// Adds the values that the observed variables must hold, or records the variables.
    fn targets(
        &mut self,
        probe: &Probe<'_>,
        texts: &[&str],
        line: u32,
        expect: &Expect,
        assembler: &mut Assembler<'_>,
    ) -> Result<(), Mistake> {
        if matches!(expect, Expect::Open) {
            assembler.observe_acceptance();
        }
        for target in &probe.observe {
            let name = target.name.fill(&mut self.scratch, texts);
            match (expect, &target.ty) {
                (Expect::Value(value), _) => assembler.value(name, value.clone(), line),
                (Expect::Open | Expect::Unsaid, Some(ty)) => {
                    assembler.observe(name, ty.fill(&mut self.scratch, texts));
                }
                (Expect::Open, None) => {
                    let message = "`open` is expected, so `observe` needs a type: `\"name : TYPE\"`";
                    return Err(Mistake::new(line, message).key("probe.observe"));
                }
                _ => {}
            }
        }
        Ok(())
    }

    /// Returns the id of the case: it names those cells of the row that the program uses outside its marks.
    fn id(&self, probe: &Probe<'_>, texts: &[&str]) -> String {
        let mut id = format!("{}::{}", self.table.context.id, probe.name);
        let Special {
            id: own,
            title,
            basis,
            dialects,
        } = self.special;
        let shown = |column: usize| match own {
            Some(own) => column == own,
            None => probe.program.used[column] && ![title, basis, dialects].contains(&Some(column)),
        };
        let mut separator = '(';
        for column in (0..texts.len()).filter(|&column| shown(column)) {
            id.push(separator);
            ident::push_cell(&mut id, texts[column]);
            separator = ',';
        }
        for name in probe.placement.iter().flat_map(|placement| placement.names()) {
            id.push(separator);
            id.push_str(name);
            separator = ',';
        }
        if separator == ',' {
            id.push(')');
        }
        id
    }

    fn wrong(&mut self, mistake: Mistake) {
        self.harvest.mistakes.push(mistake);
    }
}

fn note_unused_columns(
    table: &TableExpansion<'_>,
    names: &[Box<str>],
    probes: &[ProbePrograms<'_>],
    harvest: &mut Harvest,
) {
    for (slot, column) in table.file.columns.iter().flatten().enumerate() {
        let own_meaning = matches!(&*names[slot], "id" | "title" | "basis" | "dialects");
        let basis = table.basis.as_ref().map(|basis| &basis.template);
        let in_file = [Some(&table.title), basis]
            .into_iter()
            .flatten()
            .any(|template| template.slots().any(|used| used == slot));
        if !own_meaning && !in_file && !probes.iter().any(|probe| probe.mentions(slot)) {
            let line = table.context.lines.line(column.span().start);
            let message = format!("nothing uses the column `{}`", column.get_ref());
            harvest.remarks.push(Mistake::new(line, message).key("columns"));
        }
    }
}
