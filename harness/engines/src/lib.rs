//! The Engine trait, the reference as an engine, and the wire protocol.
