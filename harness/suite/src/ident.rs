//! Ids of cases: ASCII, stable, and readable.
//!
//! Basis: conformance-cases/README.md (ids).

use stickler_types::Fnv1a;

/// The number of characters that a cell of a row may take in an id.
const MAX_CELL_LEN: usize = 48;

/// Returns the id of the file at `path` (relative to the suite's root, with forward slashes): the path without its
/// extension.
///
/// # Errors
/// A message, if the path has characters that ids cannot have.
pub(crate) fn of_file(path: &str) -> Result<String, String> {
    let stem = stem(path);
    match check(stem) {
        Ok(()) => Ok(stem.to_owned()),
        Err(what) => Err(format!("the path gives the case its id, and {what}")),
    }
}

/// Returns the path of a file without its extension.
pub(crate) fn stem(path: &str) -> &str {
    path.rsplit_once('.').map_or(path, |(stem, _)| stem)
}

/// Checks that `id` can be the whole id of a program, or the name of a probe.
pub(crate) fn check(id: &str) -> Result<(), String> {
    let bad = id
        .chars()
        .find(|&c| !(c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | '.' | '/')));
    match bad {
        Some(bad) => Err(format!(
            "{bad:?} cannot stand in an id; ASCII letters, digits, `-`, `_` and `.` can"
        )),
        None if id.split('/').any(str::is_empty) => Err("a part of the id is empty".to_owned()),
        None => Ok(()),
    }
}

/// Appends a cell of a table as ids write it.
///
/// Different cells give different texts, except that a space and an underscore look the same.
pub(crate) fn push_cell(id: &mut String, cell: &str) {
    let start = id.len();
    for &byte in cell.as_bytes() {
        match byte {
            b' ' => id.push('_'),
            b'0'..=b'9' | b'A'..=b'Z' | b'a'..=b'z' => id.push(char::from(byte)),
            b'_' | b'.' | b'+' | b'-' | b'#' | b':' | b'%' | b'/' | b'=' | b'[' | b']' => {
                id.push(char::from(byte))
            }
            _ => push_escape(id, byte),
        }
    }
    if id.len() - start > MAX_CELL_LEN {
        shorten(id, start, cell);
    }
}

fn push_escape(id: &mut String, byte: u8) {
    const DIGITS: &[u8; 16] = b"0123456789ABCDEF";
    id.push('~');
    id.push(char::from(DIGITS[usize::from(byte >> 4)]));
    id.push(char::from(DIGITS[usize::from(byte & 15)]));
}

/// Replaces the end of a long cell by a hash of all of it.
fn shorten(id: &mut String, start: usize, cell: &str) {
    let mut keep = start + MAX_CELL_LEN - "~~01234567".len();
    // An escape is not cut in two.
    while id[keep.saturating_sub(2).max(start)..keep].contains('~') {
        keep -= 1;
    }
    id.truncate(keep);
    id.push_str(&format!("~~{:08x}", Fnv1a::of(cell).folded()));
}
