//! Declares the variables of POUs.

use super::constant::Constant;
use super::declare::{Declarer, Deferred};
use super::model::{DeclaredVariable, Storage};
use super::scope::NamedList;
use super::types::{DefaultValue, Extent, Structure, TypeId, TypeKind, TypeMember};
use stickler_syntax::source::saturating_u32;
use stickler_syntax::tree::{
    ANY_ARGUMENTS, CaseFolded, Edge, Name, PouKind, TypeSpecificationKind, VariableBlock, VariableGroup,
    VariableKind,
};
use stickler_types::Code;

impl<'u> Declarer<'u, '_> {
    /// Declares the variables of a POU, and gives a function block and a program their type.
    pub(super) fn declare_variables(&mut self, index: usize) {
        self.current = Some(index);
        let first = self.model.variables.len();
        let pou = self.model.pous[index].pou;
        self.resolve_bases(index);
        let is_function = self.model.pous[index].is_function();
        // Other declarations may name a constant that stands behind them; it is made of nothing that is declared before it.
        let text = self.model.source.text;
        let is_number = |group: &VariableGroup<'u>| {
            let initial = group
                .initializer
                .as_ref()
                .map_or("", |initial| initial.span.text(text));
            initial
                .bytes()
                .all(|byte| byte.is_ascii_digit() || b"+-_".contains(&byte))
        };
        let is_first = |block: &&VariableBlock<'u>| {
            block.constant && block.kind == VariableKind::Local && block.groups.iter().all(is_number)
        };
        let (first_blocks, blocks): (Vec<_>, Vec<_>) = pou.blocks.iter().partition(is_first);
        for block in first_blocks.into_iter().chain(blocks) {
            // The variables of VAR_INST have been declared with the owner's.
            let declared = block.kind == VariableKind::Instance && pou.kind.is_member();
            for group in block.groups.iter().filter(|_| !declared) {
                self.declare_group(index, block, group);
            }
        }
        self.declare_instance_variables(index);
        if is_function {
            self.declare_result(index);
        }
        self.model.pous[index].variables = saturating_u32(first)..saturating_u32(self.model.variables.len());
        if pou.kind == PouKind::Interface {
            self.make_interface_type(index);
        } else if !is_function {
            self.make_instance_type(index);
        }
        self.current = None;
    }

    pub(super) fn declare_group(
        &mut self,
        pou: usize,
        block: &'u VariableBlock<'u>,
        group: &'u VariableGroup<'u>,
    ) {
        let is_last = block.kind == VariableKind::Input && self.model.pous[pou].is_function();
        if is_last
            && matches!(group.specification.kind, TypeSpecificationKind::Named(name) if name.text == ANY_ARGUMENTS)
        {
            self.model.pous[pou].takes_more = true;
            return;
        }
        let hint = group.names.first().map_or("", |name| name.text);
        let first = self.model.variables.len();
        let limits = self.limits_of(pou, block, group);
        let later = match block.kind {
            VariableKind::External => true,
            _ if limits > 0 => true,
            // Nobody calls a program, so there VAR_IN_OUT declares variables like any others.
            VariableKind::InOut => self.model.pous[pou].pou.kind != PouKind::Program,
            _ => false,
        };
        let ty = if later {
            TypeId::ERROR
        } else {
            self.group_type(group, hint)
        };
        self.check_group(self.model.pous[pou].pou.kind, block, group, ty);
        for name in &group.names {
            self.declare_variable(pou, *name, block, (group, limits), ty);
        }
        if later {
            self.deferred.push(Deferred {
                pou,
                variables: first..self.model.variables.len(),
                specification: &group.specification,
                hint,
            });
        }
    }

    /// Returns the number of cells behind the address of a parameter for the limits of its argument, three for each dimension of an
    /// ARRAY[*]; 0 for all other variables, and where there may be none.
    ///
    /// Basis: iec-61131-3: 6.5.3 of the third edition.
    fn limits_of(&self, pou: usize, block: &VariableBlock<'u>, group: &VariableGroup<'u>) -> u32 {
        let may = match block.kind {
            VariableKind::InOut => self.model.pous[pou].pou.kind != PouKind::Program,
            VariableKind::Input | VariableKind::Output => {
                let lacks = self.model.source.dialect.lacks("variable-length-input");
                self.model.pous[pou].is_function() && !lacks
            }
            _ => false,
        };
        match group.specification.kind {
            TypeSpecificationKind::VariableLengthArray { dimensions, .. } if may => dimensions * 3,
            _ => 0,
        }
    }

    /// Checks what concerns a whole group at once.
    pub(super) fn check_group(
        &mut self,
        pou: PouKind,
        block: &VariableBlock<'u>,
        group: &VariableGroup<'u>,
        ty: TypeId,
    ) {
        let is_array = matches!(
            group.specification.kind,
            TypeSpecificationKind::VariableLengthArray { .. }
        );
        let held = block.kind.is_held() && !is_array;
        let may_have_value = held || self.model.source.dialect.initial_values_name_all;
        if let (false, Some(initializer)) = (may_have_value, &group.initializer) {
            let message = "what stands for another variable has no initial value of its own";
            self.report(Code::InitializerTypeMismatch, initializer.span, message);
        }
        let has_block = held && self.model.types.extent(ty).has_block;
        if held {
            self.refuse_abstract(ty, group.specification.span);
        }
        if has_block && pou == PouKind::Function && !self.model.source.dialect.blocks_in_functions {
            let message = "a function keeps nothing between calls, so it can have no function block";
            self.report(Code::FunctionBlockInFunction, group.specification.span, message);
        }
        if has_block && block.constant {
            let message = "a function block cannot be CONSTANT";
            self.report(Code::FunctionBlockNotConstant, group.specification.span, message);
        } else if held
            && block.constant
            && block.kind != VariableKind::Input
            && !self.says_initial_value(group)
            && let Some(name) = group.names.first()
        {
            let message = format!("constant `{}` needs an initial value", name.text);
            self.report(Code::ConstantMustHaveInitializer, name.span, message);
        }
    }

    /// Returns whether a group has an initial value, if perhaps one that could not be read.
    pub(super) fn says_initial_value(&self, group: &VariableGroup<'u>) -> bool {
        let end = group.specification.span.end as usize;
        let behind = self.model.source.text.get(end..).unwrap_or("");
        group.initializer.is_some()
            || matches!(group.specification.kind, TypeSpecificationKind::Error)
            || behind.trim_start().starts_with(":=")
    }

    fn declare_variable(
        &mut self,
        pou: usize,
        name: Name<'u>,
        block: &VariableBlock<'u>,
        (group, limits): (&'u VariableGroup<'u>, u32),
        ty: TypeId,
    ) {
        let index = saturating_u32(self.model.variables.len());
        let in_program = self.model.pous[pou].pou.kind == PouKind::Program;
        let kind = match block.kind {
            VariableKind::InOut if in_program => VariableKind::Local,
            _ if limits > 0 => VariableKind::InOut,
            kind => kind,
        };
        let with_outputs = self.model.source.dialect.outputs_by_position;
        let entry = &mut self.model.pous[pou];
        let is_parameter = matches!(kind, VariableKind::Input | VariableKind::InOut);
        if is_parameter {
            entry.parameters.push(index);
        }
        if is_parameter || with_outputs && matches!(block.kind, VariableKind::Output | VariableKind::InOut) {
            entry.positional.push(index);
            let may_be_left_out = match entry.is_function() {
                true => group.initializer.is_some() || block.kind == VariableKind::Output,
                false => block.kind != VariableKind::InOut,
            };
            if !(with_outputs && may_be_left_out) {
                entry.required = entry.positional.len();
            }
        }
        let fixed = block.constant
            && matches!(
                block.kind,
                VariableKind::Local | VariableKind::Temporary | VariableKind::Static
            );
        let value = match kind {
            VariableKind::External => match self.model.globals.get(&CaseFolded(name.text)) {
                Some(&global) => self.model.variable(global).value.clone(),
                None => Constant::Unknown,
            },
            _ if fixed => self.local_constant(group, ty),
            _ => Constant::Variable,
        };
        // Only now is the name known: a constant is not made of itself.
        self.enter_variable(pou, name, index);
        let variable = DeclaredVariable::new(name, ty, kind).declared(block, group);
        let constant = block.constant || limits > 0 && block.kind == VariableKind::Input;
        self.model.variables.push(DeclaredVariable {
            section: block.kind,
            limits,
            constant,
            value,
            ..variable
        });
        if let Some(edge) = group.edge {
            self.declare_edge(pou, index, ty, edge);
        }
    }

    /// Declares what the body sees in place of an input with an edge qualifier, and the value of the input in the call before.
    ///
    /// Basis: iec-61131-3: 6.6.3.5.3 of the third edition (as if the input were that of an R_TRIG or F_TRIG).
    fn declare_edge(&mut self, pou: usize, input: u32, ty: TypeId, edge: Edge) {
        let DeclaredVariable { name, kind, .. } = self.model.variables[input as usize];
        let has_body = matches!(
            self.model.pous[pou].pou.kind,
            PouKind::FunctionBlock | PouKind::Program
        );
        if !has_body || kind != VariableKind::Input || !matches!(ty, TypeId::BOOL | TypeId::ERROR) {
            let message = format!("{edge} stands behind a BOOL input of a function block or program");
            self.report(Code::SyntaxError, name.span, message);
            return;
        }
        self.model.variables[input as usize].edge = Some(edge);
        for _ in 0..2 {
            let hidden = DeclaredVariable::new(name, TypeId::BOOL, VariableKind::Instance);
            self.model.variables.push(hidden);
        }
    }

    fn enter_variable(&mut self, pou: usize, name: Name<'u>, index: u32) {
        let entry = &mut self.model.pous[pou];
        let own = entry.is_function() && CaseFolded(entry.pou.name.text) == CaseFolded(name.text);
        if own || entry.scope.contains_key(&CaseFolded(name.text)) {
            let message = format!("`{}` is already declared in `{}`", name.text, entry.pou.name.text);
            self.report(Code::SymbolDeclDuplicated, name.span, message);
        } else if self.is_inherited(pou, name) {
            let message = format!("`{}` is already declared in what is extended", name.text);
            self.report(Code::ExtendsFieldNameDuplicated, name.span, message);
        } else {
            let entry = &mut self.model.pous[pou];
            entry.scope.insert(CaseFolded(name.text), index);
        }
    }

    /// The variable that has a function's own name, and holds its result.
    fn declare_result(&mut self, pou: usize) {
        let Some(result) = self.result_specification(pou) else {
            return;
        };
        let is_setter = self.model.pous[pou].pou.kind == PouKind::Setter;
        let name = self.model.pous[pou].pou.name;
        let ty = self.specification(result, name.text);
        if self.model.types.extent(ty).has_block {
            let message = "a function block cannot be the result of a function";
            self.report(Code::FunctionBlockInFunction, result.span, message);
        }
        let index = saturating_u32(self.model.variables.len());
        let entry = &mut self.model.pous[pou];
        let kind = if is_setter {
            entry.parameters.push(index);
            VariableKind::Input
        } else {
            entry.result = Some(index);
            VariableKind::Output
        };
        self.model.variables.push(DeclaredVariable::new(name, ty, kind));
        entry.scope.insert(CaseFolded(name.text), index);
    }

    /// Lays the variables of a function block or program out, and makes them the members of a type.
    fn make_instance_type(&mut self, pou: usize) {
        let entry = &self.model.pous[pou];
        let program = entry.pou.kind == PouKind::Program;
        let (name, variables, span) = (entry.pou.name, entry.variables.clone(), entry.pou.name.span);
        let mut extent = Extent {
            size: 0,
            has_block: true,
            ..Extent::PLAIN
        };
        let mut members = NamedList::new();
        let base = entry.base.map(|base| self.model.pous[base as usize].ty);
        let has_type_number = entry.has_type_number;
        let mut size = u64::from(has_type_number);
        if let Some(base) = base {
            let inherited = *self.model.types.extent(base);
            size = inherited.size.into();
            (extent.text_units, extent.depth) = (inherited.text_units, inherited.depth);
        }
        let mut zero = !has_type_number;
        for index in variables {
            let variable = &mut self.model.variables[index as usize];
            let offset = u32::try_from(size).unwrap_or(u32::MAX);
            let inner = *self.model.types.extent(variable.ty);
            match variable.kind {
                VariableKind::External | VariableKind::Static => continue,
                VariableKind::InOut => {
                    variable.storage = Storage::InstancePointer(offset);
                    size += 1 + u64::from(variable.limits);
                }
                _ => {
                    variable.storage = Storage::Instance(offset);
                    size += u64::from(inner.size);
                    extent.text_units = extent.text_units.saturating_add(inner.text_units);
                    extent.depth = extent.depth.max(inner.depth);
                    // Before the first call an input with an edge qualifier may count as TRUE.
                    zero &= variable.initializer.is_none() && variable.edge.is_none();
                    zero &= inner.default == DefaultValue::Zero;
                }
            }
            let member = TypeMember {
                ty: variable.ty,
                offset,
                kind: variable.kind,
                constant: variable.constant,
                is_public: variable.is_public,
            };
            // Several methods may have a VAR_INST of one name; no variable has a number for its name.
            match variable.kind {
                VariableKind::Instance => members.push(&index.to_string(), member),
                _ => members.push(variable.name.text, member),
            };
        }
        if self.too_deep(extent.depth, span) || self.too_large(size, span) {
            return;
        }
        extent.depth += 1;
        extent.size = u32::try_from(size.max(1)).unwrap_or(u32::MAX);
        if !zero {
            extent.default = DefaultValue::Routine(self.model.pous[pou].initial);
        }
        let structure = Box::new(Structure {
            name: name.text.into(),
            pou: saturating_u32(pou),
            base,
            is_union: false,
            members,
        });
        let kind = match program {
            true => TypeKind::Structure(structure),
            false => TypeKind::FunctionBlock(structure),
        };
        let ty = self.model.types.add(kind, extent);
        self.model.pous[pou].ty = ty;
        self.note_parents(pou);
    }
}
