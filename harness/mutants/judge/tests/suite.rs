//! Runs the prepared cases on the reference that is built into this program, and stops at the first that fails.
//!
//! `STICKLER_PREPARED` names the file of [`stickler_mutants_judge::prepared`] cases. The cases that killed mutants before
//! come first: their indices stand in the file beside it with the ending `.killers`, the latest last. They change the order, never
//! the verdict.

use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::{Arc, Mutex};
use stickler_mutants_judge::judge::complaint;
use stickler_mutants_judge::lookout::Lookout;
use stickler_mutants_judge::prepared;

fn main() -> ExitCode {
    match judge_all() {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

fn judge_all() -> Result<(), String> {
    let path = std::env::var_os("STICKLER_PREPARED").map(PathBuf::from);
    let path =
        path.ok_or("this judge needs prepared cases: `cargo xtask mutants` prepares them and runs it")?;
    let text = std::fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    let cases = prepared::lines(&text).filter(|cases| !cases.is_empty());
    let cases = cases.ok_or_else(|| format!("{}: not prepared cases, or cut short", path.display()))?;
    let killers = path.with_extension("killers");
    // A mutant that panics is dead; what it says to that is of no interest.
    std::panic::set_hook(Box::new(|_| {}));
    let judged = Arc::new(Mutex::new(String::new()));
    let lookout = Lookout::begin({
        let (killers, judged) = (killers.clone(), judged.clone());
        move |index, what| {
            let key = judged.lock().map(|key| key.clone()).unwrap_or_default();
            eprintln!("{}", dead(&killers, index, &key, what));
            std::process::exit(1);
        }
    });
    for index in order(cases.len(), &killers) {
        let case = prepared::read(cases[index]).map_err(|error| format!("{}: {error}", path.display()))?;
        if let Ok(mut judged) = judged.lock() {
            judged.clone_from(&case.key);
        }
        lookout.at(index);
        if let Some(what) = complaint(&case) {
            return Err(dead(&killers, index, &case.key, &what));
        }
    }
    println!("{} cases passed", cases.len());
    Ok(())
}

/// The cases that killed last, then all others in the order of the file.
fn order(cases: usize, killers: &Path) -> Vec<usize> {
    let text = std::fs::read_to_string(killers).unwrap_or_default();
    let killed = text.lines().rev().filter_map(|line| line.parse().ok());
    let mut seen = HashSet::new();
    killed
        .chain(0..cases)
        .filter(|&index| index < cases && seen.insert(index))
        .collect()
}

/// Takes down which case killed, and says so.
fn dead(killers: &Path, index: usize, key: &str, what: &str) -> String {
    let mut text = std::fs::read_to_string(killers).unwrap_or_default();
    text.push_str(&format!("{index}\n"));
    // Without the file the next judge only takes longer.
    let _ = std::fs::write(killers, text);
    format!("killed by {key}: {what}")
}
