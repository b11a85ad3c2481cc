//! Parses lines that name elements: `results[3] := 17;`, a row of a watch list, a row of a table.

use super::number::{Number, is_blank, number};
use super::{Array, Complaint, Pasted, column};

/// An element that a line names.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Element<'l> {
    /// The last part of the name before the bracket; empty where there is none.
    name: &'l str,
    index: usize,
    /// The text after the bracket, up to the next element.
    rest: &'l str,
}

/// The headings of columns of values, in the languages of known editors, one a line.
const HEADINGS: &str = include_str!("headings.txt");

/// Returns the elements that a line names.
pub(super) fn of(line: &str) -> Vec<Element<'_>> {
    let mut found: Vec<(usize, Element<'_>)> = Vec::new();
    let mut at = 0;
    while let Some(open) = line[at..].find('[').map(|open| open + at) {
        at = open + 1;
        let Some(close) = line[at..].find(']').map(|close| close + at) else {
            break;
        };
        let Ok(index) = line[at..close].trim().parse::<usize>() else {
            continue;
        };
        let name = name_before(&line[..open]);
        if let Some((begin, last)) = found.last_mut() {
            // `stations[2].results[3]` is one element.
            if line[*begin..open].ends_with(&format!(".{name}")) && !name.is_empty() {
                found.pop();
            } else {
                let begin = *begin;
                last.rest = &line[begin..open - name.len()];
            }
        }
        let element = Element {
            name,
            index,
            rest: &line[close + 1..],
        };
        found.push((close + 1, element));
        at = close + 1;
    }
    found.into_iter().map(|(_, element)| element).collect()
}

fn name_before(text: &str) -> &str {
    let is_of_a_name = |c: char| c.is_alphanumeric() || c == '_';
    let text_end = text.trim_end_matches('"');
    let length: usize = text_end
        .chars()
        .rev()
        .take_while(|c| is_of_a_name(*c))
        .map(char::len_utf8)
        .sum();
    &text_end[text_end.len() - length..]
}

/// Parses lines, some of which name elements.
pub(super) fn read(lines: &[&str]) -> Pasted {
    // Where the array has its own name, arrays of other names are other variables.
    let named = |name: &str| name.eq_ignore_ascii_case("results");
    let has_named = lines
        .iter()
        .any(|line| of(line).iter().any(|element| named(element.name)));
    let mut pasted = Pasted::default();
    let mut heading = None;
    for (number, line) in lines.iter().enumerate() {
        let elements = of(line);
        if elements.is_empty() {
            heading = value_column(line).or(heading);
        }
        let alone = elements.len() == 1;
        for element in elements {
            if has_named && !element.name.is_empty() && !named(element.name) {
                continue;
            }
            let in_column = heading.filter(|_| alone).and_then(|heading| cell(line, heading));
            match value(&element, in_column) {
                Ok(value) => pasted.add(element.index, value, number + 1),
                Err((part, what)) => {
                    pasted.begin(element.index, number + 1);
                    pasted.complaints.push(Complaint {
                        line: number + 1,
                        column: column(line, part),
                        what: format!("results[{}] {what}", element.index),
                    });
                }
            }
        }
    }
    pasted
}

impl Pasted {
    /// Adds an element; an index that the array has already begins another array.
    pub(super) fn add(&mut self, index: usize, value: i32, line: usize) {
        self.begin(index, line);
        if let Some(array) = self.arrays.last_mut() {
            array.elements.insert(index, value);
        }
    }

    fn begin(&mut self, index: usize, line: usize) {
        let known = |array: &Array| array.elements.contains_key(&index);
        if self.arrays.last().is_none_or(known) {
            self.arrays.push(Array {
                line,
                ..Array::default()
            });
        }
    }
}

/// Returns the value of an element; the error is the part that cannot be read, and the mistake.
fn value<'l>(element: &Element<'l>, in_column: Option<&'l str>) -> Result<i32, (&'l str, String)> {
    let separators = |c: char| is_blank(c) || matches!(c, ':' | '=' | '"' | ';' | ',' | '>');
    let rest = element
        .rest
        .trim_start_matches(separators)
        .trim_end_matches(|c: char| is_blank(c) || matches!(c, ';' | ','));
    let whole = std::iter::once(in_column.unwrap_or(rest));
    let by_cells = rest.split(['\t', ';']);
    let by_words = rest.split(|c: char| is_blank(c) || matches!(c, ',' | ';'));
    let mut other = None;
    for part in whole.chain(by_cells).chain(by_words) {
        match number(part) {
            Some(Number::Whole(value)) => return Ok(value),
            // A number that is too great is taken for the value, unless a further column has another.
            Some(Number::Other) => other = other.or(Some(part)),
            None => {}
        }
        // A column under such a heading is the only one that may have the value.
        if in_column.is_some() {
            break;
        }
    }
    if let Some(part) = other {
        return Err((
            part,
            format!("is `{}`, which is no whole number of 32 bits", part.trim()),
        ));
    }
    let shown = in_column.unwrap_or(rest).trim();
    match shown.rsplit('\t').map(str::trim).find(|part| !part.is_empty()) {
        Some(part) => Err((part, format!("has no value that can be read: `{part}`"))),
        None => Err((element.rest, "has no value".to_owned())),
    }
}

/// Returns the index of the column whose heading is one of [`HEADINGS`].
fn value_column(line: &str) -> Option<usize> {
    cells(line).iter().position(|cell| {
        let heading = cell.trim().trim_matches('"').to_lowercase();
        HEADINGS.lines().any(|known| known == heading)
    })
}

fn cell(line: &str, number: usize) -> Option<&str> {
    cells(line).get(number).copied()
}

fn cells(line: &str) -> Vec<&str> {
    let separator = ['\t', ';', ',']
        .into_iter()
        .find(|separator| line.contains(*separator));
    separator.map_or_else(Vec::new, |separator| line.split(separator).collect())
}
