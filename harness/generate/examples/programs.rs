//! Prints the programs of a dialect, by their seeds: `cargo run -p stickler-generate --example programs -- ironplc-ed3 7 8`.
use stickler_generate::generator::{GeneratorSettings, program};
use stickler_generate::writer::{Style, write};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let dialect = arguments
        .next()
        .ok_or("which dialect, and which seeds?")?
        .parse()?;
    let settings = GeneratorSettings::of(dialect);
    for seed in arguments {
        let bytes = bytes(seed.parse()?);
        let program = program(&bytes, &settings);
        println!("{}", write(&program, &Style::default()).text);
    }
    Ok(())
}

/// The bytes of a seed: programs of every size.
fn bytes(seed: u64) -> Vec<u8> {
    stickler_generate::random::bytes(seed, (seed * 7 % 3000) as usize)
}
