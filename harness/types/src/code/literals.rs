//! Codes of whole aggregates, and of literals that their types cannot hold.

macro_rules! literal_codes {
    ($rest:tt $($entries:tt)*) => { gather! { $rest $($entries)*
        P2037 AggregateAssignmentTypeMismatch {
            summary: "the arrays or structures are not of one type",
            explanation: "Assigning a whole array or structure copies it, and nothing is converted on the way: dimensions, bounds and \
                element types must agree. Stickler's reference gives P4035 for every assignment.",
            example: elsewhere "
                PROGRAM main
                VAR
                    a : ARRAY [1..2] OF INT;
                    b : ARRAY [1..5] OF INT;
                END_VAR
                    a := b;
                END_PROGRAM
                ",
            fix: "Give both variables one type, or copy element by element.",
            repaired: "
                PROGRAM main
                VAR
                    a : ARRAY [1..2] OF INT;
                    b : ARRAY [1..5] OF INT;
                END_VAR
                    a[1] := b[1];
                    a[2] := b[2];
                END_PROGRAM
                ",
        }
        P2038 DateLiteralOutOfRange {
            summary: "the date literal is outside its type",
            explanation: "The calendar has no such day, the clock no such time, or the type does not reach so far. Stickler counts \
                nanoseconds from 1970 in 64 bits, which reach from September 1677 to April 2262; other compilers count seconds, and \
                end in 2106 or 2038.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    day : DATE;
                END_VAR
                    day := DATE#2023-02-29;
                END_PROGRAM
                ",
            fix: "Use a day that the calendar has and the type reaches.",
            repaired: "
                PROGRAM main
                VAR
                    day : DATE;
                END_VAR
                    day := DATE#2024-02-29;
                END_PROGRAM
                ",
        }
        P2039 DurationLiteralOutOfRange {
            summary: "the duration literal is outside its type",
            explanation: "The parts of the literal add up to more than the type holds. Stickler counts nanoseconds in 64 bits, which \
                is 292 years in either direction; compilers that count milliseconds in 32 bits end at 24 days.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    pause : TIME;
                END_VAR
                    pause := T#200000d;
                END_PROGRAM
                ",
            fix: "Use a shorter duration, or count days in an integer.",
            repaired: "
                PROGRAM main
                VAR
                    pause : TIME;
                END_VAR
                    pause := T#20d;
                END_PROGRAM
                ",
        }
        P2040 RealLiteralOutOfRange {
            summary: "the real literal is outside its type",
            explanation: "Rounded to the nearest value of its type, the literal would be an infinity: beyond about 3.4E38 for REAL and \
                1.8E308 for LREAL. A literal that is too small is no error; it becomes zero.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    mass : REAL;
                END_VAR
                    mass := 1.0E39;
                END_PROGRAM
                ",
            fix: "Use LREAL, or a unit in which the number is smaller.",
            repaired: "
                PROGRAM main
                VAR
                    mass : LREAL;
                END_VAR
                    mass := 1.0E39;
                END_PROGRAM
                ",
        }
        P2041 StringLengthOutOfRange {
            summary: "the string's length is out of range",
            explanation: "A string is declared longer than a string can be: the length has to fit 16 bits.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    page : STRING[70000];
                END_VAR
                END_PROGRAM
                ",
            fix: "Declare a shorter string, or several.",
            repaired: "
                PROGRAM main
                VAR
                    page : STRING[700];
                END_VAR
                END_PROGRAM
                ",
        }
        P2042 ReturnTypeNotDeclared {
            summary: "the function's result type is not declared",
            explanation: "The type behind the colon of a FUNCTION does not exist. Stickler's reference gives P2008 for every type that \
                is not declared.",
            example: elsewhere "
                FUNCTION Mode : PumpMode
                    Mode := 0;
                END_FUNCTION
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := 1;
                END_PROGRAM
                ",
            fix: "Declare the type, or use an elementary one.",
            repaired: "
                FUNCTION Mode : INT
                    Mode := 0;
                END_FUNCTION
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := 1;
                END_PROGRAM
                ",
        }
        P2043 EnumValueAmbiguous {
            summary: "several enumerations have this value",
            explanation: "The value is written without its type, more than one enumeration has a value of that name, and the place does \
                not say which of them is wanted.",
            example: IronplcEd2 "
                TYPE
                    Color : (Red, Green);
                    Signal : (Off, Green);
                END_TYPE
                PROGRAM main
                VAR
                    code : BOOL;
                END_VAR
                    code := Green;
                END_PROGRAM
                ",
            fix: "Write the type in front: `Color#Green`.",
            repaired: "
                TYPE
                    Color : (Red, Green);
                    Signal : (Off, Green);
                END_TYPE
                PROGRAM main
                VAR
                    code : Color;
                END_VAR
                    code := Color#Green;
                END_PROGRAM
                ",
        }
    } };
}
