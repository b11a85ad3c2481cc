//! What every type conversion function must give, by exact arithmetic.
