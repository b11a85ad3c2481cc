//! The rows and columns of a matrix as types: their values and their declarations.

use std::collections::BTreeMap;
use std::sync::Arc;

use stickler_types::{ElementaryType, Value, WrittenValue, boundaries};

use crate::error::Mistake;
use crate::frame::FileContext;
use crate::mark::MarkWord;
use crate::table::keys::TypeKey;

/// The type after which a row or a column is named.
#[derive(Clone, Debug, Default)]
pub(crate) struct TypeInfo {
    pub(crate) name: Arc<str>,
    /// The elementary type that the type is or derives from.
    pub(crate) base: Option<ElementaryType>,
    /// The declaration that a program needs; empty for an elementary type.
    pub(crate) declaration: Box<str>,
    /// All boundary values of the type.
    pub(crate) boundaries: Vec<RowInput>,
    /// One ordinary value of the type.
    pub(crate) ordinary: Option<RowInput>,
    /// One value of the type that shows a wrong conversion.
    pub(crate) telling: Option<RowInput>,
}

/// A value of a row's type, as a program writes it.
#[derive(Clone, Debug)]
pub(crate) struct RowInput {
    /// The text that replaces `{value}`.
    pub(crate) literal: Box<str>,
    /// The text that replaces `{typed}`.
    pub(crate) typed: Box<str>,
    /// The value, if it can be observed.
    pub(crate) value: Option<Value>,
    /// The paths below the observed variable and the values that they must have, where the variable itself has no
    /// observable value.
    pub(crate) arrives: Arc<[(Box<str>, Value)]>,
}

impl RowInput {
    fn of(value: WrittenValue) -> RowInput {
        let typed = value.value.to_string().into();
        RowInput {
            literal: value.literal,
            typed,
            value: Some(value.value),
            arrives: Arc::default(),
        }
    }
}

impl TypeInfo {
    /// Finds the type of a name: an elementary type, a text with a length, or a type that the file declares.
    pub(crate) fn find(name: &Arc<str>, declared: &BTreeMap<Box<str>, TypeInfo>) -> Result<TypeInfo, String> {
        if let Some(declared) = declared.get(&**name) {
            return Ok(declared.clone());
        }
        match ElementaryType::declared(name) {
            Some(ty) => Ok(TypeInfo::elementary(name, ty)),
            None => Err(format!(
                "`{name}` is no elementary type, and the file has no [types.{name}]"
            )),
        }
    }

    fn elementary(name: &Arc<str>, ty: ElementaryType) -> TypeInfo {
        TypeInfo {
            name: Arc::clone(name),
            base: Some(ty),
            declaration: Box::default(),
            boundaries: boundaries::boundaries(ty).into_iter().map(RowInput::of).collect(),
            ordinary: boundaries::ordinary(ty).map(RowInput::of),
            telling: boundaries::telling(ty).map(RowInput::of),
        }
    }

    /// Returns the value of the type that `literal` spells.
    pub(crate) fn input(&self, literal: &str) -> Option<RowInput> {
        match self.base {
            Some(ty) => WrittenValue::parse(ty, literal).ok().map(RowInput::of),
            None => Some(self.enumerated(literal, Arc::default())),
        }
    }

    /// Returns a value of a type that is not elementary: of an enumeration, or one that cannot be observed.
    fn enumerated(&self, literal: &str, arrives: Arc<[(Box<str>, Value)]>) -> RowInput {
        let typed = format!("{}#{literal}", self.name);
        let value = Value::parse(&typed).ok().filter(|_| arrives.is_empty());
        let typed = if value.is_some() {
            typed.into()
        } else {
            literal.into()
        };
        RowInput {
            literal: literal.into(),
            typed,
            value,
            arrives,
        }
    }

    /// Returns a literal of the type that differs from `value`: the initial value of the observed variable.
    pub(crate) fn other(&self, value: Option<&Value>) -> Option<Box<str>> {
        match self.base {
            Some(ty) => boundaries::other_than(ty, value).map(|other| other.literal),
            None => {
                let differs = |input: &&RowInput| value.is_none() || input.value.as_ref() != value;
                let other = self.boundaries.iter().rfind(differs);
                other.map(|other| other.literal.clone())
            }
        }
    }
}

/// Reads the types that the file declares.
pub(crate) fn declared(
    keys: &BTreeMap<String, TypeKey>,
    context: &FileContext<'_>,
    mistakes: &mut Vec<Mistake>,
) -> BTreeMap<Box<str>, TypeInfo> {
    let read =
        |(name, key): (&String, &TypeKey)| (name.as_str().into(), declare(name, key, context, mistakes));
    keys.iter().map(read).collect()
}

fn declare(name: &str, key: &TypeKey, context: &FileContext<'_>, mistakes: &mut Vec<Mistake>) -> TypeInfo {
    let path = format!("types.{name}");
    let base = key.base.as_ref().and_then(|base| {
        let ty = ElementaryType::from_name(base.get_ref());
        if ty.is_none() {
            let message = format!("`{}` is no elementary type", base.get_ref());
            mistakes.push(context.lines.mistake(base, &path, message));
        }
        ty
    });
    let mut arrives = Vec::new();
    for line in &key.arrives {
        match read_arrival(line.get_ref()) {
            Ok(found) => arrives.push(found),
            Err(message) => mistakes.push(context.lines.mistake(line, &path, message)),
        }
    }
    if !arrives.is_empty() && key.values.len() != 1 {
        let message = "`arrives` needs exactly one value";
        mistakes.push(context.lines.mistake(&key.declaration, &path, message));
    }
    let arrives: Arc<[(Box<str>, Value)]> = arrives.into();
    let mut info = match base {
        Some(ty) => TypeInfo::elementary(&name.into(), ty),
        None => TypeInfo {
            name: name.into(),
            ..TypeInfo::default()
        },
    };
    info.declaration = key.declaration.get_ref().trim().into();
    if !key.values.is_empty() {
        info.boundaries.clear();
    }
    for value in &key.values {
        let literal = context.spelling(value);
        let input = match base {
            Some(_) => info.input(&literal),
            None => Some(info.enumerated(&literal, Arc::clone(&arrives))),
        };
        match input {
            Some(input) => info.boundaries.push(input),
            None => {
                let message = format!("`{literal}` is no literal of the base type");
                mistakes.push(context.lines.mistake(value, &path, message));
            }
        }
    }
    if !key.values.is_empty() {
        info.ordinary = info.boundaries.first().cloned();
        info.telling.clone_from(&info.ordinary);
    }
    info
}

/// Parses a line such as `.x = INT#5`.
fn read_arrival(line: &str) -> Result<(Box<str>, Value), String> {
    let (path, value) = line.split_once('=').ok_or("write `.path = literal`")?;
    let path = path.trim();
    if !path.starts_with(['.', '[']) {
        return Err(format!(
            "`{path}` is no path below a variable; write `.x` or `[1]`"
        ));
    }
    Ok((path.into(), Value::read(value.trim())?))
}
