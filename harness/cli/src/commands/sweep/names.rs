//! The list of conversion functions that is shown for an unknown name.

use std::io::Write;
use stickler_conversions::all_functions;
use stickler_types::{grouped_by_key, join, wrap};

/// Lists all conversion functions on stderr where no dialect has the named one. The list is long, so the caller's error message
/// about the name follows it.
pub fn list_unless_known(function: &str) {
    let names = all_functions();
    if names.iter().any(|name| name == function) {
        return;
    }
    // A closed stderr is no reason to fail.
    let _ = writeln!(
        anstream::stderr(),
        "Conversion functions, `…` standing for each of the types behind it:\n{}\n",
        list(&names)
    );
}

/// Returns the list of names, with one paragraph for each common beginning.
fn list(names: &[String]) -> String {
    let families = grouped_by_key(names.iter().map(|name| split(name)));
    let paragraphs = families
        .iter()
        .map(|(family, rests)| wrap(&format!("{family} {}", rests.join(" ")).replace(" \n", "\n")));
    join(paragraphs, "\n").trim_end().to_owned()
}

/// Splits a name into the beginning that it shares with others, and the rest; names without types follow `also:`.
fn split(name: &str) -> (String, &str) {
    for middle in ["_TO_BCD_", "_TRUNC_", "_TO_"] {
        if let Some(at) = name.find(middle) {
            let (front, rest) = name.split_at(at + middle.len());
            return (format!("{front}…"), rest);
        }
    }
    for front in ["TO_BCD_", "TO_", "TRUNC_"] {
        if let Some(rest) = name.strip_prefix(front) {
            return (format!("{front}…"), rest);
        }
    }
    ("also:".to_owned(), name)
}

#[cfg(test)]
mod tests {
    use super::{list, split};
    use stickler_conversions::all_functions;
    use stickler_mdtest::check_examples;

    #[test]
    fn golden_names() {
        check_examples("tests/names.md", |example| {
            let (family, rest) = split(example.text("name"));
            format!("{family} {rest}")
        });
    }

    #[test]
    fn every_name_can_be_put_together_from_the_list() {
        let names = all_functions();
        let list = list(&names);
        let words = list.split_whitespace().count();
        let families: std::collections::HashSet<String> = names.iter().map(|name| split(name).0).collect();
        assert_eq!(words, names.len() + families.len());
    }
}
