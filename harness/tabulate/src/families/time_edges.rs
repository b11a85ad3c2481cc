//! Durations at the edges that [`super::times`] leaves out, and all that no document says of them.

use super::words::{NAMING, OPEN_PAIR, VALUES};
use crate::call::{Call, is_chosen};
use crate::class::{self, Class, Form, Voices};
use crate::inputs::integers::{BIT_STRINGS, INTEGERS, ascending, limits};
use crate::inputs::moments::{
    MILLISECOND, durations_for, ends, fractions_of_a_millisecond, milliseconds, nanoseconds,
};
use crate::inputs::reals::{REALS, by_value};
use crate::operand::Operand;
use crate::program::PAIR_OF_VARIABLE;
use crate::sheet::Sheet;
use stickler_types::ElementaryType;
use stickler_types::ElementaryType::{Bool, Ltime, Ltod, Time, Tod};

const FORM: Form = Form {
    columns: VALUES,
    open_columns: OPEN_PAIR,
    variable: PAIR_OF_VARIABLE,
    constant: None,
    recorded: true,
};

const CLASSES: [Class; 4] = [
    Class {
        name: "time-edges",
        title: "Whole milliseconds arrive as far as the target holds them, in both directions",
        summary: "The limits of each integer type in milliseconds, and the longest durations of 64 bits of nanoseconds.",
        voices: Voices::all(NAMING),
    },
    Class {
        name: "time-edges-never-fault",
        title: "A duration that the other type cannot hold gives something and never stops the program",
        summary: "\
Fractions of a millisecond, negative durations, what is too long, TIME as bits or BOOL: the page lists TIME_TO_<x> and <x>_TO_TIME, and
says only of whole milliseconds what they give; the value is recorded.",
        voices: Voices::NAMED,
    },
    Class {
        name: "time-of-day-as-number",
        title: "A time of day as a number, and a number as a time of day",
        summary: "No document says what it counts; the value is recorded. A number of more than a day is among the inputs.",
        voices: Voices::OPEN,
    },
    Class {
        name: "ltime-and-ltod",
        title: "LTIME and LTOD as numbers, and as their short forms",
        summary: "No document says what they count, nor what a duration of more than a day is as a time of day; the value is recorded.",
        voices: Voices::THIRD_EDITION,
    },
];

/// The tables of this family. `already` are the calls that other tables make.
///
/// # Errors
/// What [`class::sheets`] says.
pub fn sheets(already: &[Call]) -> Result<Vec<Sheet>, String> {
    let mut calls = Vec::new();
    for number in numbers() {
        calls.extend(to_number(Time, number));
        calls.extend(from_number(number, Time));
        for ty in [Tod, Ltime, Ltod] {
            calls.extend(few(to_number(ty, number)));
            calls.extend(few(from_number(number, ty)));
        }
    }
    for (from, to) in [
        (Time, Ltime),
        (Ltime, Time),
        (Time, Tod),
        (Time, Ltod),
        (Ltime, Tod),
        (Ltime, Ltod),
    ] {
        let operands = durations(from).into_iter();
        calls.extend(operands.map(|operand| Call::convert(from, to, operand)));
    }
    for (from, to) in [
        (Tod, Ltod),
        (Ltod, Tod),
        (Tod, Time),
        (Tod, Ltime),
        (Ltod, Time),
        (Ltod, Ltime),
    ] {
        let operands = times_of_day(from).into_iter();
        calls.extend(operands.map(|operand| Call::convert(from, to, operand)));
    }
    calls.retain(|call| !already.contains(call));
    class::sheets(&calls, &CLASSES, FORM)
}

fn numbers() -> impl Iterator<Item = ElementaryType> {
    INTEGERS.into_iter().chain(BIT_STRINGS).chain(REALS).chain([Bool])
}

fn to_number(from: ElementaryType, to: ElementaryType) -> Vec<Call> {
    let operands = match from {
        Tod | Ltod => times_of_day(from),
        _ if to == Bool => durations(from),
        _ if to.is_real() => {
            let mut operands = milliseconds(
                from,
                &[(1 << 24) - 1, (1 << 24) + 3, 1 << 31, -(1 << 31), 1 << 42],
            );
            operands.extend(fractions_of_a_millisecond(from));
            operands.extend(ends(from));
            operands
        }
        _ => durations_for(from, to),
    };
    let calls = operands
        .into_iter()
        .map(|operand| Call::convert(from, to, operand));
    calls.collect()
}

fn from_number(from: ElementaryType, to: ElementaryType) -> Vec<Call> {
    let operands = if from.is_real() {
        let literals = [
            "0.5",
            "-0.5",
            "1.5",
            "0.0000005",
            "0.0000015",
            "0.1",
            "1.0E-45",
            "9.0E12",
            // Odd, and so many nanoseconds that no LREAL is that number.
            "8999999999999.0",
            "-8999999999999.0",
            "9.3E12",
            "-9.3E12",
            "1.0E20",
            "86399999.0",
            "86400000.0",
            "86400001.0",
            "3.0E38",
        ];
        by_value(from, &literals.map(str::to_owned))
    } else {
        let (least, greatest) = limits(from);
        // The longest duration in milliseconds, and the first that is too long; a day.
        let longest = i128::from(i64::MAX) / MILLISECOND;
        let mut numbers = vec![least, -1, 0, 1, greatest, 86_399_999, 86_400_000, 86_400_001];
        numbers.extend([-longest - 1, -longest, longest, longest + 1, 1 << 31, 1 << 32]);
        ascending(from, numbers)
    };
    let calls = operands
        .into_iter()
        .map(|operand| Call::convert(from, to, operand));
    calls.collect()
}

/// The first and about every third of them: where a rule was tried with another type already.
fn few(calls: Vec<Call>) -> impl Iterator<Item = Call> {
    let calls = calls.into_iter().enumerate();
    calls
        .filter(|(at, call)| *at == 0 || is_chosen(&call.to_string(), 3))
        .map(|(_, call)| call)
}

fn durations(ty: ElementaryType) -> Vec<Operand> {
    const DAY: i128 = 86_400_000;
    let mut durations = milliseconds(ty, &[0, 1, -1, DAY - 1, DAY, DAY + 1, -DAY, 10 * DAY]);
    durations.extend(
        [1, -1, 1_500_000]
            .into_iter()
            .filter_map(|number| nanoseconds(ty, number)),
    );
    durations.extend(ends(ty));
    durations
}

fn times_of_day(ty: ElementaryType) -> Vec<Operand> {
    let times = [
        "00:00:00",
        "00:00:00.000000001",
        "00:00:00.0005",
        "00:00:00.001",
        "00:00:01",
        "12:34:56.789",
        "23:59:59.999",
        "23:59:59.999999999",
    ];
    times.map(|time| Operand::read(ty, time)).into()
}
