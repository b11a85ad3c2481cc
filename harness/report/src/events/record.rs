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
    pub(super) number: GroupNumber,
    /// The common properties.
    pub(super) group: Cow<'r, Group>,
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
    /// The time that the engine took, in microseconds.
    duration_us: u64,
    /// The question of the case; missing where the object about a case before it has the same question, asked of another engine or in another dialect.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    asked: Option<Cow<'r, AskedCase>>,
    /// The actual facts, side by side with the expected ones.
    #[serde(default, skip_serializing_if = "<[Fact]>::is_empty")]
    got: Cow<'r, [Fact]>,
    /// The observations of the case.
    #[serde(default, skip_serializing_if = "<[Observed]>::is_empty")]
    observations: Cow<'r, [Observed]>,
    /// The note of the engine's baseline on the case.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    baseline: Option<Cow<'r, BaselineNote>>,
}

/// The part of a case that is often the same for several engines and dialects, which follow each other in a log.
#[derive(Clone, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub(crate) struct AskedCase {
    /// The arguments of the probe in the id of the case.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    case: String,
    /// The fingerprint of the expectation.
    expects: u32,
    /// The line of the case in the case file, from 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    line: Option<u32>,
    /// The expected facts.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    expected: Vec<Fact>,
    /// The program, of which 32000 characters are kept, where the engine did not meet the expectation.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    program: Option<String>,
    /// The question that the program asks, such as `implicit(INT,DINT)` or `REAL_TO_INT(REAL#2.5) : INT`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, schemars(with = "Option<String>"))]
    question: Option<Question>,
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
}

impl<'r> CaseObject<'r> {
    /// Returns the object about a case; `asked` is what the object before it asked, and becomes what this one asks.
    pub(super) fn new(case: &'r CaseEvent, group: GroupNumber, asked: &'r mut Option<AskedCase>) -> Self {
        let now = Some(AskedCase {
            case: Group::arguments(&case.id).to_owned(),
            expects: case.expectation,
            line: case.line,
            expected: case.expected.clone(),
            program: case.program.as_deref().map(|program| kept(program).into_owned()),
            question: case.question.clone(),
        });
        let is_new = *asked != now;
        *asked = now;
        CaseObject {
            verdict: case.verdict,
            group,
            duration_us: case.duration_us,
            asked: asked.as_ref().filter(|_| is_new).map(Cow::Borrowed),
            got: Cow::Borrowed(&case.got),
            observations: Cow::Borrowed(&case.observations),
            baseline: case.baseline.as_ref().map(Cow::Borrowed),
        }
    }

    fn event(self, asked: AskedCase, group: &Group) -> CaseEvent {
        CaseEvent {
            id: format!("{}{}", group.id, asked.case),
            dialect: group.dialect.clone(),
            engine: group.engine.clone(),
            verdict: self.verdict,
            open: group.open,
            grade: group.grade,
            basis: group.basis.clone(),
            file: group.file.clone(),
            line: asked.line,
            area: group.area.clone(),
            title: group.title.clone(),
            expectation: asked.expects,
            expected: asked.expected,
            got: self.got.into_owned(),
            duration_us: self.duration_us,
            observations: self.observations.into_owned(),
            program: asked.program,
            question: asked.question,
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
    /// The question of the last object about a case.
    asked: Option<AskedCase>,
}

impl Decoder {
    /// Returns the event of a line; `None` where the line describes a group. `number` is the number of the line.
    ///
    /// # Errors
    /// [`LogError::Line`] where the line is none of a log; [`LogError::Reference`] where the group of a case or what it asks is unknown,
    /// or the numbers of groups have a gap.
    pub(super) fn event(&mut self, line: &[u8], number: u64) -> Result<Option<Event>, LogError> {
        let broken = |source| LogError::Line { line: number, source };
        if line.first() == Some(&b'[') {
            let record: PassedLine<'_> = serde_json::from_slice(line).map_err(broken)?;
            let PassedLine(group, case, duration_us, expects) = record;
            let asked = AskedCase {
                case: case.into_owned(),
                expects,
                ..AskedCase::default()
            };
            let record = CaseObject {
                verdict: Verdict::Pass,
                group,
                duration_us,
                ..CaseObject::default()
            };
            return self.case(record, Some(asked), number);
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
                    return Err(LogError::Reference(number));
                }
                self.groups.push(record.group.into_owned());
                Ok(None)
            }
            _ => {
                let mut record: CaseObject<'_> = serde_json::from_slice(line).map_err(broken)?;
                if let Some(asked) = record.asked.take() {
                    self.asked = Some(asked.into_owned());
                }
                self.case(record, self.asked.clone(), number)
            }
        }
    }

    fn case(
        &self,
        record: CaseObject<'_>,
        asked: Option<AskedCase>,
        number: u64,
    ) -> Result<Option<Event>, LogError> {
        let unknown = LogError::Reference(number);
        let (Some(group), Some(asked)) = (self.groups.get(record.group), asked) else {
            return Err(unknown);
        };
        Ok(Some(Event::Case(record.event(asked, group))))
    }
}
