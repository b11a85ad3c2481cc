//! Name and type checking; lowers the syntax tree to a program for the stack machine.
//!
//! `declare` collects what a text declares into a `model`: types, program organization units, variables, and
//! where they lie. `lowering` then reads that model only, infers the type of each expression, decides in
//! `contexts` whether it may stand where it does, and emits code.
//!
//! Architecture Invariant: nothing here knows how values are computed; it asks `conversion` which types convert,
//! and gives the machine instructions.

mod address_layouts;
mod arguments;
mod calls;
mod chains;
mod check;
mod common;
mod configured;
mod constant;
mod constants;
mod contexts;
mod conversions;
mod cycles;
mod declare;
mod derived;
mod direct;
mod emitter;
mod enumeration;
mod execution_control;
mod expressions;
mod globals;
mod infer;
mod inferred;
mod initializers;
mod invocations;
mod layout;
mod limits;
mod literals;
mod locations;
mod loops;
mod lost_values;
mod lowering;
mod memory;
mod methods;
mod model;
mod named_constants;
mod objects;
mod observation;
mod operator_calls;
mod operators;
mod order;
mod overrides;
mod parameters;
mod places;
mod pointer_types;
mod pointers;
mod promotion;
mod routines;
mod scope;
mod selection;
mod similarity;
mod specification;
mod standard;
mod standard_signatures;
mod statements;
mod suggestion;
mod trace;
mod types;
mod variables;

pub use calls::is_standard_function;
pub use check::{check, check_traced};
pub use observation::{CheckedProgram, ObservedType, ObservedVariable};
pub use standard_signatures::place_of_input;
pub(crate) use standard_signatures::unary_function;
pub use trace::{TracedUse, UseKind};
