//! Tests of `driver.rs`.

use super::*;
use crate::{ClockSetting, Observation};
use stickler_types::DialectName;

fn observation(name: &str, type_name: &str) -> Observation {
    Observation::last(name, type_name)
}

/// Returns the driver of one program.
fn alone<'r>(request: &RunRequest<'r>) -> Result<Driver<'r>, String> {
    driver(&[MatiecSubject {
        request: *request,
        probes: &ProbeVariables::of(request),
        program: "main".to_owned(),
    }])
}

fn request(observe: &[Observation]) -> RunRequest<'_> {
    RunRequest {
        scans: 3,
        ..RunRequest::once(
            DialectName::MATIEC,
            "TYPE COLOR : (RED, GREEN); END_TYPE",
            observe,
        )
    }
}

#[test]
fn values_are_read_as_the_driver_prints_them() {
    let observe = [
        observation("i", "INT"),
        observation("r", "REAL"),
        observation("t", "TIME"),
        observation("s", "STRING"),
        observation("c", "COLOR"),
        observation("b", "BOOL"),
    ];
    let request = request(&observe);
    let driver = alone(&request).unwrap();
    let printed = "1 3fc00000\n0 ffff\n2 1 500000000\n3 '6127\n4 1\n5 1\n";
    let values = driver.values(printed, &driver.subjects[0]).unwrap();
    let values: Vec<String> = values
        .iter()
        .map(|(name, value)| format!("{name}={value}"))
        .collect();
    assert_eq!(
        values,
        [
            "i=INT#-1",
            "r=REAL#1.5",
            "t=TIME#1500ms",
            "s=STRING#'a$''",
            "c=COLOR#GREEN",
            "b=BOOL#TRUE"
        ]
    );
    for nonsense in ["0 ffff\n", "7 0\n", "0\n", "x 0\n", "0 gg\n", "4 9\n", "3 61\n"] {
        assert!(
            driver.values(nonsense, &driver.subjects[0]).is_err(),
            "{nonsense}"
        );
    }
    let beyond = |printed: &str| {
        let all = format!("{printed}\n0 ffff\n1 0\n3 '\n4 1\n5 1\n");
        driver.values(&all, &driver.subjects[0]).unwrap()[2].1.to_string()
    };
    assert_eq!(beyond("2 9223372036854 0"), "TIME#9223372036854000000000ns");
    assert_eq!(beyond("2 9223372036854 1"), "TIME#9223372036854000000001ns");
}

#[test]
fn each_value_is_printed_behind_its_scan_and_paths_from_their_copies() {
    let early = Observation {
        after: Some(2),
        ..observation("a[1]", "INT")
    };
    let observe = [
        observation("x", "TIME"),
        early,
        observation("a[1]", "INT"),
        observation("r.f", "BYTE"),
    ];
    let request = RunRequest {
        clock: &[ClockSetting {
            before: 2,
            nanoseconds: 1_500_000_000,
        }],
        set: &[Setting {
            before: 3,
            name: "in".into(),
            value: Value::parse("INT#-2").unwrap(),
        }],
        ..request(&observe)
    };
    let driver = alone(&request).unwrap();
    for line in [
        "MAIN p0;",
        "if (scan == 0UL) print_time(0, memory.program.p0.X.value);",
        "if (scan == 2UL) print_bits(1, &memory.program.p0.STICKLER_PROBE_0.value, sizeof memory.program.p0.STICKLER_PROBE_0.value);",
        "if (scan == 0UL) print_bits(2, &memory.program.p0.STICKLER_PROBE_0.value, sizeof memory.program.p0.STICKLER_PROBE_0.value);",
        "if (scan == 0UL) print_bits(3, &memory.program.p0.STICKLER_PROBE_1.value, sizeof memory.program.p0.STICKLER_PROBE_1.value);",
        "if (scan == 2UL) { __CURRENT_TIME = (TIME){1, 500000000}; }",
        "if (scan == 3UL) { unsigned long long bits = 18446744073709551614ULL;",
        "scan <= 3UL;",
    ] {
        assert!(driver.text.contains(line), "{line}\n{}", driver.text);
    }
}

#[test]
fn a_configuration_of_the_program_is_initialised_and_run() {
    let source = "PROGRAM main ; END_PROGRAM CONFIGURATION Plant RESOURCE Station ON PLC PROGRAM i : main; END_RESOURCE \
                  END_CONFIGURATION";
    let observe = [observation("x", "INT")];
    let request = RunRequest {
        source,
        ..request(&observe)
    };
    let driver = alone(&request).unwrap();
    for line in [
        "#include \"Plant.c\"\n#include \"Station.c\"\n",
        "config_init__();",
        "config_run__(scan - 1);",
        "print_bits(0, &STATION__I.X.value, sizeof STATION__I.X.value);",
    ] {
        assert!(driver.text.contains(line), "{line}\n{}", driver.text);
    }
    assert!(
        !driver.text.contains("POUS") && !driver.text.contains("memory"),
        "{}",
        driver.text
    );
}

#[test]
fn a_variable_with_a_location_and_an_external_one_are_pointers() {
    let source = "PROGRAM other VAR y AT %MW2 : INT; END_VAR END_PROGRAM \
                  PROGRAM main VAR x AT %MW1 : INT; y : INT; END_VAR VAR_EXTERNAL g : INT; END_VAR VAR z : INT; END_VAR END_PROGRAM";
    let request = RunRequest::once(DialectName::MATIEC, source, &[]);
    for (variable, expression) in [
        ("x", "(*p.X.value)"),
        ("y", "p.Y.value"),
        ("g", "(*p.G.value)"),
        ("z", "p.Z.value"),
    ] {
        assert_eq!(place("p", variable, &request), expression);
    }
}

#[test]
fn several_programs_have_a_number_each_and_one_place() {
    let observe = [observation("x", "INT")];
    let request = request(&observe);
    let probes = ProbeVariables::of(&request);
    let subject = |program: &str| MatiecSubject {
        request,
        probes: &probes,
        program: program.to_owned(),
    };
    let driver = driver(&[subject("first"), subject("second")]).unwrap();
    for line in [
        "FIRST p0;",
        "SECOND p1;",
        "SECOND_body__(&memory.program.p1);",
        "print_bits(0, &memory.program.p1.X.value, sizeof memory.program.p1.X.value);",
        "case 1: return run_1();",
    ] {
        assert!(driver.text.contains(line), "{line}\n{}", driver.text);
    }
}

#[test]
fn what_cannot_be_shown_or_set_is_told() {
    for (type_name, part) in [
        ("LTIME", "LTIME"),
        ("WSTRING", "WSTRING"),
        ("", "not given"),
        ("SHAPE", "SHAPE"),
    ] {
        let observe = [observation("x", type_name)];
        let request = request(&observe);
        let reason = alone(&request).err().unwrap();
        assert!(reason.contains(part), "{reason}");
    }
}
