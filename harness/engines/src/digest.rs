//! A digest of texts, numbers and files, by which the cache and fingerprints compare them.

use siphasher::sip128::{Hasher128, SipHasher13};
use std::fs::{self, File};
use std::hash::Hasher;
use std::io::{self, Read};
use std::path::Path;

/// A digest of 128 bits over a sequence of pieces. Each piece counts with its length, so that no two different sequences of
/// pieces are hashed alike.
///
/// The digest tells apart what differs by chance. It does not protect against somebody who constructs two inputs of the same
/// digest.
#[derive(Clone)]
pub struct Digest {
    hasher: SipHasher13,
}

impl Digest {
    /// Returns a digest of nothing so far; `of` names the kind of thing, so that digests of different kinds differ.
    pub fn new(of: &str) -> Digest {
        let mut digest = Digest {
            hasher: SipHasher13::new(),
        };
        digest.text(of);
        digest
    }

    /// Adds a text.
    pub fn text(&mut self, text: &str) -> &mut Digest {
        self.number(text.len() as u64);
        self.hasher.write(text.as_bytes());
        self
    }

    /// Adds a number.
    pub fn number(&mut self, number: u64) -> &mut Digest {
        self.hasher.write(&number.to_le_bytes());
        self
    }

    /// Adds the content of a file.
    ///
    /// # Errors
    /// An error of the system where the file cannot be read.
    pub fn file(&mut self, path: &Path) -> io::Result<&mut Digest> {
        let mut file = File::open(path)?;
        let mut piece = vec![0; 1 << 18];
        let mut length: u64 = 0;
        while let read @ 1.. = file.read(&mut piece)? {
            self.hasher.write(&piece[..read]);
            length += read as u64;
        }
        Ok(self.number(length))
    }

    /// Adds everything in a folder and below it, with the file names, in the order of the names.
    ///
    /// # Errors
    /// An error of the system where a file or a folder cannot be read.
    pub fn folder(&mut self, path: &Path) -> io::Result<&mut Digest> {
        let mut inside: Vec<fs::DirEntry> = fs::read_dir(path)?.collect::<io::Result<_>>()?;
        inside.sort_by_key(fs::DirEntry::file_name);
        self.number(inside.len() as u64);
        for entry in inside {
            self.text(&entry.file_name().to_string_lossy());
            let path = entry.path();
            match path.is_dir() {
                true => self.folder(&path)?,
                false => self.file(&path)?,
            };
        }
        Ok(self)
    }

    /// Returns the digest of all that was added: 32 hexadecimal digits.
    pub fn finish(&self) -> String {
        format!("{:032x}", self.hasher.finish128().as_u128())
    }
}

#[cfg(test)]
mod tests {
    use super::Digest;
    use crate::process::Folder;

    fn digest(pieces: &[&str]) -> String {
        let mut digest = Digest::new("test");
        for piece in pieces {
            digest.text(piece);
        }
        digest.finish()
    }

    #[test]
    fn pieces_do_not_run_into_one_another() {
        let digests = [
            digest(&[]),
            digest(&[""]),
            digest(&["ab", "c"]),
            digest(&["a", "bc"]),
            digest(&["abc"]),
            Digest::new("ab").text("c").finish(),
        ];
        for (number, one) in digests.iter().enumerate() {
            assert_eq!(one.len(), 32);
            assert!(!digests[..number].contains(one));
        }
        assert_eq!(digest(&["ab", "c"]), digests[2]);
    }

    #[test]
    fn every_file_of_a_folder_counts_with_its_name() {
        let of = |files: &[(&str, &str)]| {
            let folder = Folder::new().unwrap();
            std::fs::create_dir(folder.path().join("below")).unwrap();
            for (name, text) in files {
                folder.write(name, text).unwrap();
            }
            let mut digest = Digest::new("test");
            digest.folder(folder.path()).unwrap();
            digest.finish()
        };
        let digests = [
            of(&[("a", "1"), ("below/b", "2")]),
            of(&[("a", "1"), ("below/b", "3")]),
            of(&[("a", "1"), ("below/c", "2")]),
            of(&[("a", "1"), ("b", "2")]),
        ];
        for (number, one) in digests.iter().enumerate() {
            assert!(!digests[..number].contains(one));
        }
        assert_eq!(of(&[("below/b", "2"), ("a", "1")]), digests[0]);
    }

    #[test]
    fn what_is_not_there_has_no_digest() {
        let folder = Folder::new().unwrap();
        let nowhere = folder.path().join("nowhere");
        assert!(Digest::new("test").file(&nowhere).is_err());
        assert!(Digest::new("test").folder(&nowhere).is_err());
    }
}
