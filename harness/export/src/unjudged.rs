//! Notes about cases that cannot be judged, and about pages without results.

use crate::ANSWERS;
use crate::manifest::PageRecord;
use crate::result_arrays::PageResult;
use stickler_types::counted;

/// The maximum number of cases that a note names.
const MAX_NAMED_CASES: usize = 5;

/// The cases of a page that cannot be judged, by the reason.
#[derive(Default)]
pub(crate) struct UnjudgedCases {
    missing: Vec<String>,
    not_run: Vec<String>,
    nonsense: Vec<(String, String)>,
}

impl UnjudgedCases {
    /// Adds a case that cannot be judged, by its result.
    pub(crate) fn add(&mut self, id: &str, reported: PageResult) {
        match reported {
            PageResult::Missing | PageResult::Outcome(..) => self.missing.push(id.to_owned()),
            PageResult::NotRun => self.not_run.push(id.to_owned()),
            PageResult::Nonsense(what) => self.nonsense.push((id.to_owned(), what)),
        }
    }

    pub(crate) fn count(&self) -> u64 {
        (self.missing.len() + self.not_run.len() + self.nonsense.len()) as u64
    }

    pub(crate) fn tell(&self, page: &PageRecord, state: Option<String>, notes: &mut Vec<String>) {
        let name = format!("page {} ({})", page.number, page.file);
        let has_state = state.is_some();
        if let Some(state) = state {
            notes.push(format!("{name}: {state}"));
        }
        let cases = |number: usize| counted(number as u64, "case is", "cases are");
        match self.missing.len() {
            0 => {}
            number => notes.push(format!(
                "{name}: {} not judged, for what is missing",
                cases(number)
            )),
        }
        if !self.not_run.is_empty() {
            let (named, rest) = self.not_run.split_at(self.not_run.len().min(MAX_NAMED_CASES));
            let named = named.join(", ");
            let more = match rest.len() {
                0 => String::new(),
                rest => format!(" and {rest} more"),
            };
            let hint = match has_state {
                true => String::new(),
                false => format!("; if the compiler does not accept it, say so in {ANSWERS}"),
            };
            notes.push(format!(
                "{name}: {} not run: {named}{more}{hint}",
                cases(self.not_run.len())
            ));
        }
        let nonsense = self.nonsense.iter().map(|(id, what)| {
            format!("{name}: {id} is not judged: {what}, which no page writes there; copy the array again")
        });
        notes.extend(shortened(nonsense.collect()));
    }
}

/// The pages for which no results were given.
#[derive(Default)]
pub(crate) struct PagesWithoutResults {
    /// The first and the last page number of each range.
    stretches: Vec<(usize, usize)>,
    cases: u64,
}

impl PagesWithoutResults {
    pub(crate) fn add(&mut self, page: usize, cases: u64) {
        self.cases += cases;
        match self.stretches.last_mut() {
            Some((_, last)) if *last + 1 == page => *last = page,
            _ => self.stretches.push((page, page)),
        }
    }

    pub(crate) fn tell(&self, notes: &mut Vec<String>) {
        let stretches = self.stretches.iter().map(|(first, last)| match first == last {
            true => first.to_string(),
            false => format!("{first} to {last}"),
        });
        let stretches: Vec<String> = stretches.collect();
        let word = match self.stretches[..] {
            [] => return,
            [(first, last)] if first == last => "page",
            _ => "pages",
        };
        notes.push(format!(
            "{word} {}: no results were given; {} not judged",
            stretches.join(", "),
            counted(self.cases, "case is", "cases are")
        ));
    }
}

/// Shortens a list of notes of one kind to a readable number.
pub(crate) fn shortened(mut notes: Vec<String>) -> Vec<String> {
    const MAX_NOTES: usize = 20;
    if notes.len() > MAX_NOTES {
        let rest = notes.len() - MAX_NOTES;
        notes.truncate(MAX_NOTES);
        notes.push(format!("... and {rest} more of the kind"));
    }
    notes
}
