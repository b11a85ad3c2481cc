//! The word that applies to a cell of a matrix in a dialect: that of the matrix, or that of the dialect's definition.
//!
//! Basis: conformance-cases/README.md (a matrix of types).

use stickler_types::{DialectName, ElementaryType, MatrixWord};

use crate::table::probe::Probe;
use crate::table::types::TypeInfo;

/// The word that applies to a cell, and its origin.
#[derive(Clone, Copy)]
pub(super) struct CellWord {
    pub(super) word: MatrixWord,
    /// The dialect whose definition states the word, with the basis; `None` if the word is that of the matrix.
    pub(super) stated: Option<(DialectName, &'static str)>,
}

/// Returns the words that apply to a cell, each with its dialects: that of the matrix, or that of a dialect's definition. A
/// definition overrides only the words about implicit conversion.
pub(super) fn words(
    probe: &Probe<'_>,
    row: &str,
    column: &TypeInfo,
    word: MatrixWord,
    dialects: &[DialectName],
) -> Vec<(CellWord, Vec<DialectName>)> {
    let stated = |dialect: &DialectName| {
        let pair = (
            ElementaryType::from_name(row)?,
            ElementaryType::from_name(&column.name)?,
        );
        // The tables that name a variant say what its documents do.
        let own = dialect.definition().filter(|_| !dialect.is_variant())?;
        let stated = own.implicit(pair.0, pair.1)?;
        let basis = stated.basis.as_deref()?;
        Some(CellWord {
            word: stated.value,
            stated: Some((*dialect, basis)),
        })
    };
    let by_matrix = CellWord { word, stated: None };
    if dialects.iter().all(|dialect| dialect.definition().is_none()) || !probe.is_implicit_conversion() {
        return vec![(by_matrix, dialects.to_vec())];
    }
    let (others, overriding): (Vec<DialectName>, Vec<DialectName>) =
        dialects.iter().partition(|dialect| stated(dialect).is_none());
    let mut words = vec![(by_matrix, others)];
    words.extend(
        overriding
            .iter()
            .filter_map(|dialect| Some((stated(dialect)?, vec![*dialect]))),
    );
    words
}
