//! The parts that the fuzz targets share, and how a failure ends libFuzzer's process.
//!
//! Architecture Invariant: nothing is judged here; every oracle is an ordinary function of `stickler-generate`.

pub use stickler_generate::oracles::FuzzTarget;

/// Judges an input for libFuzzer, which takes a panic for a finding and keeps the input.
///
/// # Panics
/// Panics if the input breaks a property of the target.
#[inline(always)]
pub fn hold(target: FuzzTarget, data: &[u8]) {
    if let Err(failure) = target.judge(data) {
        panic!("{failure}");
    }
}

/// The whole of a fuzz target: libFuzzer's entry under `cargo fuzz`, otherwise a `main` that says what judges inputs without it.
#[macro_export]
macro_rules! target {
    ($target:ident) => {
        #[cfg(fuzzing)]
        ::libfuzzer_sys::fuzz_target!(|data: &[u8]| $crate::hold($crate::FuzzTarget::$target, data));

        #[cfg(not(fuzzing))]
        fn main() {
            let name = $crate::FuzzTarget::$target.as_str();
            eprintln!("`cargo fuzz run {name}` runs this target; `stickler fuzz --target {name} --replay FILE` judges an input without libFuzzer");
        }
    };
}

#[cfg(test)]
mod tests {
    use super::FuzzTarget;
    use std::collections::BTreeSet;
    use std::fs;
    use std::path::{Path, PathBuf};

    /// Returns what lies in a folder, which a path from this crate leads to.
    fn paths_in(folder: &str) -> Vec<PathBuf> {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
        let entries = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
        entries
            .map(|entry| entry.expect("a readable folder").path())
            .collect()
    }

    /// Returns the names of what lies in a folder, hidden files aside.
    fn names_in(folder: &str) -> BTreeSet<String> {
        let paths = paths_in(folder).into_iter();
        let names = paths.filter_map(|path| Some(path.file_name()?.to_string_lossy().into_owned()));
        names.filter(|name| !name.starts_with('.')).collect()
    }

    #[test]
    fn every_target_has_its_glue_and_its_corpus_and_nothing_else_has() {
        let named = |ending| -> BTreeSet<String> {
            FuzzTarget::ALL
                .iter()
                .map(|target| format!("{}{ending}", target.as_str()))
                .collect()
        };
        assert_eq!(names_in("fuzz_targets"), named(".rs"));
        let mut folders = names_in("../corpus");
        assert!(folders.remove("README.md"), "the corpora are described");
        assert_eq!(folders, named(""));
    }

    #[test]
    fn every_input_of_the_corpora_holds() {
        for target in FuzzTarget::ALL {
            let inputs = paths_in(&format!("../corpus/{}", target.as_str()));
            assert!(!inputs.is_empty(), "{} has no corpus", target.as_str());
            for input in inputs {
                let data = fs::read(&input).expect("a readable file");
                assert!(
                    target.judge(&data).is_ok(),
                    "{}: {:?}",
                    input.display(),
                    target.judge(&data)
                );
            }
        }
    }

    #[test]
    fn every_target_is_built() {
        let manifest = include_str!("../Cargo.toml");
        for name in FuzzTarget::ALL.iter().map(|target| target.as_str()) {
            let glue = format!("path = \"fuzz_targets/{name}.rs\"");
            assert!(manifest.contains(&glue), "Cargo.toml builds no `{name}`");
        }
    }
}
