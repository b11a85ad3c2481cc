//! Tests the page of conversion functions.

use super::tests::write_golden;
use crate::page::{browser, data_of, open};
use serde_json::Value;
use std::fs;
use std::path::Path;

/// Writes the site of `golden-sites/functions`, of the reference and another engine.
fn write_site(folder: &Path) {
    let golden = Path::new(env!("CARGO_MANIFEST_DIR")).join("golden-sites/functions");
    write_golden(&golden, folder);
}

#[test]
fn the_page_of_functions_has_what_documents_state_and_what_engines_and_recorded_compilers_answered() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    write_site(folder.path());
    let page = fs::read_to_string(folder.path().join("site/functions/index.html")).expect("a page");
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
    assert!(!page.contains("id=\"data-cases\""));
}

#[test]
fn a_browser_shows_the_functions_of_a_site_and_the_values_of_one() {
    let Some(browser) = browser() else { return };
    let folder = tempfile::tempdir().expect("a temporary folder");
    write_site(folder.path());
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
