//! Assigns pasted arrays to their pages, and reads the result of each case from them.

use crate::encoding::{self, DecodedValue};
use crate::manifest::{Manifest, PageRecord, StepRecord};
use crate::page::{MAGIC, literal};
use crate::page_case::expected;
use crate::paste::Array;
use std::collections::BTreeMap;
use stickler_engines::{NamedValue, Outcome};
use stickler_suite::Case;

/// The pasted elements of each page, by the page's index in the manifest.
#[derive(Debug, Default)]
pub(crate) struct ResultArrays {
    pages: BTreeMap<usize, BTreeMap<usize, i32>>,
}

/// The result of a case in the array of its page.
#[derive(Clone, PartialEq, Debug)]
pub(crate) enum PageResult {
    /// The outcome on the engine, and the keys of the values that differ from the expected ones and that no numbers show.
    Outcome(Outcome, Vec<String>),
    /// No element of the case was pasted.
    Missing,
    /// The page ended without running the case, or has not reached it yet.
    NotRun,
    /// Elements of the case hold numbers that no page writes; holds a message that names them.
    Nonsense(String),
}

impl ResultArrays {
    /// Adds an array.
    ///
    /// # Errors
    /// The reason why it is the array of no page of this export, as a sentence without its full stop.
    pub(crate) fn take(&mut self, array: &Array, manifest: &Manifest) -> Result<Option<String>, String> {
        let at = page_of(array, manifest)?;
        let page = &manifest.pages[at];
        if let Some((index, _)) = array.elements.range(page.elements..).next() {
            return Err(format!(
                "has an element {index}, and page {} ends with {}; copy only results[0] to results[{}]",
                page.number,
                page.elements - 1,
                page.elements - 1
            ));
        }
        let known = self.pages.entry(at).or_default();
        let changed = array
            .elements
            .iter()
            .any(|(index, value)| known.get(index).is_some_and(|known| known != value));
        known.extend(array.elements.iter().map(|(index, value)| (*index, *value)));
        Ok(changed.then(|| {
            format!(
                "page {} was given before with other values; these count",
                page.number
            )
        }))
    }

    /// Returns whether no element of a page was pasted.
    pub(crate) fn is_without(&self, at: usize) -> bool {
        !self.pages.contains_key(&at)
    }

    /// Returns the result of one of the cases of a page from its array.
    pub(crate) fn result(&self, at: usize, page: &PageRecord, number: usize, case: &Case) -> PageResult {
        let Some(elements) = self.pages.get(&at) else {
            return PageResult::Missing;
        };
        let mut reading = Reading::default();
        let steps = page.steps.iter().enumerate();
        for (place, step) in steps.filter(|(_, step)| step.case == number) {
            if let Err(reported) = reading.take(elements, page, (place, step), case) {
                return reported;
            }
        }
        match reading.contradiction {
            Some(message) => PageResult::Outcome(Outcome::Error { message }, Vec::new()),
            None => PageResult::Outcome(Outcome::executed(reading.values), reading.untold),
        }
    }

    /// Returns a sentence on how far a page ran; `None` where it ran to its end and its whole array was copied.
    pub(crate) fn state(&self, at: usize, page: &PageRecord) -> Option<String> {
        let elements = self.pages.get(&at)?;
        let missing: Vec<usize> = (0..page.elements)
            .filter(|index| !elements.contains_key(index))
            .collect();
        if let [first, ..] = missing[..] {
            let last = missing.last().copied().unwrap_or(first);
            return Some(match missing.len() {
                1 => format!("results[{first}] is missing"),
                length => {
                    format!("{length} elements are missing between results[{first}] and results[{last}]")
                }
            });
        }
        let steps = page.steps.len();
        let (begun, ended) = (elements[&4], elements[&5]);
        if usize::try_from(ended) == Ok(steps) {
            return (elements[&(page.elements - 1)] != page.identity).then(|| {
                format!(
                    "results[{}] is not what the page writes at its end",
                    page.elements - 1
                )
            });
        }
        let stopped = usize::try_from(begun)
            .ok()
            .filter(|_| begun == ended.saturating_add(1));
        let culprit = stopped
            .and_then(|begun| page.steps.get(begun.checked_sub(1)?))
            .map(|step| &page.cases[step.case].id);
        Some(match culprit {
            Some(id) => format!(
                "{ended} of {steps} observations were made, and it is within the next; if it goes no further, note \
                 `crashed {id}` in {}",
                crate::ANSWERS
            ),
            None => format!("{ended} of {steps} observations were made; let it run on, and copy it again"),
        })
    }
}

/// Returns the index of the page to which an array belongs.
fn page_of(array: &Array, manifest: &Manifest) -> Result<usize, String> {
    let element = |index: usize| array.elements.get(&index).copied();
    match element(0) {
        Some(MAGIC) => {}
        _ if array.elements.values().all(|value| *value == 0) => {
            return Err("holds nothing but zeros: its page did not run".to_owned());
        }
        None => return Err("has no results[0], so nobody can say of which page it is".to_owned()),
        Some(other) => {
            return Err(format!(
                "is no array of results: results[0] is {other}, and a page writes {MAGIC} there; where a row has more than one \
                 number, copy the headings of the columns, too"
            ));
        }
    }
    let Some(identity) = element(1) else {
        return Err("has no results[1], so nobody can say of which page it is".to_owned());
    };
    // A page of another export hardly ever has all three numbers in common.
    let is =
        |index: usize, number: usize| element(index).is_none_or(|found| usize::try_from(found) == Ok(number));
    let fits = |page: &PageRecord| is(2, page.number) && is(3, page.steps.len());
    let found = manifest
        .pages
        .iter()
        .position(|page| page.identity == identity && fits(page));
    found.ok_or_else(|| match element(2) {
        Some(number) => {
            format!("is that of page {number} of another export; paste the page of this one and run it")
        }
        None => "is that of another export; paste the page of this one and run it".to_owned(),
    })
}

/// The values of a case that were read so far, one observation after the other.
#[derive(Default)]
struct Reading {
    values: Vec<NamedValue>,
    untold: Vec<String>,
    contradiction: Option<String>,
}

impl Reading {
    /// # Errors
    /// The result of the case where the array lacks a valid observation.
    fn take(
        &mut self,
        elements: &BTreeMap<usize, i32>,
        page: &PageRecord,
        (place, step): (usize, &StepRecord),
        case: &Case,
    ) -> Result<(), PageResult> {
        let element = |index: usize| elements.get(&index).copied().ok_or(PageResult::Missing);
        let strange = |index: usize, value: i32| PageResult::Nonsense(format!("results[{index}] is {value}"));
        let marker = element(step.place)?;
        let own = page
            .identity
            .saturating_add(i32::try_from(place + 1).unwrap_or(i32::MAX));
        match marker {
            0 => return Err(PageResult::NotRun),
            _ if marker != own => return Err(strange(step.place, marker)),
            _ => {}
        }
        let compared = element(step.place + 1)?;
        let Some(number) = step.observe else { return Ok(()) };
        let Some(observe) = case.observe.get(number) else {
            return Err(strange(step.place, marker));
        };
        let must_be = expected(case, number).map(|expected| &expected.value);
        let comparable = must_be.is_some_and(|value| literal(value).is_some());
        let equal = match compared {
            1 | 2 if comparable => Some(compared == 1),
            0 if !comparable => None,
            _ => return Err(strange(step.place + 1, compared)),
        };
        let encoded = encoding::encoded(&observe.type_name);
        let numbers: Vec<i32> = (0..encoded.map_or(0, encoding::pieces))
            .map(|piece| element(step.place + 2 + piece))
            .collect::<Result<_, PageResult>>()?;
        let decoded = encoded.map_or(DecodedValue::Unknown, |ty| encoding::decode(ty, &numbers));
        let key = observe.key().to_string();
        match (decoded, equal, must_be) {
            (DecodedValue::Invalid, ..) => {
                return Err(PageResult::Nonsense(format!(
                    "results[{}] and those behind it are {numbers:?}",
                    step.place + 2
                )));
            }
            (DecodedValue::Value(value), Some(equal), Some(must_be)) if equal != (value == *must_be) => {
                let word = if equal { "equals" } else { "does not equal" };
                self.contradiction = Some(format!(
                    "the program's own comparison says that {key} {word} {must_be}, and its numbers say that it is {value}"
                ));
            }
            (DecodedValue::Value(value), ..) => self.values.push((key, value)),
            (DecodedValue::Unknown, Some(true), Some(must_be)) => self.values.push((key, must_be.clone())),
            (DecodedValue::Unknown, ..) => self.untold.push(key),
        }
        Ok(())
    }
}
