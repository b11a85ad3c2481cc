//! The state of the generator: the program so far, the POU under construction, and the rest of the budget.

use super::GeneratorSettings;
use super::constructs::{Construct, ConstructSet, palette};
use super::profile::DialectProfile;
use super::scope::PouScope;
use crate::model::{Program, VariableId};
use crate::random::Random;
use arbitrary::Unstructured;
use stickler_types::{DialectName, ElementaryType};

/// Generates a program from bytes. It never fails: when the bytes run out, it ends quickly with the simplest choices. About
/// 2000 bytes are enough for the largest programs.
///
/// The program is well-typed in its dialect, terminates after a few thousand statements, and uses nothing that documents
/// leave open, as far as that can be known without running it; [`GeneratorSettings::open`] lifts the last restriction.
pub fn program(bytes: &[u8], settings: &GeneratorSettings) -> Program {
    let mut input = Unstructured::new(bytes);
    let mut builder = ProgramBuilder::new(Random::new(&mut input), settings);
    builder.declare_types();
    builder.functions();
    builder.standard_blocks();
    builder.blocks();
    builder.main();
    let ProgramBuilder { mut program, pou, .. } = builder;
    program.main.variables = pou.variables;
    program
}

/// The state of the generation of one program.
pub(super) struct ProgramBuilder<'r, 'u> {
    pub random: Random<'r, 'u>,
    pub profile: &'static DialectProfile,
    pub open: bool,
    /// What the dialect or the settings lack, in the words of [`GeneratorSettings::lacking`].
    pub lacking: Vec<String>,
    pub constructs: ConstructSet,
    /// The types that variables have.
    pub palette: Vec<ElementaryType>,
    /// The maximum number of levels of an expression.
    pub deepest: usize,
    /// The program so far; `PROGRAM main` is added last.
    pub program: Program,
    /// The cost of a call of each function, and of each function block, in executed statements.
    pub function_costs: Vec<u32>,
    pub block_costs: Vec<u32>,
    /// The POU under construction.
    pub pou: PouScope,
    /// Whether the POU is the main program.
    pub is_main: bool,
    /// The number of statements that the POU may still get.
    pub statements_left: usize,
    /// The number of nodes that the statement may still get.
    pub nodes_left: usize,
    /// The bound of the variables that texts may be read from: only earlier ones, so that no text grows by going around in a
    /// loop, because no document states how long a text may be.
    pub text_bound: VariableId,
}

/// The maximum number of statements that a program executes, counted as if every branch were taken.
pub(super) const MAX_EXECUTED_STATEMENTS: u32 = 6000;

impl<'r, 'u> ProgramBuilder<'r, 'u> {
    fn new(mut random: Random<'r, 'u>, settings: &GeneratorSettings) -> ProgramBuilder<'r, 'u> {
        let dialect = settings.dialect.unwrap_or_else(|| {
            let chosen = random.pick(&DialectName::ALL).copied();
            chosen.unwrap_or(DialectName::IRONPLC_ED2)
        });
        let profile = DialectProfile::of(dialect);
        let lacking = [&settings.lacking[..], &dialect.rules().features.lacks].concat();
        let lacks = |word: &str| is_in(&lacking, word);
        let constructs = ConstructSet::drawn(&mut random).without(&lacks);
        let palette = palette(profile, &mut random, &lacks);
        let deepest = if constructs.has(Construct::Deep) {
            random.between(3, 8) as usize
        } else {
            2
        };
        ProgramBuilder {
            random,
            profile,
            open: settings.open,
            constructs,
            palette,
            lacking,
            deepest,
            program: Program::empty(dialect),
            function_costs: Vec::new(),
            block_costs: Vec::new(),
            pou: PouScope::new(),
            is_main: false,
            statements_left: 0,
            nodes_left: 0,
            text_bound: VariableId(0),
        }
    }

    /// Returns whether the program may use a construct.
    pub const fn has(&self, feature: Construct) -> bool {
        self.constructs.has(feature)
    }

    /// Returns whether the program shall do without this, a word of [`GeneratorSettings::lacking`].
    pub fn lacks(&self, word: &str) -> bool {
        is_in(&self.lacking, word)
    }

    /// Picks one of the types that the program uses.
    pub fn any_type(&mut self) -> ElementaryType {
        self.random
            .pick(&self.palette)
            .copied()
            .unwrap_or(ElementaryType::Int)
    }

    /// Picks a type that the program uses, preferably one of a variable in scope.
    pub fn seen_type(&mut self) -> ElementaryType {
        let first = self.any_type();
        if self.pou.varies(first) {
            first
        } else {
            self.any_type()
        }
    }

    /// Returns whether the POU may execute `cost` more statements at the current position.
    pub const fn affords(&self, cost: u32) -> bool {
        self.pou.cost + self.pou.turns * cost <= MAX_EXECUTED_STATEMENTS
    }

    /// Adds the cost of an execution at the current position.
    pub const fn spend(&mut self, cost: u32) {
        self.pou.cost += self.pou.turns * cost;
    }

    fn main(&mut self) {
        // Programs of very different lengths: a short one shows a fault clearly, a long one meets more of them.
        let most = [3, 6, 12, 24, 60][self.random.below(5)];
        self.begin(most);
        self.is_main = true;
        self.main_variables();
        let mut body = self.references();
        body.extend(self.body(most));
        self.add_checksums(&mut body);
        self.program.main.body = body;
    }
}

/// Returns whether a word is among those of what a program shall do without.
pub(super) fn is_in(lacking: &[String], word: &str) -> bool {
    lacking.iter().any(|lacked| lacked.eq_ignore_ascii_case(word))
}
