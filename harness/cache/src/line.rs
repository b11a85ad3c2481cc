//! A line of a cache: a question, a digest of the line, and the answers.

use stickler_engines::Digest;

/// Returns the line that keeps these answers, with its line feed. Question and answers hold no line feed, and the question no
/// blank.
pub(crate) fn written(question: &str, answers: &str) -> String {
    format!("{question} {} {answers}\n", digest(question, answers))
}

/// A line that is as it was written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct CacheLine<'t> {
    /// The whole line, without its line feed.
    pub(crate) whole: &'t str,
    pub(crate) question: &'t str,
    pub(crate) answers: &'t str,
}

impl<'t> CacheLine<'t> {
    /// Reads a line without its line feed; `None` where it is not as it was written.
    pub(crate) fn read(whole: &'t str) -> Option<CacheLine<'t>> {
        let (question, rest) = whole.split_once(' ')?;
        let (reported, answers) = rest.split_once(' ')?;
        (reported == digest(question, answers)).then_some(CacheLine {
            whole,
            question,
            answers,
        })
    }
}

fn digest(question: &str, answers: &str) -> String {
    Digest::new("line of a cache")
        .text(question)
        .text(answers)
        .finish()
}

#[cfg(test)]
mod tests {
    use super::{CacheLine, written};

    #[test]
    fn a_line_is_read_as_it_was_written_or_not_at_all() {
        let line = written("question", "{\"an\": \"answer\"}");
        let whole = line.strip_suffix('\n').unwrap();
        let (question, answers) = ("question", "{\"an\": \"answer\"}");
        let read = CacheLine {
            whole,
            question,
            answers,
        };
        assert_eq!(CacheLine::read(whole), Some(read));
        for end in 0..whole.len() {
            assert_eq!(CacheLine::read(&whole[..end]), None);
        }
        assert_eq!(CacheLine::read(&whole.replace("answer\"}", "anserw\"}")), None);
        assert_eq!(CacheLine::read(&format!("{}{whole}", &whole[..20])), None);
    }
}
