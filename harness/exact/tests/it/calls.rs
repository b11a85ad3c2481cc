//! The rows of `tests/calls`, which the tests of the reference use too.
//!
//! - `calls` is followed by dialects and by choices that differ from theirs, such as `rounding=up`; a row is a call with typed
//!   literals, and its result, or a dash where no function takes this. Where a function gives several types, `: INT` says which is meant.
//! - `basis` is followed by dialects; a row has a source for each of them, by its name in the block `names`.
//! - `defined` defines a dialect of this name with other choices than `ironplc-ed3`; a row has a result and a source.
//! - `stated`: what the page of a vendor says. `implicit`: what a value becomes as another type.
//! - `nearest`: what a function of real numbers gives in the type behind it, or a dash.
//! - `functions`: the operand and the result of each form of a function.

use std::cell::RefCell;
use std::collections::HashMap;
use stickler_exact::{
    ImplicitResult, Signature, expected, implicit_result, nearest_result, signatures, stated_by_vendor, value,
};
use stickler_mdtest::{Block, Difference, same};
use stickler_types::{
    Dialect, DialectKind, DialectName, ElementaryType, Question, RealText, Rounding, Value, join,
};

#[test]
fn every_call_gives_what_its_row_says() {
    let names = RefCell::new(HashMap::new());
    stickler_mdtest::check(
        concat!(env!("CARGO_MANIFEST_DIR"), "/tests/calls"),
        |block| match block.kind() {
            "names" => block.rows(|name, source| {
                names.borrow_mut().insert(name.to_owned(), source.to_owned());
                Ok(())
            }),
            "calls" => calls(block),
            "basis" => block.rows(|call, sources| bases(block, call, sources, &names.borrow())),
            "defined" => defined(block, &names.borrow()),
            "stated" => block.rows(|call, result| stated(block, call, result)),
            "implicit" => block.rows(implicit),
            "nearest" => block.rows(|call, number| nearest(block, call, number)),
            "widening" => block
                .rows(|types, word| dialects(block).try_for_each(|dialect| widening(types, word, dialect))),
            "functions" => block.rows(|name, forms| {
                let differs = |dialect: DialectName| same(self::forms(name, dialect), forms.to_owned());
                dialects(block).try_for_each(differs)
            }),
            _ => vec![Difference::new(1, "no test reads such a block")],
        },
    );
}

fn dialects(block: &Block) -> impl Iterator<Item = DialectName> {
    let of = |word: &str| match word {
        "all" => DialectName::ALL.to_vec(),
        _ => vec![word.parse().expect("a dialect")],
    };
    block.options().flat_map(of).collect::<Vec<_>>().into_iter()
}

/// Returns a dialect with the choices that a block makes in its stead.
fn with_choices<'b>(dialect: Dialect, choices: impl Iterator<Item = &'b str>) -> Dialect {
    choices.fold(dialect, |mut dialect, word| match word.split_once('=') {
        Some(("digits", count)) => {
            dialect.conversions.real_text = RealText::SignificantDigits(count.parse().expect("a number"));
            dialect
        }
        Some(("rounding", word)) if dialect.kind != DialectKind::Custom => {
            let rounding = Rounding::from_word(word).expect("a rounding");
            dialect.conversions = dialect.conversions.with_rounding(rounding);
            dialect
        }
        Some((key, choice)) => {
            let basis = format!("{}: {key}", dialect.spelling);
            let stated = dialect.stating(&format!("conversions.{key}"), &format!("'{choice}'"), &basis);
            stated.expect("a choice")
        }
        None => panic!("{word} is no choice"),
    })
}

fn parsed(literal: &str) -> Result<Value, String> {
    Value::parse(literal).map_err(|error| error.to_string())
}

fn shown(value: Option<Value>) -> String {
    value.map_or_else(|| "-".to_owned(), |value| value.to_string())
}

/// Reads a call, and finds the signature that it has.
fn read(call: &str, dialect: DialectName) -> Result<(Signature, Vec<Value>), String> {
    let (call, result) = match call.rsplit_once(" : ") {
        Some((call, result)) => (call, ElementaryType::from_name(result)),
        None => (call, None),
    };
    let (function, operands) = call
        .strip_suffix(')')
        .and_then(|call| call.split_once('('))
        .ok_or("no call")?;
    let operands: Vec<&str> = match function.to_ascii_uppercase().starts_with("CONCAT") {
        true => operands.split(", ").collect(),
        false => vec![operands],
    };
    let operands: Vec<Value> = operands.into_iter().map(parsed).collect::<Result<_, _>>()?;
    let fits = |one: &Signature| one.takes(&operands) && result.is_none_or(|result| one.result == result);
    let found = signatures(function, dialect).into_iter().find(fits);
    found
        .map(|signature| (signature, operands))
        .ok_or_else(|| "no function takes this".to_owned())
}

fn calls(block: &Block) -> Vec<Difference> {
    let (choices, names): (Vec<&str>, Vec<&str>) = block.options().partition(|word| word.contains('='));
    let mut found = Vec::new();
    for name in names {
        let name: DialectName = name.parse().expect("a dialect");
        let dialect = with_choices(Dialect::of(name).clone(), choices.iter().copied());
        found.extend(block.rows(|call, result| {
            let Ok((signature, operands)) = read(call, name) else {
                return same("-", result);
            };
            let given = if choices.is_empty() {
                expected(&signature, &operands, name).value
            } else {
                value(&signature, &operands, &dialect.conversions)
            };
            same(given, parsed(result)?)
        }));
    }
    found
}

fn bases(block: &Block, call: &str, sources: &str, names: &HashMap<String, String>) -> Result<(), String> {
    for (dialect, name) in dialects(block).zip(sources.split(" | ")) {
        let said = match read(call, dialect) {
            Ok((signature, operands)) => expected(&signature, &operands, dialect).basis,
            Err(_) => None,
        };
        same(said.unwrap_or("-"), source(name, names)?).map_err(|what| format!("{dialect}: {what}"))?;
    }
    same(sources.split(" | ").count(), dialects(block).count())
}

/// Returns the source that a row names.
fn source<'n>(name: &'n str, names: &'n HashMap<String, String>) -> Result<&'n str, String> {
    match name.trim() {
        "-" => Ok("-"),
        name => names
            .get(name)
            .map(String::as_str)
            .ok_or_else(|| format!("`{name}` names no source")),
    }
}

fn defined(block: &Block, names: &HashMap<String, String>) -> Vec<Difference> {
    let mut words = block.options();
    let start = Dialect::custom(words.next().expect("a name"), DialectName::IRONPLC_ED3, "here");
    let dialect = DialectName::define(with_choices(start, words)).expect("a name of its own");
    block.rows(|call, answer| {
        let (result, name) = answer
            .split_once(" | ")
            .ok_or("a row has a result and a source")?;
        let (signature, operands) = read(call, dialect)?;
        let given = expected(&signature, &operands, dialect);
        same(given.value, parsed(result.trim())?)?;
        same(given.basis.unwrap_or("-"), source(name, names)?)
    })
}

fn stated(block: &Block, call: &str, result: &str) -> Result<(), String> {
    dialects(block).try_for_each(|dialect| {
        let (signature, operands) = read(call, dialect)?;
        let stated = stated_by_vendor(&signature, &operands, dialect);
        same(shown(stated.map(|(value, _)| value)), result.to_owned())
    })
}

fn nearest(block: &Block, call: &str, number: &str) -> Result<(), String> {
    let call = format!("{call} : {}", block.options().next().unwrap_or_default());
    let Ok(Question::Call(call)) = call.parse() else {
        return Err(format!("`{call}` is no call"));
    };
    let given = nearest_result(&call.function, &call.operands, call.result);
    same(shown(given), number.to_owned())
}

fn implicit(row: &str, result: &str) -> Result<(), String> {
    let (value, target) = row
        .split_once(" : ")
        .ok_or("a row begins with a value and a type")?;
    let value = parsed(value)?;
    let target = ElementaryType::from_name(target.trim()).ok_or("no such type")?;
    let given = match implicit_result(&value, target) {
        Some(ImplicitResult::Exactly(value)) => value.to_string(),
        Some(ImplicitResult::Open) => "open".to_owned(),
        None => "-".to_owned(),
    };
    let wanted = Value::parse(result).map_or_else(|_| result.to_owned(), |value| value.to_string());
    same(given, wanted)
}

fn widening(types: &str, word: &str, dialect: DialectName) -> Result<(), String> {
    let (from, to) = types.split_once(" : ").ok_or("a row has two types")?;
    let [from, to] = [from, to.trim()].map(ElementaryType::from_name);
    let said = stickler_exact::implicit(from.ok_or("no such type")?, to.ok_or("no such type")?, dialect);
    same(said.as_str(), word)
}

/// Returns the forms of a function as a row has them.
fn forms(name: &str, dialect: DialectName) -> String {
    let found = signatures(name, dialect);
    let form = |one: &Signature| format!("{} : {}", one.operands[0], one.result);
    match found.is_empty() {
        true => "-".to_owned(),
        false => join(found.iter().map(form), " | "),
    }
}
