//! Cases with all that their tables say filled in, in the form in which a judge can read 150 000 of them at once.
//!
//! The file begins with a line that names the form. Behind it stand numbers of four bytes, the lowest first, and texts,
//! each with its length in bytes before it.

use std::fmt;

/// The first line of the file; another form gets another line.
const FORM: &str = "stickler prepared cases 1\n";

/// One program in one dialect, and what must happen.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PreparedCase<'a> {
    /// `id@dialect`.
    pub key: &'a str,
    /// The name of the dialect.
    pub dialect: &'a str,
    /// The program.
    pub source: &'a str,
    /// The number of scans.
    pub scans: u32,
    /// The values to observe: the name, and the scan after which to look; 0 is after the last.
    pub observe: Vec<(&'a str, u32)>,
    /// The variables that are set: before which scan, the name, the value as a typed literal.
    pub set: Vec<(u32, &'a str, &'a str)>,
    /// The result that must come.
    pub expectation: PreparedExpectation<'a>,
}

/// The result that must come: a `stickler_suite::Expectation` in texts.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PreparedExpectation<'a> {
    /// Whether the program must be accepted.
    pub acceptance: PreparedAcceptance,
    /// The line and code of each diagnostic that must be there.
    pub diagnostics: Vec<(u32, &'a str)>,
    /// The line and code of each warning that must be there.
    pub warnings: Vec<(u32, &'a str)>,
    /// Lines that no diagnostic may name.
    pub clean_lines: Vec<u32>,
    /// The key (`q`, or `q@3` after the third scan) and the typed literal of each value that must be there.
    pub values: Vec<(&'a str, &'a str)>,
    /// The line and kind of the fault that must end the run.
    pub fault: Option<(u32, &'a str)>,
    /// The trimmed lines of the bodies of the rendered program.
    pub rendered: Option<Vec<&'a str>>,
}

/// Whether a program must be accepted; see `stickler_suite::Acceptance`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PreparedAcceptance {
    /// The program must be accepted.
    #[default]
    Required,
    /// The program must be rejected.
    Rejected,
    /// No document says whether the program must be accepted.
    Observed,
}

/// The file does not hold prepared cases, or not all of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unreadable {
    /// The byte at which reading ended.
    pub offset: usize,
}

impl fmt::Display for Unreadable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let offset = self.offset;
        write!(
            f,
            "not prepared cases of this version, or cut short (at byte {offset})"
        )
    }
}

impl std::error::Error for Unreadable {}

/// Writes cases as [`read`] reads them. A text or a list of 2^32 and more would be cut; there is none.
#[must_use]
pub fn write<'a>(cases: impl ExactSizeIterator<Item = PreparedCase<'a>>) -> Vec<u8> {
    let mut writer = ByteWriter(FORM.as_bytes().to_vec());
    writer.length(cases.len());
    cases.for_each(|case| writer.case(&case));
    writer.0
}

/// Reads what [`write()`] wrote.
///
/// # Errors
/// [`Unreadable`] where it is anything else.
pub fn read(bytes: &[u8]) -> Result<Vec<PreparedCase<'_>>, Unreadable> {
    let mut reader = ByteReader { bytes, offset: 0 };
    let cases = reader.form().and_then(|()| reader.list(ByteReader::case));
    let offset = reader.offset;
    cases
        .filter(|_| offset == bytes.len())
        .ok_or(Unreadable { offset })
}

struct ByteWriter(Vec<u8>);

impl ByteWriter {
    fn number(&mut self, number: u32) {
        self.0.extend(number.to_le_bytes());
    }

    fn length(&mut self, length: usize) {
        self.number(u32::try_from(length).unwrap_or(u32::MAX));
    }

    fn text(&mut self, text: &str) {
        self.length(text.len());
        self.0.extend(text.as_bytes());
    }

    fn list<T>(&mut self, list: &[T], mut item: impl FnMut(&mut ByteWriter, &T)) {
        self.length(list.len());
        list.iter().for_each(|entry| item(self, entry));
    }

    fn line_and_text(&mut self, (line, text): &(u32, &str)) {
        self.number(*line);
        self.text(text);
    }

    fn case(&mut self, case: &PreparedCase<'_>) {
        self.text(case.key);
        self.text(case.dialect);
        self.text(case.source);
        self.number(case.scans);
        self.list(&case.observe, |writer, (name, after)| {
            writer.text(name);
            writer.number(*after);
        });
        self.list(&case.set, |writer, (before, name, value)| {
            writer.number(*before);
            writer.text(name);
            writer.text(value);
        });
        self.expectation(&case.expectation);
    }

    fn expectation(&mut self, expectation: &PreparedExpectation<'_>) {
        self.number(match expectation.acceptance {
            PreparedAcceptance::Required => 0,
            PreparedAcceptance::Rejected => 1,
            PreparedAcceptance::Observed => 2,
        });
        self.list(&expectation.diagnostics, ByteWriter::line_and_text);
        self.list(&expectation.warnings, ByteWriter::line_and_text);
        self.list(&expectation.clean_lines, |writer, line| writer.number(*line));
        self.list(&expectation.values, |writer, (key, value)| {
            writer.text(key);
            writer.text(value);
        });
        self.list(expectation.fault.as_slice(), ByteWriter::line_and_text);
        self.list(expectation.rendered.as_slice(), |writer, lines| {
            writer.list(lines, |writer, line| writer.text(line));
        });
    }
}

struct ByteReader<'a> {
    bytes: &'a [u8],
    offset: usize,
}

impl<'a> ByteReader<'a> {
    fn form(&mut self) -> Option<()> {
        (self.take(FORM.len())? == FORM.as_bytes()).then_some(())
    }

    fn take(&mut self, length: usize) -> Option<&'a [u8]> {
        let end = self.offset.checked_add(length)?;
        let taken = self.bytes.get(self.offset..end)?;
        self.offset = end;
        Some(taken)
    }

    fn number(&mut self) -> Option<u32> {
        Some(u32::from_le_bytes(self.take(4)?.try_into().ok()?))
    }

    fn text(&mut self) -> Option<&'a str> {
        let length = self.number()?;
        std::str::from_utf8(self.take(usize::try_from(length).ok()?)?).ok()
    }

    fn list<T>(&mut self, mut item: impl FnMut(&mut ByteReader<'a>) -> Option<T>) -> Option<Vec<T>> {
        (0..self.number()?).map(|_| item(self)).collect()
    }

    fn line_and_text(&mut self) -> Option<(u32, &'a str)> {
        Some((self.number()?, self.text()?))
    }

    fn case(&mut self) -> Option<PreparedCase<'a>> {
        Some(PreparedCase {
            key: self.text()?,
            dialect: self.text()?,
            source: self.text()?,
            scans: self.number()?,
            observe: self.list(|reader| Some((reader.text()?, reader.number()?)))?,
            set: self.list(|reader| Some((reader.number()?, reader.text()?, reader.text()?)))?,
            expectation: self.expectation()?,
        })
    }

    fn expectation(&mut self) -> Option<PreparedExpectation<'a>> {
        Some(PreparedExpectation {
            acceptance: match self.number()? {
                0 => PreparedAcceptance::Required,
                1 => PreparedAcceptance::Rejected,
                2 => PreparedAcceptance::Observed,
                _ => return None,
            },
            diagnostics: self.list(ByteReader::line_and_text)?,
            warnings: self.list(ByteReader::line_and_text)?,
            clean_lines: self.list(ByteReader::number)?,
            values: self.list(|reader| Some((reader.text()?, reader.text()?)))?,
            fault: self.list(ByteReader::line_and_text)?.pop(),
            rendered: self.list(|reader| reader.list(ByteReader::text))?.pop(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn case() -> PreparedCase<'static> {
        PreparedCase {
            key: "folder/file@matiec",
            dialect: "matiec",
            source: "PROGRAM main (* ä *) END_PROGRAM",
            scans: 3,
            observe: vec![("q", 0), ("q", 2)],
            set: vec![(2, "q", "INT#5")],
            expectation: PreparedExpectation {
                acceptance: PreparedAcceptance::Observed,
                diagnostics: vec![(4, "P4035")],
                warnings: vec![(5, "C0195")],
                clean_lines: vec![1, 2],
                values: vec![("q@2", "INT#5")],
                fault: Some((7, "division-by-zero")),
                rendered: Some(vec!["q := 5;"]),
            },
        }
    }

    #[test]
    fn cases_are_read_as_they_were_written() {
        let cases = [case(), PreparedCase::default()];
        assert_eq!(read(&write(cases.clone().into_iter())), Ok(cases.to_vec()));
    }

    #[test]
    fn a_file_that_is_cut_short_or_longer_is_refused() {
        let bytes = write([case()].into_iter());
        for length in 0..bytes.len() {
            assert!(read(&bytes[..length]).is_err(), "{length} bytes");
        }
        assert!(read(&[bytes, vec![0]].concat()).is_err());
    }
}
