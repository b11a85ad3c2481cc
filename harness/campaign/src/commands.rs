//! ReproductionCommands that see a finding again, to be pasted into a shell.

use crate::finding::Finding;
use crate::inputs::Inputs;
use std::path::PathBuf;
use stickler_engines::shell_quote;
use stickler_types::DialectName;

/// The parts from which the commands of a campaign are written.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
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
    pub fn of(&self, finding: &Finding) -> Vec<String> {
        let option = |name: &str, value: &str| format!(" {name} {}", shell_quote(value));
        let engines: String = self.engines.iter().map(|name| option("--engine", name)).collect();
        let folder = self.folder.join(&finding.id);
        let again = format!(
            "{} fuzz --replay {}{engines}",
            self.program,
            shell_quote(&folder.to_string_lossy())
        );
        let mut find = format!(
            "{} fuzz --seed {} --first {} --count 1{engines}",
            self.program, finding.origin.seed, finding.origin.place
        );
        let dialects = self
            .dialects
            .iter()
            .map(|dialect| format!(" --dialect {dialect}"));
        find.extend(dialects.chain(self.targets.iter().map(|target| format!(" --target {target}"))));
        if !self.without.is_empty() {
            find += &option("--without", &self.without.join(","));
        }
        if !self.engines.is_empty() {
            // What it would find is named already.
            find += " --no-survey";
            if self.max_input != Inputs::MAX_LEN {
                find += &format!(" --max-input {}", self.max_input);
            }
        }
        if finding.origin.open {
            find += " --open";
        }
        vec![again, find]
    }
}
