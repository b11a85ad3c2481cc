//! Tests real compilers behind their adapters by `tests/compilers.md`. Where a compiler is not installed, its test says so and passes.

use crate::fixture::{Asked, block, files, shown};
use std::io::Write;
use stickler_engines::{
    Compiler, DependencyPaths, DescribedEngine, Description, Engine, Observation, Outcome, Packed, RunRequest,
};
use stickler_mdtest::fits;

/// Returns the compiler's engine; prints why it is skipped where there is none.
pub fn here(compiler: Compiler) -> Option<Box<dyn Engine>> {
    match compiler.engine(compiler.as_str()) {
        Ok(engine) => Some(engine),
        Err(error) => {
            // Not `eprintln`, which nobody sees when the test passes.
            let _ = writeln!(std::io::stderr(), "skipped: {error}");
            None
        }
    }
}

const DATA: &str = include_str!("../compilers.md");

/// Runs the rows of a compiler.
fn behaves(compiler: Compiler) {
    let Some(engine) = here(compiler) else { return };
    let (_, tests) = &files(DATA)[0];
    let mut failures = Vec::new();
    for test in tests {
        let source = block(test, "st").unwrap();
        let rows = test.rows.iter().map(|row| &row.cells);
        for row in rows.filter(|row| row[0] == "all" || row[0] == compiler.as_str()) {
            let asked = Asked::read(&row[1], engine.identity().dialects[0]);
            let given = shown(&asked.ask(engine.session().unwrap().as_mut(), &source));
            if !fits(&row[2], &given) {
                let (heading, row) = (&test.heading, row.join(" | "));
                failures.push(format!("{heading}\n  {row}\n  gives {given}"));
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// Checks that running in packs gives the same outcomes as running alone.
fn packs(compiler: Compiler) {
    let Some(engine) = here(compiler) else { return };
    let (_, tests) = &files(DATA)[1];
    let observe = [Observation::last("n", "INT")];
    let requests: Vec<RunRequest<'_>> = tests[0]
        .blocks
        .iter()
        .map(|program| RunRequest {
            scans: 2,
            ..RunRequest::once(engine.identity().dialects[0], &program.text, &observe)
        })
        .collect();
    if engine.pack_size() == 1 {
        return;
    }
    assert!(engine.pack_size() > requests.len());
    let mut session = engine.session().unwrap();
    let alone: Vec<Outcome> = requests.iter().map(|request| session.run(request)).collect();
    let packed = session.run_pack(&requests);
    let mut left = Vec::new();
    for ((request, alone), packed) in requests.iter().zip(&alone).zip(packed) {
        match packed {
            Packed::Answered(outcome) => {
                assert_eq!(&outcome, alone, "{}: {}", compiler.as_str(), request.source)
            }
            Packed::Alone | Packed::Unknown => left.push(request.source),
        }
    }
    assert!(left.len() <= 4, "the pack tells nothing about {left:#?}");
    let executed = |outcome: &&Outcome| matches!(outcome, Outcome::Executed { .. });
    let rejected = |outcome: &&Outcome| matches!(outcome, Outcome::Rejected { .. });
    assert!(alone.iter().filter(executed).count() >= 5, "{alone:#?}");
    assert!(alone.iter().filter(rejected).count() >= 4, "{alone:#?}");
}

/// Asks every compiler at once, each in a thread of its own.
fn each(ask: fn(Compiler)) {
    std::thread::scope(|scope| {
        for compiler in Compiler::ALL {
            scope.spawn(move || ask(compiler));
        }
    });
}

#[test]
fn every_compiler_behaves() {
    each(behaves);
}

#[test]
fn every_compiler_that_takes_packs_tells_in_them_what_it_tells_alone() {
    each(packs);
}

#[test]
fn a_description_of_ironplc_checks_as_its_adapter_does() {
    let sought = Compiler::Ironplc.seek("ironplc", "ironplc", &DependencyPaths::default());
    let (Ok(adapter), Some(compiler)) = (&sought.engine, sought.located.first()) else {
        // Not `eprintln`, which nobody sees when the test passes.
        let _ = writeln!(
            std::io::stderr(),
            "skipped: there is no ironplcc to hold its description against"
        );
        return;
    };
    let description: Description = toml::from_str(include_str!("../described/ironplc.toml")).unwrap();
    let here = compiler.path.parent().unwrap();
    let described = DescribedEngine::start("described", description, here).unwrap();
    let (mut one, mut other) = (adapter.session().unwrap(), described.session().unwrap());
    for body in [
        "a := 1;",
        "a := b;",
        "a := nowhere_declared;",
        "a := ;",
        "a := 1; a.9 := 5;",
        "a := REAL_TO_INT(b);",
    ] {
        let source = format!("PROGRAM main\nVAR\n    a : INT; b : DINT;\nEND_VAR\n    {body}\nEND_PROGRAM\n");
        for &dialect in &described.identity().dialects {
            let outcome = one.check(dialect, &source);
            assert_eq!(other.check(dialect, &source), outcome, "{body} {dialect}");
        }
    }
}

#[test]
fn a_compiler_is_known_by_its_name() {
    for compiler in Compiler::ALL {
        assert_eq!(Compiler::from_word(compiler.as_str()), Some(compiler));
    }
    assert_eq!(Compiler::from_word("cc"), None);
}
