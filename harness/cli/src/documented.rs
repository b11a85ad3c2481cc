//! Collects the statements of documents about the conversions that the cases of a run ask for, for the page of the run.

use std::collections::BTreeSet;
use stickler_conversions::overview::{CaseStatement, Statements, StatementsBuilder, part_of_program};
use stickler_suite::{Acceptance, Case};
use stickler_types::{DialectName, ElementaryType, MatrixWord};

/// The probe whose cells say whether types convert implicitly.
pub const IMPLICIT_PROBE: &str = "assignment";

/// Returns what documents state: of the pairs of types, the parts of types and the calls of functions in these cases, and of the
/// boundary values of these functions.
pub fn statements(cases: &[&Case]) -> Statements {
    let dialects: BTreeSet<DialectName> = cases.iter().map(|case| case.dialect).collect();
    let mut builder = StatementsBuilder::new(dialects.into_iter().collect());
    for case in cases.iter().filter(|case| case.placement.is_none()) {
        if let Some(cell) = &case.cell
            && &*cell.probe == IMPLICIT_PROBE
            && let (Some(from), Some(to)) = (
                ElementaryType::from_name(&cell.row),
                ElementaryType::from_name(&cell.column),
            )
        {
            builder.add_implicit(from, to, &statement(case, cell.word));
        } else if let Some(access) = part_of_program(&case.source) {
            let word = match case.expectation.accepted {
                Acceptance::Required => MatrixWord::Yes,
                Acceptance::Rejected => MatrixWord::No,
                Acceptance::Observed => MatrixWord::Open,
            };
            builder.add_part(&access, &statement(case, word));
        } else {
            builder.add_program(&case.id, &case.source);
        }
    }
    builder.finish()
}

fn statement(case: &Case, word: MatrixWord) -> CaseStatement<'_> {
    CaseStatement {
        dialect: case.dialect,
        word,
        basis: &case.basis,
        case: &case.id,
    }
}
