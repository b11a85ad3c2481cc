//! One module a family of functions; each gives the tables of its family.

mod booleans;
mod idioms;
mod integers;
mod reals;
mod words;

use crate::sheet::Sheet;
use crate::table::Table;

/// Every generated table, in the order of the families.
///
/// # Errors
/// What [`Sheet::table`] says.
pub fn all() -> Result<Vec<Table>, String> {
    let sheets = [integers::sheets(), booleans::sheets(), reals::sheets()].concat();
    let mut tables: Vec<Table> = sheets.iter().map(Sheet::table).collect::<Result<_, _>>()?;
    tables.extend(idioms::tables());
    Ok(tables)
}
