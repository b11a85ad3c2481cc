//! Writes the observations as Markdown: the disagreements between engines where no document states what they must do.

use super::BoundedMarkdown;
use crate::markdown::{code, inline};
use crate::observations::{Disagreement, probe};
use crate::overview::Overview;
use stickler_types::{counted, join, joined};

/// The maximum number of disagreements that are shown.
const MAX_SHOWN: usize = 100;

/// Writes a line for each disagreement between engines.
pub(super) fn write(overview: &Overview, page: &mut BoundedMarkdown) {
    let engines = overview.engines();
    let disagreements = overview.observed.disagreements(&engines);
    if disagreements.is_empty() {
        return;
    }
    page.add("\n## Where no source in Stickler decides\n\nThe engines do not do the same here, and none of them is wrong.\n\n");
    disagreements
        .iter()
        .take(MAX_SHOWN)
        .for_each(|disagreement| page.add(&line(disagreement)));
    let rest = disagreements.get(MAX_SHOWN..).unwrap_or_default();
    let cases: u64 = rest.iter().map(|disagreement| disagreement.cases).sum();
    if cases > 0 {
        let cases = counted(cases, "case", "cases");
        page.add(&format!(
            "\n... and in {cases} more; `events.jsonl.gz` has all observations.\n"
        ));
    }
}

/// Formats a disagreement: ``- `conversion/real::recorded(REAL,INT,2.5)`, `into`: INT#2 by ironplc and reference, INT#3 by
/// matiec``
fn line(disagreement: &Disagreement<'_>) -> String {
    let values = disagreement.values.iter().map(|(value, who)| {
        let names: Vec<String> = who.iter().map(|name| inline(name)).collect();
        format!("{} by {}", code(value), joined(&names, "and"))
    });
    let alike = match disagreement.cases {
        1 => String::new(),
        cases => {
            let others = counted(cases - 1, "other case", "other cases");
            format!(
                "; they part alike in {others} of {}",
                code(probe(disagreement.id))
            )
        }
    };
    format!(
        "- {}, {}: {}{alike}\n",
        code(disagreement.id),
        code(disagreement.name),
        join(values, ", ")
    )
}
