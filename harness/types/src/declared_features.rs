//! The features of the language that a system declares to have or to lack.

use crate::ElementaryType;
use std::ops::RangeInclusive;

/// The features that the documents of a system say it has, and those that they say it lacks, by the keys of
/// `conformance-cases/features.toml`. What they do not name is left open.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct DeclaredFeatures {
    /// The edition of IEC 61131-3 whose features the system declares to have; `None` where it declares none.
    pub edition: Option<u8>,
    /// The features that it has besides those of its edition.
    pub has: Vec<String>,
    /// The features that it lacks, whatever its edition has.
    pub lacks: Vec<String>,
    /// The elementary types among these.
    pub lacked_types: Vec<ElementaryType>,
}

impl DeclaredFeatures {
    /// The features of a system that declares nothing.
    pub const NONE: DeclaredFeatures = DeclaredFeatures {
        edition: None,
        has: Vec::new(),
        lacks: Vec::new(),
        lacked_types: Vec::new(),
    };

    /// The editions of IEC 61131-3 that are told apart.
    pub const EDITIONS: RangeInclusive<u8> = 2..=4;
}
