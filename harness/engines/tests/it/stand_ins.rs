//! Tests engines with scripts that stand in for their programs: `tests/stand-ins/*.md`, which [`fixture`](crate::fixture) reads.

use crate::fixture::{Asked, block, files, shown};
use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::Duration;
use stickler_engines::{
    Compiler, DependencyPaths, DescribedEngine, Description, Engine, Grade, Outcome, Packed, ProcessEngine,
    ProcessLimits,
};
use stickler_mdtest::{Section, fits};
use stickler_types::join;
use tempfile::TempDir;

/// Limits that suffice on a busy machine; a section with a program that hangs has shorter ones.
pub const LIMITS: ProcessLimits = ProcessLimits {
    hello: Duration::from_secs(60),
    reply: Duration::from_secs(60),
    line: 1 << 16,
    memory: 4 << 30,
};

/// Writes the files of a section into a folder; those in `sh` are programs.
fn write(section: &Section, folder: &Path) {
    for block in &section.blocks {
        let Some((language, name)) = block.info.split_once(' ') else {
            continue;
        };
        let (file, text) = (folder.join(name), format!("{}\n", block.text));
        fs::create_dir_all(file.parent().unwrap()).unwrap();
        if language != "sh" {
            fs::write(file, text).unwrap();
            continue;
        }
        // Another process writes the program: one that this process still had open for writing, in a child that another test is
        // just starting, could not be run.
        let script = r#"printf '#!/bin/sh\n%s' "$1" >"$2" && chmod 700 "$2""#;
        let written = Command::new("sh")
            .args(["-c", script, "sh", &text])
            .arg(file)
            .status();
        assert!(written.unwrap().success());
    }
}

/// Returns the engine of the files in a folder, or why there is none.
fn engine(kind: &str, section: &Section, folder: &Path) -> Result<Box<dyn Engine>, String> {
    let engine = match Compiler::from_word(kind) {
        Some(compiler) => {
            let named = |paths: DependencyPaths, dependency: &stickler_engines::Dependency| {
                let path = folder.join(&dependency.key);
                match path.is_file() {
                    true => paths.named(&dependency.key, path, "a test".to_owned()),
                    false => paths,
                }
            };
            let paths = compiler.dependencies().fold(DependencyPaths::default(), named);
            compiler.seek(kind, kind, &paths.without_variables()).engine
        }
        None if kind == "described" => {
            let table = block(section, "toml").expect("a table");
            let description: Description = toml::from_str(&table).map_err(|error| error.to_string())?;
            description
                .check()
                .map_err(|(key, reason)| format!("{key}: {reason}"))?;
            let started = DescribedEngine::start("mine", description, folder);
            started.map(|engine| Box::new(engine) as Box<dyn Engine>)
        }
        None => {
            let number = |key: &str| {
                let limits = block(section, "toml").unwrap_or_default();
                let limits: toml::Table = limits.parse().unwrap();
                limits
                    .get(key)
                    .map(|value| value.as_integer().unwrap().unsigned_abs())
            };
            let limits = ProcessLimits {
                reply: number("reply_ms").map_or(LIMITS.reply, Duration::from_millis),
                memory: number("memory").unwrap_or(LIMITS.memory),
                ..LIMITS
            };
            let unruly = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/adapters/unruly.sh");
            let own = folder.join("adapter");
            let script = if own.is_file() { own } else { unruly };
            let written = block(section, "toml command");
            let line = written.unwrap_or_else(|| format!("sh '{}'", script.display()));
            let started = ProcessEngine::start(line.trim_end(), limits);
            started.map(|engine| Box::new(engine) as Box<dyn Engine>)
        }
    };
    engine.map_err(|error| error.to_string())
}

/// Returns the program of a row.
fn source(test: &Section, please: &str) -> String {
    let plain = || format!("PROGRAM main\n(* please: {please} *)\nEND_PROGRAM\n");
    block(test, "st").unwrap_or_else(plain)
}

/// Runs a test on an engine. Returns the rows whose outcome is another, with that.
fn failures(engine: &dyn Engine, test: &Section) -> Vec<String> {
    let mut session = engine.session().unwrap();
    let dialect = engine.identity().dialects[0];
    let rows: Vec<(String, Asked, &String)> = test
        .rows
        .iter()
        .map(|row| match &row.cells[..] {
            [please, asked, expected] => (source(test, please), Asked::read(asked, dialect), expected),
            other => panic!("{}: {other:?}", test.heading),
        })
        .collect();
    let packed = rows.iter().filter(|(_, asked, _)| asked.verb == "packed");
    let requests: Vec<_> = packed.map(|(source, asked, _)| asked.of(source)).collect();
    let mut packed = session.run_pack(&requests).into_iter();
    let mut failures = Vec::new();
    for (row, (source, asked, expected)) in test.rows.iter().zip(&rows) {
        let mut check = |shown: &str| {
            if !fits(expected, shown) {
                failures.push(format!("  {}\n  gives     {shown}", row.cells.join(" | ")));
            }
        };
        let outcome = match asked.verb.as_str() {
            "name" => {
                check(&engine.identity().name);
                continue;
            }
            "identity" => {
                let identity = engine.identity();
                let abilities = join(&identity.abilities, " ");
                check(&format!("{} {abilities} {}", identity.version, identity.grade));
                continue;
            }
            "packed" => match packed.next() {
                Some(Packed::Answered(outcome)) => outcome,
                other => panic!("{}: {other:?}", test.heading),
            },
            _ => asked.ask(session.as_mut(), source),
        };
        check(&shown(&outcome));
    }
    failures
}

/// Runs all tests of a file. A test with a block `text` has no engine: the block says why.
fn run(file: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/stand-ins")
        .join(file);
    let text = fs::read_to_string(&path).unwrap();
    let mut failed = Vec::new();
    for (head, tests) in files(&text) {
        // Only Linux tells how much memory a process holds.
        let told = cfg!(target_os = "linux") || !head.heading.contains("memory");
        for test in tests.iter().filter(|_| told) {
            let folder = TempDir::new().unwrap();
            write(&head, folder.path());
            write(test, folder.path());
            let has_table = test.blocks.iter().any(|block| block.info.starts_with("toml"));
            let described = if has_table { test } else { &head };
            let engine = engine(file.trim_end_matches(".md"), described, folder.path());
            let failures = match (engine, block(test, "text")) {
                (Ok(engine), None) => failures(engine.as_ref(), test),
                (Err(reason), None) if reason.contains("there is no `cc`") => continue,
                (Err(reason), Some(expected)) if fits(expected.trim_end(), reason.trim_end()) => Vec::new(),
                (Err(reason), _) => vec![format!("  there is no engine: {reason}")],
                (Ok(_), Some(_)) => vec!["  there is an engine".to_owned()],
            };
            let named = |failure| format!("{file}: {} / {}\n{failure}", head.heading, test.heading);
            failed.extend(failures.into_iter().map(named));
        }
    }
    assert!(failed.is_empty(), "\n{}", failed.join("\n"));
}

#[test]
fn ironplc() {
    run("ironplc.md");
}

#[test]
fn matiec() {
    run("matiec.md");
}

#[test]
fn rusty() {
    run("rusty.md");
}

#[test]
fn described() {
    run("described.md");
}

#[test]
fn process() {
    run("process.md");
}

/// The checking half of the adapter `ironplc` needs no code: its table gives the same outcomes.
#[test]
fn a_description_of_ironplc_does_what_its_adapter_does() {
    let text =
        fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/stand-ins/ironplc.md")).unwrap();
    let (head, _) = &files(&text)[0];
    let folder = TempDir::new().unwrap();
    write(head, folder.path());
    let adapter = engine("ironplc", head, folder.path()).unwrap();
    let table = include_str!("../described/ironplc.toml");
    // Nothing says what its codes mean.
    let without_grade: String = table
        .lines()
        .filter(|line| !line.starts_with("grade"))
        .map(|line| format!("{line}\n"))
        .collect();
    let described = toml::from_str(&without_grade).unwrap();
    let described = DescribedEngine::start("mine", described, folder.path()).unwrap();
    assert_eq!(described.identity().grade, Grade::Line);
    let described = toml::from_str(table).unwrap();
    let described = DescribedEngine::start("mine", described, folder.path()).unwrap();
    assert_eq!(described.identity().grade, adapter.identity().grade);
    let dialect = described.identity().dialects[0];
    let check = |engine: &dyn Engine, please: &str| {
        let source = format!("PROGRAM main\n(* please: {please} *)\nEND_PROGRAM\n");
        engine.session().unwrap().check(dialect, &source)
    };
    for please in [
        "accept",
        "reject",
        "say what was recorded",
        "be unfinished",
        "go wrong",
        "panic",
        "die",
    ] {
        let outcome = match check(&described, please) {
            Outcome::Crashed { reason } => {
                Outcome::crashed(reason.replace("; nothing that it wrote fits its `diagnostic`", ""))
            }
            other => other,
        };
        assert_eq!(outcome, check(adapter.as_ref(), please), "{please}");
    }
}
