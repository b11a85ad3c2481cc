//! What the engines give for one signature, beside what the documents say.

use super::ask::{Asker, Got};
use super::given::Operands;
use crate::engines::{self, Named};
use anyhow::Result;
use stickler_exact::{Expected, Signature};
use stickler_types::DialectName;

/// One way to call a function: its types, some calls, and what they give.
pub struct Block {
    /// The types.
    pub signature: Signature,
    /// The operands of each call.
    pub calls: Vec<Operands>,
    /// One column an engine and dialect.
    pub columns: Vec<Column>,
}

/// What one engine gives in one dialect.
pub struct Column {
    /// The engine, by its place among those that were asked.
    pub engine: usize,
    /// The dialect.
    pub dialect: DialectName,
    /// A cell for each call.
    pub cells: Vec<Cell>,
}

/// What one call gave, and must give.
#[derive(Clone, PartialEq, Debug)]
pub struct Cell {
    /// What the engine did.
    pub got: Got,
    /// What must come, where its basis is there; otherwise what Stickler's design suggests.
    pub expected: Expected,
}

impl Cell {
    /// Whether the engine does not do what a document says. What it says that it cannot do contradicts nothing.
    pub fn contradicts(&self) -> bool {
        self.expected.basis.is_some()
            && !self.got.is_unsupported()
            && self.got != Got::Value(self.expected.value.clone())
    }
}

impl Block {
    /// Every cell that contradicts a document: its column, its call, and itself.
    pub fn contradictions(&self) -> impl Iterator<Item = (&Column, &Operands, &Cell)> {
        self.columns.iter().flat_map(|column| {
            let cells = self.calls.iter().zip(&column.cells);
            cells
                .filter(|(_, cell)| cell.contradicts())
                .map(move |(call, cell)| (column, call, cell))
        })
    }
}

/// Asks each engine for each call in each of the dialects that it speaks and that has the signature.
///
/// # Errors
/// An engine that cannot be run, or that speaks none of the dialects.
pub fn gather(
    rows: Vec<(Signature, Vec<Operands>)>,
    dialects: &[DialectName],
    engines: &[Named],
) -> Result<Vec<Block>> {
    let mut blocks: Vec<Block> = rows
        .into_iter()
        .map(|(signature, calls)| Block {
            signature,
            calls,
            columns: Vec::new(),
        })
        .collect();
    for (index, named) in engines.iter().enumerate() {
        let mut asker = Asker::new(named.engine.as_ref())?;
        let spoken = engines::spoken(named.identity(), dialects)?;
        for block in &mut blocks {
            for dialect in &spoken {
                block.ask(index, *dialect, &mut asker)?;
            }
        }
    }
    Ok(blocks)
}

impl Block {
    fn ask(&mut self, engine: usize, dialect: DialectName, asker: &mut Asker<'_>) -> Result<()> {
        let Block { signature, calls, .. } = &*self;
        if !stickler_exact::signatures(&signature.function, dialect).contains(signature) {
            return Ok(());
        }
        let got = asker.calls(dialect, signature, calls)?;
        let cell = |(call, got): (&Operands, Got)| Cell {
            got,
            expected: stickler_exact::expected(signature, call, dialect),
        };
        let cells = calls.iter().zip(got).map(cell).collect();
        self.columns.push(Column {
            engine,
            dialect,
            cells,
        });
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::{Cell, Got};
    use stickler_exact::Expected;
    use stickler_types::Value;

    fn cell(got: Got, basis: Option<&'static str>) -> Cell {
        let value = Value::parse("INT#5").unwrap();
        Cell {
            got,
            expected: Expected { value, basis },
        }
    }

    fn none(word: &'static str) -> Got {
        let detail = String::new();
        Got::None { word, detail }
    }

    #[test]
    fn only_what_a_document_says_can_be_contradicted() {
        let basis = Some("iec-61131-3: Table 22");
        let right = || Got::Value(Value::parse("INT#5").unwrap());
        let wrong = || Got::Value(Value::parse("INT#6").unwrap());
        assert!(!cell(right(), basis).contradicts());
        assert!(cell(wrong(), basis).contradicts());
        assert!(!cell(wrong(), None).contradicts());
        assert!(cell(none("crashed"), basis).contradicts());
        assert!(!cell(none("unsupported"), basis).contradicts());
    }
}
