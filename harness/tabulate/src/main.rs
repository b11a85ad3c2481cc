//! The program that writes the row tables of the conformance suite whose values are computed.
//!
//! `cargo run -p stickler-tabulate` rewrites them, `cargo run -p stickler-tabulate -- --check` only says which differ.
//!
//! Exit codes: 0 as expected; 1 `--check` found a difference; 2 usage, or a table that claims what no document says; 3 a file
//! cannot be read or written.

use std::path::Path;
use std::process::ExitCode;
use stickler_tabulate::folder::{self, Difference};

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
    let files = match folder::files() {
        Ok(files) => files,
        Err(message) => {
            eprintln!("error: {message}");
            return ExitCode::from(2);
        }
    };
    let place = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .join(folder::FOLDER);
    let outcome = folder::differences(&place, &files).and_then(|differences| {
        if !only_check {
            folder::write(&differences)?;
        }
        Ok(differences)
    });
    match outcome {
        Ok(differences) => report(&differences, files.len(), only_check),
        Err(error) => {
            eprintln!("error: {}: {error}", place.display());
            ExitCode::from(3)
        }
    }
}

fn report(differences: &[Difference], files: usize, only_check: bool) -> ExitCode {
    for difference in differences {
        let name = difference.path.file_name().unwrap_or_default().to_string_lossy();
        println!("{}  {name}", if only_check { "differs" } else { "written" });
    }
    println!(
        "{files} tables, {} {}",
        differences.len(),
        if only_check { "differ" } else { "written" }
    );
    if only_check && !differences.is_empty() {
        println!("to rewrite them: cargo run -p stickler-tabulate");
        return ExitCode::FAILURE;
    }
    ExitCode::SUCCESS
}
