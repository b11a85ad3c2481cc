//! Reads a table file and expands it into its cases.

use crate::condition::Testable;
use crate::error::Mistake;
use crate::frame::{FileContext, Harvest};
use crate::table::expansion::TableExpansion;
use crate::table::keys::{KeyReader, TableFile};
use crate::table::{cell, expand_matrix, expand_rows, inputs};
use crate::toml_text;

/// The largest number of columns of a table; placeholders are searched linearly among them.
const MAX_COLUMNS: usize = 100;

/// Reads a table file.
pub(crate) fn read(context: &FileContext<'_>) -> Harvest {
    let mut harvest = Harvest::default();
    match toml_text::read::<TableFile>(context.text, 0, &context.lines) {
        Ok(file) => read_file(context, &file, &mut harvest),
        Err(mistake) => harvest.mistakes.push(mistake),
    }
    harvest.mistakes.sort();
    harvest.mistakes.dedup();
    harvest.remarks.sort();
    harvest.remarks.dedup();
    harvest
}

fn read_file(context: &FileContext<'_>, file: &TableFile, harvest: &mut Harvest) {
    let names: Vec<Box<str>> = match (&file.matrix, &file.columns, &file.rows) {
        (Some(_), None, None) => cell::PLACEHOLDERS.map(Into::into).into(),
        (None, Some(columns), Some(_)) => columns
            .iter()
            .map(|column| column.get_ref().as_str())
            .chain([expand_rows::ARRIVING])
            .chain(inputs::BESIDE)
            .map(Into::into)
            .collect(),
        _ => {
            let message = "a table has either `matrix`, or `columns` and `rows`";
            harvest.mistakes.push(Mistake::new(1, message));
            return;
        }
    };
    let columns = file.columns.as_ref().map_or(0, Vec::len);
    if columns > MAX_COLUMNS {
        let message = format!("{columns} columns; a table has at most {MAX_COLUMNS}");
        harvest.mistakes.push(Mistake::new(1, message).key("columns"));
        return;
    }
    let testable = match &file.matrix {
        Some(_) => cell::testable(&names),
        None => Testable {
            names: &names,
            known: names.len(),
            unnamed: None,
        },
    };
    let mut reader = KeyReader::new(context, testable);
    if let (Some(generate), Some(_)) = (&file.generate, &file.matrix) {
        reader.wrong(generate, "generate", "a matrix has no rows to be generated");
    }
    let dialects = reader.dialects(file.dialects.as_ref(), "dialects");
    let title = reader.template(Some(&file.title), "title");
    let basis = reader.basis(file.basis.as_ref(), "basis");
    harvest.mistakes.append(&mut reader.mistakes);
    let Some(title) = title.filter(|_| basis.is_some() == file.basis.is_some()) else {
        return;
    };
    let table = TableExpansion {
        context,
        file,
        names: &names,
        dialects,
        title,
        basis,
    };
    match &file.matrix {
        Some(matrix) => expand_matrix::expand(&table, matrix, testable, harvest),
        None => expand_rows::expand(&table, testable, harvest),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::RefCell;

    use crate::dialects::Dialects;
    use crate::place::Lines;
    use crate::table::Budget;

    fn harvest(text: &str, budget: Budget) -> Harvest {
        read(&FileContext {
            file: "cases/a/f.toml".into(),
            id: "a/f".to_owned(),
            area: "a".into(),
            text,
            lines: Lines::new(text),
            dialects: &Dialects::default(),
            features: &crate::Features::default(),
            named: RefCell::default(),
            sources: None,
            places: &crate::places::Places::default(),
            budget,
        })
    }

    #[test]
    fn a_table_that_would_fill_the_memory_comes_to_an_end() {
        let matrix = "title='t'\nbasis='rule: not-stated'\ndialects=['matiec']\nmatrix='BOOL INT\\nBOOL no no'\n\
                      [[probe]]\nname='p'\nsource='{row} (*! error P0002 *)'\n";
        let matrix = matrix
            .replace("matrix='", "matrix=\"")
            .replace("no no'", "no no\"");
        let rows = "title='t'\nbasis='rule: not-stated'\ndialects=['matiec']\ncolumns=['a']\nrows=[['1'], ['2']]\n\
                    [[probe]]\nname='p'\nsource='{a} (*! error P0002 *)'\n";
        for text in [&*matrix, rows] {
            assert_eq!(harvest(text, Budget::default()).cases.len(), 2);
            for (budget, said) in [
                (
                    Budget {
                        visits: 1,
                        ..Budget::default()
                    },
                    "too many cells",
                ),
                (
                    Budget {
                        bytes: 500,
                        ..Budget::default()
                    },
                    "more than 512 MiB",
                ),
            ] {
                let harvest = harvest(text, budget);
                assert_eq!(harvest.cases.len(), 1);
                assert!(
                    harvest.mistakes[0].message.contains(said),
                    "{:?}",
                    harvest.mistakes
                );
            }
        }
    }
}
