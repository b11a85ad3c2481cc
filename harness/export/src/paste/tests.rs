//! Tests the parsing of pasted texts in all known forms.

use super::*;
use crate::page::MAGIC;

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

fn complaints(text: &str) -> Vec<(usize, usize, String)> {
    let complaints = read_bytes(text.as_bytes()).complaints;
    complaints
        .into_iter()
        .map(|reported| (reported.line, reported.column, reported.what))
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
            assert_eq!(
                array.iter().map(shown).collect::<Vec<_>>().join(", "),
                expected,
                "{text}"
            );
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
fn an_element_that_comes_again_begins_another_array_and_so_does_the_first_number_of_a_list() {
    assert_eq!(
        arrays("[0] 1\n[1] 2\n[0] 3\n"),
        [vec![(0, 1), (1, 2)], vec![(0, 3)]]
    );
    let list = format!("{MAGIC} 20000 7 {MAGIC} 30000 8");
    let expected = [
        vec![(0, MAGIC), (1, 20_000), (2, 7)],
        vec![(0, MAGIC), (1, 30_000), (2, 8)],
    ];
    assert_eq!(arrays(&list), expected);
}

#[test]
fn what_cannot_be_read_is_told_with_its_line_and_column() {
    assert_eq!(
        complaints("[0]\tDINT\t5\nresults[1]\tDINT\t???\nresults[2]\tDINT\t\t\nresults[3]\tLREAL\t1.5E3\n"),
        [
            (
                2,
                17,
                "results[1] has no value that can be read: `???`".to_owned()
            ),
            (
                3,
                12,
                "results[2] has no value that can be read: `DINT`".to_owned()
            ),
            (
                4,
                18,
                "results[3] is `1.5E3`, which is no whole number of 32 bits".to_owned()
            ),
        ]
    );
    assert_eq!(
        complaints("1398033201, 20000, INVALID, 4"),
        [(1, 20, "`INVALID` is no whole number of 32 bits".to_owned())]
    );
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
