//! Codes of initial values, arguments and results, and of bits that a type does not have.

macro_rules! argument_codes {
    ($rest:tt $($entries:tt)*) => { gather! { $rest $($entries)*
        P4022 InitializerTypeMismatch {
            summary: "the initial value's type does not fit the variable",
            explanation: "An initial value follows the same rule as an assigned one: it must be of the variable's type, or of one that \
                converts to it implicitly in the dialect. In an assignment the same fault is P4035.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    level : INT := 10.5;
                END_VAR
                END_PROGRAM
                ",
            fix: "Give a value of the variable's type, or call a type conversion function.",
            repaired: "
                PROGRAM main
                VAR
                    level : REAL := 10.5;
                END_VAR
                END_PROGRAM
                ",
        }
        P4023 FunctionCallNamedArgUndeclared {
            summary: "the function has no such parameter",
            explanation: "An argument is given by a name that none of the parameters has. Stickler's reference says so of the inputs of \
                function blocks too, for which other compilers have P4002.",
            example: IronplcEd2 "
                FUNCTION Double : INT
                VAR_INPUT
                    value : INT;
                END_VAR
                    Double := value + value;
                END_FUNCTION
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := Double(number := 5);
                END_PROGRAM
                ",
            fix: "Use the name of a parameter as it is declared.",
            repaired: "
                FUNCTION Double : INT
                VAR_INPUT
                    value : INT;
                END_VAR
                    Double := value + value;
                END_FUNCTION
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := Double(value := 5);
                END_PROGRAM
                ",
        }
        P4024 FunctionCallDuplicateNamedArg {
            summary: "an argument is given twice",
            explanation: "Each parameter takes one argument; with two of them it would depend on their order which one counts.",
            example: IronplcEd2 "
                FUNCTION Double : INT
                VAR_INPUT
                    value : INT;
                END_VAR
                    Double := value + value;
                END_FUNCTION
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := Double(value := 5, value := 6);
                END_PROGRAM
                ",
            fix: "Give it once.",
            repaired: "
                FUNCTION Double : INT
                VAR_INPUT
                    value : INT;
                END_VAR
                    Double := value + value;
                END_FUNCTION
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := Double(value := 5);
                END_PROGRAM
                ",
        }
        P4025 BitAccessOutOfRange {
            summary: "the type has no such bit",
            explanation: "Bits count from 0, the least significant, so a type of 8 bits has the bits 0 to 7. Where the type has no bits \
                at all the code is P4069.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    flags : BYTE;
                    a : BOOL;
                END_VAR
                    a := flags.8;
                END_PROGRAM
                ",
            fix: "Use a bit that the type has, or a wider type.",
            repaired: "
                PROGRAM main
                VAR
                    flags : WORD;
                    a : BOOL;
                END_VAR
                    a := flags.8;
                END_PROGRAM
                ",
        }
        P4026 FunctionCallArgTypeMismatch {
            summary: "the argument's type does not fit the parameter",
            explanation: "The argument is neither of the parameter's type nor of one that converts to it implicitly in the dialect. The \
                inputs of function blocks follow the same rule. Where a conversion function would help, the diagnostic suggests the \
                call.",
            example: IronplcEd2 "
                FUNCTION Double : INT
                VAR_INPUT
                    value : INT;
                END_VAR
                    Double := value + value;
                END_FUNCTION
                PROGRAM main
                VAR
                    a : INT;
                    b : REAL;
                END_VAR
                    a := Double(b);
                END_PROGRAM
                ",
            fix: "Call a type conversion function.",
            repaired: "
                FUNCTION Double : INT
                VAR_INPUT
                    value : INT;
                END_VAR
                    Double := value + value;
                END_FUNCTION
                PROGRAM main
                VAR
                    a : INT;
                    b : REAL;
                END_VAR
                    a := Double(REAL_TO_INT(b));
                END_PROGRAM
                ",
        }
        P4027 FunctionCallReturnTypeMismatch {
            summary: "the function's result does not fit the target",
            explanation: "The right-hand side is the bare result of a function, and its type is neither the target's nor one that \
                converts to it implicitly in the dialect. For any other expression the code is P4035.",
            example: IronplcEd2 "
                FUNCTION Half : REAL
                VAR_INPUT
                    value : REAL;
                END_VAR
                    Half := value / 2.0;
                END_FUNCTION
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := Half(5.0);
                END_PROGRAM
                ",
            fix: "Call a type conversion function.",
            repaired: "
                FUNCTION Half : REAL
                VAR_INPUT
                    value : REAL;
                END_VAR
                    Half := value / 2.0;
                END_FUNCTION
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := REAL_TO_INT(Half(5.0));
                END_PROGRAM
                ",
        }
    } };
}
