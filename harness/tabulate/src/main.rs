//! The program that fills in the tables of `conformance-cases/conversion`.
//!
//! `cargo run -p stickler-tabulate` rewrites their rows; with `-- --check` it only says which tables differ.
//!
//! Exit codes: 0 as expected; 1 `--check` found a difference; 2 wrong usage, or a table that cannot be read or claims what no document
//! says; 3 a file cannot be written.

use std::path::Path;
use std::process::ExitCode;
use stickler_tabulate::folder::{self, CallTable};

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let only_check = match &arguments[..] {
        [] => false,
        [word] if word == "--check" => true,
        _ => {
            eprintln!("usage: stickler-tabulate [--check]");
            return ExitCode::from(2);
        }
    };
    let tables = match folder::call_tables(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")) {
        Ok(tables) => tables,
        Err(message) => {
            eprintln!("error: {message}");
            return ExitCode::from(2);
        }
    };
    let differing: Vec<&CallTable> = tables.iter().filter(|table| table.differs()).collect();
    for table in &differing {
        let name = &table.table.name;
        if only_check {
            println!("differs  {name}.toml");
        } else if let Err(error) = std::fs::write(&table.path, table.wanted()) {
            eprintln!("error: {}: {error}", table.path.display());
            return ExitCode::from(3);
        } else {
            println!("written  {name}.toml");
        }
    }
    let done = if only_check { "differ" } else { "written" };
    println!("{} tables, {} {done}", tables.len(), differing.len());
    if only_check && !differing.is_empty() {
        println!("to rewrite them: cargo run -p stickler-tabulate");
        return ExitCode::FAILURE;
    }
    ExitCode::SUCCESS
}
