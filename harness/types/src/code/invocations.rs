//! Codes of invoking function blocks, and of the units and variables around them.

macro_rules! invocation_codes {
    ($rest:tt $($entries:tt)*) => { gather! { $rest $($entries)*
        P4001 FunctionCallMixedArgTypes {
            summary: "named and positional arguments are mixed",
            explanation: "A call gives its arguments either by name, in any order, or by position, without names. Mixed, it would not \
                be clear which position an argument without a name has.",
            example: IronplcEd2 "
                FUNCTION Scale : INT
                VAR_INPUT
                    value : INT;
                    factor : INT;
                END_VAR
                    Scale := value * factor;
                END_FUNCTION
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := Scale(value := 2, 3);
                END_PROGRAM
                ",
            fix: "Name all arguments, or none.",
            repaired: "
                FUNCTION Scale : INT
                VAR_INPUT
                    value : INT;
                    factor : INT;
                END_VAR
                    Scale := value * factor;
                END_FUNCTION
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := Scale(value := 2, factor := 3);
                END_PROGRAM
                ",
        }
        P4002 FunctionInvocationMissingInput {
            summary: "the function block has no such input",
            explanation: "The invocation of a function block gives a value to an input that the function block does not declare. \
                Stickler's reference gives P4023, as it does for functions.",
            example: elsewhere "
                FUNCTION_BLOCK Pump
                VAR_INPUT
                    start : BOOL;
                END_VAR
                END_FUNCTION_BLOCK
                PROGRAM main
                VAR
                    pump_1 : Pump;
                END_VAR
                    pump_1(run := TRUE);
                END_PROGRAM
                ",
            fix: "Use the name of an input as it is declared.",
            repaired: "
                FUNCTION_BLOCK Pump
                VAR_INPUT
                    start : BOOL;
                END_VAR
                END_FUNCTION_BLOCK
                PROGRAM main
                VAR
                    pump_1 : Pump;
                END_VAR
                    pump_1(start := TRUE);
                END_PROGRAM
                ",
        }
        P4003 FunctionInvocationRequiresFormal {
            summary: "the invocation's arguments do not fit the function block's inputs",
            explanation: "An invocation that gives its arguments by position must give one for each input. One that gives them by name \
                may leave inputs out: they keep their values.",
            example: IronplcEd2 "
                FUNCTION_BLOCK Pump
                VAR_INPUT
                    start : BOOL;
                    stop : BOOL;
                END_VAR
                END_FUNCTION_BLOCK
                PROGRAM main
                VAR
                    pump_1 : Pump;
                END_VAR
                    pump_1(TRUE);
                END_PROGRAM
                ",
            fix: "Name the argument, or give all of them.",
            repaired: "
                FUNCTION_BLOCK Pump
                VAR_INPUT
                    start : BOOL;
                    stop : BOOL;
                END_VAR
                END_FUNCTION_BLOCK
                PROGRAM main
                VAR
                    pump_1 : Pump;
                END_VAR
                    pump_1(start := TRUE);
                END_PROGRAM
                ",
        }
        P4004 FunctionInvocationUndefinedOutput {
            summary: "there is no such output",
            explanation: "What stands before `=>` must be an output of the function or function block that is called; behind it stands \
                the variable that receives the value.",
            example: IronplcEd2 "
                FUNCTION_BLOCK Pump
                VAR_OUTPUT
                    running : BOOL;
                END_VAR
                END_FUNCTION_BLOCK
                PROGRAM main
                VAR
                    pump_1 : Pump;
                    lamp : BOOL;
                END_VAR
                    pump_1(active => lamp);
                END_PROGRAM
                ",
            fix: "Use the name of an output as it is declared.",
            repaired: "
                FUNCTION_BLOCK Pump
                VAR_OUTPUT
                    running : BOOL;
                END_VAR
                END_FUNCTION_BLOCK
                PROGRAM main
                VAR
                    pump_1 : Pump;
                    lamp : BOOL;
                END_VAR
                    pump_1(running => lamp);
                END_PROGRAM
                ",
        }
        P4005 RecursiveCycle {
            summary: "the unit calls or contains itself",
            explanation: "A function that calls itself, or a function block that holds an instance of itself, directly or by way of \
                others, has no bound in time or memory. The standard forbids recursion.",
            example: IronplcEd2 "
                FUNCTION Factorial : DINT
                VAR_INPUT
                    n : DINT;
                END_VAR
                    IF n <= 1 THEN
                        Factorial := 1;
                    ELSE
                        Factorial := n * Factorial(n - 1);
                    END_IF;
                END_FUNCTION
                PROGRAM main
                VAR
                    f : DINT;
                END_VAR
                    f := Factorial(5);
                END_PROGRAM
                ",
            fix: "Use a loop.",
            repaired: "
                FUNCTION Factorial : DINT
                VAR_INPUT
                    n : DINT;
                END_VAR
                VAR
                    i : DINT;
                END_VAR
                    Factorial := 1;
                    FOR i := 2 TO n DO
                        Factorial := i * Factorial;
                    END_FOR;
                END_FUNCTION
                PROGRAM main
                VAR
                    f : DINT;
                END_VAR
                    f := Factorial(5);
                END_PROGRAM
                ",
        }
        P4006 ProgramMissingTaskConfig {
            summary: "the program's task is not declared",
            explanation: "`PROGRAM … WITH` names a task of the same resource, and there is none of that name.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := 1;
                END_PROGRAM
                CONFIGURATION plant
                    RESOURCE controller ON PLC
                        PROGRAM instance WITH cyclic : main;
                    END_RESOURCE
                END_CONFIGURATION
                ",
            fix: "Declare the task in the resource.",
            repaired: "
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := 1;
                END_PROGRAM
                CONFIGURATION plant
                    RESOURCE controller ON PLC
                        TASK cyclic(INTERVAL := T#10ms, PRIORITY := 1);
                        PROGRAM instance WITH cyclic : main;
                    END_RESOURCE
                END_CONFIGURATION
                ",
        }
        P4007 VariableUndefined {
            summary: "the variable is not declared",
            explanation: "No variable of that name is declared where the name is used: neither in the same program organization unit \
                nor, in dialects that look there, among the globals.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    counter : INT;
                END_VAR
                    conter := 1;
                END_PROGRAM
                ",
            fix: "Declare the variable, or correct its name.",
            repaired: "
                PROGRAM main
                VAR
                    counter : INT;
                END_VAR
                    counter := 1;
                END_PROGRAM
                ",
        }
        P4008 ConstantMustHaveInitializer {
            summary: "the constant has no initial value",
            explanation: "A constant can be given its value at its declaration only, so without an initial value there it would stay at \
                the default of its type for ever.",
            example: IronplcEd2 "
                PROGRAM main
                VAR CONSTANT
                    limit : INT;
                END_VAR
                END_PROGRAM
                ",
            fix: "Give the constant its value.",
            repaired: "
                PROGRAM main
                VAR CONSTANT
                    limit : INT := 17;
                END_VAR
                END_PROGRAM
                ",
        }
        P4009 FunctionBlockNotConstant {
            summary: "an instance of a function block cannot be CONSTANT",
            explanation: "An instance changes with each invocation, which is what it is for.",
            example: IronplcEd2 "
                FUNCTION_BLOCK Pump
                VAR_INPUT
                    start : BOOL;
                END_VAR
                END_FUNCTION_BLOCK
                PROGRAM main
                VAR CONSTANT
                    pump_1 : Pump;
                END_VAR
                END_PROGRAM
                ",
            fix: "Declare the instance in a block without CONSTANT.",
            repaired: "
                FUNCTION_BLOCK Pump
                VAR_INPUT
                    start : BOOL;
                END_VAR
                END_FUNCTION_BLOCK
                PROGRAM main
                VAR
                    pump_1 : Pump;
                END_VAR
                END_PROGRAM
                ",
        }
        P4010 VariableMustBeConst {
            summary: "an external constant is not declared as one",
            explanation: "The global variable is CONSTANT, so the VAR_EXTERNAL that makes it known to a unit has to say so too: otherwise \
                the unit could seem to write it. Stickler's reference takes the word of the global declaration.",
            example: elsewhere "
                VAR_GLOBAL CONSTANT
                    limit : INT := 17;
                END_VAR
                PROGRAM main
                VAR_EXTERNAL
                    limit : INT;
                END_VAR
                VAR
                    a : INT;
                END_VAR
                    a := limit;
                END_PROGRAM
                ",
            fix: "Write VAR_EXTERNAL CONSTANT.",
            repaired: "
                VAR_GLOBAL CONSTANT
                    limit : INT := 17;
                END_VAR
                PROGRAM main
                VAR_EXTERNAL CONSTANT
                    limit : INT;
                END_VAR
                VAR
                    a : INT;
                END_VAR
                    a := limit;
                END_PROGRAM
                ",
        }
    } };
}
