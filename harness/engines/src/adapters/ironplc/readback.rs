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
        let count = self
            .hints
            .lengths
            .get(name)
            .copied()
            .unwrap_or(INITIAL_CHARACTERS);
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
                let value = shown
                    .trim()
                    .parse::<usize>()
                    .ok()
                    .and_then(|place| values.get(place));
                let value = value.ok_or_else(|| {
                    ReadbackError::Failed(format!("it shows `{shown}` as {}", asked.type_name))
                })?;
                Ok(Value::enumerated(&*asked.type_name, value))
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
                (Some(place), _) => characters::plain(ty).nth(place).map(u16::from),
                (None, Some(place)) => characters::escaped(ty).nth(place).map(u16::from),
                (None, None) => None,
            };
            let unseen = || ReadbackError::Failed(format!("{path} holds a character that is not seen"));
            units.push(unit.ok_or_else(unseen)?);
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
mod tests {
    use super::characters::{escaped, plain};
    use super::*;
    use std::fmt::Write;
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
            Err(ReadbackError::Failed(reason)) => format!("failed: {reason}"),
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
        assert_eq!(
            seen(&readbacks, &observe[1], "c: 2\n"),
            "failed: it shows `2` as COLOR"
        );
        assert_eq!(seen(&readbacks, &observe[0], ""), "failed: the dump shows no x");
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

    /// Returns what the dump shows of a text of these characters, for a compiler that does or does not know escapes.
    fn dumped(readbacks: &Readbacks, text: &[u8], knows_escapes: bool) -> String {
        let ty = ElementaryType::String;
        let literal = escaped_literal(ty);
        let others: Vec<u8> = match knows_escapes {
            true => escaped(ty).collect(),
            false => literal.trim_matches('\'').bytes().collect(),
        };
        let find = |all: Vec<u8>, at: usize| {
            let sought = text.get(at);
            sought
                .and_then(|sought| all.iter().position(|other| other == sought))
                .map_or(0, |at| at + 1)
        };
        let mut dump = String::new();
        let mut at = 0;
        for probe in readbacks.probes() {
            let shown = match &probe.expression {
                length if length.starts_with("LEN") => text.len(),
                first if first.starts_with("FIND(stickler_probe_0,") => find(plain(ty).collect(), at),
                second if second.starts_with("FIND(stickler_probe_1,") => {
                    at += 1;
                    find(others.clone(), at - 1)
                }
                _ => continue,
            };
            writeln!(dump, "{}: {shown}", probe.name).unwrap();
        }
        dump
    }

    #[test]
    fn a_text_is_spelled_from_the_places_of_its_characters() {
        let observe = [observation("s", "STRING")];
        let readbacks = Readbacks::of(&request(&observe), RunHints::default());
        let names: BTreeSet<&str> = readbacks.probes().iter().map(|probe| &*probe.name).collect();
        // Two alphabets, the character that is sought, the length, and two places a character.
        assert_eq!(names.len(), 4 + 2 * INITIAL_CHARACTERS);
        for knows_escapes in [true, false] {
            let dump = dumped(&readbacks, b"a~$41 \"", knows_escapes);
            assert_eq!(seen(&readbacks, &observe[0], &dump), "STRING#'a~$$41 \"'");
        }
        let dump = dumped(&readbacks, b"\n'", true);
        assert_eq!(seen(&readbacks, &observe[0], &dump), "STRING#'$0A$''");
        let dump = dumped(&readbacks, b"\xE9", true);
        assert_eq!(
            seen(&readbacks, &observe[0], &dump),
            "failed: s holds a character that is not seen"
        );
        let dump = dumped(&readbacks, &[b'x'; 40], true);
        let Err(ReadbackError::Retry(hints)) = readbacks.value(&observe[0], &Dump::read(&dump)) else {
            panic!("no second look")
        };
        let long = Readbacks::of(&request(&observe), hints);
        let dump = dumped(&long, &[b'x'; 40], true);
        assert_eq!(
            seen(&long, &observe[0], &dump),
            format!("STRING#'{}'", "x".repeat(40))
        );
    }

    #[test]
    fn nothing_is_asked_of_calls_that_do_not_work() {
        let observe = [observation("s", "STRING"), observation("w", "WSTRING")];
        let hints = RunHints::without(BTreeMap::from([(ElementaryType::Wstring, "no".to_owned())]));
        let readbacks = Readbacks::of(&request(&observe), hints);
        assert_eq!(seen(&readbacks, &observe[1], ""), "no");
        assert!(
            !readbacks
                .probes()
                .iter()
                .any(|probe| probe.expression.contains("(w"))
        );
    }

    #[test]
    fn what_is_not_to_be_seen_is_told_with_its_reason() {
        let observe = [
            observation("d", "LDATE"),
            observation("u", ""),
            observation("v", "SHAPE"),
            observation("c", "CHAR"),
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
        assert_eq!(
            seen(&readbacks, &observe[3], "c: 1\n"),
            "values of CHAR are not shown"
        );
    }
}
