//! `cargo xtask tabulate`: fills in the tables of `conformance-cases/conversion`.

use stickler_tabulate::folder::{self, CallTable};

/// Writes the rows of the tables anew or, with `only_check`, says which differ; returns the exit code.
pub fn execute(only_check: bool) -> u8 {
    let tables = match folder::call_tables(&crate::root()) {
        Ok(tables) => tables,
        Err(message) => {
            eprintln!("error: {message}");
            return 2;
        }
    };
    let differing: Vec<&CallTable> = tables.iter().filter(|table| table.differs()).collect();
    for table in &differing {
        let name = &table.table.name;
        if only_check {
            println!("differs  {name}.toml");
        } else if let Err(error) = std::fs::write(&table.path, table.wanted()) {
            eprintln!("error: {}: {error}", table.path.display());
            return 3;
        } else {
            println!("written  {name}.toml");
        }
    }
    let done = if only_check { "differ" } else { "written" };
    println!("{} tables, {} {done}", tables.len(), differing.len());
    if only_check && !differing.is_empty() {
        println!("to rewrite them: cargo xtask tabulate");
        return 1;
    }
    0
}
