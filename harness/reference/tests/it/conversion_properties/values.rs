//! Properties of conversions between values that are no texts.

use super::draw::{conversion, dialects, each, number, one_of, pairs, raw, same};
use stickler_reference::conversion::{Conversion, ConversionRule, function, implicit};
use stickler_types::{Dialect, DialectName};
use stickler_types::{ElementaryType, Family, MomentUnits, OutOfRange};

/// Returns whether a conversion keeps this value: its target holds it.
fn holds(conversion: Conversion, raw: u64) -> bool {
    let Conversion { from, to, .. } = conversion;
    let whole = |ty: ElementaryType| ty.is_whole() || ty == ElementaryType::Bool;
    match (from.family(), to.family()) {
        _ if whole(from) && whole(to) => to.holds(from.integer_value(raw)),
        (_, Family::Real) if whole(from) => {
            let digits = if to == ElementaryType::Real { 24 } else { 53 };
            from.integer_value(raw).unsigned_abs() <= 1 << digits
        }
        (Family::Real, _) if whole(to) => {
            let value = number(raw, from);
            let exact =
                value.abs() < 1e18 && value.fract() == 0.0 && !(value == 0.0 && value.is_sign_negative());
            exact && to.holds(value as i128)
        }
        (Family::Real, Family::Real) => {
            to == ElementaryType::Lreal || {
                let value = number(raw, from);
                value.is_nan() || f64::from(value as f32) == value
            }
        }
        (Family::Duration, _) if to.is_integer() => {
            let nanoseconds = from.integer_value(raw);
            nanoseconds % 1_000_000 == 0 && to.holds(nanoseconds / 1_000_000)
        }
        (_, Family::Duration) if from.is_integer() => from.integer_value(raw).abs() <= 9_223_372_036_854,
        (left, right) => left == right && left != Family::Character,
    }
}

/// Returns whether a duration, date or time of day is an integer that wraps, of which these properties do not hold.
fn wraps_moments(pair: &Conversion, dialect: &Dialect) -> bool {
    let units = dialect.conversions.moment_units;
    let counts = units == MomentUnits::Counts || units == MomentUnits::ShortTime;
    counts && (pair.from.is_moment() || pair.to.is_moment())
}

#[test]
fn what_fits_a_type_comes_back_from_it() {
    let mut kept = 0;
    for dialect in dialects() {
        let pairs = pairs(dialect);
        let plain: Vec<_> = pairs
            .into_iter()
            .filter(|pair| !pair.from.is_text() && !pair.to.is_text())
            .filter(|pair| !wraps_moments(pair, dialect))
            .collect();
        each(1, 40_000, |draw| {
            let there = one_of(draw, &plain)?;
            let value = raw(draw, there.from)?;
            // Bits that are copied back bring the highest one with them.
            let back = conversion(there.to, there.from, dialect);
            let Some(back) = back.filter(|back| holds(there, value) && back.rule != ConversionRule::CopyBits)
            else {
                return Ok(());
            };
            let returned = back.apply(there.apply(value));
            assert!(
                same(returned, value, there.from),
                "{}: {value:#x} of {} by way of {} is {returned:#x}",
                dialect.name,
                there.from,
                there.to
            );
            kept += 1;
            Ok(())
        });
    }
    assert!(kept > 50_000, "only {kept} values fitted");
}

#[test]
fn the_implicit_conversion_and_the_function_agree() {
    for dialect in dialects() {
        let allowed: Vec<_> = pairs(dialect)
            .into_iter()
            .filter_map(|pair| Some((pair, implicit(pair.from, pair.to, dialect)?)))
            .collect();
        assert_eq!(allowed.is_empty(), dialect.name == DialectName::MATIEC);
        each(2, 20_000, |draw| {
            if allowed.is_empty() {
                return Ok(());
            }
            let (function, implicit) = one_of(draw, &allowed)?;
            let value = raw(draw, function.from)?;
            assert_eq!(
                function.apply(value),
                implicit.apply(value),
                "{}: {value:#x} of {} to {}",
                dialect.name,
                function.from,
                function.to
            );
            Ok(())
        });
    }
}

/// The order of two values of a type; `None` where one is no number.
fn order(left: u64, right: u64, ty: ElementaryType) -> Option<std::cmp::Ordering> {
    if ty.is_real() {
        number(left, ty).partial_cmp(&number(right, ty))
    } else {
        Some(ty.integer_value(left).cmp(&ty.integer_value(right)))
    }
}

/// Returns whether a conversion cannot wrap at this value.
fn stays_within(conversion: Conversion, raw: u64) -> bool {
    const MILLION: i128 = 1_000_000;
    let Conversion { from, to, rule } = conversion;
    let units = match rule {
        ConversionRule::ToUnits(units)
        | ConversionRule::FromUnits(units)
        | ConversionRule::FromRealUnits(units) => units,
        _ => MomentUnits::Seconds,
    };
    let in_days = matches!(
        units,
        MomentUnits::DaysAndMilliseconds | MomentUnits::DaysSince1990
    );
    // The days from 1970 to the date that counts as 0.
    let zero = match units {
        MomentUnits::DaysSince1990 if [from.family(), to.family()].contains(&Family::Date) => 7_305,
        _ => 0,
    };
    // Nanoseconds in the unit in which the type is counted.
    let unit = |ty: ElementaryType| match ty.family() {
        Family::Date if in_days => 86_400_000 * MILLION,
        Family::Date | Family::DateAndTime if !in_days => 1_000 * MILLION,
        _ => MILLION,
    };
    let number = number(raw, from);
    match (from.family(), to.family()) {
        (Family::Real, Family::Boolean) | (_, Family::Real) => true,
        (Family::TimeOfDay, Family::Duration) => true,
        (Family::Real, _) if to.is_moment() => {
            let most = (i64::MAX as f64) / unit(to) as f64;
            let day = to.family() == Family::TimeOfDay;
            if day {
                (0.0..8.6e7).contains(&number)
            } else {
                number.abs() < most * 0.9
            }
        }
        // Rounding up at the upper limit may leave the type.
        (Family::Real, _) => {
            number.abs() < 1e19 && to.holds(number as i128) && to.holds(number.round() as i128)
        }
        _ if from.is_moment() && to.is_moment() => to.family() != Family::TimeOfDay,
        _ if from.is_moment() => {
            to == ElementaryType::Bool || to.holds(from.integer_value(raw) / unit(from) - zero)
        }
        (_, Family::TimeOfDay) => (0..86_400_000).contains(&from.integer_value(raw)),
        _ if to.is_moment() => from.integer_value(raw).abs() <= i128::from(i64::MAX) / unit(to) - zero,
        (_, Family::Character) => from.integer_value(raw) >= 0 && from.integer_value(raw) < 128,
        (_, Family::Boolean) => true,
        _ => to.holds(from.integer_value(raw)),
    }
}

#[test]
fn a_conversion_is_monotonic_where_it_does_not_wrap() {
    let mut compared = 0;
    for dialect in dialects() {
        let ordered: Vec<_> = pairs(dialect)
            .into_iter()
            .filter(|pair| !pair.from.is_text() && !pair.to.is_text())
            .filter(|pair| !wraps_moments(pair, dialect))
            // Zero is less than TRUE from both sides.
            .filter(|pair| pair.to != ElementaryType::Bool)
            // The bits of a real are in another order than the numbers, and so are those of an integer with a sign.
            .filter(|pair| pair.rule != ConversionRule::CopyBits)
            .filter(|pair| pair.rule != ConversionRule::Keep || pair.from.is_real() == pair.to.is_real())
            .collect();
        each(3, 60_000, |draw| {
            let conversion = one_of(draw, &ordered)?;
            let (from, to) = (conversion.from, conversion.to);
            let (left, right) = (raw(draw, from)?, raw(draw, from)?);
            let Some(before) = order(left, right, from) else {
                return Ok(());
            };
            if !stays_within(conversion, left) || !stays_within(conversion, right) {
                return Ok(());
            }
            let after = order(conversion.apply(left), conversion.apply(right), to);
            assert!(
                after.is_some_and(|after| after == before || after.is_eq()),
                "{}: {left:#x} and {right:#x} of {from} to {to}: {before:?} became {after:?}",
                dialect.name
            );
            compared += 1;
            Ok(())
        });
    }
    assert!(compared > 60_000, "only {compared} pairs of values were compared");
}

#[test]
fn truncation_never_grows_in_magnitude() {
    let names: Vec<_> = ElementaryType::ALL
        .into_iter()
        .filter(|ty| ty.is_integer())
        .map(|to| format!("TRUNC_{to}"))
        .chain(["TRUNC".to_owned()])
        .collect();
    for dialect in dialects() {
        each(4, 30_000, |draw| {
            let name = draw.choose(&names)?;
            let from = one_of(draw, &[ElementaryType::Real, ElementaryType::Lreal])?;
            let function = function(name, dialect).expect("every dialect truncates");
            let to = function.result_type(from, None);
            let value = raw(draw, from)?;
            let (number, result) = (number(value, from), function.conversion(from, to).apply(value));
            // One choice truncates to 32 bits first, whatever the target.
            let is_lost = dialect.conversions.truncation_out_of_range == OutOfRange::Indefinite32
                && i32::try_from(number as i128).is_err();
            if is_lost || !(number.abs() < 1e19 && to.holds(number as i128)) {
                return Ok(());
            }
            // A number without its fraction has no more digits than with it.
            let whole = to.integer_value(result) as f64;
            let rest = number - whole;
            assert!(
                whole.abs() <= number.abs() && rest.abs() < 1.0 && whole * number >= 0.0,
                "{}: {name}({number:?}) is {whole}",
                dialect.name
            );
            Ok(())
        });
    }
}
