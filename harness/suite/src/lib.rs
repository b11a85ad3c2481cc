//! The conformance case format: read, lint and expand case files.
