//! Measures how strong the suite is: runs cargo-mutants with the suite as the only judge, and prints how many mutants it kills.
//! `cargo xtask mutants` is its command.

mod explained;
mod outcomes;
mod places;
mod prepare;
mod table;
mod tool;

use anyhow::Context as _;
use clap::Args;
use std::path::{Path, PathBuf};

/// Changes the reference in one small place after the other, and lets the conformance suite alone say whether anything is
/// wrong with it. Prints the kill rate per module.
///
/// Exit codes: 0; 1 where a mutant of the conversion, widening or bit-access code survives that survivors.toml does not
/// explain; 2 usage, or a broken case file; 3 cargo-mutants is missing or could not be run.
#[derive(Args)]
#[command(args_conflicts_with_subcommands = true)]
pub struct MutantsArguments {
    #[command(subcommand)]
    command: Option<MutantsCommand>,
    /// Run nothing; read these folders, each a `mutants.out` or one that has it. Of a mutant that several have, the last
    /// counts.
    #[arg(long, value_name = "DIR", num_args = 1..)]
    read: Vec<PathBuf>,
    /// A line for each file, not for each module.
    #[arg(long)]
    files: bool,
    /// List the mutants that survive and are not explained.
    #[arg(long)]
    survivors: bool,
    /// The folder for the results.
    #[arg(long, value_name = "DIR", default_value = "target/mutants")]
    output: PathBuf,
    /// The folder of the cases.
    #[arg(long, value_name = "DIR", default_value = "conformance-cases")]
    cases: PathBuf,
    /// Options of cargo-mutants: `-- --file 'harness/reference/src/conversion/*'`, `-- --shard 0/20`, `-- --iterate`.
    #[arg(last = true, value_name = "OPTION")]
    cargo_mutants: Vec<String>,
}

#[derive(clap::Subcommand)]
enum MutantsCommand {
    /// Breaks one claim in one place after the other, without building anything, and counts the cases that notice.
    Places(places::PlacesArguments),
}

/// Runs the command, prints what came of it, and returns the exit code.
pub fn execute(arguments: &MutantsArguments) -> u8 {
    let ended = match &arguments.command {
        Some(MutantsCommand::Places(arguments)) => places::run(arguments),
        None => run(arguments),
    };
    ended.unwrap_or_else(|failure| {
        eprintln!("error: {:#}", failure.error);
        failure.code
    })
}

/// A failure that ends the program before its table.
struct RunFailure {
    code: u8,
    error: anyhow::Error,
}

/// Gives a failure an exit code, for [`Result::map_err`].
fn ends_with(code: u8) -> impl Fn(anyhow::Error) -> RunFailure {
    move |error| RunFailure { code, error }
}

fn run(arguments: &MutantsArguments) -> Result<u8, RunFailure> {
    let folders = if arguments.read.is_empty() {
        tool::find().map_err(ends_with(3))?;
        let prepared = prepared(arguments).map_err(ends_with(2))?;
        tool::run(&prepared, &arguments.output, &arguments.cargo_mutants).map_err(ends_with(3))?;
        vec![arguments.output.clone()]
    } else {
        arguments.read.clone()
    };
    let outcomes = outcomes::read_all(&folders).map_err(ends_with(2))?;
    let explained = explained::Explained::read().map_err(ends_with(2))?;
    let judged = table::judge(outcomes, &explained);
    print!("{}", table::table(&judged, arguments.files));
    for stale in explained.stale(judged.iter().map(|mutant| &mutant.outcome)) {
        println!("note: survivors.toml explains a mutant that does not survive: {stale}");
    }
    let open: Vec<&table::JudgedMutant> = judged.iter().filter(|mutant| mutant.is_unexplained()).collect();
    let focused = open.iter().filter(|mutant| mutant.topic.is_some()).count();
    for mutant in open
        .iter()
        .filter(|mutant| arguments.survivors || mutant.topic.is_some())
    {
        println!("survives: {}", mutant.outcome.name);
    }
    Ok(u8::from(focused > 0))
}

/// Loads the cases of a folder in which nothing is wrong.
fn loaded(cases: &Path) -> anyhow::Result<stickler_suite::Suite> {
    let suite = stickler_suite::Suite::load(cases);
    if let Some(error) = suite.errors.first() {
        anyhow::bail!("{error}; `cargo run -- lint` lists all that is wrong with the case files");
    }
    Ok(suite)
}

/// Writes all cases down for the judge, and returns the file.
fn prepared(arguments: &MutantsArguments) -> anyhow::Result<PathBuf> {
    let mut suite = loaded(&arguments.cases)?;
    // The judge knows the dialects of documented systems only.
    suite.cases.retain(|case| case.dialect.definition().is_none());
    let output = &arguments.output;
    let output = std::path::absolute(output).with_context(|| format!("cannot find {}", output.display()))?;
    std::fs::create_dir_all(&output).with_context(|| format!("cannot create {}", output.display()))?;
    let path = output.join("prepared.cases");
    let text = stickler_mutants_judge::prepared::write(&prepare::prepare(&suite.cases))?;
    std::fs::write(&path, text).with_context(|| format!("cannot write {}", path.display()))?;
    // The indices of another suite's killers mean nothing in this one.
    let _ = std::fs::remove_file(path.with_extension("killers"));
    println!("{} cases judge each mutant", suite.cases.len());
    Ok(path)
}
