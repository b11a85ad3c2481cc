//! Gives the variables of program instances what the VAR_CONFIG sections of a configuration say: a location to those with an
//! incomplete one (`AT %I*`), an initial value to any.
//!
//! Basis: iec-61131-3: 2.7.1 of the second edition, 6.5.5.3 and 6.8.1 of the third.

use super::declare::Declarer;
use super::model::{ConfiguredValue, TopLevelName};
use super::types::TypeId;
use rustc_hash::FxHashSet;
use stickler_syntax::tree::{CaseFolded, Configuration, Name, PouKind, VariableGroup, VariableKind};
use stickler_types::Code;

impl<'u> Declarer<'u, '_> {
    /// Resolves the paths of all VAR_CONFIG sections, and reports variables of programs whose location stays incomplete.
    pub(super) fn configure_variables(&mut self) {
        let mut completed = FxHashSet::default();
        for configuration in std::mem::take(&mut self.configurations) {
            for section in &configuration.configured {
                for group in &section.groups {
                    for path in &group.names {
                        self.configure_variable(configuration, *path, group, &mut completed);
                    }
                }
            }
            let resources = configuration.resources.iter();
            for program in resources.flat_map(|resource| &resource.programs) {
                self.report_incomplete(program.name, program.type_name, &completed);
            }
        }
    }

    /// Resolves `resource.instance.block.variable`, where the name of the resource may be left out.
    fn configure_variable(
        &mut self,
        configuration: &Configuration<'u>,
        path: Name<'u>,
        group: &'u VariableGroup<'u>,
        completed: &mut FxHashSet<CaseFolded<'u>>,
    ) {
        let is_resource = |name: &str| {
            let mut headers = configuration
                .resources
                .iter()
                .filter_map(|resource| resource.header);
            headers.any(|(header, _)| header.is(name))
        };
        let path_text = match path.text.split_once('.') {
            Some((first, rest)) if is_resource(first) && rest.contains('.') => rest,
            _ => path.text,
        };
        let written = self.specification(&group.specification, path_text);
        // Of a program that is not declared nothing more is said.
        let mut programs = configuration
            .resources
            .iter()
            .flat_map(|resource| &resource.programs);
        let first = path_text.split('.').next().unwrap_or_default();
        let is_program = |name: &str| {
            let found = self.model.definitions.get(&CaseFolded(name));
            matches!(found, Some(TopLevelName::Pou(_)))
        };
        if programs.any(|program| program.name.is(first) && !is_program(program.type_name.text)) {
            return;
        }
        let Some((instance, offset, ty)) = self.configured_place(path_text) else {
            let message = format!("no program instance of the configuration has a variable `{path_text}`");
            self.report(Code::VariableUndefined, path.span, message);
            return;
        };
        let known = ty != TypeId::ERROR && written != TypeId::ERROR;
        if known && self.model.types.root(ty) != self.model.types.root(written) {
            let (here, there) = (self.model.types.name(written), self.model.types.name(ty));
            let message = format!("variable `{path_text}` is of type {there}, not {here}");
            self.report(Code::AssignmentTypeMismatch, path.span, message);
            return;
        }
        if group.location.is_some() {
            completed.insert(CaseFolded(path_text));
        }
        if let Some(initializer) = &group.initializer {
            self.model.configured.push(ConfiguredValue {
                instance,
                offset,
                ty,
                initializer,
            });
        }
    }

    /// Returns the program instance, the distance from its address and the type of the variable that a path leads to.
    fn configured_place(&self, path: &str) -> Option<(usize, u32, TypeId)> {
        let mut names = path.split('.');
        let program = names.next()?;
        let instances = &self.model.instances;
        let instance = instances
            .iter()
            .position(|instance| instance.name.eq_ignore_ascii_case(program))?;
        let mut ty = self.model.pous[instances[instance].pou as usize].ty;
        let mut offset = 0;
        for name in names {
            let member = self.model.types.member(ty, name)?;
            if member.kind == VariableKind::InOut || member.constant {
                return None;
            }
            (ty, offset) = (member.ty, offset + member.offset);
        }
        path.contains('.').then_some((instance, offset, ty))
    }

    /// Reports the variables of a program whose location nothing completes for an instance of it.
    fn report_incomplete(
        &mut self,
        instance: Name<'u>,
        program: Name<'u>,
        completed: &FxHashSet<CaseFolded<'u>>,
    ) {
        let pous = self.model.pous.iter().map(|entry| entry.pou);
        let program = pous.filter(|pou| pou.kind == PouKind::Program && pou.name.is(program.text));
        let groups = program
            .flat_map(|pou| &pou.blocks)
            .flat_map(|block| &block.groups);
        let names = groups
            .filter(|group| group.is_partly_located())
            .flat_map(|group| &group.names);
        let missing: Vec<String> = names
            .map(|name| format!("{}.{}", instance.text, name.text))
            .filter(|path| !completed.contains(&CaseFolded(path.as_str())))
            .collect();
        for path in missing {
            let message = format!("no VAR_CONFIG completes the location of `{path}`");
            self.report(Code::VariableUndefined, instance.span, message);
        }
    }
}
