//! The diagnostic codes: their numbers, their names and the page of each in `harness/types/codes`.

/// Generates the enumeration of the codes and the list of their entries from one line for each code.
macro_rules! codes {
    ($($code:ident $name:ident,)*) => {
        /// A kind of diagnostic, in the order of the codes.
        ///
        /// Basis: ironplc-problem-codes, whose numbers, names and meanings these are; codes that begin with `S` are Stickler's own.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        pub enum Code {
            $(
                #[doc = include_str!(concat!("../../codes/", stringify!($code), ".md"))]
                $name,
            )*
        }

        impl Code {
            /// Every code, in order.
            pub const ALL: &'static [Code] = &[$(Code::$name,)*];
        }

        /// The entry of each code, in the order of [`Code::ALL`].
        pub(super) const ENTRIES: &[CodeEntry] = &[$(CodeEntry {
            code: stringify!($code),
            name: stringify!($name),
            page: include_str!(concat!("../../codes/", stringify!($code), ".md")),
        },)*];
    };
}

/// One line of the table of codes.
pub(super) struct CodeEntry {
    /// The number, such as `P4035`.
    pub code: &'static str,
    /// The name, such as `AssignmentTypeMismatch`.
    pub name: &'static str,
    /// The text of the code's Markdown file.
    pub page: &'static str,
}

codes! {
    C0195 SignedToUnsigned,
    C0196 UnsignedToSigned,
    C0197 LossOfInformation,
    E067 ImplicitDowncast,
    P0001 OpenComment,
    P0002 SyntaxError,
    P0003 UnexpectedToken,
    P0004 CStyleComment,
    P0005 UnexpectedElement,
    P0010 Std2013Feature,
    P0011 EmptyVarBlock,
    P0012 InvalidStringEscape,
    P2001 StructureDuplicatedElement,
    P2002 SubrangeMinStrictlyLessMax,
    P2003 EnumTypeDeclDuplicateItem,
    P2004 EnumNotDeclared,
    P2005 EnumRecursive,
    P2006 EnumValueNotDefined,
    P2007 TypeDeclNameDuplicated,
    P2008 UndeclaredUnknownType,
    P2009 ParentEnumNotDeclared,
    P2010 RecursiveTypeCycle,
    P2011 ParentTypeNotDeclared,
    P2012 AliasParentTypeNotDeclared,
    P2013 ArrayElementTypeNotDeclared,
    P2014 SimpleTypeDeclMissingInit,
    P2015 SubrangeBaseTypeNotNumeric,
    P2016 SubrangeOutOfBounds,
    P2017 StructFieldMissingType,
    P2019 InvalidSimpleTypeDecl,
    P2020 EnumerationTooManyValues,
    P2021 StructFieldTypeNotDeclared,
    P2022 ArrayDimensionEmpty,
    P2023 ArraySizeOverflow,
    P2024 ArrayDimensionInvalid,
    P2025 TypeEnvironmentUnknownType,
    P2026 ConstantOverflow,
    P2027 ArrayIndexOutOfBounds,
    P2028 RefOperandNotVariable,
    P2029 RefOfEphemeralVariable,
    P2030 RefOfArrayElement,
    P2031 DerefRequiresReferenceType,
    P2032 ReferenceTypeMismatch,
    P2033 ArithmeticOnReference,
    P2034 NullRequiresReferenceType,
    P2035 OrderingOnReference,
    P2036 NestedRefToNotSupported,
    P2037 AggregateAssignmentTypeMismatch,
    P2038 DateLiteralOutOfRange,
    P2039 DurationLiteralOutOfRange,
    P2040 RealLiteralOutOfRange,
    P2041 StringLengthOutOfRange,
    P2042 ReturnTypeNotDeclared,
    P2043 EnumValueAmbiguous,
    P4001 FunctionCallMixedArgTypes,
    P4002 FunctionInvocationMissingInput,
    P4003 FunctionInvocationRequiresFormal,
    P4004 FunctionInvocationUndefinedOutput,
    P4005 RecursiveCycle,
    P4006 ProgramMissingTaskConfig,
    P4007 VariableUndefined,
    P4008 ConstantMustHaveInitializer,
    P4009 FunctionBlockNotConstant,
    P4010 VariableMustBeConst,
    P4011 DefinitionNameDuplicated,
    P4012 FunctionBlockNotInScope,
    P4013 PouDeclNameDuplicated,
    P4014 SymbolDeclDuplicated,
    P4015 StdlibTypeRedefinition,
    P4016 FunctionDeclNameDuplicated,
    P4017 FunctionCallUndeclared,
    P4018 FunctionCallWrongArgCount,
    P4019 DuplicateTaskName,
    P4020 NoProgramDeclaration,
    P4021 ExitOutsideLoop,
    P4022 InitializerTypeMismatch,
    P4023 FunctionCallNamedArgUndeclared,
    P4024 FunctionCallDuplicateNamedArg,
    P4025 BitAccessOutOfRange,
    P4026 FunctionCallArgTypeMismatch,
    P4027 FunctionCallReturnTypeMismatch,
    P4028 TopLevelVarGlobalNotAllowed,
    P4029 ConstantTypeParamNotAllowed,
    P4030 UndefinedConstantReference,
    P4031 ConstantNotIntegerType,
    P4032 ConstantMissingInitializer,
    P4033 PartialAccessSyntaxDisabled,
    P4034 StringEncodingMismatch,
    P4035 AssignmentTypeMismatch,
    P4036 MixedLocatedVarDeclarationNotAllowed,
    P4037 ConstantInitializerExpressionNotAllowed,
    P4038 InitializerNotConstantExpression,
    P4039 ConstantExpressionDivisionByZero,
    P4040 ConstantExpressionOverflow,
    P4041 BitStringCaseLabelNotAllowed,
    P4042 ParenStringLengthNotAllowed,
    P4043 StructInitializerExpressionNotAllowed,
    P4044 ExtendsFieldNameDuplicated,
    P4045 AbstractFunctionBlockInstantiated,
    P4046 MethodNotFound,
    P4047 TaskSingleNotSupported,
    P4048 TaskParameterOutOfRange,
    P4049 OperatorOperandTypeMismatch,
    P4050 ProgramVariableHidesGlobal,
    P4051 CaseLabelRangeInvalid,
    P4052 StringLiteralCharOutOfRange,
    P4053 CaseSelectorTypeInvalid,
    P4054 FunctionBlockInFunction,
    P4055 EnumExplicitValueNotAllowed,
    P4056 EnumBaseTypeNotAllowed,
    P4057 MethodCallWithoutReturnValue,
    P4058 FunctionCallInOutArgNotVariable,
    P4059 FunctionCallInOutArgTypeMismatch,
    P4060 InOutArgNotWritable,
    P4062 MemberQualifierNotAllowed,
    P4063 MemberQualifierInvalid,
    P4065 ContinueOutsideLoop,
    P4069 BitAccessTypeInvalid,
    P4072 ConditionTypeInvalid,
    P9001 UnsupportedStdLibType,
    P9997 NotSupported,
    P9998 InternalError,
    P9999 NotImplemented,
    S0001 AssignmentToConstant,
    S0002 LimitExceeded,
    S0003 NarrowingConversion,
    S0010 InterfaceMemberMissing,
    S0011 InheritanceInvalid,
    S0012 MemberNotAccessible,
}
