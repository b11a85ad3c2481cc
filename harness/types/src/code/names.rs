//! Codes of names: declared twice, not declared, or not what they are used as; and of calling functions.

macro_rules! name_codes {
    ($rest:tt $($entries:tt)*) => { gather! { $rest $($entries)*
        P4011 DefinitionNameDuplicated {
            summary: "two definitions have one name",
            explanation: "Functions, function blocks, programs and types share their names with each other, in whatever case. Two \
                definitions of the same kind have codes of their own: P4016 for functions, P4013 for function blocks and programs, \
                P2007 for types.",
            example: IronplcEd2 "
                FUNCTION Pump : INT
                    Pump := 0;
                END_FUNCTION
                FUNCTION_BLOCK Pump
                VAR
                    a : INT;
                END_VAR
                END_FUNCTION_BLOCK
                PROGRAM main
                VAR
                    b : INT;
                END_VAR
                END_PROGRAM
                ",
            fix: "Give one of them another name.",
            repaired: "
                FUNCTION Pressure : INT
                    Pressure := 0;
                END_FUNCTION
                FUNCTION_BLOCK Pump
                VAR
                    a : INT;
                END_VAR
                END_FUNCTION_BLOCK
                PROGRAM main
                VAR
                    b : INT;
                END_VAR
                END_PROGRAM
                ",
        }
        P4012 FunctionBlockNotInScope {
            summary: "what is invoked is no instance of a function block",
            explanation: "An invocation begins with the name of an instance: a variable whose type is a function block. The name of the \
                function block itself is not enough, for without an instance there is nothing that keeps its values.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    level : INT;
                END_VAR
                    level();
                END_PROGRAM
                ",
            fix: "Declare an instance, and invoke that.",
            repaired: "
                FUNCTION_BLOCK Level
                VAR
                    value : INT;
                END_VAR
                    value := value + 1;
                END_FUNCTION_BLOCK
                PROGRAM main
                VAR
                    tank : Level;
                END_VAR
                    tank();
                END_PROGRAM
                ",
        }
        P4013 PouDeclNameDuplicated {
            summary: "two program organization units of one kind have one name",
            explanation: "Two function blocks or two programs have the same name, in whatever case. For two functions the code is P4016; \
                for definitions of different kinds it is P4011.",
            example: IronplcEd2 "
                FUNCTION_BLOCK Pump
                VAR
                    a : INT;
                END_VAR
                END_FUNCTION_BLOCK
                FUNCTION_BLOCK Pump
                VAR
                    b : INT;
                END_VAR
                END_FUNCTION_BLOCK
                PROGRAM main
                VAR
                    pump_1 : Pump;
                END_VAR
                END_PROGRAM
                ",
            fix: "Give one of them another name.",
            repaired: "
                FUNCTION_BLOCK Pump
                VAR
                    a : INT;
                END_VAR
                END_FUNCTION_BLOCK
                FUNCTION_BLOCK Valve
                VAR
                    b : INT;
                END_VAR
                END_FUNCTION_BLOCK
                PROGRAM main
                VAR
                    pump_1 : Pump;
                END_VAR
                END_PROGRAM
                ",
        }
        P4014 SymbolDeclDuplicated {
            summary: "two variables have one name",
            explanation: "A name stands for one variable in its program organization unit, whichever block of variables declares it. \
                Case makes no difference.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    level : INT;
                    Level : REAL;
                END_VAR
                END_PROGRAM
                ",
            fix: "Give one of them another name.",
            repaired: "
                PROGRAM main
                VAR
                    level : INT;
                    limit : REAL;
                END_VAR
                END_PROGRAM
                ",
        }
        P4015 StdlibTypeRedefinition {
            summary: "the name belongs to a standard function block",
            explanation: "The standard defines function blocks such as TON, CTU, R_TRIG and SR. Some compilers keep their names for \
                them; Stickler's reference lets a program's own declaration win.",
            example: elsewhere "
                FUNCTION_BLOCK TON
                VAR_INPUT
                    a : INT;
                END_VAR
                END_FUNCTION_BLOCK
                PROGRAM main
                VAR
                    timer : TON;
                END_VAR
                END_PROGRAM
                ",
            fix: "Choose another name.",
            repaired: "
                FUNCTION_BLOCK Delay
                VAR_INPUT
                    a : INT;
                END_VAR
                END_FUNCTION_BLOCK
                PROGRAM main
                VAR
                    timer : Delay;
                END_VAR
                END_PROGRAM
                ",
        }
        P4016 FunctionDeclNameDuplicated {
            summary: "two functions have one name",
            explanation: "A program's own functions are not overloaded: other parameters or another result do not make a second function \
                of the same name possible.",
            example: IronplcEd2 "
                FUNCTION Double : INT
                VAR_INPUT
                    v : INT;
                END_VAR
                    Double := v + v;
                END_FUNCTION
                FUNCTION Double : REAL
                VAR_INPUT
                    v : REAL;
                END_VAR
                    Double := v + v;
                END_FUNCTION
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := 1;
                END_PROGRAM
                ",
            fix: "Give one of them another name.",
            repaired: "
                FUNCTION Double : INT
                VAR_INPUT
                    v : INT;
                END_VAR
                    Double := v + v;
                END_FUNCTION
                FUNCTION Double_real : REAL
                VAR_INPUT
                    v : REAL;
                END_VAR
                    Double_real := v + v;
                END_FUNCTION
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := 1;
                END_PROGRAM
                ",
        }
        P4017 FunctionCallUndeclared {
            summary: "the function is not declared",
            explanation: "Neither the source nor the standard library of the dialect has a function of that name. The name of a type \
                conversion function is made from two types that the dialect converts: INT_TO_REAL.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    a : INT;
                    b : REAL;
                END_VAR
                    b := INT_TO_RAEL(a);
                END_PROGRAM
                ",
            fix: "Declare the function, or correct its name.",
            repaired: "
                PROGRAM main
                VAR
                    a : INT;
                    b : REAL;
                END_VAR
                    b := INT_TO_REAL(a);
                END_PROGRAM
                ",
        }
        P4018 FunctionCallWrongArgCount {
            summary: "the call has the wrong number of arguments",
            explanation: "A function takes one argument for each of its parameters. Some standard functions, such as MAX, take any \
                number from two.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := ABS(a, a);
                END_PROGRAM
                ",
            fix: "Give as many arguments as there are parameters.",
            repaired: "
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := ABS(a);
                END_PROGRAM
                ",
        }
        P4019 DuplicateTaskName {
            summary: "two tasks of the resource have one name",
            explanation: "A program is tied to a task by the task's name, so that name may occur once in a resource.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := 1;
                END_PROGRAM
                CONFIGURATION plant
                    RESOURCE controller ON PLC
                        TASK cyclic(INTERVAL := T#10ms, PRIORITY := 1);
                        TASK cyclic(INTERVAL := T#20ms, PRIORITY := 2);
                        PROGRAM instance WITH cyclic : main;
                    END_RESOURCE
                END_CONFIGURATION
                ",
            fix: "Give one of them another name.",
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
                        TASK slow(INTERVAL := T#20ms, PRIORITY := 2);
                        PROGRAM instance WITH cyclic : main;
                    END_RESOURCE
                END_CONFIGURATION
                ",
        }
        P4020 NoProgramDeclaration {
            summary: "the source has no PROGRAM",
            explanation: "An execution begins with a program; functions and function blocks alone have nothing that calls them. They can \
                be checked without one.",
            example: elsewhere "
                FUNCTION Double : INT
                VAR_INPUT
                    v : INT;
                END_VAR
                    Double := v + v;
                END_FUNCTION
                ",
            fix: "Write a program that uses the units.",
            repaired: "
                FUNCTION Double : INT
                VAR_INPUT
                    v : INT;
                END_VAR
                    Double := v + v;
                END_FUNCTION
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := Double(21);
                END_PROGRAM
                ",
        }
        P4021 ExitOutsideLoop {
            summary: "EXIT stands outside a loop",
            explanation: "EXIT leaves the innermost FOR, WHILE or REPEAT around it, and here there is none. To leave a program \
                organization unit there is RETURN.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := 1;
                    EXIT;
                END_PROGRAM
                ",
            fix: "Write RETURN, or put the statement inside a loop.",
            repaired: "
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := 1;
                    RETURN;
                END_PROGRAM
                ",
        }
    } };
}
