//! Tests the parsing of pasted texts in all known forms.

use super::*;
use crate::page::MAGIC;
use stickler_mdtest::check_examples;
use stickler_types::join;

fn read_bytes(bytes: &[u8]) -> Pasted {
    read(&decoded(bytes))
}

fn arrays(text: &str) -> Vec<Vec<(usize, i32)>> {
    let pasted = read_bytes(text.as_bytes());
    assert_eq!(pasted.complaints, [], "{text}");
    pasted
        .arrays
        .iter()
        .map(|array| {
            array
                .elements
                .iter()
                .map(|(index, value)| (*index, *value))
                .collect()
        })
        .collect()
}

#[test]
fn elements_are_found_in_every_form() {
    for section in include_str!("forms.md").split("\n## ").skip(1) {
        let (heading, blocks) = section.split_once('\n').expect("a heading");
        let (_, expected) = heading.split_once(": ").expect("elements");
        let shown = |(index, value): &(usize, i32)| format!("{index} = {value}");
        for text in blocks.split("```text\n").skip(1) {
            let (text, _) = text.split_once("```").expect("an end");
            let [array] = &arrays(text)[..] else {
                panic!("{text}")
            };
            assert_eq!(join(array.iter().map(shown), ", "), expected, "{text}");
        }
    }
}

#[test]
fn line_ends_and_marks_of_any_system_are_passed_over() {
    let expected = [vec![(0, MAGIC), (1, -5), (2, 0)]];
    for text in [
        "results[0] := 1398033201;\r\nresults[1] := -5;\r\nresults[2] := 0;\r\n",
        "\u{feff}[0]\t1,398,033,201\r[1]\t\u{2212}5\r[2]\t0\r",
    ] {
        assert_eq!(arrays(text), expected, "{text}");
    }
}

#[test]
fn golden_pasted_texts() {
    check_examples("tests/pasted.md", |example| {
        let pasted = read_bytes(example.text("text").as_bytes());
        let told = match example.wanted() {
            "arrays" => {
                let shown = |array: &Array| format!("{:?}", array.elements);
                pasted.arrays.iter().map(shown).collect::<Vec<_>>()
            }
            _ => {
                let complaints = pasted.complaints.into_iter();
                let shown = |told: Complaint| format!("{}:{}: {}", told.line, told.column, told.what);
                complaints.map(shown).collect()
            }
        };
        told.join("\n")
    });
}

#[test]
fn texts_of_other_systems_are_read() {
    let text = "results[0]\tDINT\t7\r\n";
    let expected = read_bytes(text.as_bytes()).arrays;
    for bytes_of in [u16::to_le_bytes, u16::to_be_bytes] {
        for mark in ["\u{feff}", ""] {
            let units = format!("{mark}{text}");
            let bytes: Vec<u8> = units.encode_utf16().flat_map(bytes_of).collect();
            assert_eq!(read_bytes(&bytes).arrays, expected);
        }
    }
    // The blank is a no-break space in Latin-1.
    assert_eq!(read_bytes(b"[0] 1\xA0398").arrays[0].elements[&0], 1398);
    assert_eq!(read_bytes(b"").arrays, []);
    assert_eq!(
        read_bytes(b"\x1b[36m[0]\x1b[0m \x1b[1m7\x1b[0m").arrays[0].elements[&0],
        7
    );
}
