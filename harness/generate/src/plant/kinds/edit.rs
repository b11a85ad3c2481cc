//! The edits by which errors are planted that need no function of their own.

use super::super::fault_site::{FaultSite, PLANTED};
use super::super::scope::elementary;
use super::super::walk::ExpressionContext;
use super::bits::MissingBits;
use super::calls;
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
    Expression(Vec<Replacement>),
    Call(String),
    BitRead(MissingBits),
    BitWritten(MissingBits),
    Statement(Vec<String>),
    StatementOutsideLoops(String),
    Declaration(Vec<String>),
    ConstantDeclaration(Vec<String>),
}

impl Edit {
    pub(super) fn make(&self, fault: &mut FaultSite<'_, '_>) -> Option<()> {
        match self {
            Edit::Function(plant) => plant(fault),
            Edit::Misfit { context, forms } => misfit(fault, *context, forms),
            Edit::OmittedConversion(contexts) => {
                omit_conversion(fault, |context| contexts.contains(&context))
            }
            Edit::Expression(replacements) => {
                let first = fault.choose((0..replacements.len()).collect())?;
                let (before, from) = replacements.split_at(first);
                from.iter().chain(before).find_map(|one| one.plant(fault))
            }
            Edit::Call(arguments) => calls::call(fault, arguments),
            Edit::BitRead(bits) => bits.read(fault),
            Edit::BitWritten(bits) => bits.write(fault),
            Edit::Statement(texts) => fault.insert_text(|fault, unit| {
                let text = fault.choose(texts.clone())?;
                with_variable(fault, unit, &text)
            }),
            Edit::StatementOutsideLoops(text) => {
                fault.insert(|_, in_loop| !in_loop, |_, _| Some(Statement::Raw(text.clone())))
            }
            Edit::Declaration(texts) => declaration(fault, VariableSection::Local, texts),
            Edit::ConstantDeclaration(texts) => declaration(fault, VariableSection::Constant, texts),
        }
    }
}

/// Texts in the place of an expression.
#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Replacement {
    /// The contexts of the expression; without them, those that take any value.
    contexts: Option<Vec<ExpressionContext>>,
    /// The types of the expression; without them, any.
    #[serde(default, rename = "type", deserialize_with = "types")]
    types: Vec<ElementaryType>,
    texts: Vec<String>,
}

/// Reads a word for elementary types.
fn types<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<ElementaryType>, D::Error> {
    let word = String::deserialize(deserializer)?;
    let is_meant = |ty: &ElementaryType| match &*word {
        "integer" => ty.is_integer(),
        "signed" => ty.is_signed(),
        "unsigned" => ty.is_unsigned(),
        name => ty.name() == name,
    };
    let types: Vec<_> = ElementaryType::ALL.into_iter().filter(is_meant).collect();
    match types.is_empty() {
        true => Err(Error::custom(format!("`{word}` stands for no type"))),
        false => Ok(types),
    }
}

impl Replacement {
    fn plant(&self, fault: &mut FaultSite<'_, '_>) -> Option<()> {
        let original = fault.original;
        let (number, site, expression) = fault.pick_expression(|site, expression| {
            let is_in_place = match &self.contexts {
                Some(contexts) => contexts.contains(&site.context),
                None => stands_for_any_value(site, expression),
            };
            let ty = elementary(original, &expression.ty);
            is_in_place && (self.types.is_empty() || ty.is_some_and(|ty| self.types.contains(&ty)))
        })?;
        let mut text = fault.choose(self.texts.clone())?;
        let ty = elementary(original, &expression.ty).filter(|ty| ty.is_integer());
        if let Some((ty, (low, high))) = ty.zip(ty.and_then(ElementaryType::integer_range)) {
            text = text.replace("{type}", ty.name());
            for (name, value) in [
                ("{low}", low),
                ("{high}", high),
                ("{below}", low - 1),
                ("{above}", high + 1),
                ("{far}", high * 3),
            ] {
                text = text.replace(name, &value.to_string());
            }
        }
        let text = with_variable(fault, site.unit, &text)?;
        fault.replace(number, ExpressionKind::Raw(text))
    }
}

/// Replaces the type that a text names in braces by the name of a variable of this type.
fn with_variable(fault: &mut FaultSite<'_, '_>, unit: Unit, text: &str) -> Option<String> {
    let Some((_, rest)) = text.split_once('{') else {
        return Some(text.to_owned());
    };
    let (ty, _) = rest.split_once('}')?;
    let name = fault.variable_text(unit, ElementaryType::from_name(ty)?)?;
    Some(text.replace(&format!("{{{ty}}}"), &name))
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
