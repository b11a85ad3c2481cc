//! Tests of the page in a browser: its parts are opened by their addresses, and what the scripts built is read.
//!
//! The tests need a Chromium: the one that `STICKLER_CHROMIUM` names, or `chromium`, `chromium-browser` or `google-chrome` on the
//! path. Where there is none, each test says so and checks nothing. The browser prints the document and ends, so no driver is needed: every part of the page has
//! an address, which is what a click leads to. `keyboard_tests` presses keys.

use super::tests;
use crate::sample;
use std::env;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Arc;
use stickler_conversions::overview::{CaseProgram, CaseStatement, Statements, StatementsBuilder};
use stickler_conversions::recording::Recording;
use stickler_run::{CaseEvent, Event, SourceHeader, Verdict};
use stickler_types::{DialectName, ElementaryType, MatrixWord, Value};

/// The variable that names a browser.
const VARIABLE: &str = "STICKLER_CHROMIUM";

/// The names under which the browser is installed.
const NAMES: [&str; 3] = ["chromium", "chromium-browser", "google-chrome"];

/// Options with which the browser needs neither a screen nor the network, and prints what a script complains about.
pub(super) const OPTIONS: [&str; 10] = [
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--host-resolver-rules=MAP * ~NOTFOUND",
    "--enable-logging=stderr",
];

/// Options with which it ends as soon as the page is built.
const ENDING: [&str; 2] = ["--timeout=60000", "--virtual-time-budget=5000"];

/// Returns a browser; prints why the tests are skipped where there is none.
pub(crate) fn browser() -> Option<PathBuf> {
    let named = env::var_os(VARIABLE).map(PathBuf::from);
    let paths = env::var_os("PATH").unwrap_or_default();
    let installed = || {
        let files = env::split_paths(&paths).flat_map(|folder| NAMES.map(|name| folder.join(name)));
        files.into_iter().find(|file| file.is_file())
    };
    let found = named.or_else(installed);
    if found.is_none() {
        // Not `eprintln`, which nobody sees when the test passes.
        let _ = writeln!(
            std::io::stderr(),
            "skipped: no Chromium is installed to open index.html with; {VARIABLE} names one"
        );
    }
    found
}

/// Runs the browser on an address of the page; returns what it prints. Fails where a script complains.
pub(crate) fn open(browser: &Path, page: &Path, address: &str, option: &str) -> String {
    let profile = tempfile::tempdir().expect("a temporary folder");
    let output = Command::new(browser)
        .args(OPTIONS)
        .args(ENDING)
        .arg(format!("--user-data-dir={}", profile.path().display()))
        .arg(option)
        .arg(format!("file://{}{address}", page.display()))
        .output()
        .expect("a browser that starts");
    let complaints = String::from_utf8_lossy(&output.stderr);
    let complaints: Vec<&str> = complaints
        .lines()
        .filter(|line| line.contains("CONSOLE"))
        .collect();
    assert!(complaints.is_empty(), "{address}: {complaints:?}");
    assert!(output.status.success(), "{address}: {}", output.status);
    String::from_utf8(output.stdout).expect("a document in UTF-8")
}

const CALL: &str = "PROGRAM main\nVAR\n    data : REAL := 2.25;\n    into : INT;\nEND_VAR\n    into := REAL_TO_INT(data);\nEND_PROGRAM\n";

fn statements() -> Statements {
    let mut builder = StatementsBuilder::new(vec![
        DialectName::IRONPLC_ED2,
        DialectName::PLCNEXT,
        DialectName::STRUCPP,
        DialectName::CODESYS,
    ]);
    let statement = |case: &'static str| (Arc::<str>::from(case), MatrixWord::No);
    let (pair, word) = statement("widening/w::assignment(INT,SINT,1)");
    let implicit = CaseStatement {
        dialect: DialectName::IRONPLC_ED2,
        word,
        basis: "ironplc-type-conversions: Integer widening",
        case: &pair,
    };
    builder.add_implicit(ElementaryType::Int, ElementaryType::Sint, &implicit);
    for (to, case) in [
        (ElementaryType::Usint, "widening/w::assignment(INT,USINT,1)"),
        (ElementaryType::Uint, "widening/w::assignment(INT,UINT,1)"),
    ] {
        let statement = CaseStatement {
            word: MatrixWord::Warn,
            case: &Arc::from(case),
            ..implicit
        };
        builder.add_implicit(ElementaryType::Int, to, &statement);
    }
    let (bit, word) = statement("widening/b::write(BYTE,8)");
    builder.add_part(
        ElementaryType::Byte,
        "8",
        &CaseStatement {
            word,
            case: &bit,
            ..implicit
        },
    );
    let call = CaseProgram {
        case: &Arc::from("widening/c::variable(REAL,INT,2.25)"),
        dialect: DialectName::IRONPLC_ED2,
        source: CALL,
        result: None,
        basis: &Arc::from("ironplc-conversion-functions: Real to Integer"),
    };
    builder.add_program(&call);
    builder.add_program(&CaseProgram {
        case: &Arc::from("widening/c::variable(REAL,INT,2.375)"),
        dialect: DialectName::PLCNEXT,
        source: &CALL.replace("2.25", "2.375"),
        result: Some(&Value::parse("INT#7").expect("a literal")),
        basis: &Arc::from("builds: 2026"),
    });
    let call = CALL.replace("REAL", "LREAL").replace("INT", "DINT");
    builder.add_program(&CaseProgram {
        case: &Arc::from("widening/c::variable(LREAL,DINT,-3.0E9)"),
        dialect: DialectName::CODESYS,
        source: &call.replace("2.25", "-3.0E9"),
        result: Some(&Value::parse("DINT#-2147483648").expect("a literal")),
        basis: &Arc::from("builds: 2026"),
    });
    builder.finish(&RECORDINGS.map(|(file, text)| Recording::parse(file, text).expect("a recording")))
}

/// A recorded compiler that is no engine of the run, and one that is, by the name of its file.
const RECORDINGS: [(&str, &str); 2] = [
    (
        "strucpp.toml",
        "[recording]\nproduct = \"STruC++\"\nversion = \"0.6.1\"\nplatform = \"linux\"\ndate = \"2026-11-24\"\n\
         [[answers]]\ndialects = [\"ironplc-ed2\"]\n\
         [answers.implicit]\nINT = { accepts = \"SINT USINT\", rejects = \"UINT\" }\n\
         [answers.bits]\nBYTE = { accepts = \"8\" }\n\
         [answers.comparisons]\nINT = { false = \"USINT\" }\nUSINT = { rejected = \"INT\" }\n\
         [answers.functions]\n\"REAL_TO_INT(REAL) : INT\" = [[\"2.5\", \"7\"], [\"2.25\", \"crashed\"]]\n",
    ),
    (
        "reference.toml",
        "[recording]\nproduct = \"An older reference\"\nversion = \"0.0.1\"\nplatform = \"linux\"\ndate = \"2026-11-24\"\n\
         [[answers]]\ndialects = [\"ironplc-ed2\"]\n[answers.implicit]\nINT = { accepts = \"SINT\" }\n",
    ),
];

/// Writes the page of a run with an engine that fails in each part.
pub(super) fn write(folder: &Path) -> PathBuf {
    let path = folder.join("index.html");
    let failed = |id: &str, program: &str, got| CaseEvent {
        got: vec![got],
        program: Some(program.to_owned()),
        ..sample::case(id, Verdict::Fail)
    };
    let evil = "PROGRAM evil (* </script><img src=x> *) END_PROGRAM";
    let mut events = sample::with_sources(sample::run_of(vec![
        failed(
            "w::assignment(INT,SINT,1)",
            "PROGRAM w END_PROGRAM",
            stickler_run::Fact::Accepted,
        ),
        failed("c::variable(REAL,INT,2.25)", CALL, sample::value("into", "INT#3")),
        CaseEvent {
            expected: vec![stickler_run::Fact::Accepted, sample::warning(6, "C0195")],
            ..failed(
                "w::assignment(INT,USINT,1)",
                "PROGRAM w END_PROGRAM",
                stickler_run::Fact::Accepted,
            )
        },
        sample::case("w::assignment(INT,UINT,1)", Verdict::Pass),
        failed(
            "evil::p(1)",
            evil,
            sample::reported(3, "P4035", "no <b>bold</b> value \u{fffd}\u{1b}[31m"),
        ),
        sample::case("b::write(BYTE,8)", Verdict::Pass),
    ]));
    let header = sample::header(&mut events);
    header.engines[0].dialects = ["ironplc-ed2", "ironplc-ed2+partial-access"]
        .map(String::from)
        .to_vec();
    header.sources.push(SourceHeader {
        key: "builds".to_owned(),
        kind: "recording".to_owned(),
        ..header.sources[0].clone()
    });
    let footer = events.pop().expect("a footer");
    events.push(Event::Cause(sample::cause(
        "`into := data` gives 3",
        7,
        Verdict::Fail,
    )));
    events.push(footer);
    tests::write(&path, statements(), &events);
    path
}

/// Asserts that every field of a document has a label, which a screen reader reads.
fn assert_labelled(document: &str) {
    for field in ["<select", "<input"] {
        for (at, _) in document.match_indices(field) {
            let before = &document[..at];
            assert!(
                before.rfind("<label") > before.rfind("</label>"),
                "{}",
                &document[at..at + 60]
            );
        }
    }
}

#[test]
fn every_part_of_the_page_opens_by_its_address() {
    let Some(browser) = browser() else { return };
    let folder = tempfile::tempdir().expect("a temporary folder");
    let page = write(folder.path());
    let dom = |address: &str| {
        let document = open(&browser, &page, address, "--dump-dom");
        // The data and the scripts are no part of what is seen.
        let (seen, _) = document.split_once("<script type").expect("a document");
        assert_labelled(seen);
        seen.to_owned()
    };

    let first = dom("");
    assert!(first.contains("What does a conversion do?"), "{first}");
    assert!(first.contains(">ironplc-ed2, 1 variant<"), "{first}");
    assert!(
        first.contains("REAL_TO_INT(REAL) : INT") && first.contains("4 fail"),
        "{first}"
    );

    let found = dom("#REAL_TO_INT?value=2.25");
    let (_, row) = found
        .split_once("class=\"wanted\"")
        .expect("the row of the value");
    let (row, _) = row.split_once("</tr>").expect("its end");
    assert!(
        row.contains("2.25") && row.contains("✗ 3") && row.contains("#case?"),
        "{row}"
    );

    let matrix = dom("#matrix");
    let cell = "#convert?from=INT&amp;to=SINT";
    assert!(
        matrix.contains(cell) && matrix.contains("reference: yes"),
        "{matrix}"
    );
    let pair = dom(&cell.replace("&amp;", "&"));
    assert!(
        pair.contains("Does INT become SINT without a function?") && pair.contains("✗ yes"),
        "{pair}"
    );
    assert!(
        pair.contains("No case asks in plcnext, strucpp, codesys."),
        "{pair}"
    );

    for (label, cell) in [
        (
            "INT to USINT: yes, with a warning; reference: yes, no warning; STruC++ 0.6.1: yes, no warning",
            "!<b>≠R✓</b><b>≠S✓</b></a>",
        ),
        (
            "INT to UINT: yes, with a warning; STruC++ 0.6.1: no",
            "!<b>≠S✕</b></a>",
        ),
    ] {
        let (_, named) = matrix
            .split_once(&format!("aria-label=\"{label} ("))
            .expect("a labelled cell");
        let (_, inside) = named.split_once('>').expect("its inside");
        assert!(inside.starts_with(cell), "{label}: {inside}");
    }
    let warned = dom("#convert?from=INT&to=USINT");
    assert!(
        warned.contains("! yes, with a warning</span>") && warned.contains("✗ yes, no warning"),
        "{warned}"
    );
    assert!(dom("#cases").contains("<option value=\"C0195\">"));
    let coded = dom("#cases?code=C0195");
    assert!(coded.contains("1 of 4 cases"), "{coded}");

    let bits = dom("#bits?type=BYTE");
    assert!(
        bits.contains("BYTE has bits 0 to 7") && bits.contains("BYTE: variable.8 in ironplc-ed2: no"),
        "{bits}"
    );

    let claims = dom("#claims?source=ironplc-type-conversions");
    assert!(
        claims.contains("href=\"https://example.org/Integer widening#integer-widening\""),
        "{claims}"
    );

    let cases = dom("#cases?verdict=fail&code=P4035&q=evil");
    assert!(
        cases.contains("1 of 4 cases") && cases.contains("widening/evil::p(1)@ironplc-ed2"),
        "{cases}"
    );
    let case = dom("#case?engine=reference&dialect=ironplc-ed2&id=widening%2Fevil%3A%3Ap(1)");
    assert!(
        case.contains("&lt;/script&gt;&lt;img src=x&gt;")
            && case.contains("no &lt;b&gt;bold&lt;/b&gt; value \u{fffd}\\u{1b}[31m"),
        "{case}"
    );
    assert!(
        case.contains("--filter 'widening/evil::p(1)@ironplc-ed2'"),
        "{case}"
    );

    let causes = dom("#causes?number=1");
    assert!(
        causes.contains("Copy text of a report") && causes.contains("PROGRAM m END_PROGRAM"),
        "{causes}"
    );

    let unknown = dom("#REAL_TO_NOTHING");
    assert!(
        unknown.contains("No case of this run calls a function REAL_TO_NOTHING"),
        "{unknown}"
    );
}

#[test]
fn a_recorded_compiler_is_a_column_like_an_engine_unless_it_ran() {
    let Some(browser) = browser() else { return };
    let folder = tempfile::tempdir().expect("a temporary folder");
    let page = write(folder.path());
    let dom = |address: &str| open(&browser, &page, address, "--dump-dom");
    let values = dom("#REAL_TO_INT?value=2.5");
    assert!(
        values.contains("STruC++ 0.6.1<div class=\"dim\">recorded 2026-11-24</div>"),
        "{values}"
    );
    let (_, row) = values
        .split_once("class=\"wanted\"")
        .expect("the row of the value");
    let (row, _) = row.split_once("</tr>").expect("its end");
    assert!(row.contains("✗ 7"), "{row}");
    let pair = dom("#convert?from=INT&to=SINT");
    assert!(pair.contains("✗ yes</span> STruC++ 0.6.1"), "{pair}");
    let matrix = dom("#matrix");
    assert!(
        matrix.contains(
            "INT to USINT: yes, with a warning; reference: yes, no warning; STruC++ 0.6.1: yes, no warning"
        ) && matrix.contains("Engines: R reference, S STruC++ 0.6.1 (recorded 2026-11-24)"),
        "{matrix}"
    );
    let compared = dom("#convert?from=INT&to=USINT");
    assert!(
        compared.contains("<code>INT#-1 &lt; USINT#255</code> is true of the numbers.")
            && compared.contains("≠ false</span> STruC++ 0.6.1 (ironplc-ed2)"),
        "{compared}"
    );
    let bits = dom("#bits?type=BYTE");
    assert!(
        bits.contains("BYTE: variable.8 in ironplc-ed2: no; STruC++ 0.6.1: yes"),
        "{bits}"
    );
    for shown in [&values, &pair, &matrix] {
        assert!(!shown.contains("An older reference"), "the run counts");
    }
}

#[test]
fn a_page_of_the_vendor_stands_beside_a_recording_that_contradicts_it() {
    let Some(browser) = browser() else { return };
    let folder = tempfile::tempdir().expect("a temporary folder");
    let page = write(folder.path());
    let values = open(&browser, &page, "#LREAL_TO_DINT?value=-3E9", "--dump-dom");
    let (_, row) = values
        .split_once("class=\"wanted\"")
        .expect("the row of the value");
    let (row, _) = row.split_once("</tr>").expect("its end");
    assert!(
        row.contains("-2147483648") && row.contains("≠ 1294967296") && row.contains("by codesys-real-to"),
        "{row}"
    );
}

#[test]
fn the_page_can_be_printed() {
    let Some(browser) = browser() else { return };
    let folder = tempfile::tempdir().expect("a temporary folder");
    let page = write(folder.path());
    let printed = folder.path().join("printed.pdf");
    open(
        &browser,
        &page,
        "#claims",
        &format!("--print-to-pdf={}", printed.display()),
    );
    assert!(fs::read(&printed).expect("a printed page").starts_with(b"%PDF"));
}
