//! TIME as a number of milliseconds, and back: the tables of what a document says.

use super::words::{ALL, DESIGN, NAMING, OPEN_PAIR, PAIR};
use crate::call::Call;
use crate::inputs::integers::{INTEGERS, ascending, limits};
use crate::inputs::moments::{MILLISECOND, milliseconds};
use crate::inputs::reals::REALS;
use crate::operand::Operand;
use crate::program::{PAIR_OF_CONSTANT, PAIR_OF_VARIABLE};
use crate::sheet::{CallProbe, Sheet};
use stickler_types::DialectName;
use stickler_types::ElementaryType::{Dint, Lint, Lreal, Real, Time};

/// A day in milliseconds.
const DAY: i128 = 86_400_000;

/// The tables of this family.
pub fn sheets() -> Vec<Sheet> {
    let (exact, inexact) = time_to_number();
    vec![exact, inexact, number_to_time()]
}

fn time_to_number() -> (Sheet, Sheet) {
    let mut calls = Vec::new();
    for to in INTEGERS {
        let (least, greatest) = limits(to);
        let floor = -(1 << 31);
        let mut numbers = vec![
            0,
            1,
            1500,
            -1,
            -1500,
            DAY,
            greatest,
            least.max(floor),
            greatest + 1,
            100_000,
        ];
        numbers.sort_unstable();
        numbers.dedup();
        let durations = milliseconds(Time, &numbers).into_iter();
        calls.extend(durations.map(|operand| Call::convert(Time, to, operand)));
    }
    for to in REALS {
        let durations = milliseconds(Time, &[0, 1, 1500, -1, -1500, DAY, (1 << 24) + 1]).into_iter();
        calls.extend(durations.map(|operand| Call::convert(Time, to, operand)));
    }
    let (exact, mut inexact): (Vec<Call>, Vec<Call>) = calls
        .into_iter()
        .partition(|call| call.basis(DialectName::Matiec).is_some());
    for to in [Dint, Lint, Real, Lreal] {
        let fractions = ["TIME#1.5ms", "TIME#-1.5ms", "TIME#999us", "TIME#1us"];
        inexact.extend(fractions.map(|literal| Call::convert(Time, to, Operand::written(Time, literal))));
    }
    let exact = Sheet {
        name: "time-to-number",
        title: "TIME converts to a number of milliseconds",
        basis: NAMING,
        dialects: ALL.to_vec(),
        summary:
            "\"TIME_TO_DINT (returns ms), TIME_TO_REAL\": 64 bits of milliseconds into REAL round to nearest."
                .to_owned(),
        columns: PAIR,
        calls: exact,
        probes: CallProbe::variable_and_constant(ALL, &[], PAIR_OF_VARIABLE, PAIR_OF_CONSTANT),
    };
    let inexact = Sheet {
        name: "time-to-number-inexact",
        title: "TIME that the target cannot hold exactly",
        basis: DESIGN,
        dialects: ALL.to_vec(),
        summary: "Fractions of a millisecond, negative durations in unsigned types, and durations too long: no document says; recorded."
            .to_owned(),
        columns: OPEN_PAIR,
        calls: inexact,
        probes: vec![CallProbe::recorded(&[], PAIR_OF_VARIABLE)],
    };
    (exact, inexact)
}

fn number_to_time() -> Sheet {
    let mut calls = Vec::new();
    for from in INTEGERS {
        let (least, greatest) = limits(from);
        let fits = |number: i128| i64::try_from(number * MILLISECOND).is_ok();
        let longest = if fits(greatest) { greatest } else { DAY };
        let shortest = if fits(least) { least } else { -DAY };
        let numbers = [0, 1, greatest.min(1500), longest, least.max(-1), shortest];
        let operands = ascending(from, numbers).into_iter();
        calls.extend(operands.map(|operand| Call::convert(from, Time, operand)));
    }
    for from in REALS {
        let literals = ["0.0", "1.0", "1500.0", "-1500.0", "86400000.0"];
        calls.extend(literals.map(|literal| Call::convert(from, Time, Operand::read(from, literal))));
    }
    Sheet {
        name: "number-to-time",
        title: "A number converts to TIME as milliseconds",
        basis: NAMING,
        dialects: ALL.to_vec(),
        summary: "\"DINT_TO_TIME (interprets as ms)\".".to_owned(),
        columns: PAIR,
        calls,
        probes: CallProbe::variable_and_constant(ALL, &[], PAIR_OF_VARIABLE, PAIR_OF_CONSTANT),
    }
}
