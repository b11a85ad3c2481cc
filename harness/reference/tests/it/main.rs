//! The reference from the outside, in one program: each of its own would be linked once more.

mod calls;
mod dialects;
mod hostile;
mod programs;
mod registry;
mod requests;
