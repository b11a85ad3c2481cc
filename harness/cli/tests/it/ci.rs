//! Tests what services run: the script of the action, the packing of a release, the build of ClusterFuzzLite, and every YAML file.

use crate::common::{STICKLER, SUITE, text};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use tempfile::TempDir;
use yaml_rust2::{Yaml, YamlLoader};

/// The folder of the clone.
const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// A job of GitHub in an empty folder.
struct CiJob {
    folder: TempDir,
}

impl CiJob {
    fn new() -> CiJob {
        CiJob {
            folder: tempfile::tempdir().expect("a folder"),
        }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Runs the script of the action with these inputs.
    fn run(&self, inputs: &[(&str, &str)]) -> Output {
        let mut command = Command::new("bash");
        command
            .arg(format!("{ROOT}/.ci/action"))
            .current_dir(self.folder.path())
            .stdin(Stdio::null());
        for input in [
            "ENGINE", "CONFIG", "BASELINE", "CASES", "DIALECT", "FILTER", "SHARD", "MERGE", "REPORT",
        ] {
            command.env(input, "");
        }
        command
            .env("STICKLER", STICKLER)
            .env("GITHUB_ACTIONS", "true")
            .env("GITHUB_STEP_SUMMARY", self.path("summary"))
            .env("GITHUB_OUTPUT", self.path("output"))
            .envs(inputs.iter().copied());
        command.output().expect("bash")
    }

    fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).expect(name)
    }
}

#[test]
fn the_action_runs_cases_annotates_and_leaves_summary_and_outputs() {
    let job = CiJob::new();
    let run = job.run(&[
        ("CASES", SUITE),
        ("DIALECT", " matiec \n\nironplc-ed2\n"),
        ("REPORT", "my reports"),
    ]);
    assert_eq!(run.status.code(), Some(1), "{}", text(&run.stderr));
    assert!(
        text(&run.stdout).contains("::error file="),
        "{}",
        text(&run.stdout)
    );
    assert!(
        job.read("summary")
            .starts_with("# Stickler: 1 of 16 cases not as expected\n")
    );
    let outputs = "exit-code=1\nreports=my reports\nsuffix=\nsarif=my reports/results.sarif\n";
    assert_eq!(job.read("output"), outputs);
    assert!(job.path("my reports/index.html").is_file());
}

#[test]
fn no_input_of_the_action_is_taken_for_a_command() {
    let job = CiJob::new();
    let run = job.run(&[
        ("CASES", SUITE),
        ("FILTER", "$(touch made) `touch made`; touch made"),
    ]);
    assert_eq!(run.status.code(), Some(4), "{}", text(&run.stderr));
    assert_eq!(
        job.read("output"),
        "exit-code=4\nreports=reports/latest\nsuffix=\n"
    );
    assert!(!job.path("made").exists());
}

#[test]
fn the_action_joins_the_parts_that_it_ran() {
    let job = CiJob::new();
    for part in ["1", "2"] {
        let (shard, report) = (format!("{part}/2"), format!("parts/{part}"));
        job.run(&[("CASES", SUITE), ("SHARD", &shard), ("REPORT", &report)]);
    }
    assert!(
        job.read("output").contains("\nsuffix=-2-of-2\n"),
        "{}",
        job.read("output")
    );
    let merged = job.run(&[("MERGE", "parts"), ("CASES", SUITE)]);
    assert_eq!(merged.status.code(), Some(1), "{}", text(&merged.stderr));
    let last = job.read("summary");
    let last = last.rsplit("# Stickler: ").next().unwrap_or_default();
    assert!(last.starts_with("1 of 16 cases not as expected\n"), "{last}");
    let nothing = job.run(&[("MERGE", "nowhere"), ("CASES", SUITE)]);
    assert_eq!(nothing.status.code(), Some(2), "{}", text(&nothing.stderr));
}

#[test]
fn a_release_is_packed_with_its_licences_and_a_checksum_that_holds() {
    let folder = tempfile::tempdir().expect("a folder");
    let program = folder.path().join("stickler");
    fs::write(&program, "a program").expect("a file");
    let packed = Command::new("bash")
        .arg(format!("{ROOT}/.ci/package"))
        .arg(&program)
        .args(["v1", "some-target"])
        .arg(folder.path().join("out"))
        .output()
        .expect("bash");
    assert!(packed.status.success(), "{}", text(&packed.stderr));
    let archive = "stickler-v1-some-target.tar.gz";
    let checked = "(sha256sum -c ./*.sha256 || shasum -a 256 -c ./*.sha256) && tar -xzf ./*.tar.gz";
    let checked = Command::new("bash")
        .args(["-c", checked])
        .current_dir(folder.path().join("out"))
        .output()
        .expect("bash");
    assert!(checked.status.success(), "{}", text(&checked.stderr));
    let inside = folder
        .path()
        .join("out")
        .join(archive.trim_end_matches(".tar.gz"));
    for file in ["stickler", "README.md", "LICENSE-APACHE", "LICENSE-MIT"] {
        assert!(inside.join(file).is_file(), "{file}");
    }
}

/// Returns the names of the fuzz targets.
fn fuzz_targets() -> BTreeSet<String> {
    let entries = fs::read_dir(format!("{ROOT}/fuzz/fuzz_targets")).expect("a folder");
    let name = |entry: fs::DirEntry| Some(entry.path().file_stem()?.to_string_lossy().into_owned());
    entries.flatten().filter_map(name).collect()
}

#[test]
fn clusterfuzzlite_gets_every_target_with_its_corpus() {
    let folder = tempfile::tempdir().expect("a folder");
    let bin = folder.path().join("bin");
    let out = folder.path().join("out");
    let source = folder.path().join("stickler");
    let built = source.join("target/x86_64-unknown-linux-gnu/release");
    for made in [&bin, &out, &built, &source.join("corpus")] {
        fs::create_dir_all(made).expect("a folder");
    }
    let clone = Path::new(ROOT).canonicalize().expect("the clone");
    fs::create_dir(source.join("fuzz")).expect("a folder");
    fs::copy(clone.join("fuzz/st.dict"), source.join("fuzz/st.dict")).expect("the dictionary");
    let targets = fuzz_targets();
    for target in &targets {
        fs::create_dir(source.join("corpus").join(target)).expect("a folder");
    }
    // Stands in for cargo with cargo-fuzz, and for zip, of which only the first file matters here.
    let listed: Vec<&str> = targets.iter().map(String::as_str).collect();
    let listed = listed.join(" ");
    let cargo = format!(
        "#!/bin/sh\ncase \"$2\" in\nlist) printf '%s\\n' {listed} ;;\nbuild) for t in {listed}; do : > {}/$t; done ;;\n*) exit 1 ;;\nesac\n",
        built.display()
    );
    let zip = "#!/bin/sh\nwhile [ \"${1#-}\" != \"$1\" ]; do shift; done\n: > \"$1\"\n";
    for (name, script) in [("cargo", cargo.as_str()), ("zip", zip)] {
        fs::write(bin.join(name), script).expect("a script");
    }
    let path = std::env::var("PATH").unwrap_or_default();
    let made = Command::new("bash")
        .args(["-c", "chmod +x \"$1\"/* && exec bash \"$2\"", "-"])
        .arg(&bin)
        .arg(clone.join(".clusterfuzzlite/build.sh"))
        .current_dir(&source)
        .env("PATH", format!("{}:{path}", bin.display()))
        .env("OUT", &out)
        .output()
        .expect("bash");
    assert!(made.status.success(), "{}", text(&made.stderr));
    for target in &targets {
        assert!(out.join(target).is_file(), "{target}");
        assert!(
            out.join(format!("{target}_seed_corpus.zip")).is_file(),
            "{target}"
        );
    }
    let dictionaries = fs::read_dir(&out).expect("a folder").flatten();
    let dictionaries = dictionaries.filter(|file| file.path().extension().is_some_and(|name| name == "dict"));
    assert_eq!(dictionaries.count(), 4);
}

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
            assert!(
                name == "ACTION" || script.contains(&format!("${{{name}:-")),
                "{name}"
            );
        }
    });
}

#[test]
fn the_script_of_the_site_keeps_the_newest_runs_of_each_version_and_what_was_handed_in() {
    let job = CiJob::new();
    let reports = |name: &str, version: &str, day: u32| {
        let run = Command::new(STICKLER)
            .args(["run", "--cases", SUITE, "--report", name])
            .current_dir(job.folder.path())
            .output()
            .expect("the command runs");
        assert_eq!(run.status.code(), Some(1), "{}", text(&run.stderr));
        let path = job.path(&format!("{name}/events.jsonl"));
        let log = fs::read_to_string(&path).expect("a log");
        let (before, started) = log.split_once("\"started\":\"").expect("a date");
        let (_, after) = started.split_once('"').expect("its end");
        let dated = format!("{before}\"started\":\"2026-11-{day:02}T12:00:00Z\"{after}");
        let versioned = dated.replacen("\"version\":\"0.1.0\"", &format!("\"version\":\"{version}\""), 1);
        fs::write(path, versioned).expect("written");
    };
    reports("first", "1.0 beta", 1);
    reports("second", "1.0 beta", 2);
    reports("third", "1.1", 3);
    fs::create_dir_all(job.path("kept/handed-in")).expect("a folder");
    fs::copy(
        job.path("first/events.jsonl"),
        job.path("kept/handed-in/mine.jsonl"),
    )
    .expect("copied");
    fs::write(job.path("kept/handed-in/broken.jsonl"), "{}").expect("written");
    let site = |reports: &[&str]| {
        let built = Command::new("bash")
            .arg(format!("{ROOT}/.ci/site"))
            .args(["kept", "site"])
            .args(reports)
            .env("STICKLER", STICKLER)
            .env("CASES", SUITE)
            .env("KEEP", "1")
            .current_dir(job.folder.path())
            .output()
            .expect("bash");
        assert!(built.status.success(), "{}", text(&built.stderr));
        (text(&built.stdout), text(&built.stderr))
    };
    site(&["first", "third"]);
    let (told, notes) = site(&["second", "third"]);
    assert!(told.starts_with("3 runs of 1 engine"), "{told}");
    assert!(notes.contains("left out: kept/handed-in/broken.jsonl"), "{notes}");
    for (engines, newest) in [
        ("reference-1.0-beta", "2026-11-02T12-00-00Z-"),
        ("reference-1.1", "2026-11-03T12-00-00Z-"),
    ] {
        let kept = fs::read_dir(job.path(&format!("kept/runs/{engines}"))).expect("a folder");
        let names = kept
            .flatten()
            .map(|entry| entry.file_name().to_string_lossy().into_owned());
        let names: Vec<String> = names.collect();
        assert!(
            names.len() == 1 && names[0].starts_with(newest),
            "{engines}: {names:?}"
        );
    }
    assert!(
        job.path("site/runs/2.html").is_file(),
        "the page of a run is kept too"
    );
    assert!(job.read("site/index.html").contains("from 1.0 beta to 1.1"));
}
