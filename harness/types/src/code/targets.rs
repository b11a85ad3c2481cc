//! Codes of global variables, of constants that stand in types, and of what may be assigned to what.

macro_rules! target_codes {
    ($rest:tt $($entries:tt)*) => { gather! { $rest $($entries)*
        P4028 TopLevelVarGlobalNotAllowed {
            summary: "VAR_GLOBAL outside a configuration is not enabled",
            explanation: "The standard has global variables inside CONFIGURATION and RESOURCE only. Many compilers read them at the top \
                level too, and Stickler's reference does so in every dialect.",
            example: elsewhere "
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
            fix: "Move the block into a configuration.",
        }
        P4029 ConstantTypeParamNotAllowed {
            summary: "a constant's name in a type is not enabled",
            explanation: "In the second edition of the standard the length of a string and the bounds of an array are integer literals. \
                Many compilers read the name of a constant there, and Stickler's reference does so in every dialect.",
            example: elsewhere "
                PROGRAM main
                VAR CONSTANT
                    size : INT := 10;
                END_VAR
                VAR
                    samples : ARRAY [1..size] OF INT;
                END_VAR
                    samples[1] := 5;
                END_PROGRAM
                ",
            fix: "Write the number.",
            repaired: "
                PROGRAM main
                VAR
                    samples : ARRAY [1..10] OF INT;
                END_VAR
                    samples[1] := 5;
                END_PROGRAM
                ",
        }
        P4030 UndefinedConstantReference {
            summary: "the constant in the type is not declared",
            explanation: "The length of a string or the bound of an array is a name, and no constant has it.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    samples : ARRAY [1..size] OF INT;
                END_VAR
                    samples[1] := 5;
                END_PROGRAM
                ",
            fix: "Declare the constant, or write the number.",
            repaired: "
                PROGRAM main
                VAR
                    samples : ARRAY [1..10] OF INT;
                END_VAR
                    samples[1] := 5;
                END_PROGRAM
                ",
        }
        P4031 ConstantNotIntegerType {
            summary: "the constant in the type is no integer",
            explanation: "The length of a string and the bounds of an array are integers, so the constant that stands for one has to be \
                of an integer type.",
            example: IronplcEd2 "
                PROGRAM main
                VAR CONSTANT
                    size : REAL := 10.0;
                END_VAR
                VAR
                    samples : ARRAY [1..size] OF INT;
                END_VAR
                    samples[1] := 5;
                END_PROGRAM
                ",
            fix: "Give the constant an integer type.",
            repaired: "
                PROGRAM main
                VAR
                    samples : ARRAY [1..10] OF INT;
                END_VAR
                    samples[1] := 5;
                END_PROGRAM
                ",
        }
        P4032 ConstantMissingInitializer {
            summary: "the constant in the type has no value",
            explanation: "The length of a string or the bound of an array is the name of a constant whose declaration gives no value.",
            example: IronplcEd2 "
                PROGRAM main
                VAR CONSTANT
                    size : INT;
                END_VAR
                VAR
                    samples : ARRAY [1..size] OF INT;
                END_VAR
                    samples[1] := 5;
                END_PROGRAM
                ",
            fix: "Give the constant its value.",
            repaired: "
                PROGRAM main
                VAR
                    samples : ARRAY [1..10] OF INT;
                END_VAR
                    samples[1] := 5;
                END_PROGRAM
                ",
        }
        P4033 PartialAccessSyntaxDisabled {
            summary: "the syntax of partial access is not enabled",
            explanation: "The third edition of the standard writes parts of a bit string as `.%X3` (a bit), `.%B1`, `.%W1`, `.%D1` and \
                `.%L0`. The dialect does not have it. Nothing else is said about the same construct.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    flags : BYTE;
                    a : BOOL;
                END_VAR
                    a := flags.%X3;
                END_PROGRAM
                ",
            fix: "Write the bit without `%X`, or choose a dialect that has partial access.",
            repaired: "
                PROGRAM main
                VAR
                    flags : BYTE;
                    a : BOOL;
                END_VAR
                    a := flags.3;
                END_PROGRAM
                ",
        }
        P4034 StringEncodingMismatch {
            summary: "STRING and WSTRING are mixed",
            explanation: "The characters of a STRING have 8 bits and those of a WSTRING 16, and neither converts to the other by itself. \
                Stickler's reference gives the code of the context: P4035 for an assignment, P4026 for an argument.",
            example: elsewhere "
                PROGRAM main
                VAR
                    narrow : STRING;
                    wide : WSTRING;
                END_VAR
                    narrow := wide;
                END_PROGRAM
                ",
            fix: "Call a type conversion function, if the dialect has one for the pair, or use one kind of string throughout.",
            repaired: "
                PROGRAM main
                VAR
                    narrow : STRING;
                    wide : STRING;
                END_VAR
                    narrow := wide;
                END_PROGRAM
                ",
        }
        P4035 AssignmentTypeMismatch {
            summary: "the value's type does not fit the target",
            explanation: "The value is neither of the target's type nor of one that converts to it implicitly in the dialect. Dialects \
                differ here: many widen INT to DINT, some widen nothing. Where a conversion function would help, the diagnostic \
                suggests the call.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    small : INT;
                    large : DINT;
                END_VAR
                    small := large;
                END_PROGRAM
                ",
            fix: "Call a type conversion function; where the value may not fit, say what is to happen then.",
            repaired: "
                PROGRAM main
                VAR
                    small : INT;
                    large : DINT;
                END_VAR
                    small := DINT_TO_INT(LIMIT(-32768, large, 32767));
                END_PROGRAM
                ",
        }
    } };
}
