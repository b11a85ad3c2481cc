//! Checksums at the end of main, which combine all values: the LINT `checksum`, and for reals the LREAL `checksum_real`. A program that
//! shall do without these types has the widest integer and real that there are.
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
use crate::model::{
    BinaryOperator, CaseBranch, CaseLabel, Expression, LiteralForm, PathStep, Place, PlaceSelector,
    StandardFunction, Statement, Type, VariableId, assign, integer, subscripts, whole,
};
use stickler_types::{ElementaryType, Family, Value};

/// The types of a checksum, the first that the program may have.
const INTEGERS: [ElementaryType; 8] = {
    use ElementaryType::{Dint, Int, Lint, Sint, Udint, Uint, Ulint, Usint};
    [Lint, Ulint, Dint, Udint, Int, Uint, Sint, Usint]
};
const REALS: [ElementaryType; 2] = [ElementaryType::Lreal, ElementaryType::Real];

/// A variable that combines values.
#[derive(Clone, Copy)]
struct Checksum {
    variable: VariableId,
    ty: ElementaryType,
}

impl ProgramBuilder<'_, '_> {
    /// Adds the variables of the checksums and the statements that compute them.
    pub fn add_checksums(&mut self, body: &mut Vec<Statement>) {
        let places = self.parts();
        let Some(checksum) = self.checksum("checksum", &INTEGERS) else {
            return;
        };
        let has_reals = places
            .iter()
            .any(|place| matches!(place.ty, Type::Elementary(ty) if ty.is_real()));
        let reals = match has_reals {
            true => self.checksum("checksum_real", &REALS),
            false => None,
        };
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

    /// Declares a checksum of the first of these types that the program may have; `None` where there is none, or no sum.
    fn checksum(&mut self, name: &str, types: &[ElementaryType]) -> Option<Checksum> {
        if self.lacks("add") {
            return None;
        }
        let ty = *types.iter().find(|ty| !self.lacks(ty.name()))?;
        let variable = self.pou.declare_reserved(name.to_owned(), ty);
        Some(Checksum { variable, ty })
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
    fn mixed(&mut self, checksum: Checksum, place: Place, ty: ElementaryType) -> Vec<Statement> {
        if let Some(number) = self.as_number(Expression::read(place.clone()), ty, checksum.ty) {
            return vec![self.mix(checksum, number)];
        }
        let is_element = place
            .path
            .iter()
            .any(|selector| matches!(selector, PlaceSelector::Index(_)));
        let mut statements = Vec::new();
        if ty.is_text() {
            let text = vec![Expression::read(place.clone())];
            let length = Expression::standard(StandardFunction::Len, text, ElementaryType::Int);
            statements.extend(
                self.as_number(length, ElementaryType::Int, checksum.ty)
                    .map(|number| self.mix(checksum, number)),
            );
            // A comparison for each text of an array would fill pages.
            if is_element {
                return statements;
            }
        }
        let form = match ty.is_text() || self.lacks_typed(ty) {
            true => LiteralForm::Untyped,
            false => LiteralForm::Typed,
        };
        let literal = Expression::literal(ty, self.telling_value(ty), form);
        let operator = match ty.family() {
            Family::Text | Family::Character | Family::Boolean => BinaryOperator::Equal,
            _ => BinaryOperator::Less,
        };
        let condition = if ty == ElementaryType::Bool {
            Expression::read(place)
        } else {
            Expression::binary(operator, Expression::read(place), literal, ElementaryType::Bool)
        };
        if self.lacks("if") || self.lacks("else") {
            return statements;
        }
        let [first, second] = [1, 2].map(|added| vec![self.mix(checksum, number(checksum.ty, added))]);
        statements.push(Statement::If(vec![(condition, first)], Some(second)));
        statements
    }

    /// Picks a value to compare with that is not the least one of its type.
    fn telling_value(&mut self, ty: ElementaryType) -> Value {
        let first = self.drawn(ty);
        match first {
            Value::Plain { raw: 0, .. } => {
                let mut last = literals::boundaries(ty).iter().rev();
                last.find(|value| self.profile.holds(value))
                    .cloned()
                    .unwrap_or(first)
            }
            _ => first,
        }
    }

    /// Converts a value to the type of a checksum, where documents settle the result.
    fn as_number(&self, value: Expression, ty: ElementaryType, sum: ElementaryType) -> Option<Expression> {
        if ty == sum {
            return Some(value);
        }
        if self.profile.mixes_operands()
            && self.profile.sources(sum).contains(&ty)
            && !self.lacks(&format!("{ty} to {sum}"))
        {
            return Some(Expression::widened(Type::Elementary(sum), value));
        }
        let settled = self.profile.settled(ty, sum)?;
        let lacks = self.lacks("conversion") || self.lacks(&settled.function);
        (!lacks).then(|| convert(settled, value))
    }

    /// Generates `CASE place OF name: … END_CASE`, with a number for each name.
    fn mixed_enumeration(&mut self, checksum: Checksum, place: Place, ty: &Type) -> Option<Statement> {
        if self.lacks("case") {
            return None;
        }
        let count = self.program.enumerated_values(ty)?.len();
        let branches = (0..count).map(|value| CaseBranch {
            labels: vec![CaseLabel::One(Expression::enumerated(ty, value))],
            body: vec![self.mix(checksum, number(checksum.ty, value as i64))],
        });
        let branches = branches.collect();
        Some(Statement::Case(Expression::read(place), branches, None))
    }

    /// Generates `sum := sum * 0.5 + value;`.
    fn mixed_real(&self, sum: Checksum, value: Expression, ty: ElementaryType) -> Option<Statement> {
        let value = self.as_number(value, ty, sum.ty)?;
        let form = match self.lacks_typed(sum.ty) {
            true => LiteralForm::Untyped,
            false => LiteralForm::Typed,
        };
        let half = Expression::literal(sum.ty, Value::of_real(sum.ty, 0.5), form);
        Some(self.combined(sum, half, value))
    }

    /// Generates `checksum := checksum * 31 + number;`.
    fn mix(&self, checksum: Checksum, added: Expression) -> Statement {
        self.combined(checksum, number(checksum.ty, 31), added)
    }

    fn combined(&self, sum: Checksum, factor: Expression, added: Expression) -> Statement {
        let Checksum { variable, ty } = sum;
        let mut left = whole(variable, ty);
        if !self.lacks("multiply") {
            left = Expression::binary(BinaryOperator::Multiply, left, factor, ty);
        }
        assign(
            variable,
            ty,
            Expression::binary(BinaryOperator::Add, left, added, ty),
        )
    }
}

/// Expands the steps of a path to the paths of every element.
fn spread(steps: &[PathStep]) -> Vec<Vec<PlaceSelector>> {
    let mut paths = vec![Vec::new()];
    for step in steps {
        let selectors = match step {
            PathStep::Field(field) => vec![PlaceSelector::Field(*field)],
            PathStep::Output(output) => vec![PlaceSelector::Output(*output)],
            PathStep::Followed => vec![PlaceSelector::Followed],
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
    let subscript = |number: &i64| integer(ElementaryType::Int, *number, LiteralForm::Untyped);
    let selectors = subscripts(limits).into_iter();
    selectors
        .map(|numbers| PlaceSelector::Index(numbers.iter().map(subscript).collect()))
        .collect()
}

fn number(ty: ElementaryType, number: i64) -> Expression {
    integer(ty, number, LiteralForm::Untyped)
}
