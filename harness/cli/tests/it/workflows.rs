//! Tests the YAML files of services: that they can be read, and that their steps, permissions and inputs are what they must be.

use crate::common::{ROOT, text};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use yaml_rust2::{Yaml, YamlLoader};

/// Returns the paths of all YAML files of the clone, below it.
fn yaml_files() -> Vec<PathBuf> {
    let mut found = vec![PathBuf::from("action.yml")];
    for folder in [".github", ".clusterfuzzlite", "harness/docs/examples"] {
        let entries = walkdir::WalkDir::new(Path::new(ROOT).join(folder));
        for entry in entries {
            let path = entry.expect("an entry").into_path();
            if path
                .extension()
                .is_some_and(|name| name == "yml" || name == "yaml")
            {
                found.push(path.strip_prefix(ROOT).expect("below the clone").to_owned());
            }
        }
    }
    found
}

fn yaml(file: &Path) -> Yaml {
    let content = fs::read_to_string(Path::new(ROOT).join(file)).expect("a file");
    let read = YamlLoader::load_from_str(&content);
    let read = read.unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    let [document] = &read[..] else {
        panic!("{}: one document is expected", file.display());
    };
    document.clone()
}

/// Calls a function with every table in a document, and in what it contains.
fn each_table(document: &Yaml, visit: &mut dyn FnMut(&Yaml)) {
    match document {
        Yaml::Hash(table) => {
            visit(document);
            table.values().for_each(|value| each_table(value, visit));
        }
        Yaml::Array(values) => values.iter().for_each(|value| each_table(value, visit)),
        _ => {}
    }
}

/// Returns the commands of a step with every expression of the service replaced by a word.
fn without_expressions(commands: &str) -> String {
    let mut shown = String::new();
    let mut rest = commands;
    while let Some((before, behind)) = rest.split_once("${{") {
        shown.push_str(before);
        shown.push_str("word");
        rest = behind.split_once("}}").map_or("", |(_, behind)| behind);
    }
    shown + rest
}

fn is_bash(commands: &str) -> Result<(), String> {
    let checked = Command::new("bash")
        .args(["-n", "-c", commands])
        .output()
        .expect("bash");
    match checked.status.success() {
        true => Ok(()),
        false => Err(text(&checked.stderr)),
    }
}

#[test]
fn every_yaml_file_can_be_read_and_its_steps_are_commands_or_actions_of_a_version() {
    let files = yaml_files();
    assert!(files.len() >= 7, "{files:?}");
    let mut wrong = Vec::new();
    for file in &files {
        each_table(&yaml(file), &mut |table| {
            if let Some(commands) = table["run"].as_str()
                && let Err(why) = is_bash(&without_expressions(commands))
            {
                wrong.push(format!("{}: {why}", file.display()));
            }
            if let Some(action) = table["uses"].as_str()
                && !action.contains('@')
            {
                wrong.push(format!("{}: {action} has no version", file.display()));
            }
        });
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn every_workflow_has_triggers_permissions_and_limits_of_time() {
    for file in yaml_files()
        .iter()
        .filter(|file| file.starts_with(".github/workflows"))
    {
        let workflow = yaml(file);
        for key in ["name", "on", "permissions", "jobs"] {
            assert!(!workflow[key].is_badvalue(), "{}: {key}", file.display());
        }
        for (name, job) in workflow["jobs"].as_hash().expect("jobs") {
            for key in ["runs-on", "timeout-minutes", "steps"] {
                assert!(!job[key].is_badvalue(), "{}: {name:?}: {key}", file.display());
            }
        }
    }
}

#[test]
fn the_examples_give_the_action_inputs_that_it_has_and_the_script_reads_all_of_them() {
    let action = yaml(Path::new("action.yml"));
    let inputs = action["inputs"].as_hash().expect("inputs");
    each_table(
        &yaml(Path::new("harness/docs/examples/github.yml")),
        &mut |table| {
            if table["uses"]
                .as_str()
                .is_some_and(|uses| uses.contains("/stickler@"))
            {
                for (given, _) in table["with"].as_hash().into_iter().flatten() {
                    assert!(inputs.contains_key(given), "{given:?}");
                }
            }
        },
    );
    let text = fs::read_to_string(format!("{ROOT}/action.yml")).expect("the action");
    for name in inputs.keys() {
        let name = name.as_str().expect("a name");
        assert!(text.contains(&format!("inputs.{name}")), "{name}");
    }
    let script = fs::read_to_string(format!("{ROOT}/.ci/action")).expect("the script");
    each_table(&action, &mut |table| {
        for (name, _) in table["env"].as_hash().into_iter().flatten() {
            let name = name.as_str().expect("a name");
            let commands = table["run"].as_str().unwrap_or_default();
            let is_read = commands.contains(&format!("${name}")) || script.contains(&format!("${{{name}:-"));
            assert!(is_read, "{name}");
        }
    });
}
