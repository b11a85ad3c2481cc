//! Single values of every family, worked out by hand from the documents and from the definition of IEC 60559.

mod common;
mod moments;
mod numbers;
mod texts;
