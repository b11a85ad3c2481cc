//! How each observed value is to be seen in a dump, and the witnesses that make it so.

use super::dump::{self, Dump, Shown};
use crate::adapters::source::enumeration;
use crate::adapters::witness::Witness;
use crate::{Observation, RunRequest};
use std::collections::{BTreeMap, BTreeSet};
use stickler_types::{ElementaryType, Value};

/// How many characters of a text are looked at before it is known how many there are.
const FIRST_CHARACTERS: usize = 16;

/// The most characters that are looked at. Each costs a variable and a call.
const MOST_CHARACTERS: usize = 512;

/// How one value is to be seen.
#[derive(Clone, PartialEq, Eq, Debug)]
enum Sight {
    /// Its variable is printed, and this is its type.
    Simple(ElementaryType),
    /// A copy of it is.
    Copy(String, ElementaryType),
    /// The number of its place among the values of an enumeration is, or of a copy.
    Enumerated(String, Vec<String>),
    /// Its length is, and for each of its first characters the place in the alphabet.
    Text {
        ty: ElementaryType,
        length: String,
        characters: Vec<String>,
    },
    /// It is not, for this reason.
    Blind(String),
}

/// What could not be foreseen, and was seen when the program ran.
#[derive(Clone, Default, PartialEq, Eq, Debug)]
struct Experience {
    /// Variables whose name another one has as well.
    ambiguous: BTreeSet<String>,
    /// How long texts were.
    lengths: BTreeMap<String, usize>,
}

/// How all values of a request are to be seen.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Sights {
    sights: BTreeMap<String, Sight>,
    witnesses: Vec<Witness>,
    experience: Experience,
}

/// Why a value was not seen.
#[derive(Debug)]
pub(super) enum Blind {
    /// The program has to be run again with other witnesses.
    Again(Experienced),
    /// It cannot be.
    Unsupported(String),
}

/// What was learnt, for the next look.
#[derive(Debug)]
pub(super) struct Experienced(Experience);

impl Sights {
    /// How to see the values of a request; `experienced` is what earlier looks taught.
    pub(super) fn of(request: &RunRequest<'_>, experienced: Option<Experienced>) -> Sights {
        let mut sights = Sights {
            sights: BTreeMap::new(),
            witnesses: Vec::new(),
            experience: experienced
                .map(|Experienced(experience)| experience)
                .unwrap_or_default(),
        };
        for asked in request.observe {
            if !sights.sights.contains_key(&*asked.name) {
                let sight = sights.sight(asked, request.source);
                sights.sights.insert(asked.name.to_string(), sight);
            }
        }
        sights
    }

    /// The variables to be added to the program.
    pub(super) fn witnesses(&self) -> &[Witness] {
        &self.witnesses
    }

    fn sight(&mut self, asked: &Observation, source: &str) -> Sight {
        let by_name = !asked.name.contains(['.', '[']) && !self.experience.ambiguous.contains(&*asked.name);
        let Some(ty) = ElementaryType::from_name(&asked.type_name) else {
            return match enumeration(source, &asked.type_name) {
                Some(values) if by_name => Sight::Enumerated(asked.name.to_string(), values),
                Some(values) => Sight::Enumerated(self.copy(&asked.name, &asked.type_name), values),
                None if asked.type_name.is_empty() => {
                    Sight::Blind(format!("the type of {} was not told", asked.name))
                }
                None => Sight::Blind(format!("values of {} are not shown", asked.type_name)),
            };
        };
        match ty {
            _ if ty.is_text() => self.text(&asked.name, ty),
            ElementaryType::Ldate | ElementaryType::Ltod | ElementaryType::Ldt => {
                Sight::Blind(format!("of a value of {ty} only one half is shown"))
            }
            _ if by_name => Sight::Simple(ty),
            _ => Sight::Copy(self.copy(&asked.name, ty.name()), ty),
        }
    }

    /// A text can be asked for its length, and each of its characters for its place in a text that holds them all.
    fn text(&mut self, name: &str, ty: ElementaryType) -> Sight {
        let count = self
            .experience
            .lengths
            .get(name)
            .copied()
            .unwrap_or(FIRST_CHARACTERS);
        let alphabet = alphabet(ty);
        let length = self.witness(format!("LEN({name})"), "INT");
        let characters = (1..=count)
            .map(|at| self.witness(format!("FIND({alphabet}, MID({name}, 1, {at}))"), "INT"))
            .collect();
        Sight::Text {
            ty,
            length,
            characters,
        }
    }

    fn copy(&mut self, path: &str, type_name: &str) -> String {
        self.witness(path.to_owned(), type_name)
    }

    fn witness(&mut self, expression: String, type_name: &str) -> String {
        let name = Witness::name(self.witnesses.len());
        self.witnesses.push(Witness {
            name: name.clone(),
            type_name: type_name.to_owned(),
            expression,
        });
        name
    }

    /// The value that a dump shows of what was asked for.
    ///
    /// # Errors
    /// [`Blind`] where it shows none.
    pub(super) fn value(&self, asked: &Observation, dump: &Dump<'_>) -> Result<Value, Blind> {
        match self.sights.get(&*asked.name) {
            Some(Sight::Simple(ty)) => {
                dump::value(*ty, self.shown(&asked.name, &asked.name, dump)?).map_err(Blind::Unsupported)
            }
            Some(Sight::Copy(name, ty)) => {
                dump::value(*ty, self.shown(&asked.name, name, dump)?).map_err(Blind::Unsupported)
            }
            Some(Sight::Enumerated(name, values)) => {
                let shown = self.shown(&asked.name, name, dump)?;
                let value = shown
                    .trim()
                    .parse::<usize>()
                    .ok()
                    .and_then(|place| values.get(place));
                let value = value.ok_or_else(|| {
                    Blind::Unsupported(format!("it shows `{shown}` as {}", asked.type_name))
                })?;
                Ok(Value::enumerated(&*asked.type_name, value))
            }
            Some(Sight::Text {
                ty,
                length,
                characters,
            }) => self.read_text(&asked.name, *ty, length, characters, dump),
            Some(Sight::Blind(reason)) => Err(Blind::Unsupported(reason.clone())),
            None => Err(Blind::Unsupported(format!("nobody looked at {}", asked.name))),
        }
    }

    /// The value of what needs no witness, if that is so and the dump shows it.
    pub(super) fn simple(&self, asked: &Observation, dump: &Dump<'_>) -> Option<Value> {
        match (self.sights.get(&*asked.name)?, dump.find(&asked.name)) {
            (Sight::Simple(ty), Shown::Value(shown)) => dump::value(*ty, shown).ok(),
            _ => None,
        }
    }

    /// What a dump shows of a variable or of the witness that stands for it.
    fn shown<'d>(&self, path: &str, name: &str, dump: &Dump<'d>) -> Result<&'d str, Blind> {
        match dump.find(name) {
            Shown::Value(value) => Ok(value),
            Shown::Ambiguous => {
                let mut experience = self.experience.clone();
                // A witness has a name of its own, so that this happens once for each path.
                experience.ambiguous.insert(path.to_owned());
                Err(Blind::Again(Experienced(experience)))
            }
            Shown::Missing => Err(Blind::Unsupported(format!("the dump shows no {name}"))),
        }
    }

    fn read_text(
        &self,
        path: &str,
        ty: ElementaryType,
        length: &str,
        characters: &[String],
        dump: &Dump<'_>,
    ) -> Result<Value, Blind> {
        let shown = self.shown(path, length, dump)?;
        let length = shown
            .trim()
            .parse::<usize>()
            .ok()
            .filter(|&length| length <= MOST_CHARACTERS);
        let length = length
            .ok_or_else(|| Blind::Unsupported(format!("the length of {path} is shown as `{shown}`")))?;
        if length > characters.len() {
            let mut experience = self.experience.clone();
            experience.lengths.insert(path.to_owned(), length);
            return Err(Blind::Again(Experienced(experience)));
        }
        let mut units = Vec::with_capacity(length);
        for name in &characters[..length] {
            let place = self.shown(path, name, dump)?.trim().parse::<usize>().ok();
            let letter = place.and_then(|place| visible(ty).nth(place.checked_sub(1)?));
            let unseen = || Blind::Unsupported(format!("{path} holds a character that is not seen"));
            units.push(u16::from(letter.ok_or_else(unseen)?));
        }
        Ok(Value::text(ty, units))
    }
}

/// A literal of all characters that are visible, in order: FIND gives the place of one in it.
fn alphabet(ty: ElementaryType) -> String {
    let quote = if ty == ElementaryType::Wstring { '"' } else { '\'' };
    let inside: String = visible(ty).map(char::from).collect();
    format!("{quote}{inside}{quote}")
}

/// The characters that a text of a type can be seen to have. Those that have a meaning of their own in a literal are not
/// among them, since how a compiler reads them is a question and no answer.
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

    fn seen(sights: &Sights, asked: &Observation, dump: &str) -> String {
        match sights.value(asked, &Dump::read(dump)) {
            Ok(value) => value.to_string(),
            Err(Blind::Unsupported(reason)) => reason,
            Err(Blind::Again(_)) => "again".to_owned(),
        }
    }

    #[test]
    fn what_the_dump_shows_needs_no_witness() {
        let observe = [observation("x", "INT"), observation("c", "COLOR")];
        let sights = Sights::of(&request(&observe), None);
        assert_eq!(sights.witnesses(), []);
        assert_eq!(seen(&sights, &observe[0], "x: 5\nc: 1\n"), "INT#5");
        assert_eq!(seen(&sights, &observe[1], "x: 5\nc: 1\n"), "COLOR#GREEN");
        assert_eq!(seen(&sights, &observe[1], "c: 2\n"), "it shows `2` as COLOR");
        assert_eq!(seen(&sights, &observe[0], ""), "the dump shows no x");
    }

    #[test]
    fn a_path_is_copied_once() {
        let observe = [
            observation("a[1]", "INT"),
            observation("a[1]", "INT"),
            observation("r.f", "COLOR"),
        ];
        let sights = Sights::of(&request(&observe), None);
        assert_eq!(sights.witnesses().len(), 2);
        assert_eq!(sights.witnesses()[0].expression, "a[1]");
        let dump = "stickler_witness_0: 7\nstickler_witness_1: 0\n";
        assert_eq!(seen(&sights, &observe[1], dump), "INT#7");
        assert_eq!(seen(&sights, &observe[2], dump), "COLOR#RED");
    }

    #[test]
    fn a_name_that_several_variables_have_is_copied_at_the_second_look() {
        let observe = [observation("x", "INT")];
        let first = Sights::of(&request(&observe), None);
        let Err(Blind::Again(experienced)) = first.value(&observe[0], &Dump::read("x: 5\nx: 6\n")) else {
            panic!("no second look")
        };
        let second = Sights::of(&request(&observe), Some(experienced));
        assert_eq!(
            seen(&second, &observe[0], "x: 5\nx: 6\nstickler_witness_0: 5\n"),
            "INT#5"
        );
    }

    #[test]
    fn a_text_is_spelled_from_the_places_of_its_characters() {
        let observe = [observation("s", "STRING")];
        let sights = Sights::of(&request(&observe), None);
        assert_eq!(sights.witnesses().len(), 1 + FIRST_CHARACTERS);
        let place = |character: u8| {
            1 + visible(ElementaryType::String)
                .position(|other| other == character)
                .unwrap()
        };
        let dump = format!(
            "stickler_witness_0: 2\nstickler_witness_1: {}\nstickler_witness_2: {}\n",
            place(b'a'),
            place(b'~')
        );
        assert_eq!(seen(&sights, &observe[0], &dump), "STRING#'a~'");
        let dump = "stickler_witness_0: 1\nstickler_witness_1: 0\n";
        assert_eq!(
            seen(&sights, &observe[0], dump),
            "s holds a character that is not seen"
        );
        let Err(Blind::Again(experienced)) =
            sights.value(&observe[0], &Dump::read("stickler_witness_0: 40\n"))
        else {
            panic!("no second look")
        };
        assert_eq!(
            Sights::of(&request(&observe), Some(experienced))
                .witnesses()
                .len(),
            41
        );
    }

    #[test]
    fn what_is_not_to_be_seen_is_told_with_its_reason() {
        let observe = [
            observation("d", "LDATE"),
            observation("u", ""),
            observation("v", "SHAPE"),
        ];
        let sights = Sights::of(&request(&observe), None);
        assert_eq!(
            seen(&sights, &observe[0], "d: 1\n"),
            "of a value of LDATE only one half is shown"
        );
        assert_eq!(seen(&sights, &observe[1], "u: 1\n"), "the type of u was not told");
        assert_eq!(
            seen(&sights, &observe[2], "v: 1\n"),
            "values of SHAPE are not shown"
        );
    }
}
