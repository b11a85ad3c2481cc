//! Reads each observed value back from a dump of variables, and chooses the probe variables that this needs.

use super::characters::{self, escaped_literal, plain_literal};
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
    /// Probe variables show the length of the text and, for each of its first characters, its place.
    Text {
        ty: ElementaryType,
        length: String,
        characters: Vec<PlaceOfCharacter>,
    },
    /// The value cannot be read back; holds the reason.
    Unreadable(String),
}

/// The probe variables that show the positions of one character among the [plain](characters::plain) and the
/// [escaped](characters::escaped) characters.
#[derive(Clone, PartialEq, Eq, Debug)]
struct PlaceOfCharacter {
    plain: String,
    escaped: String,
}

/// The probe variables that all texts of a type share: one text with each of the
/// [plain](characters::plain) characters, one with each of the [escaped](characters::escaped) ones, and one for the character
/// that is sought.
#[derive(Clone, PartialEq, Eq, Debug)]
struct Alphabets {
    plain: String,
    escaped: String,
    one: String,
}

/// Facts that only a run shows, and that decide how values are read back in the next run.
#[derive(Clone, Default, PartialEq, Eq, Debug)]
pub(super) struct RunHints {
    /// The types of text whose values the calls that read them do not show, each with the reason.
    unreadable: BTreeMap<ElementaryType, String>,
    /// Variables that share their name with another one.
    ambiguous: BTreeSet<String>,
    /// Lengths of texts that had more characters than were read.
    lengths: BTreeMap<String, usize>,
}

impl RunHints {
    /// Returns the hints before any run: these types of text cannot be read, each with the reason.
    pub(super) fn without(unreadable: BTreeMap<ElementaryType, String>) -> RunHints {
        RunHints {
            unreadable,
            ..RunHints::default()
        }
    }
}

/// The ways in which all values of a request are read back.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Readbacks {
    readbacks: BTreeMap<String, Readback>,
    probes: Vec<ProbeVariable>,
    alphabets: BTreeMap<ElementaryType, Alphabets>,
    hints: RunHints,
}

/// The reason why a value was not read back.
#[derive(Debug)]
pub(super) enum ReadbackError {
    /// The program has to be run again with the probe variables that these hints ask for.
    Retry(RunHints),
    /// The virtual machine never shows such a value; holds the reason.
    Unsupported(String),
    /// The value was to be shown and could not be read; holds the reason.
    Failed(String),
}

impl Readbacks {
    /// Chooses how to read back the values of a request; `hints` come from earlier runs.
    pub(super) fn of(request: &RunRequest<'_>, hints: RunHints) -> Readbacks {
        let mut readbacks = Readbacks {
            readbacks: BTreeMap::new(),
            probes: Vec::new(),
            alphabets: BTreeMap::new(),
            hints,
        };
        for asked in request.observe {
            if !readbacks.readbacks.contains_key(&*asked.name) {
                let readback = readbacks.readback(asked, request);
                readbacks.readbacks.insert(asked.name.to_string(), readback);
            }
        }
        readbacks
    }

    /// Returns the variables to add to the program.
    pub(super) fn probes(&self) -> &[ProbeVariable] {
        &self.probes
    }

    fn readback(&mut self, asked: &Observation, request: &RunRequest<'_>) -> Readback {
        let by_name = !asked.name.contains(['.', '[']) && !self.hints.ambiguous.contains(&*asked.name);
        let Some(ty) = ElementaryType::from_name(&asked.type_name) else {
            return match enumeration(request, &asked.type_name) {
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
            _ if ty.is_character() => Readback::Unreadable(format!("values of {ty} are not shown")),
            ElementaryType::Ldate | ElementaryType::Ltod | ElementaryType::Ldt => {
                Readback::Unreadable(format!("of a value of {ty} only one half is shown"))
            }
            _ if by_name => Readback::Simple(ty),
            _ => Readback::Copy(self.copy(&asked.name, ty.name()), ty),
        }
    }

    /// Reads a text back by its length and, of each character, the position in a text that holds all characters.
    ///
    /// FIND gets variables, never literals or results: version 0.239 does not compare wide texts otherwise. The characters are
    /// initial values, since that version assigns no wide literal.
    fn text(&mut self, name: &str, ty: ElementaryType) -> Readback {
        if let Some(reason) = self.hints.unreadable.get(&ty) {
            return Readback::Unreadable(reason.clone());
        }
        let count = *self.hints.lengths.get(name).unwrap_or(&INITIAL_CHARACTERS);
        let Alphabets { plain, escaped, one } = self.alphabets(ty);
        let length = self.probe(format!("LEN({name})"), "INT");
        let mut characters = Vec::with_capacity(count);
        for at in 1..=count {
            self.probes.push(ProbeVariable {
                name: one.clone(),
                type_name: format!("{ty}[1]"),
                expression: format!("MID({name}, 1, {at})"),
            });
            characters.push(PlaceOfCharacter {
                plain: self.probe(format!("FIND({plain}, {one})"), "INT"),
                escaped: self.probe(format!("FIND({escaped}, {one})"), "INT"),
            });
        }
        Readback::Text {
            ty,
            length,
            characters,
        }
    }

    /// Returns the variables that hold the characters of a type.
    fn alphabets(&mut self, ty: ElementaryType) -> Alphabets {
        if let Some(known) = self.alphabets.get(&ty) {
            return known.clone();
        }
        let literals = [plain_literal(ty), escaped_literal(ty)];
        let [plain, escaped] = literals.map(|literal| {
            let length = literal.len();
            self.probe(String::new(), &format!("{ty}[{length}] := {literal}"))
        });
        let one = format!("{plain}_sought");
        let alphabets = Alphabets { plain, escaped, one };
        self.alphabets.insert(ty, alphabets.clone());
        alphabets
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
            Some(Readback::Simple(ty)) => {
                dump::value(*ty, self.shown(&asked.name, &asked.name, dump)?).map_err(ReadbackError::Failed)
            }
            Some(Readback::Copy(name, ty)) => {
                dump::value(*ty, self.shown(&asked.name, name, dump)?).map_err(ReadbackError::Failed)
            }
            Some(Readback::Enumerated(name, values)) => {
                let shown = self.shown(&asked.name, name, dump)?;
                let place = shown.trim().parse().ok();
                match place.and_then(|place: usize| values.get(place)) {
                    Some(value) => Ok(Value::enumerated(&*asked.type_name, value)),
                    None => Err(ReadbackError::Failed(format!(
                        "it shows `{shown}` as {}",
                        asked.type_name
                    ))),
                }
            }
            Some(Readback::Text {
                ty,
                length,
                characters,
            }) => self.read_text(&asked.name, *ty, length, characters, dump),
            Some(Readback::Unreadable(reason)) => Err(ReadbackError::Unsupported(reason.clone())),
            None => Err(ReadbackError::Failed(format!(
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
            Shown::Missing => Err(ReadbackError::Failed(format!("the dump shows no {name}"))),
        }
    }

    fn read_text(
        &self,
        path: &str,
        ty: ElementaryType,
        length: &str,
        characters: &[PlaceOfCharacter],
        dump: &Dump<'_>,
    ) -> Result<Value, ReadbackError> {
        let shown = self.shown(path, length, dump)?;
        let length = shown
            .trim()
            .parse::<usize>()
            .ok()
            .filter(|&length| length <= MAX_CHARACTERS);
        let length = length
            .ok_or_else(|| ReadbackError::Failed(format!("the length of {path} is shown as `{shown}`")))?;
        if length > characters.len() {
            let mut hints = self.hints.clone();
            hints.lengths.insert(path.to_owned(), length);
            return Err(ReadbackError::Retry(hints));
        }
        let mut units = Vec::with_capacity(length);
        for character in &characters[..length] {
            let plain = self.place(path, &character.plain, dump)?;
            let escaped = self.place(path, &character.escaped, dump)?;
            let unit = match (plain, escaped) {
                (Some(place), _) => characters::plain(ty).nth(place),
                (None, Some(place)) => characters::escaped(ty).nth(place),
                (None, None) => None,
            };
            let unseen = || ReadbackError::Unsupported(format!("{path} holds a character that is not seen"));
            units.push(u16::from(unit.ok_or_else(unseen)?));
        }
        Ok(Value::text(ty, units))
    }

    /// Returns the position, from 0, that a probe variable shows; `None` where FIND found nothing.
    fn place(&self, path: &str, name: &str, dump: &Dump<'_>) -> Result<Option<usize>, ReadbackError> {
        let shown = self.shown(path, name, dump)?.trim();
        match shown.parse::<usize>() {
            Ok(place) => Ok(place.checked_sub(1)),
            Err(_) => Err(ReadbackError::Failed(format!(
                "the place of a character of {path} is shown as `{shown}`"
            ))),
        }
    }
}

#[cfg(test)]
mod tests;
