//! Tests of where a file is found and of the engines in it, and of the messages about mistakes in these.

use std::fs;
use std::path::Path;
use stickler_configuration::{ConfigurationFile, EngineEntry, EngineKind};
use stickler_engines::{Compiler, DependencyPaths};

use super::read;

#[test]
fn a_compiler_gets_its_places_and_each_knows_where_it_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let text = "# Ours.\n[engines.ironplc]\nlacks = [\"array\"]\nironplcc = \"bin/ironplcc\"\n\n[engines.old]\nadapter = \"ironplc\"\n\
                ironplcvm = \"/opt/old/ironplcvm\"\n";
    fs::write(folder.path().join("stickler.toml"), text).unwrap();
    let configuration = ConfigurationFile::find(folder.path()).unwrap();
    let Some(EngineEntry {
        written,
        kind: EngineKind::Compiler { compiler, places },
        lacks,
    }) = configuration.engine("ironplc")
    else {
        panic!("no compiler")
    };
    assert_eq!(
        (written.as_str(), *compiler),
        ("stickler.toml:2", Compiler::Ironplc)
    );
    assert_eq!(*lacks, ["array"]);
    let path = folder.path().join("bin/ironplcc");
    let expected = DependencyPaths::default().named("ironplcc", path, "stickler.toml:4".to_owned());
    assert_eq!(*places, expected);
    // Of a second version, environment variables say nothing.
    let Some(EngineKind::Compiler { places, .. }) = configuration.engine("old").map(|entry| &entry.kind)
    else {
        panic!("no compiler")
    };
    let expected = DependencyPaths::default()
        .named(
            "ironplcvm",
            "/opt/old/ironplcvm".into(),
            "stickler.toml:8".to_owned(),
        )
        .without_variables();
    assert_eq!(*places, expected);
    let names: Vec<&str> = configuration.engines().map(|(name, _)| name).collect();
    assert_eq!(names, ["ironplc", "old"]);
    assert_eq!(configuration.folder(), Some(folder.path()));
}

#[test]
fn a_command_line_is_an_engine() {
    let configuration = read("[engines.mine]\ncommand = \"python3 adapter.py\"\n").unwrap();
    let kind = configuration.engine("mine").map(|entry| &entry.kind);
    assert!(matches!(kind, Some(EngineKind::Command { line, .. }) if line == "python3 adapter.py"));
}

#[test]
fn the_file_of_a_folder_above_counts_and_none_is_none() {
    let folder = tempfile::tempdir().unwrap();
    let inside = folder.path().join("a/b");
    fs::create_dir_all(&inside).unwrap();
    fs::write(
        folder.path().join("stickler.toml"),
        "[engines.mine]\ncommand = \"x\"\n",
    )
    .unwrap();
    let configuration = ConfigurationFile::find(&inside).unwrap();
    let written = &configuration.engine("mine").unwrap().written;
    assert!(
        written.ends_with("stickler.toml:1") && Path::new(written).is_absolute(),
        "{written}"
    );
    let empty = read("").unwrap();
    assert_eq!(empty.engines().count(), 0);
    assert!(empty.path().is_some());
}

#[test]
fn a_file_that_cannot_be_read_is_named() {
    let error = ConfigurationFile::read(Path::new("no/such/file.toml")).unwrap_err();
    assert_eq!(error.to_string(), "cannot read no/such/file.toml");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("stickler.toml");
    fs::write(&path, b"\xff\xfe").unwrap();
    assert!(ConfigurationFile::read(&path).is_err());
}

#[test]
fn a_compiler_can_be_described() {
    let readme = include_str!("../../../engines/README.md");
    let (_, example) = readme.split_once("```toml\n[engines.described]").unwrap();
    let (example, _) = example.split_once("```").unwrap();
    let configuration = read(&format!("[engines.described]{example}")).unwrap();
    let kind = configuration.engine("described").map(|entry| &entry.kind);
    assert!(matches!(kind, Some(EngineKind::Described(_))), "{kind:?}");
}
