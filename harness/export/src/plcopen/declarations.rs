//! Writes sections of variables, types and initial values.

use super::PageSource;
use super::xml::{Xml, attribute};
use std::io;
use stickler_reference::syntax::tree::{
    ArrayElement, ExpressionId, Initializer, InitializerKind, TypeSpecification, TypeSpecificationKind,
    VariableBlock, VariableGroup, VariableKind,
};
use stickler_types::ElementaryType;

impl PageSource<'_> {
    pub(super) fn write_block(&self, xml: &mut Xml, block: &VariableBlock<'_>) -> io::Result<()> {
        let name = match block.kind {
            VariableKind::Local => "localVars",
            VariableKind::Temporary => "tempVars",
            VariableKind::Input => "inputVars",
            VariableKind::Output => "outputVars",
            VariableKind::InOut => "inOutVars",
            VariableKind::External => "externalVars",
            VariableKind::Global => "globalVars",
        };
        let retention = block.retention.map(str::to_ascii_uppercase);
        let kept = match retention.as_deref() {
            Some("RETAIN") => Some(("retain", "true")),
            Some("NON_RETAIN") => Some(("nonretain", "true")),
            _ => None,
        };
        let constant = block.constant.then_some(("constant", "true"));
        let element = xml
            .create_element(name)
            .with_attributes(constant.into_iter().chain(kept));
        element.write_inner_content(|xml| self.write_groups(xml, &block.groups))?;
        Ok(())
    }

    fn write_groups(&self, xml: &mut Xml, groups: &[VariableGroup<'_>]) -> io::Result<()> {
        for group in groups {
            for name in &group.names {
                let location = group.location.map(|location| attribute("address", location.text));
                let attributes = [attribute("name", name.text)].into_iter().chain(location);
                let element = xml.create_element("variable").with_attributes(attributes);
                element.write_inner_content(|xml| {
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
        xml.create_element(element)
            .write_inner_content(|xml| self.write_specification(xml, ty))?;
        Ok(())
    }

    fn write_specification(&self, xml: &mut Xml, ty: &TypeSpecification<'_>) -> io::Result<()> {
        match &ty.kind {
            TypeSpecificationKind::Named(name) => write_named(xml, name.text),
            // The parser has reported an error of which nothing is written.
            TypeSpecificationKind::Error => Ok(()),
            TypeSpecificationKind::Text { name, length } => {
                let element = xml.create_element(name.text.to_ascii_lowercase());
                element
                    .with_attribute(attribute("length", self.expression(*length)))
                    .write_empty()?;
                Ok(())
            }
            TypeSpecificationKind::Subrange { base, limits } => {
                let signed = ElementaryType::from_name(base.text).is_none_or(ElementaryType::is_signed);
                let name = if signed {
                    "subrangeSigned"
                } else {
                    "subrangeUnsigned"
                };
                xml.create_element(name).write_inner_content(|xml| {
                    self.write_limits(xml, "range", *limits)?;
                    xml.create_element("baseType")
                        .write_inner_content(|xml| write_named(xml, base.text))?;
                    Ok(())
                })?;
                Ok(())
            }
            TypeSpecificationKind::Array { dimensions, element } => {
                xml.create_element("array").write_inner_content(|xml| {
                    for limits in dimensions {
                        self.write_limits(xml, "dimension", *limits)?;
                    }
                    self.write_type(xml, "baseType", element)
                })?;
                Ok(())
            }
            TypeSpecificationKind::Enumeration { base, values } => {
                xml.create_element("enum").write_inner_content(|xml| {
                    xml.create_element("values").write_inner_content(|xml| {
                        for (name, value) in values {
                            let value = value.map(|value| attribute("value", self.expression(value)));
                            let attributes = [attribute("name", name.text)].into_iter().chain(value);
                            xml.create_element("value")
                                .with_attributes(attributes)
                                .write_empty()?;
                        }
                        Ok(())
                    })?;
                    if let Some(base) = base {
                        xml.create_element("baseType")
                            .write_inner_content(|xml| write_named(xml, base.text))?;
                    }
                    Ok(())
                })?;
                Ok(())
            }
            TypeSpecificationKind::Structure(fields) => {
                xml.create_element("struct")
                    .write_inner_content(|xml| self.write_groups(xml, fields))?;
                Ok(())
            }
        }
    }

    fn write_limits(
        &self,
        xml: &mut Xml,
        name: &str,
        limits: (ExpressionId, ExpressionId),
    ) -> io::Result<()> {
        let attributes = [
            attribute("lower", self.expression(limits.0)),
            attribute("upper", self.expression(limits.1)),
        ];
        xml.create_element(name)
            .with_attributes(attributes)
            .write_empty()?;
        Ok(())
    }

    pub(super) fn write_initial_value(
        &self,
        xml: &mut Xml,
        value: Option<&Initializer<'_>>,
    ) -> io::Result<()> {
        if let Some(value) = value {
            xml.create_element("initialValue")
                .write_inner_content(|xml| self.write_value(xml, value))?;
        }
        Ok(())
    }

    fn write_value(&self, xml: &mut Xml, value: &Initializer<'_>) -> io::Result<()> {
        match &value.kind {
            InitializerKind::Expression(expression) => {
                let value = attribute("value", self.expression(*expression));
                xml.create_element("simpleValue")
                    .with_attribute(value)
                    .write_empty()?;
            }
            InitializerKind::Array(elements) => {
                xml.create_element("arrayValue").write_inner_content(|xml| {
                    elements
                        .iter()
                        .try_for_each(|element| self.write_element(xml, element))
                })?;
            }
            InitializerKind::Structure(fields) => {
                xml.create_element("structValue").write_inner_content(|xml| {
                    for (name, value) in fields {
                        let element = xml.create_element("value");
                        let element = element.with_attribute(attribute("member", name.text));
                        element.write_inner_content(|xml| self.write_value(xml, value))?;
                    }
                    Ok(())
                })?;
            }
        }
        Ok(())
    }

    fn write_element(&self, xml: &mut Xml, element: &ArrayElement<'_>) -> io::Result<()> {
        let repetition = element
            .repetition
            .map(|times| attribute("repetitionValue", self.expression(times)));
        let written = xml.create_element("value").with_attributes(repetition);
        written.write_inner_content(|xml| match &element.value {
            Some(value) => self.write_value(xml, value),
            None => xml.create_element("simpleValue").write_empty().map(drop),
        })?;
        Ok(())
    }

    fn expression(&self, expression: ExpressionId) -> &str {
        self.unit.expressions[expression.0 as usize].span.text(self.text)
    }
}

/// Writes a type by its name: elementary types that the format knows have elements of their own.
fn write_named(xml: &mut Xml, name: &str) -> io::Result<()> {
    match ElementaryType::from_name(name).and_then(element_of) {
        Some(element) => xml.create_element(element).write_empty()?,
        None => xml
            .create_element("derived")
            .with_attribute(attribute("name", name))
            .write_empty()?,
    };
    Ok(())
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
