//! Writes sections of variables, types and initial values.

use super::PageSource;
use super::xml::{Xml, attribute, empty, nested};
use std::io;
use stickler_syntax::tree::{
    ArrayElement, ExpressionId, Initializer, InitializerKind, TypeSpecification, TypeSpecificationKind,
    VariableBlock, VariableGroup, VariableKind,
};
use stickler_types::ElementaryType;

impl PageSource<'_> {
    pub(super) fn write_block(&self, xml: &mut Xml, block: &VariableBlock<'_>) -> io::Result<()> {
        let name = match block.kind {
            VariableKind::Local | VariableKind::Static => "localVars",
            VariableKind::Temporary | VariableKind::Instance => "tempVars",
            VariableKind::Input => "inputVars",
            VariableKind::Output => "outputVars",
            VariableKind::InOut => "inOutVars",
            VariableKind::External => "externalVars",
            VariableKind::Global => "globalVars",
            VariableKind::Configured => "configVars",
        };
        let retention = block.retention.map(|word| word.0.to_ascii_uppercase());
        let kept = match retention.as_deref() {
            Some("RETAIN") => Some("retain"),
            Some("NON_RETAIN") => Some("nonretain"),
            _ => None,
        };
        let constant = block.constant.then_some("constant");
        let qualifiers = constant.into_iter().chain(kept);
        let qualifiers = qualifiers.map(|name| attribute(name, "true"));
        nested(xml, name, qualifiers, |xml| self.write_groups(xml, &block.groups))
    }

    fn write_groups(&self, xml: &mut Xml, groups: &[VariableGroup<'_>]) -> io::Result<()> {
        for group in groups {
            for name in &group.names {
                let location = group.location.map(|location| attribute("address", location.text));
                let attributes = [attribute("name", name.text)].into_iter().chain(location);
                nested(xml, "variable", attributes, |xml| {
                    self.write_type(xml, "type", &group.specification)?;
                    self.write_initial_value(xml, group.initializer.as_ref())
                })?;
            }
        }
        Ok(())
    }

    /// Writes a type within an element of the given name.
    pub(super) fn write_type(
        &self,
        xml: &mut Xml,
        element: &str,
        ty: &TypeSpecification<'_>,
    ) -> io::Result<()> {
        nested(xml, element, [], |xml| self.write_specification(xml, ty))
    }

    fn write_specification(&self, xml: &mut Xml, ty: &TypeSpecification<'_>) -> io::Result<()> {
        match &ty.kind {
            TypeSpecificationKind::Named(name) => write_named(xml, name.text),
            TypeSpecificationKind::Pointer { target, .. } => nested(xml, "pointer", [], |xml| {
                nested(xml, "baseType", [], |xml| self.write_specification(xml, target))
            }),
            TypeSpecificationKind::VariableLengthArray { dimensions, element } => {
                nested(xml, "array", [], |xml| {
                    for _ in 0..*dimensions {
                        empty(
                            xml,
                            "dimension",
                            [attribute("lower", "*"), attribute("upper", "*")],
                        )?;
                    }
                    self.write_type(xml, "baseType", element)
                })
            }
            TypeSpecificationKind::Union(_) => {
                let message = "the format has no UNION; leave the cases with one out";
                Err(io::Error::other(message))
            }
            // The parser has reported an error of which nothing is written.
            TypeSpecificationKind::Error => Ok(()),
            TypeSpecificationKind::Text { name, length } => {
                let length = attribute("length", self.expression(*length));
                empty(xml, &name.text.to_ascii_lowercase(), [length])
            }
            TypeSpecificationKind::Subrange { base, limits } => {
                let signed = ElementaryType::from_name(base.text).is_none_or(ElementaryType::is_signed);
                let name = if signed {
                    "subrangeSigned"
                } else {
                    "subrangeUnsigned"
                };
                nested(xml, name, [], |xml| {
                    self.write_limits(xml, "range", *limits)?;
                    nested(xml, "baseType", [], |xml| write_named(xml, base.text))
                })
            }
            TypeSpecificationKind::Array { dimensions, element } => nested(xml, "array", [], |xml| {
                for limits in dimensions {
                    self.write_limits(xml, "dimension", *limits)?;
                }
                self.write_type(xml, "baseType", element)
            }),
            TypeSpecificationKind::Enumeration { base, values } => nested(xml, "enum", [], |xml| {
                nested(xml, "values", [], |xml| {
                    values.iter().try_for_each(|(name, value)| {
                        let value = value.map(|value| attribute("value", self.expression(value)));
                        let attributes = [attribute("name", name.text)].into_iter().chain(value);
                        empty(xml, "value", attributes)
                    })
                })?;
                base.as_ref().map_or(Ok(()), |base| {
                    nested(xml, "baseType", [], |xml| write_named(xml, base.text))
                })
            }),
            TypeSpecificationKind::Structure(fields) => {
                nested(xml, "struct", [], |xml| self.write_groups(xml, fields))
            }
        }
    }

    fn write_limits(
        &self,
        xml: &mut Xml,
        name: &str,
        limits: (ExpressionId, ExpressionId),
    ) -> io::Result<()> {
        let lower = attribute("lower", self.expression(limits.0));
        empty(xml, name, [lower, attribute("upper", self.expression(limits.1))])
    }

    pub(super) fn write_initial_value(
        &self,
        xml: &mut Xml,
        value: Option<&Initializer<'_>>,
    ) -> io::Result<()> {
        value.map_or(Ok(()), |value| {
            nested(xml, "initialValue", [], |xml| self.write_value(xml, value))
        })
    }

    fn write_value(&self, xml: &mut Xml, value: &Initializer<'_>) -> io::Result<()> {
        match &value.kind {
            InitializerKind::Expression(expression) => empty(
                xml,
                "simpleValue",
                [attribute("value", self.expression(*expression))],
            ),
            InitializerKind::Array(elements) => nested(xml, "arrayValue", [], |xml| {
                elements
                    .iter()
                    .try_for_each(|element| self.write_element(xml, element))
            }),
            InitializerKind::Structure(fields) => nested(xml, "structValue", [], |xml| {
                fields.iter().try_for_each(|(name, value)| {
                    let member = attribute("member", name.text);
                    nested(xml, "value", [member], |xml| self.write_value(xml, value))
                })
            }),
        }
    }

    fn write_element(&self, xml: &mut Xml, element: &ArrayElement<'_>) -> io::Result<()> {
        let repetition = element
            .repetition
            .map(|times| attribute("repetitionValue", self.expression(times)));
        nested(xml, "value", repetition, |xml| match &*element.values {
            [] => empty(xml, "simpleValue", []),
            [value] => self.write_value(xml, value),
            values => nested(xml, "arrayValue", [], |xml| {
                values
                    .iter()
                    .try_for_each(|value| nested(xml, "value", [], |xml| self.write_value(xml, value)))
            }),
        })
    }

    fn expression(&self, expression: ExpressionId) -> &str {
        self.unit.expressions[expression.0 as usize].span.text(self.text)
    }
}

/// Writes a type by its name: elementary types that the format knows have elements of their own.
fn write_named(xml: &mut Xml, name: &str) -> io::Result<()> {
    match ElementaryType::from_name(name).and_then(element_of) {
        Some(element) => empty(xml, element, []),
        None => empty(xml, "derived", [attribute("name", name)]),
    }
}

/// Returns the element of an elementary type; `None` for types that are newer than the format.
fn element_of(ty: ElementaryType) -> Option<&'static str> {
    match ty {
        ElementaryType::String => Some("string"),
        ElementaryType::Wstring => Some("wstring"),
        ElementaryType::Ltime
        | ElementaryType::Ldate
        | ElementaryType::Ltod
        | ElementaryType::Ldt
        | ElementaryType::Char
        | ElementaryType::Wchar => None,
        other => Some(other.name()),
    }
}
