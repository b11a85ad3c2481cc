//! The tests that are tables and files in `tests/examples`.

use crate::root;
use stickler_mdtest::{Example, check_examples};
use stickler_tabulate::call::Call;
use stickler_tabulate::table::Table;
use stickler_tabulate::{folder, generate, inputs};
use stickler_types::{DialectName, ElementaryType, WrittenValue, join};

fn ty(name: &str) -> ElementaryType {
    ElementaryType::from_name(name).unwrap_or_else(|| panic!("`{name}` is no type"))
}

/// Returns the operands that the entries of the column `inputs` stand for.
fn operands(example: &Example) -> String {
    let entries: Vec<String> = example
        .text("inputs")
        .split_whitespace()
        .map(str::to_owned)
        .collect();
    let operands = inputs::operands(&entries, ty(example.text("from")), ty(example.text("to")));
    operands.map_or_else(
        |message| message,
        |operands| join(operands.iter().map(|operand| &*operand.literal), " "),
    )
}

#[test]
fn golden_inputs() {
    check_examples("tests/examples/inputs.md", operands);
}

#[test]
fn golden_calls() {
    check_examples("tests/examples/calls.md", |example| {
        if let Some(head) = example.get("generate") {
            let calls = generate::calls(&toml::from_str(head).unwrap());
            let texts = |calls: Vec<Call>| join(calls, " ");
            return calls.map_or_else(|message| message, texts);
        }
        let operand = WrittenValue::parse(ty(example.text("from")), example.text("input")).unwrap();
        let Some(call) = Call::new(example.text("function"), vec![operand], ty(example.text("to"))) else {
            return "no call".to_owned();
        };
        let dialect: DialectName = example.text("dialect").parse().unwrap();
        call.expected(dialect).map_or_else(
            || "not in the dialect".to_owned(),
            |expected| format!("{} by {}", expected.value, expected.basis.unwrap_or("nobody")),
        )
    });
}

#[test]
fn golden_tables() {
    let names = folder::names(&root()).unwrap();
    check_examples("tests/examples/tables.md", |example| {
        let table = Table::read("example", example.text("table.toml"), &names).unwrap();
        let calls = || table.calls();
        let shown = match example.wanted() {
            "is of calls" => Ok(table.is_of_calls().to_string()),
            "calls" => calls().map(|calls| join(calls, " ")),
            "expected" => calls()
                .and_then(|calls| table.expected(&calls[0]))
                .map(|agreed| join(agreed.into_iter().map(|one| one.value), " or ")),
            _ => calls().and_then(|calls| Ok(table.with_rows(&table.rows_of(&calls)?))),
        };
        shown.unwrap_or_else(|message| message)
    });
}
