//! `results.sarif`: the unexpected results of a run for code scanning services and editors. Each claim of the run is a rule; each
//! cause of failing cases, and each failing case that no cause explains, is a result.
//!
//! Basis: SARIF 2.1.0 (OASIS), and what GitHub documents of the properties that its code scanning reads.

mod document;

use crate::basis::Basis;
use crate::overview::Overview;
use crate::text::{outdated, percent_encoded};
use crate::unexpected::Unexpected;
use document::{
    Document, Fingerprints, Invocation, Level, Message, Notification, Region, SarifDriver, SarifLocation,
    SarifResult, SarifRule, SarifRun, Tool,
};
use std::collections::BTreeMap;
use stickler_run::Header;
use stickler_types::{Code, Diagnostic, counted};

/// Returns the content of the file.
///
/// # Errors
/// Returns the error of serde_json.
pub(crate) fn json(overview: &Overview) -> serde_json::Result<Vec<u8>> {
    let header = overview.header.as_ref();
    serde_json::to_vec(&header.map(|header| document(header, overview)))
}

/// Returns the file of diagnostics, each with the name of its file. Each code is a rule.
///
/// # Errors
/// Returns the error of serde_json.
pub fn diagnostics_as_sarif<'a>(
    diagnostics: impl Iterator<Item = (&'a str, &'a Diagnostic)>,
    command: &str,
    started: &str,
) -> serde_json::Result<Vec<u8>> {
    let mut rules = BTreeMap::new();
    let mut found = Vec::new();
    for (file, diagnostic) in diagnostics {
        let code = diagnostic.registered_code();
        let id = code.map_or("means-something-else", Code::as_str).to_owned();
        let summary = code.map_or("The other dialect computes something else.", Code::summary);
        let help = code.map_or(summary, Code::explanation).to_owned();
        let text = || Message {
            text: summary.to_owned(),
        };
        rules.entry(id.clone()).or_insert_with(|| SarifRule {
            id: id.clone(),
            short_description: text(),
            full_description: text(),
            help: Message { text: help },
            help_uri: None,
        });
        found.push((id, file, diagnostic));
    }
    let results = found.into_iter().map(|(basis, file, diagnostic)| {
        let unexpected = Unexpected {
            key: format!("{basis} {file} {diagnostic}"),
            basis,
            file: file.to_owned(),
            line: diagnostic.line,
            title: diagnostic.message.clone(),
            text: diagnostic
                .suggestion
                .iter()
                .map(|text| format!("Write: {text}"))
                .collect(),
            cases: 1,
        };
        let level = if diagnostic.is_error() {
            Level::Error
        } else {
            Level::Warning
        };
        SarifResult {
            level,
            ..result(unexpected, &rules)
        }
    });
    let results = results.collect();
    let called = [command, started].map(str::to_owned);
    serde_json::to_vec(&of_results(
        env!("CARGO_PKG_VERSION"),
        rules,
        results,
        called,
        [Vec::new(), Vec::new()],
    ))
}

fn document(header: &Header, overview: &Overview) -> Document {
    let rules = rules(overview);
    let unexpected: Vec<Unexpected> = Unexpected::all(overview).collect();
    let described: u64 = unexpected.iter().map(|one| one.cases).sum();
    let results = unexpected.into_iter().map(|one| result(one, &rules)).collect();
    let told = [
        mistakes(header, overview),
        left_out(overview.failed.saturating_sub(described)),
    ];
    let called = [header.command.clone(), header.started.clone()];
    of_results(&header.stickler, rules, results, called, told)
}

/// Returns the document of results, with the command and the time of the call, and notifications on its settings and on its work.
fn of_results(
    version: &str,
    rules: BTreeMap<String, SarifRule>,
    results: Vec<SarifResult>,
    [command_line, start_time_utc]: [String; 2],
    [of_settings, of_work]: [Vec<Notification>; 2],
) -> Document {
    Document::of(SarifRun {
        tool: Tool {
            driver: SarifDriver {
                name: "Stickler",
                version: version.to_owned(),
                rules: rules.into_values().collect(),
            },
        },
        invocations: [Invocation {
            execution_successful: true,
            command_line,
            start_time_utc,
            tool_configuration_notifications: of_settings,
            tool_execution_notifications: of_work,
        }],
        results,
    })
}

/// Returns a rule for each claim, by its basis, in the order of the texts.
fn rules(overview: &Overview) -> BTreeMap<String, SarifRule> {
    let claims = overview.claims.rows(&[]);
    let claims = claims.into_iter().filter(|row| !row.sum);
    let rules = claims.map(|row| {
        let id = match row.section {
            "" => row.source.to_owned(),
            section => format!("{}: {section}", row.source),
        };
        (id.clone(), rule(id, overview))
    });
    rules.collect()
}

fn rule(id: String, overview: &Overview) -> SarifRule {
    let Basis { source, section } = Basis::of(&id);
    let source = overview.source(source);
    let address = source
        .map(|source| source.address_of(section))
        .unwrap_or_default();
    let described = match source {
        Some(source) => {
            let kind = source.relation.with_kind(&source.kind);
            format!("{id} ({kind} of {}: {})", source.publisher, source.title)
        }
        None => id.clone(),
    };
    SarifRule {
        short_description: Message { text: id.clone() },
        full_description: Message {
            text: described.clone(),
        },
        help: Message {
            text: format!("{described} {address}").trim_end().to_owned(),
        },
        help_uri: web_address(&address),
        id,
    }
}

/// Returns an address of the web as a URI; `None` for a path.
fn web_address(address: &str) -> Option<String> {
    // The reserved characters of RFC 3986 without the square brackets, which stand only in the address of a host, and a percent
    // sign, since what the address has encoded stays so.
    let reserved = ":/?#@!$&'()*+,;=%";
    let is_of_the_web = address.starts_with("https://") || address.starts_with("http://");
    is_of_the_web.then(|| percent_encoded(address, reserved))
}

fn result(unexpected: Unexpected, rules: &BTreeMap<String, SarifRule>) -> SarifResult {
    let Unexpected {
        basis,
        file,
        line,
        title,
        text,
        key,
        ..
    } = unexpected;
    let place = (!file.is_empty())
        .then(|| SarifLocation::of(uri(&file), line.map(|line| Region { start_line: line })));
    SarifResult {
        rule_index: rules.keys().position(|id| *id == basis),
        rule_id: basis,
        level: Level::Error,
        message: Message {
            text: format!("{title}\n\n{text}").trim_end().to_owned(),
        },
        locations: place.into_iter().collect(),
        partial_fingerprints: Fingerprints {
            primary_location_line_hash: key,
        },
    }
}

/// Returns a path as a reference of RFC 3986; an absolute one becomes an address of the scheme `file`.
fn uri(path: &str) -> String {
    let encoded = percent_encoded(&path.replace('\\', "/"), "/");
    match encoded.starts_with('/') {
        true => format!("file://{encoded}"),
        false => encoded,
    }
}

/// Returns the mistakes in case files and the entries of baselines that are out of date.
fn mistakes(header: &Header, overview: &Overview) -> Vec<Notification> {
    let broken = header.broken_files.iter();
    let broken = broken.map(|mistake| format!("some cases were not run: {mistake}"));
    let texts = broken.chain(overview.outdated().map(outdated));
    texts
        .map(|text| Notification {
            level: Level::Error,
            message: Message { text },
        })
        .collect()
}

/// Returns the note on cases that no result tells of; none where there is no such case.
fn left_out(cases: u64) -> Vec<Notification> {
    let note = (cases > 0).then(|| Notification {
        level: Level::Warning,
        message: Message {
            text: format!(
                "{} not as expected and left out here; results.json has all",
                counted(cases, "more case is", "more cases are")
            ),
        },
    });
    note.into_iter().collect()
}

#[cfg(test)]
pub(crate) mod tests;
