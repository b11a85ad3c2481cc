//! The smoke set: questions so plain that every compiler of Structured Text gives the same answers.
//!
//! No question needs a particular dialect, and each answer follows from the standard or from the protocol alone. Where another
//! answer comes, the compiler is wrong, or its adapter does not report what the compiler does.

use crate::Ability;

/// One question, and the answer that must come back.
pub(super) struct SmokeQuestion {
    /// The rule that must hold, as a sentence without its full stop.
    pub(super) rule: &'static str,
    pub(super) ask: Ask,
    pub(super) expect: SmokeExpectation,
}

/// The request of a question.
pub(super) enum Ask {
    Check(&'static str),
    Run {
        source: &'static str,
        scans: u32,
        observe: &'static [SmokeVariable],
    },
    Render(&'static str),
    /// A check in a dialect that nobody speaks.
    NoDialect,
    /// A check with a key that no protocol has yet.
    FurtherKey,
    /// A line that is no request.
    Line(&'static str),
}

/// An observed variable: its name, its type, and the scan after which it is observed.
pub(super) type SmokeVariable = (&'static str, &'static str, Option<u32>);

/// The answer that must come back.
pub(super) enum SmokeExpectation {
    Accepted,
    /// A rejection; where a line is given, a diagnostic that names a line must name this one.
    Rejected(Option<u32>),
    /// The values, each as its key and a typed literal.
    Values(&'static [(&'static str, &'static str)]),
    /// Source text.
    Rendered,
    /// An error about this request alone, or that the request is not supported.
    Refused,
    /// An error that belongs to no request.
    Error,
}

impl SmokeQuestion {
    /// Returns the abilities that an engine needs to be asked this question.
    pub(super) fn needs(&self) -> &'static [Ability] {
        match self.ask {
            Ask::Run { scans: 1, .. } => &[Ability::Execute],
            Ask::Run { .. } => &[Ability::Execute, Ability::Scans],
            Ask::Render(_) => &[Ability::Render],
            Ask::Check(_) | Ask::NoDialect | Ask::FurtherKey => &[Ability::Check],
            Ask::Line(_) => &[],
        }
    }
}

pub(super) const PLAIN: &str = "PROGRAM main\nVAR\n    x : INT;\nEND_VAR\n    x := 1;\nEND_PROGRAM\n";

const UNDECLARED: &str = "PROGRAM main\nVAR\n    x : INT;\nEND_VAR\n    x := unknown;\nEND_PROGRAM\n";

/// Every question, in the order in which they are asked.
pub(super) const QUESTIONS: &[SmokeQuestion] = &[
    SmokeQuestion {
        rule: "`check` of a plain program is answered by `accepted`",
        ask: Ask::Check(PLAIN),
        expect: SmokeExpectation::Accepted,
    },
    SmokeQuestion {
        rule: "a variable that is not declared is rejected, on its line",
        ask: Ask::Check(UNDECLARED),
        expect: SmokeExpectation::Rejected(Some(5)),
    },
    SmokeQuestion {
        rule: "a statement that is not finished is rejected",
        ask: Ask::Check("PROGRAM main\nVAR\n    x : INT;\nEND_VAR\n    x := ;\nEND_PROGRAM\n"),
        expect: SmokeExpectation::Rejected(None),
    },
    SmokeQuestion {
        rule: "comments may have any characters, and none of them moves a line",
        ask: Ask::Check(
            "(* ä € 𝄞 \"quotes\" \\backslash *)\nPROGRAM main\nVAR\n    x : INT;\nEND_VAR\n    x := unknown;\nEND_PROGRAM\n",
        ),
        expect: SmokeExpectation::Rejected(Some(6)),
    },
    SmokeQuestion {
        rule: "a program after a rejected one is accepted",
        ask: Ask::Check(PLAIN),
        expect: SmokeExpectation::Accepted,
    },
    SmokeQuestion {
        rule: "`run` gives the value of a sum",
        ask: Ask::Run {
            source: "PROGRAM main\nVAR\n    x : INT := 2;\nEND_VAR\n    x := x + 3;\nEND_PROGRAM\n",
            scans: 1,
            observe: &[("x", "INT", None)],
        },
        expect: SmokeExpectation::Values(&[("x", "INT#5")]),
    },
    SmokeQuestion {
        rule: "`run` gives values of every kind, as typed literals",
        ask: Ask::Run {
            source: "PROGRAM main\nVAR\n    yes : BOOL := TRUE;\n    below : DINT := -100000;\n    bits : WORD := 16#00FF;\n    \
                     half : REAL := 0.5;\n    pause : TIME := T#1500ms;\nEND_VAR\n    yes := NOT yes;\nEND_PROGRAM\n",
            scans: 1,
            observe: &[
                ("yes", "BOOL", None),
                ("below", "DINT", None),
                ("bits", "WORD", None),
                ("half", "REAL", None),
                ("pause", "TIME", None),
            ],
        },
        expect: SmokeExpectation::Values(&[
            ("yes", "BOOL#FALSE"),
            ("below", "DINT#-100000"),
            ("bits", "WORD#16#00FF"),
            ("half", "REAL#0.5"),
            ("pause", "TIME#1500ms"),
        ]),
    },
    SmokeQuestion {
        rule: "a text keeps its quotes and blanks",
        ask: Ask::Run {
            source: "PROGRAM main\nVAR\n    s : STRING := 'it$'s  so';\n    n : INT;\nEND_VAR\n    n := 1;\nEND_PROGRAM\n",
            scans: 1,
            observe: &[("s", "STRING", None)],
        },
        expect: SmokeExpectation::Values(&[("s", "STRING#'it$'s  so'")]),
    },
    SmokeQuestion {
        rule: "an element of an array is observed by its path",
        ask: Ask::Run {
            source: "PROGRAM main\nVAR\n    a : ARRAY[1..3] OF INT;\nEND_VAR\n    a[2] := 7;\nEND_PROGRAM\n",
            scans: 1,
            observe: &[("a[2]", "INT", None), ("a[3]", "INT", None)],
        },
        expect: SmokeExpectation::Values(&[("a[2]", "INT#7"), ("a[3]", "INT#0")]),
    },
    SmokeQuestion {
        rule: "a variable keeps its value from scan to scan, and can be looked at after each",
        ask: Ask::Run {
            source: "PROGRAM main\nVAR\n    n : INT;\nEND_VAR\n    n := n + 1;\nEND_PROGRAM\n",
            scans: 3,
            observe: &[("n", "INT", None), ("n", "INT", Some(1))],
        },
        expect: SmokeExpectation::Values(&[("n", "INT#3"), ("n@1", "INT#1")]),
    },
    SmokeQuestion {
        rule: "`run` starts each program anew",
        ask: Ask::Run {
            source: "PROGRAM main\nVAR\n    n : INT;\nEND_VAR\n    n := n + 1;\nEND_PROGRAM\n",
            scans: 1,
            observe: &[("n", "INT", None)],
        },
        expect: SmokeExpectation::Values(&[("n", "INT#1")]),
    },
    SmokeQuestion {
        rule: "`run` of a program that must be rejected is answered by `rejected`",
        ask: Ask::Run {
            source: UNDECLARED,
            scans: 1,
            observe: &[("x", "INT", None)],
        },
        expect: SmokeExpectation::Rejected(Some(5)),
    },
    SmokeQuestion {
        rule: "a variable that is not there is refused, and no value is made up",
        ask: Ask::Run {
            source: PLAIN,
            scans: 1,
            observe: &[("nothing", "INT", None)],
        },
        expect: SmokeExpectation::Refused,
    },
    SmokeQuestion {
        rule: "`render` of a plain program is answered by `rendered`",
        ask: Ask::Render(PLAIN),
        expect: SmokeExpectation::Rendered,
    },
    SmokeQuestion {
        rule: "a dialect that it does not speak is refused, and its `id` repeated",
        ask: Ask::NoDialect,
        expect: SmokeExpectation::Refused,
    },
    SmokeQuestion {
        rule: "a key that it does not know is passed over",
        ask: Ask::FurtherKey,
        expect: SmokeExpectation::Accepted,
    },
    SmokeQuestion {
        rule: "a line that is no JSON is answered by `error`",
        ask: Ask::Line("this is no request"),
        expect: SmokeExpectation::Error,
    },
    SmokeQuestion {
        rule: "a request of no known type is answered by `error`",
        ask: Ask::Line("{\"type\":\"sing\",\"id\":1000000}"),
        expect: SmokeExpectation::Error,
    },
    SmokeQuestion {
        rule: "after such lines it lives on and answers the next request",
        ask: Ask::Check(PLAIN),
        expect: SmokeExpectation::Accepted,
    },
];
