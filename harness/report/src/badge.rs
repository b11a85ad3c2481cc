//! `badge.json`: the share of documented claims that an engine meets, in one line, for the first page of its project.
//!
//! Basis of the keys: the endpoint badge of shields.io, which draws a badge from a JSON file at any address.

use crate::claims::Standing;
use crate::overview::Overview;
use serde_json::{Value, json};
use stickler_types::{counted, join};

/// Returns the content of the file.
///
/// # Errors
/// Returns the error of serde_json.
pub(crate) fn json(overview: &Overview) -> serde_json::Result<Vec<u8>> {
    serde_json::to_vec(&endpoint(overview))
}

fn endpoint(overview: &Overview) -> Value {
    let engines = overview.engines();
    let standings: Vec<Standing> = engines
        .iter()
        .map(|engine| overview.claims.of_engine(engine))
        .collect();
    let message = match standings[..] {
        [standing] => single_engine(standing),
        _ => {
            let each = engines.iter().zip(&standings);
            let each = each.map(|(engine, standing)| format!("{engine} {}", share(*standing)));
            join(each, ", ")
        }
    };
    let worst = standings.iter().filter_map(|standing| standing.per_mille()).min();
    json!({ "schemaVersion": 1, "label": "Stickler", "message": message, "color": color(worst) })
}

fn share(standing: Standing) -> String {
    match standing.per_mille() {
        Some(1000) => "100 %".to_owned(),
        Some(share) => format!("{}.{} %", share / 10, share % 10),
        None => "nothing tested".to_owned(),
    }
}

/// Returns the message about the only engine, which leaves its name to the page that shows the badge.
fn single_engine(standing: Standing) -> String {
    match standing.decided() {
        0 => share(standing),
        cases => format!("{} of {}", share(standing), counted(cases, "case", "cases")),
    }
}

/// Returns the color name of shields.io for a number of passes in a thousand.
fn color(worst: Option<u64>) -> &'static str {
    match worst {
        None => "lightgrey",
        Some(1000..) => "brightgreen",
        Some(950..) => "green",
        Some(800..) => "yellow",
        Some(500..) => "orange",
        Some(_) => "red",
    }
}
