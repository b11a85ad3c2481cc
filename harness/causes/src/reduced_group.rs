//! The groups of failing cases during a search: how small the program of each is, and which are asked about next.

use crate::essence::Essence;
use crate::failure_sign::Sign;
use crate::normal_form::Normal;
use crate::question::Questioner;
use crate::reduction::{LONG, Smallest, is_reducible};
use std::collections::{BTreeSet, HashMap, HashSet};
use stickler_run::{CaseEvent, Fact, Grade, Reduced, Symptom, Verdict};

/// The smallest program of a group, and its normal form.
pub(crate) struct ReducedGroup {
    pub(crate) smallest: Smallest,
    pub(crate) normal: Normal,
    /// Whether more questions may make the program smaller.
    pub(crate) is_open: bool,
    /// Whether the claim of its case does not bind the engine.
    pub(crate) differs: bool,
}

impl ReducedGroup {
    pub(crate) fn unreduced(event: &CaseEvent, sign: &Sign) -> ReducedGroup {
        let mut smallest = Smallest::unreduced(event, sign);
        // A program that must be rejected, and never ends, may be made smaller as one that is accepted.
        let is_mistake = event.expected.iter().any(|fact| fact.diagnostic().is_some());
        if is_reducible(&sign.symptom) || is_mistake && sign.symptom == Symptom::Hang {
            smallest.reduction = Reduced::Partly;
        }
        ReducedGroup {
            normal: Normal::unasked(&smallest),
            smallest,
            is_open: false,
            differs: event.verdict == Verdict::Differs,
        }
    }

    /// Returns how far the program is from one that was made small; less is better.
    pub(crate) fn distance(&self) -> (bool, usize) {
        let is_partly = self.smallest.reduction == Reduced::Partly;
        (is_partly, self.smallest.program.len())
    }

    /// Returns whether the program is so long that it waits for the others.
    pub(crate) fn is_long(&self) -> bool {
        self.smallest.program.len() > LONG
    }

    /// Removes the codes from the expected diagnostics where the engine is not asked for them.
    pub(crate) fn without_codes(mut self, basis: &str, asked: &Questioner<'_>) -> ReducedGroup {
        for deviation in [&mut self.smallest.deviation, &mut self.normal.deviation] {
            let codes = deviation.expected.iter();
            let codes = codes.filter_map(|fact| fact.diagnostic()?.registered_code());
            if asked.judge.plan.needed_for(asked.judge.engine, basis, codes) != Grade::Code {
                for fact in &mut deviation.expected {
                    if let Fact::Diagnostic(expected) | Fact::Warning(expected) = fact {
                        expected.code = None;
                    }
                }
            }
        }
        self
    }

    fn essence(&self) -> Essence {
        Essence::of(&self.smallest, &self.normal)
    }

    /// Returns the number of times that the engine was asked.
    pub(crate) fn questions(&self) -> u64 {
        self.smallest.questions + self.normal.questions
    }
}

/// The groups that are still to be asked about in a round, by their places among all.
pub(crate) struct OpenGroups {
    pub(crate) open: Vec<usize>,
    essences: HashMap<usize, (Essence, bool)>,
    /// The essences of the groups that are small already, and whether their claims do not bind the engine.
    pub(crate) small: BTreeSet<(Essence, bool)>,
    /// The open groups which one of these seems to explain: they wait for those that may show another cause.
    pub(crate) explained: HashSet<usize>,
}

impl OpenGroups {
    /// Returns the groups of a round, of all groups as they are so far.
    pub(crate) fn new(open: Vec<usize>, found: &[ReducedGroup]) -> OpenGroups {
        let essence = |at: &usize| (*at, (found[*at].essence(), found[*at].differs));
        let mut groups = OpenGroups {
            essences: open.iter().map(essence).collect(),
            open,
            small: BTreeSet::new(),
            explained: HashSet::new(),
        };
        groups.note(found.iter().enumerate());
        groups
    }

    /// Notes which of the open groups are explained by some that may be small now, each with its place among all. One that is open itself
    /// explains those behind it alone, so that the first of several is asked about before the last round.
    pub(crate) fn note<'g>(&mut self, found: impl IntoIterator<Item = (usize, &'g ReducedGroup)>) {
        let is_small = |(_, group): &(usize, &ReducedGroup)| group.smallest.reduction == Reduced::Smallest;
        for (place, group) in found.into_iter().filter(is_small) {
            let small = (group.essence(), group.differs);
            if !self.small.contains(&small) {
                let (essence, differs) = &small;
                let explains = |(other, other_differs): &(Essence, bool)| {
                    essence.explains(other) && (!differs || *other_differs)
                };
                let open = self.open.iter().copied();
                let open = open.filter(|at| !group.is_open || *at > place);
                self.explained
                    .extend(open.filter(|at| explains(&self.essences[at])));
                self.small.insert(small);
            }
        }
    }

    /// Returns the `number` groups to ask about next; `None` where none is left. Only in the last round what seems to be explained is
    /// asked about, in the end.
    pub(crate) fn next(
        &mut self,
        number: usize,
        is_last: bool,
        found: &[ReducedGroup],
    ) -> Option<Vec<usize>> {
        let explained = &self.explained;
        if !is_last {
            self.open.retain(|at| !explained.contains(at));
        }
        self.open
            .sort_by_key(|at| (found[*at].is_long(), explained.contains(at)));
        let next: Vec<usize> = self.open.drain(..number.min(self.open.len())).collect();
        (!next.is_empty()).then_some(next)
    }
}
