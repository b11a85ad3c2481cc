//! Tests the way of an editor-bound compiler's answers: questions, answers, a recording, and cases whose basis it is.

use crate::dialects;
use crate::export::{exported_questions, run};
use std::fs;
use std::path::Path;

/// A dialect that does what CODESYS does, but takes an INT for a UINT without a warning.
const MINE: &str = "[dialects.mine]\nextends = \"codesys\"\nabout = \"MyPLC 2.1\"\nsource = \"https://example.org/myplc\"\n\
                    [dialects.mine.implicit]\n\"INT.UINT\" = \"yes\"\n";

/// The path of the recording below the folder of the test.
const RECORDING: &str = "conformance-cases/recordings/my-plc.toml";

/// Exports the questions whose names contain `filter`, lets the reference answer in place of the compiler, and records what it answers.
fn record(folder: &Path, filter: &str, pages: &str, answered: fn(&Path, &str) -> String) {
    exported_questions(folder, "mine", filter, pages);
    let answers = format!("{pages}.txt");
    fs::write(
        folder.join(&answers),
        answered(folder, &format!("{pages}/page-001.st")),
    )
    .expect("written");
    let (code, shown, notes) = run(
        folder,
        &[
            "import",
            &answers,
            "--export",
            pages,
            "--no-report",
            "--record",
            RECORDING,
            "--product",
            "MyPLC",
            "--product-version",
            "2.1",
            "--platform",
            "a simulation",
            "--date",
            "2026-11-25",
        ],
    );
    assert_eq!(code, Some(0), "{shown}{notes}");
    assert!(shown.contains(" answers of MyPLC 2.1"), "{shown}");
}

#[test]
fn answers_of_an_editor_become_cases_of_a_dialect_that_overrides_a_warning() {
    let folder = dialects::folder(MINE);
    let folder = folder.path();
    fs::create_dir_all(folder.join(RECORDING).parent().expect("a parent")).expect("a folder");
    record(folder, "implicit(INT", "messages", |folder, page| {
        let (_, shown, notes) = run(folder, &["check", page, "--dialect", "mine"]);
        shown + &notes
    });
    record(folder, "REAL_TO_INT(REAL", "values", |folder, page| {
        run(folder, &["eval", page, "--dialect", "mine", "--scans", "100"]).1
    });

    let promote = ["promote", RECORDING, "--dialect", "mine"];
    let (code, shown, notes) = run(folder, &promote);
    assert_eq!(code, Some(0), "{shown}{notes}");
    assert!(
        shown.contains("widening/my-plc.toml  27 cases")
            && shown.contains("conversion/my-plc.toml  20 cases"),
        "{shown}"
    );
    let (code, _, notes) = run(folder, &promote);
    assert_eq!(code, Some(2));
    assert!(notes.contains("is there already"), "{notes}");
    let (_, shown, notes) = run(folder, &["lint"]);
    assert!(!(shown.clone() + &notes).contains("my-plc"), "{shown}{notes}");

    let of_the_recording = || {
        run(
            folder,
            &["run", "--dialect", "mine", "--filter", "/my-plc::", "--no-report"],
        )
    };
    let (code, shown, notes) = of_the_recording();
    assert_eq!(code, Some(0), "{shown}{notes}");
    assert!(
        shown.contains("47 cases") && shown.contains("recording      47"),
        "{shown}"
    );
    let (_, shown, _) = run(
        folder,
        &[
            "show",
            "conversion/my-plc::gives(REAL_TO_INT~28REAL#2.5~29_:_INT)",
        ],
    );
    assert!(
        shown.contains("recording: my-plc") && shown.contains("given1 = INT#3"),
        "{shown}"
    );

    // A case is held to what was recorded, and a recording that does not say of what it is speaks for nobody.
    let table = folder.join("conformance-cases/conversion/my-plc.toml");
    let text = fs::read_to_string(&table).expect("a table");
    fs::write(&table, text.replace("\"INT#3\"", "\"INT#2\"")).expect("written");
    let (code, shown, _) = of_the_recording();
    assert_eq!(code, Some(1), "{shown}");
    let recording = fs::read_to_string(folder.join(RECORDING)).expect("a recording");
    for (key, said) in [
        ("product", "missing field `product`"),
        ("version", "missing field `version`"),
    ] {
        let lacking = recording.replacen(&format!("{key} = "), &format!("# {key} = "), 1);
        fs::write(folder.join(RECORDING), lacking).expect("written");
        let (code, shown, notes) = of_the_recording();
        assert_eq!(code, Some(2), "{shown}{notes}");
        assert!(
            notes.contains("no case can cite the recording `my-plc`") && notes.contains(said),
            "{notes}"
        );
        let (code, _, notes) = run(folder, &["promote", RECORDING, "--name", "again"]);
        assert_eq!(code, Some(2));
        assert!(notes.contains(said), "{notes}");
    }
}

#[test]
fn a_recording_elsewhere_or_in_another_dialect_is_not_promoted() {
    let folder = dialects::folder(MINE);
    let folder = folder.path();
    let text = "[recording]\nproduct = \"MyPLC\"\nversion = \"2.1\"\nplatform = \"p\"\ndate = \"2026-11-25\"\n\
                [[answers]]\ndialects = [\"matiec\", \"codesys\"]\n[answers.implicit]\nINT = { accepts = \"INT\" }\n";
    fs::write(folder.join("elsewhere.toml"), text).expect("written");
    fs::create_dir_all(folder.join(RECORDING).parent().expect("a parent")).expect("a folder");
    fs::write(folder.join(RECORDING), text).expect("written");
    for (arguments, said) in [
        (&["promote", "elsewhere.toml"][..], "move elsewhere.toml to "),
        (
            &["promote", RECORDING],
            "answers in matiec, codesys; name one with --dialect",
        ),
        (
            &["promote", RECORDING, "--dialect", "omron"],
            "no answers in omron, only in matiec, codesys",
        ),
        (
            &["promote", RECORDING, "--dialect", "codesys", "--name", "../x"],
            "is no name for a case",
        ),
    ] {
        let (code, _, notes) = run(folder, arguments);
        assert_eq!(code, Some(2), "{notes}");
        assert!(notes.contains(said), "{notes}");
    }
}

#[test]
fn a_section_is_asked_again_of_the_same_compiler_only() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let record = |more: &[&str]| {
        let bits = [
            "record",
            "--engine",
            "reference",
            "--dialect",
            "matiec",
            "--only",
            "bits",
            "-o",
            "mine.toml",
        ];
        run(folder, &[&bits, more].concat())
    };
    let (code, _, notes) = record(&["--commit", "abc"]);
    assert_eq!(code, Some(0), "{notes}");
    for (more, said) in [
        (
            &["--commit", "abd"][..],
            "was recorded of commit abc, and this is abd",
        ),
        (&[], "was recorded of commit abc, and this is none that is named"),
        (
            &["--commit", "abc", "--product", "Mine"],
            "say with --product and --product-version what it says",
        ),
    ] {
        let (code, _, notes) = record(more);
        assert_eq!(code, Some(2), "{notes}");
        assert!(notes.contains(said), "{notes}");
    }
    let (code, _, notes) = record(&["--commit", "abc"]);
    assert_eq!(code, Some(0), "{notes}");
}

#[test]
fn a_promotion_that_fails_leaves_no_table_and_options_without_effect_are_refused() {
    let folder = dialects::folder(MINE);
    let folder = folder.path();
    let cases = folder.join("conformance-cases");
    let text = "[recording]\nproduct = \"MyPLC\"\nversion = \"2.1\"\nplatform = \"p\"\ndate = \"2026-11-25\"\n\
                [[answers]]\ndialects = [\"codesys\"]\n[answers.implicit]\nINT = { accepts = \"DINT\" }\n\
                [answers.bits]\nBYTE = { accepts = \"0\" }\n";
    fs::create_dir_all(cases.join("recordings")).expect("a folder");
    fs::write(folder.join(RECORDING), text).expect("written");
    fs::create_dir_all(folder.join("a-finding")).expect("a folder");
    for (arguments, said) in [
        (
            &["promote", RECORDING, "--title", "A title"][..],
            "--basis and --title are for a finding",
        ),
        (
            &["promote", RECORDING, "--basis", "iec-61131-3: 6.3"],
            "--basis and --title are for a finding",
        ),
        (
            &["promote", "a-finding", "--dialect", "codesys"],
            "--dialect is for a recording",
        ),
    ] {
        let (code, _, notes) = run(folder, arguments);
        assert_eq!(code, Some(2));
        assert!(notes.contains(said), "{notes}");
    }
    fs::write(cases.join("bit-access"), "in the way").expect("a file");
    let (code, _, notes) = run(folder, &["promote", RECORDING]);
    assert_eq!(code, Some(2));
    assert!(notes.contains("cannot write "), "{notes}");
    assert!(
        !cases.join("widening/my-plc.toml").exists(),
        "the first table is taken back"
    );
    fs::remove_file(cases.join("bit-access")).expect("a file");
    let (code, shown, notes) = run(folder, &["promote", RECORDING]);
    assert_eq!(code, Some(0), "{notes}");
    assert!(shown.contains("widening/my-plc.toml  1 case\n"), "{shown}");
}
