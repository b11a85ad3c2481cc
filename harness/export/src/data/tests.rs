//! Tests the files of support data: the data fits the schema, and the types for TypeScript name every key.

use super::{DATA, SupportData, write_data};
use crate::ExportError;
use serde_json::Value;
use std::fs;
use std::path::Path;
use stickler_conversions::overview::{CaseStatement, StatementsBuilder};
use stickler_mdtest::schema::misfit;
use stickler_reference::semantics::is_standard_function;
use stickler_suite::Suite;
use stickler_types::{DialectName, MatrixWord, Question};

#[test]
fn the_types_for_typescript_have_the_keys_of_the_schema() {
    let types = include_str!("types.d.ts");
    let root: Value = serde_json::from_str(include_str!("schema.json")).expect("JSON");
    let definitions = root["$defs"].as_object().expect("definitions").iter();
    for (name, definition) in definitions.chain([(&"SupportData".to_owned(), &root)]) {
        assert!(types.contains(&format!(" {name} ")), "{name}");
        let body = types
            .split(&format!("interface {name} {{"))
            .nth(1)
            .unwrap_or_default();
        let body = body.split("\n}").next().unwrap_or_default();
        for (key, _) in definition["properties"].as_object().into_iter().flatten() {
            assert!(body.contains(&format!("\n  {key}: ")), "{name}.{key}");
        }
    }
}

#[test]
fn the_data_fits_the_schema_and_only_earlier_data_is_replaced() {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance-cases");
    let suite = Suite::load_files(&cases, stickler_suite::Wanted::default(), |_, _| false);
    let mut builder = StatementsBuilder::new(vec![DialectName::CODESYS, DialectName::IRONPLC_ED2]);
    for (question, basis) in [
        (
            "REAL_TO_INT(REAL#2.5) : INT",
            "codesys-recording: recordings/codesys.run.json",
        ),
        ("implicit(SINT,INT)", "codesys-implicit: implicit-conversions.csv"),
        ("bits(WORD,7)", "rule: not-stated"),
    ] {
        let statement = CaseStatement {
            case: &"a".into(),
            dialect: DialectName::CODESYS,
            word: MatrixWord::Yes,
            result: None,
            basis: &basis.into(),
        };
        builder.add(&question.parse::<Question>().expect("a question"), &statement);
    }
    let data = SupportData::gather(&suite, &builder, &[]);
    let folder = tempfile::tempdir().expect("a temporary folder");
    let into = folder.path().join("data");
    write_data(&data, &into).expect("data");
    write_data(&data, &into).expect("data again");
    let read = |name: &str| -> Value {
        serde_json::from_slice(&fs::read(into.join(name)).expect("a file")).expect("JSON")
    };
    let written = read(DATA);
    assert_eq!(misfit(&read("stickler-data.schema.json"), &written), None);
    let answers = &written["questions"]["REAL_TO_INT(REAL#2.5) : INT"];
    let codesys = answers.as_array().into_iter().flatten();
    let mut codesys = codesys.filter(|answer| answer["systems"][0] == "codesys");
    let answer = codesys.next().expect("an answer");
    assert_eq!(
        (&answer["answer"], &answer["kind"]),
        (&"INT#3".into(), &"chosen".into())
    );
    for (name, function) in written["functions"].as_object().expect("functions") {
        assert!(is_standard_function(name, DialectName::IEC_ED3.rules()), "{name}");
        assert!(
            suite
                .features
                .get(function["feature"].as_str().expect("a key"))
                .is_some(),
            "{name}"
        );
    }
    for file in ["npm/index.json", "pypi/stickler_data/data.json"] {
        assert_eq!(read(file), written, "{file}");
    }
    assert_eq!(read("npm/package.json")["version"], suite.version);
    fs::remove_file(into.join(DATA)).expect("a file");
    let refused = write_data(&data, &into);
    assert!(matches!(refused, Err(ExportError::Occupied(..))), "{refused:?}");
}
