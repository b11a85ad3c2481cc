//! Saboteurs: engines that are the reference but for one claim, which they break in one place.

use super::analysis::Analysis;
use super::change::{self, SourceChange};
use super::claim::Rule;
use super::site::{Site, sites};
use std::fmt;
use stickler_engines::{ClosureEngine, Outcome, RunRequest, Session};
use stickler_reference::{self as reference, Limits};
use stickler_types::Dialect;
use stickler_types::{Diagnostic, DialectName, ElementaryType};

/// A rule that is broken in one place and kept everywhere else.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Saboteur {
    /// The rule.
    pub rule: Rule,
    /// The place.
    pub place: BrokenPlace,
}

/// The place in which a saboteur breaks its rule.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum BrokenPlace {
    /// The origin of a value.
    Source(&'static str),
    /// The destination of a value.
    Target(&'static str),
    /// The statement or body around.
    Surrounding(&'static str),
    /// One pair of types in one target.
    Cell(ElementaryType, ElementaryType, &'static str),
    /// One bit of one type.
    Bit(ElementaryType, u64),
}

impl Saboteur {
    /// Returns the saboteurs that break a rule at a site.
    pub fn of(site: &Site) -> impl Iterator<Item = Saboteur> {
        let rule = site.rule;
        let standing = site.standing;
        let places = [
            standing.source.map(BrokenPlace::Source),
            standing.target.map(BrokenPlace::Target),
            standing.surrounding.map(BrokenPlace::Surrounding),
            site.pair
                .zip(standing.target)
                .map(|((from, to), target)| BrokenPlace::Cell(from, to, target)),
            site.bit.map(|(of, index)| BrokenPlace::Bit(of, index)),
        ];
        places
            .into_iter()
            .flatten()
            .map(move |place| Saboteur { rule, place })
    }

    /// Returns the changes that the saboteur makes at sites of a program.
    fn changes(self, sites: &[Site]) -> Vec<&SourceChange> {
        let broken = |site: &&Site| Saboteur::of(site).any(|saboteur| saboteur == self);
        sites.iter().filter(broken).map(|site| &site.change).collect()
    }
}

impl fmt::Display for Saboteur {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} in {}", self.rule, self.place)
    }
}

impl fmt::Display for BrokenPlace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BrokenPlace::Source(name) => write!(f, "source.{name}"),
            BrokenPlace::Target(name) => write!(f, "target.{name}"),
            BrokenPlace::Surrounding(name) => write!(f, "surrounding.{name}"),
            BrokenPlace::Cell(from, to, target) => {
                write!(f, "target.{target} from {} to {}", from.name(), to.name())
            }
            BrokenPlace::Bit(of, index) => write!(f, "{}.{index}", of.name()),
        }
    }
}

impl Saboteur {
    /// Returns the reference with the claim of the saboteur broken in its place.
    #[must_use]
    pub fn engine(self) -> ClosureEngine<'static> {
        let mut engine = ClosureEngine::new(&self.to_string(), move |reference, request| {
            self.run(reference, request)
        });
        engine.render = Some(Box::new(move |dialect, source| self.render(dialect, source)));
        engine
    }

    /// Returns a program with the changes of the saboteur; `None` where it changes nothing.
    fn sabotaged(self, source: &str, dialect: DialectName, rendered: bool) -> Option<Analysis<'_>> {
        let mut analysis = Analysis::new(source, Dialect::of(dialect));
        let sites = sites(&analysis, rendered);
        let changes = self.changes(&sites);
        if changes.is_empty() {
            return None;
        }
        change::apply(&mut analysis, changes);
        Some(analysis)
    }

    fn run(self, unchanged: &mut dyn Session, request: &RunRequest<'_>) -> Outcome {
        let Some(analysis) = self.sabotaged(request.source, request.dialect, false) else {
            return unchanged.run(request);
        };
        if analysis.is_rejected() {
            return Outcome::rejected(located(analysis));
        }
        let outcome = match &analysis.program {
            Some(program) => reference::execute(program, request, Limits::default()),
            None => Ok(Outcome::ACCEPTED),
        };
        match outcome {
            Ok(outcome) => outcome.with_warnings(located(analysis)),
            Err(error) => Outcome::Error {
                message: error.to_string(),
            },
        }
    }

    fn render(self, dialect: DialectName, source: &str) -> Outcome {
        let rendered = match self.sabotaged(source, dialect, true) {
            Some(analysis) if !analysis.is_rejected() => Ok(stickler_syntax::render(&analysis.unit, source)),
            Some(analysis) if self.rule.refuses_rendering() => Err(located(analysis)),
            _ => reference::render(source, dialect),
        };
        match rendered {
            Ok(text) => Outcome::Rendered { text },
            Err(diagnostics) => Outcome::Rejected { diagnostics },
        }
    }
}

fn located(analysis: Analysis<'_>) -> Vec<Diagnostic> {
    reference::locate(analysis.diagnostics, analysis.source, &analysis.lines)
}
