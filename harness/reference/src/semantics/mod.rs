//! Name and type checking; lowers the syntax tree to a program for the stack machine.
