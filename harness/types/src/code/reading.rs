//! Codes of reading a source: characters, tokens and the grammar.

macro_rules! reading_codes {
    ($rest:tt $($entries:tt)*) => { gather! { $rest $($entries)*
        P0001 OpenComment {
            summary: "the comment is not closed",
            explanation: "A comment begins with `(*` and goes on to the next `*)`, over as many lines as it likes. Here the file \
                ends first, so everything behind the opening is lost. The diagnostic stands where the comment opens, for the \
                place where it should have closed cannot be known.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    level : INT;
                END_VAR
                    level := 5; (* the tank is half full
                END_PROGRAM
                ",
            fix: "Close the comment with `*)`. If comments stand inside one another, see whether the dialect lets them nest.",
            repaired: "
                PROGRAM main
                VAR
                    level : INT;
                END_VAR
                    level := 5; (* the tank is half full *)
                END_PROGRAM
                ",
        }
        P0002 SyntaxError {
            summary: "the source does not follow the grammar",
            explanation: "At this place the grammar wants something else: often the semicolon that ends the statement before, a \
                missing `THEN` or `DO`, or an `END_…` that does not match what it is to end. What a dialect does not have in its \
                grammar at all, such as bit access in matiec, is a syntax error too.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    a : INT;
                    b : INT;
                END_VAR
                    a := 1
                    b := 2;
                END_PROGRAM
                ",
            fix: "Look at the place that the diagnostic names and at the token before it, and put in what is missing.",
            repaired: "
                PROGRAM main
                VAR
                    a : INT;
                    b : INT;
                END_VAR
                    a := 1;
                    b := 2;
                END_PROGRAM
                ",
        }
        P0003 UnexpectedToken {
            summary: "the characters form no token",
            explanation: "No keyword, name, literal or operator begins like this. The code is also the answer to `.%B`, `.%W`, `.%D` \
                and `.%L` where partial access is enabled but knows single bits only, and to bytes that are not UTF-8. Nothing else \
                is said about the same construct.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    speed : INT;
                END_VAR
                    speed := 10 ? 3;
                END_PROGRAM
                ",
            fix: "Remove the characters, or write the operator that Structured Text has for the purpose.",
            repaired: "
                PROGRAM main
                VAR
                    speed : INT;
                END_VAR
                    speed := 10 MOD 3;
                END_PROGRAM
                ",
        }
        P0004 CStyleComment {
            summary: "comments that begin with `//` are not enabled",
            explanation: "The second edition of the standard has `(* … *)` only; the third added `//` to the end of the line. \
                The dialects `ironplc-rusty` and `plcnext` read it, the others do not.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    level : INT;
                END_VAR
                    level := 5; // half full
                END_PROGRAM
                ",
            fix: "Write the comment between `(*` and `*)`, or choose a dialect that has comments to the end of the line.",
            repaired: "
                PROGRAM main
                VAR
                    level : INT;
                END_VAR
                    level := 5; (* half full *)
                END_PROGRAM
                ",
        }
        P0005 UnexpectedElement {
            summary: "the element is not permitted here",
            explanation: "The element is well formed, but not at this place: a statement among declarations, or a declaration among \
                statements. Stickler's reference calls this a syntax error, P0002; other compilers tell the two apart.",
            example: elsewhere "
                TYPE
                    Tank : STRUCT
                        level : INT;
                        level := level + 1;
                    END_STRUCT;
                END_TYPE
                PROGRAM main
                VAR
                    tank : Tank;
                END_VAR
                    tank.level := 1;
                END_PROGRAM
                ",
            fix: "Move the element to where it belongs: statements stand in the body of a program organization unit.",
        }
        P0010 Std2013Feature {
            summary: "the feature needs the third edition of the standard",
            explanation: "The third edition of IEC 61131-3, of 2013, added types (`LTIME`, `LDATE`, `LTOD`, `LDT`, `CHAR`, `WCHAR`) \
                and other language. The dialect follows the second edition and knows the name only to say so. Nothing else is said \
                about the same construct.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    pause : LTIME;
                END_VAR
                END_PROGRAM
                ",
            fix: "Use a type of the second edition, or a dialect of the third.",
            repaired: "
                PROGRAM main
                VAR
                    pause : TIME;
                END_VAR
                END_PROGRAM
                ",
        }
        P0011 EmptyVarBlock {
            summary: "the block of variables declares nothing",
            explanation: "By the grammar of the standard a block such as `VAR … END_VAR` holds at least one declaration. Generated \
                sources often have empty ones, and many compilers can be told to let them pass. Stickler's reference does so always.",
            example: elsewhere "
                PROGRAM main
                VAR
                END_VAR
                END_PROGRAM
                ",
            fix: "Remove the empty block.",
            repaired: "
                PROGRAM main
                VAR
                    unused : BOOL;
                END_VAR
                END_PROGRAM
                ",
        }
        P0012 InvalidStringEscape {
            summary: "the string has an escape that does not exist",
            explanation: "In a character string a dollar sign begins an escape: `$$`, `$'`, `$\"`, `$L`, `$N`, `$P`, `$R`, `$T`, or the \
                code of a character with two hexadecimal digits in single quotes and four in double quotes. Anything else stands for \
                no character.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    price : STRING;
                END_VAR
                    price := '$5';
                END_PROGRAM
                ",
            fix: "Write a dollar sign that means itself as `$$`, and give the code of a character all its digits.",
            repaired: "
                PROGRAM main
                VAR
                    price : STRING;
                END_VAR
                    price := '$$5';
                END_PROGRAM
                ",
        }
    } };
}
