//! Lines of bounded length from a byte stream.

use std::io::{self, BufRead, Read};

/// The result of reading a line.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Line {
    /// The buffer holds the line, without its line feed.
    Whole,
    /// The line was longer than the limit and is gone.
    TooLong,
    /// The end of the input.
    End,
}

/// Reads the next line into `buffer`, keeping at most `limit` bytes whatever the other side sends. A last
/// line without a line feed counts.
///
/// # Errors
/// The errors of `input`.
pub(super) fn next_line(input: &mut impl BufRead, buffer: &mut Vec<u8>, limit: usize) -> io::Result<Line> {
    buffer.clear();
    // A line of the whole limit has its line feed behind it.
    let most = limit as u64 + 1;
    if input.by_ref().take(most).read_until(b'\n', buffer)? == 0 {
        return Ok(Line::End);
    }
    if buffer.last() == Some(&b'\n') {
        buffer.pop();
    }
    if buffer.len() <= limit {
        return Ok(Line::Whole);
    }
    // Gives the memory back: an engine must not keep 64 MiB because of one bad line.
    *buffer = Vec::new();
    input.skip_until(b'\n')?;
    Ok(Line::TooLong)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::BufReader;

    fn lines(text: &[u8], limit: usize, chunk: usize) -> Vec<(Line, Vec<u8>)> {
        let mut input = BufReader::with_capacity(chunk, text);
        let mut buffer = Vec::new();
        let mut found = Vec::new();
        loop {
            let line = next_line(&mut input, &mut buffer, limit).unwrap();
            if line == Line::End {
                return found;
            }
            found.push((line, buffer.clone()));
        }
    }

    #[test]
    fn lines_are_read_whole_across_chunks_and_without_a_last_feed() {
        let expected = vec![
            (Line::Whole, b"abcdef".to_vec()),
            (Line::Whole, Vec::new()),
            (Line::Whole, b"g".to_vec()),
        ];
        for chunk in 1..10 {
            assert_eq!(lines(b"abcdef\n\ng", 6, chunk), expected, "chunk {chunk}");
        }
    }

    #[test]
    fn a_line_over_the_limit_is_skipped_and_the_next_one_is_read() {
        for chunk in 1..10 {
            let found = lines(b"abcdefg\nxy\n", 6, chunk);
            assert_eq!(
                found,
                vec![(Line::TooLong, Vec::new()), (Line::Whole, b"xy".to_vec())],
                "chunk {chunk}"
            );
        }
    }

    #[test]
    fn a_last_line_over_the_limit_is_reported_before_the_end() {
        assert_eq!(lines(b"abcdefg", 6, 3), vec![(Line::TooLong, Vec::new())]);
        assert_eq!(lines(b"", 6, 3), vec![]);
    }
}
