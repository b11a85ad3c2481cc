//! Codes of declaring types: their names, and what they are made from.

macro_rules! type_declaration_codes {
    ($rest:tt $($entries:tt)*) => { gather! { $rest $($entries)*
        P2001 StructureDuplicatedElement {
            summary: "the structure has two elements of one name",
            explanation: "An element of a structure is reached by its name, so each name may occur once. Case makes no difference: \
                `Level` and `LEVEL` are the same.",
            example: IronplcEd2 "
                TYPE
                    Tank : STRUCT
                        level : INT;
                        Level : REAL;
                    END_STRUCT;
                END_TYPE
                PROGRAM main
                VAR
                    tank_1 : Tank;
                END_VAR
                END_PROGRAM
                ",
            fix: "Give one of the elements another name.",
            repaired: "
                TYPE
                    Tank : STRUCT
                        level : INT;
                        limit : REAL;
                    END_STRUCT;
                END_TYPE
                PROGRAM main
                VAR
                    tank_1 : Tank;
                END_VAR
                END_PROGRAM
                ",
        }
        P2002 SubrangeMinStrictlyLessMax {
            summary: "the subrange does not ascend",
            explanation: "A subrange is written with its lower limit first. Limits that are equal or the wrong way round leave \
                nothing to choose from, which is taken for a mistake.",
            example: IronplcEd2 "
                TYPE
                    Percent : INT (100..0);
                END_TYPE
                PROGRAM main
                VAR
                    valve : Percent;
                END_VAR
                END_PROGRAM
                ",
            fix: "Write the lower limit first.",
            repaired: "
                TYPE
                    Percent : INT (0..100);
                END_TYPE
                PROGRAM main
                VAR
                    valve : Percent;
                END_VAR
                END_PROGRAM
                ",
        }
        P2003 EnumTypeDeclDuplicateItem {
            summary: "the enumeration has two values of one name",
            explanation: "The values of an enumeration are told apart by their names alone, so each name may occur once in it, in \
                whatever case. Two enumerations may well have a value of the same name: then its type goes in front, `Color#Red`.",
            example: IronplcEd2 "
                TYPE
                    Color : (Red, Green, Red);
                END_TYPE
                PROGRAM main
                VAR
                    lamp : Color;
                END_VAR
                END_PROGRAM
                ",
            fix: "Remove the second one, or give it another name.",
            repaired: "
                TYPE
                    Color : (Red, Green, Blue);
                END_TYPE
                PROGRAM main
                VAR
                    lamp : Color;
                END_VAR
                END_PROGRAM
                ",
        }
        P2004 EnumNotDeclared {
            summary: "the type is no enumeration",
            explanation: "A literal such as `Color#Red` names an enumeration and one of its values. Here the name before the `#` \
                belongs to no enumeration.",
            example: IronplcEd2 "
                TYPE
                    Color : (Red, Green);
                END_TYPE
                PROGRAM main
                VAR
                    lamp : Color;
                END_VAR
                    lamp := Colour#Red;
                END_PROGRAM
                ",
            fix: "Write the name of the enumeration as it is declared.",
            repaired: "
                TYPE
                    Color : (Red, Green);
                END_TYPE
                PROGRAM main
                VAR
                    lamp : Color;
                END_VAR
                    lamp := Color#Red;
                END_PROGRAM
                ",
        }
        P2005 EnumRecursive {
            summary: "the enumeration is declared by itself",
            explanation: "An enumeration that is an alias of itself, directly or by way of others, never comes to any values. \
                Stickler's reference makes no difference between kinds of types here and gives P2010.",
            example: elsewhere "
                TYPE
                    Color : Paint;
                    Paint : Color;
                END_TYPE
                PROGRAM main
                VAR
                    lamp : Color;
                END_VAR
                END_PROGRAM
                ",
            fix: "List the values in one of the declarations.",
            repaired: "
                TYPE
                    Color : Paint;
                    Paint : (Red, Green);
                END_TYPE
                PROGRAM main
                VAR
                    lamp : Color;
                END_VAR
                END_PROGRAM
                ",
        }
        P2006 EnumValueNotDefined {
            summary: "the enumeration has no such value",
            explanation: "The enumeration is known, but the value is not among those that its declaration lists.",
            example: IronplcEd2 "
                TYPE
                    Color : (Red, Green);
                END_TYPE
                PROGRAM main
                VAR
                    lamp : Color;
                END_VAR
                    lamp := Color#Blue;
                END_PROGRAM
                ",
            fix: "Use a value of the enumeration, or add the value to its declaration.",
            repaired: "
                TYPE
                    Color : (Red, Green, Blue);
                END_TYPE
                PROGRAM main
                VAR
                    lamp : Color;
                END_VAR
                    lamp := Color#Blue;
                END_PROGRAM
                ",
        }
        P2007 TypeDeclNameDuplicated {
            summary: "two types have one name",
            explanation: "The name of a type stands for one declaration in the whole program. Case makes no difference.",
            example: IronplcEd2 "
                TYPE
                    Level : INT;
                    LEVEL : REAL;
                END_TYPE
                PROGRAM main
                VAR
                    tank : Level;
                END_VAR
                END_PROGRAM
                ",
            fix: "Give one of the types another name.",
            repaired: "
                TYPE
                    Level : INT;
                    Pressure : REAL;
                END_TYPE
                PROGRAM main
                VAR
                    tank : Level;
                END_VAR
                END_PROGRAM
                ",
        }
        P2008 UndeclaredUnknownType {
            summary: "the type is not declared",
            explanation: "The name is neither that of an elementary type nor of a declared type or function block. Stickler's reference \
                gives this code wherever a type is wanted; other compilers have codes of their own for parents, elements, fields \
                and results.",
            example: IronplcEd2 "
                PROGRAM main
                VAR
                    tank : Reservoir;
                END_VAR
                END_PROGRAM
                ",
            fix: "Declare the type, or correct its name.",
            repaired: "
                TYPE
                    Reservoir : STRUCT
                        level : INT;
                    END_STRUCT;
                END_TYPE
                PROGRAM main
                VAR
                    tank : Reservoir;
                END_VAR
                END_PROGRAM
                ",
        }
        P2009 ParentEnumNotDeclared {
            summary: "the enumeration's parent is not declared",
            explanation: "An enumeration is declared by the name of another that does not exist. Stickler's reference gives P2008 for \
                every type that is not declared.",
            example: elsewhere "
                TYPE
                    Lamp : Color := Red;
                END_TYPE
                PROGRAM main
                VAR
                    lamp_1 : Lamp;
                END_VAR
                END_PROGRAM
                ",
            fix: "Declare the parent.",
            repaired: "
                TYPE
                    Color : (Red, Green);
                    Lamp : Color := Red;
                END_TYPE
                PROGRAM main
                VAR
                    lamp_1 : Lamp;
                END_VAR
                END_PROGRAM
                ",
        }
        P2010 RecursiveTypeCycle {
            summary: "the type contains itself",
            explanation: "A type that has itself as a part, or as its alias, directly or by way of other types, would never end. \
                Without references there is no such type.",
            example: IronplcEd2 "
                TYPE
                    Node : STRUCT
                        value : INT;
                        next : Node;
                    END_STRUCT;
                END_TYPE
                PROGRAM main
                VAR
                    first : Node;
                END_VAR
                END_PROGRAM
                ",
            fix: "Break the circle: hold the parts in an array, and let an index name the next.",
            repaired: "
                TYPE
                    Node : STRUCT
                        value : INT;
                        next : INT;
                    END_STRUCT;
                END_TYPE
                PROGRAM main
                VAR
                    nodes : ARRAY [1..10] OF Node;
                END_VAR
                END_PROGRAM
                ",
        }
        P2011 ParentTypeNotDeclared {
            summary: "the parent type is not declared",
            explanation: "A type is derived from another that does not exist. Stickler's reference gives P2008 for every type that is \
                not declared.",
            example: elsewhere "
                TYPE
                    Level : Measure;
                END_TYPE
                PROGRAM main
                VAR
                    tank : Level;
                END_VAR
                END_PROGRAM
                ",
            fix: "Declare the parent, or derive the type from an elementary one.",
            repaired: "
                TYPE
                    Measure : INT;
                    Level : Measure;
                END_TYPE
                PROGRAM main
                VAR
                    tank : Level;
                END_VAR
                END_PROGRAM
                ",
        }
        P2012 AliasParentTypeNotDeclared {
            summary: "the type that the alias stands for is not declared",
            explanation: "An alias gives a second name to a type, and here there is no first. Stickler's reference gives P2008 for \
                every type that is not declared.",
            example: elsewhere "
                TYPE
                    Speed : Velocity;
                END_TYPE
                PROGRAM main
                VAR
                    belt : Speed;
                END_VAR
                END_PROGRAM
                ",
            fix: "Declare the other type, or use an elementary one.",
            repaired: "
                TYPE
                    Speed : REAL;
                END_TYPE
                PROGRAM main
                VAR
                    belt : Speed;
                END_VAR
                END_PROGRAM
                ",
        }
    } };
}
