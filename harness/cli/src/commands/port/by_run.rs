//! Finds the programs, function blocks and functions whose outputs differ between two dialects, by executing them on boundary values
//! of their inputs.

use super::Finding;
use super::compare::first_difference;
use crate::commands::judge::{Judged, start_values};
use stickler_syntax::Edits;
use stickler_syntax::source::LineIndex;
use stickler_syntax::tree::{Pou, PouKind, VariableKind};
use stickler_types::{Dialect, DialectName};

/// The maximum number of variables of a program.
const MAX_VARIABLES: usize = 1000;

/// The number of scans for which each combination of inputs stays.
const SCANS: usize = 3;

/// Returns the text without the declarations that one of the dialects rejects or that have one of these lines, and without those that
/// use them. Lines stay where they are. Empty where what is rejected cannot be left out.
pub(super) fn accepted_part(text: &str, dialects: [DialectName; 2], mut without: Vec<u32>) -> String {
    let mut text = text.to_owned();
    loop {
        let errors = dialects.map(|dialect| stickler_reference::errors(&text, dialect));
        let mut lines: Vec<u32> = errors.iter().flatten().filter_map(|error| error.line).collect();
        lines.append(&mut without);
        let (unit, _) = stickler_syntax::parse(&text, Dialect::of(dialects[0]));
        let index = LineIndex::new(&text);
        let mut edits = Edits::new();
        for declaration in &unit.declarations {
            let Some(span) = declaration.span() else { continue };
            let of_span = index.line(span.start)..=index.line(span.end);
            if lines.iter().any(|line| of_span.contains(line)) {
                edits.replace(span, span.text(&text).replace(|character| character != '\n', " "));
            }
        }
        match (lines.is_empty(), edits.is_empty()) {
            (true, _) => return text,
            (false, true) => return String::new(),
            (false, false) => text = edits.apply(&text),
        }
    }
}

/// Returns what means something else in the second dialect: of the units of two texts, the second of which is the first or one made
/// of it, those whose outputs differ.
pub(super) fn findings(texts: [&str; 2], dialects: [DialectName; 2]) -> Vec<Finding> {
    let (unit, _) = stickler_syntax::parse(texts[0], Dialect::of(dialects[0]));
    unit.pous()
        .filter_map(|pou| finding(pou, texts, dialects))
        .collect()
}

fn finding(pou: &Pou<'_>, texts: [&str; 2], dialects: [DialectName; 2]) -> Option<Finding> {
    let name = pou.name.text;
    let [left, right] = [0, 1].map(|at| Judged::of(texts[at], dialects[at], Some(name)).ok());
    let (left, right) = (left?, right?);
    let is_of = |path: &str, kinds: &[VariableKind]| {
        let shown = left.shown(path);
        let head = shown.split(['.', '[']).next().unwrap_or_default();
        let blocks = pou.blocks.iter().filter(|block| kinds.contains(&block.kind));
        let mut names = blocks
            .flat_map(|block| &block.groups)
            .flat_map(|group| &group.names);
        names.any(|name| name.is(head))
            || pou.kind == PouKind::Function && kinds.contains(&VariableKind::Output) && head == name
    };
    let outputs = match pou.kind {
        PouKind::Program => &[VariableKind::Local, VariableKind::Output, VariableKind::External][..],
        _ => &[VariableKind::Output, VariableKind::InOut],
    };
    let values = start_values(&left.text, dialects[0], MAX_VARIABLES).ok()?.ok()?;
    let of_kinds = |kinds: &[VariableKind]| {
        values
            .iter()
            .filter(|(path, _)| is_of(path, kinds))
            .cloned()
            .collect::<Vec<_>>()
    };
    let inputs = of_kinds(&[VariableKind::Input]).into_iter();
    let inputs: Vec<_> = inputs
        .filter_map(|(path, value)| Some((path, value.elementary()?)))
        .collect();
    let outputs: Vec<String> = of_kinds(outputs).into_iter().map(|(path, _)| path).collect();
    let programs = [(dialects[0], &*left.text), (dialects[1], &*right.text)];
    let scans = if pou.kind == PouKind::Function { 1 } else { SCANS };
    let found = first_difference(programs, &inputs, &outputs, scans)??;
    let output = left.shown(&outputs[found.output]);
    let what = match pou.kind {
        PouKind::Function if output == name => format!("the result of `{name}`"),
        PouKind::Function => format!("`{output}` of `{name}`"),
        _ => format!("`{output}` of `{name}` after scan {}", found.scan),
    };
    let inputs = inputs.iter().map(|(path, _)| left.shown(path)).zip(found.inputs);
    let example = (inputs.collect(), found.results);
    Some(Finding::differs(
        texts[0],
        pou.name.span,
        &what,
        example,
        dialects,
        None,
    ))
}
