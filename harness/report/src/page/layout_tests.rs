//! Tests of the space that the page takes: what is wider than a window scrolls by itself, and columns with the same cells are one.
//!
//! The tests need a Chromium and a ChromeDriver; where one is missing, each test says so and checks nothing.

use super::keyboard_tests::opened;
use serde_json::json;

/// An expression whose value are the heads of the table of values, each as its lines.
const HEADS: &str = "[...document.querySelectorAll('table.values thead th')].map((head) => head.innerText.split('\\n').filter((line) => line !== ''))";

#[test]
fn nothing_is_wider_than_a_narrow_window() {
    let Some((driver, _folder)) = opened() else { return };
    driver.resize(400, 800);
    for address in [
        "#explorer",
        "#REAL_TO_INT",
        "#convert?from=INT&to=USINT",
        "#matrix",
        "#bits",
        "#claims?source=ironplc-type-conversions",
        "#causes?cause=reference/1",
        "#cases?q=evil",
        "#observations",
    ] {
        driver.follow(address);
        let widths =
            driver.value("[document.documentElement.scrollWidth, document.documentElement.clientWidth]");
        assert_eq!(widths[0], widths[1], "{address} is wider than the window");
    }
}

#[test]
fn columns_are_one_as_long_as_the_shown_values_have_the_same_results() {
    let Some((driver, _folder)) = opened() else { return };
    driver.follow("#REAL_TO_INT");
    let [operand, ed2, engine] = [
        json!(["REAL"]),
        json!(["documents", "ironplc-ed2"]),
        json!(["reference", "ironplc-ed2"]),
    ];
    let compiler = json!(["STruC++ 0.6.1", "recorded 2026-11-24", "ironplc-ed2"]);
    let silent = json!(["documents", "plcnext", "strucpp", "codesys"]);
    assert_eq!(
        driver.value(HEADS),
        json!([operand, ed2, silent, compiler, engine])
    );

    driver.value("[...document.querySelectorAll('main button')].find((button) => button.innerText.startsWith('Show all')).click()");
    let recorded = json!(["0.239", "recorded", "plcnext"]);
    let silent = json!(["documents", "strucpp", "codesys"]);
    assert_eq!(
        driver.value(HEADS),
        json!([operand, ed2, recorded, silent, compiler, engine])
    );
    let notes = driver.value("document.querySelector('ul.notes').innerText");
    assert!(
        notes
            .as_str()
            .is_some_and(|notes| notes.contains("builds: 2026 (recording)")),
        "{notes}"
    );
    let address = driver.value(
        "[...document.querySelectorAll('ul.notes a')].find((link) => link.innerText === 'builds: 2026').href",
    );
    assert_eq!(address, "https://example.org/2026#2026");
}
