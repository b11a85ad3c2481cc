//! Passes that drop or simplify declarations: program organization units, sections, variables, types, initial values.

use super::draft::{TextChange, TextDraft, TextEdit};
use super::expressions::list_items;
use super::tree::{behind_blanks, bytes, place, pous, statements, with_semicolon};
use crate::reduce::Sites;
use std::ops::Range;
use stickler_syntax::source::Span;
use stickler_syntax::tree::{
    Declaration, ExpressionKind, Initializer, InitializerKind, Name, Pou, PouKind, SourceUnit,
    TypeSpecification, TypeSpecificationKind, VariableBlock, VariableGroup,
};

/// Drops program organization units, configurations and sections of global variables.
pub(super) fn drop_units(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("drop units", sites, |draft| {
        let unit = draft.tree();
        let places = unit
            .declarations
            .iter()
            .filter_map(|declaration| match declaration {
                Declaration::Pou(pou) => Some(pou.span),
                Declaration::Globals(block) => Some(block.span),
                Declaration::Configuration(configuration) => Some(configuration.span),
                Declaration::Types(_) => None,
            });
        let changes = places.map(|place| TextChange::drop(bytes(place)));
        draft.only_allowed(changes.collect())
    });
}

/// Makes a function block the program that runs, with plain variables.
pub(super) fn block_to_program(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("block to program", sites, |draft| {
        let unit = draft.tree();
        let Some(program) = pous(&unit).find(|pou| pou.kind == PouKind::Program) else {
            return Vec::new();
        };
        let is_block = |pou: &&Pou<'_>| pou.kind == PouKind::FunctionBlock;
        let changes = pous(&unit).filter(is_block).map(|block| {
            let head = block.span.start as usize..block.name.span.end as usize;
            let mut edits = vec![
                TextEdit::new(bytes(program.span), ""),
                TextEdit::new(head, format!("PROGRAM {}", program.name.text)),
                TextEdit::new(bytes(block.end), "END_PROGRAM"),
            ];
            for section in &block.blocks {
                let start = section.span.start as usize;
                let word = draft.text[start..].split_whitespace().next().unwrap_or_default();
                if ["VAR_INPUT", "VAR_OUTPUT", "VAR_IN_OUT"]
                    .iter()
                    .any(|kind| word.eq_ignore_ascii_case(kind))
                {
                    edits.push(TextEdit::new(start..start + word.len(), "VAR"));
                }
            }
            TextChange(edits)
        });
        draft.only_allowed(changes.collect())
    });
}

/// Drops sections of variables.
pub(super) fn drop_sections(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("drop sections", sites, |draft| {
        let unit = draft.tree();
        let changes = blocks(&unit)
            .into_iter()
            .map(|block| TextChange::drop(bytes(block.span)));
        draft.only_allowed(changes.collect())
    });
}

/// Drops unused declarations of variables, fields and types.
pub(super) fn drop_unused(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("drop unused", sites, |draft| {
        let unit = draft.tree();
        let text = draft.text.as_str();
        let mut changes = Vec::new();
        for block in blocks(&unit) {
            // A section that loses its only declaration goes with it.
            if let [group] = block.groups.as_slice()
                && group.names.len() == 1
            {
                changes.push(TextChange::drop(bytes(block.span)));
            } else {
                changes.extend(groups(text, &block.groups));
            }
        }
        for declaration in &unit.declarations {
            if let Declaration::Types(types) = declaration {
                for declared in types {
                    let end = end_of(text, &declared.specification, declared.initializer.as_ref());
                    let alone = types.len() == 1;
                    let from = declared.name.span.start as usize;
                    changes.push(TextChange::drop(if alone {
                        around_type(text, from, end)
                    } else {
                        from..end
                    }));
                    if let TypeSpecificationKind::Structure(fields) = &declared.specification.kind {
                        changes.extend(groups(text, fields));
                    }
                    changes.extend(enumerators(&unit, text, &declared.specification));
                }
            }
        }
        draft.only_allowed(changes)
    });
}

/// Extends a range from TYPE to END_TYPE if it is the only declaration between them.
fn around_type(text: &str, from: usize, end: usize) -> Range<usize> {
    let upper = text.to_ascii_uppercase();
    let start = upper
        .get(..from)
        .and_then(|before| before.rfind("TYPE"))
        .unwrap_or(from);
    let last = behind_blanks(text, end);
    let closing = upper.get(last..).is_some_and(|rest| rest.starts_with("END_TYPE"));
    start..if closing { last + "END_TYPE".len() } else { end }
}

/// Drops a variable together with every statement of its unit that names it; of nested statements the outermost that are
/// invalid without it.
pub(super) fn forget_variables(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("forget variables", sites, |draft| {
        let unit = draft.tree();
        let statements: Vec<Range<usize>> =
            statements(&unit).into_iter().map(|one| bytes(one.span)).collect();
        let mut changes = Vec::new();
        for pou in pous(&unit) {
            for block in &pou.blocks {
                for group in &block.groups {
                    if let ([name], Some(place)) = (group.names.as_slice(), group_place(&draft.text, group)) {
                        let mut edits = naming(&unit, pou, name, &statements);
                        if !edits.is_empty() {
                            edits.push(TextEdit::new(place, ""));
                            changes.push(TextChange(edits));
                        }
                    }
                }
            }
        }
        draft.only_allowed(changes)
    });
}

/// Replaces the innermost statements of a unit that name a variable by empty ones.
fn naming(
    unit: &SourceUnit<'_>,
    pou: &Pou<'_>,
    name: &Name<'_>,
    statements: &[Range<usize>],
) -> Vec<TextEdit> {
    let inside = bytes(pou.span);
    let uses = unit
        .expressions
        .iter()
        .filter_map(|expression| match &expression.kind {
            ExpressionKind::Name(used) if used.text.eq_ignore_ascii_case(name.text) => {
                Some(bytes(expression.span))
            }
            _ => None,
        });
    let mut edits: Vec<TextEdit> = Vec::new();
    for used in uses.filter(|used| inside.contains(&used.start)) {
        let around = statements
            .iter()
            .filter(|statement| statement.contains(&used.start));
        if let Some(innermost) = around.min_by_key(|statement| statement.len()) {
            let edit = TextEdit::new(innermost.clone(), "");
            if !edits.contains(&edit) {
                edits.push(edit);
            }
        }
    }
    edits
}

/// Drops initial values, RETAIN and CONSTANT, locations, the lengths of texts and the limits of subranges.
pub(super) fn drop_initials(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("drop initials", sites, |draft| {
        let unit = draft.tree();
        let mut changes = Vec::new();
        for block in blocks(&unit) {
            let open = block.span.start as usize;
            let first = block.groups.first().and_then(|group| group.names.first());
            let head = first.map_or(open, |name| name.span.start as usize);
            for word in ["RETAIN", "NON_RETAIN", "CONSTANT"] {
                let upper = draft
                    .text
                    .get(open..head)
                    .unwrap_or_default()
                    .to_ascii_uppercase();
                if let Some(at) = upper.find(word) {
                    changes.push(TextChange::drop(open + at..open + at + word.len()));
                }
            }
        }
        for group in blocks(&unit).iter().flat_map(|block| &block.groups) {
            if let (Some(location), Some(name)) = (group.location, group.names.last()) {
                changes.push(TextChange::drop(
                    name.span.end as usize..location.span.end as usize,
                ));
            }
        }
        for (specification, initializer) in specifications(&unit) {
            if let Some(initializer) = initializer {
                changes.push(TextChange::drop(bytes(Span {
                    start: specification.span.end,
                    end: initializer.span.end,
                })));
                if let InitializerKind::Array(elements) = &initializer.kind {
                    let ends = elements
                        .iter()
                        .filter_map(|element| Some(element.value.as_ref()?.span.end as usize));
                    let ends: Vec<usize> = ends.collect();
                    let place = bytes(initializer.span);
                    changes.extend(list_items(
                        &draft.text,
                        place.start,
                        &ends,
                        place.end.saturating_sub(1),
                    ));
                }
            }
            if let TypeSpecificationKind::Text { name, .. }
            | TypeSpecificationKind::Subrange { base: name, .. } = &specification.kind
            {
                changes.push(TextChange::drop(
                    name.span.end as usize..specification.span.end as usize,
                ));
            }
        }
        draft.only_allowed(changes)
    });
}

/// Replaces declared types of variables by their definitions.
pub(super) fn resolve_types(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("resolve types", sites, |draft| {
        let unit = draft.tree();
        let declared = unit.declarations.iter().filter_map(|declaration| match declaration {
            Declaration::Types(types) => Some(types),
            _ => None,
        });
        let mut changes = Vec::new();
        for declared in declared.flatten() {
            let used = specifications(&unit).into_iter().filter(|(one, _)| {
                matches!(&one.kind, TypeSpecificationKind::Named(name) if name.text.eq_ignore_ascii_case(declared.name.text))
            });
            let with = declared.specification.span.text(&draft.text);
            let edits: Vec<TextEdit> = used.map(|(one, _)| TextEdit::new(bytes(one.span), with)).collect();
            if !edits.is_empty() {
                changes.push(TextChange(edits));
            }
        }
        draft.only_allowed(changes)
    });
}

/// Returns all sections of variables.
fn blocks<'t, 's>(unit: &'t SourceUnit<'s>) -> Vec<&'t VariableBlock<'s>> {
    let mut found = Vec::new();
    for declaration in &unit.declarations {
        match declaration {
            Declaration::Pou(pou) => found.extend(&pou.blocks),
            Declaration::Globals(block) => found.push(block),
            Declaration::Configuration(configuration) => found.extend(&configuration.globals),
            Declaration::Types(_) => {}
        }
    }
    found
}

/// Returns the type of every variable, field and type declaration, with the initial value beside it.
fn specifications<'t, 's>(
    unit: &'t SourceUnit<'s>,
) -> Vec<(&'t TypeSpecification<'s>, Option<&'t Initializer<'s>>)> {
    let mut found = Vec::new();
    let mut add =
        |group: &'t VariableGroup<'s>| found.push((&group.specification, group.initializer.as_ref()));
    for block in blocks(unit) {
        block.groups.iter().for_each(&mut add);
    }
    for declaration in &unit.declarations {
        if let Declaration::Types(types) = declaration {
            for declared in types {
                if let TypeSpecificationKind::Structure(fields) = &declared.specification.kind {
                    fields.iter().for_each(&mut add);
                }
            }
        }
    }
    for declaration in &unit.declarations {
        if let Declaration::Types(types) = declaration {
            found.extend(
                types
                    .iter()
                    .map(|declared| (&declared.specification, declared.initializer.as_ref())),
            );
        }
    }
    found
}

/// Drops declarations of a list, and single names of declarations of several.
fn groups(text: &str, groups: &[VariableGroup<'_>]) -> Vec<TextChange> {
    let mut changes = Vec::new();
    for group in groups {
        changes.extend(group_place(text, group).map(TextChange::drop));
        for pair in group.names.windows(2) {
            changes.push(TextChange::drop(
                pair[0].span.start as usize..pair[1].span.start as usize,
            ));
            changes.push(TextChange::drop(
                pair[0].span.end as usize..pair[1].span.end as usize,
            ));
        }
    }
    changes
}

/// Returns the range from the first name to the semicolon.
fn group_place(text: &str, group: &VariableGroup<'_>) -> Option<Range<usize>> {
    let from = group.names.first()?.span.start as usize;
    Some(from..end_of(text, &group.specification, group.initializer.as_ref()))
}

/// Returns the end of a declaration after its semicolon.
fn end_of(text: &str, specification: &TypeSpecification<'_>, initializer: Option<&Initializer<'_>>) -> usize {
    let end = initializer.map_or(specification.span.end, |initializer| initializer.span.end);
    with_semicolon(text, end as usize)
}

/// Drops values of an enumeration.
fn enumerators(unit: &SourceUnit<'_>, text: &str, specification: &TypeSpecification<'_>) -> Vec<TextChange> {
    let TypeSpecificationKind::Enumeration { values, .. } = &specification.kind else {
        return Vec::new();
    };
    let ends: Vec<usize> = values
        .iter()
        .map(|(name, value)| value.map_or(name.span.end as usize, |value| place(unit, value).end))
        .collect();
    let from = values.first().map_or(0, |(name, _)| name.span.start as usize);
    let open = text
        .get(..from)
        .and_then(|before| before.rfind('('))
        .unwrap_or(from);
    list_items(text, open, &ends, specification.span.end as usize)
}
