//! The reference implementation of Structured Text that Stickler judges its own cases with.
