//! The versions of a compiler for which a claim holds, compared by their numbers.

use std::fmt;

/// The versions of a compiler for which a claim holds: all of them where neither end is stated.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Versions {
    /// The first version of which the claim is known to hold.
    pub since: Option<String>,
    /// The last version of which the claim is known to hold.
    pub until: Option<String>,
}

impl Versions {
    /// Returns whether the claim holds for a version, as a compiler says it; `false` of one without a number where an end is stated.
    pub fn include(&self, version: &str) -> bool {
        let numbers = version_numbers(version);
        let is_after = |since: &String| numbers.is_some() && numbers >= version_numbers(since);
        let is_before = |until: &String| numbers.is_some() && numbers <= version_numbers(until);
        self.since.as_ref().is_none_or(is_after) && self.until.as_ref().is_none_or(is_before)
    }

    /// Returns whether the claim begins after a version, as a compiler says it; `false` of one without a number.
    pub fn begin_after(&self, version: &str) -> bool {
        let since = self.since.as_deref().and_then(version_numbers);
        since.is_some_and(|since| version_numbers(version).is_some_and(|version| version < since))
    }

    /// Ends the claim with a version, unless it ends earlier.
    pub fn ending_with(self, until: &str) -> Versions {
        let is_earlier = |known: &String| version_numbers(known) <= version_numbers(until);
        let until = self.until.filter(is_earlier).unwrap_or_else(|| until.to_owned());
        Versions {
            until: Some(until),
            ..self
        }
    }

    /// Returns what is wrong with the ends: one without a number, or a first version behind the last one.
    pub fn mistake(&self) -> Option<String> {
        let mut ends = self.since.iter().chain(&self.until);
        if let Some(end) = ends.find(|end| version_numbers(end).is_none()) {
            return Some(format!(
                "`{end}` is no version that can be compared; write numbers, as in `0.239`"
            ));
        }
        let (since, until) = (self.since.as_ref()?, self.until.as_ref()?);
        (version_numbers(since) > version_numbers(until)).then(|| {
            format!(
                "the claims begin after they end: `since` is {since} and `until` is {until}; exchange them, or take one out"
            )
        })
    }
}

/// Writes a sentence for each end that is stated, without a full stop.
impl fmt::Display for Versions {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let begins = self
            .since
            .iter()
            .map(|since| format!("this claim begins with version {since}"));
        let ends = self
            .until
            .iter()
            .map(|until| format!("this claim ended with version {until}"));
        out.write_str(&begins.chain(ends).collect::<Vec<_>>().join("; "))
    }
}

/// Returns the first three numbers of a version, as a compiler or a person writes it: those with which a word begins, behind a `v` at most. What follows them
/// (`-beta`, `+build`) does not count, and numbers that are missing are 0. `None` where no word begins so, or where it is a commit.
pub fn version_numbers(version: &str) -> Option<[u64; 3]> {
    /// The greatest length of a word without a point that is a number; a longer one is a commit or a date.
    const MAX_NUMBER_LEN: usize = 6;
    let word = version
        .split(|character: char| character.is_whitespace() || character == ',')
        .map(|word| word.trim_start_matches(['v', 'V']))
        .find(|word| word.starts_with(|character: char| character.is_ascii_digit()))?;
    let parts = word.split('-');
    let is_date = parts.clone().count() == 3 && parts.clone().all(|part| part.parse::<u32>().is_ok());
    let word = word.split(['-', '+']).next()?;
    if is_date || !word.contains('.') && word.len() > MAX_NUMBER_LEN {
        return None;
    }
    let digits = word.split(|character: char| !character.is_ascii_digit() && character != '.');
    let mut numbers = digits.into_iter().next()?.split('.');
    let mut next = || match numbers.next() {
        None | Some("") => Some(0),
        Some(number) => number.parse().ok(),
    };
    Some([next()?, next()?, next()?])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_two_ends_the_earlier_one_counts() {
        let ended = Versions::default().ending_with("0.239");
        assert_eq!(ended.clone().ending_with("0.1000"), ended);
        assert!(!ended.ending_with("0.7").include("0.9"));
    }
}
