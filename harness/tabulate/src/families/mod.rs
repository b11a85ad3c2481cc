//! One module a family of functions; each gives the tables of its family.

mod bad_calls;
mod bcd;
mod booleans;
mod chains;
mod constants;
mod dates;
mod expressions;
mod idioms;
mod integers;
mod not_finite;
mod powers;
mod real_edges;
mod reals;
mod spellings;
mod text_edges;
mod texts;
mod time_edges;
mod times;
pub(crate) mod words;

use crate::call::Call;
use crate::sheet::Sheet;
use crate::table::Table;

/// Every generated table, in the order of the families.
///
/// # Errors
/// What [`sheets`] and [`Sheet::table`] say.
pub fn all() -> Result<Vec<Table>, String> {
    let mut tables: Vec<Table> = sheets()?.iter().map(Sheet::table).collect::<Result<_, _>>()?;
    tables.extend(constants::tables()?);
    tables.extend(chains::tables()?);
    tables.extend(expressions::tables()?);
    tables.extend(bad_calls::tables());
    tables.extend(idioms::tables());
    Ok(tables)
}

/// The tables whose rows are calls of one function.
///
/// # Errors
/// A sentence, where a family has a call that none of its tables takes, or a table without calls.
pub fn sheets() -> Result<Vec<Sheet>, String> {
    let mut sheets = [
        integers::sheets(),
        booleans::sheets(),
        reals::sheets(),
        times::sheets(),
        texts::sheets(),
    ]
    .concat();
    let already: Vec<Call> = sheets.iter().flat_map(|sheet| sheet.calls.clone()).collect();
    sheets.extend(powers::sheets()?);
    sheets.extend(real_edges::sheets(&already)?);
    sheets.extend(not_finite::sheets()?);
    sheets.extend(time_edges::sheets(&already)?);
    sheets.extend(dates::sheets()?);
    sheets.extend(text_edges::sheets(&already)?);
    sheets.extend(bcd::sheets()?);
    sheets.extend(spellings::sheets(&already)?);
    let all: Vec<Call> = sheets.iter().flat_map(|sheet| sheet.calls.clone()).collect();
    sheets.extend(constants::sheets(&all)?);
    Ok(sheets)
}
