//! `badge.json`: the share of documented claims that an engine meets, in one line, for the first page of its project.
//!
//! Basis of the keys: the endpoint badge of shields.io, which draws a badge from a JSON file at any address.

use crate::claims::Standing;
use crate::overview::Overview;
use serde::Serialize;
use stickler_types::counted;

/// The content of the file.
#[derive(PartialEq, Eq, Debug, Serialize)]
#[serde(rename_all = "camelCase")]
struct Endpoint {
    schema_version: u32,
    label: &'static str,
    message: String,
    color: &'static str,
}

/// Returns the content of the file.
///
/// # Errors
/// Returns the error of serde_json.
pub(crate) fn json(overview: &Overview) -> serde_json::Result<Vec<u8>> {
    serde_json::to_vec(&endpoint(overview))
}

fn endpoint(overview: &Overview) -> Endpoint {
    let engines = overview.engines();
    let standings: Vec<Standing> = engines
        .iter()
        .map(|engine| overview.claims.of_engine(engine))
        .collect();
    let message = match standings[..] {
        [standing] => single_engine(standing),
        _ => {
            let each = engines.iter().zip(&standings);
            let each: Vec<String> = each
                .map(|(engine, standing)| format!("{engine} {}", share(*standing)))
                .collect();
            each.join(", ")
        }
    };
    let worst = standings.iter().filter_map(|standing| standing.per_mille()).min();
    Endpoint {
        schema_version: 1,
        label: "Stickler",
        message,
        color: color(worst),
    }
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

#[cfg(test)]
mod tests {
    use super::endpoint;

    use crate::sample;
    use stickler_run::{CaseEvent, Event, Verdict};

    fn said(events: &[Event]) -> (String, &'static str) {
        let endpoint = endpoint(&sample::overview(events));
        (endpoint.message, endpoint.color)
    }

    fn cases(passed: usize, failed: usize) -> Vec<CaseEvent> {
        let pass = std::iter::repeat_n(sample::case("a", Verdict::Pass), passed);
        pass.chain(std::iter::repeat_n(sample::case("b", Verdict::Xfail), failed))
            .collect()
    }

    #[test]
    fn what_documents_leave_open_and_what_an_engine_cannot_run_does_not_count() {
        let mut run = cases(2, 0);
        run.extend([sample::open_case("open"), sample::case("c", Verdict::Unsupported)]);
        run.push(sample::case("d", Verdict::Differs));
        assert_eq!(
            said(&sample::run_of(run)),
            ("100 % of 2 cases".to_owned(), "brightgreen")
        );
        let nothing = sample::run_of(vec![sample::open_case("open")]);
        assert_eq!(said(&nothing), ("nothing tested".to_owned(), "lightgrey"));
    }

    #[test]
    fn a_known_failure_is_a_failure_and_no_share_is_rounded_up_to_the_whole() {
        assert_eq!(
            said(&sample::run_of(cases(2999, 1))),
            ("99.9 % of 3,000 cases".to_owned(), "green")
        );
        assert_eq!(
            said(&sample::run_of(cases(1, 2))),
            ("33.3 % of 3 cases".to_owned(), "red")
        );
    }

    #[test]
    fn several_engines_stand_on_one_badge_whose_colour_is_that_of_the_last_of_them() {
        let mut run = cases(3, 0);
        run.extend(cases(4, 1).into_iter().map(|case| CaseEvent {
            engine: "matiec".to_owned(),
            ..case
        }));
        assert_eq!(
            said(&sample::run_on(&["reference", "matiec"], run)),
            ("reference 100 %, matiec 80.0 %".to_owned(), "yellow")
        );
    }
}
