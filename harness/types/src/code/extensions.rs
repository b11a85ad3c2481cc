//! Codes of constant expressions, of extensions that a dialect may leave out, and of object orientation and tasks.

macro_rules! extension_codes {
    ($rest:tt $($entries:tt)*) => { gather! { $rest $($entries)*
        P4036 MixedLocatedVarDeclarationNotAllowed {
            summary: "located and other variables share a block",
            explanation: "Variables with an address (`AT %IX0.0`) stand in blocks of their own, by the standard's grammar. Stickler's \
                reference has no located variables: it answers P9999.",
            example: elsewhere "
                FUNCTION_BLOCK Sensor
                VAR
                    input AT %I* : INT;
                    ready : BOOL;
                END_VAR
                END_FUNCTION_BLOCK
                PROGRAM main
                VAR
                    sensor_1 : Sensor;
                END_VAR
                    sensor_1();
                END_PROGRAM
                ",
            fix: "Declare the located variables in a block of their own.",
        }
        P4037 ConstantInitializerExpressionNotAllowed {
            summary: "an expression as an initial value is not enabled",
            explanation: "In the second edition of the standard an initial value is one literal. Many compilers read an expression of \
                constants there, and Stickler's reference does so in every dialect.",
            example: elsewhere "
                PROGRAM main
                VAR
                    degree : LREAL := 3.14159265358979 / 180.0;
                END_VAR
                END_PROGRAM
                ",
            fix: "Write the value of the expression.",
            repaired: "
                PROGRAM main
                VAR
                    degree : LREAL := 0.0174532925199433;
                END_VAR
                END_PROGRAM
                ",
        }
        P4038 InitializerNotConstantExpression {
            summary: "the initial value is not constant",
            explanation: "An initial value is computed before the program runs, so it can only be made of literals and constants. \
                Stickler's reference also takes variables that are declared earlier, with the initial values that they have.",
            example: elsewhere "
                PROGRAM main
                VAR
                    scale : LREAL := 2.0;
                    degree : LREAL := scale / 180.0;
                END_VAR
                END_PROGRAM
                ",
            fix: "Declare as CONSTANT what the initial value is made of, or assign the value in the program.",
            repaired: "
                PROGRAM main
                VAR CONSTANT
                    scale : LREAL := 2.0;
                END_VAR
                VAR
                    degree : LREAL := scale / 180.0;
                END_VAR
                END_PROGRAM
                ",
        }
        P4039 ConstantExpressionDivisionByZero {
            summary: "the constant expression divides by zero",
            explanation: "Both operands of the division or MOD are known before the program runs, and the second is zero. A division by \
                a variable that is zero at run time stops the program with the fault `division-by-zero` where it is one of integers.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := 5 / 0;
                END_PROGRAM
                ",
            fix: "Correct the divisor.",
            repaired: "
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := 5 / 2;
                END_PROGRAM
                ",
        }
        P4040 ConstantExpressionOverflow {
            summary: "the constant expression overflows",
            explanation: "All operands are known before the program runs, and the result is outside what the expression's type holds. \
                Arithmetic on variables wraps instead.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    a : LINT;
                END_VAR
                    a := 9223372036854775807 + 1;
                END_PROGRAM
                ",
            fix: "Use smaller operands, or compute with reals.",
            repaired: "
                PROGRAM main
                VAR
                    a : LINT;
                END_VAR
                    a := 9223372036854775806 + 1;
                END_PROGRAM
                ",
        }
        P4041 BitStringCaseLabelNotAllowed {
            summary: "a based number as a CASE label is not enabled",
            explanation: "By the grammar of the second edition a CASE label is a decimal integer, a range of them, or an enumerated value. \
                Many compilers read `16#D012` there too, and so does Stickler's reference in every dialect.",
            example: elsewhere "
                PROGRAM main
                VAR
                    a : DINT;
                    b : INT;
                END_VAR
                    CASE a OF
                        16#D012: b := 1;
                    END_CASE;
                END_PROGRAM
                ",
            fix: "Write the label as a decimal number.",
            repaired: "
                PROGRAM main
                VAR
                    a : DINT;
                    b : INT;
                END_VAR
                    CASE a OF
                        53266: b := 1;
                    END_CASE;
                END_PROGRAM
                ",
        }
        P4042 ParenStringLengthNotAllowed {
            summary: "the length of a string stands in brackets",
            explanation: "The standard writes the length of a string in square brackets. Some compilers read parentheses too.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    name : STRING(20);
                END_VAR
                END_PROGRAM
                ",
            fix: "Write square brackets.",
            repaired: "
                PROGRAM main
                VAR
                    name : STRING[20];
                END_VAR
                END_PROGRAM
                ",
        }
        P4043 StructInitializerExpressionNotAllowed {
            summary: "an expression in the initial value of a structure is not enabled",
            explanation: "By the grammar of the second edition the elements of a structure, and the inputs of an instance, are initialised \
                with constants. Stickler's reference reads an expression here as in any other initial value.",
            example: elsewhere "
                TYPE
                    Tank : STRUCT
                        level : INT;
                    END_STRUCT;
                END_TYPE
                PROGRAM main
                VAR
                    base : INT := 5;
                    tank_1 : Tank := (level := base + 1);
                END_VAR
                END_PROGRAM
                ",
            fix: "Write the value.",
            repaired: "
                TYPE
                    Tank : STRUCT
                        level : INT;
                    END_STRUCT;
                END_TYPE
                PROGRAM main
                VAR
                    tank_1 : Tank := (level := 6);
                END_VAR
                END_PROGRAM
                ",
        }
        P4044 ExtendsFieldNameDuplicated {
            summary: "a derived function block repeats a name of its base",
            explanation: "A function block that EXTENDS another has all its variables already. Stickler's reference has no inheritance: it \
                answers P9999.",
            example: elsewhere "
                FUNCTION_BLOCK Base
                VAR
                    state : INT;
                END_VAR
                END_FUNCTION_BLOCK
                FUNCTION_BLOCK Derived EXTENDS Base
                VAR
                    state : BOOL;
                END_VAR
                END_FUNCTION_BLOCK
                PROGRAM main
                VAR
                    a : Derived;
                END_VAR
                    a();
                END_PROGRAM
                ",
            fix: "Give the variable of the derived function block another name.",
        }
        P4045 AbstractFunctionBlockInstantiated {
            summary: "an ABSTRACT function block has no instances",
            explanation: "An ABSTRACT function block is there to be extended. Stickler's reference has no inheritance: it answers P9999.",
            example: elsewhere "
                FUNCTION_BLOCK ABSTRACT Base
                END_FUNCTION_BLOCK
                PROGRAM main
                VAR
                    a : Base;
                END_VAR
                    a();
                END_PROGRAM
                ",
            fix: "Declare an instance of a function block that extends it.",
        }
        P4046 MethodNotFound {
            summary: "the function block has no such method",
            explanation: "Neither the function block nor any that it extends declares the method. Stickler's reference has no methods: \
                where one is called, it finds no element of the name, P4007.",
            example: elsewhere "
                FUNCTION_BLOCK Motor
                VAR
                    running : BOOL;
                END_VAR
                END_FUNCTION_BLOCK
                PROGRAM main
                VAR
                    motor_1 : Motor;
                END_VAR
                    motor_1.Start();
                END_PROGRAM
                ",
            fix: "Declare the method, or correct its name.",
        }
        P4047 TaskSingleNotSupported {
            summary: "tasks that wait for an event are not supported",
            explanation: "A task with SINGLE runs at the rising edge of a variable. A compiler without such tasks says so, for the program \
                would never run. Stickler's reference runs the program once a scan whatever its task says.",
            example: elsewhere "
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := 1;
                END_PROGRAM
                CONFIGURATION plant
                    VAR_GLOBAL
                        trigger : BOOL;
                    END_VAR
                    RESOURCE controller ON PLC
                        TASK event(SINGLE := trigger, PRIORITY := 1);
                        PROGRAM instance WITH event : main;
                    END_RESOURCE
                END_CONFIGURATION
                ",
            fix: "Give the task an INTERVAL.",
        }
        P4048 TaskParameterOutOfRange {
            summary: "a parameter of the task is out of range",
            explanation: "The PRIORITY or INTERVAL of a task is more than the run-time system can hold. Stickler's reference runs the \
                program once a scan whatever its task says.",
            example: elsewhere "
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := 1;
                END_PROGRAM
                CONFIGURATION plant
                    RESOURCE controller ON PLC
                        TASK cyclic(INTERVAL := T#10ms, PRIORITY := 100000);
                        PROGRAM instance WITH cyclic : main;
                    END_RESOURCE
                END_CONFIGURATION
                ",
            fix: "Choose a smaller number.",
        }
    } };
}
