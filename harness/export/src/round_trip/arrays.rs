//! Tests the import of correct arrays, and of arrays with errors.

use super::*;
use stickler_mdtest::assert_fits;

#[test]
fn what_the_reference_computes_is_judged_as_it_must_be_in_every_dialect_and_form() {
    let cases = cases(&FILES);
    let mut judged = 0;
    for dialect in DialectName::ALL {
        let exported = ExportFolder::of(&plan(dialect), &cases);
        assert_ne!(exported.cases, 0, "{dialect}");
        judged += exported.cases;
        for form in [list, watch_list, table, numbers] {
            let text: String = exported.arrays.iter().map(|array| form(array)).collect();
            let (imported, events, whole) = exported.import(&text);
            assert_eq!(imported.notes, [] as [&str; 0], "{dialect}");
            let failed = odd(&events);
            assert!(failed.is_empty(), "{dialect}: {failed:?}");
            assert!(whole);
            assert_eq!(
                (events.len(), imported.summary.cancelled),
                (exported.cases, false)
            );
        }
    }
    let dialects = DialectName::ALL.len();
    assert!(judged > 40 * dialects, "{judged} in {dialects} dialects");
}

fn few() -> ExportFolder {
    let files = ["widening/integer.toml", "conversion/real-to-integer-edges.toml"];
    ExportFolder::of(
        &ExportPlan {
            sample: Some(24),
            ..plan(DialectName::IRONPLC_ED3)
        },
        &cases(&files),
    )
}

#[test]
fn one_other_value_fails_exactly_its_case_with_what_came() {
    let mut exported = few();
    // The numbers of the third observation of the second page, and what its comparison told.
    let manifest = exported.manifest();
    let (page, step) = (&manifest.pages[1], manifest.pages[1].steps[2]);
    let array = &mut exported.arrays[1];
    assert_eq!(array[step.place + 1], 1);
    array[step.place + 1] = 2;
    let last = manifest.pages[1].steps[3].place - 1;
    array[last] ^= 1;
    let (_, events, whole) = exported.import(&exported.text());
    assert!(whole);
    let failed = odd(&events);
    assert_eq!(failed.len(), 1, "{failed:?}");
    assert_eq!(
        (failed[0].verdict, &failed[0].id),
        (Verdict::Fail, &page.cases[step.case].id)
    );
    assert_ne!(failed[0].expected, failed[0].got);
    // A comparison that contradicts the numbers is neither a pass nor a failure.
    exported.arrays[1][step.place + 1] = 1;
    let (_, events, _) = exported.import(&exported.text());
    let odd = odd(&events);
    assert_eq!((odd.len(), odd[0].verdict), (1, Verdict::Error));
    let got = Fact::text(&odd[0].got);
    assert!(got.contains("own comparison"), "{got}");
}

#[test]
fn what_is_no_array_of_this_export_passes_nothing() {
    let exported = few();
    let zeros: String = exported
        .arrays
        .iter()
        .map(|array| list(&vec![0; array.len()]))
        .collect();
    assert_fits(
        &exported.notes_without_verdicts(&zeros),
        "…nothing but zeros: its page did not run…",
    );
    let mut other = exported.arrays[0].clone();
    for value in &mut other {
        *value = if *value / 1000 * 1000 == exported.arrays[0][1] {
            *value + 1000
        } else {
            *value
        };
    }
    let notes = exported.notes_without_verdicts(&list(&other));
    assert_fits(
        &notes,
        "…copied.txt:1: the array is that of page 1 of another export…",
    );
    let notes = exported.notes_without_verdicts("results[0] := 5;\nresults[1] := 7;\n");
    assert!(notes.contains("results[0] is 5"), "{notes}");
    // The view of a data block in TIA without the row above it: the first number is an offset.
    let offsets = |heading: &str| {
        let rows = exported.arrays[0].iter().enumerate();
        let rows =
            rows.map(|(index, value)| format!("results[{index}]\tDInt\t{}.0\t0\t{value}\n", index * 4));
        heading.to_owned() + &rows.collect::<String>()
    };
    let notes = exported.notes_without_verdicts(&offsets(""));
    assert!(notes.contains("copy the headings of the columns, too"), "{notes}");
    let whole = offsets("Name\tData type\tOffset\tStart value\tMonitor value\n");
    assert_eq!(odd(&exported.import(&whole).1).len(), 0);
    assert!(!exported.import(&whole).1.is_empty());
    let notes = exported.notes_without_verdicts("nothing to see\n");
    assert!(notes.contains("there is no number in it"), "{notes}");
    let notes = exported.notes_without_verdicts(
        &list(&exported.arrays[0])
            .replace(":=", "???")
            .replace(|c: char| c.is_ascii_digit(), "x"),
    );
    assert!(notes.contains("there is no number in it"), "{notes}");
}

#[test]
fn what_was_cut_off_or_not_reached_is_not_judged_and_said() {
    let exported = few();
    let array = &exported.arrays[0];
    let half = list(&array[..array.len() / 2]);
    let (imported, events, whole) = exported.import(&half);
    assert!(!whole && imported.unjudged > 0 && !events.is_empty());
    assert!(events.iter().all(|case| case.verdict == Verdict::Pass));
    let notes = imported.notes.join("\n");
    assert!(notes.contains("elements are missing between"), "{notes}");
    assert_fits(&notes, "…page 2: no results were given; 8 cases are not judged…");
    // The same array in two pieces is complete, in either order.
    let pieces = format!("{}{}", list(array), list(&exported.arrays[1]));
    assert!(exported.import(&pieces).2);
    // An array that was copied too soon is incomplete.
    let manifest = exported.manifest();
    let mut early = array.clone();
    let step = manifest.pages[0].steps[5];
    early[4] = 6;
    early[5] = 5;
    early[step.place..].fill(0);
    let (imported, events, whole) = exported.import(&list(&early));
    assert_eq!((whole, events.len()), (false, 5));
    let notes = imported.notes.join("\n");
    let culprit = &manifest.pages[0].cases[step.case].id;
    assert!(notes.contains(&format!("5 of 16 observations were made, and it is within the next; if it goes no further, note `crashed {culprit}`")), "{notes}");
}

#[test]
fn what_a_person_deleted_from_a_page_is_judged_by_the_answer_alone() {
    let mut exported = few();
    let manifest = exported.manifest();
    let step = manifest.pages[0].steps[3];
    let next = manifest.pages[0].steps[4];
    exported.arrays[0][step.place..next.place].fill(0);
    let id = &manifest.pages[0].cases[step.case].id;
    let (imported, _, whole) = exported.import(&exported.text());
    assert!(!whole);
    assert!(
        imported.notes[0].contains(&format!(
            "1 case is not run: {id}; if the compiler does not accept it"
        )),
        "{:?}",
        imported.notes
    );
    for (word, verdict) in [
        ("rejected", Verdict::Fail),
        ("crashed", Verdict::Crash),
        ("accepted", Verdict::Unsupported),
    ] {
        exported.answer(&format!("{word} {id}\n"));
        let (imported, events, whole) = exported.import(&exported.text());
        assert!(whole, "{:?}", imported.notes);
        let odd = odd(&events);
        assert_eq!((odd.len(), &odd[0].id, odd[0].verdict), (1, id, verdict));
    }
    // An answer about a case that ran is ignored, and so is one about an unknown case.
    let other = &manifest.pages[0].cases[0].id;
    exported.answer(&format!("rejected {id}\nrejected {other}\nrejected x/y\n"));
    let notes = exported.import(&exported.text()).0.notes.join("\n");
    assert!(
        notes.contains(&format!("{other} has results, which count")) && notes.contains("x/y is on no page"),
        "{notes}"
    );
}
