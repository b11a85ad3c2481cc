//! Groups of cases with common properties, which a report writes once per group.

use crate::observations::probe;
use indexmap::IndexSet;
use serde::{Deserialize, Serialize};
use stickler_run::{CaseEvent, Grade};

/// The common properties of the cases of a group.
#[derive(Clone, PartialEq, Eq, Hash, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub(crate) struct Group {
    /// The beginning that the ids of the group's cases share: a case file and a probe, such as
    /// `widening/integer::assignment`.
    pub(crate) id: String,
    /// The dialect of the cases.
    pub(crate) dialect: String,
    /// The name of the engine.
    pub(crate) engine: String,
    /// The title of the cases.
    pub(crate) title: String,
    /// The claim of the cases: source and section.
    pub(crate) basis: String,
    /// The path of the case file.
    pub(crate) file: String,
    /// The area of the cases.
    pub(crate) area: String,
    /// Whether the document leaves the result open.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub(crate) open: bool,
    /// The grade of a rejection or a fault.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) grade: Option<Grade>,
}

impl Group {
    fn of(case: &CaseEvent) -> Group {
        Group {
            id: probe(&case.id).to_owned(),
            dialect: case.dialect.clone(),
            engine: case.engine.clone(),
            title: case.title.clone(),
            basis: case.basis.clone(),
            file: case.file.clone(),
            area: case.area.clone(),
            open: case.open,
            grade: case.grade,
        }
    }

    /// Returns the arguments of the probe in the id of a case: `(SINT,INT,-128)`, or an empty text.
    pub(crate) fn arguments(id: &str) -> &str {
        &id[probe(id).len()..]
    }
}

/// The number of a group in [`Groups`].
pub(crate) type GroupNumber = usize;

/// The groups of a run, numbered in the order of their first cases.
#[derive(Default)]
pub(crate) struct Groups {
    all: IndexSet<Group>,
}

impl Groups {
    /// Returns the number of the group of a case, and whether the group is new.
    pub(crate) fn number(&mut self, case: &CaseEvent) -> (GroupNumber, bool) {
        self.all.insert_full(Group::of(case))
    }

    /// Returns the group of this number.
    pub(crate) fn of_number(&self, number: GroupNumber) -> &Group {
        &self.all[number]
    }

    /// Returns all groups in the order of their numbers.
    pub(crate) fn all(&self) -> impl Iterator<Item = &Group> {
        self.all.iter()
    }
}

#[cfg(test)]
mod tests {
    use super::{Group, Groups};
    use crate::sample;
    use stickler_run::{CaseEvent, Verdict};

    #[test]
    fn cases_that_differ_in_nothing_but_their_arguments_are_one_group() {
        let case = |id: &str| sample::case(id, Verdict::Pass);
        let other = CaseEvent {
            basis: "other".to_owned(),
            ..case("a::p(3)")
        };
        let mut groups = Groups::default();
        let numbers = [
            case("a::p(1)"),
            case("a::p(2)"),
            case("a::q(1)"),
            other,
            case("a::p(4)"),
        ];
        let numbers = numbers.map(|case| groups.number(&case));
        assert_eq!(numbers, [(0, true), (0, false), (1, true), (2, true), (0, false)]);
        assert_eq!(groups.of_number(1).id, "widening/a::q");
        assert_eq!(Group::arguments("a::p(1,(2))"), "(1,(2))");
        assert_eq!(Group::arguments("a"), "");
    }
}
