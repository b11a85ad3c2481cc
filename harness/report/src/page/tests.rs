//! Tests of the page as a file: what is in it, that texts stay texts, and that nothing is loaded.

use super::{Page, SCRIPTS, STYLE, base64, data, skeleton};
use crate::groups::Groups;
use crate::sample;
use flate2::read::GzDecoder;
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use stickler_conversions::overview::Statements;
use stickler_mdtest::assert_fits;
use stickler_run::{CaseEvent, Event, Verdict};

/// Returns the page of a run.
fn page(events: &[Event]) -> String {
    let folder = tempfile::tempdir().expect("a temporary folder");
    sample::report(folder.path(), events);
    fs::read_to_string(folder.path().join("index.html")).expect("a page")
}

/// Returns the page of a run, written without the other reports, which texts of this size keep busy.
fn page_alone(events: &[Event]) -> String {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("index.html");
    write(&path, Statements::default(), events);
    fs::read_to_string(path).expect("a page")
}

/// Writes the page of a run to a file.
pub(super) fn write(path: &Path, statements: Statements, events: &[Event]) {
    let mut page = Page::create(path.to_owned(), statements).expect("a file");
    let mut groups = Groups::default();
    for event in events {
        let group = match event {
            Event::Case(case) => Some(groups.number(case).0),
            _ => None,
        };
        page.take(event, group);
    }
    page.finish(&sample::overview(events), &groups).expect("finished");
}

/// Returns the data of an element of the page.
pub(crate) fn data_of(page: &str, id: &str) -> Value {
    let start = format!("<script type=\"text/plain\" id=\"data-{id}\">");
    let (_, rest) = page.split_once(&start).expect("the element");
    let (text, _) = rest.split_once("</script>").expect("its end");
    serde_json::from_reader(GzDecoder::new(&*of_base64(text))).expect("JSON")
}

/// Returns the bytes of a text in Base64, behind which zeros may stand.
fn of_base64(text: &str) -> Vec<u8> {
    let digits = (0..64).map(|digit| base64(&[digit << 2]).as_bytes()[0]);
    let digits: Vec<u8> = digits.collect();
    let index = |byte: u8| digits.iter().position(|digit| *digit == byte).unwrap_or_default();
    let four = |four: &[u8]| four.iter().fold(0, |bits, byte| bits << 6 | index(*byte));
    let chunks = text.as_bytes().chunks(4);
    let bytes = chunks.flat_map(|chunk| [16, 8, 0].map(|shift| (four(chunk) >> shift) as u8));
    bytes.collect()
}

/// Returns the ids of the cases that the page lists, with their programs.
fn listed(page: &str) -> Vec<(String, String)> {
    let data = data_of(page, "cases");
    let number = |value: &Value| usize::try_from(value.as_u64().expect("a number")).expect("small");
    let word = |value: &Value| data["words"][number(value)].as_str().expect("a word").to_owned();
    let cases = &data["cases"];
    let of = |at: usize| {
        let group = &data["groups"]["id"][number(&cases["group"][at])];
        let id = word(group) + &word(&cases["arguments"][at]);
        let program = match &cases["program"][at] {
            Value::Null => String::new(),
            text => {
                let lines = data["texts"][number(text)].as_array().expect("lines");
                lines.iter().map(word).collect::<Vec<_>>().join("\n")
            }
        };
        (id, program)
    };
    (0..cases["group"].as_array().expect("a column").len())
        .map(of)
        .collect()
}

#[test]
fn every_case_that_did_not_pass_and_every_cause_is_in_the_page() {
    let cases = Verdict::ALL.map(|verdict| sample::case(&format!("a::p({verdict})"), verdict));
    let causes = [
        sample::cause("first", 7, Verdict::Fail),
        sample::cause("second", 3, Verdict::Differs),
    ];
    let events = sample::with_causes(sample::run_of(cases.to_vec()), causes);
    let page = page(&events);
    let ids: Vec<String> = listed(&page).into_iter().map(|(id, _)| id).collect();
    let expected = Verdict::ALL.iter().filter(|verdict| **verdict != Verdict::Pass);
    let expected: Vec<String> = expected
        .map(|verdict| format!("widening/a::p({verdict})"))
        .collect();
    assert_eq!(ids, expected);
    let run = data_of(&page, "run");
    let causes: Vec<(&str, bool, u64)> = run["causes"]
        .as_array()
        .expect("causes")
        .iter()
        .map(|cause| {
            let number = cause["number"].as_u64().expect("a number");
            (
                cause["title"].as_str().expect("a title"),
                cause["differs"] == true,
                number,
            )
        })
        .collect();
    assert_eq!(causes, [("first", false, 7), ("second", true, 3)]);
    let report = run["causes"][0]["report"].as_str().expect("a report");
    assert_fits(report, "…PROGRAM m END_PROGRAM…INT#-128…");
}

#[test]
fn a_program_that_ends_an_element_stays_text() {
    let evil = "PROGRAM m (* </script><img src=x onerror=alert(1)> <!-- *)\nEND_PROGRAM";
    let case = CaseEvent {
        program: Some(evil.to_owned()),
        title: "</title><script>alert(2)</script>".to_owned(),
        ..sample::case("a::p(1)", Verdict::Fail)
    };
    let page = page(&sample::run_of(vec![case]));
    assert!(!page.contains("<img") && !page.contains("alert(2)</script>"));
    assert_eq!(listed(&page), [("widening/a::p(1)".to_owned(), evil.to_owned())]);
    let elements = page.matches("<script").count();
    assert_eq!(elements, page.matches("</script>").count());
}

#[test]
fn the_page_loads_nothing_and_makes_no_markup_of_texts() {
    let (head, ..) = skeleton();
    assert!(head.contains("default-src 'none'"), "{head}");
    for part in SCRIPTS.into_iter().chain([STYLE]) {
        let markup = "</script|</style|innerHTML|outerHTML|insertAdjacentHTML";
        let loading = "eval(|import |fetch(|@import|url(|XMLHttpRequest";
        for word in markup.split('|').chain(loading.split('|')) {
            assert!(!part.contains(word), "{word}");
        }
    }
    let page = page(&sample::run());
    for attribute in ["src=", "<link", "<iframe", "<object"] {
        assert!(!page.contains(attribute), "{attribute}");
    }
}

#[test]
fn the_claims_of_the_page_are_those_of_the_other_reports() {
    let page = page(&sample::with_sources(sample::run()));
    let run = data_of(&page, "run");
    let claim = &run["claims"][0];
    assert_eq!(claim["section"], "Integer widening");
    assert_eq!(
        claim["address"],
        "https://example.org/Integer widening#integer-widening"
    );
    assert_eq!(claim["standings"][0]["passed"], 2);
    assert_eq!(claim["standings"][0]["failed"], 1);
}

#[test]
fn outputs_of_any_size_leave_a_page_that_can_be_opened() {
    let huge = |number: usize| CaseEvent {
        got: (0..60)
            .map(|line| sample::reported(line, "", &format!("{number} {}", "y".repeat(600))))
            .collect(),
        ..sample::case(&format!("a::p({number})"), Verdict::Fail)
    };
    let page = page_alone(&sample::run_of((0..200).map(huge).collect()));
    assert!(page.len() < 10 << 20, "{}", page.len());
    assert_eq!(listed(&page).len(), 200);
    assert!(data_of(&page, "cases")["texts_left_out"].as_u64() > Some(0));
}

#[test]
fn causes_for_which_the_page_has_no_room_are_counted() {
    let huge = "a".repeat(300_000);
    let causes = (0..20).map(|_| sample::cause(&huge, 7, Verdict::Fail));
    let events = sample::with_causes(sample::run(), causes);
    let page = page_alone(&events);
    assert!(page.len() < 10 << 20, "{}", page.len());
    let run = data_of(&page, "run");
    let shown = run["causes"].as_array().expect("causes").len();
    assert!((1..20).contains(&shown), "{shown}");
    assert_eq!(run["causes_left_out"], 20 - shown);
}

/// Returns the colours of a theme of the style sheet, by name.
fn colours(theme: &str) -> BTreeMap<&str, [f64; 3]> {
    let channel = |digits: &str| f64::from(u8::from_str_radix(digits, 16).expect("two digits")) / 255.0;
    let named = theme.split("--").filter_map(|entry| {
        let (name, rest) = entry.split_once(": #")?;
        Some((
            name,
            [channel(&rest[0..2]), channel(&rest[2..4]), channel(&rest[4..6])],
        ))
    });
    named.collect()
}

/// Returns the contrast of two colours. Basis: WCAG 2.1, relative luminance and contrast ratio.
fn contrast(one: [f64; 3], other: [f64; 3]) -> f64 {
    let luminance = |[red, green, blue]: [f64; 3]| {
        let linear = |channel: f64| match channel <= 0.03928 {
            true => channel / 12.92,
            false => ((channel + 0.055) / 1.055).powf(2.4),
        };
        0.2126 * linear(red) + 0.7152 * linear(green) + 0.0722 * linear(blue)
    };
    let (one, other) = (luminance(one), luminance(other));
    (one.max(other) + 0.05) / (one.min(other) + 0.05)
}

#[test]
fn every_text_stands_out_from_its_ground_in_both_themes() {
    let (light, dark) = STYLE
        .split_once("@media screen and (prefers-color-scheme: dark)")
        .expect("a dark theme");
    let (dark, _) = dark.split_once("}\n}").expect("its end");
    for theme in [colours(light), colours(dark)] {
        for line in include_str!("tests/grounds.txt").lines() {
            let (text, grounds) = line.split_once(": ").expect("a text and its grounds");
            for ground in grounds.split(' ') {
                let ratio = contrast(theme[text], theme[ground]);
                assert!(ratio >= 4.5, "{text} on {ground}: {ratio:.2}");
            }
        }
    }
}

#[test]
fn no_text_ends_the_element_and_all_texts_come_back() {
    let texts = ["</script><script>alert(1)</script>", "<!--", "a < b", "\"<\\"];
    let mut element = Vec::new();
    data(&mut element, "run", &texts).expect("written");
    let element = String::from_utf8(element).expect("text");
    assert_eq!(element.matches('<').count(), 2);
    assert_eq!(data_of(&element, "run"), serde_json::json!(texts));
}

/// Basis: RFC 4648, 10.
#[test]
fn bytes_in_base64_are_padded() {
    let texts = ["", "f", "fo", "foo", "foob", "fooba", "foobar"].map(|text| base64(text.as_bytes()));
    assert_eq!(
        texts,
        ["", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy"]
    );
}
