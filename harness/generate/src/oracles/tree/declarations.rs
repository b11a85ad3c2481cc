//! POUs, variables, types, initial values and configurations.

use super::statements::statement;
use super::visitor::{Visitor, id, list, name, option, range};
use stickler_reference::syntax::tree::{
    ArrayElement, Configuration, Declaration, Initializer, InitializerKind, Pou, Resource, Task,
    TypeDeclaration, TypeSpecification, TypeSpecificationKind, VariableBlock, VariableGroup,
};

pub(super) fn declaration<V: Visitor>(declaration: &Declaration<'_>, visitor: &mut V) {
    match declaration {
        Declaration::Pou(of) => {
            visitor.number(1);
            pou(of, visitor);
        }
        Declaration::Types(types) => {
            visitor.number(2);
            list(types, visitor, type_declaration);
        }
        Declaration::Globals(globals) => {
            visitor.number(3);
            block(globals, visitor);
        }
        Declaration::Configuration(of) => {
            visitor.number(4);
            configuration(of, visitor);
        }
    }
}

fn pou<V: Visitor>(pou: &Pou<'_>, visitor: &mut V) {
    let Pou {
        kind,
        name,
        result,
        blocks,
        body,
        span,
        end,
    } = pou;
    visitor.enter(*span);
    visitor.number(*kind as u64);
    visitor.name(name);
    option(result.as_ref(), visitor, specification);
    list(blocks, visitor, block);
    list(body, visitor, statement);
    visitor.enter(*end);
    visitor.leave();
    visitor.leave();
}

fn block<V: Visitor>(block: &VariableBlock<'_>, visitor: &mut V) {
    let VariableBlock {
        kind,
        constant,
        retention,
        groups,
        span,
    } = block;
    visitor.enter(*span);
    visitor.number(*kind as u64);
    visitor.number(u64::from(*constant));
    option(retention.as_ref(), visitor, |word, visitor| {
        visitor.written(word, true)
    });
    list(groups, visitor, group);
    visitor.leave();
}

fn group<V: Visitor>(group: &VariableGroup<'_>, visitor: &mut V) {
    let VariableGroup {
        names,
        specification: of,
        initializer: value,
    } = group;
    list(names, visitor, name);
    specification(of, visitor);
    option(value.as_ref(), visitor, initializer);
}

fn type_declaration<V: Visitor>(declared: &TypeDeclaration<'_>, visitor: &mut V) {
    let TypeDeclaration {
        name,
        specification: of,
        initializer: value,
    } = declared;
    visitor.name(name);
    specification(of, visitor);
    option(value.as_ref(), visitor, initializer);
}

fn specification<V: Visitor>(specified: &TypeSpecification<'_>, visitor: &mut V) {
    let TypeSpecification { kind, span } = specified;
    visitor.enter(*span);
    match kind {
        TypeSpecificationKind::Named(of) => {
            visitor.number(1);
            visitor.name(of);
        }
        TypeSpecificationKind::Text { name, length } => {
            visitor.number(2);
            visitor.name(name);
            visitor.expression(*length);
        }
        TypeSpecificationKind::Subrange { base, limits } => {
            visitor.number(3);
            visitor.name(base);
            range(limits, visitor);
        }
        TypeSpecificationKind::Array { dimensions, element } => {
            visitor.number(4);
            list(dimensions, visitor, range);
            specification(element, visitor);
        }
        TypeSpecificationKind::Enumeration { base, values } => {
            visitor.number(5);
            option(base.as_ref(), visitor, name);
            list(values, visitor, |(value, given), visitor| {
                visitor.name(value);
                option(given.as_ref(), visitor, id);
            });
        }
        TypeSpecificationKind::Structure(fields) => {
            visitor.number(6);
            list(fields, visitor, group);
        }
        TypeSpecificationKind::Error => visitor.number(7),
    }
    visitor.leave();
}

fn initializer<V: Visitor>(value: &Initializer<'_>, visitor: &mut V) {
    let Initializer { kind, span } = value;
    visitor.enter(*span);
    match kind {
        InitializerKind::Expression(value) => {
            visitor.number(1);
            visitor.expression(*value);
        }
        InitializerKind::Array(elements) => {
            visitor.number(2);
            list(
                elements,
                visitor,
                |ArrayElement { repetition, value }, visitor| {
                    option(repetition.as_ref(), visitor, id);
                    option(value.as_ref(), visitor, initializer);
                },
            );
        }
        InitializerKind::Structure(fields) => {
            visitor.number(3);
            list(fields, visitor, |(name, value), visitor| {
                visitor.name(name);
                initializer(value, visitor);
            });
        }
    }
    visitor.leave();
}

fn configuration<V: Visitor>(configuration: &Configuration<'_>, visitor: &mut V) {
    let Configuration {
        name,
        globals,
        resources,
        span,
    } = configuration;
    visitor.enter(*span);
    visitor.name(name);
    list(globals, visitor, block);
    list(resources, visitor, resource);
    visitor.leave();
}

fn resource<V: Visitor>(resource: &Resource<'_>, visitor: &mut V) {
    let Resource {
        header,
        tasks,
        programs,
    } = resource;
    option(header.as_ref(), visitor, |(of, kind), visitor| {
        visitor.name(of);
        visitor.name(kind);
    });
    list(tasks, visitor, |Task { name, properties }, visitor| {
        visitor.name(name);
        list(properties, visitor, |(property, value), visitor| {
            visitor.name(property);
            visitor.expression(*value);
        });
    });
    list(programs, visitor, |program, visitor| {
        visitor.name(&program.name);
        option(program.task.as_ref(), visitor, name);
        visitor.name(&program.type_name);
    });
}
