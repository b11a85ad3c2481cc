//! Renames what programs declare, so that several of them can stand in one text.
//!
//! Every name that a program declares for all of its text (program organization units, types and the values of enumerations)
//! gets a suffix wherever it occurs. No line moves, and columns can be translated back.

use super::source::words_of;
use crate::{Diagnostic, RunRequest};
use std::collections::HashSet;
use std::path::Path;
use std::sync::LazyLock;
use stickler_syntax::names::separable;
use stickler_syntax::{Edits, words};
use stickler_types::{Dialect, DialectName};

/// Returns the names that the program of a request declares for all of its text, in capitals; `None` where the program cannot
/// stand among others, or a name that it declares is `taken`, by the language or by the library of a compiler.
/// `takes_locations` is whether a driver gives each program memory of its own for directly represented variables.
pub(super) fn declared(
    request: &RunRequest<'_>,
    taken: &HashSet<String>,
    takes_locations: bool,
) -> Option<HashSet<String>> {
    let names = separable(request.source, Dialect::of(request.dialect), takes_locations)?;
    names.is_disjoint(taken).then_some(names)
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

/// The names that programs in a pack must not declare; read when first needed.
pub(super) type TakenNames = LazyLock<HashSet<String>, Box<dyn FnOnce() -> HashSet<String> + Send>>;

/// Returns every word of the library files with this extension in a folder, in capitals: the keywords, and the names that the
/// library of a dialect's compiler declares. A file that cannot be read is left out: the compiler will report it.
pub(super) fn library_words(folder: &Path, extension: &str, dialect: DialectName) -> HashSet<String> {
    let files = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let paths = files.map(|file| file.path());
    let texts = paths.filter(|path| path.extension().is_some_and(|found| found == extension));
    let mut taken = HashSet::new();
    for text in texts.filter_map(|path| std::fs::read_to_string(path).ok()) {
        taken.extend(words(&text, Dialect::of(dialect)).map(|word| word.text.to_ascii_uppercase()));
    }
    taken
}

/// A program whose declared names have a suffix.
pub(super) struct Renamed {
    /// The renamed text.
    pub(super) text: String,
    /// The names that have the suffix, in capitals.
    names: HashSet<String>,
    suffix: String,
    /// The lines and columns of the suffixes in the program as it was.
    insertions: Vec<(u32, u32)>,
}

impl Renamed {
    /// Appends a suffix to each occurrence of these names, which are in capitals.
    pub(super) fn with_suffix(request: &RunRequest<'_>, names: &HashSet<String>, suffix: &str) -> Renamed {
        let mut edits = Edits::new();
        let mut insertions = Vec::new();
        for word in words_of(request).filter(|word| names.contains(&word.text.to_ascii_uppercase())) {
            edits.replace(word.span.after(), suffix);
            let before = &request.source[..word.span.end as usize];
            let line_start = before.rfind('\n').map_or(0, |at| at + 1);
            insertions.push((
                column_of(before.matches('\n').count() + 1),
                column_of(before.len() - line_start + 1),
            ));
        }
        Renamed {
            text: edits.apply(request.source),
            names: names.clone(),
            suffix: suffix.to_owned(),
            insertions,
        }
    }

    /// Translates a diagnostic of the renamed text back to the program itself.
    pub(super) fn original(&self, diagnostic: Diagnostic) -> Diagnostic {
        let column = |line: Option<u32>, column: Option<u32>| Some(self.column(line?, column?));
        Diagnostic {
            column: column(diagnostic.line, diagnostic.column).or(diagnostic.column),
            end_column: column(diagnostic.end_line, diagnostic.end_column).or(diagnostic.end_column),
            message: without(&diagnostic.message, &self.names, &self.suffix),
            ..diagnostic
        }
    }

    fn column(&self, line: u32, column: u32) -> u32 {
        let length = column_of(self.suffix.len());
        let before = self.insertions.iter().filter(|(of, _)| *of == line);
        before.fold(column, |column, (_, at)| {
            column - column.saturating_sub(*at).min(length)
        })
    }
}

/// Returns a column as `u32`, which no program's text exceeds.
fn column_of(number: usize) -> u32 {
    u32::try_from(number).unwrap_or(u32::MAX)
}

/// Returns a text without a suffix where it stands behind one of these names, in whatever case the text writes both; the text of a
/// keyword may end as the suffix does.
pub(super) fn without(text: &str, names: &HashSet<String>, suffix: &str) -> String {
    let capitals = text.to_ascii_uppercase();
    let suffix = suffix.to_ascii_uppercase();
    let is_behind_a_name = |at: usize| {
        names.iter().any(|name| {
            let before = capitals[..at].strip_suffix(name.as_str());
            before.is_some_and(|before| !before.ends_with(|last: char| last.is_ascii_alphanumeric()))
        })
    };
    let mut left = String::with_capacity(text.len());
    let mut from = 0;
    for (at, _) in capitals.match_indices(&suffix) {
        if is_behind_a_name(at) {
            left.push_str(&text[from..at]);
            from = at + suffix.len();
        }
    }
    left + &text[from..]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_get_their_suffix_and_diagnostics_are_led_back() {
        let source =
            "FUNCTION f : INT (* f *)\n  f := 'f';\nEND_FUNCTION\nPROGRAM p x := F(f(y)); END_PROGRAM";
        let names = HashSet::from(["F".to_owned(), "P".to_owned()]);
        let request = RunRequest::once(DialectName::MATIEC, source, &[]);
        let renamed = Renamed::with_suffix(&request, &names, &pack_suffix(7));
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
