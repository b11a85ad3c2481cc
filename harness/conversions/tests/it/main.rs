//! Tests of sweeps by the crate's public interface: inputs, findings and cancellation.

mod broken;
mod catalogue;
mod domains;
mod foreign;
mod session;
mod stopping;
mod support;
