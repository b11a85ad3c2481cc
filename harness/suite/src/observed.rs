//! The variables that an engine has to give back: each once, with one type.

use std::sync::Arc;

use rustc_hash::FxHashMap;

use crate::assembly::type_name;
use crate::model::ExpectedValue;
use stickler_types::Observation;

/// Returns the variables of the asserted values and those that are only recorded.
///
/// # Errors
/// A message, if a value is asserted twice or a variable has two types.
pub(crate) fn all(values: &[ExpectedValue], recorded: Vec<Observation>) -> Result<Vec<Observation>, String> {
    let mut directory = Directory {
        list: Vec::with_capacity(values.len() + recorded.len()),
        index: FxHashMap::default(),
    };
    for value in values {
        let observed = Observation {
            name: Arc::clone(&value.name),
            type_name: type_name(&value.value),
            after: value.after,
        };
        if directory.find_or_add(observed).is_some() {
            return Err(format!("the value of `{}` is asserted twice", value.name));
        }
    }
    for observe in recorded {
        let (name, ty) = (Arc::clone(&observe.name), Arc::clone(&observe.type_name));
        if let Some(known) = directory.find_or_add(observe)
            && !known.eq_ignore_ascii_case(&ty)
        {
            return Err(format!("`{name}` is observed as {ty} and as {known}"));
        }
    }
    Ok(directory.list)
}

/// Variables in order, each once.
struct Directory {
    list: Vec<Observation>,
    /// The place of each variable in the list, filled only for long lists: most cases observe one variable.
    index: FxHashMap<(Arc<str>, Option<u32>), usize>,
}

impl Directory {
    /// Returns the type of the variable if the list has it already; adds the variable otherwise.
    fn find_or_add(&mut self, observe: Observation) -> Option<Arc<str>> {
        const FEW: usize = 8;
        let found = match self.list.len() {
            0..FEW => self
                .list
                .iter()
                .position(|known| known.name == observe.name && known.after == observe.after),
            _ => self.look_up(&observe),
        };
        match found {
            Some(at) => Some(Arc::clone(&self.list[at].type_name)),
            None => {
                self.list.push(observe);
                None
            }
        }
    }

    fn look_up(&mut self, observe: &Observation) -> Option<usize> {
        for (at, known) in self.list.iter().enumerate().skip(self.index.len()) {
            self.index.insert((Arc::clone(&known.name), known.after), at);
        }
        self.index
            .get(&(Arc::clone(&observe.name), observe.after))
            .copied()
    }
}
