//! Binds the arguments of a call to parameters, of functions and function blocks that the text declares.
//!
//! Basis: ironplc-problem-codes: P4001 to P4004, P4018, P4023, P4024. Arguments by position are as many as there
//! are parameters; by name, inputs may be left out, VAR_IN_OUT may not.

use super::lowering::Lowering;
use super::model::PouEntry;
use super::parameters::mixed;
use rustc_hash::FxHashSet;
use stickler_syntax::diagnostic::SpannedDiagnostic;
use stickler_syntax::source::Span;
use stickler_syntax::tree::{Argument, ExpressionId, Name, PouKind, VariableKind};
use stickler_types::Code;

/// The arguments of a call with the parameters that they are for.
#[derive(Debug, Default)]
pub(super) struct BoundArguments {
    /// VAR_INPUT and VAR_IN_OUT, as indices of variables, and what is given for them.
    pub(super) inputs: Vec<(u32, ExpressionId)>,
    /// VAR_OUTPUT that are copied after the call.
    pub(super) captures: Vec<Capture>,
    /// Some VAR_INPUT is left out.
    pub(super) omitted: bool,
    /// An argument is for no parameter; it may well have been meant for one that is left out.
    unknown: bool,
}

/// `name => target` or `NOT name => target`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Capture {
    /// The output, as the index of a variable.
    pub(super) output: u32,
    pub(super) negated: bool,
    pub(super) target: ExpressionId,
}

impl<'m> Lowering<'m> {
    /// Binds arguments to parameters; `None` where they do not go together at all. What is wrong with single
    /// arguments is said, and the others are bound all the same.
    pub(super) fn bind(
        &mut self,
        pou: u32,
        arguments: &[Argument<'m>],
        call: Span,
    ) -> Option<BoundArguments> {
        let entry = &self.model.pous[pou as usize];
        let levels = self.model.levels(pou);
        let parameters = levels.iter().flat_map(|level| &level.positional);
        let (mut least, mut most) = (0, 0);
        for level in levels.iter().filter(|level| !level.positional.is_empty()) {
            least = if level.required > 0 {
                most + level.required
            } else {
                least
            };
            most += level.positional.len();
        }
        let positional: Vec<_> = arguments
            .iter()
            .filter_map(|argument| match argument {
                Argument::Positional(value) => Some(*value),
                _ => None,
            })
            .collect();
        let by_name = arguments
            .iter()
            .any(|argument| matches!(argument, Argument::Named { .. }));
        if by_name && !positional.is_empty() {
            self.refuse(mixed(call), arguments);
            return None;
        }
        let is_plain = entry.pou.kind == PouKind::Function;
        let by_position = !positional.is_empty() || (is_plain && arguments.is_empty());
        let (first, more) = positional.split_at(most.min(positional.len()));
        if by_position && (first.len() < least || !more.is_empty() && !entry.takes_more) {
            let code = if entry.is_function() {
                Code::FunctionCallWrongArgCount
            } else {
                Code::FunctionInvocationRequiresFormal
            };
            let name = entry.pou.name.text;
            let message = format!(
                "`{name}` takes {most} arguments by position, not {}",
                positional.len()
            );
            self.refuse(SpannedDiagnostic::new(code, call, message), arguments);
            return None;
        }
        let mut bound = BoundArguments::default();
        for (&parameter, &argument) in parameters.zip(first) {
            self.bind_one(parameter, argument, false, &mut bound);
        }
        for &argument in more {
            // What takes more has no body here, so that only what is wrong inside an argument counts.
            let start = self.emitter.position();
            self.value(argument, None);
            self.emitter.truncate(start);
        }
        self.bind_names(entry, arguments, &mut bound);
        if !by_position || self.model.source.dialect.outputs_by_position {
            self.find_omitted(&levels, call, &mut bound);
        }
        Some(bound)
    }

    fn bind_names(
        &mut self,
        entry: &'m PouEntry<'m>,
        arguments: &[Argument<'m>],
        bound: &mut BoundArguments,
    ) {
        let mut given = FxHashSet::default();
        for argument in arguments {
            match argument {
                Argument::Positional(_) => {}
                Argument::Named { name, value } => match self.parameter(entry, *name, &mut given) {
                    Some(parameter) => bound.inputs.push((parameter, *value)),
                    None => {
                        bound.unknown = true;
                        self.value(*value, None);
                    }
                },
                Argument::Output {
                    name,
                    negated,
                    target,
                } => match self.output(entry, *name, &mut given) {
                    Some(output) => self.bind_one(output, *target, *negated, bound),
                    None => {
                        self.place(*target);
                    }
                },
            }
        }
    }

    /// Binds an argument to a parameter. An output that is an ARRAY[*] is passed as a VAR_IN_OUT is.
    fn bind_one(&self, output: u32, target: ExpressionId, negated: bool, bound: &mut BoundArguments) {
        let variable = self.model.variable(output);
        match variable.section == VariableKind::Output && (variable.limits == 0 || negated) {
            true => bound.captures.push(Capture {
                output,
                negated,
                target,
            }),
            false => bound.inputs.push((output, target)),
        }
    }

    fn parameter(&mut self, entry: &PouEntry<'_>, name: Name<'_>, given: &mut FxHashSet<u32>) -> Option<u32> {
        let found = self.local(entry, name.text).filter(|&index| {
            matches!(
                self.model.variable(index).section,
                VariableKind::Input | VariableKind::InOut
            )
        });
        let Some(parameter) = found else {
            let message = format!("`{}` has no input `{}`", entry.pou.name.text, name.text);
            self.report(Code::FunctionCallNamedArgUndeclared, name.span, message);
            return None;
        };
        self.once(parameter, name, given)
    }

    fn output(&mut self, entry: &PouEntry<'_>, name: Name<'_>, given: &mut FxHashSet<u32>) -> Option<u32> {
        let found = self.local(entry, name.text).filter(|&index| {
            self.model.variable(index).section == VariableKind::Output && entry.result != Some(index)
        });
        let Some(output) = found else {
            let code = if entry.is_function() {
                Code::FunctionCallNamedArgUndeclared
            } else {
                Code::FunctionInvocationUndefinedOutput
            };
            let message = format!("`{}` has no output `{}`", entry.pou.name.text, name.text);
            self.report(code, name.span, message);
            return None;
        };
        self.once(output, name, given)
    }

    fn once(&mut self, index: u32, name: Name<'_>, given: &mut FxHashSet<u32>) -> Option<u32> {
        if given.insert(index) {
            return Some(index);
        }
        let message = format!("`{}` is given twice", name.text);
        self.report(Code::FunctionCallDuplicateNamedArg, name.span, message);
        None
    }

    /// Notes whether inputs are left out, and says so of VAR_IN_OUT: of the first only, lest each of many calls
    /// be held against each of many parameters.
    fn find_omitted(&mut self, levels: &[&PouEntry<'_>], call: Span, bound: &mut BoundArguments) {
        let needed: usize = levels.iter().map(|level| level.parameters.len()).sum();
        if bound.inputs.len() == needed {
            return;
        }
        bound.omitted = true;
        let given: FxHashSet<_> = bound.inputs.iter().map(|&(parameter, _)| parameter).collect();
        let is_in_out = |parameter: u32| self.model.variable(parameter).kind == VariableKind::InOut;
        let mut parameters = levels.iter().flat_map(|level| &level.parameters);
        let missing = parameters.find(|&&parameter| is_in_out(parameter) && !given.contains(&parameter));
        let Some(&missing) = missing.filter(|_| !bound.unknown) else {
            return;
        };
        let code = if levels.iter().any(|level| level.is_function()) {
            Code::FunctionCallWrongArgCount
        } else {
            Code::FunctionInvocationMissingInput
        };
        let name = self.model.variable(missing).name.text;
        self.report(code, call, format!("`{name}` needs an argument"));
    }
}
