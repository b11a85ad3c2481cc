//! Tables of rows: what becomes of rows, probes and expectations.

use crate::common::{cases, load, one_mistake, sources};
use stickler_suite::{Acceptance, Case};
use stickler_types::{DialectName, Fault};

const CALL: &str = "[[probe]]\nname = \"call\"\nobserve = \"into\"\nsource = '''\nfrom : {from} := {input};\ninto := {from}_TO_{to}(from);\n'''\n";

/// A file whose rows begin on line 6.
fn file(columns: &str, rows: &str, probes: &str) -> String {
    format!(
        "title = \"t\"\nbasis = \"forgeiec-conversion-functions: Range and precision\"\ndialects = [\"matiec\", \"plcnext\"]\n\
         columns = [{columns}]\nrows = [\n{rows}\n]\nexpect = \"{{expected}}\"\n{probes}"
    )
}

const COLUMNS: &str = "\"from\", \"to\", \"input\", \"expected\"";

fn ids(cases: &[Case]) -> Vec<&str> {
    cases.iter().map(|case| &*case.id).collect()
}

#[test]
fn a_row_becomes_a_case_for_each_dialect() {
    let rows = "[\"DINT\", \"INT\", 100_000, \"INT#-31072\"],\n[\"INT\", \"BOOL\", true, \"BOOL#TRUE\"]";
    let cases = cases("area/file.toml", &file(COLUMNS, rows, CALL));
    assert_eq!(
        ids(&cases)[1..3],
        [
            "area/file::call(DINT,INT,100_000)",
            "area/file::call(INT,BOOL,TRUE)"
        ]
    );
    assert_eq!(
        &*cases[0].source,
        "from : DINT := 100_000;\ninto := DINT_TO_INT(from);\n"
    );
    let value = &cases[0].expectation.values[0];
    assert_eq!(
        (&*value.name, value.value.to_string(), value.line),
        ("into", "INT#-31072".to_owned(), 6)
    );
    assert_eq!(cases[2].line, 7);
    assert_eq!(
        (cases[0].dialect, cases[1].dialect),
        (DialectName::MATIEC, DialectName::PLCNEXT)
    );
    assert!(cases[0].cell.is_none());
}

#[test]
fn a_row_asks_what_its_file_or_its_probe_says() {
    let rows = "[\"DINT\", \"INT\", 100_000, \"INT#-31072\"],\n[\"TIME\", \"DINT\", \"T#5ms\", \"DINT#5\"]";
    let asks = "asks = \"{from}_TO_{to}({from}#{input}) : {to}\"\n";
    let own = CALL.replace("\"call\"\n", "\"own\"\nasks = \"implicit({from},{to})\"\n");
    let cases = cases(
        "area/file.toml",
        &file(COLUMNS, rows, &format!("{asks}{CALL}{own}")),
    );
    let asked = |case: &Case| case.question.as_ref().expect("a question").to_string();
    let asked: Vec<String> = cases.iter().step_by(2).map(asked).collect();
    assert_eq!(
        asked,
        [
            "DINT_TO_INT(DINT#100000) : INT",
            "TIME_TO_DINT(TIME#5ms) : DINT",
            "implicit(DINT,INT)",
            "implicit(TIME,DINT)"
        ]
    );
}

#[test]
fn a_text_that_is_no_question_is_a_mistake_of_its_row() {
    let asks = "asks = \"{from}_TO_{to}({input}) : {to}\"\n";
    let text = file(
        COLUMNS,
        "[\"DINT\", \"INT\", \"5\", \"INT#5\"]",
        &format!("{asks}{CALL}"),
    );
    let said = "`asks`: `DINT_TO_INT(5) : INT` is no question such as";
    one_mistake("area/file.toml", &text, 6, said);
}

#[test]
fn words_expect_rejection_faults_and_nothing() {
    let rows =
        "[\"no\", \"P4035\"],\n[\"fault\", \"\"],\n[\"open\", \"\"],\n[\"accepted\", \"\"],\n[\"-\", \"\"]";
    let probe = "[[probe]]\nname = \"p\"\nobserve = \"x : INT\"\nsource = '''\n\n{expected};  (*! error {code} if expected = no *) \
                 (*! fault subrange if expected = fault *)\n'''\n";
    let cases = cases("area/file.toml", &file("\"expected\", \"code\"", rows, probe));
    let accepted: Vec<_> = cases
        .iter()
        .step_by(2)
        .map(|case| case.expectation.accepted)
        .collect();
    use Acceptance::{Observed, Rejected, Required};
    assert_eq!(accepted, [Rejected, Required, Observed, Required]);
    let [no, fault, open, ok] = [0, 2, 4, 6].map(|at| &cases[at]);
    assert_eq!(
        (
            no.expectation.diagnostics[0].code.as_str(),
            no.expectation.diagnostics[0].line
        ),
        ("P4035", 2)
    );
    assert_eq!(
        fault.expectation.fault.map(|fault| fault.fault),
        Some(Fault::Subrange)
    );
    assert!(fault.observe.is_empty() && ok.observe.is_empty());
    assert_eq!(
        (&*open.observe[0].name, &*open.observe[0].type_name),
        ("x", "INT")
    );
}

#[test]
fn what_is_expected_is_no_part_of_the_id() {
    let columns = "\"note\", \"input\", \"expected\"";
    let probe = "[[probe]]\nname = \"p\"\nobserve = \"x\"\nsource = 'x := {input}; (*! ok if note = a *)'\n";
    let rows = "[\"a\", \"x, (y)\", \"INT#1\"]";
    assert_eq!(
        ids(&cases("area/file.toml", &file(columns, rows, probe)))[0],
        "area/file::p(x~2C_~28y~29)"
    );
}

#[test]
fn special_columns_name_title_basis_and_dialects() {
    let columns = "\"id\", \"title\", \"basis\", \"dialects\", \"input\", \"expected\"";
    let rows = "[\"one\", \"T\", \"iec-61131-3: 1\", \"matiec\", \"1\", \"INT#1\"],\n[\"two\", \"\", \"\", \"\", \"2\", \"INT#2\"]";
    let probe = "[[probe]]\nname = \"p\"\nobserve = \"x\"\nsource = 'x := {input};'\n";
    let cases = cases("area/file.toml", &file(columns, rows, probe));
    let found: Vec<_> = cases
        .iter()
        .map(|case| (&*case.id, &*case.title, &*case.basis, case.dialect))
        .collect();
    let basis = "forgeiec-conversion-functions: Range and precision";
    assert_eq!(
        found,
        [
            ("area/file::p(one)", "T", "iec-61131-3: 1", DialectName::MATIEC),
            ("area/file::p(two)", "t", basis, DialectName::MATIEC),
            ("area/file::p(two)", "t", basis, DialectName::PLCNEXT),
        ]
    );
}

#[test]
fn of_several_bases_a_case_has_the_first_that_speaks_for_its_dialect() {
    let page = "[page]\ntitle = 't'\npublisher = 'p'\nkind = 'document'\naddress = 'https://example.org'\nread = '1'\n\
                engines = []\ndialects = ['matiec']\nsections = 'clauses'\n";
    let columns = "\"basis\", \"input\", \"expected\"";
    let rows = "[\"\", \"1\", \"INT#1\"],\n[\"page: 3 | iec-61131-3: 4\", \"2\", \"INT#2\"]";
    let probe = "[[probe]]\nname = \"p\"\nobserve = \"x\"\nbasis = [\"page: 1\", \"iec-61131-3: 2\"]\nsource = 'x := {input};'\n";
    let file = file(columns, rows, probe);
    let suite = load(&[
        ("sources.toml", &(sources(&[("", &file)]) + page)),
        ("area/file.toml", &file),
    ]);
    let found: Vec<_> = suite
        .cases
        .iter()
        .map(|case| (case.dialect, &*case.basis))
        .collect();
    assert_eq!(
        found,
        [
            (DialectName::MATIEC, "page: 1"),
            (DialectName::PLCNEXT, "iec-61131-3: 2"),
            (DialectName::MATIEC, "page: 3"),
            (DialectName::PLCNEXT, "iec-61131-3: 4"),
        ]
    );
}

#[test]
fn a_cell_of_several_lines_moves_the_marks_below_it() {
    let rows = "[\"a;\\nb;\\n\", \"no\"],\n[\"a;\", \"no\"]";
    let probe = "[[probe]]\nname = \"p\"\nsource = '''\n{body}\n(*! error P4035 if expected = no *)\n'''\n";
    let cases = cases("area/file.toml", &file("\"body\", \"expected\"", rows, probe));
    assert_eq!(
        &*cases[0].source,
        "a;\nb;\n\n(*! error P4035 if expected = no *)\n"
    );
    assert_eq!(cases[0].expectation.diagnostics[0].line, 4);
    assert_eq!(cases[2].expectation.diagnostics[0].line, 2);
}

#[test]
fn a_probe_has_its_own_expectation_and_rows() {
    let columns = "\"input\", \"first\", \"expected\"";
    let rows = "[\"1\", \"INT#1\", \"INT#2\"],\n[\"2\", \"INT#3\", \"INT#4\"]";
    let probes = "[[probe]]\nname = \"p\"\nobserve = \"x\"\nexpect = \"{first}\"\nonly = \"input <> 2\"\nsource = 'x := {input};'\n\
                  [[probe]]\nname = \"q\"\nobserve = \"x\"\nscans = 2\nsource = 'x := {input};'\n";
    let cases = cases("area/file.toml", &file(columns, rows, probes));
    let found: Vec<_> = cases
        .iter()
        .step_by(2)
        .map(|case| {
            (
                &*case.id,
                case.scans,
                case.expectation.values[0].value.to_string(),
            )
        })
        .collect();
    assert_eq!(
        found,
        [
            ("area/file::p(1)", 1, "INT#1".to_owned()),
            ("area/file::q(1)", 2, "INT#2".to_owned()),
            ("area/file::q(2)", 2, "INT#4".to_owned()),
        ]
    );
}

#[test]
fn without_expect_the_marks_alone_say_what_must_happen() {
    let text = file(
        "\"input\"",
        "[\"1\"]",
        "[[probe]]\nname = \"p\"\nsource = '''\nx := {input};\n(*! values\nx = INT#{input}\n*)\n'''\n",
    )
    .replace("expect = \"{expected}\"\n", "");
    let cases = cases("area/file.toml", &text);
    assert_eq!(cases[0].expectation.values[0].value.to_string(), "INT#1");
    assert_eq!(cases[0].expectation.values[0].line, 13);
}

#[test]
fn an_error_mark_in_one_dialect_wins_over_the_expected_value() {
    let probe = CALL.replace("(from);", "(from); (*! error P4017 in plcnext *)");
    let cases = cases(
        "area/file.toml",
        &file(COLUMNS, "[\"DINT\", \"INT\", 1, \"INT#1\"]", &probe),
    );
    let accepted: Vec<_> = cases.iter().map(|case| case.expectation.accepted).collect();
    assert_eq!(accepted, [Acceptance::Required, Acceptance::Rejected]);
}

#[test]
fn mistakes_in_rows_are_said_with_their_line() {
    let good = "[\"DINT\", \"INT\", 1, \"INT#1\"]";
    for (columns, rows, probes, line, said) in [
        (
            COLUMNS,
            "[\"DINT\", \"INT\", 1]",
            CALL,
            6,
            "`rows`: the row has 3 cells for 4 columns",
        ),
        (
            COLUMNS,
            "[\"DINT\", \"INT\", 1, \"1\"]",
            CALL,
            6,
            "`expect`: `1` is no typed literal",
        ),
        (
            COLUMNS,
            "[\"DINT\", \"INT\", 1, \"no\"]",
            CALL,
            6,
            "`no` is expected, but no `error` mark applies, in the probe `call`",
        ),
        (
            COLUMNS,
            "[\"DINT\", \"INT\", 1, \"fault\"]",
            CALL,
            6,
            "no `fault` mark applies",
        ),
        (
            COLUMNS,
            "[\"DINT\", \"INT\", 1, \"open\"]",
            CALL,
            6,
            "so `observe` needs a type",
        ),
        (
            COLUMNS,
            "[\"DINT\", \"INT\", [1], \"INT#1\"]",
            CALL,
            6,
            "expected a string, a number, true or false",
        ),
        (
            COLUMNS,
            good,
            &CALL.replace("observe = \"into\"\n", ""),
            6,
            "the probe has no `observe`",
        ),
        (
            COLUMNS,
            good,
            &CALL.replace("observe", "values = [\"1\"]\nobserve"),
            11,
            "`values` belongs to a matrix",
        ),
        (
            "\"from\", \"to\", \"from\", \"expected\"",
            good,
            &CALL.replace("{input}", ""),
            4,
            "there are two columns `from`",
        ),
        (
            "\"from\", \"to\", \"in.put\", \"expected\"",
            good,
            &CALL.replace("{input}", ""),
            4,
            "`in.put` is no name of a column",
        ),
        (
            &format!("{COLUMNS}, \"dialects\""),
            "[\"DINT\", \"INT\", 1, \"INT#1\", \"iec\"]",
            CALL,
            6,
            "no dialect or group `iec`",
        ),
    ] {
        one_mistake("area/file.toml", &file(columns, rows, probes), line, said);
    }
}

#[test]
fn a_cell_that_would_end_a_mark_is_said() {
    let rows = "[\"DINT\", \"STRING\", 1, \"STRING#'*)'\"]";
    let probe = "[[probe]]\nname = \"p\"\nobserve = \"into\"\nsource = '''{from}{to}{input} (*! values if to = X\n x = {expected}\n *)'''\n";
    let mistakes = crate::common::mistakes("area/file.toml", &file(COLUMNS, rows, probe));
    assert!(
        mistakes.len() == 1 && mistakes[0].contains("`{expected}` has `(*` or `*)` in it"),
        "{mistakes:?}"
    );
}

#[test]
fn a_table_is_either_a_matrix_or_rows() {
    let head = "title = \"t\"\nbasis = \"b: c\"\ndialects = [\"matiec\"]\n";
    for rest in ["", "columns = []\n", "matrix = ''\ncolumns = []\nrows = []\n"] {
        one_mistake(
            "area/file.toml",
            &format!("{head}{rest}"),
            1,
            "either `matrix`, or `columns` and `rows`",
        );
    }
}

#[test]
fn a_generate_table_changes_no_case_and_has_known_keys() {
    let row = "[\"DINT\", \"INT\", \"1\", \"INT#1\"]";
    let plain = file(COLUMNS, row, CALL);
    let generate = |keys: &str| plain.replace("[[probe]]", &format!("[generate]\n{keys}\n[[probe]]"));
    let known = generate("from = ['DINT']\nto = ['INT']\ninputs = ['1', 'limits']\nbesides = ['other']");
    assert_eq!(cases("area/file.toml", &known), cases("area/file.toml", &plain));
    for (keys, line, said) in [
        ("to = ['INT']\ninputs = []", 9, "missing field `from`"),
        (
            "from = []\nto = []\ninputs = []\ninput = []",
            13,
            "unknown field `input`",
        ),
        (
            "from = []\nto = []\ninputs = [1]",
            12,
            "invalid type: integer `1`, expected a string",
        ),
    ] {
        one_mistake("area/file.toml", &generate(keys), line, said);
    }
    let matrix = "title = \"t\"\nbasis = \"b: c\"\ndialects = [\"matiec\"]\nmatrix = \"\"\"\nBOOL\nBOOL no\n\"\"\"\n\
                  [generate]\nfrom = []\nto = []\ninputs = []\n";
    let mistakes = crate::common::mistakes("area/file.toml", matrix);
    let said = "8: `generate`: a matrix has no rows to be generated";
    assert!(
        mistakes.iter().any(|mistake| mistake.starts_with(said)),
        "{mistakes:?}"
    );
}

#[test]
fn two_rows_with_the_same_program_are_said() {
    let rows = "[\"DINT\", \"INT\", 1, \"INT#1\"],\n[\"DINT\", \"INT\", 1, \"INT#2\"]";
    let suite = load(&[("area/file.toml", &file(COLUMNS, rows, CALL))]);
    assert_eq!((suite.cases.len(), suite.errors.len()), (2, 1));
    let said = suite.errors[0].to_string();
    assert!(
        said.starts_with("cases/area/file.toml:7: `id`: the id `area/file::call(DINT,INT,1)` stands already"),
        "{said}"
    );
}

#[test]
fn a_table_has_no_thousand_columns() {
    let columns: Vec<String> = (0..1000).map(|at| format!("\"c{at}\"")).collect();
    one_mistake(
        "area/file.toml",
        &file(&columns.join(", "), "", CALL),
        1,
        "1000 columns; a table has at most 100",
    );
}
