//! Tests of `essence.rs`.

use super::*;
use crate::question::Deviation;
use crate::title::title;
use stickler_types::{Diagnostic, ElementaryType, Value};

/// Returns a small program with which an engine did something else than was expected.
fn deviating(program: &str, expected: Vec<Fact>, got: Vec<Fact>, strict: Grade) -> Smallest {
    let sign = Sign::of(program, Verdict::Fail, (&expected, &got), strict);
    Smallest {
        deviation: Deviation { sign, expected, got },
        ..Smallest::rejected(program, 5, "")
    }
}

/// Returns what matters of a small program of which nothing was asked.
fn unasked(smallest: &Smallest) -> Essence {
    Essence::of(smallest, &Normal::unasked(smallest))
}

/// Returns what matters of a program that assigns an expression to a variable, and is accepted where this code had to be reported.
fn accepted(ty: &str, expression: &str, code: &str) -> Essence {
    let program = format!("PROGRAM p\nVAR\nx : {ty};\nEND_VAR\nx := {expression};\nEND_PROGRAM\n");
    let mistake = Fact::Diagnostic(Diagnostic {
        line: Some(5),
        code: Some(code.to_owned()),
        ..Diagnostic::default()
    });
    let smallest = deviating(&program, vec![mistake], vec![Fact::Accepted], Grade::Line);
    unasked(&smallest)
}

#[test]
fn a_typed_literal_with_a_sign_is_one_cause_wherever_it_stands() {
    let initial = Smallest::rejected(
        "PROGRAM p\nVAR\nx : INT := INT#-5;\nEND_VAR\nx := x;\nEND_PROGRAM\n",
        3,
        "P0002",
    );
    let assigned = Smallest::rejected(
        "PROGRAM p\nVAR\nx : DINT;\nEND_VAR\nx := DINT#-7;\nEND_PROGRAM\n",
        5,
        "P0002",
    );
    let essence = unasked;
    assert!(essence(&initial).explains(&essence(&assigned)));
    assert_eq!(essence(&initial).construct(), "typed literal with a sign");
    let own = Smallest::rejected(
        "PROGRAM p\nVAR\nx : INT := 1;\nEND_VAR\nx := x;\nEND_PROGRAM\n",
        3,
        "E048",
    );
    assert!(title(&own, false).ends_with("is rejected: E048 no"));
    assert!(title(&initial, true).ends_with("is rejected: P0002 no"));
    assert!(
        title(&initial, false).ends_with("is rejected: no"),
        "the code is its adapter's"
    );
    // The engine takes the literal alone.
    let innocent = Normal {
        innocent: vec!["INT#-5".to_owned()],
        ..Normal::unasked(&initial)
    };
    assert_eq!(Essence::of(&initial, &innocent).construct(), "declaration");
}

#[test]
fn a_declaration_is_told_by_the_section_that_its_own_line_begins() {
    let of = |program: &str, line: u32| {
        let mut smallest = Smallest::rejected(program, line, "P0002");
        for fact in &mut smallest.deviation.got {
            if let Fact::Diagnostic(reported) = fact {
                reported.column = Some(9);
            }
        }
        unasked(&smallest)
    };
    let apart = of("TYPE\nE : WORD;\nEND_TYPE\nPROGRAM p\n;\nEND_PROGRAM\n", 2);
    assert_eq!(apart.construct(), "type");
    let program =
        "TYPE\nE : WORD;\nEND_TYPE\nPROGRAM p\nVAR\nr : REAL;\nEND_VAR\nr.0 := TRUE;\nEND_PROGRAM\n";
    let mut elsewhere = Smallest::rejected(program, 2, "P0002");
    let mistake = Fact::Diagnostic(Diagnostic {
        line: Some(8),
        code: Some("P4069".to_owned()),
        ..Diagnostic::default()
    });
    elsewhere.deviation.sign.symptom = Symptom::OtherLine("P4069".to_owned());
    elsewhere.deviation.sign.at = String::new();
    elsewhere.deviation.expected = vec![mistake];
    let alias = Smallest::rejected(
        "TYPE\nE : WORD;\nEND_TYPE\nPROGRAM p\n;\nEND_PROGRAM\n",
        2,
        "P0002",
    );
    let alias = unasked(&alias);
    assert!(alias.explains(&unasked(&elsewhere)));
    assert!(apart.explains(&of("TYPE E : WORD; END_TYPE\nPROGRAM p\n;\nEND_PROGRAM\n", 1)));
}

#[test]
fn a_literal_that_is_not_known_is_one_cause_whatever_is_said_of_its_place() {
    let said = |program: &str, line: u32, message: &str| {
        let reported = Diagnostic {
            line: Some(line),
            message: message.to_owned(),
            ..Diagnostic::default()
        };
        let got = vec![Fact::Diagnostic(reported)];
        unasked(&deviating(program, vec![Fact::Accepted], got, Grade::Line))
    };
    let initial = "PROGRAM p\nVAR\nx : LREAL := 1.0E308;\nEND_VAR\nx := x;\nEND_PROGRAM\n";
    let assigned = "PROGRAM p\nVAR\nx : LREAL;\nEND_VAR\nx := 1.0E308;\nEND_PROGRAM\n";
    let of_initial = said(initial, 3, "initial value has another type");
    assert!(said(assigned, 5, "types do not fit").explains(&of_initial));
    assert!(!said(&assigned.replace("E308", ""), 5, "types do not fit").explains(&of_initial));
    let typed = |literal: &str| said(&initial.replace("1.0E308", literal), 3, "no constant");
    assert!(typed("BOOL#TRUE").explains(&typed("WSTRING#\"\"")));
    assert!(!typed("BOOL#TRUE").explains(&typed("BOOL#0")) && !typed("BOOL#0").explains(&typed("BOOL#TRUE")));
    let unread = |literal: &str| {
        let program = initial.replace("1.0E308", literal);
        let smallest = Smallest::rejected(&program, 3, "P0002");
        unasked(&smallest)
    };
    assert!(unread("STRING#''").explains(&unread("CHAR#'a'")));
    assert!(!unread("BOOL#0").explains(&unread("CHAR#'a'")));
    assert!(!typed("BOOL#TRUE").explains(&of_initial) && !typed("BOOL#TRUE").explains(&typed("T#5s")));
    let called = assigned.replace("1.0E308", "REAL_TO_LREAL(1.0E308)");
    assert!(!said(assigned, 5, "types do not fit").explains(&said(&called, 5, "no such function")));
}

#[test]
fn literals_that_should_not_be_read_are_told_apart_by_their_forms() {
    let accepted = |ty: &str, literal: &str| accepted(ty, literal, "P0002");
    let underscore = accepted("BYTE", "BYTE#6_");
    assert!(underscore.explains(&accepted("INT", "INT#12_")));
    assert!(underscore.explains(&accepted("INT", "1_")));
    for (ty, literal) in [
        ("REAL", "1.0_"),
        ("INT", "16#F_"),
        ("INT", "2#1_"),
        ("TIME", "T#1_s"),
        ("LTIME", "LTIME#10_ms"),
    ] {
        assert!(underscore.explains(&accepted(ty, literal)), "{literal}");
    }
    for (ty, literal) in [
        ("INT", "1e5"),
        ("INT", "1__0"),
        ("REAL", "1."),
        ("TIME", "T#1s1m"),
        ("INT", "INT#"),
        ("TIME", "T#1s_1ms_"),
        ("DATE", "D#2024-02-3_"),
    ] {
        assert!(!underscore.explains(&accepted(ty, literal)), "{literal}");
    }
}

#[test]
fn an_operator_before_its_operand_is_one_like_others() {
    let sum = accepted("WORD", "x + x", "P4049");
    assert!(sum.explains(&accepted("STRING", "-x", "P4049")));
    assert!(sum.explains(&accepted("STRING", "-(x)", "P4049")));
    assert!(!sum.explains(&accepted("STRING", "-1", "P4049")));
    assert!(!sum.explains(&accepted("STRING", "-INT#1", "P4049")));
}

#[test]
fn a_constant_that_may_be_assigned_may_be_assigned_in_part() {
    let whole = accepted("INT", "0", "S0001");
    let part = Essence {
        features: BTreeSet::from(["bit access".to_owned(), "constant".to_owned()]),
        ..whole.clone()
    };
    assert!(whole.explains(&part) && !part.explains(&whole));
    assert!(!accepted("INT", "0", "P2026").explains(&part));
}

fn diagnostic(code: &str, column: Option<u32>) -> Fact {
    Fact::Diagnostic(Diagnostic {
        line: Some(5),
        column,
        code: Some(code.to_owned()),
        ..Diagnostic::default()
    })
}

/// Returns what matters of a program with a mistake of this code on its fifth line, of which an engine says something else.
fn rejected_otherwise(program: &str, code: &str, (said, column): (&str, u32)) -> Essence {
    let smallest = deviating(
        program,
        vec![diagnostic(code, None)],
        vec![diagnostic(said, Some(column))],
        Grade::Code,
    );
    unasked(&smallest)
}

#[test]
fn a_literal_that_is_too_large_to_be_read_is_one_cause_and_explains_nothing_else() {
    let assigned = |literal: &str| {
        let program = format!("PROGRAM p\nVAR\nx : INT;\nEND_VAR\nx := {literal};\nEND_PROGRAM\n");
        rejected_otherwise(&program, "P2026", ("P0002", 6 + literal.len() as u32))
    };
    let large = assigned("99999999999999999999999999999999999999999");
    assert!(large.explains(&assigned("16#FFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFF")));
    assert!(large.explains(&assigned("INT#99999999999999999999999999999999999")));
    let program =
        "PROGRAM p\nVAR\nx : INT :=\n\n99999999999999999999999999999999999999; END_VAR\nEND_PROGRAM\n";
    assert!(large.explains(&rejected_otherwise(program, "P2026", ("P0002", 1))));
    // A valid statement that is rejected at its semicolon explains no other one.
    let moment = "PROGRAM p\nVAR\nx : TOD;\nEND_VAR\nx := TOD#00:00:00;\nEND_PROGRAM\n";
    let moment = deviating(
        moment,
        vec![Fact::Accepted],
        vec![diagnostic("P0002", Some(18))],
        Grade::Code,
    );
    let normal = Normal {
        innocent: vec!["TOD#00:00:00".to_owned()],
        ..Normal::unasked(&moment)
    };
    let moment = Essence::of(&moment, &normal);
    assert_eq!(moment.construct(), "statement");
    assert!(!moment.explains(&assigned("INT#99999999999999999999999999999999999")));
}

#[test]
fn what_a_conversion_gives_is_checked_for_all_conversions_or_for_none() {
    let accepted = |ty: &str, call: &str| accepted(ty, call, "P4027");
    let to_integer = accepted("BOOL", "DINT_TO_INT(0)");
    assert!(to_integer.explains(&accepted("INT", "INT_TO_REAL(0)")));
    assert!(!to_integer.explains(&accepted("INT", "SQRT(0.0)")));
}

#[test]
fn an_instance_is_told_apart_from_the_variable_of_var_in_out_that_is_passed_to_it() {
    let missing = |section: &str| {
        let program = format!(
            "FUNCTION_BLOCK b\n{section}\nx : INT;\nEND_VAR\nVAR\ny : INT;\nEND_VAR\ny := 0;\nEND_FUNCTION_BLOCK\n\
             PROGRAM p\nVAR\nf : b;\nz : INT;\nEND_VAR\nf(x := z);\nEND_PROGRAM\n"
        );
        let lacking = Fact::NotImplemented {
            reason: "P9999: not yet".to_owned(),
            promised_by: None,
        };
        let smallest = deviating(&program, vec![Fact::Accepted], vec![lacking], Grade::Line);
        unasked(&smallest).construct()
    };
    assert_eq!(missing("VAR_INPUT"), "instance of a function block");
    assert_eq!(missing("VAR_IN_OUT"), "VAR_IN_OUT, instance of a function block");
}

#[test]
fn a_place_that_converts_nothing_is_one_cause_whatever_the_types() {
    let of = |program: &str, name: &str| {
        let fact = |raw| Fact::Value {
            name: name.to_owned(),
            value: Value::plain(ElementaryType::Int, raw),
        };
        let smallest = deviating(program, vec![fact(2)], vec![fact(0)], Grade::Line);
        // The program without its statements assigns the variable to itself.
        let normal = Normal {
            program: program.replace("d := TRUE", "x := x"),
            ..Normal::unasked(&smallest)
        };
        Essence::of(&smallest, &normal)
    };
    let initial = |ty: &str, literal: &str| {
        let program =
            format!("PROGRAM p\nVAR\nx : {ty} := {literal};\nd : BOOL;\nEND_VAR\nd := TRUE;\nEND_PROGRAM\n");
        of(&program, "x")
    };
    let of_integer = initial("LREAL", "INT#2");
    assert!(of_integer.explains(&initial("LREAL", "REAL#2.0")));
    assert!(!of_integer.explains(&initial("LREAL", "LREAL#2.0")));
    assert!(!of_integer.explains(&initial("TIME", "LTIME#2s")));
    // Another variable of the program is no part of a plain initial value.
    let field = |other: &str| {
        let program = format!(
            "TYPE r :\nSTRUCT f : ULINT := 2; END_STRUCT; END_TYPE\nPROGRAM p\nVAR\nx : r; d : {other};\nEND_VAR\nd := d;\n\
             END_PROGRAM\n"
        );
        of(&program, "x.f")
    };
    assert_eq!(field("LINT").construct(), "STRUCT, initial value");
    assert!(field("BOOL").explains(&field("LINT")));
    let output = |from: &str, into: &str| {
        let block =
            format!("FUNCTION_BLOCK b\nVAR_OUTPUT\no : {from};\nEND_VAR\no := o;\nEND_FUNCTION_BLOCK\n");
        let program =
            format!("{block}PROGRAM p\nVAR\nx : {into};\ng : b;\nEND_VAR\ng(o => x);\nEND_PROGRAM\n");
        of(&program, "x")
    };
    assert!(output("INT", "REAL").explains(&output("INT", "LINT")));
    assert!(!output("INT", "REAL").explains(&of_integer));
    let assigned = |from: &str| {
        let program = format!("PROGRAM p\nVAR\nx : LREAL;\ny : {from};\nEND_VAR\nx := y;\nEND_PROGRAM\n");
        of(&program, "x")
    };
    assert!(!assigned("INT").explains(&assigned("REAL")));
    let to_element = of(
        "PROGRAM p\nVAR\nx : ARRAY[0..1] OF LREAL;\ny : INT;\nEND_VAR\nx[0] := y;\nEND_PROGRAM\n",
        "x[0]",
    );
    assert!(assigned("INT").explains(&to_element));
    assert!(!assigned("INT").explains(&of_integer));
}

/// Returns what matters of a program that must give `r := TRUE` and gives what is got.
fn computed(declarations: &str, statement: &str, got: Fact, labels: &[&str]) -> Essence {
    let program = format!("PROGRAM p\nVAR\n{declarations}\nEND_VAR\n{statement}\nEND_PROGRAM\n");
    let truth = |raw| Fact::Value {
        name: "r".to_owned(),
        value: Value::plain(ElementaryType::Bool, raw),
    };
    let smallest = deviating(&program, vec![truth(1)], vec![got, truth(0)], Grade::Line);
    let normal = Normal {
        labels: labels.iter().map(|label| (*label).to_owned()).collect(),
        ..Normal::unasked(&smallest)
    };
    Essence::of(&smallest, &normal)
}

#[test]
fn an_operation_of_two_kinds_is_one_cause_whether_it_stops_or_not() {
    let wrong = Fact::OtherValue { name: "r".to_owned() };
    let stops = Fact::Fault {
        fault: stickler_types::Fault::DivisionByZero,
        line: None,
    };
    let spans = "r, t : TIME := T#1s; f : REAL := 2.5;";
    let value = computed(spans, "r := t / f;", wrong, &["fraction"]);
    let fault = computed(spans, "r := t / f;", stops.clone(), &[]);
    assert!(value.explains(&fault));
    let plain = computed("r, a, b : INT;", "r := a / b;", stops, &[]);
    assert!(!plain.explains(&fault) && !fault.explains(&plain));
}

#[test]
fn the_size_of_unsigned_numbers_with_the_first_bit_does_not_matter_where_they_are_not_converted() {
    let wrong = || Fact::OtherValue { name: "r".to_owned() };
    let compared = |declarations: &str, label: &str| {
        computed(
            &format!("r : BOOL; {declarations}"),
            "r := a < b;",
            wrong(),
            &[label],
        )
    };
    let bytes = compared("a : BYTE := 128; b : BYTE;", "BYTE");
    assert!(bytes.explains(&compared(
        "a : ULINT := 18446744073709551610; b : ULINT;",
        "ULINT"
    )));
    assert!(!bytes.explains(&compared("a : ULINT := 5; b : ULINT;", "ULINT")));
}

#[test]
fn an_operator_whose_types_are_refused_is_refused_in_a_declaration_too() {
    let refused = |program: &str, line: u32| {
        let reported = Diagnostic {
            line: Some(line),
            message: "Cannot assign".to_owned(),
            ..Diagnostic::default()
        };
        let got = vec![Fact::Diagnostic(reported)];
        unasked(&deviating(program, vec![Fact::Accepted], got, Grade::Line))
    };
    let declared = refused(
        "PROGRAM p\nVAR\nx : UDINT := 0 + 0;\nEND_VAR\nx := x;\nEND_PROGRAM\n",
        3,
    );
    let assigned = "PROGRAM p\nVAR\nx : UDINT;\nEND_VAR\nx := 0 + 0;\nEND_PROGRAM\n";
    assert!(declared.explains(&refused(assigned, 5)));
    assert!(declared.explains(&refused(&assigned.replace("0 + 0", "+0"), 5)));
    assert!(!declared.explains(&refused(&assigned.replace("0 + 0", "0"), 5)));
    let of_dates = assigned
        .replace("UDINT;", "TIME;\nd : DATE;")
        .replace("0 + 0", "d - d");
    assert!(!declared.explains(&refused(&of_dates, 6)));
    // What is refused without an operator is refused with one too.
    let plain = refused(&assigned.replace("0 + 0", "0"), 5);
    assert!(plain.explains(&refused(assigned, 5)));
}

#[test]
fn times_of_day_and_durations_are_malformed_in_one_way_whatever_their_units() {
    let accepted = |ty: &str, literal: &str| accepted(ty, literal, "P0002");
    let short = accepted("TOD", "TOD#2:0");
    assert!(short.explains(&accepted("DT", "DT#2024-2-9-2:0")));
    assert!(!short.explains(&accepted("DT", "DT#2024-2-9")));
    let empty = accepted("TIME", "T#_d");
    assert!(empty.explains(&accepted("LTIME", "LTIME#_ms")));
    assert!(!empty.explains(&accepted("TIME", "T#1d1d")));
}

#[test]
fn a_function_that_a_parser_does_not_know_is_one_cause_whatever_it_is_given() {
    let given = |declared: &str, operand: &str| {
        let program = format!(
            "PROGRAM p\nVAR\n{declared} x : DT;\nEND_VAR\nx := DATE_TO_DT({operand});\nEND_PROGRAM\n"
        );
        let smallest = Smallest::rejected(&program, 5, "P0002");
        unasked(&smallest)
    };
    let variable = given("d : DATE;", "d");
    assert!(variable.explains(&given("", "DATE#2024-03-01")));
    assert_eq!(variable.construct(), "date_TO_dateandtime");
    let called = |ty: &str, call: &str| {
        let program = format!("PROGRAM p\nVAR\nx : {ty};\nEND_VAR\nx := {call};\nEND_PROGRAM\n");
        let smallest = Smallest::rejected(&program, 5, "P4017");
        unasked(&smallest)
    };
    let to_truth = called("BOOL", "REAL_TO_BOOL(0.0)");
    assert!(to_truth.explains(&called("REAL", "BOOL_TO_REAL(FALSE)")));
    assert!(!to_truth.explains(&called("INT", "REAL_TO_INT(0.0)")));
    let of_texts = called("STRING", "BOOL_TO_STRING(FALSE)");
    assert!(of_texts.explains(&called("TIME", "STRING_TO_TIME('')")));
    assert!(!of_texts.explains(&to_truth) && !of_texts.explains(&called("DT", "DATE_TO_DT(d)")));
    let greatest = called("INT", "MAX(0, 0, 0)");
    assert!(greatest.explains(&called("INT", "MIN(0, 0, 0)")));
    assert!(!greatest.explains(&called("INT", "LIMIT(0, 0, 0)")));
}

#[test]
fn a_header_that_cannot_be_read_is_one_cause_whatever_is_said_of_it() {
    let of = |reason: &str| {
        let program = "PROGRAM p\nVAR\nx : INT;\nEND_VAR\nx := 0;\nEND_PROGRAM\n";
        let reason = reason.to_owned();
        let smallest = deviating(
            program,
            vec![Fact::Accepted],
            vec![Fact::Unusable { reason }],
            Grade::Line,
        );
        unasked(&smallest)
    };
    let header = of("LOCATED.h:1:5: error: expected a semicolon before a type");
    assert!(header.explains(&of("LOCATED.h:1:1: error: unknown type name here")));
    assert!(!header.explains(&of("POUS.c:1:1: error: unknown type name here")));
}

#[test]
fn a_conversion_by_name_is_wrong_whatever_is_computed_beside_it_and_whichever_integers_it_gives() {
    let wrong = || Fact::OtherValue { name: "r".to_owned() };
    let of = |ty: &str, expression: &str| {
        let declarations = format!("r : {ty}; a, b : REAL;");
        computed(
            &declarations,
            &format!("r := {expression};"),
            wrong(),
            &["fraction"],
        )
    };
    let alone = of("INT", "REAL_TO_INT(a)");
    assert!(alone.explains(&of("INT", "REAL_TO_INT(a + b)")));
    assert!(alone.explains(&of("UDINT", "REAL_TO_UDINT(a)")));
    assert!(!alone.explains(&of("INT", "TRUNC(a)")));
}

#[test]
fn both_directions_of_a_shift_and_both_places_of_an_escape_are_one_cause_each() {
    let wrong = || Fact::OtherValue { name: "r".to_owned() };
    let shifted = |function: &str| computed("r : WORD;", &format!("r := {function}(r, 16);"), wrong(), &[]);
    assert!(shifted("SHL").explains(&shifted("SHR")) && shifted("ROL").explains(&shifted("ROR")));
    assert!(!shifted("SHL").explains(&shifted("ROL")));
    let assigned = computed("r : STRING;", "r := '$80';", wrong(), &[]);
    let begins = computed("r : STRING := '$80';", "r := r;", wrong(), &[]);
    assert!(assigned.explains(&begins));
}

#[test]
fn loops_that_do_not_end_are_one_cause_for_each_kind_of_loop() {
    let of = |statement: &str| {
        let program = format!("PROGRAM p\nVAR\nx : INT;\nEND_VAR\n{statement}\nEND_PROGRAM\n");
        let endless = vec![Fact::TimedOut { after_ms: 1000 }];
        let sign = Sign::of(
            &program,
            Verdict::Timeout,
            (&[Fact::Accepted], &endless),
            Grade::Line,
        );
        let mut smallest = deviating(&program, vec![Fact::Accepted], endless, Grade::Line);
        smallest.deviation.sign = sign;
        (unasked(&smallest), title(&smallest, false))
    };
    let (up, title) = of("FOR x := 1 TO 2 DO\nx := x + 1;\nEND_FOR;");
    assert!(title.starts_with("`FOR x := 1 TO 2 DO`"), "{title}");
    assert!(up.explains(&of("FOR x := 2 TO 1 BY -1 DO x := x; END_FOR;").0));
    assert!(!up.explains(&of("WHILE x < 2 DO x := x; END_WHILE;").0));
}
