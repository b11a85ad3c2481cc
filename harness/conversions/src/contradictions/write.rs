//! Contradictions as a text for a terminal.

use super::{Contradictions, Topic};
use std::io::{self, Write};
use stickler_types::{counted, shortened};

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
        match self.topics.len() {
            all if all == self.number => writeln!(out, "{topics} on {questions}."),
            shown => writeln!(
                out,
                "{topics} on {questions}; the {shown} largest are shown, --all shows all."
            ),
        }
    }
}

impl Topic {
    fn write(&self, number: usize, out: &mut dyn Write) -> io::Result<()> {
        let answers = counted(self.answers.len() as u64, "answer", "answers");
        let systems = counted(self.systems as u64, "system", "systems");
        writeln!(out, "{number}. {}", shortened(&self.question, MAX_CHARACTERS))?;
        write!(out, "   {}: {answers}, {systems}", self.kind)?;
        if let [first, ..] = &self.others[..] {
            let first = shortened(first, MAX_CHARACTERS);
            write!(
                out,
                "; the same sides on {} more, such as {first}",
                self.questions - 1
            )?;
        }
        writeln!(out)?;
        if let (Some(case), Some(_)) = (&self.case, &self.program) {
            writeln!(out, "   stickler show '{case}'")?;
        }
        for (answer, by) in &self.answers {
            writeln!(out, "   {}", shortened(answer, MAX_CHARACTERS))?;
            for origin in by {
                write!(out, "      {}: {} ", origin.system, origin.source)?;
                writeln!(
                    out,
                    "({}; {})\n        {}",
                    origin.kind, origin.read, origin.address
                )?;
            }
        }
        writeln!(out)
    }
}
