//! Tests of the dialects that a file defines: `tests/definitions.md`, and what no table can tell.

use crate::{mistake, read};
use stickler_types::DialectName;

/// Returns what a dialect is, a statement a line.
fn shown(name: DialectName) -> String {
    let definition = name.definition().unwrap();
    let about = definition.about.as_deref().unwrap_or("-");
    let mut text = format!(
        "{name}: extends {}, about {about}, {}\n",
        definition.base, definition.place
    );
    for ((from, to), stated) in &definition.cells {
        let basis = stated.basis.as_deref().unwrap_or("-");
        text += &format!("    implicit {from}.{to} = {}: {basis}\n", stated.value.as_str());
    }
    for (key, value) in definition.statements() {
        let basis = definition.basis(key).unwrap_or("-");
        text += &format!("    {key} = {value}: {basis}\n");
    }
    text
}

#[test]
fn golden_definitions_are_those_of_the_file() {
    stickler_mdtest::check_examples("tests/definitions.md", |example| {
        let dialects = read(example.text("toml")).unwrap();
        dialects
            .dialects()
            .iter()
            .map(|dialect| shown(*dialect))
            .collect()
    });
}

#[test]
fn a_file_may_have_many_dialects_and_be_read_twice() {
    let many: String = (0..300)
        .map(|number| format!("[dialects.many-{number}]\nextends = \"matiec\"\n"))
        .collect();
    assert_eq!(read(&many).unwrap().dialects().len(), 300);
    assert_eq!(read(&many).unwrap().dialects(), read(&many).unwrap().dialects());
    let chain: String = (1..300)
        .map(|number| format!("[dialects.chain-{number}]\nextends = \"chain-{}\"\n", number - 1))
        .collect();
    let chain = format!("{chain}[dialects.chain-0]\nextends = \"plcnext\"\n");
    let last = read(&chain).unwrap().dialects()[298];
    assert_eq!(last.base(), DialectName::PLCNEXT);
    assert_eq!(read("[dialects]\n").unwrap().dialects(), []);
}

#[test]
fn an_engine_may_speak_a_dialect_of_the_file() {
    let text = "[engines.mine]\ncheck = \"stc {file}\"\n[engines.mine.dialects]\nspoken = \"--spoken\"\n\
                [dialects.spoken]\nextends = \"matiec\"\n";
    assert!(read(text).is_ok());
    let message = mistake(&text.replace("\nspoken =", "\nnot-spoken ="));
    assert!(message.contains("unknown dialect `not-spoken`"), "{message}");
}
