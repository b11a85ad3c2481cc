//! Prints the programs of a dialect, by their seeds: `cargo run -p stickler-generate --example programs -- ironplc-ed3 7 8`.

use arbitrary::Unstructured;
use stickler_generate::generator::{Settings, program};
use stickler_generate::writer::{Style, write};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let dialect = arguments
        .next()
        .ok_or("which dialect, and which seeds?")?
        .parse()?;
    let settings = Settings {
        dialect: Some(dialect),
        ..Settings::default()
    };
    for seed in arguments {
        let bytes = bytes(seed.parse()?);
        let program = program(&mut Unstructured::new(&bytes), &settings);
        println!("{}", write(&program, &Style::default()).text);
    }
    Ok(())
}

/// The bytes of a seed, by splitmix64; as many as the tests of this crate take.
fn bytes(seed: u64) -> Vec<u8> {
    let length = (seed * 7 % 3000) as usize;
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
