//! Tests of the page under control, mostly with nothing but a keyboard: the order of the focus, and the sessions of `golden-page/sessions.toml`.
//!
//! The tests need a Chromium and a ChromeDriver; where one is missing, each test says so and checks nothing.

use super::browser_tests::{OPTIONS, browser, write};
use super::web_driver::{TAB, WebDriver};
use serde::Deserialize;
use serde_json::Value;
use tempfile::TempDir;

/// The maximum number of times that Tab is pressed in search of an element.
const MAX_TABS: usize = 200;

/// An expression whose value is the place of the focused element among all elements, a name of it, and whether it is visible.
const FOCUSED: &str = "(() => { const at = document.activeElement; return [[...document.querySelectorAll('*')].indexOf(at), \
    at.getAttribute('type') || at.id || at.textContent.trim(), at.checkVisibility() && at.getClientRects().length > 0]; })()";

/// Opens the page of a run with failures; `None` where something to open it with is missing.
fn opened() -> Option<(WebDriver, TempDir)> {
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

/// The sessions of the file `sessions.toml`: steps of a person in the browser, and the results that they must have.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Sessions {
    session: Vec<BrowserSession>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct BrowserSession {
    about: String,
    step: Vec<Step>,
}

/// Keys to press after the window was resized or an address was followed, and an expression whose value is this or a text with that in it.
#[derive(Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct Step {
    resize: Option<(u32, u32)>,
    follow: Option<String>,
    press: String,
    value: Option<String>,
    is: Option<Value>,
    contains: String,
}

#[test]
fn sessions_go_as_the_file_says() {
    let file: Sessions = toml::from_str(include_str!("../../golden-page/sessions.toml")).expect("sessions");
    for BrowserSession { about, step } in file.session {
        let Some((driver, _folder)) = opened() else { return };
        for step in step {
            step.resize
                .iter()
                .for_each(|(width, height)| driver.resize(*width, *height));
            step.follow.iter().for_each(|address| driver.follow(address));
            if !step.press.is_empty() {
                driver.press(step.press.chars());
            }
            let value = step.value.as_ref().map(|expression| driver.value(expression));
            let is_met = match (&value, &step.is) {
                (Some(_), None) if step.contains.is_empty() => true,
                (Some(value), None) => value.as_str().is_some_and(|text| text.contains(&step.contains)),
                (value, is) => value == is,
            };
            assert!(is_met, "{about}: {step:?} gives {value:?}");
        }
    }
}
