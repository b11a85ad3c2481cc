//! `cargo xtask tabulate`: fills in the tables of `conformance-cases/conversion` and `conformance-cases/blocks`.

use std::path::PathBuf;
use stickler_tabulate::{blocks, folder};

/// Writes the rows of the tables anew or, with `only_check`, says which differ; returns the exit code.
pub fn execute(only_check: bool) -> u8 {
    let tables = match tables() {
        Ok(tables) => tables,
        Err(message) => {
            eprintln!("error: {message}");
            return 2;
        }
    };
    let differing = tables.iter().filter(|(_, text, wanted)| text != wanted);
    let differing: Vec<&(PathBuf, String, String)> = differing.collect();
    for (path, _, wanted) in &differing {
        let name = path.file_name().unwrap_or_default().display();
        if only_check {
            println!("differs  {name}");
        } else if let Err(error) = std::fs::write(path, wanted) {
            eprintln!("error: {}: {error}", path.display());
            return 3;
        } else {
            println!("written  {name}");
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

/// Returns the path of each table, its text, and the text that it must have.
fn tables() -> Result<Vec<(PathBuf, String, String)>, String> {
    let root = crate::root();
    let calls = folder::call_tables(&root)?.into_iter();
    let calls = calls.map(|table| (table.path.clone(), table.table.text.clone(), table.wanted()));
    let blocks = blocks::block_tables(&root)?.into_iter();
    let blocks = blocks.map(|(path, table, wanted)| (path, table.text, wanted));
    Ok(calls.chain(blocks).collect())
}
