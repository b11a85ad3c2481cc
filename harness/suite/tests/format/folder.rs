//! Folders of case files that no example can write down: files that are wanted, any bytes as a case file, limits.

use std::path::Path;

use crate::folders::{folder, load, write};
use stickler_mdtest::assert_fits;
use stickler_suite::{CaseFileError, FileKind, LintFinding, Suite, Wanted, lint, load_file};
use stickler_types::DialectName;

const PROGRAM: &str =
    "(*!\ntitle = \"t\"\nbasis = \"iec-61131-3: 6\"\ndialects = [\"matiec\"]\n*)\nx; (*! ok *)\n";

#[test]
fn only_the_files_that_are_wanted_are_read() {
    let table = "title = 't'\nbasis = 'iec-61131-3: 6'\ndialects = ['matiec']\ncolumns = ['a']\nrows = [['1']]\n\
                 [[probe]]\nname = 'p'\nsource = 'x := {a}; (*! ok *)'\n";
    let folder = folder(&[("a/bad.st", "x"), ("a/good.st", PROGRAM), ("a/good.toml", table)]);
    let wanted = |wanted: FileKind| {
        let suite = Suite::load_files(&folder.path().join("cases"), Wanted::default(), |id, kind| {
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

/// A table of twenty-four rows that each dialect is asked, one of which is another in the third edition.
fn of_two_editions() -> String {
    let rows: Vec<String> = (0..24).map(|row| format!("['{row}']")).collect();
    format!(
        "title = 't'\nbasis = 'iec-61131-3: 6'\ndialects = ['ironplc-ed2', 'ironplc-ed3']\ncolumns = ['a']\nrows = [{}]\n\
         [[probe]]\nname = 'p'\nsource = \"\"\"x := {{a}};\n(*! ok if a <> 7 *) (*! error P4035 if a = 7 in ironplc-ed3 *)\n\"\"\"\n",
        rows.join(", ")
    )
}

#[test]
fn an_edition_repeats_a_sample_of_the_other_and_what_differs() {
    let table = of_two_editions();
    let folder = folder(&[("a/t.toml", &table)]);
    let load = |wanted: Wanted<'_>| {
        let suite = Suite::load_with(&folder.path().join("cases"), wanted);
        assert!(suite.errors.is_empty(), "{:?}", suite.errors);
        let of = |dialect| {
            let cases = suite.cases.iter().filter(|case| case.dialect == dialect);
            cases.map(|case| case.id.to_string()).collect::<Vec<_>>()
        };
        [of(DialectName::IRONPLC_ED2), of(DialectName::IRONPLC_ED3)]
    };
    let [second, third] = load(Wanted::default());
    assert!(
        second.len() < 8 && second.contains(&"a/t::p(7)".to_owned()),
        "{second:?}"
    );
    assert_eq!(third.len(), 24);
    let alone = Wanted {
        asked: &[DialectName::IRONPLC_ED2],
        ..Wanted::default()
    };
    assert_eq!(load(alone).map(|ids| ids.len()), [24, 0]);
    let with_repeats = Wanted {
        with_repeats: true,
        ..Wanted::default()
    };
    assert_eq!(load(with_repeats).map(|ids| ids.len()), [24, 24]);
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
    let is_told = |error: &CaseFileError| error.file == "nowhere" && error.message.contains("cannot be read");
    assert!(suite.errors.iter().any(is_told));
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
    let is_short = |error: &CaseFileError| error.message.contains("further mistakes");
    assert!(suite.errors.iter().any(is_short));
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
fn a_program_of_many_broken_marks_is_said_in_a_few_lines() {
    let text = format!("{PROGRAM}{}", "(*!*)\n(* (*! *)\n".repeat(20_000));
    let folder = folder(&[("a/f.st", &text)]);
    let found = lint(&folder.path().join("cases"), &[]);
    assert!(found.len() < 120, "{}", found.len());
    let is_short = |finding: &LintFinding| finding.what.message.contains("further mistakes");
    assert!(found.iter().any(is_short));
}

#[test]
fn a_table_has_no_thousand_columns() {
    let columns: Vec<String> = (0..1000).map(|at| format!("\"c{at}\"")).collect();
    let text = format!(
        "title = 't'\ndialects = ['matiec']\ncolumns = [{}]\nrows = []\n",
        columns.join(", ")
    );
    let suite = load(&[("a/t.toml", &text)]);
    let said = suite.errors[0].to_string();
    assert_fits(
        &said,
        "…a/t.toml:1: `columns`: 1000 columns; a table has at most 100…",
    );
}

#[test]
fn a_program_may_have_carriage_returns_a_byte_order_mark_and_no_last_line_break() {
    let text = PROGRAM
        .replace("x; (*! ok *)\n", "x; (*! error P0002 *)\n(*! ok *)")
        .replace('\n', "\r\n");
    let suite = load(&[("a/f.st", &format!("\u{FEFF}{text}"))]);
    let expectation = &suite.cases[0].expectation;
    assert_eq!(
        (expectation.diagnostics[0].line, &expectation.clean_lines[..]),
        (6, &[7][..])
    );
    let text = PROGRAM
        .replace("x; (*! ok *)\n", "(*! values\nx = INT#1\n*)")
        .replace('\n', "\r\n");
    let suite = load(&[("a/f.st", &text)]);
    assert_eq!(suite.cases[0].expectation.values[0].value.to_string(), "INT#1");
}

#[test]
fn many_variables_are_observed_once_each_like_few() {
    let marks: String = (0..100)
        .map(|at| format!("(*! observe v{at} : INT *)\n"))
        .collect();
    let suite = load(&[("a/f.st", &format!("{PROGRAM}{marks}{marks}"))]);
    assert_eq!(suite.cases[0].observe.len(), 100);
}
