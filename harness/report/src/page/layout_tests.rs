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
        json!(["Stickler's model of", "ironplc-ed2"]),
    ];
    let compiler = json!(["STruC++ 0.6.1", "recorded 2026-11-24", "ironplc-ed2"]);
    let silent = |dialects: &str| {
        let shown = driver.value("document.querySelector('#silent').innerText");
        assert!(
            shown.as_str().is_some_and(|text| text.ends_with(dialects)),
            "{shown}"
        );
    };
    assert_eq!(driver.value(HEADS), json!([operand, ed2, compiler, engine]));
    silent("must come: plcnext, strucpp, codesys.");

    driver.value("[...document.querySelectorAll('main button')].find((button) => button.innerText.startsWith('Show all')).click()");
    let recorded = json!(["0.239", "recorded", "plcnext"]);
    assert_eq!(
        driver.value(HEADS),
        json!([operand, ed2, recorded, compiler, engine])
    );
    silent("must come: strucpp, codesys.");
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

#[test]
fn the_reader_s_own_system_comes_first_and_is_remembered() {
    let Some((driver, _folder)) = opened() else { return };
    let first = "document.querySelector('.panel h4').innerText";
    driver.follow("#REAL_TO_INT");
    assert_eq!(driver.value(first), "PLCnext Engineer · STruC++");
    driver.value("(() => { const at = document.querySelector('#system'); at.value = 'codesys'; at.dispatchEvent(new Event('change')); })()");
    assert_eq!(driver.value(first), "CODESYS");
    driver.value("location.reload()");
    assert_eq!(driver.value(first), "CODESYS");
    assert_eq!(driver.value("document.querySelector('#system').value"), "codesys");

    // An arrow key goes to the next sample, and says what comes of it.
    driver.value("document.querySelector('.plot').focus()");
    driver.press(['\u{e014}']);
    let readout = driver.value("document.querySelector('.readout strong').innerText");
    assert_eq!(readout, "2.5000002 → 3");
}
