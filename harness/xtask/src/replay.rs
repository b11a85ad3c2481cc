//! `cargo xtask replay`: judges inputs of a fuzz target without libFuzzer, one line about each.

use std::fs;
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use stickler_generate::oracles::{FuzzTarget, InputOutcome};

/// The longest input that is read, in bytes; far more than libFuzzer makes, and than any text the reference reads.
const MAX_INPUT_LEN: u64 = 128 << 20;

/// The result of a replay.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
struct ReplaySummary {
    /// Inputs that broke nothing.
    held: usize,
    /// Inputs that broke what the target holds them to.
    failed: usize,
    /// Files and folders that could not be read, and folders without any input.
    unread: usize,
}

/// Replays the files, and the files in folders; returns the exit code.
pub fn execute(target: FuzzTarget, named: &[PathBuf]) -> u8 {
    let summary = replay_all(target, named, &mut io::stdout().lock(), &mut io::stderr().lock());
    match summary {
        Ok(ReplaySummary { unread: 1.., .. }) => 2,
        Ok(ReplaySummary { failed: 1.., .. }) => 1,
        Ok(_) => 0,
        // Nobody reads the output any more.
        Err(_) => 2,
    }
}

/// Replays files and the files in folders, in order, with one line about each on `output` and what could not be read on
/// `complaints`; goes on whatever happens.
///
/// # Errors
/// Errors of writing to either stream.
fn replay_all(
    target: FuzzTarget,
    named: &[impl AsRef<Path>],
    output: &mut dyn Write,
    complaints: &mut dyn Write,
) -> io::Result<ReplaySummary> {
    let mut summary = ReplaySummary::default();
    for name in named {
        let files = match inputs(name.as_ref()) {
            Ok(files) => files,
            Err(error) => {
                summary.unread += 1;
                writeln!(complaints, "{}: {error}", name.as_ref().display())?;
                continue;
            }
        };
        if files.is_empty() {
            summary.unread += 1;
            let folder = name.as_ref().display();
            writeln!(
                complaints,
                "{folder}: the folder holds no input; seed it from corpus/{}",
                target.as_str()
            )?;
        }
        for file in files {
            replay_file(target, &file, &mut summary, output, complaints)?;
        }
    }
    writeln!(output, "{} held, {} failed", summary.held, summary.failed)?;
    Ok(summary)
}

/// Returns the file itself, or the files of a folder and its subfolders in the order of their names.
fn inputs(path: &Path) -> io::Result<Vec<PathBuf>> {
    if !path.is_dir() {
        return Ok(vec![path.to_owned()]);
    }
    let mut entries: Vec<PathBuf> = fs::read_dir(path)?
        .map(|entry| entry.map(|entry| entry.path()))
        .collect::<io::Result<_>>()?;
    entries.sort();
    let mut files = Vec::with_capacity(entries.len());
    for entry in entries {
        // What a link leads to may be the folder itself.
        if entry.is_symlink() || !entry.is_dir() {
            files.push(entry);
        } else {
            files.extend(inputs(&entry)?);
        }
    }
    Ok(files)
}

fn replay_file(
    target: FuzzTarget,
    file: &Path,
    summary: &mut ReplaySummary,
    output: &mut dyn Write,
    complaints: &mut dyn Write,
) -> io::Result<()> {
    let shown = file.display();
    let data = match read(file) {
        Ok(data) => data,
        Err(error) => {
            summary.unread += 1;
            return writeln!(complaints, "{shown}: {error}");
        }
    };
    match target.judge(&data) {
        Ok(InputOutcome::Checked) => {
            summary.held += 1;
            writeln!(output, "{shown}: held")
        }
        Ok(InputOutcome::Skipped(why)) => {
            summary.held += 1;
            writeln!(output, "{shown}: passed over, {why}")
        }
        Err(failure) => {
            summary.failed += 1;
            writeln!(output, "{shown}: FAILED\n{failure}")
        }
    }
}

fn read(file: &Path) -> io::Result<Vec<u8>> {
    let mut data = Vec::new();
    fs::File::open(file)?
        .take(MAX_INPUT_LEN + 1)
        .read_to_end(&mut data)?;
    if data.len() as u64 > MAX_INPUT_LEN {
        return Err(io::Error::other(format!(
            "the input is longer than {} MiB",
            MAX_INPUT_LEN >> 20
        )));
    }
    Ok(data)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Replays these paths; returns the summary, the output, and the complaints about what could not be read.
    fn said(target: FuzzTarget, paths: &[PathBuf]) -> (ReplaySummary, String, String) {
        let (mut output, mut complaints) = (Vec::new(), Vec::new());
        let summary =
            replay_all(target, paths, &mut output, &mut complaints).expect("vectors take everything");
        let [output, complaints] =
            [output, complaints].map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
        (summary, output, complaints)
    }

    #[test]
    fn every_input_of_the_corpora_holds() {
        for target in FuzzTarget::ALL {
            let corpus = crate::root().join("corpus").join(target.as_str());
            let (summary, output, complaints) = said(target, &[corpus]);
            assert!(
                (summary.failed, summary.unread) == (0, 0),
                "{target:?}: {output}{complaints}"
            );
        }
    }

    #[test]
    fn a_missing_file_and_an_empty_folder_are_told_and_the_rest_is_replayed() {
        let folder = tempfile::tempdir().expect("a folder");
        let empty = folder.path().join("empty");
        fs::create_dir(&empty).expect("a folder");
        let input = folder.path().join("input");
        fs::write(&input, b"PROGRAM main END_PROGRAM").expect("a file");
        let (summary, output, complaints) =
            said(FuzzTarget::Parse, &[folder.path().join("none"), empty, input]);
        assert_eq!(
            summary,
            ReplaySummary {
                held: 1,
                failed: 0,
                unread: 2
            }
        );
        assert!(output.contains("input: held"), "{output}");
        assert!(complaints.contains("none: No such file"), "{complaints}");
        assert!(
            complaints.contains("empty: the folder holds no input"),
            "{complaints}"
        );
    }

    #[test]
    fn the_files_of_a_folder_come_in_order() {
        let folder = tempfile::tempdir().expect("a folder");
        for name in ["b", "a", "c"] {
            fs::write(folder.path().join(name), name).expect("a file");
        }
        let files = inputs(folder.path()).expect("a folder");
        let names: Vec<_> = files.iter().filter_map(|file| file.file_name()).collect();
        assert_eq!(names, ["a", "b", "c"]);
    }
}
