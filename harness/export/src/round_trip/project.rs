//! Tests that all pages make one project, which is valid by the public schema of the format.

use super::*;
use crate::ProjectPlan;
use std::process::Command;
use stickler_mdtest::assert_fits;

/// Exports cases with a project, and returns its text.
fn project(dialect: DialectName, cases: &[Case]) -> Result<String, crate::ExportError> {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("all.xml");
    let plan = ExportPlan {
        project: Some(ProjectPlan {
            file: file.clone(),
            created: "2026-11-23T20:00:00Z".to_owned(),
        }),
        cases_per_page: 2,
        ..plan(dialect)
    };
    let cases: Vec<&Case> = cases.iter().collect();
    export(&plan, &cases, &folder.path().join("pages"))?;
    Ok(fs::read_to_string(&file).expect("a project"))
}

/// Returns the values of an attribute in all elements that begin with `<element `.
fn values<'t>(text: &'t str, element: &str, attribute: &str) -> Vec<&'t str> {
    let begin = format!("<{element} {attribute}=\"");
    let found = text.split(&begin).skip(1);
    found.filter_map(|rest| rest.split('"').next()).collect()
}

#[test]
fn names_of_units_are_unique_in_a_project_and_every_program_runs() {
    let text = project(DialectName::IRONPLC_ED3, &cases(&FILES)).expect("a project");
    for element in ["pou", "dataType"] {
        let names = values(&text, element, "name");
        let different: BTreeSet<&str> = names.iter().copied().collect();
        assert!(!names.is_empty(), "{element}");
        assert_eq!(names.len(), different.len(), "{element}: {names:?}");
    }
    let programs = text.matches("pouType=\"program\"").count();
    assert!(programs > 1);
    assert_eq!(text.matches("<pouInstance ").count(), programs);
}

#[test]
fn a_project_is_valid_by_the_schema_where_that_is_at_hand() {
    let Some(schema) = std::env::var_os("STICKLER_PLCOPEN_SCHEMA") else {
        eprintln!("not validated: STICKLER_PLCOPEN_SCHEMA does not name tc6_xml_v201.xsd");
        return;
    };
    for dialect in DialectName::ALL {
        let cases = cases(&FILES);
        if !cases.iter().any(|case| case.dialect == dialect) {
            continue;
        }
        let text = project(dialect, &cases).expect("a project");
        let file = tempfile::NamedTempFile::new().expect("a file");
        fs::write(file.path(), text).expect("written");
        let command = Command::new("xmllint")
            .args(["--noout", "--schema"])
            .arg(&schema)
            .arg(file.path())
            .output();
        let Ok(ended) = command else {
            eprintln!("not validated: xmllint is not installed");
            return;
        };
        assert!(
            ended.status.success(),
            "{dialect}: {}",
            String::from_utf8_lossy(&ended.stderr)
        );
    }
}

/// A program for Python that reads a project with the classes of Beremiz, and writes the Structured Text that its compiler gets.
const BEREMIZ: &str = include_str!("beremiz.py");

#[test]
fn beremiz_reads_a_project_where_it_is_installed() {
    let Some(beremiz) = std::env::var_os("STICKLER_BEREMIZ") else {
        eprintln!("not read: STICKLER_BEREMIZ does not name the folder of Beremiz");
        return;
    };
    let cases = cases(&["conversion/real-to-integer.toml", "widening/integer.toml"]);
    let text = project(DialectName::MATIEC, &cases).expect("a project");
    let folder = tempfile::tempdir().expect("a folder");
    let (xml, st) = (folder.path().join("all.xml"), folder.path().join("all.st"));
    fs::write(&xml, &text).expect("written");
    let read = Command::new("python3")
        .args(["-c", BEREMIZ])
        .args([&xml, &st])
        .env("PYTHONPATH", beremiz)
        .env("PYTHONDONTWRITEBYTECODE", "1")
        .current_dir(folder.path())
        .output()
        .expect("python3");
    assert!(read.status.success(), "{}", String::from_utf8_lossy(&read.stderr));
    let generated = fs::read_to_string(&st).expect("a program");
    let programs = text.matches("pouType=\"program\"").count();
    assert_eq!(generated.matches("END_PROGRAM").count(), programs);
    let dialect = stickler_types::Dialect::of(DialectName::MATIEC);
    let (_, diagnostics) = stickler_syntax::parse(&generated, dialect);
    assert!(diagnostics.is_empty(), "{diagnostics:?}");
}

/// Returns a case of the suite with a comment in its statements.
fn commented(comment: &str) -> Vec<Case> {
    let mut cases = cases(&["widening/integer.toml"]);
    cases.retain(|case| case.dialect == DialectName::IRONPLC_ED2 && case.source.contains("END_VAR\n"));
    cases.truncate(1);
    let source = cases[0]
        .source
        .replacen("END_VAR\n", &format!("END_VAR\n(* {comment} *)\n"), 1);
    cases[0].source = source.into();
    cases
}

#[test]
fn text_is_escaped_and_a_character_that_xml_cannot_hold_is_refused_with_its_place() {
    let text = project(DialectName::IRONPLC_ED2, &commented("a < b & c ]]> <d/>")).expect("a project");
    assert_fits(&text, "…(* a &lt; b &amp; c ]]&gt; &lt;d/&gt; *)…");
    let cases = commented("bell \u{7}");
    let error = project(DialectName::IRONPLC_ED2, &cases)
        .expect_err("a bell")
        .to_string();
    assert_fits(&error, "page-001.st:…U+0007…");
    assert!(error.contains(&*cases[0].id), "{error}");
}
