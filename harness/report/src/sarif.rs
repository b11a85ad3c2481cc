//! `results.sarif`: the unexpected results of a run for code scanning services and editors. Each claim of the run is a rule; each
//! cause of failing cases, and each failing case that no cause explains, is a result.
//!
//! Basis: SARIF 2.1.0 (OASIS), and what GitHub documents of the properties that its code scanning reads.

use crate::basis::Basis;
use crate::overview::Overview;
use crate::text::{outdated, percent_encoded};
use crate::unexpected::Unexpected;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use stickler_run::Header;
use stickler_types::{Code, Diagnostic, counted};

/// Returns the content of the file.
///
/// # Errors
/// Returns the error of serde_json.
pub(crate) fn json(overview: &Overview) -> serde_json::Result<Vec<u8>> {
    let header = overview.header.as_ref();
    serde_json::to_vec(&header.map(|header| of_run(header, overview)))
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
        let help = code.map_or(summary, Code::explanation);
        rules
            .entry(id.clone())
            .or_insert_with(|| rule(&id, [summary, summary, help]));
        found.push((id, file, diagnostic));
    }
    let results = found.into_iter().map(|(basis, file, diagnostic)| {
        let suggestion = diagnostic.suggestion.iter();
        let unexpected = Unexpected {
            key: format!("{basis} {file} {diagnostic}"),
            basis,
            file: file.to_owned(),
            line: diagnostic.line,
            title: diagnostic.message.clone(),
            text: suggestion.map(|text| format!("Write: {text}")).collect(),
            cases: 1,
        };
        result(unexpected, diagnostic.severity.as_str(), &rules)
    });
    let results = results.collect();
    let version = env!("CARGO_PKG_VERSION");
    let untold = [Vec::new(), Vec::new()];
    serde_json::to_vec(&document(version, rules, results, [command, started], untold))
}

fn of_run(header: &Header, overview: &Overview) -> Value {
    let rules = rules(overview);
    let unexpected: Vec<Unexpected> = Unexpected::all(overview).collect();
    let described: u64 = unexpected.iter().map(|one| one.cases).sum();
    let results = unexpected.into_iter().map(|one| result(one, "error", &rules));
    let results = results.collect();
    let told = [
        mistakes(header, overview),
        left_out(overview.failed.saturating_sub(described)),
    ];
    let called = [&*header.command, &*header.started];
    document(&header.stickler, rules, results, called, told)
}

/// Returns the `sarifLog` of one run, with the command and the time of the call, and notifications on its settings and on its work.
fn document(
    version: &str,
    rules: BTreeMap<String, Value>,
    results: Vec<Value>,
    [command, started]: [&str; 2],
    [of_settings, of_work]: [Vec<Value>; 2],
) -> Value {
    let rules: Vec<Value> = rules.into_values().collect();
    json!({
        "$schema": "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json",
        "version": "2.1.0",
        "runs": [{
            "tool": { "driver": { "name": "Stickler", "version": version, "rules": rules } },
            "invocations": [{
                "executionSuccessful": true,
                "commandLine": command,
                "startTimeUtc": started,
                "toolConfigurationNotifications": of_settings,
                "toolExecutionNotifications": of_work,
            }],
            "results": results,
        }],
    })
}

/// Returns a `reportingDescriptor` with a short, a full, and a helpful description.
fn rule(id: &str, [short, full, help]: [&str; 3]) -> Value {
    json!({
        "id": id,
        "shortDescription": { "text": short },
        "fullDescription": { "text": full },
        "help": { "text": help },
    })
}

fn notification(level: &str, text: &str) -> Value {
    json!({ "level": level, "message": { "text": text } })
}

/// Returns a rule for each claim, by its basis, in the order of the texts.
fn rules(overview: &Overview) -> BTreeMap<String, Value> {
    let claims = overview.claims.rows(&[]);
    let claims = claims.into_iter().filter(|row| !row.sum);
    let rules = claims.map(|row| {
        let id = match row.section {
            "" => row.source.to_owned(),
            section => format!("{}: {section}", row.source),
        };
        let rule = rule_of_claim(&id, overview);
        (id, rule)
    });
    rules.collect()
}

fn rule_of_claim(id: &str, overview: &Overview) -> Value {
    let Basis { source, section } = Basis::of(id);
    let Some(source) = overview.source(source) else {
        return rule(id, [id; 3]);
    };
    let address = source.address_of(section);
    let kind = source.relation.with_kind(source.kind.as_str());
    let described = format!("{id} ({kind} of {}: {})", source.publisher, source.title);
    let help = format!("{described} {address}");
    let mut rule = rule(id, [id, &described, help.trim_end()]);
    if let Some(address) = web_address(&address) {
        rule["helpUri"] = address.into();
    }
    rule
}

/// Returns an address of the web as a URI; `None` for a path.
fn web_address(address: &str) -> Option<String> {
    // The reserved characters of RFC 3986 without the square brackets, which stand only in the address of a host, and a percent
    // sign, since what the address has encoded stays so.
    let reserved = ":/?#@!$&'()*+,;=%";
    let is_of_the_web = address.starts_with("https://") || address.starts_with("http://");
    is_of_the_web.then(|| percent_encoded(address, reserved))
}

fn result(unexpected: Unexpected, level: &str, rules: &BTreeMap<String, Value>) -> Value {
    let Unexpected {
        basis,
        file,
        line,
        title,
        text,
        key,
        ..
    } = unexpected;
    let mut place = json!({ "artifactLocation": { "uri": uri(&file) } });
    if let Some(line) = line {
        place["region"] = json!({ "startLine": line });
    }
    let mut result = json!({
        "ruleId": basis,
        "level": level,
        "message": { "text": format!("{title}\n\n{text}").trim_end() },
        "locations": match file.is_empty() {
            true => json!([]),
            false => json!([{ "physicalLocation": place }]),
        },
        // By this, the only one that GitHub reads, a service sees that two runs have the same result.
        "partialFingerprints": { "primaryLocationLineHash": key },
    });
    if let Some(index) = rules.keys().position(|id| *id == basis) {
        result["ruleIndex"] = index.into();
    }
    result
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
fn mistakes(header: &Header, overview: &Overview) -> Vec<Value> {
    let broken = header.broken_files.iter();
    let broken = broken.map(|mistake| format!("some cases were not run: {mistake}"));
    let texts = broken.chain(overview.outdated().map(outdated));
    texts.map(|text| notification("error", &text)).collect()
}

/// Returns the note on cases that no result tells of; none where there is no such case.
fn left_out(cases: u64) -> Vec<Value> {
    let more = counted(cases, "more case is", "more cases are");
    let text = format!("{more} not as expected and left out here; events.jsonl.gz has all");
    let note = (cases > 0).then(|| notification("warning", &text));
    note.into_iter().collect()
}

#[cfg(test)]
pub(crate) mod tests;
