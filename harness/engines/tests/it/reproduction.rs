//! Tests reproductions: their files, and what their scripts print where the compiler is here.

use crate::compilers::here;
use crate::fixture::{Asked, block, shown};
use std::fs;
use std::path::Path;
use stickler_engines::{Ability, Compiler, Description, Engine, Reproduction, RunRequest, reproduce_and_run};
use stickler_mdtest::sections;
use stickler_types::DialectName;

const SOURCE: &str = "TYPE PAIR : STRUCT a : INT; b : DINT; END_STRUCT; END_TYPE\n\
                      PROGRAM main\nVAR\n    n : INT;\n    x : BOOL;\n    list : ARRAY[1..2] OF INT;\n    both : PAIR;\n    \
                      ratio : REAL := 0.1;\nEND_VAR\n    n := n - 1;\n    x := n < -1;\n    list[2] := n;\n    \
                      both.b := 7;\nEND_PROGRAM\n";

fn dialect(compiler: Compiler) -> DialectName {
    match compiler {
        Compiler::Ironplc => DialectName::IRONPLC_ED3,
        Compiler::Matiec => DialectName::MATIEC,
        Compiler::Strucpp => DialectName::STRUCPP,
        Compiler::Rusty => DialectName::RUSTY,
    }
}

/// Runs the script of a reproduction. Returns all that it printed.
fn run(reproduction: &Reproduction, engine: &dyn Engine) -> String {
    let tools = engine.tools();
    let printed = reproduction.run(&tools).unwrap().text;
    assert!(!printed.contains("/stickler-"), "{printed}");
    for (variable, path) in tools {
        assert!(
            !printed.contains(&*path.to_string_lossy()),
            "{variable}: {printed}"
        );
    }
    printed
}

#[test]
fn a_script_prints_the_values_of_a_program_without_stickler() {
    let asked = "run 2 scans: n INT, n@1 INT, x BOOL, list[2] INT, both.b DINT, ratio REAL";
    for compiler in Compiler::ALL {
        let asked = Asked::read(asked, dialect(compiler));
        let request = asked.of(SOURCE);
        let reproduction = compiler.reproduce(&request, Ability::Execute).unwrap();
        let Some(engine) = here(compiler) else { continue };
        let printed = run(&reproduction, &*engine);
        let expected: &[&str] = match compiler {
            Compiler::Ironplc => &[
                "n: -1",
                "n: -2",
                "x: TRUE",
                "stickler_probe_0: -2",
                "stickler_probe_1: 7",
                "ratio: 0.1",
            ],
            _ => &[
                "n@1 = -1",
                "n = -2",
                "x = 1",
                "list[2] = -2",
                "both.b = 7",
                "ratio = 0.100000001",
            ],
        };
        for line in expected {
            assert!(
                printed.lines().any(|printed| printed == *line),
                "{line}: {printed}\n{reproduction:#?}"
            );
        }
    }
}

#[test]
fn a_script_shows_whether_a_program_is_accepted() {
    let wrong = SOURCE.replace("n - 1", "n - unknown");
    for compiler in Compiler::ALL {
        let Some(engine) = here(compiler) else { continue };
        for (source, accepted) in [(SOURCE, true), (&wrong, false)] {
            let request = RunRequest::once(dialect(compiler), source, &[]);
            // What is rejected is shown without what an execution needs.
            let asked = if accepted {
                Ability::Check
            } else {
                Ability::Execute
            };
            let (reproduction, output) = reproduce_and_run(&*engine, &request, asked).unwrap();
            assert_eq!(
                reproduction,
                compiler.reproduce(&request, Ability::Check).unwrap()
            );
            assert_eq!(reproduction.files[0].text, source);
            assert_eq!(output.unwrap().succeeded, accepted);
            let printed = run(&reproduction, &*engine);
            assert_eq!(
                printed.contains("The program is accepted."),
                accepted,
                "{printed}\n{reproduction:#?}"
            );
            // Of `program.st:10`, wherever a compiler says it.
            assert_eq!(printed.contains("10"), !accepted, "{printed}");
        }
    }
}

#[test]
fn golden_reproductions_are_those_of_the_adapters() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    let text = fs::read_to_string(folder.join("reproductions.md")).unwrap();
    let mut differences = Vec::new();
    for test in &sections(&text).unwrap()[1..] {
        let source = block(test, "st").unwrap();
        let reproductions: Vec<String> = test
            .rows
            .iter()
            .map(|row| {
                let [engine, asked] = &row.cells[..] else {
                    panic!("{:?}", row.cells)
                };
                let asked = Asked::read(asked, DialectName::MATIEC);
                let ability = match asked.verb.as_str() {
                    "check" => Ability::Check,
                    "render" => Ability::Render,
                    _ => Ability::Execute,
                };
                let request = asked.of(&source);
                let reproduction = match Compiler::from_word(engine) {
                    Some(compiler) => compiler.reproduce(&request, ability),
                    None => {
                        let table: Description = toml::from_str(&block(test, "toml").unwrap()).unwrap();
                        table.reproduce(&request, ability)
                    }
                };
                match reproduction {
                    Ok(shown) => shown
                        .files
                        .iter()
                        .chain([&shown.script()])
                        .map(|file| format!("=== {}\n{}", file.name, file.text))
                        .collect(),
                    Err(reason) => format!("=== none\n{reason}\n"),
                }
            })
            .collect();
        let found = reproductions.concat();
        let file = folder.join(format!("reproductions/{}.txt", test.heading.replace(' ', "-")));
        if std::env::var_os("STICKLER_BLESS").is_some() {
            fs::write(&file, &found).unwrap();
        }
        let golden = fs::read_to_string(&file)
            .unwrap_or_default()
            .replace("\r\n", "\n");
        if golden != found {
            differences.push(format!(
                "{}: `cargo xtask bless` writes it\n{found}",
                file.display()
            ));
        }
    }
    assert!(differences.is_empty(), "{}", differences.join("\n"));
}

/// The program has its globals from its own configuration, for an adapter as for a person.
#[test]
fn a_configuration_of_the_program_is_used() {
    let source = "PROGRAM main\nVAR_EXTERNAL\n    shared : INT;\nEND_VAR\nVAR\n    seen : INT;\nEND_VAR\n    \
                  shared := shared + 2;\n    seen := shared;\nEND_PROGRAM\nCONFIGURATION Plant\n    \
                  VAR_GLOBAL\n        shared : INT := 40;\n    END_VAR\n    RESOURCE Station ON PLC\n        \
                  TASK Cyclic(INTERVAL := T#10ms, PRIORITY := 1);\n        PROGRAM instance WITH Cyclic : main;\n    \
                  END_RESOURCE\nEND_CONFIGURATION\n";
    // RuSTy documents no configurations.
    for compiler in [Compiler::Ironplc, Compiler::Matiec, Compiler::Strucpp] {
        let Some(engine) = here(compiler) else { continue };
        let asked = Asked::read("run 2 scans: seen INT, seen@1 INT", dialect(compiler));
        let request = asked.of(source);
        let outcome = engine.session().unwrap().run(&request);
        assert_eq!(
            shown(&outcome),
            "executed seen = INT#44, seen@1 = INT#42",
            "{}",
            compiler.as_str()
        );
        let reproduction = compiler.reproduce(&request, Ability::Execute).unwrap();
        let printed = run(&reproduction, &*engine);
        for value in ["42", "44"] {
            assert!(printed.contains(value), "{printed}\n{reproduction:#?}");
        }
    }
}
