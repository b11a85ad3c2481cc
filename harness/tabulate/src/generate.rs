//! From a `[generate]` table to calls.

use crate::call::Call;
use crate::inputs;
use stickler_suite::Generate;
use stickler_types::{ElementaryType, Value};

/// Returns the calls that a `[generate]` table stands for: each function for each pair of types with each input.
///
/// Functions that no dialect has are left out, so that the lists of types may be longer than those that belong together.
///
/// # Errors
/// A sentence, where an entry is no type, no input, or none of the words of `only`.
pub fn calls(generate: &Generate) -> Result<Vec<Call>, String> {
    let (sources, targets) = (types(&generate.from)?, types(&generate.to)?);
    let mut calls = Vec::new();
    for &from in &sources {
        for &to in &targets {
            let operands = inputs::operands(&generate.inputs, from, to)?;
            for function in functions(generate) {
                let function = function.replace("{from}", from.name()).replace("{to}", to.name());
                let of_function = operands
                    .iter()
                    .map(|operand| Call::new(&function, vec![operand.clone()], to));
                calls.extend(of_function.flatten());
            }
        }
    }
    if let Some(word) = &generate.only {
        if !["narrowed", "kept", "with-a-sign"].contains(&word.as_str()) {
            return Err(format!(
                "`only` is `narrowed`, `kept` or `with-a-sign`, not `{word}`"
            ));
        }
        calls.retain(|call| what_becomes(call) == Some(word));
    }
    Ok(calls)
}

/// Returns what becomes of the number of a call between integers and bit strings: `narrowed` where the target has fewer bits,
/// otherwise `kept` where the target holds the number, and `with-a-sign` where it does not.
fn what_becomes(call: &Call) -> Option<&'static str> {
    let (from, to) = (call.from(), call.to());
    let Value::Plain { raw, .. } = call.operands[0].value else {
        return None;
    };
    if !from.is_whole() || !to.is_whole() {
        return None;
    }
    let number = from.integer_value(raw);
    Some(match to.integer_value(to.wrap(number)) == number {
        _ if from.bits() > to.bits() => "narrowed",
        true => "kept",
        false => "with-a-sign",
    })
}

fn functions(generate: &Generate) -> Vec<&str> {
    if generate.functions.is_empty() {
        vec!["{from}_TO_{to}"]
    } else {
        generate.functions.iter().map(String::as_str).collect()
    }
}

/// Returns the types of a list, in which `ANY`, `ANY_INT` and `ANY_REAL` stand for several.
fn types(names: &[String]) -> Result<Vec<ElementaryType>, String> {
    let mut types = Vec::new();
    for name in names {
        let all = ElementaryType::ALL.into_iter();
        match name.as_str() {
            "ANY" => types.extend(all),
            "ANY_INT" => types.extend(all.filter(|ty| ty.is_integer())),
            "ANY_REAL" => types.extend(all.filter(|ty| ty.is_real())),
            _ => types.push(ElementaryType::from_name(name).ok_or_else(|| format!("`{name}` is no type"))?),
        }
    }
    Ok(types)
}
