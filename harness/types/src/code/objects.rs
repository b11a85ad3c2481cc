//! Codes of what is passed by reference, of loops and conditions, and of parts of a value.

macro_rules! object_codes {
    ($rest:tt $($entries:tt)*) => { gather! { $rest $($entries)*
        P4058 FunctionCallInOutArgNotVariable {
            summary: "the VAR_IN_OUT argument is no variable",
            explanation: "What is passed to a VAR_IN_OUT can be changed by the unit that is called, so it must be a variable: a literal or \
                the value of an expression has no place to write to.",
            example: IronplcEd2 "
                FUNCTION Increment : INT
                VAR_IN_OUT
                    counter : INT;
                END_VAR
                    counter := counter + 1;
                    Increment := counter;
                END_FUNCTION
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := Increment(a + 1);
                END_PROGRAM
                ",
            fix: "Pass a variable.",
            repaired: "
                FUNCTION Increment : INT
                VAR_IN_OUT
                    counter : INT;
                END_VAR
                    counter := counter + 1;
                    Increment := counter;
                END_FUNCTION
                PROGRAM main
                VAR
                    a : INT;
                    b : INT;
                END_VAR
                    b := Increment(a);
                END_PROGRAM
                ",
        }
        P4059 FunctionCallInOutArgTypeMismatch {
            summary: "the VAR_IN_OUT argument is of another type",
            explanation: "The unit that is called works on the caller's variable itself, so nothing is converted, not even where a value \
                would widen.",
            example: IronplcEd2 "
                FUNCTION Increment : DINT
                VAR_IN_OUT
                    counter : DINT;
                END_VAR
                    counter := counter + 1;
                    Increment := counter;
                END_FUNCTION
                PROGRAM main
                VAR
                    a : INT;
                    b : DINT;
                END_VAR
                    b := Increment(a);
                END_PROGRAM
                ",
            fix: "Declare the variable with the type of the parameter.",
            repaired: "
                FUNCTION Increment : DINT
                VAR_IN_OUT
                    counter : DINT;
                END_VAR
                    counter := counter + 1;
                    Increment := counter;
                END_FUNCTION
                PROGRAM main
                VAR
                    a : DINT;
                    b : DINT;
                END_VAR
                    b := Increment(a);
                END_PROGRAM
                ",
        }
        P4060 InOutArgNotWritable {
            summary: "the VAR_IN_OUT argument cannot be written",
            explanation: "The unit that is called may write what is passed to a VAR_IN_OUT, and this variable must not change.",
            example: IronplcEd2 "
                FUNCTION Increment : INT
                VAR_IN_OUT
                    counter : INT;
                END_VAR
                    counter := counter + 1;
                    Increment := counter;
                END_FUNCTION
                PROGRAM main
                VAR CONSTANT
                    start : INT := 5;
                END_VAR
                VAR
                    a : INT;
                END_VAR
                    a := Increment(start);
                END_PROGRAM
                ",
            fix: "Copy the value into a variable, and pass that.",
            repaired: "
                FUNCTION Increment : INT
                VAR_IN_OUT
                    counter : INT;
                END_VAR
                    counter := counter + 1;
                    Increment := counter;
                END_FUNCTION
                PROGRAM main
                VAR CONSTANT
                    start : INT := 5;
                END_VAR
                VAR
                    a : INT;
                    current : INT;
                END_VAR
                    current := start;
                    a := Increment(current);
                END_PROGRAM
                ",
        }
        P4062 MemberQualifierNotAllowed {
            summary: "qualifiers of a function block are not enabled",
            explanation: "PUBLIC, FINAL, ABSTRACT and their like belong to the object orientation of the third edition. Stickler's \
                reference does not have it: it answers P9999.",
            example: elsewhere "
                FUNCTION_BLOCK FINAL Motor
                VAR
                    speed : INT;
                END_VAR
                END_FUNCTION_BLOCK
                PROGRAM main
                VAR
                    motor_1 : Motor;
                END_VAR
                    motor_1();
                END_PROGRAM
                ",
            fix: "Leave the qualifier out.",
        }
        P4063 MemberQualifierInvalid {
            summary: "the qualifiers contradict each other",
            explanation: "A qualifier stands twice, two of them exclude each other, or one stands where it means nothing. Stickler's \
                reference has no object orientation: it answers P9999.",
            example: elsewhere "
                FUNCTION_BLOCK ABSTRACT FINAL Motor
                VAR
                    speed : INT;
                END_VAR
                END_FUNCTION_BLOCK
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := 1;
                END_PROGRAM
                ",
            fix: "Keep one of the qualifiers.",
        }
        P4065 ContinueOutsideLoop {
            summary: "CONTINUE stands outside a loop",
            explanation: "CONTINUE goes on with the next turn of the innermost FOR, WHILE or REPEAT around it, and here there is none.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := 1;
                    CONTINUE;
                END_PROGRAM
                ",
            fix: "Put the statement inside a loop, or remove it.",
            repaired: "
                PROGRAM main
                VAR
                    a : INT;
                    odd : INT;
                END_VAR
                    FOR a := 1 TO 10 DO
                        IF a MOD 2 = 0 THEN
                            CONTINUE;
                        END_IF;
                        odd := odd + 1;
                    END_FOR;
                END_PROGRAM
                ",
        }
        P4069 BitAccessTypeInvalid {
            summary: "the type has no bits to access",
            explanation: "Single bits are taken out of bit strings and integers. A BOOL is one bit as a whole; reals, times, dates, texts, \
                arrays and structures have none. Where the type has bits, but not this one, the code is P4025.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    level : REAL;
                    a : BOOL;
                END_VAR
                    a := level.3;
                END_PROGRAM
                ",
            fix: "Convert the value to a bit string or integer first, or access an element or field that is one.",
            repaired: "
                PROGRAM main
                VAR
                    level : REAL;
                    whole : DINT;
                    a : BOOL;
                END_VAR
                    whole := REAL_TO_DINT(level);
                    a := whole.3;
                END_PROGRAM
                ",
        }
        P4072 ConditionTypeInvalid {
            summary: "the condition is not BOOL",
            explanation: "IF, WHILE and REPEAT decide by a BOOL; no number and no bit string converts to one by itself.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    level : INT;
                    alarm : BOOL;
                END_VAR
                    IF level THEN
                        alarm := TRUE;
                    END_IF;
                END_PROGRAM
                ",
            fix: "Compare the value.",
            repaired: "
                PROGRAM main
                VAR
                    level : INT;
                    alarm : BOOL;
                END_VAR
                    IF level <> 0 THEN
                        alarm := TRUE;
                    END_IF;
                END_PROGRAM
                ",
        }
    } };
}
