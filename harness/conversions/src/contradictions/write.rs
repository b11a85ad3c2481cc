//! Contradictions as a text for a terminal.

use super::{AnswerOrigin, Contradictions, Topic};
use std::io::{self, Write};
use stickler_types::{counted, grouped, shortened};

/// The maximum number of characters of a question or an answer in a line.
const MAX_CHARACTERS: usize = 100;

impl Contradictions {
    /// Writes the topics, and how many there are.
    ///
    /// # Errors
    /// Errors of writing to `out`.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        for (number, topic) in (1..).zip(&self.topics) {
            topic.write(number, out)?;
        }
        let topics = counted(self.number as u64, "contradiction", "contradictions");
        let questions = counted(self.questions as u64, "question", "questions");
        write!(out, "{topics} on {questions}")?;
        match self.topics.len() {
            shown if shown < self.number => {
                writeln!(out, "; the {} largest are shown.", grouped(shown as u64))
            }
            _ => writeln!(out, "."),
        }
    }
}

impl Topic {
    fn write(&self, number: usize, out: &mut dyn Write) -> io::Result<()> {
        writeln!(out, "{number}. {}", shortened(&self.question, MAX_CHARACTERS))?;
        let answers = counted(self.answers.len() as u64, "answer", "answers");
        let systems = counted(self.systems as u64, "system", "systems");
        write!(out, "   {}: {answers}, {systems}", self.kind)?;
        if let [first, ..] = &self.others[..] {
            let more = counted(self.questions as u64 - 1, "question", "questions");
            write!(
                out,
                "; the same sides on {more} more, such as {}",
                shortened(first, MAX_CHARACTERS)
            )?;
        }
        writeln!(out)?;
        if let (Some(case), Some(_)) = (&self.case, &self.program) {
            writeln!(out, "   stickler show '{case}'")?;
        }
        for answer in &self.answers {
            writeln!(out, "   {}", shortened(&answer.answer, MAX_CHARACTERS))?;
            for origin in &answer.by {
                writeln!(out, "      {}", origin.describe())?;
                writeln!(out, "        {}", origin.address)?;
            }
        }
        writeln!(out)
    }
}

impl AnswerOrigin {
    /// Returns the system with its source in a line: `TwinCAT: twincat-pages: 9007201783809931 (document, November 2026)`.
    fn describe(&self) -> String {
        let AnswerOrigin {
            system,
            kind,
            source,
            read,
            ..
        } = self;
        match &self.publisher {
            Some(publisher) => format!("{system}: {source} ({kind} of {publisher}; {read})"),
            None => format!("{system}: {source} ({kind}; {read})"),
        }
    }
}
