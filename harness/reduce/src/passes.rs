//! The passes over texts.

pub(crate) mod arrays;
pub(crate) mod chunks;
pub(crate) mod declarations;
pub(crate) mod expressions;
pub(crate) mod initial_values;
pub(crate) mod literals;
pub(crate) mod parameters;
pub(crate) mod statements;
