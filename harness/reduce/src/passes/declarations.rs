//! Passes that drop or simplify declarations: program organization units, sections, variables, types, initial values.

use crate::TextView;
use crate::passes::parameters::{argument, calls, parameters};
use std::ops::Range;
use stickler_syntax::Edits;
use stickler_syntax::source::Span;
use stickler_syntax::token::TokenKind;
use stickler_syntax::tree::{
    Declaration, Expression, ExpressionKind, InitializerKind, Name, Pou, PouKind, Statement, StatementKind,
    TypeDeclaration, TypeSpecification, TypeSpecificationKind, VariableGroup, VariableKind,
};
use stickler_syntax::visitor::{Part, Place};

/// The type of the result of a function whose result does not matter.
const PLAIN_RESULT: &str = "INT";

/// Lists changes that drop program organization units, configurations and sections of global variables.
pub fn drop_units(view: &TextView<'_>) -> Vec<Edits> {
    let spans = view.unit.declarations.iter().filter_map(Declaration::span);
    view.only_allowed(spans.map(Edits::removing).collect())
}

/// Makes a function block or a function the program that runs, with plain variables; one of them is the result of the function.
pub fn unit_to_program(view: &TextView<'_>) -> Vec<Edits> {
    let Some(program) = view.unit.pous().find(|pou| pou.kind == PouKind::Program) else {
        return Vec::new();
    };
    // A PROGRAM of the standard has no methods and no properties, and implements nothing.
    let is_plain = |pou: &&Pou<'_>| pou.kind != PouKind::Program && !pou.is_object();
    let units = view.unit.pous().filter(is_plain);
    let changes = units.map(|unit| {
        let mut edits = Edits::removing(program.span);
        let name = unit.name.span;
        let head = format!("PROGRAM {}", program.name.text);
        edits.replace(unit.span.start as usize..name.end as usize, head);
        let call = calls(view, unit).into_iter().next();
        if let Some(result) = &unit.result {
            // The result is the variable that receives it.
            let receiver = call
                .and_then(|call| receiver(view, call))
                .unwrap_or(unit.name.text);
            for used in view.uses(unit, unit.name) {
                edits.replace(used.expression.span, receiver);
            }
            let variable = format!("\nVAR {receiver} : {}; END_VAR", result.span.text(view.text()));
            edits.replace(name.end as usize..result.span.end as usize, variable);
        }
        edits.extend(call.into_iter().flat_map(|call| begun_inputs(view, unit, call)));
        edits.replace(unit.end, "END_PROGRAM");
        for section in &unit.blocks {
            if let [word, ..] = view.inside(section.span.into())
                && let TokenKind::VarInput | TokenKind::VarOutput | TokenKind::VarInOut = word.kind
            {
                edits.replace(word.span, "VAR");
            }
        }
        edits
    });
    view.only_allowed(changes.collect())
}

/// Returns the variable to which the result of a call is assigned.
fn receiver<'t>(view: &TextView<'t>, call: &Expression<'_>) -> Option<&'t str> {
    let is_assigned = |statement: &&Statement| match statement.kind {
        StatementKind::Assignment { value, .. } => view.range_of_expression(value) == call.span.into(),
        _ => false,
    };
    let assigning = view.statements().into_iter().find(is_assigned)?;
    let StatementKind::Assignment { target, .. } = assigning.kind else {
        return None;
    };
    match &view.unit.expression(target)?.kind {
        ExpressionKind::Name(name) => Some(name.text),
        _ => None,
    }
}

/// Returns the edits by which inputs begin with the literals that a call gives them.
fn begun_inputs(view: &TextView<'_>, unit: &Pou<'_>, call: &Expression<'_>) -> Vec<Edits> {
    let mut edits = Vec::new();
    for (section, group, before) in parameters(unit) {
        let ty = declared(view, group);
        let begun = group.names.iter().enumerate().map(|(at, name)| {
            let value = argument(call, (name.text, before + at))?;
            let is_literal = matches!(view.unit.expression(value)?.kind, ExpressionKind::Literal(_));
            let value = view.range_of_expression(value);
            is_literal.then(|| format!("{} : {ty} := {};", name.text, &view.text()[value]))
        });
        let begun: Option<Vec<String>> = begun.collect();
        if let (VariableKind::Input, Some(begun), Some(range)) =
            (section.kind, begun, view.range_of_declaration(group))
        {
            edits.push(Edits::replacing(range, begun.join("\n")));
        }
    }
    edits
}

/// Drops sections of variables, and methods: each alone, and with its like in other units, since a function block has what an interface
/// demands that it implements.
pub(crate) fn drop_sections(view: &TextView<'_>) -> Vec<Edits> {
    let sections = view.sections().into_iter().map(|section| section.span);
    let sections = sections.map(|span| (span.text(view.text()), span));
    let members = view.unit.pous().flat_map(|pou| &pou.members);
    let parts: Vec<(&str, Span)> = sections
        .chain(members.map(|member| (member.name.text, member.span)))
        .collect();
    let alike = parts.iter().map(|(name, _)| {
        let like = parts.iter().filter(|(other, _)| other == name);
        let mut edits = Edits::new();
        edits.extend(like.map(|(_, span)| Edits::removing(*span)));
        edits
    });
    let alone = parts.iter().map(|(_, span)| Edits::removing(*span));
    view.only_allowed(alike.chain(alone).collect())
}

/// Joins a section of variables with the one before it of the same kind.
pub(crate) fn join_sections(view: &TextView<'_>) -> Vec<Edits> {
    let sections = view.sections();
    let pairs = sections.windows(2).filter(|pair| pair[0].kind == pair[1].kind);
    let between = pairs.filter_map(|pair| {
        let end = view.inside(pair[0].span.into()).last()?.span.start;
        let start = view.inside(pair[1].span.into()).first()?.span.end;
        Some(Edits::removing(end as usize..start as usize))
    });
    view.only_allowed(between.collect())
}

/// Makes parameters, external variables, and those that begin anew with each call, plain ones.
pub(crate) fn plain_sections(view: &TextView<'_>) -> Vec<Edits> {
    let words = view.sections().into_iter();
    let words = words.filter_map(|section| view.inside(section.span.into()).first());
    let special = words.filter(|word| !matches!(word.kind, TokenKind::Var | TokenKind::VarGlobal));
    view.only_allowed(special.map(|word| Edits::replacing(word.span, "VAR")).collect())
}

/// Gives functions a result of a plain type, which is a literal, and the same type to the variables that only receive it.
pub(crate) fn plain_results(view: &TextView<'_>) -> Vec<Edits> {
    let functions = view.unit.pous().filter(|pou| pou.kind == PouKind::Function);
    let changes = functions.filter_map(|function| {
        let result = function.result.as_ref()?;
        let is_plain = result.span.text(view.text()).eq_ignore_ascii_case(PLAIN_RESULT);
        let mut edits = Edits::replacing(result.span, PLAIN_RESULT);
        for used in view.uses(function, function.name) {
            match used.statement.map(|statement| &statement.kind) {
                Some(StatementKind::Assignment { value, .. }) if used.place == Place::Target => {
                    edits.replace(view.range_of_expression(*value), "0");
                }
                _ => return None,
            }
        }
        let is_call = |used: &Part<'_, '_>| match used.statement.map(|statement| &statement.kind) {
            Some(StatementKind::Assignment { value, .. }) if used.place == Place::Target => {
                let value = view.unit.expression(*value).map(|value| &value.kind);
                matches!(value, Some(ExpressionKind::Call { callee, .. })
                    if view.text()[view.range_of_expression(*callee)].eq_ignore_ascii_case(function.name.text))
            }
            _ => false,
        };
        for (pou, group) in view.variables() {
            let uses: Vec<_> = group.names.iter().flat_map(|name| view.uses(pou, *name)).collect();
            if !uses.is_empty() && uses.iter().all(is_call) {
                edits.replace(group.specification.span, PLAIN_RESULT);
            }
        }
        (!is_plain).then_some(edits)
    });
    view.only_allowed(changes.collect())
}

/// Lists changes that drop unused declarations of variables, fields and types.
pub fn drop_unused(view: &TextView<'_>) -> Vec<Edits> {
    let mut changes = Vec::new();
    for section in view.sections() {
        match section.groups.as_slice() {
            // A section that loses its only declaration goes with it.
            [group] if group.names.len() == 1 => changes.push(Edits::removing(section.span)),
            all => changes.extend(groups(view, all)),
        }
    }
    for declared in view.unit.types() {
        changes.push(Edits::removing(type_declaration(view, declared)));
        if let TypeSpecificationKind::Structure(fields) = &declared.specification.kind {
            changes.extend(groups(view, fields));
        }
        changes.extend(enumerators(view, &declared.specification));
    }
    view.only_allowed(changes)
}

/// Returns the range of a declaration of a type; from TYPE to END_TYPE if it is the only one between them.
fn type_declaration(view: &TextView<'_>, declared: &TypeDeclaration<'_>) -> Range<usize> {
    let from = declared.name.span.start as usize;
    let to = view.end_of(&declared.specification, declared.initializer.as_ref());
    match (view.previous(from), view.next(to)) {
        (Some(open), Some(close)) if (open.kind, close.kind) == (TokenKind::Type, TokenKind::EndType) => {
            open.span.start as usize..close.span.end as usize
        }
        _ => from..to,
    }
}

/// Drops a variable together with every statement of its unit that names it; of nested statements the outermost that are
/// invalid without it.
pub(crate) fn forget_variables(view: &TextView<'_>) -> Vec<Edits> {
    let changes = view
        .variables()
        .filter_map(|(pou, group)| match group.names.as_slice() {
            [name] => {
                let mut edits = naming(view, pou, *name).filter(|edits| !edits.is_empty())?;
                edits.remove(view.range_of_declaration(group)?);
                Some(edits)
            }
            _ => None,
        });
    view.only_allowed(changes.collect())
}

/// Puts another variable of the same unit and type in the place of a variable, whose declaration goes.
pub(crate) fn share_variables(view: &TextView<'_>) -> Vec<Edits> {
    let single = view.variables().filter_map(|(pou, group)| match group.names[..] {
        [name] => Some((
            pou,
            name,
            view.range_of_declaration(group)?,
            declared(view, group),
        )),
        _ => None,
    });
    let variables: Vec<_> = single.collect();
    let mut changes = Vec::new();
    for (pou, name, declaration, specification) in &variables {
        let others = variables.iter().filter(|(other, ..)| other.span == pou.span);
        for (_, other, _, _) in others
            .filter(|(_, other, _, same)| same.eq_ignore_ascii_case(specification) && other.span != name.span)
        {
            let mut edits = Edits::removing(declaration.clone());
            let uses = view.uses(pou, *name);
            for used in &uses {
                edits.replace(used.expression.span, other.text);
            }
            changes.push((uses.iter().any(|used| used.place == Place::Target), edits));
        }
    }
    // What is assigned stays.
    changes.sort_by_key(|(is_assigned, _)| *is_assigned);
    view.only_allowed(changes.into_iter().map(|(_, edits)| edits).collect())
}

/// Returns the type of variables as it is written.
fn declared<'t>(view: &TextView<'t>, group: &VariableGroup<'_>) -> &'t str {
    group.specification.span.text(view.text())
}

/// Removes the innermost statements of a unit that name a variable.
fn naming(view: &TextView<'_>, pou: &Pou<'_>, name: Name<'_>) -> Option<Edits> {
    let mut edits = Edits::new();
    for used in view.uses(pou, name) {
        edits.remove(used.statement?.span);
    }
    Some(edits)
}

/// Drops initial values, RETAIN and CONSTANT, locations, the lengths of texts and the limits of subranges.
pub(crate) fn drop_initials(view: &TextView<'_>) -> Vec<Edits> {
    let mut changes = Vec::new();
    for section in view.sections() {
        let words = view
            .inside(section.span.into())
            .iter()
            .skip(1)
            .take_while(|word| {
                matches!(
                    word.kind,
                    TokenKind::Retain | TokenKind::NonRetain | TokenKind::Constant
                )
            });
        changes.extend(words.map(|word| Edits::removing(word.span)));
    }
    for group in view.sections().iter().flat_map(|section| &section.groups) {
        if let (Some(location), Some(name)) = (group.location, group.names.last()) {
            changes.push(Edits::removing(
                name.span.end as usize..location.span.end as usize,
            ));
        }
    }
    for (specification, initializer) in view.specifications() {
        if let Some(initializer) = initializer {
            changes.push(Edits::removing(
                specification.span.end as usize..initializer.span.end as usize,
            ));
            if let InitializerKind::Array(elements) = &initializer.kind {
                let ends = elements
                    .iter()
                    .filter_map(|element| Some(element.values.last()?.span.end as usize));
                let ends: Vec<usize> = ends.collect();
                let (open, close) = (initializer.span.start as usize, initializer.span.end as usize);
                changes.extend(view.list_items(open, &ends, close));
            }
        }
        if let TypeSpecificationKind::Text { name, .. } | TypeSpecificationKind::Subrange { base: name, .. } =
            &specification.kind
        {
            changes.push(Edits::removing(
                name.span.end as usize..specification.span.end as usize,
            ));
        }
    }
    view.only_allowed(changes)
}

/// Replaces declared types of variables by their definitions, or by the type of a field; an enumeration without a name is another type.
pub(crate) fn resolve_types(view: &TextView<'_>) -> Vec<Edits> {
    let specifications = view.specifications();
    let mut changes = Vec::new();
    let is_enumeration = |one: &&TypeDeclaration<'_>| {
        matches!(one.specification.kind, TypeSpecificationKind::Enumeration { .. })
    };
    for declared in view.unit.types().filter(|one| !is_enumeration(one)) {
        // Of a structure, the type of a field may be what matters.
        let fields = match &declared.specification.kind {
            TypeSpecificationKind::Structure(fields) => fields.as_slice(),
            _ => &[],
        };
        let fields = fields.iter().map(|field| field.specification.span);
        for resolved in std::iter::once(declared.specification.span).chain(fields) {
            let mut edits = Edits::new();
            for (one, _) in &specifications {
                if let TypeSpecificationKind::Named(name) = &one.kind
                    && name.is(declared.name.text)
                {
                    edits.replace(one.span, resolved.text(view.text()));
                }
            }
            if !edits.is_empty() {
                edits.remove(type_declaration(view, declared));
                changes.push(edits);
            }
        }
    }
    view.only_allowed(changes)
}

/// Drops declarations of a list, and single names of declarations of several.
fn groups(view: &TextView<'_>, groups: &[VariableGroup<'_>]) -> Vec<Edits> {
    let mut changes = Vec::new();
    for group in groups {
        changes.extend(view.range_of_declaration(group).map(Edits::removing));
        for pair in group.names.windows(2) {
            let (one, next) = (pair[0].span, pair[1].span);
            changes.push(Edits::removing(one.start as usize..next.start as usize));
            changes.push(Edits::removing(one.end as usize..next.end as usize));
        }
    }
    changes
}

/// Drops values of an enumeration.
fn enumerators(view: &TextView<'_>, specification: &TypeSpecification<'_>) -> Vec<Edits> {
    let TypeSpecificationKind::Enumeration { values, .. } = &specification.kind else {
        return Vec::new();
    };
    let ends: Vec<usize> = values
        .iter()
        .map(|(name, value)| {
            value.map_or(name.span.end as usize, |value| {
                view.range_of_expression(value).end
            })
        })
        .collect();
    let first = values.first().map_or(0, |(name, _)| name.span.start as usize);
    let open = view
        .previous(first)
        .map_or(first, |open| open.span.start as usize);
    view.list_items(open, &ends, specification.span.end as usize)
}
