//! The committed corpora, replayed: every file in `corpus/<target>/` is a test. A folder without files is an error.
//!
//! `cargo test -p stickler-fuzz --test corpus -- parse` replays one target's.

use libtest_mimic::{Arguments, Failed, Trial};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{fs, io};
use stickler_fuzz::FuzzTarget;

/// The targets, each with the name of its folder in `corpus/` and of its tests.
const CORPORA: [(FuzzTarget, &str); 8] = [
    (FuzzTarget::Parse, "parse"),
    (FuzzTarget::Literal, "literal"),
    (FuzzTarget::Convert, "convert"),
    (FuzzTarget::Check, "check"),
    (FuzzTarget::Execute, "execute"),
    (FuzzTarget::CaseFile, "case_file"),
    (FuzzTarget::Protocol, "protocol"),
    (FuzzTarget::Differential, "differential"),
];

fn main() -> io::Result<ExitCode> {
    let arguments = Arguments::from_args();
    let mut trials = Vec::new();
    for (target, name) in CORPORA {
        for path in files(name)? {
            let input = path.file_name().unwrap_or_default().display().to_string();
            trials.push(Trial::test(format!("{name}::{input}"), move || {
                replay(target, &path)
            }));
        }
    }
    Ok(libtest_mimic::run(&arguments, trials).exit_code())
}

/// Returns the files of a corpus in the order of their names, without hidden ones.
fn files(name: &str) -> io::Result<Vec<PathBuf>> {
    let folder = Path::new("../corpus").join(name);
    let mut paths = Vec::new();
    let entries = fs::read_dir(&folder)
        .map_err(|error| io::Error::new(error.kind(), format!("{}: {error}", folder.display())))?;
    for entry in entries {
        let entry = entry?;
        if entry.file_type()?.is_file() && !entry.file_name().as_encoded_bytes().starts_with(b".") {
            paths.push(entry.path());
        }
    }
    paths.sort();
    assert!(!paths.is_empty(), "{} has no files", folder.display());
    Ok(paths)
}

fn replay(target: FuzzTarget, path: &Path) -> Result<(), Failed> {
    target.judge(&fs::read(path)?)?;
    Ok(())
}
