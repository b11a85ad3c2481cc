//! Boundary values with their neighbours on both sides.

use crate::{ElementaryType, Family};
use std::collections::BTreeSet;

/// The number of neighbours that are added to each boundary value.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum BoundaryDetail {
    /// Many neighbours: some ten thousand values of a type, for computation within one process.
    Fine,
    /// The nearest neighbours: some thousand values of a type, for an engine that must be asked for each.
    Coarse,
}

impl BoundaryDetail {
    /// Returns how far the neighbourhood of an integer reaches to either side.
    const fn integers(self) -> i128 {
        match self {
            BoundaryDetail::Fine => 64,
            BoundaryDetail::Coarse => 2,
        }
    }

    /// Returns the number of representable numbers on either side of a real one that belong to its neighbourhood.
    const fn reals(self) -> u64 {
        match self {
            BoundaryDetail::Fine => 8,
            BoundaryDetail::Coarse => 1,
        }
    }

    /// Returns the number up to which each half is a boundary of its own.
    const fn halves(self) -> u128 {
        match self {
            BoundaryDetail::Fine => 2_048,
            BoundaryDetail::Coarse => 8,
        }
    }

    /// Returns the step from one power of two to the next, where no integer is near.
    const fn powers(self) -> usize {
        match self {
            BoundaryDetail::Fine => 1,
            BoundaryDetail::Coarse => 16,
        }
    }
}

const SECOND: i128 = 1_000_000_000;
const DAY: i128 = 86_400 * SECOND;

/// Returns the raw forms of a type's boundaries and of their neighbours, each once, in the order of their bits; none for a text.
pub fn neighbourhoods(ty: ElementaryType, detail: BoundaryDetail) -> Vec<u64> {
    let raws: BTreeSet<u64> = match ty.family() {
        Family::Boolean | Family::Signed | Family::Unsigned | Family::BitString | Family::Character => {
            integers(ty, detail)
        }
        Family::Real => reals(ty, detail),
        Family::Duration | Family::DateAndTime => moments().map(i64::cast_unsigned).collect(),
        Family::Date => moments().map(whole_day).map(i64::cast_unsigned).collect(),
        Family::TimeOfDay => moments()
            .map(|moment| moment.rem_euclid(DAY as i64).cast_unsigned())
            .collect(),
        Family::Text => BTreeSet::new(),
    };
    raws.into_iter().collect()
}

/// Returns the numbers around zero, the powers of two (which include the limits of every type) and the powers of ten (where
/// decimal digits run out).
fn integers(ty: ElementaryType, detail: BoundaryDetail) -> BTreeSet<u64> {
    let powers_of_two = (0..=64).map(|n| 1_i128 << n);
    let powers_of_ten = (1..=19).map(|n| 10_i128.pow(n));
    // The greatest digits of one, two … places, in the coded form.
    let coded = (1..=16).map(|places| 0x9999_9999_9999_9999_i128 & ((1 << (4 * places)) - 1));
    let reach = detail.integers();
    let around = |centre: i128| (centre - reach..=centre + reach).flat_map(|number| [number, -number]);
    // A number that the type does not hold stands for the one with the same bits, which is as good.
    powers_of_two
        .chain(powers_of_ten)
        .chain(coded)
        .flat_map(around)
        .map(|number| ty.wrap(number))
        .collect()
}

/// Returns the numbers around zero, the powers of two, small halves, the limits of the integers and halves beside them, the
/// largest finite number, the infinity, and NaNs of each kind; and all of them with a minus.
fn reals(ty: ElementaryType, detail: BoundaryDetail) -> BTreeSet<u64> {
    let format = RealFormat::of(ty);
    let mut raws = BTreeSet::new();
    let mut around = |raw: u64| {
        let (least, greatest) = (
            raw.saturating_sub(detail.reals()),
            raw.saturating_add(detail.reals()),
        );
        for near in least..=greatest.min(format.sign - 1) {
            raws.extend([near, near | format.sign]);
        }
    };
    around(0);
    for power in (1..=2 * format.bias).step_by(detail.powers()) {
        around(power << format.fraction_bits);
    }
    // Infinity stands behind the largest finite number, and after it the NaNs; the quiet ones begin half way.
    around(format.infinity());
    around(format.infinity() | 1 << (format.fraction_bits - 1));
    around(format.sign - 1);
    for halves in 0..2 * detail.halves() {
        around(format.halves(halves));
    }
    for bits in 7..=64 {
        // The limit, and up to three halves beside it on each side.
        for halves in -3..=3 {
            around(format.halves((2_u128 << bits).saturating_add_signed(halves)));
        }
    }
    raws
}

/// The position of the parts of a real type's bits.
struct RealFormat {
    fraction_bits: u32,
    bias: u64,
    sign: u64,
}

impl RealFormat {
    const fn of(ty: ElementaryType) -> RealFormat {
        match ty {
            ElementaryType::Real => RealFormat {
                fraction_bits: 23,
                bias: 127,
                sign: 1 << 31,
            },
            _ => RealFormat {
                fraction_bits: 52,
                bias: 1023,
                sign: 1 << 63,
            },
        }
    }

    const fn infinity(&self) -> u64 {
        (2 * self.bias + 1) << self.fraction_bits
    }

    /// Returns the raw form of `count` halves; bits that the fraction cannot hold are dropped.
    fn halves(&self, count: u128) -> u64 {
        let Some(highest) = count.checked_ilog2() else {
            return 0;
        };
        let aligned = match self.fraction_bits.checked_sub(highest) {
            Some(left) => count << left,
            None => count >> (highest - self.fraction_bits),
        };
        // The leading bit, which is not written, is one of the exponent's.
        let biased = self.bias + u64::from(highest) - 2;
        (biased << self.fraction_bits) + aligned as u64
    }
}

/// Returns the nanoseconds around zero, the units, days, the beginnings of selected years and their leap days, the limits
/// of the integers in nanoseconds, milliseconds and seconds, and the limits of 64 bits.
fn moments() -> impl Iterator<Item = i64> {
    let units = [0, 1_000, 1_000_000, SECOND, 60 * SECOND, 3_600 * SECOND, DAY];
    let limits = [7, 8, 15, 16, 31, 32, 63].map(|bits| 1_i128 << bits);
    let in_units = limits
        .into_iter()
        .flat_map(|limit| [limit, limit * 1_000_000, limit * SECOND]);
    let centres = units.into_iter().chain(in_units).chain(turns_of_days());
    centres
        .flat_map(|centre| NEAR.into_iter().flat_map(move |by| [centre + by, centre - by]))
        .flat_map(|nanoseconds| [nanoseconds, -nanoseconds])
        .filter_map(|nanoseconds| i64::try_from(nanoseconds).ok())
}

/// Distances from a boundary at which a fraction of a unit, a second or a day converts differently.
const NEAR: [i128; 14] = [
    0,
    1,
    499_999,
    500_000,
    500_001,
    999_999,
    1_000_000,
    1_000_001,
    SECOND / 2,
    SECOND - 1,
    SECOND,
    DAY - SECOND,
    DAY - 1,
    DAY,
];

/// The first and the last year that 64 bits reach, centuries with and without a leap day, and the years in which counters
/// overflow.
const YEARS: [i128; 14] = [
    1678, 1700, 1900, 1969, 1970, 1972, 1999, 2000, 2024, 2038, 2100, 2106, 2200, 2262,
];

/// Returns the beginnings of 1 January and of the sixtieth day of [`YEARS`], in nanoseconds since 1970.
fn turns_of_days() -> impl Iterator<Item = i128> {
    let leap_days = |year: i128| {
        let before = year - 1;
        before / 4 - before / 100 + before / 400
    };
    YEARS.into_iter().flat_map(move |year| {
        let days = 365 * (year - 1970) + leap_days(year) - leap_days(1970);
        [days * DAY, (days + 59) * DAY]
    })
}

/// Returns the beginning of the day on which a moment lies, if 64 bits hold it; otherwise that of the next day.
fn whole_day(nanoseconds: i64) -> i64 {
    let day = DAY as i64;
    let behind_midnight = nanoseconds.rem_euclid(day);
    nanoseconds
        .checked_sub(behind_midnight)
        .unwrap_or_else(|| nanoseconds + (day - behind_midnight))
}
