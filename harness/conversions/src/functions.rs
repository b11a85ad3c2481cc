//! The names of conversion functions: which there are, and in which dialects.

use stickler_types::DialectName;

/// How many names are suggested.
const MAX_SUGGESTIONS: usize = 5;

/// How many letters may be wrong in a name for another to be suggested.
const MAX_DISTANCE: usize = 3;

/// IronPLC's dialects, which differ in no conversion of the types that they share.
const IRONPLC: [DialectName; 3] = [
    DialectName::IronplcEd2,
    DialectName::IronplcEd3,
    DialectName::IronplcRusty,
];

/// The dialects that were asked for, parted by whether they have a function.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct FunctionDialects {
    /// Those that have it, in the order in which they were asked for; at least one.
    pub having: Vec<DialectName>,
    /// Those that lack it.
    pub lacking: Vec<DialectName>,
}

/// A name that is no conversion function of the dialects that were asked for.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum NoSuchFunction {
    /// No dialect has it.
    #[error("there is no conversion function `{function}`; {}`stickler conversions` lists all", did_you_mean(.similar))]
    Anywhere {
        /// The name as it was given.
        function: String,
        /// The names that differ least from it, if by little enough.
        similar: Vec<String>,
    },
    /// Other dialects have it.
    #[error(
        "there is no conversion function `{function}` in {}; it is one in {}",
        dialect_list(.asked),
        dialect_list(.elsewhere)
    )]
    InDialects {
        /// The name as it was given.
        function: String,
        /// The dialects that were asked for.
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

/// Looks a function up in the dialects that were asked for, or in all where none was.
///
/// # Errors
/// [`NoSuchFunction`] where none of them has it.
pub fn find_function(function: &str, asked: &[DialectName]) -> Result<FunctionDialects, NoSuchFunction> {
    let asked = if asked.is_empty() {
        &DialectName::ALL[..]
    } else {
        asked
    };
    let has = |dialect: &DialectName| !stickler_exact::signatures(function, *dialect).is_empty();
    let once = (0..asked.len()).filter(|&index| !asked[..index].contains(&asked[index]));
    let (having, lacking): (Vec<_>, Vec<_>) = once.map(|index| asked[index]).partition(has);
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
#[must_use]
pub fn all_functions() -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for dialect in DialectName::ALL {
        let known: std::collections::HashSet<String> = names.iter().cloned().collect();
        let functions = stickler_exact::functions(dialect);
        names.extend(functions.into_iter().filter(|name| !known.contains(name)));
    }
    names
}

/// Returns the names of dialects in one line.
#[must_use]
pub fn dialect_list(dialects: &[DialectName]) -> String {
    short_names(dialects).join(", ")
}

/// Returns the names of dialects, in few words: `every dialect` for all of them, `ironplc-*` for all of IronPLC's.
#[must_use]
pub fn short_names(dialects: &[DialectName]) -> Vec<String> {
    let all = |wanted: &[DialectName]| wanted.iter().all(|dialect| dialects.contains(dialect));
    if all(&DialectName::ALL) {
        return vec!["every dialect".to_owned()];
    }
    let together = all(&IRONPLC);
    let names = dialects.iter().filter_map(|dialect| match dialect {
        DialectName::IronplcEd2 if together => Some("ironplc-*".to_owned()),
        dialect if together && IRONPLC.contains(dialect) => None,
        dialect => Some(dialect.to_string()),
    });
    names.collect()
}

/// Returns the names that differ least, if by little enough.
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

#[cfg(test)]
mod tests {
    use super::{all_functions, dialect_list, find_function, similar};
    use stickler_types::DialectName;

    #[test]
    fn two_letters_in_the_wrong_order_are_put_right() {
        assert_eq!(similar("REAL_TO_DNIT"), ["REAL_TO_DINT"]);
        assert_eq!(similar("TRUNK"), ["TRUNC"]);
        assert!(similar("SIN").is_empty());
        assert!(similar("").is_empty());
    }

    #[test]
    fn a_function_of_other_dialects_is_told_from_one_of_none() {
        let error = find_function("ROUND", &[DialectName::Matiec])
            .unwrap_err()
            .to_string();
        assert!(
            error.contains("no conversion function `ROUND` in matiec"),
            "{error}"
        );
        assert!(error.contains("plcnext"), "{error}");
        let dialects = find_function("ROUND", &[]).unwrap();
        assert_eq!(dialects.lacking, [DialectName::Matiec]);
        let twice = [DialectName::Plcnext, DialectName::Plcnext];
        assert_eq!(
            find_function("ROUND", &twice).unwrap().having,
            [DialectName::Plcnext]
        );
    }

    #[test]
    fn dialects_that_belong_together_are_named_together() {
        assert_eq!(dialect_list(&DialectName::ALL), "every dialect");
        assert_eq!(dialect_list(&DialectName::ALL[..4]), "ironplc-*, matiec");
        assert_eq!(
            dialect_list(&[DialectName::IronplcEd3, DialectName::Plcnext]),
            "ironplc-ed3, plcnext"
        );
    }

    #[test]
    fn no_name_is_listed_twice() {
        let names = all_functions();
        let mut sorted = names.clone();
        sorted.sort();
        sorted.dedup();
        assert_eq!(sorted.len(), names.len());
        assert!(names.len() > 500, "{}", names.len());
    }
}
