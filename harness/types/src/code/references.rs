//! Codes of references (`REF_TO`), which the dialects of the reference do not have.

macro_rules! reference_codes {
    ($rest:tt $($entries:tt)*) => { gather! { $rest $($entries)*
        P2028 RefOperandNotVariable {
            summary: "the operand of `REF` is no variable",
            explanation: "A reference leads to a place where a value is held; a literal or the result of an expression has none. \
                Stickler's reference has no references: it answers P9999.",
            example: elsewhere "
                PROGRAM main
                VAR
                    r : REF_TO INT;
                END_VAR
                    r := REF(42);
                END_PROGRAM
                ",
            fix: "Keep the value in a variable, and refer to that.",
        }
        P2029 RefOfEphemeralVariable {
            summary: "the reference would outlive its variable",
            explanation: "The variables of a function, and VAR_TEMP anywhere, are gone when the call ends; a reference to one of them \
                would then lead nowhere. Stickler's reference has no references: it answers P9999.",
            example: elsewhere "
                FUNCTION_BLOCK Keeper
                VAR
                    r : REF_TO INT;
                END_VAR
                VAR_TEMP
                    brief : INT;
                END_VAR
                    r := REF(brief);
                END_FUNCTION_BLOCK
                PROGRAM main
                VAR
                    keeper_1 : Keeper;
                END_VAR
                    keeper_1();
                END_PROGRAM
                ",
            fix: "Refer to a variable that lasts, such as one of a function block's instance.",
        }
        P2030 RefOfArrayElement {
            summary: "a reference to an element of an array is not supported",
            explanation: "Some compilers let references lead to whole variables only. Stickler's reference has no references: it \
                answers P9999.",
            example: elsewhere "
                PROGRAM main
                VAR
                    samples : ARRAY [1..10] OF INT;
                    r : REF_TO INT;
                END_VAR
                    r := REF(samples[3]);
                END_PROGRAM
                ",
            fix: "Keep the subscript instead of a reference.",
        }
        P2031 DerefRequiresReferenceType {
            summary: "only a reference can be followed with `^`",
            explanation: "The operator `^` gives what a reference leads to; its operand holds a value and leads nowhere. Stickler's \
                reference has no references: it answers P9999.",
            example: elsewhere "
                PROGRAM main
                VAR
                    a : INT := 42;
                    b : INT;
                END_VAR
                    b := a^;
                END_PROGRAM
                ",
            fix: "Use the variable without `^`, or declare it as `REF_TO`.",
        }
        P2032 ReferenceTypeMismatch {
            summary: "the reference leads to another type",
            explanation: "A reference can be written through, so it must lead to exactly the type that it was declared for; nothing \
                is converted. Stickler's reference has no references: it answers P9999.",
            example: elsewhere "
                PROGRAM main
                VAR
                    a : INT;
                    r : REF_TO REAL;
                END_VAR
                    r := REF(a);
                END_PROGRAM
                ",
            fix: "Declare the reference for the type of the variable.",
        }
        P2033 ArithmeticOnReference {
            summary: "nobody can calculate with references",
            explanation: "References are compared and followed; unlike the pointers of other languages they know no sums and \
                differences. Stickler's reference has no references: it answers P9999.",
            example: elsewhere "
                PROGRAM main
                VAR
                    a : INT;
                    r : REF_TO INT := REF(a);
                END_VAR
                    r := r + 1;
                END_PROGRAM
                ",
            fix: "Follow the reference with `^` to calculate with the value, or keep a subscript in place of the reference.",
        }
        P2034 NullRequiresReferenceType {
            summary: "only a reference can be NULL",
            explanation: "`NULL` is the reference that leads nowhere, and no value of any other type. Stickler's reference has no \
                references, and takes `NULL` for a name like any other.",
            example: elsewhere "
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := NULL;
                END_PROGRAM
                ",
            fix: "Give the variable a value of its own type.",
        }
        P2035 OrderingOnReference {
            summary: "references have no order",
            explanation: "Two references are equal if they lead to the same variable; which of two variables comes first is not \
                defined. Stickler's reference has no references: it answers P9999.",
            example: elsewhere "
                PROGRAM main
                VAR
                    a : INT;
                    r : REF_TO INT := REF(a);
                    q : REF_TO INT := REF(a);
                    less : BOOL;
                END_VAR
                    less := r < q;
                END_PROGRAM
                ",
            fix: "Compare with `=` or `<>`, or compare the values behind the references.",
        }
        P2036 NestedRefToNotSupported {
            summary: "a reference to a reference is not supported",
            explanation: "Some compilers let a reference lead to values only. Stickler's reference has no references: it answers P9999.",
            example: elsewhere "
                TYPE
                    First : REF_TO INT;
                    Second : REF_TO First;
                END_TYPE
                PROGRAM main
                VAR
                    r : Second;
                END_VAR
                END_PROGRAM
                ",
            fix: "Put the inner reference into a structure, or do with one.",
        }
    } };
}
