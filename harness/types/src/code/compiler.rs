//! Codes of what a compiler cannot do, and Stickler's own.

macro_rules! compiler_codes {
    ($rest:tt $($entries:tt)*) => { gather! { $rest $($entries)*
        P9001 UnsupportedStdLibType {
            summary: "the standard type is not implemented",
            explanation: "The standard defines the type or function block, and the compiler does not have it. Stickler's reference has \
                none of the standard function blocks yet, and gives P2008 for them as for any type that is not declared.",
            example: elsewhere "
                PROGRAM main
                VAR
                    timer : TON;
                END_VAR
                    timer(IN := TRUE, PT := T#1s);
                END_PROGRAM
                ",
            fix: "Write a function block of your own under another name.",
        }
        P9997 NotSupported {
            summary: "the compiler does not offer this",
            explanation: "The program is right, but goes beyond a limit in the compiler's design, and there are no plans to change that. \
                Stickler's reference gives S0002 for its own limits.",
            example: elsewhere "
                PROGRAM main
                VAR
                    samples : ARRAY [1..100000] OF LREAL;
                END_VAR
                    samples[1] := 0.5;
                END_PROGRAM
                ",
            fix: "Divide what is too large.",
        }
        P9998 InternalError {
            summary: "the compiler has a defect",
            explanation: "The compiler found itself in a state that it was not made for. That says nothing about the program; the suite \
                counts it as a crash rather than a rejection.",
            example: elsewhere "
                PROGRAM main
                VAR
                    a : INT;
                END_VAR
                    a := 1;
                END_PROGRAM
                ",
            fix: "Report the program to the makers of the compiler.",
        }
        P9999 NotImplemented {
            summary: "this part of the language is not implemented",
            explanation: "The construct belongs to the language, and the compiler does not have it yet. Stickler's reference gives this \
                code for what it leaves out, such as classes, methods, references, located variables and the other languages of the \
                standard; it skips the construct and goes on.",
            example: IronplcEd3 "
                PROGRAM main
                VAR
                    r : REF_TO INT;
                END_VAR
                END_PROGRAM
                ",
            fix: "Write the program without the construct.",
            repaired: "
                PROGRAM main
                VAR
                    r : INT;
                END_VAR
                END_PROGRAM
                ",
        }
        S0001 AssignmentToConstant {
            summary: "a constant cannot be assigned",
            explanation: "A variable that is declared CONSTANT keeps the value of its declaration. It can be neither assigned, nor count \
                a FOR loop, nor receive an output.",
            example: IronplcEd2 "
                PROGRAM main
                VAR CONSTANT
                    limit : INT := 17;
                END_VAR
                    limit := 18;
                END_PROGRAM
                ",
            fix: "Declare the variable in a block without CONSTANT.",
            repaired: "
                PROGRAM main
                VAR
                    limit : INT := 17;
                END_VAR
                    limit := 18;
                END_PROGRAM
                ",
        }
        S0002 LimitExceeded {
            summary: "the source exceeds a limit of the reference",
            explanation: "The reference reads sources of up to 64 MiB that nest up to 200 deep and need up to four million cells of memory \
                in all, so that no source can exhaust the machine. One array that is too large by itself is P2023.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    a : ARRAY [1..4000000] OF INT;
                    b : ARRAY [1..4000000] OF INT;
                END_VAR
                    a[1] := b[1];
                END_PROGRAM
                ",
            fix: "Make the program smaller.",
            repaired: "
                PROGRAM main
                VAR
                    a : ARRAY [1..400] OF INT;
                    b : ARRAY [1..400] OF INT;
                END_VAR
                    a[1] := b[1];
                END_PROGRAM
                ",
        }
    } };
}
