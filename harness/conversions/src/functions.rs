//! The catalogue of conversion functions: the names that exist, the dialects that have them, and suggestions for misspelt ones.

use std::collections::HashSet;
use stickler_exact::{Signature, elementary_signatures, signatures};
use stickler_types::{DialectName, distinct};

/// The maximum number of names that are suggested for an unknown one.
const MAX_SUGGESTIONS: usize = 5;

/// The maximum edit distance, in letters, between an unknown name and a suggested one.
const MAX_DISTANCE: usize = 3;

/// IronPLC's dialects, which differ in no conversion of the types that they share.
const IRONPLC: [DialectName; 3] = [
    DialectName::IRONPLC_ED2,
    DialectName::IRONPLC_ED3,
    DialectName::IRONPLC_RUSTY,
];

/// The requested dialects, divided into those that have a function and those that lack it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct FunctionDialects {
    /// The dialects that have the function, in the order of the request; at least one.
    pub having: Vec<DialectName>,
    /// The dialects that lack the function.
    pub lacking: Vec<DialectName>,
}

/// The error for a name that is no conversion function of the requested dialects.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum NoSuchFunction {
    /// No dialect has the function.
    #[error("there is no conversion function `{function}`; {}`stickler conversions` lists all", did_you_mean(.similar))]
    Anywhere {
        /// The name as it was given.
        function: String,
        /// The most similar names of functions; none where all differ too much.
        similar: Vec<String>,
    },
    /// Only other dialects than the requested ones have the function.
    #[error(
        "there is no conversion function `{function}` in {}; it is one in {}",
        dialect_list(.asked),
        dialect_list(.elsewhere)
    )]
    InDialects {
        /// The name as it was given.
        function: String,
        /// The requested dialects.
        asked: Vec<DialectName>,
        /// The dialects that have it.
        elsewhere: Vec<DialectName>,
    },
}

fn did_you_mean(similar: &[String]) -> String {
    match similar {
        [] => String::new(),
        _ => format!("did you mean {}? ", similar.join(", ")),
    }
}

/// Returns the signatures of a function that can be swept: of a conversion function or, of a name that is none, of a standard function of one
/// operand.
pub fn swept_signatures(function: &str, dialect: DialectName) -> Vec<Signature> {
    let own = signatures(function, dialect);
    match own.is_empty() {
        true => elementary_signatures(function, dialect),
        false => own,
    }
}

/// Looks a function up in the requested dialects, or in all dialects where none is requested; `signatures` tells which a dialect has.
///
/// # Errors
/// [`NoSuchFunction`] where none of these dialects has the function.
pub fn find_function(
    function: &str,
    asked: &[DialectName],
    signatures: fn(&str, DialectName) -> Vec<Signature>,
) -> Result<FunctionDialects, NoSuchFunction> {
    let asked = if asked.is_empty() {
        &DialectName::ALL[..]
    } else {
        asked
    };
    let has = |dialect: &DialectName| !signatures(function, *dialect).is_empty();
    let (having, lacking): (Vec<_>, Vec<_>) = distinct(asked.iter().copied()).into_iter().partition(has);
    if !having.is_empty() {
        return Ok(FunctionDialects { having, lacking });
    }
    let elsewhere: Vec<DialectName> = DialectName::ALL.into_iter().filter(has).collect();
    Err(match elsewhere.is_empty() {
        true => NoSuchFunction::Anywhere {
            function: function.to_owned(),
            similar: similar(function),
        },
        false => NoSuchFunction::InDialects {
            function: function.to_owned(),
            asked: lacking,
            elsewhere,
        },
    })
}

/// Returns the names of the conversion functions of all dialects, each once.
pub fn all_functions() -> Vec<String> {
    let mut known = HashSet::new();
    let all = DialectName::ALL.into_iter().flat_map(stickler_exact::functions);
    all.filter(|name| known.insert(name.clone())).collect()
}

/// Returns the names of dialects in one line.
pub fn dialect_list(dialects: &[DialectName]) -> String {
    short_names(dialects).join(", ")
}

/// Returns the names of dialects, in few words: `every dialect` for all of them, `ironplc-*` for all of IronPLC's.
pub fn short_names(dialects: &[DialectName]) -> Vec<String> {
    let all = |wanted: &[DialectName]| wanted.iter().all(|dialect| dialects.contains(dialect));
    if all(&DialectName::ALL) {
        return vec!["every dialect".to_owned()];
    }
    let together = all(&IRONPLC);
    let names = dialects.iter().filter_map(|&dialect| match dialect {
        DialectName::IRONPLC_ED2 if together => Some("ironplc-*".to_owned()),
        dialect if together && IRONPLC.contains(&dialect) => None,
        dialect => Some(dialect.to_string()),
    });
    names.collect()
}

/// Returns the names of functions that are nearest to an unknown name, within [`MAX_DISTANCE`] and half of its length.
fn similar(function: &str) -> Vec<String> {
    let distances: Vec<(usize, String)> = all_functions()
        .into_iter()
        .map(|name| (strsim::damerau_levenshtein(&name, function), name))
        .collect();
    let least = distances.iter().map(|(distance, _)| *distance).min();
    let limit = least.filter(|least| *least <= MAX_DISTANCE && *least < function.len() / 2);
    distances
        .into_iter()
        .filter(|(distance, _)| Some(*distance) == limit)
        .map(|(_, name)| name)
        .take(MAX_SUGGESTIONS)
        .collect()
}
