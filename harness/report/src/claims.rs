//! Claims: what each section of each document says, and how an engine stands to it. Every format leads with them,
//! and every format takes them from here.

use crate::overview::entry;
use std::collections::BTreeMap;
use stickler_run::{CaseEvent, Verdict};

/// How the cases of one claim stand. Every case counts once.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, serde::Serialize)]
pub struct Standing {
    /// The engine did what the document says (verdicts pass and xpass).
    pub passed: u64,
    /// It did something else, whether a baseline expects that or not, or it crashed, hung or made no sense.
    pub failed: u64,
    /// The document leaves it open: what the engine does was recorded, nothing was asserted.
    pub open: u64,
    /// The engine said that it cannot run the case.
    pub unsupported: u64,
}

impl Standing {
    /// All cases of the claim.
    pub const fn cases(self) -> u64 {
        self.passed + self.failed + self.open + self.unsupported
    }

    fn count(&mut self, event: &CaseEvent) {
        let counter = match event.verdict {
            Verdict::Pass if event.open => &mut self.open,
            Verdict::Pass | Verdict::Xpass => &mut self.passed,
            Verdict::Unsupported => &mut self.unsupported,
            Verdict::Fail | Verdict::Xfail | Verdict::Crash | Verdict::Timeout | Verdict::Error => {
                &mut self.failed
            }
        };
        *counter += 1;
    }

    fn add(&mut self, other: Standing) {
        self.passed += other.passed;
        self.failed += other.failed;
        self.open += other.open;
        self.unsupported += other.unsupported;
    }
}

/// One section of one document, as one engine meets it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Claim<'a> {
    /// The engine.
    pub engine: &'a str,
    /// The document, such as `ironplc-type-conversions`.
    pub source: &'a str,
    /// Its section, such as `Integer widening`; empty where a basis names a whole document.
    pub section: &'a str,
    /// How its cases stand.
    pub standing: Standing,
}

/// All claims of a run, by engine, document and section.
#[derive(Debug, Default)]
pub struct Claims {
    engines: BTreeMap<String, BTreeMap<String, Standing>>,
}

impl Claims {
    /// Counts one case.
    pub fn take(&mut self, event: &CaseEvent) {
        entry(entry(&mut self.engines, &event.engine), &event.basis).count(event);
    }

    /// Every claim, sorted by engine, document and section.
    pub fn iter(&self) -> impl Iterator<Item = Claim<'_>> {
        self.engines.iter().flat_map(|(engine, claims)| {
            claims.iter().map(move |(basis, standing)| {
                let (source, section) = split_basis(basis);
                Claim {
                    engine,
                    source,
                    section,
                    standing: *standing,
                }
            })
        })
    }

    /// The documents, each with the sum of its sections; sorted by engine and document.
    pub fn documents(&self) -> Vec<Claim<'_>> {
        let mut documents: Vec<Claim<'_>> = Vec::new();
        for claim in self.iter() {
            match documents.last_mut() {
                Some(last) if (last.engine, last.source) == (claim.engine, claim.source) => {
                    last.standing.add(claim.standing);
                }
                _ => documents.push(Claim { section: "", ..claim }),
            }
        }
        documents
    }
}

/// The document and the section that a `basis` names. Basis: section 3 of the design, `source: section`.
pub fn split_basis(basis: &str) -> (&str, &str) {
    match basis.split_once(':') {
        Some((source, section)) => (source.trim(), section.trim()),
        None => (basis.trim(), ""),
    }
}

#[cfg(test)]
mod tests {
    use super::{Claims, Standing, split_basis};
    use crate::sample;
    use stickler_run::Verdict;

    #[test]
    fn every_case_counts_once_under_its_section() {
        let mut claims = Claims::default();
        claims.take(&sample::case("a", Verdict::Pass));
        claims.take(&sample::case("b", Verdict::Fail));
        claims.take(&sample::case("c", Verdict::Crash));
        claims.take(&sample::case("d", Verdict::Unsupported));
        claims.take(&sample::open_case("e"));
        let standings: Vec<Standing> = claims.iter().map(|claim| claim.standing).collect();
        assert_eq!(
            standings,
            [Standing {
                passed: 1,
                failed: 2,
                open: 1,
                unsupported: 1
            }]
        );
        assert_eq!(standings[0].cases(), 5);
    }

    #[test]
    fn a_document_is_the_sum_of_its_sections() {
        let mut claims = Claims::default();
        for (basis, verdict) in [
            ("a: one", Verdict::Pass),
            ("a: two", Verdict::Fail),
            ("b: one", Verdict::Pass),
        ] {
            let mut event = sample::case("x", verdict);
            event.basis = basis.to_owned();
            claims.take(&event);
        }
        let documents = claims.documents();
        assert_eq!(
            documents.iter().map(|claim| claim.source).collect::<Vec<_>>(),
            ["a", "b"]
        );
        assert_eq!(
            documents[0].standing,
            Standing {
                passed: 1,
                failed: 1,
                ..Standing::default()
            }
        );
    }

    #[test]
    fn a_basis_is_a_document_and_a_section() {
        assert_eq!(split_basis("doc: A: B"), ("doc", "A: B"));
        assert_eq!(split_basis("doc"), ("doc", ""));
    }
}
