//! Lints the sources as a whole: mistakes that only a reader of all cases would notice.

use std::collections::BTreeSet;

use super::{Source, SourceKind, Sources};
use crate::error::{CaseFileError, Mistake};
use crate::near::suggestion;

impl Sources {
    /// Returns a warning for each source and each rule that none of these bases names.
    pub(crate) fn unused<'b>(&self, bases: impl Iterator<Item = &'b str>) -> Vec<CaseFileError> {
        let cited: BTreeSet<&str> = bases.collect();
        let is_cited = |source: &Source| {
            cited
                .iter()
                .any(|basis| self.of(basis).is_some_and(|(found, _)| found.key == source.key))
        };
        let mut warnings = Vec::new();
        for source in &self.sources {
            if source.kind == SourceKind::Rule {
                let unused = source.sections.headings.iter().filter(|(rule, _)| {
                    let basis = format!("{}: {rule}", source.key);
                    !cited.contains(basis.as_str())
                });
                let warning = |(rule, line): &(String, u32)| {
                    let message = format!("no case rests on the rule `{rule}`");
                    Mistake::new(*line, message)
                        .hint("take it out")
                        .in_file(&self.rules)
                };
                warnings.extend(unused.map(warning));
            } else if !source.is_built_in() && !is_cited(source) {
                let mistake = Mistake::new(source.line, "no case cites the source").key(source.key.clone());
                warnings.push(mistake.hint("take it out").in_file(&self.file));
            }
        }
        warnings
    }

    /// Returns a mistake for each engine of a source that is not one of the `known` engines.
    #[must_use]
    pub fn unknown_engines(&self, known: &[&str]) -> Vec<CaseFileError> {
        let mut mistakes = Vec::new();
        for source in &self.sources {
            for engine in source
                .engines
                .iter()
                .filter(|engine| !known.contains(&engine.as_str()))
            {
                let reported = suggestion(engine, known.iter().copied());
                let message = format!("no built-in engine `{engine}`; {reported}");
                mistakes.push(
                    Mistake::new(source.line, message)
                        .key(source.key.clone())
                        .in_file(&self.file),
                );
            }
        }
        mistakes
    }
}
