//! The lines of a log: the content of each kind, and the conversion between events and lines.

use crate::LogError;
use crate::groups::{Group, GroupNumber};
use crate::text::kept;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use stickler_run::{BaselineNote, CaseEvent, Cause, Event, Fact, Footer, Header, Observed, Verdict};
use stickler_types::Question;

/// A line of an event log. Readers ignore keys that they do not know.
#[cfg(test)]
#[derive(schemars::JsonSchema)]
#[schemars(untagged)]
#[expect(
    dead_code,
    reason = "each kind of line is written by itself; only the schema is made of this type"
)]
pub(crate) enum LogLine<'r> {
    Run(RunLine<'r>),
    Passed(PassedLine<'r>),
    Case(CaseObject<'r>),
}

/// A line that is not about a case, to be written.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(tag = "type", rename_all = "lowercase")]
pub(crate) enum RunLine<'r> {
    /// The first line.
    Header(&'r Header),
    /// The common properties of the cases of a group, before the first of them.
    Group(GroupLine<'r>),
    /// A cause of failing cases, after all cases.
    Cause(&'r Cause),
    /// The last line of a complete run.
    Footer(&'r Footer),
}

/// A group and the number by which the lines of its cases name it.
#[derive(Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub(crate) struct GroupLine<'r> {
    /// The number of the group, from 0.
    number: GroupNumber,
    /// The common properties.
    group: Cow<'r, Group>,
}

/// An object about a case. Properties that it leaves out are empty or unknown.
#[derive(Default, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub(crate) struct CaseObject<'r> {
    /// The verdict.
    #[serde(rename = "type")]
    verdict: Verdict,
    /// The number of the group.
    group: GroupNumber,
    /// The arguments of the probe in the id of the case.
    #[serde(default, skip_serializing_if = "str::is_empty")]
    case: Cow<'r, str>,
    /// The time that the engine took, in microseconds.
    duration_us: u64,
    /// The fingerprint of the expectation.
    expects: u32,
    /// The line of the case in the case file, from 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    line: Option<u32>,
    /// The expected facts.
    #[serde(default, skip_serializing_if = "<[Fact]>::is_empty")]
    expected: Cow<'r, [Fact]>,
    /// The actual facts, side by side with the expected ones.
    #[serde(default, skip_serializing_if = "<[Fact]>::is_empty")]
    got: Cow<'r, [Fact]>,
    /// The observations of the case.
    #[serde(default, skip_serializing_if = "<[Observed]>::is_empty")]
    observations: Cow<'r, [Observed]>,
    /// The program, of which 32000 characters are kept, where the engine did not meet the expectation.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    program: Option<Cow<'r, str>>,
    /// The question that the program asks, such as `implicit(INT,DINT)` or `REAL_TO_INT(REAL#2.5) : INT`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, schemars(with = "Option<String>"))]
    question: Option<Cow<'r, Question>>,
    /// The note of the engine's baseline on the case.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    baseline: Option<Cow<'r, BaselineNote>>,
}

/// An array about a case that passed and has nothing more to tell: its group, the arguments of the probe in its id, its
/// duration in microseconds, and the fingerprint of its expectation. Nearly all lines of a log are such arrays.
#[derive(Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub(crate) struct PassedLine<'r>(GroupNumber, Cow<'r, str>, u64, u32);

impl<'r> PassedLine<'r> {
    /// Returns the line of a case; `None` where an array does not hold all that is known of it.
    pub(super) fn of(case: &'r CaseEvent, group: GroupNumber) -> Option<PassedLine<'r>> {
        let has_more = case.line.is_some()
            || case.program.is_some()
            || case.baseline.is_some()
            || !(case.expected.is_empty() && case.got.is_empty() && case.observations.is_empty());
        let arguments = Group::arguments(&case.id).into();
        (case.verdict == Verdict::Pass && !has_more).then_some(PassedLine(
            group,
            arguments,
            case.duration_us,
            case.expectation,
        ))
    }

    fn whole(self) -> CaseObject<'r> {
        let PassedLine(group, case, duration_us, expects) = self;
        CaseObject {
            verdict: Verdict::Pass,
            group,
            case,
            duration_us,
            expects,
            ..CaseObject::default()
        }
    }
}

impl<'r> GroupLine<'r> {
    pub(super) const fn new(number: GroupNumber, group: &'r Group) -> GroupLine<'r> {
        GroupLine {
            number,
            group: Cow::Borrowed(group),
        }
    }
}

impl<'r> CaseObject<'r> {
    pub(super) fn new(case: &'r CaseEvent, group: GroupNumber) -> CaseObject<'r> {
        CaseObject {
            verdict: case.verdict,
            group,
            case: Group::arguments(&case.id).into(),
            duration_us: case.duration_us,
            expects: case.expectation,
            line: case.line,
            expected: Cow::Borrowed(&case.expected),
            got: Cow::Borrowed(&case.got),
            observations: Cow::Borrowed(&case.observations),
            program: case.program.as_deref().map(kept),
            question: case.question.as_ref().map(Cow::Borrowed),
            baseline: case.baseline.as_ref().map(Cow::Borrowed),
        }
    }

    fn event(self, group: &Group) -> CaseEvent {
        CaseEvent {
            id: format!("{}{}", group.id, self.case),
            dialect: group.dialect.clone(),
            engine: group.engine.clone(),
            verdict: self.verdict,
            open: group.open,
            grade: group.grade,
            basis: group.basis.clone(),
            file: group.file.clone(),
            line: self.line,
            area: group.area.clone(),
            title: group.title.clone(),
            expectation: self.expects,
            expected: self.expected.into_owned(),
            got: self.got.into_owned(),
            duration_us: self.duration_us,
            observations: self.observations.into_owned(),
            program: self.program.map(Cow::into_owned),
            question: self.question.map(Cow::into_owned),
            baseline: self.baseline.map(Cow::into_owned),
        }
    }
}

/// The first key of a line, which names its kind.
#[derive(Deserialize)]
struct Tag<'r> {
    #[serde(rename = "type", borrow)]
    kind: Cow<'r, str>,
}

/// A decoder that turns lines into events.
#[derive(Default)]
pub(super) struct Decoder {
    groups: Vec<Group>,
}

impl Decoder {
    /// Returns the event of a line; `None` where the line describes a group. `number` is the number of the line.
    ///
    /// # Errors
    /// [`LogError::Line`] where the line is none of a log; [`LogError::Group`] where the group of a case is unknown, or the
    /// numbers of groups have a gap.
    pub(super) fn event(&mut self, line: &[u8], number: u64) -> Result<Option<Event>, LogError> {
        let broken = |source| LogError::Line { line: number, source };
        if line.first() == Some(&b'[') {
            let record: PassedLine<'_> = serde_json::from_slice(line).map_err(broken)?;
            return self.case(record.whole(), number);
        }
        let Tag { kind } = serde_json::from_slice(line).map_err(broken)?;
        // The kind is known, so each line is read once more as what it is, and what is wrong in it has its place in the line.
        match &*kind {
            "header" => Ok(Some(Event::Header(serde_json::from_slice(line).map_err(broken)?))),
            "cause" => Ok(Some(Event::Cause(serde_json::from_slice(line).map_err(broken)?))),
            "footer" => Ok(Some(Event::Footer(serde_json::from_slice(line).map_err(broken)?))),
            "group" => {
                let record: GroupLine<'_> = serde_json::from_slice(line).map_err(broken)?;
                if record.number != self.groups.len() {
                    return Err(LogError::Group { line: number });
                }
                self.groups.push(record.group.into_owned());
                Ok(None)
            }
            _ => {
                let record: CaseObject<'_> = serde_json::from_slice(line).map_err(broken)?;
                self.case(record, number)
            }
        }
    }

    fn case(&self, record: CaseObject<'_>, number: u64) -> Result<Option<Event>, LogError> {
        let group = self.groups.get(record.group);
        let group = group.ok_or(LogError::Group { line: number })?;
        Ok(Some(Event::Case(record.event(group))))
    }
}
