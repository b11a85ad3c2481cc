//! The calls of `harness/exact/tests/calls`: both the oracle and the reference give what their rows say, each by its own arithmetic.

use stickler_mdtest::{Block, Difference, same};
use stickler_reference::conversion::{
    Conversion, concatenation, conversion_function_name, function, implicit,
};
use stickler_types::{Dialect, DialectName, ElementaryType, RealText, Rounding, Value, join};

#[test]
fn every_call_gives_what_its_row_says() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../exact/tests/calls");
    stickler_mdtest::check(folder, |block| match block.kind() {
        "calls" => calls(block),
        "functions" => block.rows(|name, forms| {
            let differs = |dialect| same(self::forms(name, dialect), forms.to_owned());
            dialects(block).try_for_each(differs)
        }),
        "widening" => block.rows(|types, word| {
            let [from, to] = types.split(" : ").map(ty).collect::<Vec<_>>()[..] else {
                return Err("a row has two types".to_owned());
            };
            let word_of = |dialect: &Dialect| {
                let has_both = dialect.has(from) && dialect.has(to);
                if has_both && implicit(from, to, dialect).is_some() {
                    "yes"
                } else {
                    "no"
                }
            };
            dialects(block).try_for_each(|dialect| same(word_of(dialect), word))
        }),
        "implicit" => block.rows(implicit_value),
        // What documents say is a matter of the oracle.
        _ => Vec::new(),
    });
}

fn ty(name: &str) -> ElementaryType {
    ElementaryType::from_name(name.trim()).expect("a type")
}

fn value(literal: &str) -> Result<Value, String> {
    Value::parse(literal).map_err(|error| error.to_string())
}

fn dialects(block: &Block) -> impl Iterator<Item = &'static Dialect> {
    let names = |word: &str| match word {
        "all" => DialectName::ALL.to_vec(),
        _ => vec![word.parse().expect("a dialect")],
    };
    let of: Vec<DialectName> = block
        .options()
        .filter(|word| !word.contains('='))
        .flat_map(names)
        .collect();
    of.into_iter().map(Dialect::of)
}

/// Returns a dialect with the choices of a block.
fn with_choices(block: &Block, dialect: &Dialect) -> Dialect {
    let choices = block.options().filter_map(|word| word.split_once('='));
    choices.fold(dialect.clone(), |mut dialect, (key, choice)| match key {
        "digits" => {
            dialect.conversions.real_text = RealText::SignificantDigits(choice.parse().expect("a number"));
            dialect
        }
        "rounding" => {
            let rounding = Rounding::from_word(choice).expect("a rounding");
            dialect.conversions = dialect.conversions.with_rounding(rounding);
            dialect
        }
        key => dialect
            .stating(
                &format!("conversions.{key}"),
                &format!("'{choice}'"),
                "test: a choice",
            )
            .expect("a choice"),
    })
}

fn calls(block: &Block) -> Vec<Difference> {
    let differences = |dialect| {
        let dialect = with_choices(block, dialect);
        block.rows(|call, result| {
            let given = called(call, &dialect)?;
            match result {
                "-" => same(given.is_some(), false),
                result => same(given.ok_or("no function takes this")?, value(result)?),
            }
        })
    };
    dialects(block).flat_map(differences).collect()
}

/// Returns the result of a call; `None` where the dialect has no such function, or it does not take the operand.
fn called(call: &str, dialect: &Dialect) -> Result<Option<Value>, String> {
    let (call, target) = match call.rsplit_once(" : ") {
        Some((call, result)) => (call, Some(ty(result))),
        None => (call, None),
    };
    let (name, operands) = call
        .strip_suffix(')')
        .and_then(|call| call.split_once('('))
        .ok_or("no call")?;
    if let Some(join) = concatenation(name, dialect) {
        let (date, time) = operands.split_once(", ").ok_or("two operands")?;
        let (Value::Plain { raw: date, .. }, Value::Plain { raw: time, .. }) = (value(date)?, value(time)?)
        else {
            return Err("a date and a time of day".to_owned());
        };
        return Ok(Some(Value::plain(join.result, join.apply_two(date, time))));
    }
    let operand = value(operands)?;
    let from = ty(operand.type_name());
    let Some(function) = function(name, dialect).filter(|function| function.accepts(from)) else {
        return Ok(None);
    };
    // Without a target, the first form of several.
    let target = target.or_else(|| function.results(from).next());
    let to = function.result_type(from, target);
    Ok(Some(converted(function.conversion(from, to), &operand)))
}

/// Converts a value.
fn converted(conversion: Conversion, operand: &Value) -> Value {
    let to = conversion.to;
    match operand {
        Value::Text { units, .. } if to.is_text() => Value::text(to, conversion.text_to_text(units)),
        Value::Text { units, .. } => Value::plain(to, conversion.apply_from_text(units)),
        Value::Plain { raw, .. } if to.is_text() => Value::text(to, conversion.apply_to_text(*raw)),
        Value::Plain { raw, .. } => Value::plain(to, conversion.apply(*raw)),
        other => panic!("{other} has no conversion"),
    }
}

/// Returns the forms of a function as a row has them.
fn forms(name: &str, dialect: &Dialect) -> String {
    if let Some(join) = concatenation(name, dialect) {
        return format!("{} : {}", join.operands[0], join.result);
    }
    let Some(function) = function(name, dialect) else {
        return "-".to_owned();
    };
    let taken = ElementaryType::ALL
        .into_iter()
        .filter(|&from| function.accepts(from));
    let forms = taken.flat_map(|from| function.results(from).map(move |to| format!("{from} : {to}")));
    join(forms, " | ")
}

/// Holds a value that converts implicitly in some dialect to what becomes of it there.
fn implicit_value(row: &str, result: &str) -> Result<(), String> {
    let (operand, to) = row
        .split_once(" : ")
        .ok_or("a row begins with a value and a type")?;
    let operand = value(operand)?;
    let from = ty(operand.type_name());
    let mut converting = DialectName::ALL.into_iter();
    let conversion = converting.find_map(|name| implicit(from, ty(to), Dialect::of(name)));
    match (conversion, value(result)) {
        (Some(conversion), Ok(result)) => same(converted(conversion, &operand), result),
        (None, Ok(_)) => Err("no dialect converts this".to_owned()),
        // Where the oracle leaves the result open, the reference has one, which nobody asserts.
        (_, Err(_)) => Ok(()),
    }
}

#[test]
fn the_implicit_conversion_is_that_of_the_function() {
    let mut count = 0;
    for dialect in DialectName::ALL.map(Dialect::of) {
        for (from, to) in pairs() {
            let function = function(&format!("{from}_TO_{to}"), dialect);
            if let Some((function, implicit)) = function.zip(implicit(from, to, dialect)) {
                assert_eq!(function.conversion(from, to), implicit, "{}", dialect.name);
                count += 1;
            }
        }
    }
    assert!(count > 1_000, "only {count} pairs");
}

/// Returns every ordered pair of types.
fn pairs() -> impl Iterator<Item = (ElementaryType, ElementaryType)> {
    let all = ElementaryType::ALL.into_iter();
    all.flat_map(|from| ElementaryType::ALL.map(|to| (from, to)))
}

#[test]
fn a_suggested_name_is_a_function_from_and_to_these_types() {
    for name in DialectName::ALL {
        let dialect = Dialect::of(name);
        for (from, to) in pairs() {
            if let Some(suggested) = conversion_function_name(from, to, dialect) {
                assert_eq!(
                    forms(&suggested, dialect),
                    format!("{from} : {to}"),
                    "{name}: {suggested}"
                );
            }
        }
    }
    let ed2 = Dialect::of(DialectName::IRONPLC_ED2);
    let suggested = |from, to| conversion_function_name(ty(from), ty(to), ed2);
    assert_eq!(suggested("DINT", "INT").as_deref(), Some("DINT_TO_INT"));
    assert_eq!(
        (suggested("INT", "INT"), suggested("LTIME", "LINT")),
        (None, None)
    );
}

#[test]
fn a_name_of_any_length_is_looked_up() {
    assert!(function(&"X".repeat(100_000), Dialect::of(DialectName::IRONPLC_ED3)).is_none());
}
