//! Renames what programs declare, so that several of them can stand in one text.
//!
//! Every name that a program declares for all of its text (program organization units, types and the values of enumerations)
//! gets a suffix wherever it occurs. No line moves, and columns can be translated back.

use super::source::{SourceToken, tokens, words};
use crate::Diagnostic;
use std::collections::HashSet;
use std::path::Path;

/// The keywords of sections whose names a whole configuration shares, and of a configuration itself.
const SHARED: &[&str] = &[
    "CONFIGURATION",
    "RESOURCE",
    "VAR_GLOBAL",
    "VAR_EXTERNAL",
    "VAR_CONFIG",
    "VAR_ACCESS",
    "NAMESPACE",
    "CLASS",
    "INTERFACE",
    "USING",
];

/// The keywords of declarations that may stand beside others in a text.
const UNITS: &[&str] = &["PROGRAM", "FUNCTION", "FUNCTION_BLOCK", "TYPE"];

/// The keywords of further constructs that have an end of their own.
const BLOCKS: &[&str] = &["STRUCT", "IF", "CASE", "FOR", "WHILE", "REPEAT"];

/// Returns the names that a program declares for all of its text, in capitals; `None` where the program cannot stand among
/// others: it shares something with a configuration or with the machine, it is incomplete, or a name that it declares is
/// `taken`, by the language or by the library of a compiler.
#[must_use]
pub fn declared(source: &str, taken: &HashSet<String>) -> Option<HashSet<String>> {
    read(source, taken, ProgramReader::default())
}

/// Returns what [`declared`] does, and takes programs with directly represented variables, for a driver that gives each program memory
/// of its own.
#[must_use]
pub(super) fn declared_or_located(source: &str, taken: &HashSet<String>) -> Option<HashSet<String>> {
    let reader = ProgramReader {
        takes_locations: true,
        ..ProgramReader::default()
    };
    read(source, taken, reader)
}

fn read(source: &str, taken: &HashSet<String>, mut reader: ProgramReader) -> Option<HashSet<String>> {
    for token in tokens(source) {
        reader.read(token)?;
    }
    let whole = reader.open.is_empty() && reader.names.is_disjoint(taken);
    whole.then_some(reader.names)
}

/// The state of reading a program.
#[derive(Default)]
struct ProgramReader {
    /// Whether directly represented variables may occur.
    takes_locations: bool,
    /// The units and blocks that have not ended, in capitals.
    open: Vec<String>,
    names: HashSet<String>,
    last: Last,
    /// The last word, in capitals.
    word: String,
    /// Whether that word was the first of its declaration.
    first: bool,
    /// Whether the reader is within the list of the values of an enumeration.
    in_list: bool,
}

/// The kind of the last token.
#[derive(Clone, Copy, PartialEq, Eq, Default)]
enum Last {
    /// The keyword before the name of a program organization unit.
    Unit,
    Word,
    /// A colon.
    Colon,
    /// The keyword before the first declaration of a type, or the semicolon before any other.
    Start,
    #[default]
    Other,
}

impl ProgramReader {
    /// Reads the next token; `None` where the program cannot stand among others.
    fn read(&mut self, token: SourceToken<'_>) -> Option<()> {
        let last = std::mem::replace(&mut self.last, Last::Other);
        match token {
            SourceToken::Sign(b'%') if self.takes_locations => {}
            SourceToken::Unfinished | SourceToken::Pragma | SourceToken::Sign(b'%') => return None,
            SourceToken::Word(word) => self.word(word.text.to_ascii_uppercase(), last)?,
            SourceToken::Sign(b':') => {
                // The name of a type stands before a colon, unlike that of a field; the name of another type stands before an
                // assignment.
                let named = last == Last::Word && self.first;
                if named && self.open.last().is_some_and(|open| open == "TYPE") {
                    self.names.insert(self.word.clone());
                }
                self.last = Last::Colon;
            }
            SourceToken::Sign(b'(') => self.in_list |= last == Last::Colon,
            SourceToken::Sign(b')') => self.in_list = false,
            SourceToken::Sign(b';') => self.last = Last::Start,
            SourceToken::Sign(_) => {}
        }
        Some(())
    }

    fn word(&mut self, word: String, last: Last) -> Option<()> {
        if SHARED.contains(&word.as_str()) {
            return None;
        }
        if let Some(ended) = word.strip_prefix("END_") {
            let open = self.open.pop()?;
            let fits = open == ended || (ended == "VAR" && open.starts_with("VAR"));
            return fits.then_some(());
        }
        if last == Last::Unit || self.in_list {
            self.names.insert(word);
            return Some(());
        }
        let unit = UNITS.contains(&word.as_str());
        if unit || word == "VAR" || word.starts_with("VAR_") || BLOCKS.contains(&word.as_str()) {
            if unit != self.open.is_empty() {
                return None;
            }
            self.last = match word.as_str() {
                "TYPE" => Last::Start,
                _ if unit => Last::Unit,
                _ => Last::Other,
            };
            self.open.push(word);
            return Some(());
        }
        self.word = word;
        self.first = last == Last::Start;
        self.last = Last::Word;
        Some(())
    }
}

/// The text behind the names of a program in a pack, before the number of the program's place.
const PACK_SUFFIX: &str = "_in_pack_";

/// Returns the suffix of the names of the program at this place of a pack.
pub(super) fn pack_suffix(place: usize) -> String {
    format!("{PACK_SUFFIX}{place}")
}

/// Tells whether a program has names that look as if they were already renamed for a pack.
pub(super) fn has_pack_suffix(source: &str) -> bool {
    source.to_ascii_lowercase().contains(PACK_SUFFIX)
}

/// Returns the places of the programs whose renamed names a text has, in whatever case it writes them.
pub(super) fn places_named(text: &str) -> Vec<usize> {
    let text = text.to_ascii_lowercase();
    let behind = text.split(PACK_SUFFIX).skip(1);
    let number = |behind: &str| {
        let end = behind.find(|next: char| !next.is_ascii_digit());
        behind[..end.unwrap_or(behind.len())].parse().ok()
    };
    behind.filter_map(number).collect()
}

/// Returns every word of the library files with this extension in a folder, in capitals: the keywords, and the names that the
/// library declares. A file that cannot be read is left out: the compiler will report it.
pub(super) fn library_words(folder: &Path, extension: &str) -> HashSet<String> {
    let files = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let paths = files.map(|file| file.path());
    let texts = paths.filter(|path| path.extension().is_some_and(|found| found == extension));
    let mut taken = HashSet::new();
    for text in texts.filter_map(|path| std::fs::read_to_string(path).ok()) {
        taken.extend(words(&text).map(|word| word.text.to_ascii_uppercase()));
    }
    taken
}

/// A suffix that was inserted behind a name: its line, the column at which it begins, and its length, all as they are after the
/// insertion.
struct Insertion {
    line: u32,
    column: u32,
    length: u32,
}

/// A program whose declared names have a suffix.
pub(super) struct Renamed {
    /// The renamed text.
    pub(super) text: String,
    suffix: String,
    insertions: Vec<Insertion>,
}

impl Renamed {
    /// Appends the suffix of a place in a pack to each occurrence of these names, which are in capitals.
    pub(super) fn in_pack(source: &str, names: &HashSet<String>, place: usize) -> Renamed {
        Renamed::of(source, names, &pack_suffix(place))
    }

    /// Appends a suffix to each occurrence of these names, which are in capitals.
    fn of(source: &str, names: &HashSet<String>, suffix: &str) -> Renamed {
        let mut renamed = Renamed {
            text: String::with_capacity(source.len() * 2),
            suffix: suffix.to_owned(),
            insertions: Vec::new(),
        };
        let length = column_of(suffix.len());
        let mut written = 0;
        for word in words(source).filter(|word| names.contains(&word.text.to_ascii_uppercase())) {
            renamed.text.push_str(&source[written..word.end()]);
            written = word.end();
            let line_start = renamed.text.rfind('\n').map_or(0, |at| at + 1);
            renamed.insertions.push(Insertion {
                line: column_of(1 + source[..written].matches('\n').count()),
                column: column_of(renamed.text.len() - line_start + 1),
                length,
            });
            renamed.text.push_str(suffix);
        }
        renamed.text.push_str(&source[written..]);
        renamed
    }

    /// Translates a diagnostic of the renamed text back to the program itself.
    pub(super) fn original(&self, diagnostic: Diagnostic) -> Diagnostic {
        let column = |line: Option<u32>, column: Option<u32>| Some(self.column(line?, column?));
        Diagnostic {
            column: column(diagnostic.line, diagnostic.column).or(diagnostic.column),
            end_column: column(diagnostic.end_line, diagnostic.end_column).or(diagnostic.end_column),
            message: without(&diagnostic.message, &self.suffix),
            ..diagnostic
        }
    }

    fn column(&self, line: u32, column: u32) -> u32 {
        let before = self.insertions.iter().filter(|insertion| insertion.line == line);
        let moved = before.map(|insertion| column.saturating_sub(insertion.column).min(insertion.length));
        column - moved.sum::<u32>().min(column)
    }
}

/// Returns a column as `u32`, which no program's text exceeds.
fn column_of(number: usize) -> u32 {
    u32::try_from(number).unwrap_or(u32::MAX)
}

/// Returns a text without a suffix, which may also be written in capitals.
fn without(text: &str, suffix: &str) -> String {
    text.replace(suffix, "").replace(&suffix.to_ascii_uppercase(), "")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(source: &str) -> Option<Vec<String>> {
        let taken = HashSet::from(["TON".to_owned()]);
        let mut names: Vec<String> = declared(source, &taken)?.into_iter().collect();
        names.sort();
        Some(names)
    }

    #[test]
    fn names_are_those_of_units_types_and_enumerations() {
        let source = "TYPE Color : (RED, Green) := RED; PAIR : STRUCT a : INT; k : (ON, OFF); END_STRUCT; END_TYPE\n\
                      FUNCTION f : INT VAR_INPUT x : INT; END_VAR f := x; END_FUNCTION\n\
                      PROGRAM main VAR c : Color; w : (UP, DOWN); END_VAR IF c = RED THEN c := GREEN; END_IF; END_PROGRAM";
        let expected = [
            "COLOR", "DOWN", "F", "GREEN", "MAIN", "OFF", "ON", "PAIR", "RED", "UP",
        ];
        assert_eq!(names(source).unwrap(), expected);
    }

    #[test]
    fn a_type_by_which_another_is_declared_is_no_name_of_the_text() {
        let source = "TYPE A : INT := 5; B : ARRAY[1..2] OF DINT := [1, 2]; C : STRUCT f : SINT := 1; END_STRUCT; D : A := 7; END_TYPE";
        assert_eq!(names(source).unwrap(), ["A", "B", "C", "D"]);
    }

    #[test]
    fn what_is_no_company_for_others_is_known() {
        for source in [
            "PROGRAM main VAR_EXTERNAL x : INT; END_VAR END_PROGRAM",
            "PROGRAM main VAR x AT %IX0.0 : BOOL; END_VAR END_PROGRAM",
            "PROGRAM main {pragma} END_PROGRAM",
            "PROGRAM main (* open END_PROGRAM",
            "PROGRAM main IF a THEN END_PROGRAM",
            "PROGRAM main",
            "END_PROGRAM",
            "IF a THEN END_IF",
            "PROGRAM main PROGRAM other END_PROGRAM END_PROGRAM",
            "FUNCTION_BLOCK TON END_FUNCTION_BLOCK",
        ] {
            assert_eq!(names(source), None, "{source}");
        }
    }

    #[test]
    fn names_get_their_suffix_and_diagnostics_are_led_back() {
        let source =
            "FUNCTION f : INT (* f *)\n  f := 'f';\nEND_FUNCTION\nPROGRAM p x := F(f(y)); END_PROGRAM";
        let names = HashSet::from(["F".to_owned(), "P".to_owned()]);
        let renamed = Renamed::of(source, &names, "_in_pack_7");
        assert_eq!(
            renamed.text,
            "FUNCTION f_in_pack_7 : INT (* f *)\n  f_in_pack_7 := 'f';\nEND_FUNCTION\n\
             PROGRAM p_in_pack_7 x := F_in_pack_7(f_in_pack_7(y)); END_PROGRAM"
        );
        // Every column of the original, looked up in the renamed text and translated back.
        for (number, (before, after)) in source.lines().zip(renamed.text.lines()).enumerate() {
            let line = column_of(number + 1);
            let kept = after.replace("_in_pack_7", "~~~~~~~~~~");
            let columns = kept.char_indices().filter(|(_, character)| *character != '~');
            let led_back: Vec<u32> = columns
                .map(|(at, _)| renamed.column(line, column_of(at + 1)))
                .collect();
            let expected: Vec<u32> = (1..=column_of(before.len())).collect();
            assert_eq!(led_back, expected, "{before}");
        }
        let original = renamed.original(Diagnostic {
            line: Some(4),
            column: Some(26),
            end_line: Some(4),
            end_column: Some(37),
            message: "no F_IN_PACK_7 and no f_in_pack_7".to_owned(),
            ..Diagnostic::default()
        });
        assert_eq!((original.column, original.end_column), (Some(16), Some(17)));
        assert_eq!(original.message, "no F and no f");
    }
}
