//! Fingerprints of engines: digests of the programs and files that decide their answers.

use crate::Digest;
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// A digest of this crate's source, which calls the compilers and reads their output.
const ADAPTERS: &str = env!("STICKLER_ADAPTERS");

/// A digest of the parts of an engine, gathered piece by piece; `None` once a piece could not be read.
pub(super) struct Fingerprint {
    digest: Option<Digest>,
}

impl Fingerprint {
    /// Returns the fingerprint of an adapter without its parts; `kind` names the adapter.
    pub(super) fn of(kind: &str) -> Fingerprint {
        let mut digest = Digest::new("engine");
        digest.text(ADAPTERS).text(kind);
        Fingerprint { digest: Some(digest) }
    }

    /// Adds a text.
    pub(super) fn text(mut self, text: &str) -> Fingerprint {
        if let Some(digest) = &mut self.digest {
            digest.text(text);
        }
        self
    }

    /// Adds a program. A script may call any program, and so there is no fingerprint where the program is a script.
    pub(super) fn program(self, path: &Path) -> Fingerprint {
        self.take(|digest| !is_script(path) && digest.file(path).is_ok())
    }

    /// Adds the content of a file.
    pub(super) fn file(self, path: &Path) -> Fingerprint {
        self.take(|digest| digest.file(path).is_ok())
    }

    /// Adds everything in a folder and below it.
    pub(super) fn folder(self, path: &Path) -> Fingerprint {
        self.take(|digest| digest.folder(path).is_ok())
    }

    /// Adds the fingerprint of another part; without it there is none of the whole.
    pub(super) fn with(self, other: Option<String>) -> Fingerprint {
        match other {
            Some(other) => self.text(&other),
            None => Fingerprint { digest: None },
        }
    }

    /// Adds the values of environment variables that programs heed.
    pub(super) fn variables(mut self, names: &[&str]) -> Fingerprint {
        for name in names {
            let value = std::env::var_os(name).unwrap_or_default();
            self = self.text(&value.to_string_lossy());
        }
        self
    }

    /// Returns the fingerprint; `None` where a part could not be read.
    pub(super) fn finish(&self) -> Option<String> {
        self.digest.as_ref().map(Digest::finish)
    }

    fn take(mut self, took: impl FnOnce(&mut Digest) -> bool) -> Fingerprint {
        if let Some(digest) = &mut self.digest
            && !took(digest)
        {
            self.digest = None;
        }
        self
    }
}

/// Tells whether a program is a script, which another program executes; true where the file cannot be read.
fn is_script(program: &Path) -> bool {
    let mut first = [0; 2];
    let read = File::open(program).and_then(|mut file| file.read_exact(&mut first));
    read.is_err() || first == *b"#!"
}

#[cfg(test)]
mod tests {
    use super::Fingerprint;
    use crate::process::Folder;

    #[test]
    fn a_program_that_changes_has_another_fingerprint_and_one_that_is_gone_has_none() {
        let folder = Folder::new().unwrap();
        let program = folder.write("compiler", "binary 1").unwrap();
        let fingerprint = || Fingerprint::of("test").program(&program).text("flags").finish();
        let before = fingerprint();
        assert!(before.is_some());
        assert_eq!(fingerprint(), before);
        folder.write("compiler", "binary 2").unwrap();
        let after = fingerprint();
        assert!(after.is_some() && after != before);
        std::fs::remove_file(&program).unwrap();
        assert_eq!(fingerprint(), None);
        assert_eq!(Fingerprint::of("test").with(None).finish(), None);
    }

    #[test]
    fn of_a_script_nobody_knows_what_it_calls() {
        let folder = Folder::new().unwrap();
        let text = "#!/bin/sh\nexec elsewhere/compiler \"$@\"\n";
        let script = folder.write("compiler", text).unwrap();
        assert_eq!(Fingerprint::of("test").program(&script).finish(), None);
        // A script that a compiler only reads as a file has a fingerprint.
        assert!(Fingerprint::of("test").file(&script).finish().is_some());
    }
}
