//! Reads each observed value back from a dump of variables, and chooses the probe variables that this needs.

use super::dump::{self, Dump, Shown};
use crate::adapters::probe_variable::ProbeVariable;
use crate::adapters::source::enumeration;
use crate::{Observation, RunRequest};
use std::collections::{BTreeMap, BTreeSet};
use stickler_types::{ElementaryType, Value};

/// The number of characters of a text that are read before its length is known.
const INITIAL_CHARACTERS: usize = 16;

/// The highest number of characters of a text that are read. Each costs a probe variable and a call.
const MAX_CHARACTERS: usize = 512;

/// The way in which one value is read back.
#[derive(Clone, PartialEq, Eq, Debug)]
enum Readback {
    /// The dump shows the variable itself, which has this type.
    Simple(ElementaryType),
    /// The dump shows a copy of the value in a probe variable of this name and type.
    Copy(String, ElementaryType),
    /// A variable or probe variable of this name shows the position of the value among those of its enumeration.
    Enumerated(String, Vec<String>),
    /// Probe variables show the length of the text and, for each of its first characters, the position in the alphabet.
    Text {
        ty: ElementaryType,
        length: String,
        characters: Vec<String>,
    },
    /// The value cannot be read back; holds the reason.
    Unreadable(String),
}

/// Facts that only a run of the program shows, and that decide how its values are read back in the next run.
#[derive(Clone, Default, PartialEq, Eq, Debug)]
pub(super) struct RunHints {
    /// Variables that share their name with another one.
    ambiguous: BTreeSet<String>,
    /// Lengths of texts that had more characters than were read.
    lengths: BTreeMap<String, usize>,
}

/// The ways in which all values of a request are read back.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Readbacks {
    readbacks: BTreeMap<String, Readback>,
    probes: Vec<ProbeVariable>,
    hints: RunHints,
}

/// The reason why a value was not read back.
#[derive(Debug)]
pub(super) enum ReadbackError {
    /// The program has to be run again with the probe variables that these hints ask for.
    Retry(RunHints),
    /// The value cannot be read back; holds the reason.
    Unsupported(String),
}

impl Readbacks {
    /// Chooses how to read back the values of a request; `hints` come from earlier runs.
    pub(super) fn of(request: &RunRequest<'_>, hints: RunHints) -> Readbacks {
        let mut readbacks = Readbacks {
            readbacks: BTreeMap::new(),
            probes: Vec::new(),
            hints,
        };
        for asked in request.observe {
            if !readbacks.readbacks.contains_key(&*asked.name) {
                let readback = readbacks.readback(asked, request.source);
                readbacks.readbacks.insert(asked.name.to_string(), readback);
            }
        }
        readbacks
    }

    /// Returns the variables to add to the program.
    pub(super) fn probes(&self) -> &[ProbeVariable] {
        &self.probes
    }

    fn readback(&mut self, asked: &Observation, source: &str) -> Readback {
        let by_name = !asked.name.contains(['.', '[']) && !self.hints.ambiguous.contains(&*asked.name);
        let Some(ty) = ElementaryType::from_name(&asked.type_name) else {
            return match enumeration(source, &asked.type_name) {
                Some(values) if by_name => Readback::Enumerated(asked.name.to_string(), values),
                Some(values) => Readback::Enumerated(self.copy(&asked.name, &asked.type_name), values),
                None if asked.type_name.is_empty() => {
                    Readback::Unreadable(format!("the type of {} was not given", asked.name))
                }
                None => Readback::Unreadable(format!("values of {} are not shown", asked.type_name)),
            };
        };
        match ty {
            _ if ty.is_text() => self.text(&asked.name, ty),
            ElementaryType::Ldate | ElementaryType::Ltod | ElementaryType::Ldt => {
                Readback::Unreadable(format!("of a value of {ty} only one half is shown"))
            }
            _ if by_name => Readback::Simple(ty),
            _ => Readback::Copy(self.copy(&asked.name, ty.name()), ty),
        }
    }

    /// Reads a text back by its length and, of each character, the position in a text that holds all characters.
    fn text(&mut self, name: &str, ty: ElementaryType) -> Readback {
        let count = self
            .hints
            .lengths
            .get(name)
            .copied()
            .unwrap_or(INITIAL_CHARACTERS);
        let alphabet = alphabet(ty);
        let length = self.probe(format!("LEN({name})"), "INT");
        let characters = (1..=count)
            .map(|at| self.probe(format!("FIND({alphabet}, MID({name}, 1, {at}))"), "INT"))
            .collect();
        Readback::Text {
            ty,
            length,
            characters,
        }
    }

    fn copy(&mut self, path: &str, type_name: &str) -> String {
        self.probe(path.to_owned(), type_name)
    }

    fn probe(&mut self, expression: String, type_name: &str) -> String {
        let name = ProbeVariable::name(self.probes.len());
        self.probes.push(ProbeVariable {
            name: name.clone(),
            type_name: type_name.to_owned(),
            expression,
        });
        name
    }

    /// Reads the value of an observed variable from a dump.
    ///
    /// # Errors
    /// [`ReadbackError`] where the dump does not show it.
    pub(super) fn value(&self, asked: &Observation, dump: &Dump<'_>) -> Result<Value, ReadbackError> {
        match self.readbacks.get(&*asked.name) {
            Some(Readback::Simple(ty)) => dump::value(*ty, self.shown(&asked.name, &asked.name, dump)?)
                .map_err(ReadbackError::Unsupported),
            Some(Readback::Copy(name, ty)) => {
                dump::value(*ty, self.shown(&asked.name, name, dump)?).map_err(ReadbackError::Unsupported)
            }
            Some(Readback::Enumerated(name, values)) => {
                let shown = self.shown(&asked.name, name, dump)?;
                let value = shown
                    .trim()
                    .parse::<usize>()
                    .ok()
                    .and_then(|place| values.get(place));
                let value = value.ok_or_else(|| {
                    ReadbackError::Unsupported(format!("it shows `{shown}` as {}", asked.type_name))
                })?;
                Ok(Value::enumerated(&*asked.type_name, value))
            }
            Some(Readback::Text {
                ty,
                length,
                characters,
            }) => self.read_text(&asked.name, *ty, length, characters, dump),
            Some(Readback::Unreadable(reason)) => Err(ReadbackError::Unsupported(reason.clone())),
            None => Err(ReadbackError::Unsupported(format!(
                "no readback was planned for {}",
                asked.name
            ))),
        }
    }

    /// Reads the value of a variable that needs no probe; `None` where it needs one, or the dump does not show it.
    pub(super) fn simple(&self, asked: &Observation, dump: &Dump<'_>) -> Option<Value> {
        match (self.readbacks.get(&*asked.name)?, dump.find(&asked.name)) {
            (Readback::Simple(ty), Shown::Value(shown)) => dump::value(*ty, shown).ok(),
            _ => None,
        }
    }

    /// Returns the text in a dump for a variable or for the probe variable that stands for it.
    fn shown<'d>(&self, path: &str, name: &str, dump: &Dump<'d>) -> Result<&'d str, ReadbackError> {
        match dump.find(name) {
            Shown::Value(value) => Ok(value),
            Shown::Ambiguous => {
                let mut hints = self.hints.clone();
                // A probe variable has a unique name, so that this happens once for each path.
                hints.ambiguous.insert(path.to_owned());
                Err(ReadbackError::Retry(hints))
            }
            Shown::Missing => Err(ReadbackError::Unsupported(format!("the dump shows no {name}"))),
        }
    }

    fn read_text(
        &self,
        path: &str,
        ty: ElementaryType,
        length: &str,
        characters: &[String],
        dump: &Dump<'_>,
    ) -> Result<Value, ReadbackError> {
        let shown = self.shown(path, length, dump)?;
        let length = shown
            .trim()
            .parse::<usize>()
            .ok()
            .filter(|&length| length <= MAX_CHARACTERS);
        let length = length.ok_or_else(|| {
            ReadbackError::Unsupported(format!("the length of {path} is shown as `{shown}`"))
        })?;
        if length > characters.len() {
            let mut hints = self.hints.clone();
            hints.lengths.insert(path.to_owned(), length);
            return Err(ReadbackError::Retry(hints));
        }
        let mut units = Vec::with_capacity(length);
        for name in &characters[..length] {
            let place = self.shown(path, name, dump)?.trim().parse::<usize>().ok();
            let letter = place.and_then(|place| visible(ty).nth(place.checked_sub(1)?));
            let unseen = || ReadbackError::Unsupported(format!("{path} holds a character that is not seen"));
            units.push(u16::from(letter.ok_or_else(unseen)?));
        }
        Ok(Value::text(ty, units))
    }
}

/// Returns a literal of all visible characters, in order, in which FIND gives the position of a character.
fn alphabet(ty: ElementaryType) -> String {
    let quote = if ty == ElementaryType::Wstring { '"' } else { '\'' };
    let inside: String = visible(ty).map(char::from).collect();
    format!("{quote}{inside}{quote}")
}

/// Returns the characters that can be read back in a text of a type. Characters with a meaning of their own in a literal are
/// not among them, since compilers may read them differently.
fn visible(ty: ElementaryType) -> impl Iterator<Item = u8> {
    let quote = if ty == ElementaryType::Wstring {
        b'"'
    } else {
        b'\''
    };
    (b' '..=b'~').filter(move |&character| character != b'$' && character != quote)
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_types::DialectName;

    const SOURCE: &str = "TYPE COLOR : (RED, GREEN); END_TYPE PROGRAM main END_PROGRAM";

    fn observation(name: &str, type_name: &str) -> Observation {
        Observation::last(name, type_name)
    }

    fn request(observe: &[Observation]) -> RunRequest<'_> {
        RunRequest::once(DialectName::IronplcEd2, SOURCE, observe)
    }

    fn seen(readbacks: &Readbacks, asked: &Observation, dump: &str) -> String {
        match readbacks.value(asked, &Dump::read(dump)) {
            Ok(value) => value.to_string(),
            Err(ReadbackError::Unsupported(reason)) => reason,
            Err(ReadbackError::Retry(_)) => "again".to_owned(),
        }
    }

    #[test]
    fn what_the_dump_shows_needs_no_probe() {
        let observe = [observation("x", "INT"), observation("c", "COLOR")];
        let readbacks = Readbacks::of(&request(&observe), RunHints::default());
        assert_eq!(readbacks.probes(), []);
        assert_eq!(seen(&readbacks, &observe[0], "x: 5\nc: 1\n"), "INT#5");
        assert_eq!(seen(&readbacks, &observe[1], "x: 5\nc: 1\n"), "COLOR#GREEN");
        assert_eq!(seen(&readbacks, &observe[1], "c: 2\n"), "it shows `2` as COLOR");
        assert_eq!(seen(&readbacks, &observe[0], ""), "the dump shows no x");
    }

    #[test]
    fn a_path_is_copied_once() {
        let observe = [
            observation("a[1]", "INT"),
            observation("a[1]", "INT"),
            observation("r.f", "COLOR"),
        ];
        let readbacks = Readbacks::of(&request(&observe), RunHints::default());
        assert_eq!(readbacks.probes().len(), 2);
        assert_eq!(readbacks.probes()[0].expression, "a[1]");
        let dump = "stickler_probe_0: 7\nstickler_probe_1: 0\n";
        assert_eq!(seen(&readbacks, &observe[1], dump), "INT#7");
        assert_eq!(seen(&readbacks, &observe[2], dump), "COLOR#RED");
    }

    #[test]
    fn a_name_that_several_variables_have_is_copied_at_the_second_look() {
        let observe = [observation("x", "INT")];
        let first = Readbacks::of(&request(&observe), RunHints::default());
        let Err(ReadbackError::Retry(hints)) = first.value(&observe[0], &Dump::read("x: 5\nx: 6\n")) else {
            panic!("no second look")
        };
        let second = Readbacks::of(&request(&observe), hints);
        assert_eq!(
            seen(&second, &observe[0], "x: 5\nx: 6\nstickler_probe_0: 5\n"),
            "INT#5"
        );
    }

    #[test]
    fn a_text_is_spelled_from_the_places_of_its_characters() {
        let observe = [observation("s", "STRING")];
        let readbacks = Readbacks::of(&request(&observe), RunHints::default());
        assert_eq!(readbacks.probes().len(), 1 + INITIAL_CHARACTERS);
        let place = |character: u8| {
            1 + visible(ElementaryType::String)
                .position(|other| other == character)
                .unwrap()
        };
        let dump = format!(
            "stickler_probe_0: 2\nstickler_probe_1: {}\nstickler_probe_2: {}\n",
            place(b'a'),
            place(b'~')
        );
        assert_eq!(seen(&readbacks, &observe[0], &dump), "STRING#'a~'");
        let dump = "stickler_probe_0: 1\nstickler_probe_1: 0\n";
        assert_eq!(
            seen(&readbacks, &observe[0], dump),
            "s holds a character that is not seen"
        );
        let Err(ReadbackError::Retry(hints)) =
            readbacks.value(&observe[0], &Dump::read("stickler_probe_0: 40\n"))
        else {
            panic!("no second look")
        };
        assert_eq!(Readbacks::of(&request(&observe), hints).probes().len(), 41);
    }

    #[test]
    fn what_is_not_to_be_seen_is_told_with_its_reason() {
        let observe = [
            observation("d", "LDATE"),
            observation("u", ""),
            observation("v", "SHAPE"),
        ];
        let readbacks = Readbacks::of(&request(&observe), RunHints::default());
        assert_eq!(
            seen(&readbacks, &observe[0], "d: 1\n"),
            "of a value of LDATE only one half is shown"
        );
        assert_eq!(
            seen(&readbacks, &observe[1], "u: 1\n"),
            "the type of u was not given"
        );
        assert_eq!(
            seen(&readbacks, &observe[2], "v: 1\n"),
            "values of SHAPE are not shown"
        );
    }
}
