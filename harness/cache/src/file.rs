//! The files of a cache: naming, reading, mending and removing them.

use std::collections::HashMap;
use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::Path;
use std::time::SystemTime;
use stickler_engines::Digest;

/// The first line of every file. Another version of the format has another number.
const FORMAT: &str = "stickler-cache 1";

/// The extension of the files.
const EXTENSION: &str = "cache";

/// The size of a file in bytes beyond which its older half is thrown away: some ten times what the suite needs.
pub(crate) const MAX_FILE_SIZE: usize = 64 << 20;

/// The number of files in a folder at most.
const MAX_FILES: usize = 8;

/// The answers that a file holds, and the file to which more are added.
#[derive(Default)]
pub(crate) struct Kept {
    pub(crate) answers: HashMap<String, String>,
    pub(crate) file: Option<File>,
}

/// Returns the name of the file of this compiler.
pub(crate) fn name(engine: &str, fingerprint: &str) -> String {
    let harmless = |character: char| match character.is_ascii_alphanumeric() || "-.".contains(character) {
        true => character,
        false => '_',
    };
    let engine: String = engine.chars().map(harmless).take(40).collect();
    format!("{engine}-{fingerprint}.{EXTENSION}")
}

/// Reads a file, of which the older half goes if it has more than `largest` bytes, and opens it for more; what does not go well
/// stands in `notes`.
pub(crate) fn open(path: &Path, fingerprint: &str, largest: usize, notes: &mut Vec<String>) -> Kept {
    let shown = path.display();
    let text = match read(path) {
        Ok(text) => Some(text),
        Err(error) if error.kind() == ErrorKind::NotFound => None,
        Err(error) => {
            notes.push(format!("{shown} cannot be read, and keeps no results: {error}"));
            return Kept::default();
        }
    };
    let head = format!("{FORMAT} {fingerprint}\n");
    let contents = text.as_deref().map(|text| Contents::of(text, &head));
    notes.extend(contents.as_ref().and_then(|contents| contents.note(path)));
    let contents = contents.unwrap_or_default();
    let fits = text.as_ref().is_none_or(|text| text.len() <= largest);
    let lines = match fits {
        true => &contents.lines[..],
        false => &contents.lines[contents.lines.len() / 2..],
    };
    let opened = match fits && contents.is_sound() {
        true => OpenOptions::new().append(true).open(path),
        false => replace(path, &head, lines),
    };
    match &opened {
        // The files that were used last are those that stay. Where the system does not note it, another may go first.
        Ok(file) => _ = file.set_modified(SystemTime::now()),
        Err(error) => notes.push(format!(
            "{shown} cannot be written, and keeps no results: {error}"
        )),
    }
    let answer = |line: &CacheLine<'_>| (line.question.to_owned(), line.answers.to_owned());
    Kept {
        answers: lines.iter().map(answer).collect(),
        file: opened.ok(),
    }
}

/// Returns the text of a file, with what is no UTF-8 replaced: such a line is broken anyway.
fn read(path: &Path) -> io::Result<String> {
    let text = String::from_utf8(fs::read(path)?);
    Ok(text.unwrap_or_else(|error| String::from_utf8_lossy(error.as_bytes()).into_owned()))
}

/// The contents of a file; by default there is no file.
#[derive(Default)]
struct Contents<'t> {
    /// Whether the file begins with [`FORMAT`].
    ours: bool,
    /// The lines that are as they were written.
    lines: Vec<CacheLine<'t>>,
    broken: usize,
    /// Whether the last line has its line feed.
    ended: bool,
}

impl<'t> Contents<'t> {
    fn of(text: &'t str, head: &str) -> Contents<'t> {
        let Some(rest) = text.strip_prefix(head) else {
            return Contents::default();
        };
        let all = rest.lines().count();
        // Of two runs that made the file at once each may have written its beginning.
        let heads = rest.lines().filter(|line| *line == head.trim_end()).count();
        let lines: Vec<CacheLine<'t>> = rest.lines().filter_map(CacheLine::read).collect();
        Contents {
            ours: true,
            broken: all - heads - lines.len(),
            lines,
            ended: text.ends_with('\n'),
        }
    }

    fn is_sound(&self) -> bool {
        self.ours && self.broken == 0 && self.ended
    }

    fn note(&self, path: &Path) -> Option<String> {
        let shown = path.display();
        if !self.ours {
            return Some(format!(
                "{shown} is no cache of this version of Stickler; nothing in it is used, and it begins anew"
            ));
        }
        let results = match self.broken {
            0 => return None,
            1 => "1 line is".to_owned(),
            broken => format!("{broken} lines are"),
        };
        Some(format!(
            "{shown}: {results} broken; what they kept is asked again"
        ))
    }
}

/// Puts a file in the place of another, whole or not at all, and opens it for more.
fn replace(path: &Path, head: &str, lines: &[CacheLine<'_>]) -> io::Result<File> {
    let folder = path.parent().unwrap_or(Path::new(""));
    fs::create_dir_all(folder)?;
    let mut text = head.to_owned();
    for line in lines {
        text.push_str(line.whole);
        text.push('\n');
    }
    let mut new = tempfile::NamedTempFile::new_in(folder)?;
    new.write_all(text.as_bytes())?;
    new.persist(path).map_err(|error| error.error)?;
    OpenOptions::new().append(true).open(path)
}

/// Removes the files of the folder that were not used for longest, until so many are left. `own` stays.
pub(crate) fn remove_old(folder: &Path, own: &Path) {
    // What cannot be looked at now can be removed another time.
    let files = fs::read_dir(folder).into_iter().flatten().flatten();
    let ours = files.filter(|file| {
        let path = file.path();
        path != own && path.extension().is_some_and(|extension| extension == EXTENSION)
    });
    let mut dated: Vec<_> = ours
        .filter_map(|file| Some((file.metadata().ok()?.modified().ok()?, file.path())))
        .collect();
    dated.sort();
    let surplus = (dated.len() + 1).saturating_sub(MAX_FILES);
    for (_, path) in dated.drain(..surplus) {
        let _ = fs::remove_file(path);
    }
}

/// Returns the line that keeps these answers, with its line feed. Question and answers hold no line feed, and the question no
/// blank.
pub(crate) fn written(question: &str, answers: &str) -> String {
    format!("{question} {} {answers}\n", digest(question, answers))
}

/// A line that is as it was written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct CacheLine<'t> {
    /// The whole line, without its line feed.
    pub(crate) whole: &'t str,
    pub(crate) question: &'t str,
    pub(crate) answers: &'t str,
}

impl<'t> CacheLine<'t> {
    /// Reads a line without its line feed; `None` where it is not as it was written.
    pub(crate) fn read(whole: &'t str) -> Option<CacheLine<'t>> {
        let (question, rest) = whole.split_once(' ')?;
        let (reported, answers) = rest.split_once(' ')?;
        (reported == digest(question, answers)).then_some(CacheLine {
            whole,
            question,
            answers,
        })
    }
}

fn digest(question: &str, answers: &str) -> String {
    Digest::new("line of a cache")
        .text(question)
        .text(answers)
        .finish()
}

#[cfg(test)]
mod tests {
    use super::{CacheLine, written};

    #[test]
    fn a_line_is_read_as_it_was_written_or_not_at_all() {
        let line = written("question", "{\"an\": \"answer\"}");
        let whole = line.strip_suffix('\n').unwrap();
        let (question, answers) = ("question", "{\"an\": \"answer\"}");
        let read = CacheLine {
            whole,
            question,
            answers,
        };
        assert_eq!(CacheLine::read(whole), Some(read));
        for end in 0..whole.len() {
            assert_eq!(CacheLine::read(&whole[..end]), None);
        }
        assert_eq!(CacheLine::read(&whole.replace("answer\"}", "anserw\"}")), None);
        assert_eq!(CacheLine::read(&format!("{}{whole}", &whole[..20])), None);
    }
}
