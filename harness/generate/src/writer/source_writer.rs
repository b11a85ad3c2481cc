//! The text under construction: keywords in the case of the style, lines, indents, blanks with comments.

use super::{Keywords, Style};
use crate::model::{Pou, Program, Variable, VariableId};
use stickler_types::SplitMix64;

/// The text so far, and the state that determines its continuation.
pub(super) struct SourceWriter<'p> {
    pub program: &'p Program,
    /// The POU that is written; main, which writes nothing in types.
    pub pou: &'p Pou,
    pub style: Style,
    pub text: String,
    pub raw_lines: Vec<u32>,
    line: u32,
    indent: usize,
    /// The position in the random sequence of the style.
    random: SplitMix64,
}

/// The mean number of blanks between two comments.
const BLANKS_A_COMMENT: u64 = 12;

/// The texts of comments: things that a scanner may take for something else.
const COMMENTS: [&str; 8] = [
    "(**)",
    "(* END_IF; *)",
    "(* it's *)",
    "(* \" *)",
    "(*** x := 1; ***)",
    "(* // *)",
    "(* ( * ) *)",
    "(* two\nlines *)",
];

impl<'p> SourceWriter<'p> {
    pub fn new(program: &'p Program, style: Style) -> SourceWriter<'p> {
        SourceWriter {
            program,
            pou: &program.main,
            style,
            // A mean program has about this many bytes, so the text rarely moves.
            text: String::with_capacity(4096),
            raw_lines: Vec::new(),
            line: 1,
            indent: 0,
            random: SplitMix64::new(style.seed),
        }
    }

    /// Returns a variable of the POU.
    pub fn variable(&self, id: VariableId) -> Option<&'p Variable> {
        self.pou.variables.get(id.0)
    }

    /// Appends text unchanged.
    pub fn put(&mut self, text: &str) {
        self.text.push_str(text);
    }

    /// Appends a keyword, or a name that the language defines; given in upper case.
    pub fn word(&mut self, word: &str) {
        match self.style.keywords {
            Keywords::Upper => self.text.push_str(word),
            Keywords::Lower => self.text.extend(word.chars().map(|c| c.to_ascii_lowercase())),
            Keywords::Mixed => {
                let mut cases = self.next_random();
                for letter in word.chars() {
                    let upper = cases & 1 == 1;
                    cases = cases.rotate_right(1);
                    self.text.push(if upper {
                        letter
                    } else {
                        letter.to_ascii_lowercase()
                    });
                }
            }
        }
    }

    /// Appends a blank, or a comment, which separates tokens as a blank does.
    pub fn blank(&mut self) {
        if !self.style.comments || !self.next_random().is_multiple_of(BLANKS_A_COMMENT) {
            self.text.push(' ');
            return;
        }
        let chosen = self.next_random();
        if chosen & 1 == 0 {
            self.text.push(' ');
        }
        let which = (chosen >> 2) as usize % COMMENTS.len();
        for (number, line) in COMMENTS[which].split('\n').enumerate() {
            if number > 0 {
                self.end_line();
            }
            self.text.push_str(line);
        }
        if chosen & 2 == 0 {
            self.text.push(' ');
        }
    }

    /// Appends an infix operator or `:=` between blanks.
    pub fn between_blanks(&mut self, operator: &str) {
        self.blank();
        self.word(operator);
        self.blank();
    }

    /// Ends the line and indents the next one.
    pub fn new_line(&mut self) {
        self.end_line();
        for _ in 0..self.indent {
            self.text.push_str("    ");
        }
    }

    /// Begins a line that is indented one step more than the last.
    pub fn deeper(&mut self) {
        self.indent += 1;
    }

    /// Reduces the indent of the following lines by one step.
    pub fn shallower(&mut self) {
        self.indent = self.indent.saturating_sub(1);
    }

    /// Appends text that breaks a rule on purpose, and records the line on which it begins.
    pub fn raw(&mut self, text: &str) {
        self.raw_lines.push(self.line);
        for (number, line) in text.split('\n').enumerate() {
            if number > 0 {
                self.end_line();
            }
            self.text.push_str(line);
        }
    }

    fn end_line(&mut self) {
        self.text
            .push_str(if self.style.carriage_returns { "\r\n" } else { "\n" });
        self.line += 1;
    }

    /// Advances the random sequence of the style, which is independent of the bytes of the program.
    pub fn next_random(&mut self) -> u64 {
        self.random.draw()
    }
}
