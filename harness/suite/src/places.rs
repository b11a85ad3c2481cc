//! The places of a program in which a value can stand: sources, targets and surroundings, from `places.toml`.
//!
//! A probe with `places` has no program of its own: [`compose`] puts one together of a source, a target and a surrounding, and
//! [`Design`] says which of the combinations a cell or a row takes.

mod compose;
mod design;
mod read;

use crate::error::suggestion;
use std::sync::Arc;

use serde::Deserialize;
use stickler_types::{DialectName, words};
use toml::Spanned;

use crate::condition::Condition;
use crate::toml_text::Strings;
pub(crate) use compose::{Wording, compose};
pub(crate) use design::{Arrangement, Design};
pub(crate) use read::read;

/// The names that the condition of a place may test.
const TESTED: [&str; 2] = ["from", "to"];

/// The places that tables may use, in the order of the file.
#[derive(Clone, Debug, Default)]
pub struct Places {
    sources: Vec<ProgramPlace>,
    targets: Vec<ProgramPlace>,
    surroundings: Vec<ProgramPlace>,
    units: Vec<PlaceUnit>,
    /// The configuration of a program that has global variables.
    configuration: String,
    /// The combinations of source, target and surrounding that no probe takes, because tables ask the same with programs of their own.
    plain: Vec<[usize; 3]>,
}

words! {
    /// The part that a place has in a program, with its name in `places.toml`.
    Role {
        /// The place where a value comes from.
        Source = "source",
        /// The place where a value goes to.
        Target = "target",
        /// The statement or the body that is around both.
        Surrounding = "surrounding",
    }
}

/// One place. A text that it does not have is empty.
#[derive(Clone, Debug)]
pub struct ProgramPlace {
    name: Arc<str>,
    key: PlaceKey,
    /// The dialects whose documents promise the place, or for which the standard does.
    dialects: Vec<DialectName>,
    /// The dialects whose documents only say what the place does not take, so that its programs claim rejections alone; each is one of
    /// `dialects`.
    only_rejected: Vec<DialectName>,
    /// The types for which the place exists.
    only: Condition,
    /// The units in whose bodies the place may stand, by index.
    units: Vec<usize>,
    /// Whether the value meets the type of the target in the statement of the target, and not in a declaration.
    is_in_its_statement: bool,
    /// Whether the source goes to a parameter of its own type, and from there to the target.
    is_behind_a_parameter: bool,
}

/// A place as `places.toml` has it.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
struct PlaceKey {
    /// A description for a person.
    title: String,
    /// The sections of sources that promise the place.
    promised: Strings,
    absent: Option<Vec<Spanned<String>>>,
    only_rejected: Option<Vec<Spanned<String>>>,
    /// Whether the place stands only in probes that name it or a group of it.
    only_named: bool,
    only: Option<Spanned<String>>,
    units: Option<Vec<Spanned<String>>>,
    groups: Vec<String>,
    /// Whether a source is a literal, or a target takes nothing else.
    literal: bool,
    /// Whether a source is a call, which has a code of its own where it does not fit.
    call: bool,
    code: String,
    call_code: String,
    value: String,
    target: String,
    observe: String,
    declarations: String,
    parameters: String,
    variables: String,
    sections: String,
    globals: String,
    before: String,
    statement: String,
    after: String,
    caller: String,
    arguments: String,
}

/// A program organization unit in whose body places can stand.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct PlaceUnit {
    text: String,
    observe: String,
    #[serde(default)]
    parameters: String,
    #[serde(default)]
    arguments: String,
}

/// The names of the places of which the program of a case is put together.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Placement {
    /// The place that the value comes from: `array-element`.
    pub source: Arc<str>,
    /// The place that the value goes to: `argument`.
    pub target: Arc<str>,
    /// The statement or the body around both: `if`.
    pub surrounding: Arc<str>,
}

impl Placement {
    /// Returns the names of source, target and surrounding, as the id of a case has them.
    pub(crate) fn names(&self) -> [&str; 3] {
        [&self.source, &self.target, &self.surrounding]
    }
}

impl Places {
    /// Returns the places of a role, in the order of the file.
    pub fn of(&self, role: Role) -> &[ProgramPlace] {
        match role {
            Role::Source => &self.sources,
            Role::Target => &self.targets,
            Role::Surrounding => &self.surroundings,
        }
    }

    /// Returns the places with this name or in this group, by index.
    ///
    /// # Errors
    /// A message that names the nearest name, if there is no such place.
    pub(crate) fn find(&self, role: Role, name: &str) -> Result<Vec<usize>, String> {
        let places = self.of(role);
        let found: Vec<usize> = (0..places.len())
            .filter(|&index| places[index].is(name))
            .collect();
        if found.is_empty() {
            let groups = places
                .iter()
                .flat_map(|place| &place.key.groups)
                .map(String::as_str);
            let known = places.iter().map(|place| &*place.name).chain(groups);
            let role = role.as_str();
            return Err(format!("no {role} `{name}`; {}", suggestion(name, known)));
        }
        Ok(found)
    }

    /// Returns the places of a role that a probe has without naming them, by index.
    pub(crate) fn unnamed(&self, role: Role) -> Vec<usize> {
        let places = self.of(role);
        (0..places.len())
            .filter(|&index| !places[index].is_only_named())
            .collect()
    }

    /// Keeps the targets that take more than literals.
    pub(crate) fn retain_statements(&self, targets: &mut Vec<usize>) {
        targets.retain(|&target| !self.targets[target].key.literal);
    }

    /// Returns whether tables ask the same as an arrangement with programs of their own.
    fn is_plain(&self, arrangement: &Arrangement) -> bool {
        let places = [arrangement.source, arrangement.target, arrangement.surrounding];
        self.plain.contains(&places)
    }

    /// Returns the names of the places of an arrangement.
    pub(crate) fn placement(&self, arrangement: &Arrangement) -> Placement {
        let name = |role: Role, index: usize| Arc::clone(&self.of(role)[index].name);
        Placement {
            source: name(Role::Source, arrangement.source),
            target: name(Role::Target, arrangement.target),
            surrounding: name(Role::Surrounding, arrangement.surrounding),
        }
    }
}

impl ProgramPlace {
    /// Returns the name of the place.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Returns whether the place stands only in probes that name it or a group of it.
    pub fn is_only_named(&self) -> bool {
        self.key.only_named
    }

    /// Returns the bases that promise the place.
    pub fn promises(&self) -> impl Iterator<Item = &str> {
        self.key.promised.0.iter().map(|basis| basis.get_ref().as_str())
    }

    /// Returns whether a source is a literal, or a target takes nothing else.
    pub fn is_literal(&self) -> bool {
        self.key.literal
    }

    /// Returns whether a target takes its value from a parameter of the value's own type, so that a variable stands there whatever goes to
    /// the parameter.
    pub fn is_behind_a_parameter(&self) -> bool {
        self.is_behind_a_parameter
    }

    /// Returns whether the place is in a group of this name.
    pub fn is_in(&self, group: &str) -> bool {
        self.key.groups.iter().any(|name| name == group)
    }

    fn is(&self, name: &str) -> bool {
        *self.name == *name || self.is_in(name)
    }

    /// Returns whether a surrounding is the body of a unit and no statement.
    fn is_a_body(&self) -> bool {
        self.key.statement == "{statement}"
    }

    /// Returns whether a dialect has the place for values that go from one type to another, in programs that claim a rejection if
    /// `rejected`, and in others if not.
    pub fn stands(&self, dialect: DialectName, (from, to): (&str, &str), rejected: bool) -> bool {
        self.is_promised(dialect, rejected) && self.only.holds(&[from, to])
    }

    /// Returns whether a document promises the place in a dialect, for programs that claim a rejection if `rejected`.
    fn is_promised(&self, dialect: DialectName, rejected: bool) -> bool {
        self.dialects.contains(&dialect) && (rejected || !self.only_rejected.contains(&dialect))
    }
}
