//! A line of a cache: a question, a digest of the line, and the answers.

use stickler_engines::Digest;

/// The line that keeps these answers, with its line feed. Neither holds a line feed, nor the question a blank.
pub(crate) fn written(question: &str, answers: &str) -> String {
    format!("{question} {} {answers}\n", digest(question, answers))
}

/// The question and the answers of a line without its line feed; `None` where it is not as it was written.
pub(crate) fn read(line: &str) -> Option<(&str, &str)> {
    let (question, rest) = line.split_once(' ')?;
    let (told, answers) = rest.split_once(' ')?;
    (told == digest(question, answers)).then_some((question, answers))
}

fn digest(question: &str, answers: &str) -> String {
    Digest::new("line of a cache")
        .text(question)
        .text(answers)
        .finish()
}

#[cfg(test)]
mod tests {
    use super::{read, written};

    #[test]
    fn a_line_is_read_as_it_was_written_or_not_at_all() {
        let line = written("question", "{\"an\": \"answer\"}");
        let whole = line.strip_suffix('\n').unwrap();
        assert_eq!(read(whole), Some(("question", "{\"an\": \"answer\"}")));
        for end in 0..whole.len() {
            assert_eq!(read(&whole[..end]), None);
        }
        assert_eq!(read(&whole.replace("answer\"}", "anserw\"}")), None);
        assert_eq!(read(&format!("{}{whole}", &whole[..20])), None);
    }
}
