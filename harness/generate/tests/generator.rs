//! What the generator promises: its programs are accepted, whatever the bytes.

use arbitrary::Unstructured;
use stickler_generate::generator::{Settings, program};
use stickler_generate::writer::{Style, write};
use stickler_types::DialectName;

/// So many bytes that look random, for the seed.
fn bytes(seed: u64, length: usize) -> Vec<u8> {
    let mut state = seed;
    let mut bytes = Vec::with_capacity(length);
    while bytes.len() < length {
        state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (state ^ (state >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        bytes.extend((mixed ^ (mixed >> 31)).to_le_bytes());
    }
    bytes
}

#[test]
fn the_reference_accepts_every_program() {
    let seeds: u64 = std::env::var("SEEDS")
        .ok()
        .and_then(|seeds| seeds.parse().ok())
        .unwrap_or(300);
    for dialect in DialectName::ALL {
        let settings = Settings {
            dialect: Some(dialect),
            ..Settings::default()
        };
        for seed in 0..seeds {
            let bytes = bytes(seed, (seed % 2048) as usize);
            let program = program(&mut Unstructured::new(&bytes), &settings);
            let text = write(&program, &Style::default()).text;
            let diagnostics = stickler_reference::check(&text, dialect);
            assert!(
                diagnostics.is_empty(),
                "{dialect}, seed {seed}: {diagnostics:#?}\n{text}"
            );
        }
    }
}
