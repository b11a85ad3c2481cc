//! The one spelling.

use super::render;
use crate::parse;
use stickler_types::{Dialect, DialectName};

/// The rendered text, which renders to itself.
fn rendered(text: &str) -> String {
    let (unit, diagnostics) = parse(text, Dialect::of(DialectName::IRONPLC_ED3));
    assert_eq!(diagnostics, [], "{text}");
    let once = render(&unit, text);
    let (again, diagnostics) = parse(&once, Dialect::of(DialectName::IRONPLC_ED3));
    assert_eq!(diagnostics, [], "{once}");
    assert_eq!(render(&again, &once), once);
    once
}

/// The rendered body of a program with these declarations.
fn body(declarations: &str, body: &str) -> String {
    let text = rendered(&format!("PROGRAM p {declarations} {body} END_PROGRAM"));
    let lines = text
        .lines()
        .skip_while(|line| *line != "END_VAR")
        .skip(1)
        .take_while(|line| *line != "END_PROGRAM");
    lines
        .map(|line| line.strip_prefix("    ").unwrap_or(line))
        .collect::<Vec<_>>()
        .join("\n")
}

#[test]
fn a_program_is_written_in_one_spelling() {
    let text = "program Main (* comment *) var constant Limit:int:=5;end_var var A,b:BOOL;end_var
        if a then B:=not(A);elsif b then;else return;end_if;end_program";
    assert_eq!(
        rendered(text),
        "PROGRAM Main\nVAR CONSTANT\n    Limit : INT := 5;\nEND_VAR\nVAR\n    A, b : BOOL;\nEND_VAR
    IF A THEN\n        b := NOT (A);\n    ELSIF b THEN\n        ;\n    ELSE\n        RETURN;\n    END_IF;
END_PROGRAM\n"
    );
}

#[test]
fn bits_come_back_in_the_short_form() {
    let declarations = "VAR w : WORD; a : ARRAY[0..1] OF BYTE; END_VAR";
    assert_eq!(
        body(declarations, "w.%X3 := a[ 0 ].%x07; W.%5 := w.15;"),
        "w.3 := a[0].7;\nw.5 := w.15;"
    );
}

#[test]
fn subscripts_have_no_spaces() {
    let declarations = "VAR i : INT; END_VAR";
    assert_eq!(
        body(
            declarations,
            "m[ I + 1 , f( i,j := 2 ) ] := m[i MOD 2, -i * (i - 1)];"
        ),
        "m[i+1,f(i,j:=2)] := m[i MOD 2,-i*(i-1)];"
    );
}

#[test]
fn names_are_written_as_declared() {
    let text = "TYPE Color : (Red, Green); Rec : STRUCT Field : ARRAY[0..1] OF Rec2; END_STRUCT;
          Rec2 : STRUCT Inner : INT; END_STRUCT; END_TYPE
        FUNCTION_BLOCK Block VAR_INPUT In : INT; END_VAR VAR_OUTPUT Out : INT; END_VAR END_FUNCTION_BLOCK
        FUNCTION Twice : INT VAR_INPUT Value : INT; END_VAR TWICE := VALUE + value; END_FUNCTION
        VAR_GLOBAL Shared : REC := (FIELD := [2((INNER := 1))]); END_VAR
        PROGRAM p VAR C : COLOR := RED; Fb : BLOCK; END_VAR
        c := color#green; shared.field[1].inner := twice(value := 5); FB(IN := 1, out => SHARED.field[0].INNER);
        unknown.Thing := fb.OUT; END_PROGRAM";
    let lines = rendered(text);
    for line in [
        "    TWICE := VALUE + value;"
            .replace("TWICE", "Twice")
            .replace("VALUE", "Value")
            .replace("value", "Value")
            .as_str(),
        "    Shared : Rec := (Field := [2((Inner := 1))]);",
        "    C : Color := Red;",
        "    C := Color#Green;",
        "    Shared.Field[1].Inner := Twice(Value := 5);",
        "    Fb(In := 1, Out => Shared.Field[0].Inner);",
        "    unknown.Thing := Fb.Out;",
    ] {
        assert!(lines.lines().any(|written| written == line), "{line}\n{lines}");
    }
}

#[test]
fn literals_stand_as_written_but_for_their_prefix() {
    assert_eq!(
        body(
            "VAR END_VAR",
            "x := int#-5 + word#16#fF + t#1h_5m + true + bool#false + 'a$'b' + 1_0.5e3;"
        ),
        "x := INT#-5 + WORD#16#fF + T#1h_5m + TRUE + BOOL#FALSE + 'a$'b' + 1_0.5e3;"
    );
}

#[test]
fn every_statement_has_its_lines() {
    let text = "case N of 1,2..5:x:=1;red:;else end_case;for i:=1 to 10 by 2 do exit;end_for;
        while a do continue;end_while;repeat f(); until a and b end_repeat;";
    assert_eq!(
        body("VAR n : INT; END_VAR", text),
        "CASE n OF\n    1, 2..5:\n        x := 1;\n    red:\n        ;\nELSE\nEND_CASE;
FOR i := 1 TO 10 BY 2 DO\n    EXIT;\nEND_FOR;\nWHILE a DO\n    CONTINUE;\nEND_WHILE;
REPEAT\n    f();\nUNTIL a AND b\nEND_REPEAT;"
    );
}

#[test]
fn locations_are_written_in_capitals() {
    assert_eq!(
        rendered("program p var x at %mw5:int:=3;end_var end_program"),
        "PROGRAM p\nVAR\n    x AT %MW5 : INT := 3;\nEND_VAR\nEND_PROGRAM\n"
    );
}

#[test]
fn types_and_configurations_are_written_out() {
    let text = "type S:struct a:string[ 10 ]:='x';b:int(-5..5);end_struct;E:int(A:=1,B);end_type
        configuration C var_global g:array[1..2 , 0..1]of lint:=[1,2(0)];end_var
        resource R on PLC task T1(interval:=t#10ms,priority:=1);program P1 with t1:MAIN;end_resource end_configuration
        program Main end_program";
    assert_eq!(
        rendered(text),
        "TYPE\n    S : STRUCT\n        a : STRING[10] := 'x';\n        b : INT(-5..5);\n    END_STRUCT;
    E : INT (A := 1, B);\nEND_TYPE

CONFIGURATION C\n    VAR_GLOBAL\n        g : ARRAY[1..2,0..1] OF LINT := [1, 2(0)];\n    END_VAR
    RESOURCE R ON PLC\n        TASK T1(INTERVAL := t#10ms, PRIORITY := 1);\n        PROGRAM P1 WITH T1 : Main;
    END_RESOURCE\nEND_CONFIGURATION\n\nPROGRAM Main\nEND_PROGRAM\n"
            .replace("t#10ms", "T#10ms")
    );
}

#[test]
fn a_long_chain_is_written_without_recursion() {
    let chain = format!("x := 1{};", " + 1".repeat(300_000));
    assert_eq!(body("VAR END_VAR", &chain), chain);
}
