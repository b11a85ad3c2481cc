//! Matrices: what becomes of cells, probes and values.

use crate::common::{cases, load, one_mistake};
use stickler_suite::{Acceptance, Case};
use stickler_types::{DialectName, MatrixWord, Value};

const HEAD: &str = "title = \"t {row}\"\nbasis = \"ironplc-type-conversions: Integer widening\"\ndialects = [\"ironplc-ed2\", \"matiec\"]\n";

const ASSIGNMENT: &str = "[[probe]]\nname = \"assign\"\nobserve = \"into\"\nsource = '''\nPROGRAM main\nVAR\n\
    from : {row} := {value};\ninto : {column};\nEND_VAR\ninto := from; (*! error P4035 if no *)\nEND_PROGRAM\n'''\n";

/// A file with this matrix, whose columns stand on line 5, and these probes.
fn file(matrix: &str, probes: &str) -> String {
    format!("{HEAD}matrix = '''\n{matrix}'''\n{probes}")
}

fn ids(cases: &[Case]) -> Vec<&str> {
    cases.iter().map(|case| &*case.id).collect()
}

fn expected(case: &Case) -> Vec<(&str, String)> {
    case.expectation
        .values
        .iter()
        .map(|value| (&*value.name, value.value.to_string()))
        .collect()
}

#[test]
fn a_cell_becomes_a_case_for_each_value_and_dialect() {
    let probe = format!("asks = \"implicit({{row}},{{column}})\"\n{ASSIGNMENT}");
    let text = file("     BOOL WORD\nBOOL =    yes\n", &probe);
    let cases = cases("area/file.toml", &text);
    assert_eq!(
        ids(&cases)[..4],
        [
            "area/file::assign(BOOL,BOOL,FALSE)",
            "area/file::assign(BOOL,BOOL,FALSE)",
            "area/file::assign(BOOL,BOOL,TRUE)",
            "area/file::assign(BOOL,BOOL,TRUE)",
        ]
    );
    assert_eq!(cases.len(), 8);
    assert_eq!(
        (cases[0].dialect, cases[1].dialect),
        (DialectName::IRONPLC_ED2, DialectName::MATIEC)
    );
    let last = &cases[7];
    assert_eq!(
        &*last.source,
        "PROGRAM main\nVAR\nfrom : BOOL := TRUE;\ninto : WORD;\nEND_VAR\ninto := from; (*! error P4035 if no *)\nEND_PROGRAM\n"
    );
    assert_eq!(expected(last), [("into", "WORD#16#0001".to_owned())]);
    assert_eq!(
        (&*last.observe[0].name, &*last.observe[0].type_name),
        ("into", "WORD")
    );
    assert_eq!(last.question.as_ref().unwrap().to_string(), "implicit(BOOL,WORD)");
    assert_eq!((last.line, &*last.title), (6, "t BOOL"));
    let cell = last.cell.as_ref().unwrap();
    assert_eq!(
        (&*cell.probe, &*cell.row, &*cell.column, cell.word),
        ("assign", "BOOL", "WORD", MatrixWord::Yes)
    );
}

#[test]
fn a_no_cell_is_rejected_on_the_marks_line_with_one_value_and_none_in_the_id() {
    let cases = cases("area/file.toml", &file("    SINT\nINT no\n", ASSIGNMENT));
    assert_eq!(
        ids(&cases),
        ["area/file::assign(INT,SINT)", "area/file::assign(INT,SINT)"]
    );
    assert_eq!(cases[0].expectation.accepted, Acceptance::Rejected);
    assert_eq!(cases[0].expectation.diagnostics[0].line, 6);
    assert!(
        cases[0].source.contains("from : INT := 1;"),
        "{}",
        cases[0].source
    );
    assert!(cases[0].observe.is_empty());
}

#[test]
fn an_open_cell_records_acceptance_and_the_value() {
    let cases = cases("area/file.toml", &file("     WORD\nBOOL open\n", ASSIGNMENT));
    assert_eq!(cases.len(), 4);
    assert_eq!(cases[0].expectation.accepted, Acceptance::Observed);
    assert!(cases[0].expectation.values.is_empty());
    assert_eq!(
        (&*cases[0].observe[0].name, &*cases[0].observe[0].type_name),
        ("into", "WORD")
    );
}

#[test]
fn a_dash_is_no_case_and_words_are_tested_by_marks() {
    let probe = ASSIGNMENT.replace("if no", "if no|open");
    let cases = cases(
        "area/file.toml",
        &file("     WORD BYTE REAL\nBOOL -    open no\n", &probe),
    );
    assert_eq!(ids(&cases)[0], "area/file::assign(BOOL,BYTE)");
    assert!(
        cases
            .iter()
            .all(|case| case.expectation.accepted == Acceptance::Rejected)
    );
    assert_eq!(cases.len(), 4);
}

#[test]
fn integers_arrive_rounded_once_in_reals() {
    let cases = cases("area/file.toml", &file("     LREAL\nLINT yes\n", ASSIGNMENT));
    let arrived = |value: &str| {
        let id = format!("area/file::assign(LINT,LREAL,{value})");
        expected(cases.iter().find(|case| *case.id == *id).unwrap())[0]
            .1
            .clone()
    };
    assert_eq!(arrived("9007199254740993"), "LREAL#9007199254740992.0");
    assert_eq!(
        Value::parse(&arrived("9223372036854775807")),
        Value::parse("LREAL#9223372036854775808.0")
    );
}

#[test]
fn values_can_be_one_or_a_list() {
    let one = ASSIGNMENT.replace("observe", "values = \"one\"\nobserve");
    let found = cases("area/file.toml", &file("    INT\nINT =\n", &one));
    assert_eq!(ids(&found)[0], "area/file::assign(INT,INT,1)");
    assert_eq!(found.len(), 2);
    let list = ASSIGNMENT.replace("observe", "values = [5, \"16#10\"]\nobserve");
    let found = cases("area/file.toml", &file("    INT\nINT =\n", &list));
    assert_eq!(
        ids(&found)[1..3],
        ["area/file::assign(INT,INT,5)", "area/file::assign(INT,INT,16#10)"]
    );
    assert_eq!(expected(&found[2]), [("into", "INT#16".to_owned())]);
}

#[test]
fn placeholders_stand_for_the_value_in_all_its_forms() {
    let probe = "[[probe]]\nname = \"p\"\nvalues = [\"-1\"]\nobserve = [\"a\", \"b : DINT\"]\nsource = '''\n\
        {value} {typed} {other} {cell} {{}}\n(*! values if yes\nc = {expected}\n*)\n'''\n";
    let cases = cases("area/file.toml", &file("     LINT\nSINT yes\n", probe));
    assert!(
        cases[0].source.starts_with("-1 SINT#-1 1 yes {}\n"),
        "{}",
        cases[0].source
    );
    let lint = "LINT#-1".to_owned();
    assert_eq!(
        expected(&cases[0]),
        [("c", lint.clone()), ("a", lint), ("b", "DINT#-1".to_owned())]
    );
}

#[test]
fn the_initial_value_is_never_the_one_that_must_arrive() {
    let probe = ASSIGNMENT.replace("{column};", "{column} := {other};");
    let cases = cases(
        "area/file.toml",
        &file("     BOOL INT\nBOOL =   -\nINT  -   =\n", &probe),
    );
    for case in &cases {
        let line = case.source.lines().nth(3).unwrap();
        let initial = line.rsplit(' ').next().unwrap().trim_end_matches(';');
        let arrives = expected(case)[0].1.clone();
        assert_ne!(arrives.rsplit('#').next(), Some(initial), "{}", case.id);
    }
}

#[test]
fn a_probe_can_leave_cells_out_and_narrow_dialects() {
    let probe = ASSIGNMENT.replace(
        "observe",
        "only = \"row <> column and column = ANY_INT\"\ndialects = [\"matiec\"]\nobserve",
    );
    let matrix = "     SINT INT REAL\nSINT =    yes yes\nINT  no   =   yes\n";
    let cases = cases("area/file.toml", &file(matrix, &probe));
    let mut pairs: Vec<_> = cases
        .iter()
        .map(|case| case.cell.as_ref().unwrap())
        .map(|c| (&*c.row, &*c.column))
        .collect();
    pairs.dedup();
    assert_eq!(pairs, [("SINT", "INT"), ("INT", "SINT")]);
    assert!(cases.iter().all(|case| case.dialect == DialectName::MATIEC));
}

#[test]
fn a_mark_in_some_dialects_splits_the_cell() {
    let probe = ASSIGNMENT
        .replace("if no", "if no error P4035 in matiec")
        .replace("if no error P4035", "");
    let cases = cases("area/file.toml", &file("     BOOL\nBOOL =\n", &probe));
    let found: Vec<_> = cases
        .iter()
        .map(|case| (&*case.id, case.dialect, case.expectation.accepted))
        .collect();
    use Acceptance::{Rejected, Required};
    assert_eq!(
        found,
        [
            (
                "area/file::assign(BOOL,BOOL,FALSE)",
                DialectName::IRONPLC_ED2,
                Required
            ),
            (
                "area/file::assign(BOOL,BOOL,TRUE)",
                DialectName::IRONPLC_ED2,
                Required
            ),
            ("area/file::assign(BOOL,BOOL)", DialectName::MATIEC, Rejected),
        ]
    );
}

#[test]
fn several_matrices_have_their_own_dialects_basis_and_names() {
    let text = format!(
        "title = \"t\"\nbasis = \"b: c\"\n[[matrix]]\nname = \"m\"\ndialects = [\"matiec\"]\ntable = '''\n     BOOL\nBOOL no\n'''\n\
         [[matrix]]\ndialects = [\"plcnext\"]\nbasis = \"implicit-conversion-table: {{row}} to {{column}}\"\ntable = '''\n     BOOL\nBOOL =\n'''\n{ASSIGNMENT}"
    );
    let cases = cases("area/file.toml", &text);
    assert_eq!(ids(&cases)[0], "area/file::m.assign(BOOL,BOOL)");
    assert_eq!(
        (cases[0].dialect, &*cases[0].basis, cases[0].line),
        (DialectName::MATIEC, "b: c", 8)
    );
    assert_eq!(
        (cases[1].dialect, &*cases[1].basis),
        (DialectName::PLCNEXT, "implicit-conversion-table: BOOL to BOOL")
    );
}

#[test]
fn declared_types_have_their_own_values() {
    let types = "[types.COLOR]\ndeclaration = \"TYPE COLOR : (RED, GREEN); END_TYPE\"\nvalues = [\"RED\", \"GREEN\"]\n\
        [types.LENGTH]\ndeclaration = \"TYPE LENGTH : INT; END_TYPE\"\nbase = \"INT\"\nvalues = [7]\n\
        [types.POINT]\ndeclaration = \"TYPE POINT : STRUCT x : INT; END_STRUCT; END_TYPE\"\nvalues = [\"(x := 5)\"]\narrives = [\".x = INT#5\"]\n";
    let probe = ASSIGNMENT.replace("PROGRAM main", "{types} PROGRAM main");
    let matrix = "       COLOR LENGTH POINT DINT\nCOLOR  =     -      -     no\nLENGTH -     =      -     yes\nPOINT  no    -      =     -\n";
    let cases = cases("area/file.toml", &file(matrix, &format!("{probe}{types}")));
    let of = |id: &str| {
        cases
            .iter()
            .find(|case| *case.id == format!("area/file::assign({id})"))
            .unwrap()
    };
    assert_eq!(
        expected(of("COLOR,COLOR,GREEN")),
        [("into", "COLOR#GREEN".to_owned())]
    );
    assert_eq!(&*of("COLOR,COLOR,GREEN").observe[0].type_name, "COLOR");
    assert!(
        of("COLOR,COLOR,RED")
            .source
            .starts_with("TYPE COLOR : (RED, GREEN); END_TYPE PROGRAM main\n")
    );
    assert_eq!(expected(of("LENGTH,DINT,7")), [("into", "DINT#7".to_owned())]);
    assert_eq!(
        expected(of("POINT,POINT,~28x_:=_5~29")),
        [("into.x", "INT#5".to_owned())]
    );
    let rejected = of("POINT,COLOR");
    assert!(
        rejected
            .source
            .starts_with("TYPE POINT : STRUCT x : INT; END_STRUCT; END_TYPE TYPE COLOR")
    );
    assert_eq!(rejected.expectation.diagnostics[0].line, 6);
}

#[test]
fn texts_of_a_length_count_as_their_base_type() {
    let cases = cases(
        "area/file.toml",
        &file("          STRING\nSTRING[9] yes\n", ASSIGNMENT),
    );
    assert_eq!(ids(&cases)[2], "area/file::assign(STRING[9],STRING,~27a~27)");
    assert_eq!(expected(&cases[2]), [("into", "STRING#'a'".to_owned())]);
}

#[test]
fn a_time_that_no_number_holds_is_recorded() {
    let cases = cases("area/file.toml", &file("     UDINT\nTIME yes\n", ASSIGNMENT));
    let of = |value: &str| cases.iter().find(|case| case.id.contains(value)).unwrap();
    assert_eq!(expected(of("TIME#1ms")), [("into", "UDINT#1".to_owned())]);
    assert!(expected(of("TIME#-1ms")).is_empty());
    assert_eq!(&*of("TIME#-1ms").observe[0].type_name, "UDINT");
    assert_eq!(of("TIME#-1ms").expectation.accepted, Acceptance::Required);
}

#[test]
fn mistakes_in_a_matrix_are_said_with_their_line() {
    let observe_without_value = ASSIGNMENT.replace("{value}", "1");
    for (matrix, probes, line, said) in [
        (
            "    INT\nINT no no\n",
            ASSIGNMENT,
            6,
            "`matrix`: row `INT` has 2 cells for 1 columns",
        ),
        (
            "    INT\nINT nope\n",
            ASSIGNMENT,
            6,
            "`nope` is no word of a cell",
        ),
        ("    INT\nPNT no\n", ASSIGNMENT, 6, "the file has no [types.PNT]"),
        ("    PNT\nINT no\n", ASSIGNMENT, 5, "the file has no [types.PNT]"),
        ("    INT\nINT no\n", "", 1, "the table has no [[probe]]"),
        (
            "    INT\nREAL yes\n",
            ASSIGNMENT,
            9,
            "nothing says what arrives in a INT from a REAL",
        ),
        (
            "    INT\nINT =\n",
            &observe_without_value,
            9,
            "nothing says what must arrive",
        ),
        (
            "    INT\nINT =\n",
            &format!("expect = \"x\"\n{ASSIGNMENT}"),
            8,
            "`expect` belongs to a table of rows",
        ),
    ] {
        one_mistake("area/file.toml", &file(matrix, probes), line, said);
    }
}

#[test]
fn mistakes_in_a_probe_are_said_with_their_line() {
    let matrix = "    INT\nINT no\n";
    for (from, to, line, said) in [
        (
            "{row}",
            "{line}",
            14,
            "`probe.source`: no placeholder `{line}`; there are `{row}`",
        ),
        ("END_PROGRAM", "END_PROGRAM }", 18, "`}` stands alone"),
        ("P4035", "P9999999", 17, "P9999999"),
        ("if no", "if never", 17, "`never` is no word of a cell"),
        ("if no", "if value = 1", 17, "a condition cannot test `value`"),
        (
            "error P4035 if no",
            "ok",
            6,
            "INT to INT says no, but no `error` mark applies (in the probe `assign`",
        ),
        (
            "observe = \"into\"",
            "observe = \"{nope}\"",
            10,
            "`probe.observe`: no placeholder `{nope}`",
        ),
        (
            "observe = \"into\"",
            "observe = 5",
            10,
            "`probe.observe`: invalid type",
        ),
        ("observe", "obsrve", 10, "unknown field `obsrve`"),
        (
            "observe",
            "values = \"all\"\nobserve",
            10,
            "`all` is no set of values",
        ),
        (
            "observe",
            "values = [70000]\nobserve",
            10,
            "`70000` is no literal of INT",
        ),
        (
            "observe",
            "only = \"INT\"\nobserve",
            10,
            "`INT` is no word of a cell",
        ),
        (
            "observe",
            "dialects = [\"x\"]\nobserve",
            10,
            "`probe.dialects`: no dialect or group `x`",
        ),
        ("observe", "basis = \"{value}\"\nobserve", 9, "a basis may use"),
        (
            "observe",
            "expect = \"no\"\nobserve",
            9,
            "`expect` belongs to a table of rows",
        ),
        (
            "\"assign\"",
            "\"a b\"",
            9,
            "`probe.name`: ' ' cannot stand in an id",
        ),
        ("\"assign\"", "\"a/b\"", 9, "a probe's name has no `/`"),
    ] {
        one_mistake(
            "area/file.toml",
            &file(matrix, &ASSIGNMENT.replace(from, to)),
            line,
            said,
        );
    }
    one_mistake(
        "area/file.toml",
        &file(matrix, &ASSIGNMENT.repeat(2)),
        21,
        "there are two probes `assign`",
    );
}

#[test]
fn mistakes_in_a_declared_type_are_said_with_their_line() {
    let declaration = "[types.T]\ndeclaration = \"TYPE T : INT; END_TYPE\"\n";
    for (rest, line, said) in [
        (
            "base = \"INTEGER\"",
            22,
            "`types.T`: `INTEGER` is no elementary type",
        ),
        (
            "base = \"INT\"\nvalues = [70000]",
            23,
            "`70000` is no literal of the base type",
        ),
        (
            "values = [\"(1)\"]\narrives = [\"x = INT#5\"]",
            23,
            "`x` is no path below a variable",
        ),
        (
            "values = [\"(1)\"]\narrives = [\".x\"]",
            23,
            "write `.path = literal`",
        ),
        (
            "arrives = [\".x = INT#5\"]",
            21,
            "`arrives` needs exactly one value",
        ),
        ("value = 1", 22, "unknown field `value`"),
    ] {
        let text = file("    INT\nINT no\n", &format!("{ASSIGNMENT}{declaration}{rest}\n"));
        one_mistake("area/file.toml", &text, line, said);
    }
}

#[test]
fn a_type_without_values_is_said() {
    let types = "[types.T]\ndeclaration = \"TYPE T : STRUCT x : INT; END_STRUCT; END_TYPE\"\n";
    let text = file("  INT\nT no\n", &format!("{ASSIGNMENT}{types}"));
    one_mistake(
        "area/file.toml",
        &text,
        6,
        "T has no values for the probe `assign` (give [types.T] `values`)",
    );
}

#[test]
fn the_same_cell_twice_is_said_and_kept_once() {
    let matrices = "[[matrix]]\ntable = '''\n     BOOL\nBOOL no\n'''\n".repeat(2);
    let suite = load(&[("area/file.toml", &format!("{HEAD}{matrices}{ASSIGNMENT}"))]);
    assert_eq!(suite.cases.len(), 2);
    assert_eq!(suite.errors.len(), 1);
    let said = suite.errors[0].to_string();
    assert!(said.contains("file.toml:12: `id`: the id `area/file::assign(BOOL,BOOL)` stands already at cases/area/file.toml:7"), "{said}");
}
