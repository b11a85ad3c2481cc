//! The cases that did not pass and that reports list whole: all of them, or as many of each kind as there is room for.

use crate::text::kept;
use std::collections::HashMap;
use stickler_run::{CaseEvent, Verdict};

/// The maximum number of bytes of the listed cases, as `results.json` has them. `junit.xml` takes about as many.
const MAX_BYTES: usize = 3 << 20;

/// The cases that did not pass. Where there is no room for all, the first ones of each engine, case file and verdict are listed, as many of
/// each as there is room for, so that no part of the suite crowds out the others.
#[derive(Debug, Default)]
pub(crate) struct ListedCases {
    /// The listed cases, each with its number among those of its engine, case file and verdict, and its size in bytes.
    cases: Vec<(u64, usize, CaseEvent)>,
    /// The number of cases of each engine, case file and verdict.
    seen: HashMap<(String, String, Verdict), u64>,
    /// The number of times that the maximum number of listed cases of each engine, case file and verdict was halved.
    halvings: u32,
    bytes: usize,
    /// The number of cases that did not pass and are not listed.
    pub(crate) left_out: u64,
}

impl ListedCases {
    /// Adds a case that did not pass.
    pub(crate) fn take(&mut self, case: &CaseEvent) {
        let kind = (case.engine.clone(), case.file.clone(), case.verdict);
        let number = self.seen.entry(kind).or_default();
        *number += 1;
        if *number > limit(self.halvings) {
            self.left_out += 1;
            return;
        }
        let program = case.program.as_deref();
        let case = CaseEvent {
            program: program.map(|program| kept(program).into_owned()),
            ..case.clone()
        };
        // An event is always JSON.
        let bytes = serde_json::to_vec(&case).map_or(0, |json| json.len());
        self.cases.push((*number, bytes, case));
        self.bytes += bytes;
        while self.bytes > MAX_BYTES {
            self.halvings += 1;
            let (limit, listed) = (limit(self.halvings), self.cases.len());
            self.cases.retain(|(number, ..)| *number <= limit);
            self.left_out += (listed - self.cases.len()) as u64;
            self.bytes = self.cases.iter().map(|(_, bytes, _)| bytes).sum();
        }
    }

    /// Returns the listed cases, in the order of the run.
    pub(crate) fn iter(&self) -> impl Iterator<Item = &CaseEvent> {
        self.cases.iter().map(|(.., case)| case)
    }
}

/// Returns the maximum number of listed cases of each engine, case file and verdict.
fn limit(halvings: u32) -> u64 {
    u64::MAX.checked_shr(halvings).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::{ListedCases, MAX_BYTES};
    use crate::sample;
    use stickler_run::{CaseEvent, Verdict};

    #[test]
    fn cases_of_each_file_are_listed_as_far_as_there_is_room_and_the_others_are_counted() {
        let mut listed = ListedCases::default();
        let case = CaseEvent {
            program: Some("x".repeat(1000)),
            ..sample::case("a", Verdict::Fail)
        };
        let many = 2 * MAX_BYTES as u64 / 1000;
        (0..many).for_each(|_| listed.take(&case));
        let rare = CaseEvent {
            file: "other.toml".to_owned(),
            ..case
        };
        listed.take(&rare);
        assert!(listed.bytes <= MAX_BYTES && listed.bytes > MAX_BYTES / 8);
        assert_eq!(listed.iter().last(), Some(&rare));
        assert_eq!(listed.iter().count() as u64 + listed.left_out, many + 1);
    }
}
