//! Every input of a conversion function, held against exact arithmetic.
