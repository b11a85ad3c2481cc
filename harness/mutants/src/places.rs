//! `places`: saboteurs that break one claim in one place, and how many cases notice.
//!
//! A saboteur is the reference with one rule broken in one place: an implicit conversion that is refused as an element of an array,
//! a bit that is written wrongly inside a loop. It works on what the reference made of a program: its errors, its instructions,
//! and for rendering its tree. It answers as the reference does where a program does not have the rule in that place, so only the
//! other cases are run against it.

mod analysis;
mod claim;
mod explained;
mod forms;
mod matrix;
mod measure;
mod names;
mod saboteur;
mod site;
mod standing;
mod table;
#[cfg(test)]
mod tests;
mod wrong_code;

use crate::{RunFailure, ends_with, loaded};
use clap::Args;
use explained::{ExplainedSaboteurs, Explanation};
use saboteur::Saboteur;
use std::path::PathBuf;
use stickler_types::DialectName;
use table::Judged;

/// Breaks one claim in one place after the other, and lets the cases of the suite say whether anything is wrong.
///
/// Exit codes: 0; 1 where a saboteur is not noticed that unnoticed.toml does not explain, or where it explains one that is noticed;
/// 2 usage, or a broken case file.
#[derive(Args)]
pub struct PlacesArguments {
    /// Only rules whose names contain this text: `implicit.`, `bit`, `.wrong`.
    #[arg(long, value_name = "TEXT", default_value = "")]
    rule: String,
    /// Only places whose names contain this text: `target.argument`, `source.`, `from SINT`.
    #[arg(long, value_name = "TEXT", default_value = "")]
    place: String,
    /// Only the cases of this dialect, and the rules that it has; may be repeated.
    #[arg(long, value_name = "DIALECT")]
    dialect: Vec<DialectName>,
    /// A line for each saboteur: rule, place, how many cases have it, see it, see it and assert nothing, and fail, and one of them.
    #[arg(long)]
    each: bool,
    /// The number of threads; 0 stands for one a processor.
    #[arg(long, short, value_name = "N", default_value_t = 0)]
    jobs: usize,
    /// The folder of the cases.
    #[arg(long, value_name = "DIR", default_value = "conformance-cases")]
    cases: PathBuf,
}

/// Runs the cases against the saboteurs, and prints what came of it.
pub fn run(arguments: &PlacesArguments) -> Result<u8, RunFailure> {
    let mut suite = loaded(&arguments.cases).map_err(ends_with(2))?;
    let mut dialects = DialectName::ALL.to_vec();
    if !arguments.dialect.is_empty() {
        dialects.clone_from(&arguments.dialect);
        suite.cases.retain(|case| dialects.contains(&case.dialect));
    }
    let is_wanted = |saboteur: &Saboteur| {
        saboteur.rule.to_string().contains(&arguments.rule)
            && saboteur.place.to_string().contains(&arguments.place)
    };
    let mut tallies = measure::measure(&suite.cases, arguments.jobs, is_wanted).map_err(ends_with(2))?;
    for saboteur in matrix::required(&suite, &dialects).into_iter().filter(is_wanted) {
        tallies.entry(saboteur).or_default();
    }
    let explained = ExplainedSaboteurs::read(&arguments.dialect).map_err(ends_with(2))?;
    let judged = table::judge(tallies, &explained);
    let whole = arguments.rule.is_empty() && arguments.place.is_empty();
    let stale = match whole {
        true => explained.stale(
            &saboteurs(&judged, |one| one.kind.is_some() && !one.is_recorded()),
            &saboteurs(&judged, Judged::is_noticed),
        ),
        false => Vec::new(),
    };
    Ok(print(&judged, &stale, arguments.each))
}

fn saboteurs(judged: &[Judged], wanted: impl Fn(&Judged) -> bool) -> Vec<&Saboteur> {
    let wanted = judged.iter().filter(|one| wanted(one));
    wanted.map(|one| &one.saboteur).collect()
}

/// Prints the tables and what is wrong, and returns the exit code.
fn print(judged: &[Judged], stale: &[String], each: bool) -> u8 {
    if each {
        for Judged { saboteur, tally, .. } in judged {
            let (rule, place) = (saboteur.rule, saboteur.place);
            let example = tally.example.as_deref().unwrap_or("-");
            println!(
                "{rule}\t{place}\t{}\t{}\t{}\t{}\t{example}",
                tally.met, tally.changed, tally.recorded, tally.noticed
            );
        }
    }
    println!("{}\n{}", table::by_place(judged), table::by_rule(judged));
    let unexplained: Vec<&Judged> = judged.iter().filter(|one| one.is_unexplained()).collect();
    for one in &unexplained {
        println!("{}", one.complaint());
    }
    for entry in stale {
        println!("stale: unnoticed.toml explains {entry}");
    }
    let noticed = judged.iter().filter(|one| one.is_noticed()).count();
    let recorded = judged.iter().filter(|one| one.is_recorded()).count();
    let explained = |kind| {
        let explained = judged.iter().filter(|one| !one.is_recorded());
        explained.filter(|one| one.kind == Some(kind)).count()
    };
    println!(
        "{} saboteurs: {noticed} noticed, {recorded} break no claim (o), {} open and {} impossible (e), {} none of these",
        judged.len(),
        explained(Explanation::Open),
        explained(Explanation::Impossible),
        unexplained.len()
    );
    u8::from(!unexplained.is_empty() || !stale.is_empty())
}
