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
fn elements_are_found_in_every_form_of_a_line() {
    let expected = [vec![(0, 1_398_033_201), (1, -5), (2, 0)]];
    for text in [
        // Watch lists of CODESYS and TwinCAT: expression, type, value, prepared value, address, comment.
        "Expression\tType\tValue\tPrepared value\tAddress\tComment\nstickler_page_1.results\tARRAY [0..2] OF DINT\t\t\t\t\n\
         stickler_page_1.results[0]\tDINT\t1398033201\t\t\twhat to copy\nstickler_page_1.results[1]\tDINT\t-5\t\t\t\n\
         stickler_page_1.results[2]\tDINT\t0\t\t%MD4\t\n",
        // The view of a data block in TIA, where an offset and a start value stand before the value.
        "Name\tData type\tOffset\tStart value\tMonitor value\tRetain\nresults\tArray[0..2] of DInt\t0.0\t\t\tFalse\n\
         results[0]\tDInt\t0.0\t0\t1398033201\tFalse\nresults[1]\tDInt\t4.0\t0\t-5\tFalse\nresults[2]\tDInt\t8.0\t0\t0\tFalse\n",
        "\"DB\".results[0]\t\tDEC+/-\t1398033201\n\"DB\".results[1]\t\tDEC+/-\t-5\n\"DB\".results[2]\t\tDEC+/-\t0\n",
        "[0] 1398033201\n[1] -5\n[2] 0",
        "results[0] := 1398033201;\r\nresults[1] := -5;\r\nresults[2] := 0;\r\n",
        "results[0] = 1398033201; results[1] = -5; results[2] = 0",
        "results[2] = 16#0\nresults[1]: 16#FFFF_FFFB\nresults[0]:16#5354_4B31\n",
        "\"results[0]\",\"DINT\",\"1398033201\"\n\"results[1]\",\"DINT\",\"-5\"\n\"results[2]\",\"DINT\",\"0\"\n",
        "results[0];DINT;1.398.033.201\nresults[1];DINT;-5\nresults[2];DINT;0\n",
        "   results[0]   DINT   1398033201\n   results[1]   DINT   -5\n   results[2]   DINT   0\n",
        "line[3].results[0]\t1 398 033 201\nline[3].results[1]\t-5,0\nline[3].results[2]\tFALSE\nline[3].other[0]\t77\n",
        "\u{feff}[0]\t1,398,033,201\r[1]\t\u{2212}5\r[2]\t0\r",
    ] {
        assert_eq!(arrays(text), expected, "{text}");
    }
}

#[test]
fn lists_are_read_whatever_keeps_their_numbers_apart() {
    let expected = [vec![(0, MAGIC), (1, 20_000), (2, 0), (3, 0)]];
    for text in [
        "1398033201\n20000\n0\n0\n",
        "1398033201, 20000, 0, 0",
        "[1398033201, 20000, 2(0)]",
        "results := [1398033201, 20000, 2(0)];".trim_start_matches("results := "),
        "1398033201 20000 0 0",
        "1398033201;20000;0;0",
        "1.398.033.201\n20.000\n0\n0",
        "0\t1398033201\n1\t20000\n2\t0\n3\t0\n",
        "a remark\n16#53544B31\t16#4E20\nFALSE\t0\n",
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
