//! The selection of cases by a plan.

use crate::{Filter, Plan};
use stickler_suite::Case;

/// Selects the cases that fit the plan's dialects, filters and shard, and none of what it excludes, in the order of the suite. A filter
/// that is the id or the key of a case among the dialects selects that case alone.
#[must_use]
pub fn select<'s>(plan: &Plan, cases: &'s [Case]) -> Vec<&'s Case> {
    let spoken = |case: &&Case| plan.dialects.is_empty() || plan.dialects.contains(&case.dialect);
    let mut selected: Vec<&Case> = cases.iter().filter(spoken).collect();
    if !plan.filters.is_empty() {
        let chosen = chosen_by_any(&plan.filters, &selected);
        let mut chosen = chosen.into_iter();
        selected.retain(|_| chosen.next().unwrap_or(false));
    }
    if !plan.excluded.is_empty() {
        let mut excluded = chosen_by_any(&plan.excluded, &selected).into_iter();
        selected.retain(|_| !excluded.next().unwrap_or(false));
    }
    if let Some(shard) = plan.shard {
        selected.retain(|case| shard.holds_case(&case.id, case.dialect.as_str()));
    }
    selected
}

fn chosen_by_any(filters: &[Filter], cases: &[&Case]) -> Vec<bool> {
    let mut chosen = vec![false; cases.len()];
    for filter in filters {
        let names = |case: &&Case| filter.names(&case.id, case.dialect.as_str());
        let exact = cases.iter().any(names);
        for (mark, case) in chosen.iter_mut().zip(cases) {
            *mark |= if exact {
                names(case)
            } else {
                filter.fits(&case.id, case.dialect.as_str())
            };
        }
    }
    chosen
}
