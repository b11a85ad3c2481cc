//! Measures the programs of the generator: `cargo run --release -p stickler-generate --example census -- 10000 [DIALECT]`.
//!
//! For each dialect it prints the programs that the oracle `execute` finds anything wrong with (the reference rejects one,
//! breaks down, does not end, or gives other values than the evaluator, for the program or for a variant of it), the share
//! of programs whose every value is settled by documents, the questions that the others raise, their sizes, and how often
//! each construct occurs.

use arbitrary::Unstructured;
use std::collections::BTreeMap;
use stickler_generate::evaluate::evaluate;
use stickler_generate::features;
use stickler_generate::generator::{GeneratorSettings, program};
use stickler_generate::model::{AssignmentTarget, Program, Statement};
use stickler_generate::oracles::InputOutcome;
use stickler_generate::oracles::execute::judge_program;
use stickler_generate::writer::{Style, write};
use stickler_types::{DialectName, Value};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let seeds: u64 = arguments.next().unwrap_or("1000".to_owned()).parse()?;
    let dialects = match arguments.next() {
        Some(name) => vec![name.parse()?],
        None => DialectName::ALL.to_vec(),
    };
    for dialect in dialects {
        Measured::of(dialect, seeds).print(dialect);
    }
    Ok(())
}

#[derive(Default)]
struct Measured {
    programs: u64,
    wrong: u64,
    passed_over: BTreeMap<&'static str, u64>,
    settled: u64,
    lines: Vec<usize>,
    steps: u64,
    /// Statements of main that were left out to see whether any value changes, and those where one did.
    left_out: u64,
    missed: u64,
    questions: BTreeMap<String, u64>,
    refusals: BTreeMap<String, u64>,
    constructs: BTreeMap<String, (u64, u64)>,
}

impl Measured {
    fn of(dialect: DialectName, seeds: u64) -> Measured {
        let settings = GeneratorSettings {
            dialect: Some(dialect),
            ..GeneratorSettings::default()
        };
        let mut measured = Measured::default();
        for seed in 0..seeds {
            let bytes = bytes(seed);
            let program = program(&mut Unstructured::new(&bytes), &settings);
            let text = write(&program, &Style::default()).text;
            measured.programs += 1;
            measured.lines.push(text.lines().count());
            match judge_program(&program, &bytes) {
                Ok(InputOutcome::Checked) => {}
                Ok(InputOutcome::Skipped(word)) => *measured.passed_over.entry(word).or_default() += 1,
                Err(failure) => {
                    measured.wrong += 1;
                    println!("{dialect}, seed {seed}: {}: {}", failure.symptom, failure.message);
                }
            }
            measured.evaluate(&program);
            for (construct, times) in features::measured(&program) {
                let counted = measured.constructs.entry(construct).or_default();
                counted.0 += times;
                counted.1 += 1;
            }
        }
        measured
    }

    fn evaluate(&mut self, program: &Program) {
        match evaluate(program, 1) {
            Ok(evaluation) => {
                self.steps += evaluation.steps;
                self.settled += u64::from(evaluation.opened.is_empty());
                self.leave_out(program, &evaluation.values);
                for opened in evaluation.opened {
                    *self
                        .questions
                        .entry(opened.question.as_str().to_owned())
                        .or_default() += 1;
                }
            }
            Err(refusal) => *self.refusals.entry(format!("{refusal:?}")).or_default() += 1,
        }
    }

    /// Leaves out one statement of main, and looks whether any value changes.
    fn leave_out(&mut self, program: &Program, values: &[(String, Value)]) {
        let own = |statement: &Statement| {
            !matches!(statement, Statement::Assign(AssignmentTarget::Place(place), _)
            if program.main.variables[place.variable.0].name.starts_with("checksum"))
        };
        let count = program
            .main
            .body
            .iter()
            .take_while(|statement| own(statement))
            .count();
        if count == 0 {
            return;
        }
        let mut shorter = program.clone();
        shorter.main.body.remove(self.programs as usize % count);
        self.left_out += 1;
        if let Ok(evaluation) = evaluate(&shorter, 1) {
            self.missed += u64::from(evaluation.values != values);
        }
    }

    fn print(mut self, dialect: DialectName) {
        self.lines.sort_unstable();
        let quantile = |of: usize| {
            self.lines
                .get(self.lines.len() * of / 100)
                .copied()
                .unwrap_or_default()
        };
        println!(
            "# {dialect}: {} programs, {} wrong, {} settled",
            self.programs, self.wrong, self.settled
        );
        println!(
            "lines: {} {} {} {} (10 %, half, 90 %, 99 %)",
            quantile(10),
            quantile(50),
            quantile(90),
            quantile(99)
        );
        println!("steps: {} a program", self.steps / self.programs.max(1));
        println!(
            "of {} statements of main that were left out one by one, {} were missed by some value",
            self.left_out, self.missed
        );
        println!("passed over: {:?}", self.passed_over);
        println!("questions: {:?}", self.questions);
        println!("refusals: {:?}", self.refusals);
        println!("times / programs");
        for (construct, (times, programs)) in self.constructs {
            println!("{times:>9} {programs:>9}  {construct}");
        }
    }
}

/// The bytes of a seed: programs of every size.
fn bytes(seed: u64) -> Vec<u8> {
    stickler_generate::random::bytes(seed, (seed * 7 % 3000) as usize)
}
