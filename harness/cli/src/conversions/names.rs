//! The names of conversion functions: which there are, and what somebody meant who wrote another.

use anyhow::bail;
use stickler_types::DialectName;

/// How many names are suggested.
const MOST: usize = 5;

/// How many letters may be wrong in a name for another to be suggested.
const NEAR: usize = 3;

/// IronPLC's dialects, which differ in no conversion of the types that they share.
const IRONPLC: [DialectName; 3] = [
    DialectName::IronplcEd2,
    DialectName::IronplcEd3,
    DialectName::IronplcRusty,
];

/// Which of the dialects that were asked for have a function.
pub struct Present {
    /// Those that have it, in the order in which they were asked for; at least one.
    pub having: Vec<DialectName>,
    /// Those that do not.
    pub lacking: Vec<DialectName>,
}

/// Looks a function up in the dialects that were asked for, or in all where none was.
///
/// # Errors
/// Where none of them has it: with the dialects that do, or else the names that look like it.
pub fn present(function: &str, asked: &[DialectName]) -> anyhow::Result<Present> {
    let asked = if asked.is_empty() {
        &DialectName::ALL[..]
    } else {
        asked
    };
    let has = |dialect: &DialectName| !stickler_exact::signatures(function, *dialect).is_empty();
    let once = (0..asked.len()).filter(|&index| !asked[..index].contains(&asked[index]));
    let (having, lacking): (Vec<_>, Vec<_>) = once.map(|index| asked[index]).partition(has);
    if !having.is_empty() {
        return Ok(Present { having, lacking });
    }
    let elsewhere: Vec<DialectName> = DialectName::ALL.into_iter().filter(has).collect();
    if elsewhere.is_empty() {
        bail!("{}", unknown(function));
    }
    bail!(
        "there is no conversion function `{function}` in {}; it is one in {}",
        listed(&lacking),
        listed(&elsewhere)
    )
}

/// The names of all conversion functions of all dialects, each once.
pub fn all() -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for dialect in DialectName::ALL {
        let known: std::collections::HashSet<String> = names.iter().cloned().collect();
        let functions = stickler_exact::functions(dialect);
        names.extend(functions.into_iter().filter(|name| !known.contains(name)));
    }
    names
}

/// Dialects in one line.
pub fn listed(dialects: &[DialectName]) -> String {
    short(dialects).join(", ")
}

/// The names of dialects, in few words: `every dialect` for all of them, `ironplc-*` for all of IronPLC's.
pub fn short(dialects: &[DialectName]) -> Vec<String> {
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

fn unknown(function: &str) -> String {
    let nearest = nearest(function);
    let all = "`stickler conversions` lists all";
    match nearest.is_empty() {
        true => format!("there is no conversion function `{function}`; {all}"),
        false => format!(
            "there is no conversion function `{function}`; did you mean {}? {all}",
            nearest.join(", ")
        ),
    }
}

/// The names that differ least, if by little enough.
fn nearest(function: &str) -> Vec<String> {
    let distances: Vec<(usize, String)> = all()
        .into_iter()
        .map(|name| (strsim::damerau_levenshtein(&name, function), name))
        .collect();
    let least = distances.iter().map(|(distance, _)| *distance).min();
    let limit = least.filter(|least| *least <= NEAR && *least < function.len() / 2);
    distances
        .into_iter()
        .filter(|(distance, _)| Some(*distance) == limit)
        .map(|(_, name)| name)
        .take(MOST)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{all, nearest, present};
    use stickler_types::DialectName;

    #[test]
    fn two_letters_in_the_wrong_order_are_put_right() {
        assert_eq!(nearest("REAL_TO_DNIT"), ["REAL_TO_DINT"]);
        assert_eq!(nearest("TRUNK"), ["TRUNC"]);
        assert!(nearest("SIN").is_empty());
        assert!(nearest("").is_empty());
    }

    #[test]
    fn a_function_of_other_dialects_is_told_from_one_of_none() {
        let error = present("ROUND", &[DialectName::Matiec])
            .err()
            .unwrap()
            .to_string();
        assert!(
            error.contains("no conversion function `ROUND` in matiec"),
            "{error}"
        );
        assert!(error.contains("plcnext"), "{error}");
        let present = present("ROUND", &[]).ok().unwrap();
        assert_eq!(present.lacking, [DialectName::Matiec]);
        let twice = [DialectName::Plcnext, DialectName::Plcnext];
        assert_eq!(
            super::present("ROUND", &twice).ok().unwrap().having,
            [DialectName::Plcnext]
        );
    }

    #[test]
    fn dialects_that_belong_together_are_named_together() {
        let listed = super::listed;
        assert_eq!(listed(&DialectName::ALL), "every dialect");
        assert_eq!(listed(&DialectName::ALL[..4]), "ironplc-*, matiec");
        assert_eq!(
            listed(&[DialectName::IronplcEd3, DialectName::Plcnext]),
            "ironplc-ed3, plcnext"
        );
    }

    #[test]
    fn no_name_is_listed_twice() {
        let names = all();
        let mut sorted = names.clone();
        sorted.sort();
        sorted.dedup();
        assert_eq!(sorted.len(), names.len());
        assert!(names.len() > 500, "{}", names.len());
    }
}
