//! Tests of the page with nothing but a keyboard: the order of the focus, the link over the head, and the search field.
//!
//! The tests need a Chromium and a ChromeDriver; where one is missing, each test says so and checks nothing.

use super::browser_tests::{OPTIONS, browser, write};
use super::web_driver::{ENTER, TAB, WebDriver};
use std::iter;
use tempfile::TempDir;

/// The maximum number of times that Tab is pressed in search of an element.
const MAX_TABS: usize = 200;

/// An expression whose value is the place of the focused element among all elements, a name of it, and whether it is visible.
const FOCUSED: &str = "(() => { const at = document.activeElement; return [[...document.querySelectorAll('*')].indexOf(at), \
    at.getAttribute('type') || at.id || at.textContent.trim(), at.checkVisibility() && at.getClientRects().length > 0]; })()";

/// Opens the page of a run with failures; `None` where something to open it with is missing.
pub(super) fn opened() -> Option<(WebDriver, TempDir)> {
    let browser = browser()?;
    let folder = tempfile::tempdir().expect("a temporary folder");
    let profile = format!("--user-data-dir={}", folder.path().join("profile").display());
    let options: Vec<&str> = OPTIONS.into_iter().chain([profile.as_str()]).collect();
    let driver = WebDriver::start(&browser, &options)?;
    driver.open(&format!("file://{}", write(folder.path()).display()));
    Some((driver, folder))
}

/// Presses Tab until the focus leaves the page; returns the names of the elements that had it. Fails where the focus goes back,
/// or to an element that nobody sees.
fn focus_order(driver: &WebDriver) -> Vec<String> {
    let mut names = Vec::new();
    let mut last = 0;
    while names.len() < MAX_TABS {
        driver.press([TAB]);
        let focused = driver.value(FOCUSED);
        let name = focused[1].as_str().unwrap_or_default();
        if driver.value("document.activeElement === document.body").as_bool() == Some(true) {
            return names;
        }
        let place = focused[0].as_u64().expect("a place");
        if place < last && names.first().is_some_and(|first| first == name) {
            return names;
        }
        assert!(place > last, "the focus goes back to {name} after {names:?}");
        assert_eq!(
            focused[2].as_bool(),
            Some(true),
            "nobody sees that {name} has the focus"
        );
        names.push(name.to_owned());
        last = place;
    }
    panic!("the focus never leaves the page: {names:?}");
}

#[test]
fn the_focus_goes_through_the_page_from_its_beginning_to_its_end() {
    let Some((driver, _folder)) = opened() else { return };
    let order = focus_order(&driver);
    let place = |name: &str| {
        let found = order.iter().position(|element| element == name);
        found.unwrap_or_else(|| panic!("{name} never has the focus: {order:?}"))
    };
    assert_eq!(place("skip"), 0);
    assert!(place("Conversions") < place("Causes") && place("Causes") < place("search"));
    assert!(place("search") < place("submit"));
}

#[test]
fn the_first_link_leads_over_the_head() {
    let Some((driver, _folder)) = opened() else { return };
    driver.press([TAB, ENTER]);
    assert_eq!(driver.value("document.activeElement.id"), "main");
    driver.press([TAB]);
    assert_eq!(
        driver.value("document.activeElement.closest('main') !== null"),
        true
    );
}

#[test]
fn what_is_typed_in_the_search_field_is_shown() {
    let Some((driver, _folder)) = opened() else { return };
    for (typed, address, place, shown) in [
        ("real_to_int 2.25", "#REAL_TO_INT?value=2.25", "tr.wanted", "2.25"),
        (
            "INT to SINT",
            "#convert?from=INT&to=SINT",
            "h3",
            "Does INT become SINT",
        ),
        (
            "REAL_TO_NOTHING",
            "#REAL_TO_NOTHING",
            "p.notice",
            "a function REAL_TO_NOTHING",
        ),
    ] {
        driver.value("document.querySelector('input[type=search]').select()");
        driver.press(typed.chars().chain(iter::once(ENTER)));
        assert_eq!(driver.value("location.hash"), address);
        assert_eq!(
            driver.value("document.activeElement.id"),
            "main",
            "a keyboard goes on from there"
        );
        let text = driver.value(&format!("document.querySelector('#main {place}').innerText"));
        assert!(
            text.as_str().is_some_and(|text| text.contains(shown)),
            "{typed}: {text}"
        );
    }
}
