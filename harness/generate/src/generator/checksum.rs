//! The end of main, where everything flows together into `checksum`.

use super::expressions::{elementary, read, whole};
use super::maker::Maker;
use crate::model::{
    BinaryOperator, Expression, ExpressionKind, LiteralForm, Statement, StatementKind, Target, Type,
    VariableId,
};
use stickler_types::{ElementaryType, Value};

impl Maker<'_, '_> {
    /// Adds the variable `checksum` and the statements that compute it from all others.
    pub fn add_checksums(&mut self, body: &mut Vec<Statement>) {
        let observed = self.variables.len();
        let checksum = self.add_variable(
            "checksum".to_owned(),
            Type::Elementary(ElementaryType::Lint),
            None,
        );
        for variable in (0..observed).map(VariableId) {
            let Type::Elementary(ty) = self.variables[variable.0].ty else {
                continue;
            };
            if let Some(number) = self.as_lint(read(variable, ty), ty) {
                body.push(mix(checksum, number));
            }
        }
    }

    /// A value as LINT, where documents settle what that gives.
    fn as_lint(&self, value: Expression, ty: ElementaryType) -> Option<Expression> {
        let lint = ElementaryType::Lint;
        if ty == lint {
            return Some(value);
        }
        let kind = if self.language.sources(lint).contains(&ty) {
            ExpressionKind::Widen(Box::new(value))
        } else {
            ExpressionKind::Convert(self.language.settled(ty, lint)?.clone(), Box::new(value))
        };
        Some(elementary(lint, kind))
    }
}

/// `checksum := checksum * 31 + number;`
fn mix(checksum: VariableId, number: Expression) -> Statement {
    let lint = ElementaryType::Lint;
    let factor = elementary(
        lint,
        ExpressionKind::Literal(Value::plain(lint, 31), LiteralForm::Untyped),
    );
    let product = ExpressionKind::Binary(
        BinaryOperator::Multiply,
        Box::new(read(checksum, lint)),
        Box::new(factor),
    );
    let sum = ExpressionKind::Binary(
        BinaryOperator::Add,
        Box::new(elementary(lint, product)),
        Box::new(number),
    );
    Statement {
        kind: StatementKind::Assign(
            Target::Place(whole(checksum, Type::Elementary(lint))),
            elementary(lint, sum),
        ),
    }
}
