//! The case format from outside: files in, cases and mistakes out.
//!
//! The examples stand in Markdown files beside this one. The inputs of an example that are named by a path are the files of a suite, whose
//! `suite.toml`, `dialects.toml` and `sources.toml` are [those of all examples](folders) unless it has its own. The name of what must come says what
//! is shown:
//!
//! | name | shown |
//! |---|---|
//! | `cases` | the cases, each with what it expects |
//! | `whole` | the cases with everything that belongs to them |
//! | `ids` | the ids and dialects alone |
//! | `mistakes` | what is wrong; without the path where there is one file |
//! | `kept` | what is wrong, and the ids and dialects of the cases that there are all the same |
//! | `lint` | what lint finds, errors and warnings |
//! | an id | the program of the case |

mod defined;
mod folder;
mod folders;
mod listing;
mod shipped;

use folders::{files, folder as folder_of};
use stickler_mdtest::{Example, check_examples};
use stickler_suite::{LintSeverity, Suite, lint};
use stickler_types::join;

/// Returns what an example wants of its files.
fn shown(example: &Example) -> String {
    let files = files(example);
    let folder = folder_of(&files);
    let root = folder.path().join("cases");
    let only = match &files[..] {
        [(path, _)] => format!("cases/{path}:"),
        _ => "cases/".to_owned(),
    };
    let brief = |mistake: String| mistake.replacen(&only, "", 1);
    if example.wanted() == "lint" {
        let finding = |finding: stickler_suite::LintFinding| match finding.severity {
            LintSeverity::Error => format!("error {}", brief(finding.what.to_string())),
            LintSeverity::Warning => format!("warning {}", brief(finding.what.to_string())),
        };
        return join(lint(&root, &["matiec", "rusty"]).into_iter().map(finding), "\n");
    }
    let suite = Suite::load(&root);
    let mistakes = join(suite.errors.iter().map(|error| brief(error.to_string())), "\n");
    let ids = || {
        let listing = listing::listing(&suite.cases, false);
        join(listing.lines().filter(|line| !line.starts_with(' ')), "\n")
    };
    match example.wanted() {
        "mistakes" => mistakes,
        "kept" => format!("{mistakes}\n{}", ids()),
        _ if !mistakes.is_empty() => mistakes,
        "cases" => listing::listing(&suite.cases, false),
        "whole" => listing::listing(&suite.cases, true),
        "ids" => ids(),
        id => {
            let case = suite.cases.iter().find(|case| &*case.id == id);
            case.map_or_else(|| format!("no case {id}"), |case| case.source.to_string())
        }
    }
}

#[test]
fn golden_programs() {
    check_examples("tests/format/programs.md", shown);
}

#[test]
fn golden_matrices() {
    check_examples("tests/format/matrices.md", shown);
}

#[test]
fn golden_rows() {
    check_examples("tests/format/rows.md", shown);
}

#[test]
fn golden_places() {
    check_examples("tests/format/places.md", shown);
}

#[test]
fn golden_suites() {
    check_examples("tests/format/suites.md", shown);
}
