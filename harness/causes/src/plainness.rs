//! The plainness of the types and numbers of a program: the order in which the normal form prefers them.

use crate::forms::{PLAIN, named_types};
use crate::program::{Part, ReadProgram};
use crate::words::{elementary, is_number};
use std::collections::BTreeSet;
use stickler_syntax::Edits;
use stickler_syntax::visitor::Place;

/// A decimal number of a program.
pub(crate) struct PlainNumber<'t> {
    prefix: &'t str,
    is_negative: bool,
    digits: &'t str,
    /// The digits before the point.
    whole: &'t str,
    /// The digits behind the point, where they are not zero.
    fraction: Option<&'t str>,
    has_exponent: bool,
}

impl<'t> PlainNumber<'t> {
    /// Reads a literal with its sign; `None` where it is no decimal number.
    fn read(literal: &'t str) -> Option<PlainNumber<'t>> {
        let (prefix, number) = literal.split_at(literal.find('#').map_or(0, |at| at + 1));
        let ty = elementary(prefix.trim_end_matches('#'));
        let digits = number.trim_start_matches(['-', '+', ' ']);
        let is_decimal = digits.starts_with(|first: char| first.is_ascii_digit()) && !digits.contains('#');
        if !is_decimal || !prefix.is_empty() && !ty.is_some_and(is_number) {
            return None;
        }
        let (whole, rest) = digits.split_once('.').unwrap_or((digits, ""));
        let has_exponent = digits.contains(['E', 'e']);
        Some(PlainNumber {
            prefix,
            is_negative: number.starts_with('-'),
            digits,
            whole,
            fraction: Some(rest).filter(|rest| !has_exponent && !rest.trim_matches('0').is_empty()),
            has_exponent,
        })
    }

    /// Returns whether it has a sign, a fraction, and many digits.
    fn features(&self) -> [bool; 3] {
        [
            self.is_negative,
            self.fraction.is_some(),
            self.whole.len() > 1 || self.has_exponent,
        ]
    }

    /// Returns the number with fewer of sign, fraction and size, the plainest first.
    fn plainer(&self) -> Vec<String> {
        let (no, yes) = (false, true);
        let kept = [
            [no, no, no],
            [yes, no, no],
            [no, yes, no],
            [no, no, yes],
            [yes, yes, no],
            [yes, no, yes],
            [no, yes, yes],
        ];
        let has = self.features();
        let are_there = |kept: &[bool; 3]| kept.iter().zip(has).all(|(kept, has)| !kept || has);
        // The digits of a number with an exponent stay together.
        let is_whole = |[_, fraction, large]: &[bool; 3]| !self.has_exponent || !fraction && !large;
        let with = |[negative, fraction, large]: [bool; 3]| {
            let whole = if large { self.whole } else { "1" };
            let rest = match self.fraction.filter(|_| fraction) {
                Some(_) if !large => ".5".to_owned(),
                Some(digits) => format!(".{digits}"),
                None if self.digits.contains('.') => ".0".to_owned(),
                None => String::new(),
            };
            format!("{}{}{whole}{rest}", self.prefix, if negative { "-" } else { "" })
        };
        let sign = if self.is_negative { "-" } else { "" };
        let own = format!("{}{sign}{}", self.prefix, self.digits);
        let plainer = kept.into_iter().filter(are_there).filter(is_whole).map(with);
        plainer.filter(|text| *text != own).collect()
    }
}

/// Returns the numbers of a program that are values; bounds, subscripts and bits are none.
fn plain_numbers<'p, 't: 'p, 's>(
    program: &'p ReadProgram<'t, 's>,
) -> impl Iterator<Item = (&'p Part<'t, 's>, PlainNumber<'s>)> {
    let beside = [Place::Limit, Place::Subscript, Place::Repetition, Place::Length];
    let values = program
        .literals()
        .filter(move |(part, _)| !beside.contains(&part.place));
    values.filter_map(|(part, literal)| Some((part, PlainNumber::read(literal)?)))
}

/// Plain literals of the types of durations, dates and times.
const MOMENTS: [(&str, &str); 5] = [
    ("TIME#", "T#1s"),
    ("T#", "T#1s"),
    ("DT#", "DT#2000-01-02-03:04:05"),
    ("D#", "D#2000-01-02"),
    ("TOD#", "TOD#03:04:05"),
];

/// Returns the durations, dates and times of a program that are not the plain ones, and the plain one of each type.
fn moments<'p, 't: 'p, 's>(
    program: &'p ReadProgram<'t, 's>,
) -> impl Iterator<Item = (&'p Part<'t, 's>, &'static str)> {
    let plain = |(part, literal): (&'p Part<'t, 's>, &str)| {
        let (_, plain) = MOMENTS.iter().find(|(prefix, _)| literal.starts_with(prefix))?;
        (literal != *plain).then_some((part, *plain))
    };
    program.literals().filter_map(plain)
}

/// Returns the changes that make a number, a date or a time of a program plainer.
pub(crate) fn plainer_numbers(program: &ReadProgram<'_, '_>) -> Vec<Edits> {
    let moments = moments(program).map(|(part, plain)| Edits::replacing(part.expression.span, plain));
    let change = |(part, number): (&Part<'_, '_>, PlainNumber<'_>)| {
        let span = part.expression.span;
        let plainer = number.plainer().into_iter();
        plainer.map(move |plainer| Edits::replacing(span, plainer))
    };
    plain_numbers(program).flat_map(change).chain(moments).collect()
}

/// Returns how far the types and the numbers of a program are from the plainest.
pub(crate) fn plainness(program: &ReadProgram<'_, '_>) -> u128 {
    let rank = |name: &str| match PLAIN.iter().position(|plain| *plain == name) {
        None if name != "BOOL" => PLAIN.len() as u128,
        place => place.unwrap_or_default() as u128,
    };
    let types: u128 = named_types(program.text).into_iter().map(rank).sum();
    let numbers = plain_numbers(program).map(|(_, number)| {
        let features = number.features().into_iter().filter(|is_there| *is_there).count();
        100 * features as u128
            + number.digits.len() as u128
            + u128::from(number.digits.trim_end_matches(['.', '0']) != "1")
    });
    1000 * types + numbers.sum::<u128>() + 100 * moments(program).count() as u128
}

/// Returns what is special about the numbers and the numeric types of a program that computes a wrong value.
pub(crate) fn value_features(program: &ReadProgram<'_, '_>) -> BTreeSet<String> {
    let names = ["negative number", "fraction", "large number"];
    let numbers = plain_numbers(program).flat_map(|(_, number)| names.into_iter().zip(number.features()));
    let numbers = numbers.filter(|(_, is_there)| *is_there).map(|(name, _)| name);
    let special = named_types(program.text).into_iter();
    let special = special.filter(|name| PLAIN.contains(name) && !matches!(*name, "INT" | "REAL"));
    numbers.chain(special).map(str::to_owned).collect()
}
