//! Folders of case files: order, mistakes that do not spread, lint, and any bytes as a case file.

use std::path::Path;

use crate::common::{folder, load, sources, write};
use stickler_suite::{FileKind, LintSeverity, Suite, lint, load_file};

const PROGRAM: &str =
    "(*!\ntitle = \"t\"\nbasis = \"iec-61131-3: 6\"\ndialects = [\"matiec\"]\n*)\nx; (*! ok *)\n";

#[test]
fn cases_come_in_the_order_of_their_paths() {
    let suite = load(&[
        ("b/a.st", PROGRAM),
        ("a/z.st", PROGRAM),
        ("a/b/c.st", PROGRAM),
        ("a/a.st", PROGRAM),
    ]);
    assert!(suite.errors.is_empty(), "{:?}", suite.errors);
    assert_eq!(suite.version, "1.2.3");
    let ids: Vec<_> = suite.cases.iter().map(|case| &*case.id).collect();
    assert_eq!(ids, ["a/a", "a/b/c", "a/z", "b/a"]);
}

#[test]
fn only_the_files_that_are_wanted_are_read() {
    let table = "title = 't'\nbasis = 'iec-61131-3: 6'\ndialects = ['matiec']\ncolumns = ['a']\nrows = [['1']]\n\
                 [[probe]]\nname = 'p'\nsource = 'x := {a}; (*! ok *)'\n";
    let folder = folder(&[("a/bad.st", "x"), ("a/good.st", PROGRAM), ("a/good.toml", table)]);
    let wanted = |wanted: FileKind| {
        let suite = Suite::load_files(&folder.path().join("cases"), &[], |id, kind| {
            id == "a/good" && kind == wanted
        });
        assert!(suite.errors.is_empty(), "{:?}", suite.errors);
        suite
            .cases
            .into_iter()
            .map(|case| case.id.to_string())
            .collect::<Vec<_>>()
    };
    assert_eq!(wanted(FileKind::Program), ["a/good"]);
    assert_eq!(wanted(FileKind::Table), ["a/good::p(1)"]);
}

#[test]
fn a_mistake_in_one_file_leaves_the_rest() {
    let suite = load(&[("a/bad.st", "x"), ("a/good.st", PROGRAM), ("a/bad.toml", "= 3")]);
    assert_eq!(suite.cases.len(), 1);
    let files: Vec<_> = suite
        .errors
        .iter()
        .map(|error| (error.file.as_str(), error.line))
        .collect();
    assert_eq!(files, [("cases/a/bad.st", 1), ("cases/a/bad.toml", 1)]);
}

#[test]
fn a_file_without_its_suite_is_loaded_alone() {
    let folder = folder(&[("a/one.st", PROGRAM), ("a/two.st", "x")]);
    let root = folder.path().join("cases");
    let (cases, errors) = load_file(&root, &root.join("a/one.st"));
    assert_eq!(
        (cases.len(), &*cases[0].id, &*cases[0].file),
        (1, "a/one", "cases/a/one.st")
    );
    assert!(errors.is_empty());
    assert_eq!(cases, Suite::load(&root).cases);
    let (cases, errors) = load_file(&root, &root.join("a/two.st"));
    assert_eq!((cases.len(), errors.len()), (0, 1));
    let (_, errors) = load_file(&root, &root.join("suite.toml"));
    assert!(errors[0].message.contains("a case file ends in .st or .toml"));
    let (_, errors) = load_file(&root, Path::new("/nowhere/x.st"));
    assert!(errors[0].message.contains("is not below"));
    let (_, errors) = load_file(&root, &root.join("a/missing.st"));
    assert!(errors[0].message.contains("cannot be read"));
}

#[test]
fn a_folder_that_is_not_there_is_a_mistake() {
    let folder = tempfile::tempdir().unwrap();
    let suite = Suite::load(&folder.path().join("nowhere"));
    assert!(suite.cases.is_empty());
    assert!(
        suite
            .errors
            .iter()
            .any(|error| error.file == "nowhere" && error.message.contains("cannot be read"))
    );
}

#[test]
fn what_no_id_can_have_is_said_of_a_path() {
    let suite = load(&[("a/b c.st", PROGRAM), ("a/é.toml", "")]);
    assert_eq!(suite.errors.len(), 2);
    assert!(
        suite.errors[0].message.contains("' ' cannot stand in an id"),
        "{}",
        suite.errors[0]
    );
}

#[test]
fn any_bytes_are_no_reason_to_fail() {
    let folder = folder(&[("a/good.st", PROGRAM)]);
    let root = folder.path().join("cases");
    let bad: &[(&str, Vec<u8>)] = &[
        ("a/b1.st", b"x\n\xFF\xFE".to_vec()),
        ("a/b2.toml", b"\xC3\x28".to_vec()),
        ("a/b3.st", vec![0; 1000]),
        ("a/b4.toml", vec![0; 1000]),
        ("a/b5.toml", b"[".repeat(100_000)),
        (
            "a/b6.toml",
            b"a=".iter().chain(b"[".repeat(100_000).iter()).copied().collect(),
        ),
        ("a/b7.st", b"(*!".repeat(10_000)),
        ("a/b8.st", b"(*! '\"$".repeat(10_000)),
        ("a/b9.toml", b"title = '''".to_vec()),
        ("a/c1.st", Vec::new()),
        ("a/c2.toml", Vec::new()),
    ];
    for (path, bytes) in bad {
        write(&root, path, bytes);
    }
    let suite = Suite::load(&root);
    assert_eq!(suite.cases.len(), 1);
    assert_eq!(suite.errors.len(), bad.len(), "{:#?}", suite.errors);
    let said = suite.errors[0].to_string();
    assert_eq!(
        said,
        "cases/a/b1.st:2: the text is not UTF-8: byte 2 begins no character"
    );
}

#[test]
fn a_file_that_is_too_long_is_not_read() {
    let folder = folder(&[]);
    let root = folder.path().join("cases");
    std::fs::create_dir_all(root.join("a")).unwrap();
    std::fs::File::create(root.join("a/big.st"))
        .unwrap()
        .set_len(17 << 20)
        .unwrap();
    let (_, errors) = load_file(&root, &root.join("a/big.st"));
    assert!(errors[0].message.contains("longer than 16 MiB"), "{}", errors[0]);
}

#[test]
fn the_same_mistake_in_a_thousand_cells_is_not_said_a_thousand_times() {
    let columns: Vec<String> = (0..40).map(|at| format!("STRING[{at}]")).collect();
    let rows: Vec<String> = columns
        .iter()
        .map(|row| format!("{row}{}", " no".repeat(40)))
        .collect();
    let text = format!(
        "title = \"t\"\nbasis = \"b: c\"\ndialects = [\"all\"]\nmatrix = '''\n{}\n{}\n'''\n[[probe]]\nname = \"p\"\nsource = '{{row}}'\n",
        columns.join(" "),
        rows.join("\n")
    );
    let suite = load(&[("a/file.toml", &text)]);
    assert!(suite.errors.len() < 60, "{}", suite.errors.len());
    assert!(
        suite
            .errors
            .iter()
            .any(|error| error.message.contains("further mistakes"))
    );
}

fn findings(files: &[(&str, &str)]) -> Vec<(LintSeverity, String)> {
    let folder = folder(files);
    let found = lint(&folder.path().join("cases"), &[]);
    found
        .into_iter()
        .map(|finding| (finding.severity, finding.what.to_string()))
        .collect()
}

#[test]
fn lint_has_nothing_to_say_of_a_sound_suite() {
    assert_eq!(findings(&[("a/one.st", PROGRAM)]), []);
}

#[test]
fn lint_says_what_only_a_reader_would_notice() {
    for (path, text, said) in [
        (
            "a/f.st",
            PROGRAM.replace("(*! ok *)", ""),
            "cases/a/f.st:1: the case claims nothing but that the program is accepted",
        ),
        (
            "a/f.st",
            PROGRAM
                .replace("x;", "(*! observe x : INT *)")
                .replace("(*! ok *)", ""),
            "cases/a/f.st:3: `basis`: `iec-61131-3: 6` stands where nothing is asserted (leave it out)",
        ),
        (
            "a/f.st",
            PROGRAM.replace("x;", "'(*! ok *)'"),
            "cases/a/f.st:6: `(*!` stands in a string",
        ),
        (
            "a/f.st",
            PROGRAM.replace("x;", "(*! ok in plcnext *)"),
            "cases/a/f.st:6: the mark applies in none of the file's dialects",
        ),
        (
            "a/f.txt",
            String::new(),
            "cases/a/f.txt:1: the file is neither a case file",
        ),
    ] {
        let found = findings(&[(path, &text)]);
        assert!(
            found.len() == 1 && found[0].0 == LintSeverity::Warning,
            "{found:?}"
        );
        assert!(found[0].1.starts_with(said), "{said}: {found:?}");
    }
}

#[test]
fn a_case_that_asserts_something_cites_a_source_that_there_is() {
    let basis = "basis = \"iec-61131-3: 6\"\n";
    for (basis_then, said) in [
        (
            "basis = \"iec-61131: 6\"\n",
            "3: `basis`: no source `iec-61131`; did you mean `iec-61131-3`?",
        ),
        (
            "basis = \"iec-61131-3: six\"\n",
            "3: `basis`: `iec-61131-3` has no section `six`; write a clause",
        ),
        (
            "basis = \"rule: mine\"\n",
            "3: `basis`: no rule `mine`; there is none",
        ),
        (
            "basis = \"rule: not-stated\"\n",
            "3: `basis`: a case asserts something, so a source must state it",
        ),
        (
            "",
            "1: `basis`: a case asserts something and has no basis (say where",
        ),
        (
            "basis = \"\"\n",
            "1: `basis`: a case asserts something and has no basis (say where",
        ),
        (
            "basis = [\"\", \"iec-61131-3: 6\"]\n",
            "3: `basis`: `` is not written `source: section`",
        ),
    ] {
        let text = PROGRAM.replace(basis, basis_then);
        let found = findings(&[("a/f.st", &text), ("sources.toml", &sources(&[("", PROGRAM)]))]);
        assert!(found.len() == 1 && found[0].0 == LintSeverity::Error, "{found:?}");
        assert!(found[0].1.contains(said), "{said}: {found:?}");
    }
}

#[test]
fn a_case_cites_a_source_that_speaks_for_its_dialect() {
    let page = "[page]\ntitle = 't'\npublisher = 'p'\nkind = 'document'\naddress = 'https://example.org'\nread = '1'\n\
                engines = []\ndialects = ['plcnext']\nsections = ['s']\n";
    let text = PROGRAM.replace("iec-61131-3: 6", "page: s");
    let found = findings(&[("a/f.st", &text), ("sources.toml", page)]);
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].0, LintSeverity::Error);
    assert_eq!(
        found[0].1,
        "cases/a/f.st:3: `basis`: `page: s` does not speak for matiec (cite what says it of this dialect; where nothing does, leave it open)"
    );
}

#[test]
fn a_case_that_asserts_nothing_needs_no_basis_and_is_not_stated() {
    let text = PROGRAM
        .replace("basis = \"iec-61131-3: 6\"\n", "")
        .replace("x; (*! ok *)", "(*! observe acceptance *)");
    let suite = load(&[("a/f.st", &text)]);
    assert!(suite.findings().is_empty(), "{:?}", suite.findings());
    assert!(suite.cases[0].is_open());
    assert_eq!(&*suite.cases[0].basis, stickler_suite::NOT_STATED);
}

#[test]
fn lint_says_what_in_a_table_has_no_use() {
    let table = "title = \"t\"\nbasis = \"iec-61131-3: 6\"\ndialects = [\"matiec\"]\ncolumns = [\"a\",\n\"b\"]\nrows = [[\"1\", \"2\"]]\n\
        [[probe]]\nname = \"p\"\nsource = '''\n{a} (*! ok *)\n(*! error P0002 if a = 2 *)\n'''\n[[probe]]\nname = \"q\"\nonly = \"a = 3\"\nsource = '(*! ok *)'\n\
        [[probe]]\nname = \"r\"\nsource = '{a}'\n";
    let found: Vec<String> = findings(&[("a/f.toml", table)])
        .into_iter()
        .map(|(_, said)| said)
        .collect();
    assert_eq!(
        found,
        [
            "cases/a/f.toml:5: `columns`: nothing uses the column `b`",
            "cases/a/f.toml:6: the probe `r` claims nothing but that the program is accepted for this row \
         (if that is the claim, say `(*! ok *)` on the line that matters)",
            "cases/a/f.toml:11: `probe.source`: the mark applies in no case",
            "cases/a/f.toml:14: `probe`: the probe `q` has no case",
        ]
    );
}

#[test]
fn lint_asks_for_a_readme_in_each_area() {
    let folder = folder(&[("a/one.st", PROGRAM)]);
    let root = folder.path().join("cases");
    std::fs::remove_file(root.join("a/README.md")).unwrap();
    let found = lint(&root, &[]);
    assert_eq!(found.len(), 1);
    assert_eq!(
        found[0].what.to_string(),
        "cases/a:1: the folder has no README.md that says what is claimed there"
    );
}

#[test]
fn lint_says_which_source_and_which_rule_no_case_needs() {
    let source = sources(&[("", "iec-61131-3: b: ")]);
    let found = findings(&[
        ("a/one.st", PROGRAM),
        ("sources.toml", &format!("\n{source}")),
        ("rules.md", "# Rules\n\n## idle\n"),
    ]);
    let said: Vec<&str> = found.iter().map(|(_, said)| said.as_str()).collect();
    assert_eq!(
        said,
        [
            "cases/rules.md:3: no case rests on the rule `idle` (take it out)",
            "cases/sources.toml:2: `b`: no case cites the source (take it out)",
        ]
    );
}

#[test]
fn lint_says_which_engine_of_a_source_is_unknown() {
    let source = sources(&[("", "iec-61131-3: ")]);
    let folder = folder(&[
        ("a/one.st", PROGRAM),
        (
            "sources.toml",
            &source.replace("read", "engines = ['matieck']\nread"),
        ),
    ]);
    let found = lint(&folder.path().join("cases"), &["matiec", "rusty"]);
    assert_eq!(found.len(), 1);
    assert_eq!(
        found[0].what.to_string(),
        "cases/sources.toml:1: `iec-61131-3`: no built-in engine `matieck`; did you mean `matiec`?"
    );
}

#[test]
fn hidden_files_are_not_looked_at() {
    assert_eq!(
        findings(&[("a/one.st", PROGRAM), ("a/.one.st.swp", ""), (".git/x.st", "")]),
        []
    );
}

#[test]
fn the_suites_own_files_are_checked() {
    let folder = folder(&[("a/one.st", PROGRAM)]);
    let root = folder.path().join("cases");
    write(&root, "suite.toml", "version = 1");
    write(&root, "dialects.toml", "[groups]\nx = [\n\"y\"]");
    let suite = Suite::load(&root);
    let said: Vec<String> = suite.errors.iter().map(ToString::to_string).collect();
    assert_eq!(said.len(), 2, "{said:?}");
    assert!(
        said[0].starts_with("cases/dialects.toml:3: `groups.x`: unknown dialect `y`"),
        "{}",
        said[0]
    );
    assert!(
        said[1].starts_with("cases/suite.toml:1: `version`: invalid type"),
        "{}",
        said[1]
    );
    assert_eq!(suite.cases.len(), 1);
}

#[test]
fn a_program_of_many_broken_marks_is_said_in_a_few_lines() {
    let text = format!("{PROGRAM}{}", "(*!*)\n(* (*! *)\n".repeat(20_000));
    let folder = folder(&[("a/f.st", &text)]);
    let found = lint(&folder.path().join("cases"), &[]);
    assert!(found.len() < 120, "{}", found.len());
    assert!(
        found
            .iter()
            .any(|finding| finding.what.message.contains("further mistakes"))
    );
}
