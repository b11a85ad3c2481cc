//! Tests the reference over the wire protocol, with programs that no case contains. The expected values were worked out by
//! hand.

use serde_json::{Value as Json, json};
use stickler_engines::Reference;
use stickler_engines::protocol::serve;

fn talk(lines: &[Json]) -> Vec<Json> {
    let text: String = lines.iter().map(|line| format!("{line}\n")).collect();
    let mut output = Vec::new();
    serve(&Reference::new(), text.as_bytes(), &mut output).unwrap();
    String::from_utf8(output)
        .unwrap()
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect()
}

/// Returns the only reply to this request.
fn ask(request: Json) -> Json {
    let mut replies = talk(&[request]);
    assert_eq!(replies.len(), 1, "{replies:?}");
    replies.remove(0)
}

fn run(dialect: &str, source: &str, observe: &[&str]) -> Json {
    let observe: Vec<Json> = observe.iter().map(|name| json!({ "name": name })).collect();
    ask(json!({"type":"run","id":1,"dialect":dialect,"source":source,"observe":observe}))
}

#[test]
fn the_reference_speaks_all_dialects_and_can_do_everything() {
    let reply = ask(json!({"type":"hello","protocol":1}));
    let expected = json!({"type":"hello","protocol":1,"name":"reference","version":env!("CARGO_PKG_VERSION"),
        "dialects":["ironplc-ed2","ironplc-ed3","ironplc-rusty","matiec","plcnext","strucpp","rusty","codesys","twincat","logix","control-expert","omron",
            "iec-ed3","ironplc-ed2+cross-family-widening","ironplc-ed2+partial-access","ironplc-ed3+cross-family-widening",
            "ironplc-ed3-without-partial-access","ironplc-rusty-without-cross-family-widening","ironplc-rusty-without-partial-access"],
        "abilities":["check","execute","render","scans"],"grade":"code"});
    assert_eq!(reply, expected);
}

#[test]
fn a_program_with_functions_instances_and_arrays_is_executed() {
    let source = "
FUNCTION squares : DINT
VAR_INPUT n : INT; END_VAR
VAR i : INT; END_VAR
    FOR i := 1 TO n DO squares := squares + i * i; END_FOR;
END_FUNCTION
FUNCTION_BLOCK counter
VAR_INPUT step : INT; END_VAR
VAR_OUTPUT count : INT := 40; END_VAR
    count := count + step;
END_FUNCTION_BLOCK
PROGRAM main
VAR
    table : ARRAY[-1..1] OF INT := [5, 6, 7];
    c : counter;
    total : DINT;
    r : LREAL;
    name : STRING[10] := 'it$'s';
END_VAR
    c(step := 1);
    c(step := table[-1]);
    total := squares(n := 4);
    r := total;
    table[0] := table[0] - table[1];
END_PROGRAM
";
    let reply = run(
        "ironplc-ed2",
        source,
        &["total", "r", "table[0]", "c.count", "name"],
    );
    let values = json!({"total":"DINT#30","r":"LREAL#30.0","table[0]":"INT#-1","c.count":"INT#46",
        "name":"STRING#'it$'s'"});
    assert_eq!(reply, json!({"type":"executed","id":1,"values":values}));
}

#[test]
fn a_rejection_tells_every_place_with_a_suggestion_that_helps() {
    let source = "\
PROGRAM main
VAR
    small : INT;
    large : DINT := 70000;
END_VAR
    small := large;
    small := missing;
END_PROGRAM
";
    let reply = run("ironplc-ed2", source, &[]);
    assert_eq!(reply["type"], "rejected");
    let diagnostics = reply["diagnostics"].as_array().unwrap();
    let places: Vec<Json> = diagnostics
        .iter()
        .map(|d| json!([d["code"], d["line"], d["column"], d["end_column"]]))
        .collect();
    assert_eq!(places, [json!(["P4035", 6, 14, 19]), json!(["P4007", 7, 14, 21])]);
    assert_eq!(diagnostics[0]["suggestion"], "DINT_TO_INT(large)");
    let repaired = source
        .replace("small := large", "small := DINT_TO_INT(large)")
        .replace("missing", "small");
    assert_eq!(
        run("ironplc-ed2", &repaired, &["small"])["values"],
        json!({"small":"INT#4464"})
    );
}

#[test]
fn a_fault_tells_its_line_and_the_values_so_far() {
    let source = "\
PROGRAM main
VAR
    a : ARRAY[1..3] OF INT;
    i : INT := 1;
END_VAR
    WHILE TRUE DO
        a[i] := i;
        i := i + 1;
    END_WHILE;
END_PROGRAM
";
    let reply = run("matiec", source, &["i", "a[3]"]);
    let expected = json!({"type":"faulted","id":1,"fault":"subscript-range","line":7,
        "values":{"i":"INT#4","a[3]":"INT#3"}});
    assert_eq!(reply, expected);
}

#[test]
fn an_endless_program_ends_at_the_step_limit() {
    let source =
        "PROGRAM main\nVAR x : BOOL; END_VAR\nREPEAT\nx := NOT x;\nUNTIL FALSE END_REPEAT;\nEND_PROGRAM\n";
    assert_eq!(run("plcnext", source, &[])["fault"], "step-limit");
}

#[test]
fn more_scans_than_anyone_has_time_for_end_at_the_step_limit() {
    let reply = ask(
        json!({"type":"run","id":1,"dialect":"matiec","source":"PROGRAM main\nEND_PROGRAM\n",
        "scans":u32::MAX}),
    );
    assert_eq!(
        (&reply["fault"], &reply["line"]),
        (&json!("step-limit"), &json!(1))
    );
}

#[test]
fn scans_take_settings_and_are_observed_one_by_one() {
    let source = "\
PROGRAM main
VAR_INPUT step : INT := 1; END_VAR
VAR sum : INT; END_VAR
    sum := sum + step;
END_PROGRAM
";
    let reply = ask(
        json!({"type":"run","id":7,"dialect":"ironplc-ed3","source":source,"scans":4,
        "clock":[{"before":2,"value":"TIME#150ms"}],
        "set":[{"before":3,"name":"step","value":"INT#10"}],
        "observe":[{"name":"sum","type":"INT","after":2},{"name":"sum","after":3},{"name":"sum"},
            {"name":"step"}]}),
    );
    let values = json!({"sum@2":"INT#2","sum@3":"INT#12","sum":"INT#22","step":"INT#10"});
    assert_eq!(reply, json!({"type":"executed","id":7,"values":values}));
}

#[test]
fn check_accepts_what_has_no_program_and_run_does_not() {
    let source = "FUNCTION twice : INT\nVAR_INPUT x : INT; END_VAR\n    twice := 2 * x;\nEND_FUNCTION\n";
    let check = json!({"type":"check","id":3,"dialect":"ironplc-rusty","source":source});
    assert_eq!(ask(check), json!({"type":"accepted","id":3}));
    assert_eq!(run("ironplc-rusty", source, &[])["type"], "rejected");
}

#[test]
fn check_and_render_reject_what_cannot_be_read() {
    for verb in ["check", "render"] {
        let reply = ask(
            json!({"type":verb,"id":3,"dialect":"matiec","source":"PROGRAM main\n  x := ;\nEND_PROGRAM"}),
        );
        assert_eq!(
            (reply["type"].as_str(), reply["id"].as_u64()),
            (Some("rejected"), Some(3))
        );
        assert_eq!(reply["diagnostics"][0]["code"], "P0002");
        assert_eq!(reply["diagnostics"][0]["line"], 2);
    }
}

#[test]
fn rendered_text_is_normalised_and_renders_to_itself() {
    let source =
        "program Main var  W:WORD;(*gone*) b : bool; end_var b:=W.%X3; if b then W:=W; end_if; end_program";
    let render = |source: &str| {
        let reply = ask(json!({"type":"render","id":4,"dialect":"ironplc-ed3","source":source}));
        assert_eq!(reply["type"], "rendered", "{reply}");
        reply["text"].as_str().unwrap().to_owned()
    };
    let text = render(source);
    let lines: Vec<&str> = text.lines().map(str::trim).collect();
    for line in [
        "PROGRAM Main",
        "W : WORD;",
        "b := W.3;",
        "IF b THEN",
        "END_IF;",
        "END_PROGRAM",
    ] {
        assert!(lines.contains(&line), "{line} is not in\n{text}");
    }
    assert!(!text.contains("gone"));
    assert_eq!(render(&text), text);
}

#[test]
fn a_name_that_is_not_there_is_an_error_of_that_request_alone() {
    let source = "PROGRAM main\nVAR x : INT := 5; a : ARRAY[1..2] OF INT; END_VAR\nEND_PROGRAM\n";
    let request = |id: u64, name: &str| {
        let observe = json!([{"name":name,"type":"INT"}]);
        json!({"type":"run","id":id,"dialect":"matiec","source":source,"observe":observe})
    };
    let names = ["y", "x.z", "a", "a[3]", "x[1]", "", "a[", "a[1", "[1]", "x", "X"];
    let requests: Vec<Json> = (1..).zip(names).map(|(id, name)| request(id, name)).collect();
    let replies = talk(&requests);
    for (reply, id) in replies.iter().zip(1..10) {
        assert_eq!(
            (&reply["type"], &reply["id"]),
            (&json!("error"), &json!(id)),
            "{reply}"
        );
    }
    assert_eq!(replies[9]["values"], json!({"x":"INT#5"}));
    assert_eq!(replies[10]["values"], json!({"X":"INT#5"}));
}

#[test]
fn a_setting_that_does_not_fit_is_an_error_of_that_request_alone() {
    let source = "PROGRAM main\nVAR x : INT; END_VAR\nEND_PROGRAM\n";
    for (name, value) in [
        ("y", "INT#1"),
        ("x", "DINT#1"),
        ("x", "BOOL#TRUE"),
        ("x", "COLOR#RED"),
    ] {
        let reply = ask(json!({"type":"run","id":2,"dialect":"matiec","source":source,
            "set":[{"before":1,"name":name,"value":value}]}));
        assert_eq!(
            (&reply["type"], &reply["id"]),
            (&json!("error"), &json!(2)),
            "{reply}"
        );
    }
}

#[test]
fn any_text_as_a_program_is_answered_by_a_reply_with_its_id() {
    let sources = [
        String::new(),
        "\u{0}\u{FEFF}\u{FFFD}é".to_owned(),
        "(*".repeat(1000),
        "PROGRAM main\nVAR x : INT; END_VAR\nx := ".to_owned() + &"(".repeat(20_000),
        "'".to_owned() + &"x".repeat(100_000),
        "PROGRAM PROGRAM PROGRAM ; ; END_IF END_VAR".to_owned(),
    ];
    for source in &sources {
        for verb in ["run", "check", "render"] {
            let reply = ask(json!({"type":verb,"id":11,"dialect":"ironplc-rusty","source":source}));
            assert_eq!(reply["id"], 11, "{reply}");
            assert_ne!(reply["type"], "error", "{reply}");
        }
    }
}
