//! Parses lists of numbers: one or several on a line, or each after its own index.

use super::number::{Number, is_blank, number};
use super::{Complaint, Pasted, column};
use crate::page::{MAGIC, PAGE_NUMBER_STEP};

/// A number of a list, and the line on which it stands.
type NumberAndLine = (i32, usize);

/// Parses lines of which none names an element.
pub(super) fn read(lines: &[&str]) -> Pasted {
    let mut pasted = Pasted::default();
    let mut rows: Vec<Vec<NumberAndLine>> = Vec::new();
    for (at, line) in lines.iter().enumerate() {
        let (row, complaints) = row(line, at + 1);
        // A line without any number is a heading or a remark.
        if !row.is_empty() {
            pasted.complaints.extend(complaints);
            rows.push(row);
        }
    }
    let numbers: Vec<NumberAndLine> = if are_numbered(&rows) {
        rows.iter().map(|row| row[1]).collect()
    } else {
        rows.concat()
    };
    let mut index = 0;
    for (at, &(value, line)) in numbers.iter().enumerate() {
        let next = numbers.get(at + 1).map(|(next, _)| *next);
        if value == MAGIC && next.is_some_and(is_of_a_page) {
            index = 0;
        }
        pasted.add(index, value, line);
        index += 1;
    }
    pasted
}

fn is_of_a_page(number: i32) -> bool {
    usize::try_from(number).is_ok_and(|number| number > 0 && number % PAGE_NUMBER_STEP == 0)
}

/// Returns whether every row is the index of an element and its value.
fn are_numbered(rows: &[Vec<NumberAndLine>]) -> bool {
    let mut next = 0;
    let counts = rows.iter().all(|row| match row[..] {
        [(index, _), _] => {
            let fits = index == next || index == 0;
            next = index.saturating_add(1);
            fits
        }
        _ => false,
    });
    counts && rows.first().is_some_and(|row| row[0].0 == 0)
}

/// Parses the numbers of a line; also returns the complaints about parts that are no numbers.
fn row(line: &str, at: usize) -> (Vec<NumberAndLine>, Vec<Complaint>) {
    let inside = line.trim_matches(|c: char| is_blank(c) || matches!(c, '[' | ']' | '{' | '}' | ';' | ','));
    if let Some(Number::Whole(value)) = number(inside) {
        return (vec![(value, at)], Vec::new());
    }
    let separators: &[char] = if inside.contains('\t') {
        &['\t']
    } else if inside.contains(';') {
        &[';']
    } else if inside.contains(',') {
        &[',']
    } else {
        &[' ', '\u{a0}']
    };
    let (mut row, mut complaints) = (Vec::new(), Vec::new());
    for part in inside
        .split(separators)
        .filter(|part| !part.trim_matches(is_blank).is_empty())
    {
        match number(part) {
            Some(Number::Whole(value)) => row.push((value, at)),
            _ => match repeated(part) {
                Some((times, value)) => row.extend(std::iter::repeat_n((value, at), times)),
                None => complaints.push(Complaint {
                    line: at,
                    column: column(line, part.trim_start()),
                    what: format!("`{}` is no whole number of 32 bits", part.trim()),
                }),
            },
        }
    }
    (row, complaints)
}

/// Parses a repeated value, as in initial values: `5(0)` is five zeros.
fn repeated(part: &str) -> Option<(usize, i32)> {
    let (times, value) = part.trim().strip_suffix(')')?.split_once('(')?;
    let times = times
        .trim()
        .parse::<usize>()
        .ok()
        .filter(|times| *times <= PAGE_NUMBER_STEP * 8)?;
    match number(value)? {
        Number::Whole(value) => Some((times, value)),
        Number::Other => None,
    }
}
