//! Whole programs through the public face: what each stage does only counts once they work together.

mod arithmetic;
mod conversions;
mod faults;
mod flow;
mod hostile;
mod pous;
mod rejected;
mod scans;
mod suggestions;
mod support;
mod variables;
