//! Declarations: POUs, variable sections, types, initial values, configurations.

use super::names::NameShape;
use super::writer::Writer;
use crate::tree::{
    Access, ArrayElement, CaseFolded, Configuration, Declaration, Edge, Initializer, InitializerKind, Name,
    Pou, PouKind, Resource, TypeDeclaration, TypeSpecification, TypeSpecificationKind, VariableBlock,
    VariableGroup,
};
use rustc_hash::FxHashMap;
use stickler_types::ElementaryType;

impl<'u, 's> Writer<'u, 's> {
    /// The whole text; an empty line stands between declarations.
    pub(super) fn source_unit(&mut self) {
        for (index, declaration) in self.unit.declarations.iter().enumerate() {
            if index > 0 {
                self.end();
            }
            match declaration {
                Declaration::Pou(pou) => self.pou(pou, pou.modifiers.access),
                Declaration::Types(types) => self.types(types),
                Declaration::Globals(block) => self.block_of_variables(block),
                Declaration::Configuration(configuration) => self.configuration(configuration),
                Declaration::Namespace(name) => self.line(&format!("NAMESPACE {}", name.text)),
                Declaration::EndNamespace(_) => self.line("END_NAMESPACE"),
                Declaration::Using(name) => self.line(&format!("USING {};", name.text)),
            }
        }
    }

    /// A POU; `own_access` is the access specifier that is written with it.
    fn pou(&mut self, pou: &'u Pou<'s>, own_access: Option<Access>) {
        let closing = pou.kind.closer().text();
        self.begin();
        self.put(closing.trim_start_matches("END_"));
        match pou.kind {
            PouKind::Getter | PouKind::Setter => {
                self.access(own_access);
                self.end();
            }
            _ => self.head(pou, own_access),
        }
        let around = self.pou.replace(pou.span.start);
        pou.blocks.iter().for_each(|block| self.block_of_variables(block));
        self.members(&pou.members);
        self.indented(|writer| writer.statements(&pou.body));
        self.line(closing);
        self.pou = around;
    }

    /// The name of a POU with the keywords around it, and its result type.
    fn head(&mut self, pou: &'u Pou<'s>, access: Option<Access>) {
        self.access(access);
        for word in pou.modifiers.words() {
            self.out.extend([" ", word]);
        }
        self.out.extend([" ", pou.name.text]);
        if pou.kind != PouKind::Function {
            self.using(&pou.using);
        }
        for (word, names) in [(" EXTENDS ", &pou.extends), (" IMPLEMENTS ", &pou.implements)] {
            self.put(if names.is_empty() { "" } else { word });
            self.list(names, |writer, name| writer.put(writer.names.pou_name(name.text)));
        }
        if let Some(result) = &pou.result {
            self.put(" : ");
            self.specification(result);
        }
        if pou.kind == PouKind::Function {
            self.using(&pou.using);
        }
        self.end();
    }

    /// USING in the head of a POU.
    fn using(&mut self, names: &[Name<'s>]) {
        for name in names {
            self.out.extend([" USING ", name.text, ";"]);
        }
    }

    /// An access specifier behind another word.
    fn access(&mut self, access: Option<Access>) {
        if let Some(access) = access {
            self.out.extend([" ", access.as_str()]);
        }
    }

    /// Methods and properties. An access specifier that GET and SET do not share stands with each.
    fn members(&mut self, members: &'u [Pou<'s>]) {
        self.indented(|writer| {
            for parts in members.chunk_by(|one, next| one.name.span == next.name.span) {
                if parts[0].kind == PouKind::Method {
                    writer.pou(&parts[0], parts[0].modifiers.access);
                    continue;
                }
                let access = parts[0].modifiers.access;
                let is_shared = parts.iter().all(|part| part.modifiers.access == access);
                writer.begin();
                writer.put("PROPERTY");
                writer.head(&parts[0], access.filter(|_| is_shared));
                for part in parts {
                    let access = part.modifiers.access.filter(|_| !is_shared);
                    writer.indented(|writer| writer.pou(part, access));
                }
                writer.line("END_PROPERTY");
            }
        });
    }

    fn block_of_variables(&mut self, block: &'u VariableBlock<'s>) {
        self.begin();
        self.put(block.kind.as_str());
        self.access(block.access);
        self.put(if block.constant { " CONSTANT" } else { "" });
        if let Some(retention) = block.retention {
            self.put(" ");
            self.capitals(retention.0);
        }
        self.end();
        self.groups(&block.groups);
        self.line("END_VAR");
    }

    fn groups(&mut self, groups: &'u [VariableGroup<'s>]) {
        self.indented(|writer| {
            for group in groups {
                writer.begin();
                writer.list(&group.names, |writer, name| writer.put(name.text));
                if let Some(location) = group.location {
                    writer.put(" AT ");
                    writer.capitals(location.text);
                }
                writer.declared(&group.specification, group.edge, group.initializer.as_ref());
            }
        });
    }

    fn types(&mut self, types: &'u [TypeDeclaration<'s>]) {
        self.line("TYPE");
        self.indented(|writer| {
            for declared in types {
                writer.begin();
                writer.put(declared.name.text);
                if let Some(base) = declared.extends {
                    writer.put(" EXTENDS ");
                    writer.type_name(&base);
                }
                writer.declared(&declared.specification, None, declared.initializer.as_ref());
            }
        });
        self.line("END_TYPE");
    }

    /// Writes the type, the edge qualifier and the initial value behind the name in a declaration.
    fn declared(
        &mut self,
        specification: &'u TypeSpecification<'s>,
        edge: Option<Edge>,
        initializer: Option<&'u Initializer<'s>>,
    ) {
        self.put(" : ");
        self.specification(specification);
        if let Some(edge) = edge {
            self.out.extend([" ", edge.as_str()]);
        }
        if let Some(initializer) = initializer {
            self.put(" := ");
            self.initializer(initializer, NameShape::Typed(specification));
        }
        self.put(";");
        self.end();
    }

    fn specification(&mut self, specification: &'u TypeSpecification<'s>) {
        match &specification.kind {
            TypeSpecificationKind::Named(name) => self.type_name(name),
            TypeSpecificationKind::Text { name, length } => {
                self.type_name(name);
                self.between_brackets(|writer| {
                    writer.expression(*length);
                });
            }
            TypeSpecificationKind::Subrange { base, limits } => {
                self.type_name(base);
                self.put("(");
                self.range(*limits);
                self.put(")");
            }
            TypeSpecificationKind::Array { dimensions, element } => {
                self.put("ARRAY");
                self.between_brackets(|writer| {
                    writer.list(dimensions, |writer, limits| writer.range(*limits))
                });
                self.put(" OF ");
                self.specification(element);
            }
            TypeSpecificationKind::VariableLengthArray { dimensions, element } => {
                self.put("ARRAY");
                self.between_brackets(|writer| {
                    writer.list(0..*dimensions, |writer, _| writer.put("*"));
                });
                self.put(" OF ");
                self.specification(element);
            }
            TypeSpecificationKind::Pointer { form, target } => {
                self.put(form.as_str());
                self.put(" ");
                self.specification(target);
            }
            TypeSpecificationKind::Enumeration { base, values } => {
                let starts = base.as_ref().zip(values.first());
                let is_behind = starts.is_some_and(|(base, (first, _))| base.span.start > first.span.start);
                if let Some(base) = base.as_ref().filter(|_| !is_behind) {
                    self.type_name(base);
                    self.put(" ");
                }
                self.put("(");
                self.list(values, |writer, (name, value)| {
                    writer.put(name.text);
                    if let Some(value) = value {
                        writer.put(" := ");
                        writer.expression(*value);
                    }
                });
                self.put(")");
                if let Some(base) = base.as_ref().filter(|_| is_behind) {
                    self.put(" ");
                    self.type_name(base);
                }
            }
            TypeSpecificationKind::Structure(fields) | TypeSpecificationKind::Union(fields) => {
                let is_union = matches!(specification.kind, TypeSpecificationKind::Union(_));
                let word = ["STRUCT", "UNION"][usize::from(is_union)];
                self.put(word);
                self.end();
                self.groups(fields);
                self.begin();
                self.put("END_");
                self.put(word);
            }
            TypeSpecificationKind::Error => {}
        }
    }

    /// A type's name: as the text declares it, or in capitals where it is elementary.
    fn type_name(&mut self, name: &Name<'s>) {
        match self.names.type_name(name.text) {
            Some(spelling) => self.put(spelling),
            None if ElementaryType::from_name(name.text).is_some() => self.capitals(name.text),
            None => self.put(name.text),
        }
    }

    pub(super) fn initializer(&mut self, initializer: &'u Initializer<'s>, of: NameShape<'u, 's>) {
        match &initializer.kind {
            InitializerKind::Expression(value) => {
                self.expression(*value);
            }
            InitializerKind::Array(elements) => {
                let element = self.names.element(of);
                self.put("[");
                self.list(elements, |writer, entry| writer.array_element(entry, element));
                self.put("]");
            }
            InitializerKind::Structure(fields) => {
                self.put("(");
                self.list(fields, |writer, (name, value)| {
                    let (spelling, shape) = writer.names.member(of, name.text);
                    writer.put(spelling);
                    writer.put(" := ");
                    writer.initializer(value, shape);
                });
                self.put(")");
            }
        }
    }

    fn array_element(&mut self, entry: &'u ArrayElement<'s>, of: NameShape<'u, 's>) {
        if let Some(repetition) = entry.repetition {
            self.expression(repetition);
            self.put("(");
        }
        self.list(&entry.values, |writer, value| writer.initializer(value, of));
        self.put(if entry.repetition.is_some() { ")" } else { "" });
    }

    fn configuration(&mut self, configuration: &'u Configuration<'s>) {
        let Configuration {
            name,
            globals,
            resources,
            configured,
            ..
        } = configuration;
        self.out.extend(["CONFIGURATION ", name.text]);
        self.end();
        self.indented(|writer| {
            globals.iter().for_each(|block| writer.block_of_variables(block));
            resources.iter().for_each(|resource| writer.resource(resource));
            configured
                .iter()
                .for_each(|block| writer.block_of_variables(block));
        });
        self.line("END_CONFIGURATION");
    }

    fn resource(&mut self, resource: &'u Resource<'s>) {
        let Some((name, kind)) = &resource.header else {
            return self.resource_items(resource);
        };
        self.begin();
        self.out.extend(["RESOURCE ", name.text, " ON ", kind.text]);
        self.end();
        self.indented(|writer| writer.resource_items(resource));
        self.line("END_RESOURCE");
    }

    fn resource_items(&mut self, resource: &'u Resource<'s>) {
        let names = resource.tasks.iter().map(|task| task.name.text);
        let tasks: FxHashMap<_, _> = names.map(|name| (CaseFolded(name), name)).collect();
        for task in &resource.tasks {
            self.begin();
            self.out.extend(["TASK ", task.name.text]);
            if !task.properties.is_empty() {
                self.put("(");
                self.list(&task.properties, |writer, (name, value)| {
                    writer.capitals(name.text);
                    writer.put(" := ");
                    writer.expression(*value);
                });
                self.put(")");
            }
            self.put(";");
            self.end();
        }
        for program in &resource.programs {
            self.begin();
            self.out.extend(["PROGRAM ", program.name.text]);
            if let Some(task) = &program.task {
                let declared = tasks.get(&CaseFolded(task.text)).copied();
                self.out.extend([" WITH ", declared.unwrap_or(task.text)]);
            }
            let program = self.names.pou_name(program.type_name.text);
            self.out.extend([" : ", program, ";"]);
            self.end();
        }
    }
}
