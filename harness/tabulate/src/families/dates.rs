//! Dates, times of day and both together: the functions that the ForgeIEC page lists, and all others.

use super::words::{ALL, ELSEWHERE, MATIEC, NAMING, OPEN_PAIR, VALUES};
use crate::call::Call;
use crate::class::{self, Class, Form, Voices};
use crate::column::Column;
use crate::inputs::integers::{BIT_STRINGS, INTEGERS, ascending};
use crate::inputs::moments::{DATES, FAR_DATES, FINE_TIMES, TIMES_OF_DAY, ends};
use crate::inputs::reals::{REALS, by_value};
use crate::operand::Operand;
use crate::program::{CONCATENATION, PAIR_OF_TYPED_INPUT, PAIR_OF_VARIABLE};
use crate::sheet::{CallProbe, Sheet};
use stickler_types::ElementaryType;
use stickler_types::ElementaryType::{Bool, Date, Dt, Ldate, Ldt, Ltod, Tod};

const FORM: Form = Form {
    columns: VALUES,
    open_columns: OPEN_PAIR,
    variable: PAIR_OF_VARIABLE,
    constant: Some(PAIR_OF_TYPED_INPUT),
    recorded: true,
};

/// The tables of this family.
///
/// # Errors
/// What [`class::sheets`] says.
pub fn sheets() -> Result<Vec<Sheet>, String> {
    let mut sheets = vec![listed()];
    sheets.extend(far()?);
    sheets.extend(other()?);
    sheets.extend(concatenation()?);
    Ok(sheets)
}

/// Each date with each time of day.
fn moments(ty: ElementaryType, dates: &[&str], times: &[&str]) -> Vec<Operand> {
    let pairs = dates
        .iter()
        .flat_map(|date| times.iter().map(move |time| (date, time)));
    pairs
        .map(|(date, time)| Operand::read(ty, &format!("{date}-{time}")))
        .collect()
}

fn listed() -> Sheet {
    let dates = DATES.map(|date| Call::convert(Date, Dt, Operand::read(Date, date)));
    let mut calls = Vec::from(dates);
    for to in [Date, Tod] {
        let operands = moments(Dt, &DATES, &TIMES_OF_DAY).into_iter();
        calls.extend(operands.map(|operand| Call::convert(Dt, to, operand)));
    }
    Sheet {
        name: "dates",
        title: "DATE_TO_DT is midnight; DT_TO_DATE and DT_TO_TOD take a DATE_AND_TIME apart",
        basis: NAMING,
        dialects: ALL.to_vec(),
        summary: "Leap days, the ends of years, the second that overflows 32 bits, and 2100, which is no leap year."
            .to_owned(),
        columns: VALUES,
        calls,
        probes: CallProbe::variable_and_constant(MATIEC, ELSEWHERE, PAIR_OF_VARIABLE, PAIR_OF_TYPED_INPUT),
    }
}

fn far() -> Result<Vec<Sheet>, String> {
    let dates = FAR_DATES.map(|date| Call::convert(Date, Dt, Operand::read(Date, date)));
    let mut calls = Vec::from(dates);
    // All but the last day, which 64 bits do not reach to its end.
    let days = &FAR_DATES[..FAR_DATES.len() - 1];
    let mut operands = moments(
        Dt,
        days,
        &["00:00:00", "00:00:00.000000001", "23:59:59.999999999"],
    );
    operands.extend(moments(
        Dt,
        &["1969-12-31", "1970-01-01", "2024-02-29"],
        &FINE_TIMES[1..3],
    ));
    operands.extend(moments(
        Dt,
        &["2038-01-19", "2106-02-07"],
        &["03:14:07", "03:14:08", "06:28:15", "06:28:16"],
    ));
    operands.extend(ends(Dt));
    for to in [Date, Tod] {
        calls.extend(
            operands
                .iter()
                .map(|operand| Call::convert(Dt, to, operand.clone())),
        );
    }
    let classes = [
        Class {
            name: "dates-far",
            title: "Dates before 1970, beside midnight, and at the ends of what 64 bits of nanoseconds reach",
            summary: "1700, 1900, 2100 and 2200 are no leap years. A moment before 1970 lies in the day that began before it.",
            voices: Voices::only_matiec(NAMING),
        },
        Class {
            name: "dates-never-fault",
            title: "The first moment of all belongs to a day that began before it, and never stops the program",
            summary: "Which day DT_TO_DATE then gives no document says; the value is recorded.",
            voices: Voices::NAMED,
        },
    ];
    class::sheets(&calls, &classes, FORM)
}

/// The types that the ForgeIEC page's three functions do not join: as numbers, and as one another.
fn other() -> Result<Vec<Sheet>, String> {
    let mut calls = Vec::new();
    let numbers = || INTEGERS.into_iter().chain(BIT_STRINGS).chain(REALS).chain([Bool]);
    for ty in [Date, Dt, Ldate, Ldt] {
        for number in numbers() {
            let operands = instants(ty).into_iter();
            calls.extend(operands.map(|operand| Call::convert(ty, number, operand)));
            let operands = counts(number).into_iter();
            calls.extend(operands.map(|operand| Call::convert(number, ty, operand)));
        }
    }
    for (from, to) in [
        (Date, Ldate),
        (Date, Ldt),
        (Ldate, Date),
        (Ldate, Dt),
        (Ldate, Ldt),
        (Dt, Ldate),
        (Dt, Ltod),
        (Dt, Ldt),
        (Ldt, Date),
        (Ldt, Ldate),
        (Ldt, Tod),
        (Ldt, Ltod),
        (Ldt, Dt),
    ] {
        let operands = instants(from).into_iter();
        calls.extend(operands.map(|operand| Call::convert(from, to, operand)));
    }
    let classes = [
        Class {
            name: "dates-never-fault-as-bool",
            title: "A date or a moment as a BOOL gives something and never stops the program",
            summary: "The page lists <x>_TO_BOOL; which dates are 0 it does not say; the value is recorded.",
            voices: Voices::NAMED,
        },
        Class {
            name: "dates-as-numbers",
            title: "A date or a moment as a number, and a number as one",
            summary: "No document says what is counted, seconds or days or nanoseconds, nor from when; the value is recorded.",
            voices: Voices::OPEN,
        },
        Class {
            name: "long-dates",
            title: "LDATE and LDT as numbers, and as their short forms",
            summary: "No document says what is counted; the value is recorded.",
            voices: Voices::THIRD_EDITION,
        },
    ];
    let form = Form {
        constant: None,
        ..FORM
    };
    class::sheets(&calls, &classes, form)
}

/// Some moments of a type: the epoch, beside it, a leap day, and the ends.
fn instants(ty: ElementaryType) -> Vec<Operand> {
    let literals: &[&str] = match ty {
        Date | Ldate => &[
            "1970-01-01",
            "1969-12-31",
            "1970-01-02",
            "2024-02-29",
            "2106-02-07",
            "1677-09-22",
        ],
        _ => &[
            "1970-01-01-00:00:00",
            "1969-12-31-23:59:59.999999999",
            "1970-01-01-00:00:01.5",
            "2024-02-29-12:34:56.789",
            "2038-01-19-03:14:08",
            "2262-04-11-23:47:16.854775807",
        ],
    };
    literals
        .iter()
        .map(|literal| Operand::read(ty, literal))
        .collect()
}

/// Some numbers to be taken for a moment.
fn counts(ty: ElementaryType) -> Vec<Operand> {
    if ty.is_real() {
        let literals = ["-1.0", "0.5", "86399.0", "86400.5", "1.0E10", "3.0E38"];
        return by_value(ty, &literals.map(str::to_owned));
    }
    let (least, greatest) = super::super::inputs::integers::limits(ty);
    ascending(ty, [least, 0, 1, greatest, 86_399, 86_400, 9_223_372_036])
}

fn concatenation() -> Result<Vec<Sheet>, String> {
    const DAYS: [&str; 6] = [
        "1677-09-22",
        "1969-12-31",
        "1970-01-01",
        "2024-02-29",
        "2100-02-28",
        "2262-04-11",
    ];
    const TIMES: [&str; 4] = [
        "00:00:00",
        "00:00:00.000000001",
        "12:34:56.789",
        "23:59:59.999999999",
    ];
    let mut calls = Vec::new();
    for (date, time, result) in [(Date, Tod, Dt), (Date, Ltod, Ldt), (Ldate, Ltod, Ldt)] {
        let pairs = DAYS.iter().flat_map(|day| TIMES.map(|clock| (*day, clock)));
        calls.extend(pairs.map(|(day, clock)| {
            let operands = vec![Operand::read(date, day), Operand::read(time, clock)];
            Call::new(&format!("CONCAT_{date}_{time}"), operands, result)
        }));
    }
    let classes = [
        Class {
            name: "concat-date-tod",
            title: "CONCAT_DATE_TOD joins a date and a time of day",
            summary: "No document of a dialect has it; the standard does. On the last day 64 bits of nanoseconds overflow. The value is recorded.",
            voices: Voices::OPEN,
        },
        Class {
            name: "concat-long-dates",
            title: "CONCAT_DATE_LTOD and CONCAT_LDATE_LTOD join a date and a time of day to an LDT",
            summary: "",
            voices: Voices::THIRD_EDITION,
        },
    ];
    let columns = &[
        Column::Function,
        Column::From,
        Column::SecondFrom,
        Column::To,
        Column::Input,
        Column::Second,
    ];
    let form = Form {
        columns,
        open_columns: columns,
        variable: CONCATENATION,
        constant: None,
        recorded: true,
    };
    class::sheets(&calls, &classes, form)
}
