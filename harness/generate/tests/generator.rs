//! What the generator promises: its programs are accepted, whatever the bytes.

use arbitrary::Unstructured;
use std::collections::BTreeMap;
use stickler_generate::generator::{Settings, program};
use stickler_generate::writer::{Style, write};
use stickler_types::DialectName;

/// So many bytes that look random, for the seed.
fn bytes(seed: u64, length: usize) -> Vec<u8> {
    let mut state = seed;
    let mut bytes = Vec::with_capacity(length + 8);
    while bytes.len() < length {
        state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (state ^ (state >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        bytes.extend((mixed ^ (mixed >> 31)).to_le_bytes());
    }
    bytes.truncate(length);
    bytes
}

/// How many programs of a dialect are made: `SEEDS` of the environment, or few.
fn seeds() -> u64 {
    let asked = std::env::var("SEEDS").ok();
    asked.and_then(|seeds| seeds.parse().ok()).unwrap_or(400)
}

#[test]
fn the_reference_accepts_every_program() {
    let mut rejected = BTreeMap::new();
    for dialect in DialectName::ALL {
        let settings = Settings {
            dialect: Some(dialect),
            ..Settings::default()
        };
        for seed in 0..seeds() {
            let bytes = bytes(seed, (seed * 7 % 3000) as usize);
            let program = program(&mut Unstructured::new(&bytes), &settings);
            let text = write(&program, &Style::default()).text;
            if let Some(first) = stickler_reference::check(&text, dialect).first() {
                let count: &mut (usize, String) = rejected.entry(first.code).or_default();
                count.0 += 1;
                let line = text.lines().nth(first.line as usize - 1).unwrap_or_default();
                if count.0 <= 3 {
                    count.1 += &format!("{dialect}, seed {seed}: {}: {line}\n", first.message);
                }
            }
        }
    }
    let shown: Vec<String> = rejected
        .iter()
        .map(|(code, (count, text))| format!("{code:?}, {count} times: {text}"))
        .collect();
    assert!(shown.is_empty(), "{}", shown.join("\n"));
}
