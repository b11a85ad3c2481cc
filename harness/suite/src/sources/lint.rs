//! Lints the sources as a whole: mistakes that only a reader of all cases would notice.

use std::collections::{BTreeSet, HashMap};

use super::{Source, SourceKind, Sources};
use crate::error::{CaseFileError, Mistake, suggestion};
use crate::{Case, Feature, Suite};
use stickler_types::{Question, Value};

impl Sources {
    /// Returns a warning for each source and each rule that no case and no statement of a suite names, for each contradiction of what neither a
    /// case claims nor a source promises of a feature, for each that is [not declared](Self::contradicted_in_silence), and for each printed example
    /// [without a case](Self::without_case).
    pub(crate) fn unused(&self, suite: &Suite) -> Vec<CaseFileError> {
        let (cases, features) = (&suite.cases, &suite.features);
        let mut cited: BTreeSet<&str> = cases.iter().map(|case| &*case.basis).collect();
        cited.extend(suite.statements.iter().map(|stated| stated.basis.as_str()));
        let is_cited = |source: &Source| {
            cited
                .iter()
                .any(|basis| self.of(basis).is_some_and(|(found, _)| found.key == source.key))
        };
        let mut warnings = self.without_case(cases, &cited);
        warnings.extend(self.contradicted_in_silence(cases));
        for source in &self.sources {
            for contradiction in &source.contradicts {
                let is_claimed = |case: &Case| contradiction.is_of(&case.basis, (&case.id, &case.source));
                // What promises a feature is cited of cases that use it, too.
                let is_promised = |feature: &Feature| {
                    let mut promises = feature.promises();
                    promises.any(|basis| {
                        let is_shown = |case: &Case| {
                            contradiction.is_of(basis, (&case.id, &case.source))
                                && case.features().contains(&*feature.key)
                        };
                        contradiction.is_of(basis, ("", &feature.program)) || cases.iter().any(is_shown)
                    })
                };
                // What a source says of a symptom, the page of a cause claims.
                let is_told = |claim: &String| self.of(claim).is_some_and(|(of, _)| !of.symptoms.is_empty());
                let is_needed = cases.iter().any(is_claimed)
                    || features.iter().any(is_promised)
                    || contradiction.claims.iter().any(is_told);
                if !is_needed {
                    let message = format!("`{}` contradicts what no case claims", contradiction.section);
                    let mistake = Mistake::new(source.line, message).key(source.key.clone());
                    warnings.push(mistake.in_file(&self.file));
                }
            }
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
            } else if !source.is_built_in()
                && !is_cited(source)
                && source.contradicts.is_empty()
                && source.printed.is_empty()
                && source.symptoms.is_empty()
            {
                let mistake = Mistake::new(source.line, "no case cites the source").key(source.key.clone());
                warnings.push(mistake.hint("take it out").in_file(&self.file));
            }
        }
        warnings
    }

    /// Returns a warning for each case that gives a call another value than one before it in the same dialect, by sources of one publisher of which
    /// none says that it [contradicts](Source::contradicts) the other.
    fn contradicted_in_silence(&self, cases: &[Case]) -> Vec<CaseFileError> {
        let mut firsts: HashMap<_, (&Case, &Value)> = HashMap::new();
        let mut warnings = Vec::new();
        for case in cases {
            // Of other questions the text does not say which value is given.
            if let Some(question @ Question::Call(_)) = case.question.as_deref()
                && let ([expected], None) = (&case.expectation.values[..], &case.placement)
            {
                let key = (case.dialect, question.to_string());
                let (first, other) = *firsts.entry(key).or_insert((case, &expected.value));
                let of = [first, case].map(|case| self.of(&case.basis).map(|(source, _)| source));
                let says_so = |source: &Source, of: &Case| {
                    let mut claims = source.contradicts.iter();
                    claims.any(|claims| claims.is_of(&of.basis, (&of.id, &of.source)))
                };
                if let [Some(one), Some(two)] = of
                    && *other != expected.value
                    && one.publisher == two.publisher
                    && !says_so(one, case)
                    && !says_so(two, first)
                {
                    let (value, basis, maker) = (&expected.value, &case.basis, &one.publisher);
                    let other = format!("{other} by {} ({}:{})", first.basis, first.file, first.line);
                    let advice = format!("take one out, or say so in `[[{}.contradicts]]`", two.key);
                    let message =
                        format!("`{question}` is {value} by {basis}, and {other}, both of {maker}; {advice}");
                    warnings.push(Mistake::new(case.line, message).key("basis").in_file(&case.file));
                }
            }
        }
        warnings
    }

    /// Returns a mistake for each engine of a source that is not one of the `known` engines.
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
