//! Collects the declarations of a source text into a [`Model`], in an order in which each finds what it needs:
//! names, global variables with the values of constants, types and function blocks, the other POUs, the types of
//! global variables, and last the addresses.

use super::address_layouts::AddressLayouts;
use super::check::Reporter;
use super::inferred::Inferred;
use super::memory::MemoryLayout;
use super::model::{
    DefaultInitialValue, InitialRoutine, Instance, Model, PouEntry, SourceText, TopLevelName,
};
use super::pointer_types::PendingPointer;
use super::scope::Scope;
use super::types::{TypeId, TypeTable};
use crate::instruction::RoutineId;
use rustc_hash::{FxHashMap, FxHashSet};
use stickler_syntax::Namespaces;
use stickler_syntax::source::{Span, saturating_u32};
use stickler_syntax::tree::{
    CaseFolded, Configuration, Declaration, ExpressionKind, Name, Pou, PouKind, TypeDeclaration,
    TypeSpecification, VariableBlock,
};
use stickler_types::Code;

/// Makes the model.
pub(super) struct Declarer<'u, 'r> {
    pub(super) model: Model<'u>,
    pub(super) reporter: &'r mut Reporter,
    /// The declarations that are ordered by need: types and function blocks.
    pub(super) nodes: Vec<TypeNode<'u>>,
    /// The sections of global variables.
    pub(super) global_blocks: Vec<&'u VariableBlock<'u>>,
    pub(super) configurations: Vec<&'u Configuration<'u>>,
    /// The POU whose variables are being declared.
    pub(super) current: Option<usize>,
    /// Variables whose types need no size of their own: VAR_IN_OUT and VAR_EXTERNAL.
    pub(super) deferred: Vec<Deferred<'u>>,
    /// Reference and pointer types whose targets are resolved once all types are known, with the POU and the name for each; `None` from
    /// then on.
    pub(super) pointers: Option<Vec<PendingPointer<'u>>>,
    /// The sizes in bytes of what stands in unions.
    pub(super) layouts: AddressLayouts,
    /// Whether a type of a later edition has been met.
    pub(super) later: bool,
    /// Room for the inferred types of constant expressions, which are lowered one by one.
    pub(super) inferred: Vec<Inferred>,
    /// The number of messages that may still look for a similar name, which takes time.
    pub(super) guesses: u32,
}

/// A type or function block to be resolved.
#[derive(Debug)]
pub(super) struct TypeNode<'u> {
    pub(super) declared: DeclaredNode<'u>,
    /// `None` until it is resolved.
    pub(super) id: Option<TypeId>,
}

/// The declaration of a node.
#[derive(Clone, Copy, Debug)]
pub(super) enum DeclaredNode<'u> {
    Type(&'u TypeDeclaration<'u>),
    /// An index into [`Model::pous`].
    Block(usize),
}

/// Variables that take their type once all types are known.
#[derive(Debug)]
pub(super) struct Deferred<'u> {
    pub(super) pou: usize,
    pub(super) variables: std::ops::Range<usize>,
    pub(super) specification: &'u TypeSpecification<'u>,
    pub(super) hint: &'u str,
}

/// Collects all declarations of a source text; gives the memory that they take, too.
pub(super) fn declare<'u>(source: SourceText<'u>, reporter: &mut Reporter) -> (Model<'u>, MemoryLayout) {
    let model = Model {
        source,
        types: TypeTable::default(),
        namespaces: Namespaces::new(source.unit, source.dialect.library_namespaces),
        definitions: FxHashMap::default(),
        declared_types: Vec::new(),
        pous: Vec::new(),
        variables: Vec::new(),
        globals: Scope::default(),
        enumerated: Scope::default(),
        initial_values: Vec::new(),
        passed_over: FxHashSet::default(),
        instances: Vec::new(),
        called_programs: FxHashMap::default(),
        configured: Vec::new(),
        routines: 0,
        has_members: false,
    };
    let mut declarer = Declarer {
        model,
        reporter,
        nodes: Vec::new(),
        global_blocks: Vec::new(),
        configurations: Vec::new(),
        current: None,
        deferred: Vec::new(),
        pointers: Some(Vec::new()),
        layouts: AddressLayouts::default(),
        later: false,
        inferred: Vec::new(),
        guesses: 20,
    };
    declarer.collect_names();
    declarer.check_locations();
    declarer.declare_globals();
    declarer.resolve_types();
    declarer.declare_other_pous();
    declarer.resolve_globals();
    declarer.resolve_deferred();
    declarer.link_members();
    declarer.choose_instances();
    declarer.add_called_programs();
    declarer.configure_variables();
    let memory = declarer.lay_out();
    declarer.model.declared_types = declarer
        .nodes
        .iter()
        .map(|node| node.id.unwrap_or(TypeId::ERROR))
        .collect();
    (declarer.model, memory)
}

impl<'u> Declarer<'u, '_> {
    fn collect_names(&mut self) {
        let unit = self.model.source.unit;
        for declaration in &unit.declarations {
            match declaration {
                Declaration::Pou(pou) => self.collect_pou(pou),
                Declaration::Types(types) => types.iter().for_each(|ty| self.collect_type(ty)),
                Declaration::Globals(block) => self.global_blocks.push(block),
                Declaration::Configuration(configuration) => {
                    self.global_blocks.extend(&configuration.globals);
                    self.configurations.push(configuration);
                }
                Declaration::Namespace(_) | Declaration::EndNamespace(_) | Declaration::Using(_) => {}
            }
        }
        for (name, reason) in std::mem::take(&mut self.model.namespaces.refused) {
            let message = format!("`{}` {reason}", name.text);
            self.report(Code::UndeclaredUnknownType, name.span, message);
        }
        self.number_types();
    }

    fn collect_pou(&mut self, pou: &'u Pou<'u>) {
        let index = self.model.pous.len();
        let is_type = matches!(
            pou.kind,
            PouKind::FunctionBlock | PouKind::Class | PouKind::Interface
        );
        let node = is_type.then(|| {
            self.nodes.push(TypeNode {
                declared: DeclaredNode::Block(index),
                id: None,
            });
            self.nodes.len() - 1
        });
        self.add_pou(pou, node, None);
        self.define(pou.name, TopLevelName::Pou(saturating_u32(index)), Some(pou.kind));
        self.collect_members(index);
    }

    /// Adds a POU, a member of another one among them.
    pub(super) fn add_pou(&mut self, pou: &'u Pou<'u>, node: Option<usize>, owner: Option<u32>) -> u32 {
        let body = self.routine();
        let initial = self.routine();
        self.model.pous.push(PouEntry {
            pou,
            node,
            variables: 0..0,
            scope: Scope::default(),
            enumerated: Scope::default(),
            result: None,
            parameters: Vec::new(),
            positional: Vec::new(),
            required: 0,
            takes_more: false,
            ty: TypeId::ERROR,
            body,
            initial,
            cleared: 0..0,
            owner,
            base: None,
            interfaces: Vec::new(),
            ancestors: 0,
            members: Scope::default(),
            has_type_number: false,
            dispatch: None,
            is_overridden: false,
            is_frame: false,
        });
        saturating_u32(self.model.pous.len() - 1)
    }

    fn collect_type(&mut self, ty: &'u TypeDeclaration<'u>) {
        let node = self.nodes.len();
        self.nodes.push(TypeNode {
            declared: DeclaredNode::Type(ty),
            id: None,
        });
        self.define(ty.name, TopLevelName::Type(saturating_u32(node)), None);
    }

    /// Gives a name its meaning at the top level, unless it has one.
    fn define(&mut self, name: Name<'u>, definition: TopLevelName, kind: Option<PouKind>) {
        if name.text.is_empty() {
            return;
        }
        let key = (self.model.namespaces.at(name.span), CaseFolded(name.text));
        let Some(&earlier) = self.model.definitions.get(&key) else {
            self.model.definitions.insert(key, definition);
            return;
        };
        let code = match (self.kind_of(earlier), kind) {
            (None, None) => Code::TypeDeclNameDuplicated,
            (Some(PouKind::Function), Some(PouKind::Function)) => Code::FunctionDeclNameDuplicated,
            (Some(_), Some(_)) => Code::PouDeclNameDuplicated,
            _ => Code::DefinitionNameDuplicated,
        };
        self.reporter
            .report(code, name.span, format!("`{}` is already declared", name.text));
    }

    fn kind_of(&self, definition: TopLevelName) -> Option<PouKind> {
        match definition {
            TopLevelName::Pou(pou) => Some(self.model.pous[pou as usize].pou.kind),
            TopLevelName::Type(_) => None,
        }
    }

    /// Hands out a routine, whose code is made later.
    pub(super) fn routine(&mut self) -> RoutineId {
        self.model.routines += 1;
        self.model.routines - 1
    }

    /// Says what a routine does that has been handed out: it makes the default value of a type.
    pub(super) fn define_routine(&mut self, routine: RoutineId, value: DefaultInitialValue<'u>) {
        let pou = self.current.map(saturating_u32);
        self.model
            .initial_values
            .push(InitialRoutine { routine, value, pou });
    }

    /// Reports something wrong.
    pub(super) fn report(&mut self, code: Code, span: Span, message: impl Into<String>) {
        self.reporter.report(code, span, message);
    }

    /// Functions and programs, whose variables no type contains.
    fn declare_other_pous(&mut self) {
        for index in 0..self.model.pous.len() {
            if self.model.pous[index].node.is_none() {
                self.declare_variables(index);
            }
        }
    }

    /// Chooses the programs that run: those of the configurations, or else the one called `main`, or else the first.
    fn choose_instances(&mut self) {
        if self
            .configurations
            .iter()
            .any(|configuration| !configuration.resources.is_empty())
        {
            return self.configured_instances();
        }
        let programs = || {
            self.model
                .pous
                .iter()
                .zip(0..)
                .filter(|(entry, _)| entry.pou.kind == PouKind::Program)
        };
        let main = programs().find(|(entry, _)| entry.pou.name.text.eq_ignore_ascii_case("main"));
        if let Some((entry, pou)) = main.or_else(|| programs().next()) {
            self.model.instances.push(Instance {
                name: entry.pou.name.text,
                pou,
                base: 0,
                runs: true,
            });
        }
    }

    /// Gives the programs that expressions name the one instance that they have where programs are called by their names.
    ///
    /// Basis: codesys-pages: _cds_obj_program.
    fn add_called_programs(&mut self) {
        let source = self.model.source;
        if !source.dialect.programs_called {
            return;
        }
        let running = self.model.instances.iter().enumerate().rev();
        let mut called: FxHashMap<u32, usize> =
            running.map(|(index, instance)| (instance.pou, index)).collect();
        for expression in &source.unit.expressions {
            if let ExpressionKind::Name(name) = expression.kind
                && let Some(TopLevelName::Pou(pou)) = self.model.definition(name)
                && let entry = self.model.pous[pou as usize].pou
                && entry.kind == PouKind::Program
                && !called.contains_key(&pou)
            {
                called.insert(pou, self.model.instances.len());
                let (name, base, runs) = (entry.name.text, 0, false);
                self.model.instances.push(Instance {
                    name,
                    pou,
                    base,
                    runs,
                });
            }
        }
        self.model.called_programs = called;
    }

    fn configured_instances(&mut self) {
        for configuration in self.configurations.clone() {
            let mut names: FxHashMap<CaseFolded<'u>, ()> = FxHashMap::default();
            for resource in &configuration.resources {
                let mut tasks: FxHashMap<CaseFolded<'u>, ()> = FxHashMap::default();
                for task in &resource.tasks {
                    if tasks.insert(CaseFolded(task.name.text), ()).is_some() {
                        let message = format!("task `{}` is already declared", task.name.text);
                        self.report(Code::DuplicateTaskName, task.name.span, message);
                    }
                }
                for program in &resource.programs {
                    if names.insert(CaseFolded(program.name.text), ()).is_some() {
                        let message = format!("`{}` is already declared", program.name.text);
                        self.report(Code::SymbolDeclDuplicated, program.name.span, message);
                    }
                    if let Some(task) = program.task
                        && !tasks.contains_key(&CaseFolded(task.text))
                    {
                        let message = format!("task `{}` is not declared", task.text);
                        self.report(Code::ProgramMissingTaskConfig, task.span, message);
                    }
                    self.configured_instance(program.name, program.type_name);
                }
            }
        }
    }

    fn configured_instance(&mut self, name: Name<'u>, program: Name<'u>) {
        match self.model.definition(program) {
            Some(TopLevelName::Pou(pou)) if self.model.pous[pou as usize].pou.kind == PouKind::Program => {
                self.model.instances.push(Instance {
                    name: name.text,
                    pou,
                    base: 0,
                    runs: true,
                });
            }
            _ => {
                let message = format!("program `{}` is not declared", program.text);
                self.report(Code::UndeclaredUnknownType, program.span, message);
            }
        }
    }
}
