//! Calls that no system can make sense of: unknown names, wrong numbers of arguments, wrong types.

use crate::sheet::owned;
use crate::table::{Probe, Table};

const PROGRAM: &str = "\
PROGRAM main
VAR
    i : INT := 5;
    d : DINT := 5;
    r : REAL := 5.0;
    w : WORD := 16#0005;
    b : BOOL;
    s : STRING := '5';
    t : TIME := T#5ms;
    day : DATE := D#2024-02-29;
    moment : DT;
END_VAR
    {target} := {call};   (*! error {code} *)
END_PROGRAM
";

/// The table of this family.
pub fn tables() -> Vec<Table> {
    vec![
        table(
            "bad-name",
            "A function that does not exist",
            "P4017",
            &[
                ("d", "INT_TO_DNIT(i)"),
                ("d", "ITN_TO_DINT(i)"),
                ("d", "INT_TO_(i)"),
                ("d", "INT_2_DINT(i)"),
                ("d", "INTTO_DINT(i)"),
                ("d", "TO_DIMT(i)"),
                ("d", "TRUNC_DNIT(r)"),
                ("d", "TRUNCATE(r)"),
                ("i", "BDC_TO_INT(w)"),
                ("w", "INT_TO_BDC(i)"),
                ("moment", "DATE_TO_TD(day)"),
                ("i", "REAL_TO_INTEGER(r)"),
                ("s", "INT_TO_TEXT(i)"),
                ("i", "STRING_TO_NUMBER(s)"),
                ("d", "INT_TO_DINT_TO_LINT(i)"),
                ("d", "REAL_TRUNC_TO_DINT(r)"),
            ],
        ),
        table(
            "bad-count",
            "A conversion function takes one argument",
            "P4018",
            &[
                ("d", "INT_TO_DINT()"),
                ("d", "INT_TO_DINT(i, i)"),
                ("d", "INT_TO_DINT(i, i, i)"),
                ("d", "TRUNC()"),
                ("d", "TRUNC(r, r)"),
                ("i", "REAL_TO_INT()"),
                ("i", "BCD_TO_INT(w, w)"),
                ("w", "INT_TO_BCD()"),
                ("i", "STRING_TO_INT(s, i)"),
                ("s", "INT_TO_STRING()"),
                ("d", "TIME_TO_DINT(t, t)"),
                ("moment", "DATE_TO_DT()"),
                ("b", "INT_TO_BOOL(i, i)"),
            ],
        ),
        table(
            "bad-argument",
            "An argument that does not convert to the parameter's type",
            "P4026",
            &[
                ("d", "INT_TO_DINT(d)"),
                ("d", "INT_TO_DINT(r)"),
                ("d", "INT_TO_DINT(s)"),
                ("d", "INT_TO_DINT(b)"),
                ("d", "INT_TO_DINT(t)"),
                ("d", "INT_TO_DINT(day)"),
                ("i", "REAL_TO_INT(s)"),
                ("i", "WORD_TO_INT(r)"),
                ("i", "BYTE_TO_INT(w)"),
                ("i", "STRING_TO_INT(i)"),
                ("d", "TIME_TO_DINT(i)"),
                ("t", "DINT_TO_TIME(t)"),
                ("moment", "DATE_TO_DT(t)"),
                ("day", "DT_TO_DATE(day)"),
                ("d", "TRUNC(s)"),
                ("i", "BCD_TO_INT(s)"),
                ("w", "INT_TO_BCD(r)"),
                ("i", "BOOL_TO_INT(i)"),
            ],
        ),
        table(
            "bad-target",
            "A result that does not convert to the target's type",
            "P4027",
            &[
                ("i", "INT_TO_DINT(i)"),
                ("d", "INT_TO_STRING(i)"),
                ("s", "STRING_TO_INT(s)"),
                ("i", "INT_TO_REAL(i)"),
                ("b", "DINT_TO_INT(d)"),
                ("day", "DATE_TO_DT(day)"),
                ("i", "DINT_TO_TIME(d)"),
                ("t", "INT_TO_DINT(i)"),
                ("i", "TRUNC(r)"),
            ],
        ),
    ]
}

fn table(name: &str, title: &str, code: &str, calls: &[(&str, &str)]) -> Table {
    let rows = calls.iter().map(|(target, call)| owned(&[target, call, code]));
    Table {
        name: name.to_owned(),
        title: title.to_owned(),
        basis: format!("ironplc-problem-codes: {code}"),
        dialects: owned(&["ironplc-ed3", "matiec", "plcnext"]),
        summary: String::new(),
        columns: owned(&["target", "call", "code"]),
        rows: rows.collect(),
        probes: vec![Probe {
            name: "rejected".to_owned(),
            source: PROGRAM.to_owned(),
            ..Probe::default()
        }],
    }
}
