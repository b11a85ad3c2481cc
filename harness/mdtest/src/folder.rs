//! Reads the test files of a folder, and reports what is not as they say.

use crate::markdown::{Fence, Mistake, sections};
use crate::{Block, Difference};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

/// Checks every block of every `*.md` file of a folder.
///
/// # Panics
/// Where a file cannot be read or holds no block, and where a block gives differences: then with all of them.
pub fn check(folder: impl AsRef<Path>, checked: impl Fn(&Block) -> Vec<Difference>) {
    let folder = folder.as_ref();
    let entries = std::fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut paths: Vec<_> = entries.map(|entry| entry.expect("an entry").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "md"));
    paths.sort();
    assert!(!paths.is_empty(), "{} holds no test", folder.display());
    let mut report = String::new();
    for path in paths {
        let text = std::fs::read_to_string(&path).expect("a text");
        let blocks = blocks(&text).unwrap_or_else(|(line, what)| panic!("{}:{line}: {what}", path.display()));
        assert!(!blocks.is_empty(), "{} holds no block", path.display());
        for block in blocks {
            let found = catch_unwind(AssertUnwindSafe(|| checked(&block)))
                .unwrap_or_else(|_| vec![Difference::new(1, "the test panics")]);
            for Difference { line, what } in found {
                let (path, line) = (path.display(), block.line + line - 1);
                let what = what.replace('\n', "\n    ");
                report.push_str(&format!("{path}:{line}: {}\n    {what}\n\n", block.heading));
            }
        }
    }
    assert!(report.is_empty(), "not as the tests say:\n\n{report}");
}

/// Takes a file apart.
fn blocks(text: &str) -> Result<Vec<Block>, Mistake> {
    let sections = sections(text)?.into_iter();
    let blocks = sections.flat_map(|section| {
        let block = move |fence: Fence| Block {
            heading: section.heading.clone(),
            info: fence.info,
            text: fence.text.lines().flat_map(|line| [line, "\n"]).collect(),
            line: fence.lines.start + 1,
        };
        section.blocks.into_iter().map(block)
    });
    Ok(blocks.collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_has_its_heading_its_words_and_its_line() {
        let blocks =
            blocks("# File\n\n## Case\n\nProse.\n\n```st matiec\nx\n\ny\n```\n\n```calls\n# c\na = 1\n```\n")
                .expect("blocks");
        let [program, calls] = &blocks[..] else {
            panic!("{}", blocks.len())
        };
        assert_eq!((program.heading.as_str(), program.line), ("Case", 8));
        assert_eq!((program.kind(), program.text.as_str()), ("st", "x\n\ny\n"));
        assert!(program.options().eq(["matiec"]));
        assert_eq!(calls.lines().collect::<Vec<_>>(), [(2, "a = 1")]);
    }

    #[test]
    fn each_line_is_put_in_its_place() {
        let blocks = blocks("```st ed2 each line in P … ¶Q\na\nb\n```\n").expect("a block");
        let programs = blocks[0].programs();
        let texts: Vec<_> = programs.iter().map(|program| &*program.text).collect();
        assert_eq!(texts, ["P a \nQ", "P b \nQ"]);
        assert_eq!(programs[1].place(Difference::new(7, "")), Difference::new(2, ""));
        assert!(blocks[0].options().eq(["ed2"]));
    }

    #[test]
    fn a_row_that_differs_is_reported_with_its_line() {
        let blocks = blocks("```calls\nf(1) = 2\n\nf(2)\n```\n").expect("a block");
        let found = blocks[0].rows(|question, answer| crate::same(question, answer));
        assert_eq!(
            found[0],
            Difference::new(1, "f(1) = 2\n     got f(1)\nexpected 2")
        );
        assert_eq!((found[1].line, found.len()), (3, 2));
    }

    #[test]
    #[should_panic(expected = "the test panics")]
    fn a_panic_is_reported_with_its_place() {
        check(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/sample"), |_| {
            panic!("on purpose")
        });
    }
}
