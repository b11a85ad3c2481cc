//! Types and values from the outside, in one program: each of its own would be linked once more.

mod dates_and_times;
mod elementary_types;
mod values;
