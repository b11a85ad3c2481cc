//! A program of any dialect with its tree: what it declares, which type each of its expressions has, and to what values are given.

use crate::words::{ANY, converted, elementary, is_number, type_of_word};
use std::collections::HashMap;
use std::ops::Deref;
use stickler_syntax::names::{DeclaredKind, DeclaredName, declared};
use stickler_syntax::source::{LineIndex, Span};
use stickler_syntax::tree::{
    Argument, ExpressionId, ExpressionKind, Initializer, InitializerKind, Pou, PouKind, SourceUnit,
    StatementKind, TypeDeclaration, TypeSpecification, TypeSpecificationKind, UnaryOperator, VariableGroup,
    VariableKind,
};
pub(crate) use stickler_syntax::visitor::Part;
use stickler_syntax::visitor::{Context, Place, Visitor, walk};
use stickler_types::ElementaryType;

/// The maximum number of types that a type of one's own is resolved through.
const MAX_ALIASES: usize = 8;

/// A program with its tree.
pub(crate) struct Program<'s> {
    pub(crate) text: &'s str,
    pub(crate) unit: SourceUnit<'s>,
    pub(crate) lines: LineIndex,
}

impl<'s> Program<'s> {
    pub(crate) fn new(text: &'s str) -> Program<'s> {
        Program {
            text,
            unit: stickler_syntax::parse(text, &ANY).0,
            lines: LineIndex::new(text),
        }
    }

    /// Returns the number of the line that a part of the program begins on.
    pub(crate) fn line(&self, span: Span) -> u32 {
        self.lines.line(span.start)
    }

    /// Returns the text of a line.
    pub(crate) fn line_text(&self, number: u32) -> Option<&'s str> {
        self.text.lines().nth(number.checked_sub(1)? as usize)
    }

    /// Reads the names and the expressions of the program.
    pub(crate) fn read(&self) -> ReadProgram<'_, 's> {
        let mut collector = Collector {
            names: declared(&self.unit),
            parts: Vec::new(),
            initial: HashMap::new(),
        };
        walk(&self.unit, &mut collector);
        let index = collector.parts.iter().enumerate();
        ReadProgram {
            program: self,
            names: collector.names,
            index: index.map(|(at, part)| (part.id, at)).collect(),
            parts: collector.parts,
            initial: collector.initial,
        }
    }
}

/// Reads a program, and asks it something.
pub(crate) fn read<R>(text: &str, question: impl FnOnce(&ReadProgram<'_, '_>) -> R) -> R {
    question(&Program::new(text).read())
}

/// The names and the expressions of a program.
pub(crate) struct ReadProgram<'t, 's> {
    pub(crate) program: &'t Program<'s>,
    pub(crate) names: Vec<DeclaredName<'t, 's>>,
    pub(crate) parts: Vec<Part<'t, 's>>,
    index: HashMap<ExpressionId, usize>,
    /// The types of what begins with an initial value, by the place of that.
    initial: HashMap<Span, &'t TypeSpecification<'s>>,
}

impl<'s> Deref for ReadProgram<'_, 's> {
    type Target = Program<'s>;

    fn deref(&self) -> &Program<'s> {
        self.program
    }
}

impl<'t, 's> ReadProgram<'t, 's> {
    pub(crate) fn text(&self, id: ExpressionId) -> &'s str {
        let expression = self.program.unit.expression(id);
        expression.map_or("", |expression| expression.span.text(self.program.text))
    }

    pub(crate) fn part(&self, id: ExpressionId) -> Option<&Part<'t, 's>> {
        self.parts.get(*self.index.get(&id)?)
    }

    /// Returns the expression that another one is a part of.
    pub(crate) fn around(&self, part: &Part<'t, 's>) -> Option<&Part<'t, 's>> {
        self.part(part.around?)
    }

    /// Returns the expressions in a place.
    pub(crate) fn at(&self, place: Place) -> impl Iterator<Item = &Part<'t, 's>> {
        self.parts.iter().filter(move |part| part.place == place)
    }

    /// Returns the first declaration of a variable or a field with a name.
    pub(crate) fn group(&self, name: &str) -> Option<&'t VariableGroup<'s>> {
        let mut named = self.names.iter().filter(|one| one.name.is(name));
        named.find_map(|one| one.group)
    }

    /// Returns what a name is where a unit uses it: what the unit itself declares, or else what another part does.
    pub(crate) fn named(&self, name: &str, pou: Option<&Pou<'_>>) -> Option<&DeclaredName<'t, 's>> {
        let here = pou.map(|pou| pou.span);
        let mut own = self.names.iter().filter(|one| one.name.is(name));
        let is_here = |one: &&DeclaredName<'t, 's>| one.inside.map(|pou| pou.span) == here;
        own.clone().find(is_here).or_else(|| own.next())
    }

    /// Returns whether a program declares a name.
    pub(crate) fn declares(&self, name: &str) -> bool {
        self.names.iter().any(|one| one.name.is(name))
    }

    /// Returns the unit of a name: a function, or the block of which a variable is an instance.
    pub(crate) fn unit_of(&self, name: &str) -> Option<&'t Pou<'s>> {
        let block = self
            .group(name)
            .and_then(|group| match &group.specification.kind {
                TypeSpecificationKind::Named(ty) => Some(ty.text),
                _ => None,
            });
        let mut units = self.program.unit.pous();
        units.find(|pou| pou.name.is(block.unwrap_or(name)))
    }

    /// Returns whether a name is that of an instance of a function block of the program.
    pub(crate) fn is_instance(&self, name: &str) -> bool {
        let unit = self.unit_of(name);
        self.group(name).is_some() && unit.is_some_and(|pou| pou.kind == PouKind::FunctionBlock)
    }

    /// Returns the elementary type of what is declared so: of an array that of its elements.
    pub(crate) fn elementary(&self, specification: &TypeSpecification<'_>) -> Option<ElementaryType> {
        self.resolved(specification, MAX_ALIASES)
    }

    fn resolved(&self, specification: &TypeSpecification<'_>, depth: usize) -> Option<ElementaryType> {
        let depth = depth.checked_sub(1)?;
        let name = match &specification.kind {
            TypeSpecificationKind::Named(name)
            | TypeSpecificationKind::Text { name, .. }
            | TypeSpecificationKind::Subrange { base: name, .. } => name,
            TypeSpecificationKind::Array { element, .. } => return self.resolved(element, depth),
            _ => return None,
        };
        elementary(name.text).or_else(|| self.resolved(&self.declared_type(name.text)?.specification, depth))
    }

    /// Returns the declaration of a type of one's own.
    pub(crate) fn declared_type(&self, name: &str) -> Option<&'t TypeDeclaration<'s>> {
        self.program.unit.types().find(|one| one.name.is(name))
    }

    /// Returns the type with which the variable, the field or the result is declared that an expression is.
    pub(crate) fn specification(&self, id: ExpressionId) -> Option<&'t TypeSpecification<'s>> {
        let part = self.part(id)?;
        match &part.expression.kind {
            ExpressionKind::Name(name) => {
                let unit = part.pou.filter(|pou| pou.name.is(name.text));
                let result = unit.and_then(|pou| pou.result.as_ref());
                let group = self.named(name.text, part.pou).and_then(|one| one.group);
                result.or_else(|| group.map(|group| &group.specification))
            }
            ExpressionKind::Field { field, .. } => Some(&self.named(field.text, None)?.group?.specification),
            ExpressionKind::Index { base, .. } => self.specification(*base),
            _ => None,
        }
    }

    /// Returns the elementary type of an expression, where it is no calculation and no plain literal.
    pub(crate) fn type_of(&self, id: ExpressionId) -> Option<ElementaryType> {
        match &self.program.unit.expression(id)?.kind {
            ExpressionKind::Literal(literal) => type_of_word(&format!("{}#", literal.prefix()?.text)),
            ExpressionKind::Bit { .. } => Some(ElementaryType::Bool),
            ExpressionKind::Part { part, .. } => Some(*part),
            ExpressionKind::Parenthesized(inner) => self.type_of(*inner),
            ExpressionKind::Call { callee, .. } => {
                let name = self.text(*callee);
                let result = self.unit_of(name).and_then(|unit| unit.result.as_ref());
                match result {
                    Some(result) => self.elementary(result),
                    None => converted(name).map(|(_, into)| into),
                }
            }
            _ => self.elementary(self.specification(id)?),
        }
    }

    /// Returns a literal with its sign; `None` of another expression.
    pub(crate) fn literal(&self, id: ExpressionId) -> Option<&'s str> {
        let is_literal = |id: ExpressionId| {
            let expression = self.program.unit.expression(id);
            expression.is_some_and(|one| matches!(one.kind, ExpressionKind::Literal(_)))
        };
        match self.program.unit.expression(id)?.kind {
            ExpressionKind::Unary {
                operator: UnaryOperator::Negate,
                operand,
            } if is_literal(operand) && !self.text(operand).contains('#') => Some(self.text(id)),
            _ => is_literal(id).then(|| self.text(id)),
        }
    }

    /// Returns the literals of the program; the number behind a minus is a part of one.
    pub(crate) fn literals(&self) -> impl Iterator<Item = (&Part<'t, 's>, &'s str)> {
        let is_part = |part: &Part<'t, 's>| part.around.is_some_and(|around| self.literal(around).is_some());
        let whole = self.parts.iter().filter(move |part| !is_part(part));
        whole.filter_map(|part| Some((part, self.literal(part.id)?)))
    }

    /// Returns the literal with which a variable begins.
    pub(crate) fn initial(&self, name: &str) -> Option<&'s str> {
        let named = self.names.iter().filter(|one| one.name.is(name));
        let mut groups = named.filter_map(|one| one.group);
        groups.find_map(|group| match group.initializer.as_ref()?.kind {
            InitializerKind::Expression(value) => self.literal(value),
            _ => None,
        })
    }

    /// Returns the declaration of what a value is given to: a variable, a field, an element, or a parameter.
    pub(crate) fn target_specification(&self, part: &Part<'t, 's>) -> Option<&'t TypeSpecification<'s>> {
        match part.place {
            Place::InitialValue => self.initial.get(&part.expression.span).copied(),
            Place::Value => match part.statement?.kind {
                StatementKind::Assignment { target, .. } => self.specification(target),
                _ => None,
            },
            _ => Some(&self.input(part)?.group?.specification),
        }
    }

    /// Returns the declaration of the parameter to which an argument is given.
    pub(crate) fn input(&self, part: &Part<'t, 's>) -> Option<&DeclaredName<'t, 's>> {
        if !matches!(part.place, Place::Argument | Place::NamedArgument) {
            return None;
        }
        let (callee, arguments) = self.call(part.around?)?;
        let unit = self.unit_of(callee)?;
        let is_input = |one: &&DeclaredName<'t, 's>| {
            let inputs = [VariableKind::Input, VariableKind::InOut].map(DeclaredKind::Variable);
            inputs.contains(&one.kind) && one.inside.is_some_and(|pou| pou.span == unit.span)
        };
        let mut inputs = self.names.iter().filter(is_input);
        let is_it = |argument: &Argument<'s>| match argument {
            Argument::Positional(value) | Argument::Named { value, .. } => *value == part.id,
            Argument::Output { .. } => false,
        };
        let at = arguments.iter().position(is_it)?;
        match &arguments[at] {
            Argument::Named { name, .. } => inputs.find(|input| input.name.is(name.text)),
            _ => inputs.nth(at),
        }
    }

    /// Returns the elementary type of what a value is given to, or compared with by FOR and CASE.
    pub(crate) fn target(&self, part: &Part<'t, 's>) -> Option<ElementaryType> {
        if let Some(specification) = self.target_specification(part) {
            return self.elementary(specification);
        }
        match part.place {
            Place::Value => match part.statement?.kind {
                StatementKind::Assignment { target, .. } => self.type_of(target),
                _ => None,
            },
            Place::Argument => {
                let (callee, arguments) = self.call(part.around?)?;
                let is_only = matches!(arguments, [Argument::Positional(_)]) && !self.declares(callee);
                converted(callee).filter(|_| is_only).map(|(from, _)| from)
            }
            Place::From | Place::To | Place::By => match part.statement?.kind {
                StatementKind::For { control, .. } => self.type_of(control),
                _ => None,
            },
            Place::Label => match part.statement?.kind {
                StatementKind::Case { selector, .. } => self.type_of(selector),
                _ => None,
            },
            _ => None,
        }
    }

    /// Returns the elementary type that a word names, a literal by its prefix, or a variable by its declaration.
    pub(crate) fn type_of_word(&self, word: &str) -> Option<ElementaryType> {
        let declared = || self.elementary(&self.named(word, None)?.group?.specification);
        type_of_word(word).or_else(declared)
    }

    /// Returns the name and the arguments of a call.
    pub(crate) fn call(&self, id: ExpressionId) -> Option<(&'s str, &'t [Argument<'s>])> {
        match &self.part(id)?.expression.kind {
            ExpressionKind::Call { callee, arguments } => Some((self.text(*callee), arguments)),
            _ => None,
        }
    }

    /// Returns the types of an output and of the variable that takes it.
    pub(crate) fn output(&self, part: &Part<'t, 's>) -> Option<(ElementaryType, ElementaryType)> {
        let (_, arguments) = self.call(part.around?)?;
        arguments.iter().find_map(|argument| match argument {
            Argument::Output { name, target, .. } if *target == part.id => {
                let group = self.named(name.text, None)?.group?;
                Some((self.elementary(&group.specification)?, self.type_of(*target)?))
            }
            _ => None,
        })
    }

    /// Returns the kind of section that declares a variable where a unit uses it.
    pub(crate) fn section(&self, name: &str, pou: Option<&Pou<'_>>) -> Option<VariableKind> {
        match self.named(name, pou)?.kind {
            DeclaredKind::Variable(kind) => Some(kind),
            _ => None,
        }
    }

    /// Returns a literal of a type: one with which a variable of the type begins, or a number with all of its bits.
    pub(crate) fn some_value(&self, ty: ElementaryType) -> Option<String> {
        let of_type = |one: &&DeclaredName<'t, 's>| {
            one.group
                .is_some_and(|group| self.elementary(&group.specification) == Some(ty))
        };
        let mut known = self
            .names
            .iter()
            .filter(of_type)
            .filter_map(|one| self.initial(one.name.text));
        let plain = match ty.integer_range() {
            Some((0, most)) => most.to_string(),
            Some(_) => "-1".to_owned(),
            None if ty.is_bit_string() => "1".to_owned(),
            None => "1.5".to_owned(),
        };
        let plain = || is_number(ty).then(|| format!("{}#{plain}", ty.name()));
        known.next().map(str::to_owned).or_else(plain)
    }
}

/// A walk that collects expressions and the places of initial values.
struct Collector<'t, 's> {
    names: Vec<DeclaredName<'t, 's>>,
    parts: Vec<Part<'t, 's>>,
    initial: HashMap<Span, &'t TypeSpecification<'s>>,
}

impl<'t, 's> Collector<'t, 's> {
    fn begins(&mut self, initializer: Option<&Initializer<'s>>, specification: &'t TypeSpecification<'s>) {
        self.initial
            .extend(initializer.map(|one| (one.span, specification)));
    }
}

impl<'t, 's: 't> Visitor<'t, 's> for Collector<'t, 's> {
    fn variables(&mut self, group: &'t VariableGroup<'s>, _: &Context<'t, 's>) {
        self.begins(group.initializer.as_ref(), &group.specification);
    }

    fn type_declaration(&mut self, declared: &'t TypeDeclaration<'s>, _: &Context<'t, 's>) {
        self.begins(declared.initializer.as_ref(), &declared.specification);
    }

    fn initializer(&mut self, initializer: &'t Initializer<'s>, _: &Context<'t, 's>) {
        match &initializer.kind {
            InitializerKind::Expression(_) => {}
            InitializerKind::Array(elements) => {
                if let Some(specification) = self.initial.get(&initializer.span).copied() {
                    elements
                        .iter()
                        .flat_map(|element| &element.values)
                        .for_each(|value| self.begins(Some(value), specification));
                }
            }
            InitializerKind::Structure(fields) => {
                for (name, value) in fields {
                    let declared = self
                        .names
                        .iter()
                        .find(|one| one.name.is(name.text) && one.group.is_some());
                    if let Some(group) = declared.and_then(|one| one.group) {
                        self.begins(Some(value), &group.specification);
                    }
                }
            }
        }
    }

    fn expression(&mut self, part: Part<'t, 's>, _: &Context<'t, 's>) {
        self.parts.push(part);
    }
}
