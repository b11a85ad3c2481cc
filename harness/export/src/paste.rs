//! Parses texts that a person copied out of an editor into arrays of numbers.
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

/// The arrays of a pasted text, and its mistakes.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(crate) struct Pasted {
    /// The arrays of the text, in order.
    pub(crate) arrays: Vec<Array>,
    /// The parts that could not be read.
    pub(crate) complaints: Vec<Complaint>,
}

/// The elements of an array that the text contains.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(crate) struct Array {
    /// The line on which the array begins, from 1.
    pub(crate) line: usize,
    /// The elements by their index.
    pub(crate) elements: BTreeMap<usize, i32>,
}

/// A part of the text that could not be read.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Complaint {
    /// The line of the part, from 1.
    pub(crate) line: usize,
    /// The column of the part, from 1, in characters.
    pub(crate) column: usize,
    /// The mistake, as a fragment.
    pub(crate) what: String,
}

/// Parses a pasted text.
pub(crate) fn read(text: &str) -> Pasted {
    let lines: Vec<&str> = text.split('\n').map(|line| line.trim_end_matches('\r')).collect();
    if lines.iter().any(|line| !elements::of(line).is_empty()) {
        elements::read(&lines)
    } else {
        list::read(&lines)
    }
}

/// Decodes UTF-8 or UTF-16, by the byte order mark or, without one, by the zero in the first character of UTF-16; other bytes
/// are Latin-1. Ends lines with `\n`, and removes the colour sequences of terminals, which some compilers always write.
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
    // A text whose lines end with carriage returns only came from a very old system, or through one.
    if text.contains('\n') {
        text
    } else {
        text.replace('\r', "\n")
    }
}

/// Returns the column, from 1, at which a part of a line begins.
fn column(line: &str, part: &str) -> usize {
    let offset = (part.as_ptr() as usize).saturating_sub(line.as_ptr() as usize);
    line.get(..offset).map_or(1, |before| before.chars().count() + 1)
}

#[cfg(test)]
mod tests;
