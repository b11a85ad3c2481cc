//! Texts for the functions that parse or measure them: error-prone ones written by hand, one of each length, and generated number-like ones.

use std::sync::LazyLock;
use stickler_types::{ElementaryType, SplitMix64};

/// Returns texts written by hand, of every kind that the readers of numbers, BOOL, durations and dates tell apart.
pub fn by_hand(ty: ElementaryType) -> Vec<Vec<u16>> {
    let long = [
        "0".repeat(300) + "1",
        "1".repeat(300),
        " ".repeat(200) + "7",
        "0.".to_owned() + &"0".repeat(200) + "1",
        "x".repeat(1000),
        // Just above and just below the middle between two REALs, and between two LREALs.
        "1.000000059604644775390626".to_owned(),
        "1.000000059604644775390625".to_owned(),
        "9007199254740993.0".to_owned(),
        "9007199254740993.00000000000000000000001".to_owned(),
    ];
    let short = SHORT.lines().map(shown);
    let units = |text: String| text.encode_utf16().collect();
    let of_length = |length| (0..length).map(|at| LIMITS[at % LIMITS.len()]).collect();
    short
        .map(units)
        .chain((0..=MAX_LENGTH).map(of_length))
        .chain(long.into_iter().map(units))
        .chain(wide(ty))
        .collect()
}

/// Returns texts that only a WSTRING holds (full-width digits, half of a surrogate pair), or their counterparts for a STRING.
fn wide(ty: ElementaryType) -> Vec<Vec<u16>> {
    match ty {
        ElementaryType::Wstring => vec![
            "１２".encode_utf16().collect(),
            vec![0x663],
            vec![0xD800],
            vec![0x31, 0x2003],
        ],
        _ => vec![vec![0x31, 0xA0], vec![0xFF]],
    }
}

/// The length of the longest text that every system holds in a STRING that is declared for it.
const MAX_LENGTH: usize = 254;

/// The first and the last printable characters of ASCII and of a single byte, of which there is a text of each length.
const LIMITS: [u16; 4] = [0x20, 0x7E, 0xA0, 0xFF];

/// Texts written by hand, one a line; [`shown`] says how blanks stand in them.
const SHORT: &str = include_str!("texts.txt");

/// The pieces of generated texts; digits are more frequent than the rest.
static PIECES: LazyLock<Vec<String>> =
    LazyLock::new(|| include_str!("pieces.txt").lines().map(shown).collect());

/// Returns the text of a line, in which `␠`, `␉`, `␊` and `␀` stand for the characters that nobody would see.
fn shown(line: &str) -> String {
    let visible = ["␠", "␉", "␊", "␀"].into_iter().zip([" ", "\t", "\n", "\0"]);
    visible.fold(line.to_owned(), |text, (sign, character)| {
        text.replace(sign, character)
    })
}

/// Generates a number-like text: an integer, a real number with or without an exponent, or random pieces.
pub fn made_up(random: SplitMix64) -> Vec<u16> {
    let sign = ["", "", "-", "+"][(random.at(0) % 4) as usize];
    let number = random.at(1) >> (random.at(2) % 64);
    let text = match random.at(3) % 8 {
        0..3 => format!("{sign}{number}"),
        3 => format!("{sign}{number}.{}", random.at(4) >> (random.at(5) % 64)),
        4 => format!(
            "{sign}{}.{}E{}",
            number % 1_000,
            random.at(4) >> (random.at(5) % 64),
            (random.at(6) % 800).cast_signed() - 400
        ),
        5 => format!("{}{sign}{number}{}", spaces(random.at(4)), spaces(random.at(5))),
        _ => (0..random.at(4) % 12)
            .map(|place| PIECES[(random.at(8 + place) % PIECES.len() as u64) as usize].as_str())
            .collect(),
    };
    text.encode_utf16().collect()
}

const fn spaces(random: u64) -> &'static str {
    match random % 4 {
        0 => " ",
        1 => "  ",
        _ => "",
    }
}
