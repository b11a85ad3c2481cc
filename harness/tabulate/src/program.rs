//! The programs of the tables: templates in which the columns are placeholders.

/// `<SRC>_TO_<DST>` of a variable.
pub const PAIR_OF_VARIABLE: &str = "\
PROGRAM main
VAR
    data : {from} := {input};
    into : {to};
END_VAR
    into := {from}_TO_{to}(data);
END_PROGRAM
";

/// `<SRC>_TO_<DST>` of a literal, because folding a constant must not change the value.
pub const PAIR_OF_CONSTANT: &str = "\
PROGRAM main
VAR
    into : {to};
END_VAR
    into := {from}_TO_{to}({typed});
END_PROGRAM
";

/// The same where the column `input` is a typed literal already.
pub const PAIR_OF_TYPED_INPUT: &str = "\
PROGRAM main
VAR
    into : {to};
END_VAR
    into := {from}_TO_{to}({input});
END_PROGRAM
";

/// The function that the row names, of a variable.
pub const FUNCTION_OF_VARIABLE: &str = "\
PROGRAM main
VAR
    data : {from} := {input};
    into : {to};
END_VAR
    into := {function}(data);
END_PROGRAM
";

/// The function that the row names, of a literal.
pub const FUNCTION_OF_CONSTANT: &str = "\
PROGRAM main
VAR
    into : {to};
END_VAR
    into := {function}({typed});
END_PROGRAM
";

/// A function of two variables.
pub const CONCATENATION: &str = "\
PROGRAM main
VAR
    day  : {from} := {input};
    hour : {with} := {second};
    into : {to};
END_VAR
    into := {function}(day, hour);
END_PROGRAM
";
