//! Tests the pages of the manual: every relative link leads to a file, every fragment to a heading, and every crate has a section.

use std::fs;
use std::path::{Path, PathBuf};

/// Folders without pages of the manual: build output, recorded commands, golden reports, and what runs leave.
const SKIPPED: [&str; 6] = ["target", "cmd", "golden", "latest", "cache", "findings"];

fn pages(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder").flatten() {
        let (path, name) = (entry.path(), entry.file_name());
        let name = name.to_string_lossy();
        let is_hidden = name.starts_with('.') && name != ".github";
        if path.is_dir() && !is_hidden && !SKIPPED.contains(&&*name) {
            pages(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "md") {
            found.push(path);
        }
    }
}

/// Returns the lines of a page that are no part of a code block.
fn prose(text: &str) -> impl Iterator<Item = &str> {
    let mut in_code = false;
    text.lines().filter(move |line| {
        let is_fence = line.trim_start().starts_with("```");
        in_code ^= is_fence;
        !in_code && !is_fence
    })
}

/// Returns the targets of the links in a line.
fn targets(line: &str) -> impl Iterator<Item = &str> {
    let behind = line.split("](").skip(1);
    behind.filter_map(|rest| rest.split_once(')').map(|(target, _)| target))
}

/// Returns the fragment that leads to a heading.
fn fragment(heading: &str) -> String {
    let kept = heading.trim_start_matches('#').trim().to_lowercase();
    let kept = kept.chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c));
    kept.collect::<String>().replace(' ', "-")
}

/// Returns what is wrong with a link of a page.
fn broken(page: &Path, text: &str, target: &str) -> Option<String> {
    if target.contains("://") {
        return None;
    }
    let (file, wanted) = target.split_once('#').unwrap_or((target, ""));
    let path = page.parent().expect("a folder").join(file);
    let text = match file {
        "" => text.to_owned(),
        _ if !path.exists() => return Some(format!("there is no {file}")),
        _ if wanted.is_empty() => return None,
        _ => fs::read_to_string(&path).expect("a page"),
    };
    let mut headings = prose(&text).filter(|line| line.starts_with('#'));
    let leads_somewhere = wanted.is_empty() || headings.any(|line| fragment(line) == wanted);
    (!leads_somewhere).then(|| format!("no heading for {target}"))
}

#[test]
fn every_relative_link_of_the_manual_leads_somewhere() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut found = Vec::new();
    pages(&root, &mut found);
    assert!(found.len() > 20, "{found:?}");
    let mut mistakes = Vec::new();
    for page in found {
        let text = fs::read_to_string(&page).expect("a page");
        for target in prose(&text).flat_map(targets) {
            if let Some(what) = broken(&page, &text, target) {
                mistakes.push(format!("{}: {what}", page.display()));
            }
        }
    }
    assert!(mistakes.is_empty(), "{}", mistakes.join("\n"));
}

#[test]
fn the_architecture_names_every_crate() {
    let harness = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let text = fs::read_to_string(harness.join("README.md")).expect("a page");
    let headings: Vec<&str> = prose(&text).filter(|line| line.starts_with("### ")).collect();
    for entry in fs::read_dir(&harness).expect("a folder").flatten() {
        let heading = format!("`{}`", entry.file_name().to_string_lossy());
        let is_crate = entry.path().join("Cargo.toml").exists();
        let is_named = headings.iter().any(|line| line.contains(&heading));
        assert!(
            !is_crate || is_named,
            "harness/README.md has no section on {heading}"
        );
    }
}

#[test]
fn a_link_that_leads_nowhere_is_found() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../README.md");
    let text = "# A `heading`, twice\n```\n# none\n[no](link)\n```\n";
    assert_eq!(prose(text).flat_map(targets).count(), 0);
    for (target, is_broken) in [
        ("#a-heading-twice", false),
        ("#none", true),
        ("harness", false),
        ("harness/README.md#the-crates", false),
        ("harness/README.md#no-such-heading", true),
        ("no-such-file.md", true),
        ("https://example.org/x", false),
    ] {
        assert_eq!(broken(&page, text, target).is_some(), is_broken, "{target}");
    }
}
