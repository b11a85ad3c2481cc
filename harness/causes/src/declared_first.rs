//! The declarations of a program in the order in which they use each other.

use crate::program::ReadProgram;
use crate::words::has_word;
use stickler_syntax::tree::Declaration;

/// Returns a program in which each type and each unit is declared before what uses it; `None` where that is so already, or where more than
/// types, units, global variables and configurations are declared.
pub(crate) fn declared_first(program: &ReadProgram<'_, '_>) -> Option<String> {
    let text = program.text;
    let mut left: Vec<(&str, String)> = Vec::new();
    for declaration in &program.unit.declarations {
        match declaration {
            Declaration::Types(types) => {
                for ty in types {
                    let start = ty.name.span.start as usize;
                    let behind = ty.specification.span.end as usize;
                    let end = behind + text[behind..].find(';')?;
                    left.push((
                        ty.name.text,
                        format!("TYPE\n    {};\nEND_TYPE", &text[start..end]),
                    ));
                }
            }
            Declaration::Pou(pou) => left.push((pou.name.text, pou.span.text(text).to_owned())),
            other => left.push(("", other.span()?.text(text).to_owned())),
        }
    }
    let mut ordered = Vec::new();
    let mut is_changed = false;
    while !left.is_empty() {
        let uses_other = |at: &usize| {
            let mut others = left.iter().enumerate();
            others.any(|(other, (name, _))| other != *at && !name.is_empty() && has_word(&left[*at].1, name))
        };
        let next = (0..left.len()).find(|at| !uses_other(at)).unwrap_or(0);
        is_changed |= next > 0;
        ordered.push(left.remove(next).1);
    }
    is_changed.then(|| ordered.join("\n\n") + "\n")
}
