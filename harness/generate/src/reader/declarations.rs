//! Reading of types, variables and program organization units.

use super::{Reader, named};
use crate::generator::TypeContext;
use crate::model::{
    ArrayType, DeclaredKind, InitialValue, Pou, Type, TypeDeclaration, Variable, VariableSection, subscripts,
};
use stickler_syntax::tree::{
    self, Access, Declaration, ExpressionId, Initializer, InitializerKind, Name, PouKind, TypeSpecification,
    TypeSpecificationKind, VariableBlock, VariableGroup, VariableKind,
};
use stickler_types::ElementaryType;

impl<'t> Reader<'t> {
    /// Reads the whole text; exactly one of its units is a program.
    pub(super) fn declarations(&mut self) -> Option<()> {
        let unit = self.unit;
        let mut programs = 0;
        for declaration in &unit.declarations {
            match declaration {
                Declaration::Types(types) => {
                    for declared in types {
                        let declared = self.type_declaration(declared)?;
                        self.program.types.push(declared);
                    }
                }
                Declaration::Pou(pou) => {
                    programs += usize::from(pou.kind == PouKind::Program);
                    self.pou(pou, None)?;
                }
                _ => return None,
            }
        }
        (programs == 1).then_some(())
    }

    fn type_declaration(&self, declared: &tree::TypeDeclaration<'t>) -> Option<TypeDeclaration> {
        if declared.initializer.is_some() {
            return None;
        }
        let kind = match &declared.specification.kind {
            TypeSpecificationKind::Structure(groups) => {
                let mut fields = Vec::new();
                for group in groups {
                    let ty = self.ty(&group.specification)?;
                    let initial = match &group.initializer {
                        Some(initial) => Some(self.value(expression(initial)?, &ty, TypeContext::Initial)?),
                        None => None,
                    };
                    let names = names(group)?;
                    fields.extend(names.map(|name| (name, ty.clone(), initial.clone())));
                }
                DeclaredKind::Structure(fields)
            }
            TypeSpecificationKind::Enumeration { base: None, values } => {
                let names = values
                    .iter()
                    .map(|(name, number)| number.is_none().then(|| name.text.to_owned()));
                DeclaredKind::Enumeration(names.collect::<Option<_>>()?)
            }
            _ => DeclaredKind::Alias(self.ty(&declared.specification)?),
        };
        Some(TypeDeclaration {
            name: declared.name.text.to_owned(),
            kind,
        })
    }

    fn ty(&self, specification: &TypeSpecification<'t>) -> Option<Type> {
        match &specification.kind {
            TypeSpecificationKind::Named(name) => self.named_type(name),
            TypeSpecificationKind::Pointer { target, .. } => {
                Some(Type::Reference(Box::new(self.ty(target)?)))
            }
            TypeSpecificationKind::Array { dimensions, element } => {
                let limit = |id: &ExpressionId| i64::try_from(self.integer(*id)?).ok();
                let dimensions = dimensions.iter().map(|(low, high)| {
                    let limits = (limit(low)?, limit(high)?);
                    (limits.0 <= limits.1).then_some(limits)
                });
                Some(Type::Array(Box::new(ArrayType {
                    dimensions: dimensions.collect::<Option<_>>()?,
                    element: self.ty(element)?,
                })))
            }
            _ => None,
        }
    }

    fn named_type(&self, name: &Name<'_>) -> Option<Type> {
        let program = &self.program;
        if let Some(ty) = ElementaryType::from_name(name.text) {
            return Some(Type::Elementary(ty));
        }
        let declared = named(program.types.iter().map(|one| &one.name), name.text);
        let block = || named(program.blocks.iter().map(|one| &one.name), name.text);
        declared.map(Type::Declared).or_else(|| block().map(Type::Block))
    }

    /// Reads a unit; a method with the function block that owns it.
    fn pou(&mut self, pou: &'t tree::Pou<'t>, owner: Option<usize>) -> Option<()> {
        let is_public = pou.modifiers.access == owner.map(|_| Access::Public);
        let is_plain = is_public && pou.modifiers.words().next().is_none();
        let has_members = pou.kind == PouKind::FunctionBlock || pou.members.is_empty();
        if !is_plain || !has_members || !pou.extends.is_empty() || !pou.implements.is_empty() {
            return None;
        }
        self.variables.clear();
        self.function = None;
        for block in &pou.blocks {
            self.section(block)?;
        }
        let name = pou.name.text.to_owned();
        if let Some(result) = &pou.result {
            self.function = Some((name.clone(), self.ty(result)?));
        }
        let body = self.statements(&pou.body)?;
        let read = Pou {
            name,
            result: self.function.take().map(|(_, result)| result),
            owner,
            variables: std::mem::take(&mut self.variables),
            body,
            ..Pou::default()
        };
        match (pou.kind, &read.result) {
            (PouKind::Program, None) if pou.name.is("main") => {
                self.program.main = Pou {
                    name: "main".to_owned(),
                    ..read
                };
            }
            (PouKind::FunctionBlock, None) => {
                let owner = self.program.blocks.len();
                self.program.blocks.push(read);
                let mut members = pou.members.iter();
                return members.try_for_each(|member| self.pou(member, Some(owner)));
            }
            (PouKind::Function | PouKind::Method, Some(_)) => self.program.functions.push(read),
            _ => return None,
        }
        Some(())
    }

    fn section(&mut self, block: &'t VariableBlock<'t>) -> Option<()> {
        let section = match (block.kind, block.constant) {
            (VariableKind::Local, false) => VariableSection::Local,
            (VariableKind::Local, true) => VariableSection::Constant,
            (VariableKind::Input, false) => VariableSection::Input,
            (VariableKind::Output, false) => VariableSection::Output,
            (VariableKind::InOut, false) => VariableSection::InOut,
            _ => return None,
        };
        if block.retention.is_some() {
            return None;
        }
        for group in &block.groups {
            let ty = self.ty(&group.specification)?;
            let initial = match &group.initializer {
                Some(initial) => Some(self.initial(initial, &ty)?),
                None => None,
            };
            for name in names(group)? {
                self.variables.push(Variable {
                    name,
                    ty: ty.clone(),
                    section,
                    initial: initial.clone(),
                });
            }
        }
        Some(())
    }

    fn initial(&self, initial: &Initializer<'t>, ty: &Type) -> Option<InitialValue> {
        let value =
            |initial: &Initializer<'t>, ty: &Type| self.value(expression(initial)?, ty, TypeContext::Initial);
        match (&initial.kind, self.program.unaliased(ty)) {
            (InitializerKind::Expression(_), ty) => Some(InitialValue::Expression(value(initial, ty)?)),
            (InitializerKind::Array(elements), Type::Array(array)) => {
                let values = elements.iter().map(|element| match &*element.values {
                    [one] if element.repetition.is_none() => value(one, &array.element),
                    _ => None,
                });
                let values: Vec<_> = values.collect::<Option<_>>()?;
                (values.len() == subscripts(&array.dimensions).len()).then_some(InitialValue::Array(values))
            }
            (InitializerKind::Structure(values), ty) => {
                let fields = self.program.fields(ty)?;
                let values = values.iter().map(|(name, initial)| {
                    let field = named(fields.iter().map(|(name, ..)| name), name.text)?;
                    Some((field, value(initial, &fields.get(field)?.1)?))
                });
                Some(InitialValue::Structure(values.collect::<Option<_>>()?))
            }
            _ => None,
        }
    }
}

/// Returns the names of a declaration without a location.
fn names<'g>(group: &'g VariableGroup<'_>) -> Option<impl Iterator<Item = String> + 'g> {
    let names = group.names.iter().map(|name| name.text.to_owned());
    group.location.is_none().then_some(names)
}

fn expression(initial: &Initializer<'_>) -> Option<ExpressionId> {
    match initial.kind {
        InitializerKind::Expression(id) => Some(id),
        _ => None,
    }
}
