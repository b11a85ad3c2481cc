//! Tests the pages of conversion functions.

use super::tests::written;
use super::write;
use crate::sample;
use std::fs;
use std::path::Path;
use std::sync::Arc;
use stickler_conversions::overview::{CaseProgram, Statements, StatementsBuilder};
use stickler_conversions::recording::Recording;
use stickler_run::{CaseEvent, Event, Verdict};
use stickler_types::{DialectName, Value};

const PROGRAM: &str = "PROGRAM main\nVAR\n    data : REAL := 2.25;\n    into : INT;\nEND_VAR\n    into := REAL_TO_INT(data);\nEND_PROGRAM\n";

const RECORDING: &str = "[recording]\nproduct = \"A <b>PLC</b>\"\nversion = \"3.5\"\nplatform = \"linux\"\ndate = \"2026-11-24\"\n\
    [[answers]]\ndialects = [\"matiec\"]\n[answers.functions]\n\"REAL_TO_INT(REAL) : INT\" = [[\"2.25\", \"7\"], [\"2.5\", \"crashed\"]]\n";

fn statements() -> Statements {
    let mut builder = StatementsBuilder::new(vec![
        DialectName::IRONPLC_ED2,
        DialectName::IRONPLC_ED3,
        DialectName::MATIEC,
        DialectName::CODESYS,
    ]);
    let program = CaseProgram {
        case: &Arc::from("widening/c::variable(REAL,INT,2.25)"),
        dialect: DialectName::IRONPLC_ED2,
        source: PROGRAM,
        result: None,
        basis: &Arc::from("ironplc-conversion-functions: Real to Integer"),
    };
    builder.add_program(&program);
    builder.add_program(&CaseProgram {
        dialect: DialectName::CODESYS,
        result: Some(&Value::parse("INT#99").expect("a literal")),
        basis: &Arc::from("codesys-recording: functions"),
        ..program
    });
    builder.finish(&[Recording::parse("a-plc.toml", RECORDING).expect("a recording")])
}

/// Builds the site of a run of the reference and of one of another engine, and returns a page of it.
fn site(folder: &Path) -> impl Fn(&str) -> String {
    let case = |verdict| CaseEvent {
        got: vec![sample::value("into", "INT#3")],
        ..sample::case("c::variable(REAL,INT,2.25)", verdict)
    };
    let run = |name: &str, engine: &str, verdict| {
        let mut events = sample::with_sources(sample::run_of(vec![case(verdict)]));
        for event in &mut events {
            match event {
                Event::Header(header) => engine.clone_into(&mut header.engines[0].name),
                Event::Case(case) => engine.clone_into(&mut case.engine),
                Event::Footer(footer) => engine.clone_into(&mut footer.engines[0].name),
                Event::Cause(_) => {}
            }
        }
        written(&folder.join(name), &events)
    };
    let own = run("own", "reference", Verdict::Pass);
    let other = run("other", "compiler", Verdict::Fail);
    fs::write(other.join("index.html"), "the run's page").expect("written");
    let site = folder.join("site");
    let summary = write(&[own, other], false, &site, &statements()).expect("a site");
    assert_eq!(summary.functions, 1);
    move |page| fs::read_to_string(site.join(page)).expect("a page")
}

#[test]
fn a_page_has_each_value_by_documents_on_engines_and_on_recorded_compilers_with_its_source() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let page = site(folder.path())("functions/REAL_TO_INT.html");
    let (head, rows) = page.split_once("<tbody>").expect("a table");
    let heads: Vec<&str> = head.split("<th scope=\"col\"").skip(2).collect();
    let columns = [
        "documents<div class=\"dim\">ironplc-ed2</div><div class=\"dim\">ironplc-ed3</div>",
        "documents<div class=\"dim\">matiec</div>",
        "documents<div class=\"dim\">codesys</div>",
        "#REAL_TO_INT\">compiler 0.1.0</a><div class=\"dim\">ironplc-ed2</div>",
        "reference 0.1.0<div class=\"dim\">ironplc-ed2</div>",
        "A &lt;b&gt;PLC&lt;/b&gt; 3.5<div class=\"dim\">recorded 2026-11-24</div><div class=\"dim\">matiec</div>",
    ];
    assert_eq!(heads.len(), columns.len(), "{head}");
    for (head, column) in heads.iter().zip(columns) {
        assert!(head.contains(column), "{column} in {head}");
    }
    let row = |value: &str| {
        let start = format!("<th scope=\"row\" class=\"number\">{value}</th>");
        let (_, rest) = rows.split_once(&start).expect("the row");
        rest.split_once("</tr>").expect("its end").0.to_owned()
    };
    let cells: Vec<String> = row("2.25").split("<td").skip(1).map(str::to_owned).collect();
    for (cell, part) in cells.iter().zip([
        ">2 <sup>",
        ">2 <sup>",
        ">99 <sup>",
        "✗ 3",
        "2 <span class=\"tag pass\">✓",
        "✗ 7",
    ]) {
        assert!(cell.contains(part), "{part} in {cell}");
    }
    assert!(row("2.5").contains("✗ crashed"), "{}", row("2.5"));
    let (_, sources) = page.split_once("<h2>Sources</h2>").expect("the sources");
    assert!(
        sources.contains("ironplc-conversion-functions: Real to Integer")
            && sources.contains("codesys-recording: functions")
    );
    assert!(!page.contains("<script"));
}

#[test]
fn functions_are_listed_and_an_engine_names_those_on_which_it_departs() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let page = site(folder.path());
    let index = page("functions/index.html");
    let (_, row) = index
        .split_once("<a href=\"REAL_TO_INT.html\">")
        .expect("its row");
    assert!(
        row.contains("<td class=\"number\">1</td>") && row.contains("✗ 1") && row.contains(">–<"),
        "{row}"
    );
    assert!(page("index.html").contains("<a href=\"functions/index.html\">"));
    let departs = "<a href=\"../functions/REAL_TO_INT.html\">REAL_TO_INT</a>: 1 value<";
    assert!(page("engines/compiler.html").contains(departs));
    assert!(!page("engines/reference.html").contains("REAL_TO_INT"));
}
