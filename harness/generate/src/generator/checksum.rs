//! Checksums at the end of main, which combine all values: the LINT `checksum`, and for reals the LREAL `checksum_real`.
//!
//! Values enter only in ways that documents settle, which depends on the dialect:
//!
//! | value | enters |
//! |---|---|
//! | LINT, and types that widen to it | unchanged |
//! | other integers, bit strings, BOOL, TIME | by `<TYPE>_TO_LINT`, where documents of the dialect state its results |
//! | texts | by LEN |
//! | enumerations | by CASE |
//! | REAL and LREAL | in `checksum_real`, which is halved before |
//! | all other values, and texts besides | by comparison with a literal |
//! | arrays and structures | by each of their parts |
//!
//! The comparison keeps little of a value (in PLCnext, whose documents say next to nothing about conversion functions, also
//! of a ULINT or LWORD). But each value is also observed itself: see [`crate::model::Program::observed`].

use super::builder::ProgramBuilder;
use super::calls::convert;
use super::literals;
use super::places::{assign, integer, whole};
use super::scope::PathStep;
use crate::model::{
    ArrayType, BinaryOperator, CaseBranch, CaseLabel, Expression, ExpressionKind, LiteralForm, Place,
    PlaceSelector, StandardFunction, Statement, Type, VariableId, subscripts,
};
use stickler_types::{ElementaryType, Family, Value};

const LINT: ElementaryType = ElementaryType::Lint;
const LREAL: ElementaryType = ElementaryType::Lreal;

impl ProgramBuilder<'_, '_> {
    /// Adds the variables of the checksums and the statements that compute them.
    pub fn add_checksums(&mut self, body: &mut Vec<Statement>) {
        let places = self.parts();
        let checksum = self.pou.declare_reserved("checksum".to_owned(), LINT);
        let has_reals = places
            .iter()
            .any(|place| matches!(place.ty, Type::Elementary(ty) if ty.is_real()));
        let reals = has_reals.then(|| self.pou.declare_reserved("checksum_real".to_owned(), LREAL));
        for place in places {
            match (place.ty.clone(), reals) {
                (Type::Elementary(ty), Some(reals)) if ty.is_real() => {
                    body.extend(self.mixed_real(reals, Expression::read(place), ty));
                }
                (Type::Elementary(ty), _) => body.extend(self.mixed(checksum, place, ty)),
                (ty, _) => body.extend(self.mixed_enumeration(checksum, place, &ty)),
            }
        }
    }

    /// Returns every elementary or enumerated part of the variables of main, except for those that the generator reserves
    /// for itself.
    fn parts(&self) -> Vec<Place> {
        let mut parts = Vec::new();
        for seen in &self.pou.places {
            let is_own = self.pou.idle.iter().any(|&(idle, _)| idle == seen.variable);
            let is_part =
                matches!(seen.ty, Type::Elementary(_)) || self.program.enumerated_values(&seen.ty).is_some();
            if is_part && !is_own {
                for path in spread(&seen.path) {
                    parts.push(Place {
                        variable: seen.variable,
                        path,
                        ty: seen.ty.clone(),
                    });
                }
            }
        }
        parts
    }

    /// Generates the statements that add a value other than a real to the checksum.
    fn mixed(&mut self, checksum: VariableId, place: Place, ty: ElementaryType) -> Vec<Statement> {
        if let Some(number) = self.as_lint(Expression::read(place.clone()), ty) {
            return vec![mix(checksum, number)];
        }
        let is_element = place
            .path
            .iter()
            .any(|selector| matches!(selector, PlaceSelector::Index(_)));
        let mut statements = Vec::new();
        if ty.is_text() {
            let length =
                ExpressionKind::Standard(StandardFunction::Len, vec![Expression::read(place.clone())]);
            let length = Expression::elementary(ElementaryType::Int, length);
            statements.extend(
                self.as_lint(length, ElementaryType::Int)
                    .map(|number| mix(checksum, number)),
            );
            // A comparison for each text of an array would fill pages.
            if is_element {
                return statements;
            }
        }
        let literal = self.telling_value(ty);
        let literal = Expression::literal(
            ty,
            literal,
            if ty.is_text() {
                LiteralForm::Untyped
            } else {
                LiteralForm::Typed
            },
        );
        let ordered = !matches!(ty.family(), Family::Text | Family::Character | Family::Boolean);
        let operator = if ordered {
            BinaryOperator::Less
        } else {
            BinaryOperator::Equal
        };
        let condition = if ty == ElementaryType::Bool {
            Expression::read(place)
        } else {
            Expression::binary(operator, Expression::read(place), literal, ElementaryType::Bool)
        };
        let otherwise = vec![mix(checksum, number(2))];
        statements.push(Statement::If(
            vec![(condition, vec![mix(checksum, number(1))])],
            Some(otherwise),
        ));
        statements
    }

    /// Picks a value to compare with that is not the least one of its type.
    fn telling_value(&mut self, ty: ElementaryType) -> Value {
        let first = literals::value(ty, &mut self.random);
        match first {
            Value::Plain { raw: 0, .. } => literals::boundaries(ty).last().cloned().unwrap_or(first),
            _ => first,
        }
    }

    /// Converts a value to LINT, where documents settle the result.
    fn as_lint(&self, value: Expression, ty: ElementaryType) -> Option<Expression> {
        if ty == LINT {
            return Some(value);
        }
        if self.profile.sources(LINT).contains(&ty) {
            return Some(Expression::elementary(
                LINT,
                ExpressionKind::Widen(Box::new(value)),
            ));
        }
        let settled = self.profile.settled(ty, LINT)?;
        Some(convert(settled, value))
    }

    /// Generates `CASE place OF name: … END_CASE`, with a number for each name.
    fn mixed_enumeration(&mut self, checksum: VariableId, place: Place, ty: &Type) -> Option<Statement> {
        let count = self.program.enumerated_values(ty)?.len();
        let branches = (0..count).map(|value| CaseBranch {
            labels: vec![CaseLabel::One(Expression {
                ty: ty.clone(),
                kind: ExpressionKind::Enumerated(value),
            })],
            body: vec![mix(checksum, number(value as i64))],
        });
        Some(Statement::Case(Expression::read(place), branches.collect(), None))
    }

    /// Generates `sum := sum * 0.5 + value;`.
    fn mixed_real(&self, sum: VariableId, value: Expression, ty: ElementaryType) -> Option<Statement> {
        let value = if ty == LREAL {
            value
        } else if self.profile.sources(LREAL).contains(&ty) {
            Expression::elementary(LREAL, ExpressionKind::Widen(Box::new(value)))
        } else {
            convert(self.profile.settled(ty, LREAL)?, value)
        };
        let half = ExpressionKind::Literal(Value::plain(LREAL, 0.5_f64.to_bits()), LiteralForm::Typed);
        let halved = Expression::binary(
            BinaryOperator::Multiply,
            whole(sum, LREAL),
            Expression::elementary(LREAL, half),
            LREAL,
        );
        Some(assign(
            sum,
            LREAL,
            Expression::binary(BinaryOperator::Add, halved, value, LREAL),
        ))
    }
}

/// Expands the steps of a path to the paths of every element.
fn spread(steps: &[PathStep]) -> Vec<Vec<PlaceSelector>> {
    let mut paths = vec![Vec::new()];
    for step in steps {
        let selectors = match step {
            PathStep::Field(field) => vec![PlaceSelector::Field(*field)],
            PathStep::Output(output) => vec![PlaceSelector::Output(*output)],
            PathStep::Index(limits) => every_element(limits),
        };
        paths = paths
            .into_iter()
            .flat_map(|path| {
                selectors.iter().map(move |selector| {
                    let mut longer = path.clone();
                    longer.push(selector.clone());
                    longer
                })
            })
            .collect();
    }
    paths
}

fn every_element(limits: &[(i64, i64)]) -> Vec<PlaceSelector> {
    let array = ArrayType {
        dimensions: limits.to_vec(),
        element: Type::Elementary(LINT),
    };
    let subscript = |number: &i64| integer(ElementaryType::Int, *number, LiteralForm::Untyped);
    let selectors = subscripts(&array).into_iter();
    selectors
        .map(|numbers| PlaceSelector::Index(numbers.iter().map(subscript).collect()))
        .collect()
}

fn number(number: i64) -> Expression {
    integer(LINT, number, LiteralForm::Untyped)
}

/// Generates `checksum := checksum * 31 + number;`.
fn mix(checksum: VariableId, added: Expression) -> Statement {
    let product = Expression::binary(BinaryOperator::Multiply, whole(checksum, LINT), number(31), LINT);
    assign(
        checksum,
        LINT,
        Expression::binary(BinaryOperator::Add, product, added, LINT),
    )
}
