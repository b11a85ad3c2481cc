//! Tests pages that are only compiled, and the messages about them.

use super::*;

/// Returns the diagnostics of the reference for a page that is only compiled, as a list of messages.
fn messages(page: &str, file: &str, dialect: DialectName) -> String {
    let reference = Reference::new();
    let outcome = reference.session().expect("a session").check(dialect, page);
    let Outcome::Rejected { diagnostics } = outcome else {
        panic!("{outcome:?}")
    };
    let lines = diagnostics.iter().map(|reported| {
        format!(
            "{file}({}): error: {}\n",
            reported.line.unwrap_or(0),
            reported.message
        )
    });
    lines.collect()
}

#[test]
fn programs_that_must_be_rejected_are_told_apart_by_the_messages_of_their_page() {
    let cases = cases(&[
        "widening/integer.toml",
        "widening/contexts.toml",
        "widening/codesys.toml",
        "widening/logix.toml",
        "widening/control-expert.toml",
        "widening/omron-compared.toml",
        "widening/iec-ed3.toml",
        "bit-access/outside-short.toml",
        "language/literals-outside.toml",
    ]);
    let cases: Vec<&Case> = cases.iter().collect();
    for dialect in DialectName::ALL {
        let plan = ExportPlan {
            with: BTreeSet::from([ExtraCases::Rejected]),
            sample: Some(200),
            ..plan(dialect)
        };
        let folder = tempfile::tempdir().expect("a folder");
        let reported = export(&plan, &cases, folder.path()).expect("exported");
        assert!(reported.compiled_only > 0, "{dialect}");
        let export = Export::read(folder.path()).expect("an export");
        let manifest = Manifest::read(folder.path()).expect("a manifest");
        let mut list = String::new();
        let mut rejected = 0;
        for page in manifest.pages.iter().filter(|page| page.is_compiled()) {
            let text = fs::read_to_string(folder.path().join(&page.file)).expect("a page");
            list.push_str(&messages(&text, &page.file, dialect));
            rejected += page.cases.len();
        }
        let judged = |list: &str| {
            let source = CopiedText {
                name: "messages.txt".to_owned(),
                bytes: list.as_bytes().to_vec(),
            };
            let mut verdicts = Vec::new();
            let imported = import(&export, &[source], &mut |event| {
                if let Event::Case(case) = event {
                    verdicts.push(case.verdict);
                }
            });
            (verdicts, imported.notes.join("\n"))
        };
        let (verdicts, notes) = judged(&list);
        assert_eq!(verdicts, vec![Verdict::Pass; rejected], "{dialect}: {notes}");
        // Without the message of one case, that case was accepted; without that of the last statement, nothing is known.
        let first = &manifest
            .pages
            .iter()
            .find(|page| page.is_compiled())
            .expect("a page");
        let lines = &first.lines.cases[0];
        let is_of_the_case = |line: &str| {
            lines
                .iter()
                .any(|(from, to)| (*from..=*to).any(|at| line.starts_with(&format!("{}({at})", first.file))))
        };
        let fewer: String = list
            .lines()
            .filter(|line| !is_of_the_case(line))
            .map(|line| format!("{line}\n"))
            .collect();
        let (verdicts, _) = judged(&fewer);
        assert_eq!(
            verdicts
                .iter()
                .filter(|verdict| **verdict == Verdict::Fail)
                .count(),
            1
        );
        let is_last = |line: &str| {
            let compiled = manifest.pages.iter().filter(|page| page.is_compiled());
            let mut ends =
                compiled.filter_map(|page| Some((&page.file, page.lines.cases.last()?.first()?.0)));
            ends.any(|(file, at)| line.starts_with(&format!("{file}({at})")))
        };
        let kept = list.lines().filter(|line| !is_last(line));
        let cut: String = kept.map(|line| format!("{line}\n")).collect();
        let (verdicts, notes) = judged(&cut);
        assert!(
            verdicts.is_empty() && notes.contains("the list of messages is not whole"),
            "{notes}"
        );
    }
}
