//! Reading of statements back into the model.

use super::Reader;
use crate::generator::TypeContext;
use crate::model::{
    Argument, AssignmentTarget, CaseBranch, CaseLabel, Expression, ExpressionKind, ForLoop, Statement, Type,
    VariableId, VariableSection,
};
use stickler_syntax::tree::{self, ExpressionId};

impl Reader<'_> {
    /// Reads a list of statements, without the empty ones.
    pub(super) fn statements(&self, statements: &[tree::Statement]) -> Option<Vec<Statement>> {
        let full = statements
            .iter()
            .filter(|statement| !matches!(statement.kind, tree::StatementKind::Empty));
        full.map(|statement| self.statement(&statement.kind)).collect()
    }

    fn statement(&self, statement: &tree::StatementKind) -> Option<Statement> {
        Some(match statement {
            tree::StatementKind::Assignment { target, value } => {
                let (target, ty) = self.target(*target)?;
                Statement::Assign(target, self.value(*value, &ty, TypeContext::Assigned)?)
            }
            tree::StatementKind::Call(call) => self.invocation(*call)?,
            tree::StatementKind::If { branches, otherwise } => {
                let branches = branches
                    .iter()
                    .map(|(condition, body)| Some((self.condition(*condition)?, self.statements(body)?)));
                Statement::If(
                    branches.collect::<Option<_>>()?,
                    self.otherwise(otherwise.as_deref())?,
                )
            }
            tree::StatementKind::Case {
                selector,
                branches,
                otherwise,
            } => {
                let selector = self.own(*selector)?;
                let branches = branches.iter().map(|branch| self.branch(branch, &selector.ty));
                let branches = branches.collect::<Option<_>>()?;
                Statement::Case(selector, branches, self.otherwise(otherwise.as_deref())?)
            }
            tree::StatementKind::For {
                control,
                from,
                to,
                by,
                body,
            } => {
                let control = self.place(*control).filter(|place| place.path.is_empty())?;
                let value = |id| self.value(id, &control.ty, TypeContext::Assigned);
                Statement::For(ForLoop {
                    variable: control.variable,
                    from: value(*from)?,
                    to: value(*to)?,
                    by: match by {
                        Some(by) => Some(literal(value(*by)?)?),
                        None => None,
                    },
                    body: self.statements(body)?,
                })
            }
            tree::StatementKind::While { condition, body } => {
                Statement::While(self.condition(*condition)?, self.statements(body)?)
            }
            tree::StatementKind::Repeat { body, until } => {
                Statement::Repeat(self.statements(body)?, self.condition(*until)?)
            }
            tree::StatementKind::Exit => Statement::Exit,
            tree::StatementKind::Return => Statement::Return,
            tree::StatementKind::Jump(_) | tree::StatementKind::Label(_) => return None,
            tree::StatementKind::Binding { .. } | tree::StatementKind::Continue => return None,
            tree::StatementKind::Empty => return None,
        })
    }

    fn otherwise(&self, otherwise: Option<&[tree::Statement]>) -> Option<Option<Vec<Statement>>> {
        otherwise.map_or(Some(None), |body| self.statements(body).map(Some))
    }

    fn branch(&self, branch: &tree::CaseBranch, selector: &Type) -> Option<CaseBranch> {
        let value = |id| literal(self.value(id, selector, TypeContext::Operand)?);
        let labels = branch.labels.iter().map(|label| {
            Some(match label {
                tree::CaseLabel::Value(one) => CaseLabel::One(value(*one)?),
                tree::CaseLabel::Range(low, high) => CaseLabel::Range(value(*low)?, value(*high)?),
            })
        });
        Some(CaseBranch {
            labels: labels.collect::<Option<_>>()?,
            body: self.statements(&branch.body)?,
        })
    }

    /// Reads the left side of an assignment, and its type.
    fn target(&self, id: ExpressionId) -> Option<(AssignmentTarget, Type)> {
        match (&self.unit.expression(id)?.kind, &self.function) {
            (tree::ExpressionKind::Name(name), Some((function, result))) if name.is(function) => {
                Some((AssignmentTarget::Result, result.clone()))
            }
            (tree::ExpressionKind::Bit { .. }, _) => {
                let (place, bit) = self.bit(id)?;
                Some((AssignmentTarget::Bit(place, bit), super::BOOL))
            }
            _ => {
                let place = self.place(id)?;
                let ty = place.ty.clone();
                Some((AssignmentTarget::Place(place), ty))
            }
        }
    }

    /// Reads a call of an instance of a function block.
    fn invocation(&self, call: ExpressionId) -> Option<Statement> {
        let tree::ExpressionKind::Call { callee, arguments } = &self.unit.expression(call)?.kind else {
            return None;
        };
        let instance = self.place(*callee)?;
        let Type::Block(block) = instance.ty else {
            return None;
        };
        let parameters = &self.program.blocks.get(block)?.variables;
        let ty = |parameter: VariableId| Some(&parameters.get(parameter.0)?.ty);
        let (mut inputs, mut outputs) = (Vec::new(), Vec::new());
        for argument in arguments {
            match argument {
                tree::Argument::Named { name, value } => {
                    let input = self.parameter(parameters, name, &[VariableSection::Input]);
                    let (parameter, value) = match input {
                        Some(input) => (input, self.value(*value, ty(input)?, TypeContext::Argument)?),
                        None => {
                            let in_out = self.parameter(parameters, name, &[VariableSection::InOut])?;
                            let given = self.own(*value)?;
                            let is_variable = matches!(given.kind, ExpressionKind::Read(_));
                            let ty = self.program.unaliased(ty(in_out)?);
                            (
                                in_out,
                                Some(given).filter(|given| is_variable && given.ty == *ty)?,
                            )
                        }
                    };
                    inputs.push(Argument { parameter, value });
                }
                tree::Argument::Output {
                    name,
                    negated: false,
                    target,
                } => {
                    let output = self.parameter(parameters, name, &[VariableSection::Output])?;
                    let place = self.place(*target)?;
                    outputs.push((output, Some(place).filter(|place| ty(output) == Some(&place.ty))?));
                }
                _ => return None,
            }
        }
        Some(Statement::Invoke {
            instance: instance.variable,
            inputs,
            outputs,
        })
    }
}

/// Returns an expression that is a literal or an enumerated value.
fn literal(value: Expression) -> Option<Expression> {
    let is_literal = matches!(
        value.kind,
        ExpressionKind::Literal(..) | ExpressionKind::Enumerated(_)
    );
    is_literal.then_some(value)
}
