//! ReproductionCommands that see a finding again, to be pasted into a shell.

use crate::finding::Finding;
use crate::inputs::Inputs;
use std::path::PathBuf;
use stickler_engines::shell_quote;
use stickler_types::DialectName;

/// The parts from which the commands of a campaign are written.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ReproductionCommands {
    /// The words that start Stickler where the reader is, such as `stickler`.
    pub program: String,
    /// The folder in which findings are kept.
    pub folder: PathBuf,
    /// The value of each `--engine`.
    pub engines: Vec<String>,
    /// The dialects that were asked for; none: those that the engines speak.
    pub dialects: Vec<DialectName>,
    /// The targets that were asked for; the place of an input says which of them judges it.
    pub targets: Vec<String>,
    /// The value of each `--without`, and the words for what a survey found.
    pub without: Vec<String>,
    /// The number of bytes of the largest inputs.
    pub max_input: usize,
}

impl ReproductionCommands {
    /// Returns two commands: the first judges the saved finding again, the second finds the original again.
    #[must_use]
    pub fn of(&self, finding: &Finding) -> Vec<String> {
        let mut again = format!("{} fuzz --replay ", self.program);
        again.push_str(&shell_quote(&self.folder.join(&finding.id).to_string_lossy()));
        let mut find = format!(
            "{} fuzz --seed {} --first {} --count 1",
            self.program, finding.origin.seed, finding.origin.place
        );
        for engine in &self.engines {
            for line in [&mut again, &mut find] {
                line.push_str(" --engine ");
                line.push_str(&shell_quote(engine));
            }
        }
        for dialect in &self.dialects {
            find.push_str(" --dialect ");
            find.push_str(dialect.as_str());
        }
        for target in &self.targets {
            find.push_str(" --target ");
            find.push_str(target);
        }
        if !self.without.is_empty() {
            find.push_str(" --without ");
            find.push_str(&shell_quote(&self.without.join(",")));
        }
        if !self.engines.is_empty() {
            // What it would find is named already.
            find.push_str(" --no-survey");
            if self.max_input != Inputs::MAX_LEN {
                find.push_str(&format!(" --max-input {}", self.max_input));
            }
        }
        if finding.origin.open {
            find.push_str(" --open");
        }
        vec![again, find]
    }
}
