//! The program that writes the row tables of the conformance suite whose values are computed.
