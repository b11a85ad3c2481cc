//! Tests of the generator from the outside, in one program, because each program of its own would be linked once more.

mod execute;
mod generator;
mod mutations;
mod operands;
mod telling;
mod writer;

/// Returns the number of programs to make: `SEEDS` of the environment, or few.
fn seeds(few: u64) -> u64 {
    let asked = std::env::var("SEEDS").ok();
    asked.and_then(|seeds| seeds.parse().ok()).unwrap_or(few)
}
