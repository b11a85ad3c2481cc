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
    let has_bits = |ty: ElementaryType| ty.is_integer() || ty.is_bit_string();
    let Value::Plain { raw, .. } = call.operands[0].value else {
        return None;
    };
    if !has_bits(from) || !has_bits(to) {
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

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(generate: &str) -> Result<Vec<String>, String> {
        let calls = calls(&toml::from_str(generate).unwrap())?;
        Ok(calls.iter().map(Call::to_string).collect())
    }

    #[test]
    fn each_function_is_called_for_each_pair_of_types_with_each_input() {
        let generate = "from = ['SINT', 'BOOL']\nto = ['SINT', 'BYTE']\ninputs = ['5', 'TRUE']";
        assert_eq!(
            texts(generate).unwrap(),
            [
                "SINT_TO_BYTE(SINT#5)",
                "BOOL_TO_SINT(BOOL#TRUE)",
                "BOOL_TO_BYTE(BOOL#TRUE)"
            ]
        );
    }

    #[test]
    fn a_function_that_no_dialect_has_is_left_out() {
        let generate =
            "functions = ['ROUND', 'TRUNC_{to}']\nfrom = ['REAL']\nto = ['DINT', 'INT']\ninputs = ['0.5']";
        assert_eq!(
            texts(generate).unwrap(),
            ["ROUND(REAL#0.5)", "TRUNC_DINT(REAL#0.5)", "TRUNC_INT(REAL#0.5)"]
        );
    }

    #[test]
    fn calls_are_told_apart_by_what_becomes_of_the_number() {
        let calls = |only| {
            texts(&format!(
                "from = ['INT']\nto = ['SINT', 'UINT', 'DINT', 'DWORD']\ninputs = ['-1', '5']\nonly = '{only}'"
            ))
        };
        assert_eq!(
            calls("narrowed").unwrap(),
            ["INT_TO_SINT(INT#-1)", "INT_TO_SINT(INT#5)"]
        );
        assert_eq!(
            calls("kept").unwrap(),
            [
                "INT_TO_UINT(INT#5)",
                "INT_TO_DINT(INT#-1)",
                "INT_TO_DINT(INT#5)",
                "INT_TO_DWORD(INT#5)"
            ]
        );
        assert_eq!(
            calls("with-a-sign").unwrap(),
            ["INT_TO_UINT(INT#-1)", "INT_TO_DWORD(INT#-1)"]
        );
        let error = calls("widened").unwrap_err();
        assert!(error.ends_with("not `widened`"), "{error}");
    }

    #[test]
    fn an_unknown_type_is_an_error() {
        let error = texts("from = ['ANY_INTS']\nto = ['INT']\ninputs = ['0']").unwrap_err();
        assert_eq!(error, "`ANY_INTS` is no type");
    }
}
