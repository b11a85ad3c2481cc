//! Codes of operators and statements, and of what is passed by reference.

macro_rules! statement_codes {
    ($rest:tt $($entries:tt)*) => { gather! { $rest $($entries)*
        P4049 OperatorOperandTypeMismatch {
            summary: "the operator is not defined for these operands",
            explanation: "Either no type of the operand's kind has the operator, such as MOD on reals, or the two operands have no common \
                type: one of them would have to convert implicitly to the type of the other, and no third type is sought.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    angle : REAL;
                END_VAR
                    angle := angle MOD 360.0;
                END_PROGRAM
                ",
            fix: "Convert the operands to a type that has the operator.",
            repaired: "
                PROGRAM main
                VAR
                    angle : DINT;
                END_VAR
                    angle := angle MOD 360;
                END_PROGRAM
                ",
        }
        P4050 ProgramVariableHidesGlobal {
            summary: "a program's variable hides a global one",
            explanation: "A program reaches a global variable by VAR_EXTERNAL. A variable of its own with the same name would hide it, \
                which some compilers reject; in Stickler's reference the program's own variable is meant.",
            example: elsewhere "
                VAR_GLOBAL
                    limit : INT := 17;
                END_VAR
                PROGRAM main
                VAR
                    limit : INT;
                END_VAR
                    limit := 18;
                END_PROGRAM
                ",
            fix: "Rename the variable, or declare it in VAR_EXTERNAL if the global one is meant.",
            repaired: "
                VAR_GLOBAL
                    limit : INT := 17;
                END_VAR
                PROGRAM main
                VAR_EXTERNAL
                    limit : INT;
                END_VAR
                    limit := 18;
                END_PROGRAM
                ",
        }
        P4051 CaseLabelRangeInvalid {
            summary: "the range of the CASE label descends",
            explanation: "A range is written with its lower limit first; the wrong way round it holds no value, and its branch never runs.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    level : INT;
                    alarm : BOOL;
                END_VAR
                    CASE level OF
                        10..1: alarm := TRUE;
                    END_CASE;
                END_PROGRAM
                ",
            fix: "Write the lower limit first.",
            repaired: "
                PROGRAM main
                VAR
                    level : INT;
                    alarm : BOOL;
                END_VAR
                    CASE level OF
                        1..10: alarm := TRUE;
                    END_CASE;
                END_PROGRAM
                ",
        }
        P4052 StringLiteralCharOutOfRange {
            summary: "the string's type cannot hold the character",
            explanation: "A STRING has characters of 8 bits, the first 256 of Unicode, and the literal has another one.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    price : STRING;
                END_VAR
                    price := '5 €';
                END_PROGRAM
                ",
            fix: "Use a WSTRING and double quotes.",
            repaired: "
                PROGRAM main
                VAR
                    price : WSTRING;
                END_VAR
                    price := \"5 €\";
                END_PROGRAM
                ",
        }
        P4053 CaseSelectorTypeInvalid {
            summary: "the CASE selector is neither an integer nor an enumeration",
            explanation: "The labels of a CASE are integers and enumerated values, and the selector is compared with them. Reals, bit \
                strings, times and texts are not comparable with any label.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    level : REAL;
                    alarm : BOOL;
                END_VAR
                    CASE level OF
                        1: alarm := TRUE;
                    END_CASE;
                END_PROGRAM
                ",
            fix: "Convert the selector to an integer, or use IF.",
            repaired: "
                PROGRAM main
                VAR
                    level : REAL;
                    alarm : BOOL;
                END_VAR
                    CASE REAL_TO_INT(level) OF
                        1: alarm := TRUE;
                    END_CASE;
                END_PROGRAM
                ",
        }
        P4054 FunctionBlockInFunction {
            summary: "a function cannot hold an instance of a function block",
            explanation: "A function starts afresh with each call, and an instance is there to remember. The third edition lets a function \
                receive its caller's instance by VAR_IN_OUT.",
            example: IronplcEd2 "
                FUNCTION_BLOCK Counter
                VAR_OUTPUT
                    count : INT;
                END_VAR
                    count := count + 1;
                END_FUNCTION_BLOCK
                FUNCTION Next : INT
                VAR
                    counter_1 : Counter;
                END_VAR
                    Next := counter_1.count;
                END_FUNCTION
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := Next();
                END_PROGRAM
                ",
            fix: "Make the function a function block, or hold the instance in the program.",
            repaired: "
                FUNCTION_BLOCK Counter
                VAR_OUTPUT
                    count : INT;
                END_VAR
                    count := count + 1;
                END_FUNCTION_BLOCK
                PROGRAM main
                VAR
                    counter_1 : Counter;
                    a : INT;
                END_VAR
                    counter_1(count => a);
                END_PROGRAM
                ",
        }
        P4055 EnumExplicitValueNotAllowed {
            summary: "numbers for enumerated values are not enabled",
            explanation: "The third edition lets an enumeration number its values (`Red := 1`), the second does not. Some compilers need \
                to be told.",
            example: elsewhere "
                TYPE
                    Color : (Red := 1, Green := 2);
                END_TYPE
                PROGRAM main
                VAR
                    lamp : Color;
                END_VAR
                END_PROGRAM
                ",
            fix: "Leave the numbers out.",
            repaired: "
                TYPE
                    Color : (Red, Green);
                END_TYPE
                PROGRAM main
                VAR
                    lamp : Color;
                END_VAR
                END_PROGRAM
                ",
        }
        P4056 EnumBaseTypeNotAllowed {
            summary: "a type behind the enumeration is not enabled",
            explanation: "Some compilers let the declaration say in which type the values are held: `(Red, Green) BYTE`. The standard has \
                no such form, and its third edition writes the type in front. Stickler's reference calls the form a syntax error, \
                P0002.",
            example: elsewhere "
                TYPE
                    Color : (Red, Green) BYTE;
                END_TYPE
                PROGRAM main
                VAR
                    lamp : Color;
                END_VAR
                END_PROGRAM
                ",
            fix: "Leave the type out.",
            repaired: "
                TYPE
                    Color : (Red, Green);
                END_TYPE
                PROGRAM main
                VAR
                    lamp : Color;
                END_VAR
                END_PROGRAM
                ",
        }
        P4057 MethodCallWithoutReturnValue {
            summary: "the method gives no value",
            explanation: "A method without a result stands where a value is needed. Stickler's reference has no methods: it answers P9999.",
            example: elsewhere "
                FUNCTION_BLOCK Motor
                METHOD Start
                END_METHOD
                END_FUNCTION_BLOCK
                PROGRAM main
                VAR
                    motor_1 : Motor;
                    ok : BOOL;
                END_VAR
                    ok := motor_1.Start();
                END_PROGRAM
                ",
            fix: "Call the method as a statement, or give it a result.",
        }
    } };
}
