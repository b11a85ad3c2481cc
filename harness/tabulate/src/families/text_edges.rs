//! Texts at the edges that [`super::texts`] leaves out, and all that no document says of them.

use super::words::{CONFORMANCE, NAMING, OPEN_PAIR, VALUES};
use crate::call::{Call, is_chosen};
use crate::class::{self, Class, Form, Voices};
use crate::inputs::edges::{of_format, of_precision};
use crate::inputs::integers::{BIT_STRINGS, INTEGERS, ascending, limits};
use crate::inputs::reals::{REALS, by_value, sorted};
use crate::inputs::texts::{
    AROUND_BOOL, AROUND_INTEGERS, AROUND_REALS, NO_NUMBERS, PLAIN_REALS, around_moments, operand,
};
use crate::operand::Operand;
use crate::program::PAIR_OF_VARIABLE;
use crate::sheet::Sheet;
use stickler_types::ElementaryType;
use stickler_types::ElementaryType::{
    Bool, Char, Date, Dt, Ldate, Ldt, Ltime, Ltod, String as Text, Time, Tod, Wchar, Wstring,
};

const FORM: Form = Form {
    columns: VALUES,
    open_columns: OPEN_PAIR,
    variable: PAIR_OF_VARIABLE,
    constant: None,
    recorded: true,
};

const CLASSES: [Class; 5] = [
    Class {
        name: "text-numbers",
        title: "Plain decimal numbers are read and written, each digit in its place",
        summary: "Powers of ten, the limits of each type, and fractions with so few digits that one real number alone has them.",
        voices: Voices::only_matiec(NAMING),
    },
    Class {
        name: "text-no-numbers",
        title: "More texts that are no number convert to 0, silently",
        summary: "",
        voices: Voices::only_matiec(CONFORMANCE),
    },
    Class {
        name: "text-never-faults",
        title: "A text that some systems read gives something and never stops the program, and so does any number as a text",
        summary: "\
Empty, blanks, signs, leading zeros, underscores, bases, typed literals, exponents, trailing text, too long, non-digits: the page says
neither which of them are numbers nor how a real number is written; the value is recorded.",
        voices: Voices::NAMED,
    },
    Class {
        name: "text-open",
        title: "Texts as bit strings, dates and wide texts, and back",
        summary: "No document says; the value is recorded. Wide texts also hold full-width digits.",
        voices: Voices::OPEN,
    },
    Class {
        name: "text-third-edition",
        title: "Texts and the types of the third edition, and characters as numbers and texts",
        summary: "No document says; the value is recorded. A CHAR has 8 bits and a WCHAR 16.",
        voices: Voices::THIRD_EDITION,
    },
];

/// The tables of this family. `already` are the calls that other tables make.
///
/// # Errors
/// What [`class::sheets`] says.
pub fn sheets(already: &[Call]) -> Result<Vec<Sheet>, String> {
    let mut calls = read_numbers();
    calls.extend(read_others());
    calls.extend(written());
    calls.extend(between_texts());
    calls.extend(characters());
    calls.retain(|call| !already.contains(call));
    let mut each_once: Vec<Call> = Vec::new();
    for call in calls {
        if !each_once.contains(&call) {
            each_once.push(call);
        }
    }
    class::sheets(&each_once, &CLASSES, FORM)
}

fn read(from: ElementaryType, to: ElementaryType, texts: &[&str]) -> Vec<Call> {
    let operands = texts.iter().map(|text| operand(from, text));
    operands.map(|operand| Call::convert(from, to, operand)).collect()
}

/// The first and about every third text, for a type that reads as another does.
fn some<'t>(texts: &[&'t str]) -> Vec<&'t str> {
    let texts = texts.iter().copied().enumerate();
    texts
        .filter(|(at, text)| *at == 0 || is_chosen(text, 3))
        .map(|(_, text)| text)
        .collect()
}

fn read_numbers() -> Vec<Call> {
    let mut calls = Vec::new();
    for to in INTEGERS {
        let plain = plain_numbers(to);
        let plain: Vec<&str> = plain.iter().map(String::as_str).collect();
        calls.extend(read(Text, to, &plain));
        calls.extend(read(Text, to, &NO_NUMBERS));
        calls.extend(read(Text, to, &AROUND_INTEGERS));
        calls.extend(read(Wstring, to, &some(&AROUND_INTEGERS)));
        // 42 in full-width digits, which only a wide text can hold.
        calls.push(Call::convert(
            Wstring,
            to,
            Operand::written(Wstring, "\"$FF14$FF12\""),
        ));
    }
    for to in BIT_STRINGS {
        calls.extend(read(Text, to, &some(&AROUND_INTEGERS)));
        calls.extend(read(
            Text,
            to,
            &[
                "'16#FF'",
                "'16#00FF'",
                "'255'",
                "'256'",
                "'-1'",
                "'16#10000000000000000'",
            ],
        ));
        calls.extend(read(Wstring, to, &["'16#FF'", "'255'"]));
    }
    for to in REALS {
        calls.extend(read(Text, to, &PLAIN_REALS));
        calls.extend(read(Text, to, &NO_NUMBERS));
        calls.extend(read(Text, to, &AROUND_REALS));
        calls.extend(read(Wstring, to, &some(&AROUND_REALS)));
    }
    calls
}

/// The limits of an integer type and one past them, and the powers of ten that it holds, as texts.
fn plain_numbers(ty: ElementaryType) -> Vec<String> {
    let (least, greatest) = limits(ty);
    let powers = (0..20)
        .map(|places| 10_i128.pow(places))
        .filter(|power| *power <= greatest);
    let mut numbers: Vec<i128> = powers.flat_map(|power| [power, -power]).collect();
    numbers.retain(|number| *number >= least);
    numbers.extend([least - 1, greatest + 1, 12, -12]);
    numbers.iter().map(|number| format!("'{number}'")).collect()
}

fn read_others() -> Vec<Call> {
    let mut calls = read(Text, Bool, &AROUND_BOOL);
    calls.extend(read(Wstring, Bool, &some(&AROUND_BOOL)));
    for to in [Time, Date, Tod, Dt, Ltime, Ldate, Ltod, Ldt] {
        calls.extend(read(Text, to, around_moments(to)));
        calls.extend(read(Wstring, to, &some(around_moments(to))));
    }
    calls
}

fn written() -> Vec<Call> {
    let mut operands: Vec<Operand> = Vec::new();
    for ty in INTEGERS {
        let (least, greatest) = limits(ty);
        let powers = (0..20).flat_map(|places| [10_i128.pow(places), -(10_i128.pow(places))]);
        operands.extend(ascending(ty, powers.chain([least, greatest, 12, -12])));
    }
    for ty in BIT_STRINGS {
        operands.extend(ascending(ty, [0, 1, 0xAB, limits(ty).1 / 2, limits(ty).1]));
    }
    for ty in REALS {
        let numbers = [
            "0.3",
            "0.30000001",
            "0.0001",
            "0.00001",
            "123456.7",
            "1234567.0",
            "1234567890123.0",
            "1.0E15",
            "1.0E16",
            "0.333333333333333333",
            "9999999999.5",
            "123456789.0",
        ];
        operands.extend(sorted(
            [
                of_format(ty),
                of_precision(ty),
                by_value(ty, &numbers.map(str::to_owned)),
            ]
            .concat(),
        ));
    }
    for ty in [Time, Ltime, Date, Ldate, Tod, Ltod, Dt, Ldt] {
        operands.extend(moments(ty).iter().map(|literal| Operand::read(ty, literal)));
    }
    operands.extend(["TRUE", "FALSE"].map(|literal| Operand::read(Bool, literal)));
    let mut calls = Vec::new();
    let mut last = None;
    for operand in operands {
        let stickler_types::Value::Plain { ty, .. } = operand.value else {
            continue;
        };
        // The first of each type, and about every third.
        if last.replace(ty) != Some(ty) || is_chosen(&operand.typed, 3) {
            calls.push(Call::convert(ty, Wstring, operand.clone()));
        }
        calls.push(Call::convert(ty, Text, operand));
    }
    calls
}

fn moments(ty: ElementaryType) -> &'static [&'static str] {
    match ty {
        Time | Ltime => &[
            "0ms",
            "-1.5ms",
            "1ns",
            "1500ms",
            "1d2h3m4s5ms",
            "106751d23h47m16s854ms775us807ns",
        ],
        Date | Ldate => &[
            "1970-01-01",
            "1969-12-31",
            "2024-02-29",
            "1677-09-22",
            "2262-04-11",
        ],
        Tod | Ltod => &["00:00:00", "12:34:56.789", "23:59:59.999999999", "01:02:03.5"],
        _ => &[
            "1970-01-01-00:00:00",
            "1969-12-31-23:59:59.999999999",
            "2024-02-29-12:34:56.5",
            "2038-01-19-03:14:08",
        ],
    }
}

fn between_texts() -> Vec<Call> {
    let narrow = [
        "''",
        "'abc'",
        "'a$$b'",
        "'$'quoted$''",
        "'$C4$FF'",
        "'$00'",
        "'$L$N$T'",
    ];
    let wide = [
        "\"\"",
        "\"abc\"",
        "\"$00E4\"",
        "\"$20AC5\"",
        "\"$0000\"",
        "\"$FF14$FF12\"",
        "\"$D83D$DE00\"",
    ];
    let mut calls: Vec<Call> = narrow
        .map(|text| Call::convert(Text, Wstring, Operand::written(Text, text)))
        .into();
    calls.extend(wide.map(|text| Call::convert(Wstring, Text, Operand::written(Wstring, text))));
    calls.extend(narrow.map(|text| Call::convert(Text, Char, Operand::written(Text, text))));
    calls.extend(narrow.map(|text| Call::convert(Text, Wchar, Operand::written(Text, text))));
    calls.extend(wide.map(|text| Call::convert(Wstring, Wchar, Operand::written(Wstring, text))));
    calls.extend(wide.map(|text| Call::convert(Wstring, Char, Operand::written(Wstring, text))));
    calls
}

fn characters() -> Vec<Call> {
    let mut calls = Vec::new();
    for (ty, literals) in [
        (Char, &["'a'", "'0'", "'$00'", "'$FF'", "'$''"]),
        (
            Wchar,
            &["\"a\"", "\"$0000\"", "\"$00FF\"", "\"$0100\"", "\"$FFFF\""],
        ),
    ] {
        let other = if ty == Char { Wchar } else { Char };
        let targets = INTEGERS
            .into_iter()
            .chain(BIT_STRINGS)
            .chain([other, Text, Wstring]);
        for to in targets {
            calls.extend(literals.map(|literal| Call::convert(ty, to, Operand::read(ty, literal))));
        }
        for from in INTEGERS.into_iter().chain(BIT_STRINGS) {
            let numbers = [
                limits(from).0,
                -1,
                0,
                48,
                97,
                255,
                256,
                65_535,
                65_536,
                limits(from).1,
            ];
            let operands = ascending(from, numbers).into_iter();
            calls.extend(operands.map(|operand| Call::convert(from, ty, operand)));
        }
    }
    calls
}
