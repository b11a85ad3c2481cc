//! Tests that a slice is converted as each of its values is. Sweeps of `stickler-conversions` compare the values with exact arithmetic.

use super::{Conversion, ConversionRule};
use stickler_types::dialect::COMMON_CHOICES;
use stickler_types::{ConversionChoices, ElementaryType, OutOfRange, Rounding, SplitMix64};

#[test]
fn many_values_are_converted_as_each_one_is() {
    let outside = |rounding| {
        OutOfRange::ALL
            .iter()
            .map(move |&out_of_range| (rounding, out_of_range))
    };
    let plain = || ElementaryType::ALL.into_iter().filter(|ty| !ty.is_text());
    for (rounding, out_of_range) in Rounding::ALL.into_iter().flat_map(outside) {
        let choices = ConversionChoices {
            out_of_range,
            ..COMMON_CHOICES.with_rounding(rounding)
        };
        for (from, to) in plain().flat_map(|from| plain().map(move |to| (from, to))) {
            let Some(rule) = ConversionRule::between(from, to, &choices) else {
                continue;
            };
            let conversion = Conversion { from, to, rule };
            let numbers = SplitMix64::new(7).numbers().take(40);
            let operands: Vec<u64> = numbers.map(|bits| crate::raw::narrow(bits, from)).collect();
            let mut results = vec![0; operands.len()];
            conversion.apply_to_slice(&operands, &mut results);
            let each: Vec<u64> = operands
                .iter()
                .map(|operand| conversion.apply(*operand))
                .collect();
            assert_eq!(results, each, "{conversion:?} of {operands:x?}");
        }
    }
}
