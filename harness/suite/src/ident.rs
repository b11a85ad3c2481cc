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

#[cfg(test)]
mod tests {
    use super::*;

    fn cell(text: &str) -> String {
        let mut id = String::from("x(");
        push_cell(&mut id, text);
        id.split_off(2)
    }

    #[test]
    fn the_id_of_a_file_is_its_path_without_the_extension() {
        assert_eq!(
            of_file("widening/integer-2.1.toml").as_deref(),
            Ok("widening/integer-2.1")
        );
        assert!(of_file("a b/c.st").unwrap_err().contains("' ' cannot stand"));
        assert!(of_file("é.st").is_err());
    }

    #[test]
    fn a_name_has_no_empty_parts() {
        assert!(check("a//b").is_err());
        assert!(check("").is_err());
        assert!(check("a,b").is_err());
        assert_eq!(check("a/b-c_d.e"), Ok(()));
    }

    #[test]
    fn cells_are_ascii_and_tell_what_they_were() {
        assert_eq!(cell("-128"), "-128");
        assert_eq!(cell("16#FF"), "16#FF");
        assert_eq!(cell("b.%X3"), "b.%X3");
        assert_eq!(cell("a b"), "a_b");
        assert_eq!(cell("f(x, 'y')@*"), "f~28x~2C_~27y~27~29~40~2A");
        assert_eq!(cell("é~"), "~C3~A9~7E");
    }

    #[test]
    fn a_long_cell_is_cut_at_the_same_place_each_time() {
        let long = "abcdefghij".repeat(5);
        assert_eq!(cell(&long[..48]), &long[..48]);
        assert_eq!(cell(&long).len(), 48);
        assert!(cell(&long).starts_with(&long[..38]));
        assert_ne!(cell(&long), cell(&format!("{long}k")));
        let quotes = "'".repeat(20);
        assert_eq!(&cell(&quotes)[33..38], "~27~~");
    }
}
