//! The versions of an engine: which run of each counts, and which version is newer.

use super::run::SiteRun;
use semver::Version;
use stickler_types::counted;

/// The parts of a hundred of the cases of the largest run of a version that a run must have to count in its place. A part of the suite never
/// does; a run of a suite that lost some cases does.
const ENOUGH_PERCENT: u64 = 90;

/// A run of an engine.
#[derive(Clone, Copy)]
pub(super) struct VersionRun<'r> {
    pub(super) run: &'r SiteRun,
    pub(super) version: &'r str,
    /// The run of the same version that counts in place of this one.
    pub(super) replaced: Option<&'r SiteRun>,
}

impl VersionRun<'_> {
    /// Returns why the run does not count, as a fragment; `None` where it counts.
    pub(super) fn reason(&self, engine: &str) -> Option<String> {
        let other = self.replaced?;
        let [own, others] = [self.run, other].map(|run| run.sum(engine).cases());
        let cases = |number| counted(number, "case", "cases");
        Some(match other.number > self.run.number {
            true => format!("the later run of {} counts, with {}", other.date(), cases(others)),
            false => format!(
                "it has {}, and the run of {} counts, with {}",
                cases(own),
                other.date(),
                cases(others)
            ),
        })
    }
}

/// Sets, for each run of an engine, the run of the same version that counts in its place: the latest of those that have nearly as many
/// cases as the largest. The runs come by date.
pub(super) fn replace(engine: &str, runs: &mut [VersionRun<'_>]) {
    let cases = |run: &VersionRun<'_>| run.run.sum(engine).cases();
    for at in 0..runs.len() {
        let same = || runs.iter().filter(|run| run.version == runs[at].version);
        let largest = same().map(cases).max().unwrap_or(0);
        let is_enough = |run: &&VersionRun<'_>| cases(run) * 100 >= largest * ENOUGH_PERCENT;
        let counting = same().rfind(is_enough).map(|run| run.run);
        let is_other = counting.is_some_and(|run| run.number != runs[at].run.number);
        runs[at].replaced = counting.filter(|_| is_other);
    }
}

/// Returns the runs that count, oldest version first: by number where each version is one, so that the results of an old version may be
/// handed in late; otherwise by the date of the first run of the version.
pub(super) fn in_order<'r>(runs: &[VersionRun<'r>]) -> Vec<VersionRun<'r>> {
    let mut counted: Vec<VersionRun<'r>> = runs
        .iter()
        .copied()
        .filter(|run| run.replaced.is_none())
        .collect();
    let numbers: Option<Vec<Version>> = runs.iter().map(|run| number(run.version)).collect();
    match numbers {
        Some(_) => counted.sort_by_key(|run| number(run.version)),
        None => counted.sort_by_key(|run| runs.iter().position(|first| first.version == run.version)),
    }
    counted
}

/// Parses a version such as `0.239`, `v1.2.3` or `2.0.0-rc.1`; `None` for another text, such as a commit.
fn number(version: &str) -> Option<Version> {
    let version = version.trim().trim_start_matches('v');
    let end = version.find(['-', '+']).unwrap_or(version.len());
    let (numbers, rest) = version.split_at(end);
    let missing = match numbers.split('.').count() {
        2 => ".0",
        3 => "",
        _ => return None,
    };
    Version::parse(&format!("{numbers}{missing}{rest}")).ok()
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn versions_are_compared_by_their_numbers_and_commits_are_none() {
        let sorted = ["0.9", "0.10", "v1.0.0-rc.1", "1.0.0"];
        assert!(sorted.is_sorted_by_key(|version| number(version).expect("a version")));
        for text in ["ab12cd3", "2024", "1.2.3.4", ""] {
            assert_eq!(number(text), None, "{text}");
        }
    }
}
