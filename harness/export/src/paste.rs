//! What a person copied out of an editor, read into arrays of numbers.
//!
//! Two forms are told apart by looking at the whole text. Where something is written as an element, `results[3]` or only
//! `[3]`, every such line gives the element and its value: the value is in the column that a heading calls so, or else is the first number
//! behind the element. Otherwise the text is a list of numbers, in their order or behind their own numbers `0`, `1`, `2` ….
//! Whatever is neither (headings, other variables) is passed over; a value that is there and cannot be read is told, with its line
//! and column.

mod elements;
mod list;
mod number;

use std::collections::BTreeMap;

/// A text, read.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(crate) struct Pasted {
    /// Its arrays, in order.
    pub(crate) arrays: Vec<Array>,
    /// What could not be read.
    pub(crate) complaints: Vec<Complaint>,
}

/// The elements of an array that are there.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(crate) struct Array {
    /// The line on which it begins, from 1.
    pub(crate) line: usize,
    /// By their number.
    pub(crate) elements: BTreeMap<usize, i32>,
}

/// Something that could not be read.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Complaint {
    /// From 1.
    pub(crate) line: usize,
    /// From 1, in characters.
    pub(crate) column: usize,
    /// A fragment.
    pub(crate) what: String,
}

/// Reads a text.
pub(crate) fn read(text: &str) -> Pasted {
    let lines: Vec<&str> = text.split('\n').map(|line| line.trim_end_matches('\r')).collect();
    if lines.iter().any(|line| !elements::of(line).is_empty()) {
        elements::read(&lines)
    } else {
        list::read(&lines)
    }
}

/// The text of bytes in UTF-8 or UTF-16, by their mark or, without one, by the zero in the first character of UTF-16; what is
/// neither is Latin-1. Lines end with `\n`, and what a terminal shows as colours is gone: some compilers colour what they write whoever
/// reads it.
pub(crate) fn decoded(bytes: &[u8]) -> String {
    let utf_16 = |rest: &[u8], unit: fn([u8; 2]) -> u16| {
        let units: Vec<u16> = rest
            .chunks_exact(2)
            .map(|pair| unit([pair[0], pair[1]]))
            .collect();
        String::from_utf16_lossy(&units)
    };
    let text = match bytes {
        [0xFF, 0xFE, rest @ ..] => utf_16(rest, u16::from_le_bytes),
        [0xFE, 0xFF, rest @ ..] => utf_16(rest, u16::from_be_bytes),
        [0xEF, 0xBB, 0xBF, rest @ ..] => String::from_utf8_lossy(rest).into_owned(),
        [_, 0, ..] => utf_16(bytes, u16::from_le_bytes),
        [0, _, ..] => utf_16(bytes, u16::from_be_bytes),
        _ => match str::from_utf8(bytes) {
            Ok(text) => text.to_owned(),
            Err(_) => bytes.iter().map(|&byte| char::from(byte)).collect(),
        },
    };
    let text = anstream::adapter::strip_str(&text).to_string();
    // What has only carriage returns came from a very old system, or through one.
    if text.contains('\n') {
        text
    } else {
        text.replace('\r', "\n")
    }
}

/// The column, from 1, at which a part of a line begins.
fn column(line: &str, part: &str) -> usize {
    let offset = (part.as_ptr() as usize).saturating_sub(line.as_ptr() as usize);
    line.get(..offset).map_or(1, |before| before.chars().count() + 1)
}

#[cfg(test)]
mod tests;
