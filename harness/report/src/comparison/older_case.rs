//! Keeps what is compared of a case of the older run until the newer run comes to it.

use super::Kind;
use stickler_run::{CaseEvent, Fact, Verdict};
use stickler_types::join;

/// A case of the older run: its verdict, and the expected and the actual facts as texts. Of a case that passed, the log has neither.
pub(super) struct OlderCase {
    /// The verdict in the older run, as if there were no baseline.
    pub(super) verdict: Verdict,
    expectation: u32,
    expected: String,
    said: String,
}

/// The behavior of an engine that a verdict shows, whatever a baseline expects.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Behavior {
    Right,
    Wrong,
    /// The engine crashed or gave no answer in time.
    Dead,
    Unsupported,
}

impl OlderCase {
    /// Extracts the parts of a case that the comparison needs.
    pub(super) fn of(case: &CaseEvent) -> OlderCase {
        OlderCase {
            verdict: case.actual_verdict(),
            expectation: case.expectation,
            expected: Fact::text(&case.expected),
            said: said(case, None),
        }
    }

    /// Returns whether the expectation changed.
    pub(super) fn expects_otherwise(&self, case: &CaseEvent) -> bool {
        self.expectation != case.expectation
    }

    /// Returns how the case changed in the newer run; `None` where both results are alike. The message of a crash need not
    /// be the same twice.
    pub(super) fn change(&self, case: &CaseEvent) -> Option<Kind> {
        match (behavior(self.verdict), behavior(case.actual_verdict())) {
            (Behavior::Dead, Behavior::Dead) | (Behavior::Unsupported, Behavior::Unsupported) => None,
            (_, Behavior::Dead) => Some(Kind::Crashed),
            (Behavior::Right, Behavior::Wrong | Behavior::Unsupported) => Some(Kind::Broken),
            (_, Behavior::Right) if behavior(self.verdict) != Behavior::Right => Some(Kind::Fixed),
            // Where the expectation changed and the engine meets both, the suite changed and not the engine.
            (Behavior::Right, Behavior::Right) if self.expects_otherwise(case) => None,
            (before, now) if before == now && self.said == said(case, None) => None,
            _ => Some(Kind::Otherwise),
        }
    }

    /// Returns the text of the current expectation, from the run whose log contains it: a log does not for a case that
    /// passed.
    pub(super) fn expected_now(&self, case: &CaseEvent) -> Option<String> {
        let reported = match case.expected.is_empty() {
            false => Some(Fact::text(&case.expected)),
            true => Some(self.expected.clone()).filter(|_| !self.expects_otherwise(case)),
        };
        reported.filter(|text| !text.is_empty())
    }

    /// Returns the text of the older result, as far as it is known. `expected` is the text of the current expectation.
    pub(super) fn said(self, expected: Option<&str>, expectation_changed: bool) -> Option<String> {
        // Where the log says nothing, the engine met the expectation.
        let met = || expected.filter(|_| !expectation_changed).map(str::to_owned);
        Some(self.said).filter(|said| !said.is_empty()).or_else(met)
    }
}

fn behavior(verdict: Verdict) -> Behavior {
    match verdict {
        Verdict::Pass | Verdict::Xpass => Behavior::Right,
        Verdict::Fail | Verdict::Differs | Verdict::Xfail | Verdict::Error => Behavior::Wrong,
        Verdict::Crash | Verdict::Timeout => Behavior::Dead,
        Verdict::Unsupported | Verdict::Waiting => Behavior::Unsupported,
    }
}

/// Returns the result of a case, one fact a line: the actual facts and the observations. Where the log contains no actual
/// facts, they are the expected ones.
pub(super) fn said(case: &CaseEvent, expected: Option<&str>) -> String {
    let got = match case.got.is_empty() {
        true => expected.unwrap_or_default().to_owned(),
        false => Fact::text(&case.got),
    };
    let observed = case.observations.iter();
    let observed = observed.map(|observed| format!("{} = {}", observed.name, observed.value));
    let facts = std::iter::once(got).filter(|got| !got.is_empty()).chain(observed);
    join(facts, "\n")
}

#[cfg(test)]
mod tests {
    use super::OlderCase;
    use crate::comparison::Kind;
    use crate::sample;
    use stickler_mdtest::check_examples;
    use stickler_run::{BaselineNote, CaseEvent, Verdict};

    fn change(old: &CaseEvent, new: &CaseEvent) -> Option<Kind> {
        OlderCase::of(old).change(new)
    }

    #[test]
    fn golden_changes_of_verdicts() {
        check_examples("tests/changes.md", |example| {
            let case = |column: &str| {
                let verdict = Verdict::from_word(example.text(column)).expect("a verdict");
                sample::case("a", verdict)
            };
            let change = change(&case("old"), &case("new"));
            change.map_or("none".to_owned(), |kind| kind.to_string())
        });
    }

    #[test]
    fn a_crash_that_a_baseline_expects_is_still_a_crash() {
        let note = BaselineNote {
            verdict: Verdict::Crash,
            ..BaselineNote::default()
        };
        let crash = CaseEvent {
            baseline: Some(note),
            ..sample::case("a", Verdict::Xfail)
        };
        let crashed = Some(Kind::Crashed);
        assert_eq!(change(&sample::case("a", Verdict::Fail), &crash), crashed);
        assert_eq!(change(&sample::case("a", Verdict::Crash), &crash), None);
    }

    #[test]
    fn another_wrong_value_and_another_observation_are_told() {
        let wrong = sample::case("a", Verdict::Fail);
        let otherwise = CaseEvent {
            got: vec![sample::value("into", "INT#0")],
            ..wrong.clone()
        };
        assert_eq!(change(&wrong, &otherwise), Some(Kind::Otherwise));
        let open = sample::open_case("a");
        let mut observed = open.clone();
        observed.observations[0].value = "INT#2".to_owned();
        assert_eq!(change(&open, &open), None);
        assert_eq!(change(&open, &observed), Some(Kind::Otherwise));
    }

    #[test]
    fn a_case_that_expects_something_else_and_gets_it_is_alike() {
        let old = sample::case("a", Verdict::Pass);
        let new = CaseEvent {
            expectation: old.expectation + 1,
            ..old.clone()
        };
        assert_eq!(change(&old, &new), None);
        assert!(OlderCase::of(&old).expects_otherwise(&new));
        assert_eq!(
            OlderCase::of(&old).said(None, true),
            None,
            "what was expected then is not known"
        );
    }
}
