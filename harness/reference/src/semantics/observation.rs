//! Finds the variable that a path names: `a[1]`, `rec.field[2].x`, `instance.name`; and lists the elementary values of a program by
//! their paths.

use super::address_layouts::AddressLayouts;
use super::model::{Model, Storage};
use super::scope::NamedList;
use super::types::{ArrayShape, Structure, TypeId, TypeKind, TypeMember, TypeTable};
use crate::addresses::AddressMap;
use crate::instruction::MachineProgram;
use crate::library::has_block;
use stickler_syntax::tree::VariableKind;
use stickler_types::{ElementaryType, MomentUnits, join};

/// A program that can run, and where its variables lie.
#[derive(Debug)]
pub struct CheckedProgram {
    /// The program.
    pub program: MachineProgram,
    pub(super) directory: VariableTable,
}

/// A variable that can be observed.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ObservedVariable {
    /// The cell.
    pub address: u32,
    /// The type.
    pub ty: ObservedType,
    /// The number of cells that hold a byte each, of a field of a union; `None` for all other variables.
    pub bytes: Option<u32>,
}

/// The type of a variable that can be observed.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum ObservedType {
    /// An elementary type that is no text; a subrange counts as its base type.
    Plain(ElementaryType),
    /// STRING or WSTRING.
    Text(ElementaryType),
    /// An enumeration.
    Enumerated {
        /// The name.
        type_name: String,
        /// The raw forms of its values, and their names.
        values: Vec<(i64, String)>,
    },
}

/// The addresses of the variables of a checked program.
#[derive(Debug)]
pub(super) struct VariableTable {
    pub(super) types: TypeTable,
    globals: NamedList<TypeMember>,
    moment_units: MomentUnits,
    /// The program instances: name, type, and address.
    pub(super) instances: Vec<(Box<str>, TypeId, u32)>,
}

impl VariableTable {
    /// Takes the addresses out of a model, whose source text may then go.
    pub(super) fn new(model: Model<'_>) -> VariableTable {
        let mut globals = NamedList::new();
        for variable in model
            .variables
            .iter()
            .filter(|variable| variable.kind == VariableKind::Global)
        {
            if let Storage::Absolute(offset) = variable.storage {
                let kind = VariableKind::Global;
                globals.push(
                    variable.name.text,
                    TypeMember {
                        ty: variable.ty,
                        offset,
                        kind,
                        constant: false,
                        is_public: true,
                    },
                );
            }
        }
        let instances = model.instances.iter();
        let mut instances: Vec<_> = instances
            .map(|instance| {
                (
                    instance.name.into(),
                    model.pous[instance.pou as usize].ty,
                    instance.base,
                )
            })
            .collect();
        // Plain names are those of PROGRAM main, wherever in the configuration it runs.
        instances.sort_by_cached_key(|(_, ty, _)| !model.types.name(*ty).eq_ignore_ascii_case("main"));
        VariableTable {
            moment_units: model.source.dialect.conversions.moment_units,
            types: model.types,
            globals,
            instances,
        }
    }

    /// The variable that the first names of a path mean, and what is left of the path.
    fn root<'p>(&self, path: &'p str) -> Result<(TypeId, u32, &'p str), String> {
        let (name, rest) = name(path)?;
        if let Some((_, ty, base)) = self.instances.first()
            && let Some(found) = self.member(*ty, *base, name)
        {
            return Ok((found.0, found.1, rest));
        }
        let called = |(instance, ..): &&(Box<str>, TypeId, u32)| instance.eq_ignore_ascii_case(name);
        let runs = |(_, ty, _): &&(Box<str>, TypeId, u32)| self.types.name(*ty).eq_ignore_ascii_case(name);
        let instance = self
            .instances
            .iter()
            .find(called)
            .or_else(|| self.instances.iter().find(runs));
        if let Some((instance, ty, base)) = instance {
            let Some(rest) = rest.trim_start().strip_prefix('.') else {
                return Err(format!(
                    "`{instance}` is a program; write `{instance}.` and a variable"
                ));
            };
            let (name, rest) = super::observation::name(rest)?;
            return match self.member(*ty, *base, name) {
                Some((ty, address)) => Ok((ty, address, rest)),
                None => Err(format!("`{instance}` has no variable `{name}`")),
            };
        }
        match self.globals.find(name) {
            Some(global) => Ok((global.ty, global.offset, rest)),
            None => Err(format!("there is no variable `{name}`")),
        }
    }

    fn member(&self, ty: TypeId, base: u32, name: &str) -> Option<(TypeId, u32)> {
        let member = self.types.member(ty, name);
        let member = member.filter(|member| member.kind != VariableKind::InOut)?;
        Some((member.ty, base + member.offset))
    }

    fn element<'p>(
        &self,
        ty: TypeId,
        base: u32,
        subscripts: &'p str,
    ) -> Result<(TypeId, u32, &'p str), String> {
        let TypeKind::Array(shape) = self.types.kind(ty) else {
            return Err(format!("{} has no elements", self.types.name(ty)));
        };
        let (inside, rest) = subscripts.split_once(']').ok_or("`]` is missing")?;
        let mut address = base;
        let mut numbers = inside.split(',');
        for dimension in &shape.dimensions {
            let number = numbers.next().ok_or("there are too few subscripts")?.trim();
            let number: i64 = number
                .parse()
                .map_err(|_| format!("`{number}` is no subscript"))?;
            if !(dimension.low..=dimension.high).contains(&number) {
                return Err(format!(
                    "subscript {number} is outside {}..{}",
                    dimension.low, dimension.high
                ));
            }
            // Both differences are below the limit of memory.
            address += u32::try_from(number.abs_diff(dimension.low)).unwrap_or(0) * dimension.stride;
        }
        match numbers.next() {
            Some(_) => Err("there are too many subscripts".to_owned()),
            None => Ok((shape.element, address, rest)),
        }
    }

    fn observed(&self, ty: TypeId, address: u32) -> Result<ObservedVariable, String> {
        let ty = match self.types.kind(ty) {
            TypeKind::Elementary(ty) => ObservedType::Plain(*ty),
            TypeKind::Subrange(subrange) => ObservedType::Plain(subrange.base),
            TypeKind::Text { ty, .. } => ObservedType::Text(*ty),
            TypeKind::Enumeration(enumeration) => ObservedType::Enumerated {
                type_name: enumeration.name.to_string(),
                values: enumeration
                    .values
                    .iter()
                    .map(|(name, &number)| (number, name.to_owned()))
                    .collect(),
            },
            _ => return Err(format!("{} is no elementary type", self.types.name(ty))),
        };
        let bytes = None;
        Ok(ObservedVariable { address, ty, bytes })
    }

    /// Returns the cell of the byte at which the part begins that would lie at an offset in cells, in a field of a union whose first
    /// byte lies in a cell; and the number of bytes of a type.
    fn byte(&self, (field, first): (TypeId, u32), cells: u32, ty: TypeId) -> (u32, u32) {
        let mut layouts = AddressLayouts::default();
        let field = layouts.layout(&self.types, self.moment_units, field);
        let (size, _) = layouts.size(&self.types, self.moment_units, ty);
        let (layouts, objects) = (layouts.layouts, Vec::new());
        (
            first + AddressMap { layouts, objects }.offset_in_bytes(field, cells),
            size,
        )
    }
}

impl CheckedProgram {
    /// The global variable of a name; `None` where there is none of an elementary type.
    pub(crate) fn global(&self, name: &str) -> Option<ObservedVariable> {
        let global = self.directory.globals.find(name)?;
        self.directory.observed(global.ty, global.offset).ok()
    }

    /// The variable of a path: names with `.field` and `[subscripts]` behind them, in any case.
    ///
    /// The first name is a variable of the program called `main` (or else of the one that runs first), or a
    /// program instance or its program with one of its variables behind it, or a global variable.
    ///
    /// # Errors
    /// A message where nothing has that name, or what has it is of no elementary type.
    ///
    /// Basis: harness/engines/README.md (an observed name may be a path to an elementary value).
    pub fn resolve(&self, path: &str) -> Result<ObservedVariable, String> {
        let directory = &self.directory;
        let (mut ty, mut address, mut rest) = directory.root(path)?;
        // The innermost field of a union, and the cell of its first byte; the address is then an offset in that field.
        let mut overlaid = None;
        loop {
            rest = rest.trim_start();
            if directory.types.is_union(ty) {
                let first = overlaid.map_or(address, |field| directory.byte(field, address, ty).0);
                (overlaid, address) = (Some((ty, first)), 0);
            }
            if let Some(behind) = rest.strip_prefix('.') {
                let (field, behind) = name(behind)?;
                let of = ty;
                (ty, address) = directory
                    .member(of, address, field)
                    .ok_or_else(|| format!("{} has no element `{field}`", directory.types.name(of)))?;
                if let (Some(field), true) = (&mut overlaid, directory.types.is_union(of)) {
                    field.0 = ty;
                }
                rest = behind;
            } else if let Some(behind) = rest.strip_prefix('[') {
                (ty, address, rest) = directory.element(ty, address, behind)?;
            } else if rest.is_empty() {
                let observed = directory.observed(ty, address)?;
                let Some(field) = overlaid else {
                    return Ok(observed);
                };
                let (address, size) = directory.byte(field, address, ty);
                let (ty, bytes) = (observed.ty, Some(size));
                return Ok(ObservedVariable { address, ty, bytes });
            } else {
                return Err(format!("`{rest}` is not understood"));
            }
        }
    }
}

/// The identifier at the start of a path, and what is behind it.
fn name(path: &str) -> Result<(&str, &str), String> {
    let path = path.trim_start();
    let end = path
        .find(|c: char| !(c.is_alphanumeric() || c == '_'))
        .unwrap_or(path.len());
    if end == 0 {
        Err(format!("a name is missing before `{path}`"))
    } else {
        Ok(path.split_at(end))
    }
}

impl CheckedProgram {
    /// The paths of all elementary values of the program that runs first (PROGRAM main), in the order of their
    /// declarations, arrays element by element, structures and function blocks field by field; at most `most`.
    ///
    /// Each of them is one that [`CheckedProgram::resolve`] takes.
    pub fn variables(&self, most: usize) -> Vec<String> {
        let directory = &self.directory;
        let mut listing = PathListing {
            types: &directory.types,
            most,
            paths: Vec::new(),
        };
        if let Some((_, ty, _)) = directory.instances.first() {
            listing.value(*ty, String::new());
        }
        listing.paths
    }
}

struct PathListing<'t> {
    types: &'t TypeTable,
    most: usize,
    paths: Vec<String>,
}

impl PathListing<'_> {
    /// Types are declared before they are used, so a value is only as deep as the text is long; the checker bounds
    /// how deep that may be.
    fn value(&mut self, ty: TypeId, path: String) {
        if self.paths.len() >= self.most {
            return;
        }
        match self.types.kind(ty) {
            TypeKind::Elementary(_)
            | TypeKind::Subrange(_)
            | TypeKind::Text { .. }
            | TypeKind::Enumeration(_) => {
                self.paths.push(path);
            }
            TypeKind::Array(shape) => self.elements(shape, &path),
            TypeKind::Structure(structure) | TypeKind::FunctionBlock(structure) => {
                self.members(structure, &path)
            }
            TypeKind::Pointer(_) | TypeKind::Alias | TypeKind::Interface(_) | TypeKind::Error => {}
        }
    }

    fn members(&mut self, structure: &Structure, path: &str) {
        if let Some(base) = structure.base.and_then(|base| self.types.structure(base)) {
            self.members(base, path);
        }
        let is_standard = has_block(&structure.name);
        for (name, member) in structure.members.iter() {
            let is_own = is_standard && member.kind == VariableKind::Local;
            if !is_own && !matches!(member.kind, VariableKind::InOut | VariableKind::Instance) {
                let dot = if path.is_empty() { "" } else { "." };
                self.value(member.ty, format!("{path}{dot}{name}"));
            }
        }
    }

    fn elements(&mut self, shape: &ArrayShape, path: &str) {
        let mut subscripts: Vec<i64> = shape.dimensions.iter().map(|dimension| dimension.low).collect();
        for _ in 0..shape.length {
            if self.paths.len() >= self.most {
                return;
            }
            self.value(shape.element, format!("{path}[{}]", join(&subscripts, ",")));
            for (subscript, dimension) in subscripts.iter_mut().zip(&shape.dimensions).rev() {
                if *subscript < dimension.high {
                    *subscript += 1;
                    break;
                }
                *subscript = dimension.low;
            }
        }
    }
}
