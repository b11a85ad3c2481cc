//! Codes of what types consist of: elements, fields, subranges, dimensions, and the values that fit them.

macro_rules! type_content_codes {
    ($rest:tt $($entries:tt)*) => { gather! { $rest $($entries)*
        P2013 ArrayElementTypeNotDeclared {
            summary: "the array's element type is not declared",
            explanation: "The type behind `OF` does not exist. Stickler's reference gives P2008 for every type that is not declared.",
            example: elsewhere "
                TYPE
                    Batch : ARRAY [1..10] OF Sample;
                END_TYPE
                PROGRAM main
                VAR
                    today : Batch;
                END_VAR
                END_PROGRAM
                ",
            fix: "Declare the element type, or use an elementary one.",
            repaired: "
                TYPE
                    Batch : ARRAY [1..10] OF REAL;
                END_TYPE
                PROGRAM main
                VAR
                    today : Batch;
                END_VAR
                END_PROGRAM
                ",
        }
        P2014 SimpleTypeDeclMissingInit {
            summary: "the declaration of the type lacks its initial value",
            explanation: "Some compilers ask for an initial value where a type is declared by the name of another. The standard does \
                not, and neither does Stickler's reference.",
            example: elsewhere "
                TYPE
                    Level : INT;
                END_TYPE
                PROGRAM main
                VAR
                    tank : Level;
                END_VAR
                END_PROGRAM
                ",
            fix: "Give the type an initial value.",
            repaired: "
                TYPE
                    Level : INT := 0;
                END_TYPE
                PROGRAM main
                VAR
                    tank : Level;
                END_VAR
                END_PROGRAM
                ",
        }
        P2015 SubrangeBaseTypeNotNumeric {
            summary: "the subrange's base type is no integer",
            explanation: "A subrange takes some values in sequence out of an integer type. Reals, bit strings, times and texts have \
                no such sequence.",
            example: IronplcEd2 "
                TYPE
                    Ratio : REAL (0..1);
                END_TYPE
                PROGRAM main
                VAR
                    valve : Ratio;
                END_VAR
                END_PROGRAM
                ",
            fix: "Choose an integer type, or drop the limits and test the value in the program.",
            repaired: "
                TYPE
                    Ratio : INT (0..1);
                END_TYPE
                PROGRAM main
                VAR
                    valve : Ratio;
                END_VAR
                END_PROGRAM
                ",
        }
        P2016 SubrangeOutOfBounds {
            summary: "the subrange goes beyond its base type",
            explanation: "Both limits of a subrange must be values of the type that it is taken from.",
            example: IronplcEd2 "
                TYPE
                    Level : SINT (0..1000);
                END_TYPE
                PROGRAM main
                VAR
                    tank : Level;
                END_VAR
                END_PROGRAM
                ",
            fix: "Choose a wider base type, or closer limits.",
            repaired: "
                TYPE
                    Level : INT (0..1000);
                END_TYPE
                PROGRAM main
                VAR
                    tank : Level;
                END_VAR
                END_PROGRAM
                ",
        }
        P2017 StructFieldMissingType {
            summary: "the field has no type",
            explanation: "Every field of a structure is declared with a colon and its type. Stickler's reference calls the omission a \
                syntax error, P0002.",
            example: elsewhere "
                TYPE
                    Tank : STRUCT
                        level : ;
                    END_STRUCT;
                END_TYPE
                PROGRAM main
                VAR
                    tank_1 : Tank;
                END_VAR
                END_PROGRAM
                ",
            fix: "Write the type of the field behind the colon.",
            repaired: "
                TYPE
                    Tank : STRUCT
                        level : INT;
                    END_STRUCT;
                END_TYPE
                PROGRAM main
                VAR
                    tank_1 : Tank;
                END_VAR
                END_PROGRAM
                ",
        }
        P2019 InvalidSimpleTypeDecl {
            summary: "the declaration of the type is not valid",
            explanation: "The right-hand side of the declaration describes no type that a variable could have. Stickler's reference \
                reports the particular fault: mostly a syntax error, P0002.",
            example: elsewhere "
                TYPE
                    Level : 5;
                END_TYPE
                PROGRAM main
                VAR
                    tank : Level;
                END_VAR
                END_PROGRAM
                ",
            fix: "Declare the type by the name of another one, a subrange, an enumeration, an array or a structure.",
            repaired: "
                TYPE
                    Level : INT (0..5);
                END_TYPE
                PROGRAM main
                VAR
                    tank : Level;
                END_VAR
                END_PROGRAM
                ",
        }
        P2020 EnumerationTooManyValues {
            summary: "the enumeration has too many values",
            explanation: "A compiler numbers the values of an enumeration, and may have room for so many numbers only. Stickler's \
                reference has no limit that a source could reach; the example stands for one with many more values.",
            example: elsewhere "
                TYPE
                    Step : (Step_1, Step_2, Step_3);
                END_TYPE
                PROGRAM main
                VAR
                    current : Step;
                END_VAR
                END_PROGRAM
                ",
            fix: "Divide the enumeration, or number the values with an integer type.",
        }
        P2021 StructFieldTypeNotDeclared {
            summary: "the field's type is not declared",
            explanation: "A field of a structure has a type that does not exist. Stickler's reference gives P2008 for every type that \
                is not declared.",
            example: elsewhere "
                TYPE
                    Tank : STRUCT
                        level : Measure;
                    END_STRUCT;
                END_TYPE
                PROGRAM main
                VAR
                    tank_1 : Tank;
                END_VAR
                END_PROGRAM
                ",
            fix: "Declare the type, or use an elementary one.",
            repaired: "
                TYPE
                    Tank : STRUCT
                        level : INT;
                    END_STRUCT;
                END_TYPE
                PROGRAM main
                VAR
                    tank_1 : Tank;
                END_VAR
                END_PROGRAM
                ",
        }
        P2022 ArrayDimensionEmpty {
            summary: "the array has no dimension",
            explanation: "Between the brackets of an array stands at least one range of subscripts. Stickler's reference calls the \
                omission a syntax error, P0002.",
            example: elsewhere "
                PROGRAM main
                VAR
                    samples : ARRAY [] OF INT;
                END_VAR
                END_PROGRAM
                ",
            fix: "Write the lower and the upper bound.",
            repaired: "
                PROGRAM main
                VAR
                    samples : ARRAY [1..10] OF INT;
                END_VAR
                END_PROGRAM
                ",
        }
        P2023 ArraySizeOverflow {
            summary: "the array is too large",
            explanation: "The product of the dimensions is more than an array may hold. Controllers have little memory, and \
                a size that overflows is nearly always a slip in a bound.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    samples : ARRAY [1..100000, 1..100000] OF INT;
                END_VAR
                END_PROGRAM
                ",
            fix: "Make the array smaller.",
            repaired: "
                PROGRAM main
                VAR
                    samples : ARRAY [1..100, 1..100] OF INT;
                END_VAR
                END_PROGRAM
                ",
        }
        P2024 ArrayDimensionInvalid {
            summary: "the array's bounds descend",
            explanation: "The lower bound of a dimension stands first and is not greater than the upper one. Equal bounds are right: \
                they make an array of one element.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    samples : ARRAY [10..1] OF INT;
                END_VAR
                END_PROGRAM
                ",
            fix: "Write the lower bound first.",
            repaired: "
                PROGRAM main
                VAR
                    samples : ARRAY [1..10] OF INT;
                END_VAR
                END_PROGRAM
                ",
        }
        P2025 TypeEnvironmentUnknownType {
            summary: "the type is unknown",
            explanation: "A compiler that looks types up more than once may miss one only later, and says so with this code. \
                Stickler's reference gives P2008 for every type that is not declared.",
            example: elsewhere "
                FUNCTION_BLOCK Pump
                VAR
                    state : PumpState;
                END_VAR
                END_FUNCTION_BLOCK
                PROGRAM main
                VAR
                    pump_1 : Pump;
                END_VAR
                END_PROGRAM
                ",
            fix: "Declare the type, or correct its name.",
            repaired: "
                TYPE
                    PumpState : (Idle, Running);
                END_TYPE
                FUNCTION_BLOCK Pump
                VAR
                    state : PumpState;
                END_VAR
                END_FUNCTION_BLOCK
                PROGRAM main
                VAR
                    pump_1 : Pump;
                END_VAR
                END_PROGRAM
                ",
        }
        P2026 ConstantOverflow {
            summary: "the constant does not fit its type",
            explanation: "A literal takes the type of the other operand or of the target, and that type has no such value. A sign \
                directly in front of an untyped literal belongs to it, so `-128` is a SINT; how the number is written makes no \
                difference, so `16#FF` is 255 and no SINT. A constant outside a subrange gets this code too.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    level : SINT;
                END_VAR
                    level := 200;
                END_PROGRAM
                ",
            fix: "Use a value that the type has, or a wider type.",
            repaired: "
                PROGRAM main
                VAR
                    level : INT;
                END_VAR
                    level := 200;
                END_PROGRAM
                ",
        }
        P2027 ArrayIndexOutOfBounds {
            summary: "the constant subscript is outside the array's bounds",
            explanation: "The subscript is known before the program runs, and the array has no such element. A subscript that is \
                known only at run time and turns out wrong stops the program with the fault `subscript-range`.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    samples : ARRAY [1..10] OF INT;
                END_VAR
                    samples[0] := 5;
                END_PROGRAM
                ",
            fix: "Use a subscript from the lower to the upper bound, both included.",
            repaired: "
                PROGRAM main
                VAR
                    samples : ARRAY [1..10] OF INT;
                END_VAR
                    samples[1] := 5;
                END_PROGRAM
                ",
        }
    } };
}
