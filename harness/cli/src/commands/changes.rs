//! `stickler changes`: what a version of the suite claims otherwise than an older one, as Markdown.

use crate::arguments::ChangesArguments;
use crate::case_folder::CaseFolder;
use crate::exit::Exit;
use anyhow::{Context, bail};
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::Write;
use std::path::Path;
use stickler_report::basis::Basis;
use stickler_run::{Fact, clip_line, expected_facts};
use stickler_suite::{Case, Change, Changed, Dialects, Suite};
use stickler_types::{counted, grouped, join};

/// The maximum number of rows of a table: the largest groups of cases.
const MAX_ROWS: usize = 16;

/// The maximum number of characters of an expectation or of an id.
const MAX_SHOWN: usize = 90;

/// Returns the cells by which the cases of a table are grouped.
type Row = fn(&Changed<'_>) -> String;

/// The changes: in the words of the first table, and each as a table with these columns and rows.
const TABLES: [(Change, &str, &str, Row); 7] = [
    (
        Change::Corrected,
        "corrected: something else is expected",
        "claim | before | now",
        |changed| {
            [
                changed.new.basis.to_string(),
                expected(changed.old),
                expected(changed.new),
            ]
            .join(" | ")
        },
    ),
    (Change::Withdrawn, "withdrawn as wrong", "claim", claim_before),
    (
        Change::Rebased,
        "with the same expectation by another claim",
        "before | now",
        |changed| [claim_before(changed), claim(changed)].join(" | "),
    ),
    (
        Change::Asserted,
        "asserted, and only recorded before",
        "claim",
        claim,
    ),
    (
        Change::Opened,
        "only recorded, and asserted before",
        "claim",
        claim_before,
    ),
    (Change::Added, "added", "source", |changed| {
        Basis::of(&changed.new.basis).source.to_owned()
    }),
    (
        Change::Gone,
        "gone: asked by another case, or no longer asked",
        "file",
        |changed| changed.old.file.to_string(),
    ),
];

fn claim(changed: &Changed<'_>) -> String {
    changed.new.basis.to_string()
}

fn claim_before(changed: &Changed<'_>) -> String {
    changed.old.basis.to_string()
}

/// Writes the changes between two versions to `out`, or into a file.
///
/// # Errors
/// A folder without a suite, or one that this version of Stickler cannot read; a file that cannot be written.
pub fn execute(arguments: &ChangesArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let new = CaseFolder::locate(arguments.new.as_deref())?;
    let [old, new] = [&arguments.old, &new.path].map(|folder| load(folder));
    let text = page(&old?, &new?);
    let Some(path) = &arguments.output else {
        out.write_all(text.as_bytes())?;
        return Ok(Exit::AsExpected);
    };
    let before = match path.exists() {
        true => fs::read_to_string(path),
        false => Ok("# Changes of the claims\n".to_owned()),
    };
    let written = before.and_then(|before| fs::write(path, with_part(&before, &text)));
    written.with_context(|| format!("cannot write {}", path.display()))?;
    Ok(Exit::AsExpected)
}

/// Loads the suite in a folder, or in the folder of cases there.
fn load(path: &Path) -> anyhow::Result<Suite> {
    let mut folders = [path.to_owned(), path.join("conformance-cases")].into_iter();
    let (shown, hint) = (
        path.display(),
        "`git worktree add ../old COMMIT` makes the folder of an older version",
    );
    let Some(folder) = folders.find(|folder| folder.join("suite.toml").is_file()) else {
        bail!("{shown} has no suite.toml; {hint}");
    };
    Dialects::define_those_of(&folder);
    let suite = Suite::load(&folder);
    match suite.errors.first() {
        None => Ok(suite),
        Some(error) => {
            let number = counted(suite.errors.len() as u64, "mistake", "mistakes");
            bail!("{shown} cannot be compared, since this version of Stickler finds {number} there: {error}")
        }
    }
}

/// Puts a part that begins with a heading of the second level into a file: in place of the one with the same heading, or as the first.
fn with_part(file: &str, part: &str) -> String {
    let mut parts = vec![String::new()];
    for line in file.lines() {
        if line.starts_with("## ") {
            parts.push(String::new());
        }
        if let Some(last) = parts.last_mut() {
            last.push_str(line);
            last.push('\n');
        }
    }
    let head = parts.remove(0);
    parts.retain(|other| other.lines().next() != part.lines().next());
    let parts = [head, part.to_owned()].into_iter().chain(parts);
    join(parts.map(|part| format!("{}\n", part.trim())), "\n")
}

fn page(old: &Suite, new: &Suite) -> String {
    let changes = new.changes_since(old);
    let claims = |suite: &Suite| -> BTreeSet<String> {
        let asserting = suite.cases.iter().filter(|case| !case.is_open());
        asserting.map(|case| case.basis.to_string()).collect()
    };
    let (claimed, claims) = (claims(old), claims(new));
    let mut text = format!("## {}\n\nAgainst {}: ", new.version, old.version);
    let [before, now] = [old, new].map(|suite| counted(suite.cases.len() as u64, "case", "cases"));
    let more = counted(claims.difference(&claimed).count() as u64, "claim", "claims");
    let fewer = claimed.difference(&claims).count();
    text += &format!("{before} before, {now} now; {more} more, {fewer} fewer.\n\n| cases | |\n|---|---|\n");
    let of = |change: Change| changes.iter().filter(move |changed| changed.change == change);
    for (change, title, ..) in TABLES {
        text += &format!("| {title} | {} |\n", grouped(of(change).count() as u64));
    }
    push_withdrawn(&mut text, new, of(Change::Withdrawn));
    let is_new = |changed: &&Changed<'_>| !claimed.contains(&*changed.new.basis);
    let by_new_claims = of(Change::Added).filter(is_new);
    push_table(
        &mut text,
        ("added by claims that are new", "claim"),
        by_new_claims,
        |changed| changed.new.basis.to_string(),
    );
    for (change, title, columns, row) in TABLES {
        push_table(&mut text, (title, columns), of(change), row);
    }
    text
}

/// Adds what was withdrawn, with the reason and what came instead; all of it, for lint looks for the ids here.
fn push_withdrawn<'a>(text: &mut String, suite: &Suite, cases: impl Iterator<Item = &'a Changed<'a>>) {
    let mut entries: BTreeMap<String, BTreeMap<&str, u64>> = BTreeMap::new();
    let entry = |case: &Case| suite.withdrawn(&case.id, case.dialect.as_str());
    for entry in cases.filter_map(|changed| entry(changed.old)) {
        let (date, reason, instead) = (&entry.date, entry.reason.trim(), entry.instead.trim());
        let ids = entries.entry(format!("{date}: {reason} Instead: {instead}"));
        *ids.or_default().entry(&entry.id).or_default() += 1;
    }
    for (at, (entry, ids)) in entries.iter().enumerate() {
        let heading = if at == 0 { "\n### Withdrawn\n\n" } else { "" };
        let of_id = |(id, number): (&&str, &u64)| format!("`{id}` ({})", counted(*number, "case", "cases"));
        let ids = join(ids.iter().map(of_id), ", ");
        *text += &format!("{heading}* {ids}, {entry}\n");
    }
}

/// Adds a table of groups of cases, the largest first, each with an example.
fn push_table<'a>(
    text: &mut String,
    (title, columns): (&str, &str),
    cases: impl Iterator<Item = &'a Changed<'a>>,
    row: impl Fn(&Changed<'_>) -> String,
) {
    let mut groups: BTreeMap<String, (u64, String)> = BTreeMap::new();
    for changed in cases {
        let example = || (0, clip_line(&changed.new.key(), MAX_SHOWN).replace('|', "\\|"));
        groups.entry(row(changed)).or_insert_with(example).0 += 1;
    }
    let mut groups: Vec<_> = groups.into_iter().collect();
    groups.sort_by_key(|(_, (number, _))| Reverse(*number));
    for (at, (row, (number, example))) in groups.iter().take(MAX_ROWS).enumerate() {
        if at == 0 {
            let rule = "---|".repeat(columns.split('|').count() + 2);
            *text += &format!("\n### Cases {title}\n\n| {columns} | cases | for example |\n|{rule}\n");
        }
        *text += &format!("| {row} | {} | `{example}` |\n", grouped(*number));
    }
    let rest = groups.iter().skip(MAX_ROWS).map(|(_, (number, _))| number);
    let (rows, cases) = (rest.clone().count(), rest.sum());
    if rows > 0 {
        *text += &format!("\nAnd {rows} more with {}.\n", counted(cases, "case", "cases"));
    }
}

/// Returns what a case expects on one line of a table.
fn expected(case: &Case) -> String {
    let text = Fact::text(&expected_facts(case)).trim().replace('\n', "; ");
    clip_line(&text, MAX_SHOWN).replace('|', "\\|")
}
