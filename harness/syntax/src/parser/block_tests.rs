//! The statements that have statements in them.

use crate::parser::testing::{accepted_body, body_errors};
use crate::tree::StatementKind;

#[test]
fn if_has_branches() {
    let body = accepted_body("IF a THEN x := 1; ELSIF b THEN ELSIF c THEN ; ELSE y := 2; z := 3; END_IF;");
    let [
        StatementKind::If {
            branches,
            otherwise: Some(otherwise),
        },
    ] = &[&body[0].kind][..1]
    else {
        panic!("{body:?}")
    };
    assert_eq!((branches.len(), otherwise.len()), (3, 2));
}

#[test]
fn loops_have_bodies() {
    let body = accepted_body(
        "FOR i := 1 TO 10 DO x := i; END_FOR; FOR a[1] := 10 TO 1 BY -1 DO END_FOR;
         WHILE a < b DO END_WHILE; REPEAT ; UNTIL a END_REPEAT;",
    );
    assert!(matches!(body[0].kind, StatementKind::For { by: None, .. }));
    assert!(matches!(body[1].kind, StatementKind::For { by: Some(_), .. }));
    assert!(matches!(body[2].kind, StatementKind::While { .. }));
    assert!(matches!(body[3].kind, StatementKind::Repeat { .. }));
}

#[test]
fn case_labels_are_told_from_statements() {
    let body = accepted_body(
        "CASE n OF 1, 2, 5..7: x := 1; y := 2; RED: f(x); COLOR#GREEN: ; -5..-1: a.b := 1; a[1] := 2;
         A, B: LOW..HIGH: N + 1: g.h: 16#FF: INT#5: f((x), y := 1); F((1), g(2)): F(1)..F(2) * 3: f(x); ELSE x := 9;
         END_CASE;",
    );
    let StatementKind::Case {
        branches,
        otherwise: Some(_),
        ..
    } = &body[0].kind
    else {
        panic!("{body:?}")
    };
    let sizes: Vec<_> = branches
        .iter()
        .map(|branch| (branch.labels.len(), branch.body.len()))
        .collect();
    assert_eq!(
        sizes,
        [
            (3, 2),
            (1, 1),
            (1, 1),
            (1, 2),
            (2, 0),
            (1, 0),
            (1, 0),
            (1, 0),
            (1, 0),
            (1, 1),
            (1, 0),
            (1, 1)
        ]
    );
}

#[test]
fn a_broken_header_is_one_error_and_its_body_is_read() {
    for text in [
        "IF a + THEN x := ; END_IF;",
        "IF THEN x := ; END_IF;",
        "IF a b THEN x := ; END_IF;",
        "IF a\nx := ; END_IF;",
        "IF (a THEN x := ; END_IF;",
        "WHILE a + DO x := ; END_WHILE;",
        "FOR i = 1 TO 5 DO x := ; END_FOR;",
        "FOR i := 1 TO DO x := ; END_FOR;",
        "FOR i := 1 5 DO x := ; END_FOR;",
        "FOR 5 := 1 TO 5 DO x := ; END_FOR;",
        "REPEAT x := ; UNTIL a + END_REPEAT;",
        "REPEAT x := ; END_REPEAT;",
        "CASE a + OF 1: x := ; END_CASE;",
        "CASE a OF 1 + : x := ; END_CASE;",
        "CASE a OF y := 1; 1: x := ; END_CASE;",
    ] {
        let errors = body_errors(text);
        assert_eq!(errors.len(), 2, "{text}: {errors:?}");
    }
}

#[test]
fn a_missing_or_wrong_end_is_one_error() {
    for (text, error) in [
        (
            "IF a THEN x := 1;",
            "expected `END_IF`, found the keyword `END_PROGRAM`",
        ),
        (
            "IF a THEN x := 1; END_WHILE; y := 1;",
            "expected `END_IF`, found the keyword `END_WHILE`",
        ),
        (
            "WHILE a DO IF b THEN x := 1; END_WHILE;",
            "expected `END_IF`, found the keyword `END_WHILE`",
        ),
        (
            "IF a THEN WHILE b DO ELSE END_IF;",
            "expected `END_WHILE`, found the keyword `ELSE`",
        ),
        (
            "IF a THEN ELSE x := 1; ELSE y := 1; END_IF;",
            "expected a statement, found the keyword `ELSE`",
        ),
        (
            "CASE a OF 1: x := 1;",
            "expected `END_CASE`, found the keyword `END_PROGRAM`",
        ),
        (
            "IF a THEN IF b THEN IF c THEN",
            "expected `END_IF`, found the keyword `END_PROGRAM`",
        ),
        (
            "IF a THEN x := 1; ENDIF; y := 1;",
            "expected `END_IF`, found `ENDIF`",
        ),
        (
            "IF a THEN x := 1; ELSE x := 2; end if; y := 1;",
            "expected `END_IF`, found `end`",
        ),
        (
            "CASE a OF 1: x := 1; END CASE; y := 1;",
            "expected `END_CASE`, found `END`",
        ),
        (
            "CASE a OF EndCase; y := 1;",
            "expected `END_CASE`, found `EndCase`",
        ),
        (
            "FOR i := 1 TO 2 DO x := 1; ENDFOR; y := 1;",
            "expected `END_FOR`, found `ENDFOR`",
        ),
        (
            "WHILE a DO x := 1; END\nWHILE; y := 1;",
            "expected `END_WHILE`, found `END`",
        ),
        (
            "REPEAT x := 1; UNTIL a ENDREPEAT; y := 1;",
            "expected `END_REPEAT`, found `ENDREPEAT`",
        ),
        (
            "REPEAT x := 1; UNTIL a END REPEAT; y := 1;",
            "expected `END_REPEAT`, found `END`",
        ),
        (
            "IF a THEN WHILE b DO x := 1; ENDIF; y := 1;",
            "expected `END_WHILE`, found `ENDIF`",
        ),
        (
            "WHILE a DO x := 1; ENDFOR; y := 1;",
            "expected `END_WHILE`, found `ENDFOR`",
        ),
        (
            "CASE a 1: x := 1; 2: x := 2; END_CASE; y := 1;",
            "expected `OF`, found `1`",
        ),
        (
            "CASE a + 1\n RED: x := 1; 2: x := 2; END_CASE; y := 1;",
            "expected `OF`, found `RED`",
        ),
    ] {
        let errors = body_errors(text);
        assert!(
            matches!(errors.as_slice(), [only] if only.ends_with(error)),
            "{text}: {errors:?}"
        );
    }
}

#[test]
fn blocks_nest_to_the_limit_only() {
    let nested = |depth: usize| {
        format!(
            "{}x := 1;{}",
            "IF a THEN ".repeat(depth),
            " END_IF;".repeat(depth)
        )
    };
    assert_eq!(body_errors(&nested(200)), [""; 0]);
    assert_eq!(
        body_errors(&nested(201)),
        ["1:2001 S0002 nested more than 200 deep"]
    );
    assert_eq!(body_errors(&nested(100_000)).len(), 1);
    for open in [
        "IF a THEN ",
        "CASE a OF 1: ",
        "FOR i := 1 TO 2 DO ",
        "WHILE a DO ",
        "REPEAT ",
    ] {
        let errors = body_errors(&open.repeat(100_000));
        assert!(
            matches!(errors.as_slice(), [only] if only.contains("S0002")),
            "{open}: {errors:?}"
        );
    }
}

#[test]
fn a_variable_may_be_called_as_a_misspelt_end_is() {
    let body =
        accepted_body("IF a THEN ENDIF := 1; END_FOR_ := 2; end.x := 3; EndWhile(); END := 4; END_IF;");
    let StatementKind::If { branches, .. } = &body[0].kind else {
        panic!("{body:?}")
    };
    assert_eq!(branches[0].1.len(), 5);
    assert_eq!(
        body_errors("ENDIF;"),
        ["1:6 P0002 expected `:=` or a call, found `;`"]
    );
}
