//! The cases that passed, and the observations, by probe: arguments are keys, and dialects that have the same cases share
//! them.

use super::JsonList;
use super::document::{ActualFacts, ByArguments, ObservedResult, PassedResult};
use crate::groups::{Group, GroupNumber, Groups};
use std::borrow::Cow;
use std::collections::{BTreeMap, HashMap};
use stickler_run::{CaseEvent, Fact, Verdict};

/// The cases that passed, and the observations of all cases, by group.
#[derive(Default)]
pub(super) struct Passed {
    groups: Vec<GroupCases>,
}

/// The cases of one group, each by its arguments.
#[derive(Default)]
struct GroupCases {
    durations_us: ValuesByArguments<u64>,
    got: ValuesByArguments<Vec<Fact>>,
    observed: BTreeMap<String, ValuesByArguments<String>>,
}

/// Values of cases by their arguments, in the order of the run.
type ValuesByArguments<T> = Vec<(Box<str>, T)>;

impl Passed {
    /// Adds a case.
    pub(super) fn take(&mut self, case: &CaseEvent, group: GroupNumber) {
        if self.groups.len() <= group {
            self.groups.resize_with(group + 1, GroupCases::default);
        }
        let group = &mut self.groups[group];
        let arguments = Group::arguments(&case.id);
        if case.verdict == Verdict::Pass {
            group.durations_us.push((arguments.into(), case.duration_us));
            if !case.got.is_empty() {
                group.got.push((arguments.into(), case.got.clone()));
            }
        }
        for observed in &case.observations {
            let values = group.observed.entry(observed.name.clone()).or_default();
            values.push((arguments.into(), observed.value.clone()));
        }
    }

    /// Returns the list of cases that passed.
    ///
    /// # Errors
    /// Returns the error of serde_json.
    pub(super) fn list(&self, groups: &Groups) -> serde_json::Result<JsonList> {
        let mut list = JsonList::default();
        for probe in probes(groups.all()) {
            let of = |member: &usize| self.groups.get(*member).map(|cases| &cases.durations_us);
            for shared in shared(&probe.members, of) {
                let dialects = shared.dialects(groups);
                let group = probe.group;
                list.push(&PassedResult {
                    id: Cow::Borrowed(&group.id),
                    engine: Cow::Borrowed(&group.engine),
                    dialects,
                    title: Cow::Borrowed(&group.title),
                    basis: Cow::Borrowed(&group.basis),
                    file: Cow::Borrowed(&group.file),
                    area: Cow::Borrowed(&group.area),
                    open: group.open,
                    grade: group.grade,
                    got: self.got(&shared, groups),
                    duration_us: shared.by_arguments(|duration| *duration),
                })?;
            }
        }
        Ok(list)
    }

    /// Returns the actual facts of those cases whose expectation and observations do not imply them, by arguments and
    /// dialect.
    fn got<'a>(&'a self, shared: &SharedCases<'a, u64>, groups: &'a Groups) -> ActualFacts<'a> {
        let mut all = ActualFacts::new();
        let is_here: HashMap<&str, ()> = shared
            .cases
            .iter()
            .map(|(arguments, _)| (*arguments, ()))
            .collect();
        for &member in &shared.members {
            for (arguments, got) in self.groups.get(member).iter().flat_map(|cases| &cases.got) {
                if is_here.contains_key(&**arguments) {
                    let by_dialect = all.entry(Cow::Borrowed(arguments)).or_default();
                    let dialect = &groups.all()[member].dialect;
                    by_dialect.insert(Cow::Borrowed(dialect), Cow::Borrowed(got));
                }
            }
        }
        all
    }

    /// Returns the list of observations.
    ///
    /// # Errors
    /// Returns the error of serde_json.
    pub(super) fn observations(&self, groups: &Groups) -> serde_json::Result<JsonList> {
        let mut list = JsonList::default();
        for probe in probes(groups.all()) {
            let members = probe.members.iter().filter_map(|&member| self.groups.get(member));
            let mut names: Vec<&String> = members.flat_map(|cases| cases.observed.keys()).collect();
            names.sort_unstable();
            names.dedup();
            for name in names {
                let of = |member: &usize| self.groups.get(*member)?.observed.get(name);
                for shared in shared(&probe.members, of) {
                    list.push(&ObservedResult {
                        id: Cow::Borrowed(&probe.group.id),
                        engine: Cow::Borrowed(&probe.group.engine),
                        dialects: shared.dialects(groups),
                        name: Cow::Borrowed(name),
                        values: shared.by_arguments(|value| Cow::Borrowed(value.as_str())),
                    })?;
                }
            }
        }
        Ok(list)
    }
}

/// The groups that differ in nothing but the dialect.
struct ProbeGroups<'g> {
    /// The first of the groups, which stands for all but their dialects.
    group: &'g Group,
    members: Vec<GroupNumber>,
}

/// Joins groups that differ in nothing but the dialect, in the order of the run.
fn probes(groups: &[Group]) -> Vec<ProbeGroups<'_>> {
    let mut places: HashMap<Group, usize> = HashMap::new();
    let mut probes: Vec<ProbeGroups<'_>> = Vec::new();
    for (number, group) in groups.iter().enumerate() {
        let in_any_dialect = Group {
            dialect: String::new(),
            ..group.clone()
        };
        let place = *places.entry(in_any_dialect).or_insert(probes.len());
        match probes.get_mut(place) {
            Some(probe) => probe.members.push(number),
            None => probes.push(ProbeGroups {
                group,
                members: vec![number],
            }),
        }
    }
    probes
}

/// The cases that several groups share, each with its value in each of these groups.
struct SharedCases<'a, T> {
    members: Vec<GroupNumber>,
    cases: Vec<(&'a str, Vec<&'a T>)>,
}

impl<'a, T> SharedCases<'a, T> {
    fn dialects<'g>(&self, groups: &'g Groups) -> Vec<Cow<'g, str>> {
        let dialect = |&member: &GroupNumber| Cow::Borrowed(groups.all()[member].dialect.as_str());
        self.members.iter().map(dialect).collect()
    }

    fn by_arguments<V>(&self, value: impl Fn(&'a T) -> V) -> ByArguments<'a, V> {
        let cases = self.cases.iter().map(|(arguments, known)| {
            let values = known.iter().map(|known| value(known)).collect();
            (Cow::Borrowed(*arguments), values)
        });
        ByArguments(cases.collect())
    }
}

/// Joins the entries of several groups by their arguments, and makes one list of those that occur in the same groups.
fn shared<'a, T: 'a>(
    members: &[GroupNumber],
    of: impl Fn(&GroupNumber) -> Option<&'a ValuesByArguments<T>>,
) -> Vec<SharedCases<'a, T>> {
    let mut places: HashMap<&str, usize> = HashMap::new();
    let mut cases: Vec<(&str, Vec<GroupNumber>, Vec<&T>)> = Vec::new();
    for member in members {
        for (arguments, known) in of(member).into_iter().flatten() {
            let place = *places.entry(arguments).or_insert(cases.len());
            if place == cases.len() {
                cases.push((arguments, Vec::new(), Vec::new()));
            }
            cases[place].1.push(*member);
            cases[place].2.push(known);
        }
    }
    let mut lists: Vec<SharedCases<'a, T>> = Vec::new();
    for (arguments, members, known) in cases {
        let place = lists.iter().position(|list| list.members == members);
        let place = place.unwrap_or_else(|| {
            let cases = Vec::new();
            lists.push(SharedCases { members, cases });
            lists.len() - 1
        });
        lists[place].cases.push((arguments, known));
    }
    lists
}
