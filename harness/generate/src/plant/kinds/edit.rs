//! The edits by which errors are planted that need no function of their own.

use super::super::fault_site::{FaultSite, PLANTED};
use super::super::scope::elementary;
use super::super::walk::ExpressionContext;
use super::literals::integer_site;
use super::misfits::{MisfitForm, misfit};
use super::omitted_conversions::omit_conversion;
use super::operands::stands_for_any_value;
use super::table::{Plant, function};
use crate::model::{ExpressionKind, Statement, Unit, VariableSection};
use serde::de::{Deserialize, Deserializer, Error};
use stickler_types::ElementaryType;

/// A way to plant an error; `kinds.toml` says what each does.
#[derive(serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Edit {
    #[serde(deserialize_with = "function")]
    Function(Plant),
    Misfit {
        context: ExpressionContext,
        forms: Vec<MisfitForm>,
    },
    OmittedConversion(Vec<ExpressionContext>),
    Integer {
        contexts: Vec<ExpressionContext>,
        texts: Vec<String>,
    },
    Literal(Vec<TypedTexts>),
    Constant(Vec<String>),
    Value(String),
    Part(TypedTexts),
    Statement(Vec<String>),
    StatementOutsideLoops(String),
    Declaration(Vec<String>),
    ConstantDeclaration(Vec<String>),
}

/// Texts for a type.
#[derive(serde::Deserialize)]
pub(super) struct TypedTexts {
    #[serde(rename = "type", deserialize_with = "elementary_type")]
    ty: ElementaryType,
    texts: Vec<String>,
}

fn elementary_type<'de, D: Deserializer<'de>>(deserializer: D) -> Result<ElementaryType, D::Error> {
    let name = String::deserialize(deserializer)?;
    ElementaryType::from_name(&name).ok_or_else(|| Error::custom(format!("`{name}` is no type")))
}

impl Edit {
    pub(super) fn make(&self, fault: &mut FaultSite<'_, '_>) -> Option<()> {
        match self {
            Edit::Function(plant) => plant(fault),
            Edit::Misfit { context, forms } => misfit(fault, *context, forms),
            Edit::OmittedConversion(contexts) => {
                omit_conversion(fault, |context| contexts.contains(&context))
            }
            Edit::Integer { contexts, texts } => integer(fault, contexts, texts),
            Edit::Literal(alternatives) => alternatives.iter().find_map(|one| literal(fault, one)),
            Edit::Constant(texts) => constant(fault, texts),
            Edit::Value(text) => {
                let (number, ..) = fault.pick_expression(stands_for_any_value)?;
                fault.replace(number, ExpressionKind::Raw(text.clone()));
                Some(())
            }
            Edit::Part(part) => self::part(fault, part),
            Edit::Statement(texts) => fault.insert_text(|fault, unit| statement(fault, unit, texts)),
            Edit::StatementOutsideLoops(text) => {
                fault.insert(|_, in_loop| !in_loop, |_, _| Some(Statement::Raw(text.clone())))
            }
            Edit::Declaration(texts) => declaration(fault, VariableSection::Local, texts),
            Edit::ConstantDeclaration(texts) => declaration(fault, VariableSection::Constant, texts),
        }
    }
}

/// Puts one of the texts in a place for a value of a type.
fn literal(fault: &mut FaultSite<'_, '_>, TypedTexts { ty, texts }: &TypedTexts) -> Option<()> {
    let original = fault.original;
    let (number, ..) = fault.pick_expression(|site, expression| {
        site.context != ExpressionContext::InOut && elementary(original, &expression.ty) == Some(*ty)
    })?;
    let text = fault.choose(texts.clone())?;
    fault.replace(number, ExpressionKind::Raw(text))
}

/// Puts one of the texts in one of these contexts, for a value of an integer type.
fn integer(fault: &mut FaultSite<'_, '_>, contexts: &[ExpressionContext], texts: &[String]) -> Option<()> {
    let original = fault.original;
    let is_integer = |ty: &ElementaryType| ty.is_integer();
    let (number, _, expression) = fault.pick_expression(|site, expression| {
        contexts.contains(&site.context)
            && elementary(original, &expression.ty)
                .as_ref()
                .is_some_and(is_integer)
    })?;
    written(fault, number, elementary(original, &expression.ty)?, texts)
}

/// Puts one of the texts in a place for a value of an integer type.
fn constant(fault: &mut FaultSite<'_, '_>, texts: &[String]) -> Option<()> {
    let (number, ty) = integer_site(fault)?;
    written(fault, number, ty, texts)
}

/// Replaces an expression of an integer type by one of the texts, in which numbers of that type are named.
fn written(fault: &mut FaultSite<'_, '_>, number: usize, ty: ElementaryType, texts: &[String]) -> Option<()> {
    let (low, high) = ty.integer_range()?;
    let mut text = fault.choose(texts.to_vec())?.replace("{type}", ty.name());
    for (name, value) in [
        ("{low}", low),
        ("{high}", high),
        ("{below}", low - 1),
        ("{above}", high + 1),
        ("{far}", high * 3),
    ] {
        text = text.replace(name, &value.to_string());
    }
    fault.replace(number, ExpressionKind::Raw(text))
}

/// Replaces an expression, in a place that takes any value, by a variable of a type followed by one of the texts.
fn part(fault: &mut FaultSite<'_, '_>, TypedTexts { ty, texts }: &TypedTexts) -> Option<()> {
    let (number, site, _) = fault.pick_expression(stands_for_any_value)?;
    let name = fault.variable_text(site.unit, *ty)?;
    let text = fault.choose(texts.clone())?;
    fault.replace(number, ExpressionKind::Raw(format!("{name}{text}")))
}

fn statement(fault: &mut FaultSite<'_, '_>, unit: Unit, texts: &[String]) -> Option<String> {
    let name = match texts.iter().any(|text| text.contains("{name}")) {
        true => fault.variable_text(unit, ElementaryType::Int)?,
        false => String::new(),
    };
    let text = fault.choose(texts.to_vec())?;
    Some(text.replace("{name}", &name))
}

/// Declares one of several types for a variable with a name of its own.
pub(super) fn declaration(
    fault: &mut FaultSite<'_, '_>,
    section: VariableSection,
    texts: &[String],
) -> Option<()> {
    let unit = fault.unit()?;
    let text = fault.choose(texts.to_vec())?;
    fault.declare_text(unit, &format!("{PLANTED}_one {text}"), section)
}
