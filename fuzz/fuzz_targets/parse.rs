//! Fuzz target `parse`.
fn main() {}
