//! Binary-coded decimal: the ForgeIEC page's two functions, and the standard's names.

use super::words::{ALL, BCD, CONFORMANCE, ELSEWHERE, MATIEC, NAMED, NAMED_VALUES, OPEN_NAMED};
use crate::call::Call;
use crate::class::{self, Class, Form, Voices};
use crate::inputs::integers::{BIT_STRINGS, ascending, limits};
use crate::operand::Operand;
use crate::program::{FUNCTION_OF_CONSTANT, FUNCTION_OF_VARIABLE};
use crate::sheet::{CallProbe, Claim, Sheet};
use stickler_types::ElementaryType;
use stickler_types::ElementaryType::{Byte, Dint, Int, Udint, Uint, Ulint, Usint, Word};

/// The bits that spell a number's decimal digits, four bits a digit.
fn digits(number: i128) -> i128 {
    let written = number.to_string();
    written
        .bytes()
        .fold(0, |bits, digit| bits * 16 + i128::from(digit - b'0'))
}

/// The tables of this family. `already` are the calls that other tables make.
///
/// # Errors
/// What [`class::sheets`] says.
pub fn sheets() -> Result<Vec<Sheet>, String> {
    let (decimal, outside) = (decimal(), outside());
    let already = [&decimal.calls[..], &outside.calls].concat();
    let mut sheets = vec![decimal, outside];
    sheets.extend(every_digit(&already)?);
    Ok(sheets)
}

fn decimal() -> Sheet {
    const OF_BYTE: &[i128] = &[0, 1, 9, 10, 42, 50, 99];
    const OF_WORD: &[i128] = &[0, 9, 10, 99, 100, 1234, 9000, 9999];
    let sizes = [(Byte, OF_BYTE), (Word, OF_WORD)];
    let mut calls = Vec::new();
    for (bits, number) in sizes
        .iter()
        .flat_map(|(bits, numbers)| numbers.iter().map(move |n| (*bits, *n)))
    {
        let operand = Operand::number(bits, digits(number));
        calls.extend([Int, Dint].map(|to| Call::new("BCD_TO_INT", vec![operand.clone()], to)));
    }
    for from in [Int, Dint] {
        for (bits, number) in sizes
            .iter()
            .flat_map(|(bits, numbers)| numbers.iter().map(move |n| (*bits, *n)))
        {
            calls.push(Call::new("INT_TO_BCD", vec![Operand::number(from, number)], bits));
        }
    }
    Sheet {
        name: "bcd",
        title: "BCD_TO_INT and INT_TO_BCD convert between binary and packed decimal digits",
        basis: BCD,
        dialects: ALL.to_vec(),
        summary: "BYTE holds two digits, WORD four; both directions, INT and DINT. The function's result takes the type of its target."
            .to_owned(),
        columns: NAMED,
        calls,
        probes: CallProbe::variable_and_constant(MATIEC, ELSEWHERE, FUNCTION_OF_VARIABLE, FUNCTION_OF_CONSTANT),
    }
}

fn outside() -> Sheet {
    let wrong_digits = [
        (Byte, Int, 0x0A),
        (Byte, Int, 0xA0),
        (Byte, Int, 0xFF),
        (Word, Int, 0x00FA),
        (Word, Int, 0xFFFF),
        (Word, Dint, 0xABCD),
    ];
    let too_many = [
        (Int, Byte, 100),
        (Int, Byte, 255),
        (Int, Byte, -1),
        (Int, Word, 10_000),
        (Int, Word, -1),
        (Dint, Word, 123_456),
        (Dint, Word, -2_147_483_648),
    ];
    let call = |function: &'static str| {
        move |(from, to, number)| Call::new(function, vec![Operand::number(from, number)], to)
    };
    let wrong_digits = wrong_digits.into_iter().map(call("BCD_TO_INT"));
    let too_many = too_many.into_iter().map(call("INT_TO_BCD"));
    let never_raises = CallProbe {
        name: "never-raises",
        claim: Claim::Accepted,
        ..CallProbe::recorded(MATIEC, FUNCTION_OF_VARIABLE)
    };
    Sheet {
        name: "bcd-outside",
        title: "Digits above 9, and numbers with too many digits",
        basis: CONFORMANCE,
        dialects: ALL.to_vec(),
        summary: "\
\"Conversions that lose information silently truncate or wrap\": they are accepted and never stop the program. What they give is not said, and recorded."
            .to_owned(),
        columns: OPEN_NAMED,
        calls: wrong_digits.chain(too_many).collect(),
        probes: vec![never_raises, CallProbe::recorded(ELSEWHERE, FUNCTION_OF_VARIABLE)],
    }
}

/// Each digit in each place, and every spelling of the functions.
fn every_digit(already: &[Call]) -> Result<Vec<Sheet>, String> {
    let mut calls = Vec::new();
    for (bits, places) in [(Byte, 2), (Word, 4)] {
        let numbers = (0..places).flat_map(|place| (1..=9).map(move |digit| digit * 10_i128.pow(place)));
        for number in numbers {
            let (binary, coded) = (
                Operand::number(Int, number),
                Operand::number(bits, digits(number)),
            );
            calls.push(Call::new("BCD_TO_INT", vec![coded], Int));
            calls.push(Call::new("INT_TO_BCD", vec![binary], bits));
        }
        let wrong = (0..places).flat_map(|place| [0xA, 0xF].map(|digit| digit << (4 * place)));
        calls.extend(
            wrong.map(|number: i128| Call::new("BCD_TO_INT", vec![Operand::number(bits, number)], Dint)),
        );
    }
    for bits in BIT_STRINGS {
        for integer in [Usint, Uint, Udint, Ulint] {
            calls.extend(spelled(bits, integer));
        }
    }
    calls.retain(|call| !already.contains(call));
    let classes = [
        Class {
            name: "bcd-digits",
            title: "Each decimal digit stands for its place in BCD_TO_INT and INT_TO_BCD",
            summary: "",
            voices: Voices::only_matiec(BCD),
        },
        Class {
            name: "bcd-wrong-digits",
            title: "A digit above 9 in each place gives something and never stops the program",
            summary: "What it gives no document says; the value is recorded.",
            voices: Voices::NAMED,
        },
        Class {
            name: "bcd-other-names",
            title: "The standard's names: <BITS>_BCD_TO_<UINT>, BCD_TO_<UINT>, <UINT>_TO_BCD_<BITS>, TO_BCD_<BITS>",
            summary: "No document of a dialect has them; the value is recorded, also of digits above 9 and of numbers with too many digits.",
            voices: Voices::OPEN,
        },
    ];
    let form = Form {
        columns: NAMED_VALUES,
        open_columns: OPEN_NAMED,
        variable: FUNCTION_OF_VARIABLE,
        constant: None,
        recorded: true,
    };
    class::sheets(&calls, &classes, form)
}

/// Calls of the four names that join a bit string and an unsigned integer.
fn spelled(bits: ElementaryType, integer: ElementaryType) -> Vec<Call> {
    let greatest = limits(bits).1;
    let nines = greatest / 0xF * 9;
    let coded = ascending(
        bits,
        [
            0,
            9,
            0x10,
            0x42,
            0x99,
            0x0100,
            nines,
            greatest / 0xF,
            greatest,
            0x0A,
            greatest / 0xF * 0xA,
        ],
    );
    let too_great = i128::from(u64::MAX).min(limits(integer).1);
    let fitting = digits_of(bits);
    let binary = ascending(
        integer,
        [0, 9, 10, 42, 99, fitting - 1, fitting, fitting + 1, too_great],
    );
    let mut calls = Vec::new();
    for operand in coded {
        calls.push(Call::new(
            &format!("{bits}_BCD_TO_{integer}"),
            vec![operand.clone()],
            integer,
        ));
        if operand.raw().count_ones() % 2 == 0 {
            calls.push(Call::new(&format!("BCD_TO_{integer}"), vec![operand], integer));
        }
    }
    for operand in binary {
        calls.push(Call::new(
            &format!("{integer}_TO_BCD_{bits}"),
            vec![operand.clone()],
            bits,
        ));
        if operand.raw() % 2 == 0 {
            calls.push(Call::new(&format!("TO_BCD_{bits}"), vec![operand], bits));
        }
    }
    calls
}

/// The least number that has too many digits for a bit string.
fn digits_of(bits: ElementaryType) -> i128 {
    10_i128.pow(bits.bits() / 4)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_is_spelled_in_its_own_digits() {
        assert_eq!(digits(0), 0);
        assert_eq!(digits(1_234), 0x1234);
        assert_eq!(digits_of(Byte), 100);
    }
}
