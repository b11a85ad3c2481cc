//! Gives the variables of program instances what the VAR_CONFIG sections of a configuration say: a location to those with an
//! incomplete one (`AT %I*`), an initial value to any.
//!
//! Basis: iec-61131-3: 2.7.1 of the second edition, 6.5.5.3 and 6.8.1 of the third.

use super::declare::Declarer;
use super::model::{ConfiguredValue, Model};
use super::types::TypeId;
use rustc_hash::{FxHashMap, FxHashSet};
use stickler_syntax::tree::{CaseFolded, Configuration, Name, VariableGroup, VariableKind};
use stickler_types::Code;

impl<'u> Declarer<'u, '_> {
    /// Resolves the paths of all VAR_CONFIG sections, and reports variables of programs whose location stays incomplete.
    pub(super) fn configure_variables(&mut self) {
        let mut completed = FxHashSet::default();
        for configuration in std::mem::take(&mut self.configurations) {
            let names = ConfiguredNames::of(configuration, &self.model);
            for section in &configuration.configured {
                for group in &section.groups {
                    for path in &group.names {
                        self.configure_variable(&names, *path, group, &mut completed);
                    }
                }
            }
            let resources = configuration.resources.iter();
            for program in resources.flat_map(|resource| &resource.programs) {
                if let Some(&Some(instance)) = names.instances.get(&CaseFolded(program.name.text)) {
                    self.report_incomplete(program.name, instance, &completed);
                }
            }
        }
    }

    /// Resolves `resource.instance.block.variable`, where the name of the resource may be left out.
    fn configure_variable(
        &mut self,
        names: &ConfiguredNames<'u>,
        path: Name<'u>,
        group: &'u VariableGroup<'u>,
        completed: &mut FxHashSet<CaseFolded<'u>>,
    ) {
        let path_text = match path.text.split_once('.') {
            Some((first, rest)) if names.resources.contains(&CaseFolded(first)) && rest.contains('.') => rest,
            _ => path.text,
        };
        let written = self.specification(&group.specification, path_text);
        let (program, rest) = path_text.split_once('.').unwrap_or((path_text, ""));
        let instance = names.instances.get(&CaseFolded(program)).copied();
        // Of a program that is not declared nothing more is said.
        if instance == Some(None) {
            return;
        }
        let Some((instance, offset, ty)) = instance.flatten().and_then(|at| self.configured_place(at, rest))
        else {
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

    /// Returns a program instance with the distance from its address and the type of the variable that a path in it leads to.
    fn configured_place(&self, instance: usize, path: &str) -> Option<(usize, u32, TypeId)> {
        let mut ty = self.model.pous[self.model.instances[instance].pou as usize].ty;
        let mut offset = 0;
        for name in path.split('.') {
            let member = self.model.types.member(ty, name)?;
            if member.kind == VariableKind::InOut || member.constant {
                return None;
            }
            (ty, offset) = (member.ty, offset + member.offset);
        }
        Some((instance, offset, ty))
    }

    /// Reports the variables of a program whose location nothing completes for an instance of it.
    fn report_incomplete(&mut self, name: Name<'u>, instance: usize, completed: &FxHashSet<CaseFolded<'u>>) {
        let pou = self.model.instances[instance].pou;
        let blocks = self.model.pous[pou as usize].pou.blocks.iter();
        let groups = blocks.flat_map(|block| &block.groups);
        let names = groups
            .filter(|group| group.is_partly_located())
            .flat_map(|group| &group.names);
        let missing: Vec<String> = names
            .map(|variable| format!("{}.{}", name.text, variable.text))
            .filter(|path| !completed.contains(&CaseFolded(path.as_str())))
            .collect();
        for path in missing {
            let message = format!("no VAR_CONFIG completes the location of `{path}`");
            self.report(Code::VariableUndefined, name.span, message);
        }
    }
}

/// The names of a configuration that paths begin with.
struct ConfiguredNames<'u> {
    resources: FxHashSet<CaseFolded<'u>>,
    /// The indices of the program instances; `None` for one whose program is not declared.
    instances: FxHashMap<CaseFolded<'u>, Option<usize>>,
}

impl<'u> ConfiguredNames<'u> {
    fn of(configuration: &Configuration<'u>, model: &Model<'u>) -> ConfiguredNames<'u> {
        let resources = configuration.resources.iter();
        let headers = resources.clone().filter_map(|resource| resource.header);
        let programs = resources.flat_map(|resource| &resource.programs);
        let mut instances: FxHashMap<_, _> = programs
            .map(|program| (CaseFolded(program.name.text), None))
            .collect();
        for (index, instance) in model.instances.iter().enumerate().rev() {
            instances.insert(CaseFolded(instance.name), Some(index));
        }
        ConfiguredNames {
            resources: headers.map(|(name, _)| CaseFolded(name.text)).collect(),
            instances,
        }
    }
}
