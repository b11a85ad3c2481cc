//! Properties of the choices from reals to integers, those that no dialect makes among them.

use super::draw::{conversion, each, number, one_of, raw};
use stickler_types::ElementaryType::{self, Lreal, Real};
use stickler_types::dialect::COMMON_CHOICES;
use stickler_types::{ConversionChoices, OutOfRange, Rounding};
use stickler_types::{Dialect, DialectName};

fn chosen(rounding: Rounding, out_of_range: OutOfRange) -> Dialect {
    Dialect {
        conversions: ConversionChoices {
            out_of_range,
            ..COMMON_CHOICES.with_rounding(rounding)
        },
        ..Dialect::of(DialectName::MATIEC).clone()
    }
}

const ROUNDINGS: [Rounding; 6] = [
    Rounding::Truncate,
    Rounding::HalfToEven,
    Rounding::HalfAwayFromZero,
    Rounding::Up,
    Rounding::Down,
    Rounding::AwayFromZero,
];

fn integers() -> Vec<ElementaryType> {
    ElementaryType::ALL
        .into_iter()
        .filter(|ty| ty.is_whole())
        .collect()
}

#[test]
fn each_rounding_keeps_its_promise() {
    let integers = integers();
    each(21, 60_000, |draw| {
        let (from, to) = (one_of(draw, &[Real, Lreal])?, one_of(draw, &integers)?);
        let rounding = one_of(draw, &ROUNDINGS)?;
        let value = raw(draw, from)?;
        let exact = number(value, from);
        let (low, high) = to.integer_range().expect("an integer");
        if !(exact.abs() < 4e18 && low < exact.floor() as i128 && (exact.ceil() as i128) < high) {
            return Ok(());
        }
        let result = conversion(from, to, &chosen(rounding, OutOfRange::Wrap))
            .expect("a function")
            .apply(value);
        let whole = to.integer_value(result);
        // Exact where the nearest integer or the one toward zero is meant, for then it is a part of the number.
        let rest = exact - whole as f64;
        let kept = match rounding {
            Rounding::Truncate => rest.abs() < 1.0 && rest * exact >= 0.0,
            Rounding::HalfToEven => rest.abs() < 0.5 || (rest.abs() == 0.5 && whole % 2 == 0),
            Rounding::HalfAwayFromZero => rest.abs() < 0.5 || (rest.abs() == 0.5 && rest * exact < 0.0),
            Rounding::Up => whole == exact.ceil() as i128,
            Rounding::Down => whole == exact.floor() as i128,
            Rounding::AwayFromZero => whole.unsigned_abs() == exact.abs().ceil() as u128,
        };
        assert!(kept, "{rounding:?}: {exact:?} of {from} to {to} is {whole}");
        Ok(())
    });
}

#[test]
fn what_saturates_is_monotonic_everywhere() {
    let integers = integers();
    each(22, 60_000, |draw| {
        let (from, to) = (one_of(draw, &[Real, Lreal])?, one_of(draw, &integers)?);
        let dialect = chosen(one_of(draw, &ROUNDINGS)?, OutOfRange::Saturate);
        let conversion = conversion(from, to, &dialect).expect("a function");
        let (left, right) = (raw(draw, from)?, raw(draw, from)?);
        let result = |raw| to.integer_value(conversion.apply(raw));
        if number(left, from) <= number(right, from) {
            assert!(
                result(left) <= result(right),
                "{left:#x} and {right:#x} of {from} to {to}"
            );
        }
        Ok(())
    });
}

#[test]
fn inside_the_target_it_does_not_matter_what_happens_outside() {
    let integers = integers();
    each(23, 60_000, |draw| {
        let (from, to) = (one_of(draw, &[Real, Lreal])?, one_of(draw, &integers)?);
        let rounding = one_of(draw, &ROUNDINGS)?;
        let value = raw(draw, from)?;
        let apply = |outside| {
            conversion(from, to, &chosen(rounding, outside))
                .expect("a function")
                .apply(value)
        };
        let (wrapped, nearest) = (apply(OutOfRange::Wrap), apply(OutOfRange::Saturate));
        let (low, high) = to.integer_range().expect("an integer");
        let whole = to.integer_value(nearest);
        assert!(
            wrapped == nearest || whole == low || whole == high,
            "{value:#x} of {from} to {to}: {wrapped:#x} or {nearest:#x}"
        );
        Ok(())
    });
}
