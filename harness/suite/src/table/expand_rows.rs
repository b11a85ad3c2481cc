//! Expands a table of rows into a case for every row × probe × dialect.
//!
//! Basis: conformance-cases/README.md (a table of rows).

use stickler_types::{DialectName, Value};
use toml::Spanned;

use crate::assemble::Assembler;
use crate::assembly::Assembly;
use crate::citations::WrittenBasis;
use crate::condition::Testable;
use crate::error::Mistake;
use crate::frame::{DialectGroup, Harvest};
use crate::ident;
use crate::mark::MarkWord;
use crate::table::expansion::{CaseMaker, TableExpansion};
use crate::table::inputs::{self, BESIDE};
use crate::table::keys::TableRow;
use crate::table::probe::Probe;
use crate::table::probes::{self, ProbePrograms};

/// The placeholder that follows the columns: the value that must arrive, as an untyped literal.
pub(crate) const ARRIVING: &str = "arriving";

/// The number of placeholders that follow the columns.
const UNWRITTEN: usize = 1 + BESIDE.len();

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

impl Expect {
    /// Returns the value that must arrive as an untyped literal; an empty text where none must.
    fn untyped(&self) -> String {
        let typed = match self {
            Expect::Value(value) => value.to_string(),
            _ => String::new(),
        };
        typed
            .split_once('#')
            .map_or("", |(_, literal)| literal)
            .to_owned()
    }
}

/// Expands the rows of a file.
pub(crate) fn expand(table: &TableExpansion<'_>, testable: Testable<'_>, harvest: &mut Harvest) {
    let mut probes = probes::read(table.file, table.context, testable, harvest);
    let Some(dialects) = table.dialects.clone().filter(|dialects| !dialects.is_empty()) else {
        let mistake = Mistake::new(1, "the file has no dialects").key("dialects");
        return harvest.mistakes.push(mistake);
    };
    let position = |name: &str| table.names.iter().position(|known| **known == *name);
    let special = Special {
        id: position("id"),
        title: position("title"),
        basis: position("basis"),
        dialects: position("dialects"),
    };
    let mut expander = RowExpander {
        maker: CaseMaker::new(table, harvest),
        special,
    };
    expander.check_keys(&probes);
    if let Err(mistake) = expander.probes(&mut probes, &dialects) {
        return expander.maker.wrong(mistake);
    }
    if harvest.mistakes.is_empty() {
        note_unused_columns(table, &probes, harvest);
    }
}

struct RowExpander<'a, 'h> {
    maker: CaseMaker<'a, 'h>,
    special: Special,
}

impl RowExpander<'_, '_> {
    /// Reports columns that cannot be placeholders, and keys that have no meaning in a table of rows.
    fn check_keys(&mut self, probes: &[ProbePrograms<'_>]) {
        let CaseMaker { table, .. } = self.maker;
        let lines = &table.context.lines;
        for (at, column) in table.file.columns.iter().flatten().enumerate() {
            let name = column.get_ref();
            let is_name = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | ' ');
            if name.is_empty() || !name.chars().all(is_name) {
                let message = format!("`{name}` is no name of a column; letters, digits, `_` and `-` are");
                self.maker.wrong(lines.mistake(column, "columns", message));
            }
            if table.names[..at].iter().any(|known| **known == **name) {
                let message = format!("there are two columns `{name}`");
                self.maker.wrong(lines.mistake(column, "columns", message));
            }
        }
        if !table.file.types.is_empty() {
            self.maker
                .wrong(Mistake::new(1, "[types] belongs to a matrix").key("types"));
        }
        for ProbePrograms { probe, .. } in probes {
            if let Some(values) = &probe.key.values {
                let message = "`values` belongs to a matrix; rows have theirs";
                self.maker.wrong(lines.mistake(values, "probe.values", message));
            }
            let untyped = probe.observe.iter().any(|target| target.ty.is_none());
            if probe.expect.is_none() && untyped {
                let message = "`observe` needs `expect`, or a type: `observe = \"name : TYPE\"`";
                self.maker
                    .wrong(Mistake::new(probe.line, message).key("probe.observe"));
            }
        }
    }

    fn probes(&mut self, probes: &mut [ProbePrograms<'_>], dialects: &[DialectName]) -> Result<(), Mistake> {
        for probe in probes {
            let before = self.maker.harvest.cases.len();
            let own = probe.probe.narrowed(dialects);
            let CaseMaker { table, .. } = self.maker;
            for (number, row) in table.file.rows.iter().flatten().enumerate() {
                let line = table.context.lines.of(row);
                self.maker.visit(line)?;
                if let Err(mistake) = self.row(probe, (number, row), line, &own) {
                    self.maker.wrong(mistake);
                }
            }
            if self.maker.harvest.mistakes.is_empty() {
                let cases = self.maker.harvest.cases.len() - before;
                probe.remarks(cases, &mut self.maker.harvest.remarks);
            }
        }
        Ok(())
    }

    /// Expands one row in one probe.
    ///
    /// # Errors
    /// A mistake in the row, which leaves it without cases.
    fn row(
        &mut self,
        programs: &mut ProbePrograms<'_>,
        (number, row): (usize, &Spanned<TableRow>),
        line: u32,
        dialects: &[DialectName],
    ) -> Result<(), Mistake> {
        let CaseMaker { table, .. } = self.maker;
        let context = table.context;
        let cells: Vec<Box<str>> = row.get_ref().iter().map(|cell| context.spelling(cell)).collect();
        let columns = table.names.len() - UNWRITTEN;
        if cells.len() != columns {
            let message = format!("the row has {} cells for {columns} columns", cells.len());
            return Err(Mistake::new(line, message).key("rows"));
        }
        let mut texts: Vec<&str> = cells.iter().map(|cell| &**cell).chain([""; UNWRITTEN]).collect();
        let probe = &programs.probe;
        if !probe.only.holds(&texts) {
            return Ok(());
        }
        let wrong = |key| move |message: String| Mistake::new(line, message).key(key);
        let dialects = self.row_dialects(&texts, dialects).map_err(wrong("rows"))?;
        let expect = self.expect(probe, &texts).map_err(wrong("expect"))?;
        if matches!(expect, Expect::None) {
            return Ok(());
        }
        let arriving = expect.untyped();
        texts[columns] = &arriving;
        let beside = match &expect {
            Expect::Value(value) => inputs::beside(value),
            _ => [String::new(), String::new()],
        };
        for (text, neighbour) in texts[columns + 1..].iter_mut().zip(&beside) {
            *text = neighbour;
        }
        for (index, dialects) in programs.chosen(context.places, number, dialects, &texts) {
            if let Some(probe) = programs.at(index, context, self.maker.harvest) {
                if arriving.is_empty() && probe.program.used[columns] {
                    let message = format!("the probe `{}` needs a value that must arrive", probe.name);
                    return Err(Mistake::new(line, message).key("expect"));
                }
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
                self.maker.wrong(mistake);
            }
        }
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
        let own = self.maker.table.context.dialects.resolve(names)?;
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
        let text = template.fill(&mut self.maker.scratch, texts);
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
        let targets = |assembler: &mut Assembler| match rejected || faults {
            true => Ok(()),
            false => targets(probe, texts, line, expect, assembler),
        };
        let hint = || format!("for the row on line {line}");
        let assembly = self.maker.assembly(probe, active, (texts, line), targets, hint)?;
        if assembly.claims_nothing() && !matches!(expect, Expect::Accepted) {
            let message = format!("the probe `{}` {} for this row", probe.name, Assembly::NOTHING);
            let remark = Mistake::new(line, message).hint(Assembly::SAY_OK);
            self.maker.harvest.remark(remark);
        }
        let own = |column: Option<usize>| column.map(|column| texts[column]).filter(|text| !text.is_empty());
        let basis = match own(self.special.basis) {
            Some(basis) => Some(WrittenBasis {
                text: basis.into(),
                line,
            }),
            None => self.maker.basis(probe, None, texts),
        };
        let title = own(self.special.title).map_or_else(|| self.maker.title(probe, None, texts), Into::into);
        let group = DialectGroup {
            id: self.id(probe, texts).into(),
            line,
            title,
            basis,
            assembly,
            ..DialectGroup::default()
        };
        self.maker.add(probe, texts, group, members)
    }

    /// Returns the id of the case: it names those cells of the row that the program uses outside its marks.
    fn id(&self, probe: &Probe<'_>, texts: &[&str]) -> String {
        let mut id = format!("{}::{}", self.maker.table.context.id, probe.name);
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
        for column in (0..texts.len() - UNWRITTEN).filter(|&column| shown(column)) {
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
}

/// Adds the values that the observed variables must hold, or records the variables.
fn targets(
    probe: &Probe<'_>,
    texts: &[&str],
    line: u32,
    expect: &Expect,
    assembler: &mut Assembler,
) -> Result<(), Mistake> {
    let mut scratch = String::new();
    if matches!(expect, Expect::Open) {
        assembler.observe_acceptance();
    }
    for target in &probe.observe {
        let name = target.name.fill(&mut scratch, texts);
        match (expect, &target.ty) {
            (Expect::Value(value), _) => assembler.value(name, value.clone(), line),
            (Expect::Open | Expect::Unsaid, Some(ty)) => {
                assembler.observe(name, ty.fill(&mut scratch, texts));
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

fn note_unused_columns(table: &TableExpansion<'_>, probes: &[ProbePrograms<'_>], harvest: &mut Harvest) {
    for (slot, column) in table.file.columns.iter().flatten().enumerate() {
        let own_meaning = matches!(&*table.names[slot], "id" | "title" | "basis" | "dialects");
        let basis = table.basis.as_ref().map(|basis| &basis.template);
        let in_file = [Some(&table.title), basis]
            .into_iter()
            .flatten()
            .any(|template| template.slots().any(|used| used == slot));
        if !own_meaning && !in_file && !probes.iter().any(|probe| probe.mentions(slot)) {
            let message = format!("nothing uses the column `{}`", column.get_ref());
            harvest
                .remarks
                .push(table.context.lines.mistake(column, "columns", message));
        }
    }
}
