//! Tests the page of conversion functions.

use super::tests::written;
use super::write;
use crate::page::{browser, data_of, open};
use crate::sample;
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::sync::Arc;
use stickler_conversions::overview::{CaseProgram, Statements, StatementsBuilder};
use stickler_conversions::recording::Recording;
use stickler_run::{CaseEvent, Event, Verdict};
use stickler_types::DialectName;

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
        result: Some(&stickler_types::Value::parse("INT#99").expect("a literal")),
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
fn the_page_of_functions_has_what_documents_state_and_what_engines_and_recorded_compilers_answered() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let site = site(folder.path());
    let page = site("functions/index.html");
    let run = data_of(&page, "run");
    assert_eq!(run["header"]["engines"][0]["name"], "compiler");
    assert_eq!(run["header"]["engines"][0]["page"], "../runs/2.html");
    assert!(run["header"]["engines"][1]["page"].is_null());
    let sources = run["header"]["sources"].as_array().expect("sources");
    assert_eq!(sources[0]["key"], "ironplc-type-conversions");
    let conversions = data_of(&page, "conversions");
    let words = conversions["answers"]["words"].as_array().expect("words");
    let columns = conversions["answers"]["columns"].as_array().expect("columns");
    let name = |column: &Value| {
        words[usize::try_from(column["engine"].as_u64().expect("a number")).expect("small")].clone()
    };
    let names: Vec<Value> = columns.iter().map(name).collect();
    assert_eq!(names, ["compiler", "reference", "A <b>PLC</b> 3.5"]);
    assert_eq!(
        columns[0]["other"][0].as_array().map(Vec::len),
        Some(1),
        "it departs from the source"
    );
    assert_eq!(columns[1]["met"].as_array().map(Vec::len), Some(1));
    assert_eq!(columns[2]["other"][0].as_array().map(Vec::len), Some(2));
    assert!(!page.contains("id=\"data-cases\"") && !page.contains("<b>PLC"));
    let led = site("functions/REAL_TO_INT.html");
    assert!(led.contains("content=\"0; url=index.html#REAL_TO_INT\""), "{led}");
}

#[test]
fn an_engine_names_the_functions_on_which_it_departs() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let page = site(folder.path());
    assert!(page("index.html").contains("<a href=\"functions/index.html\">"));
    let departs = "<a href=\"../functions/index.html#REAL_TO_INT\">REAL_TO_INT</a>: 1 value<";
    assert!(page("engines/compiler.html").contains(departs));
    assert!(!page("engines/reference.html").contains("REAL_TO_INT"));
}

#[test]
fn a_browser_shows_the_functions_of_a_site_and_the_values_of_one() {
    let Some(browser) = browser() else { return };
    let folder = tempfile::tempdir().expect("a temporary folder");
    let _ = site(folder.path());
    let path = folder.path().join("site/functions/index.html");
    let shown = |address: &str| open(&browser, &path, address, "--dump-dom");
    let list = shown("");
    for part in [
        ">REAL_TO_INT</a></th>",
        "✗ 1</span>",
        "<a href=\"../index.html\">",
        ">Functions</a>",
    ] {
        assert!(list.contains(part), "{part}\n{list}");
    }
    assert!(!list.contains(">Claims</a>") && !list.contains("<b>PLC"));
    let function = shown("#REAL_TO_INT");
    for part in [
        "<a href=\"../runs/2.html#REAL_TO_INT\">compiler</a>",
        "✗ 3</span>",
        "2 <span class=\"tag pass\">✓",
        "✗ crashed",
    ] {
        assert!(function.contains(part), "{part}\n{function}");
    }
    assert!(shown("#bits").contains("Bit access") && shown("#matrix").contains("Implicit conversion"));
}
