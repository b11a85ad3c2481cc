//! Finds the symptoms of a program: the differences between an engine's outcome and the reference's.

use stickler_engines::{
    Ability, Engine, EngineError, EngineSession, Identity, NamedValue, Observation, Outcome, Reference,
    RunRequest,
};
use stickler_generate::reduce::OutcomeSymptom;
use stickler_reduce::Interestingness;
use stickler_types::{DialectName, Fault, Value};

/// The maximum number of variables that are compared.
const MAX_VARIABLES: usize = 1000;

/// The engine on which a program is reduced, and the reference beside it.
pub struct ReductionEngine<'e> {
    session: EngineSession<'e>,
    reference: Reference,
    /// Whether the engine is the reference itself.
    alone: bool,
}

impl<'e> ReductionEngine<'e> {
    /// Opens a session of an engine; `alone` where it is the reference itself, which is not compared with itself. A process
    /// that serves the reference is an engine like any other.
    ///
    /// # Errors
    /// An engine that cannot be started.
    pub fn new(engine: &'e dyn Engine, alone: bool) -> Result<ReductionEngine<'e>, EngineError> {
        Ok(ReductionEngine {
            session: EngineSession::open(engine)?,
            reference: Reference::new(),
            alone,
        })
    }

    /// Returns the identity of the engine.
    pub fn identity(&self) -> &'e Identity {
        self.session.engine().identity()
    }

    /// Returns every symptom of a program; for the reference itself, its rejection, fault or failure to run it to its end.
    ///
    /// # Errors
    /// An engine that crashed and cannot be started again.
    pub fn symptoms(&mut self, dialect: DialectName, source: &str) -> anyhow::Result<Vec<OutcomeSymptom>> {
        let expected = self.expected(dialect, source)?;
        if self.alone {
            let to_its_end = Outcome::executed(Vec::new());
            return Ok(OutcomeSymptom::all(&to_its_end, &expected));
        }
        // Without a result of the reference, there is nothing to compare the engine with.
        if matches!(
            expected,
            Outcome::Crashed { .. }
                | Outcome::Error { .. }
                | Outcome::Faulted {
                    fault: Fault::StepLimit,
                    ..
                }
        ) {
            return Ok(Vec::new());
        }
        let got = self.ask(dialect, source, &expected)?;
        Ok(OutcomeSymptom::all(&expected, &got))
    }

    /// Returns whether a program shows a symptom.
    ///
    /// # Errors
    /// The engine failed, as in [`ReductionEngine::symptoms`].
    pub fn answer(
        &mut self,
        dialect: DialectName,
        source: &str,
        symptom: &OutcomeSymptom,
    ) -> anyhow::Result<Interestingness> {
        let symptoms = self.symptoms(dialect, source)?;
        Ok(Interestingness::from(symptoms.contains(symptom)))
    }

    /// Returns the outcome of a program on the reference, with the values of all variables of an elementary type.
    fn expected(&self, dialect: DialectName, source: &str) -> Result<Outcome, EngineError> {
        let names = stickler_reference::variables(source, dialect, MAX_VARIABLES);
        let observe: Vec<Observation> = names.iter().map(|name| Observation::last(name, "")).collect();
        let mut session = EngineSession::new(&self.reference);
        let outcome = session.run(&RunRequest::once(dialect, source, &observe))?;
        Ok(match outcome {
            Outcome::Executed { mut values, .. } => {
                values.retain(|(_, value)| !matches!(value, Value::Enumerated { .. }));
                Outcome::executed(values)
            }
            other => other,
        })
    }

    /// Returns the outcome of a program on the engine, with the values of the variables to compare.
    fn ask(
        &mut self,
        dialect: DialectName,
        source: &str,
        expected: &Outcome,
    ) -> Result<Outcome, EngineError> {
        let values: &[NamedValue] = match expected {
            Outcome::Executed { values, .. } => values,
            _ => &[],
        };
        let observe: Vec<Observation> = values
            .iter()
            .map(|(name, value)| Observation::last(name, value.type_name()))
            .collect();
        let rejected = matches!(expected, Outcome::Rejected { .. });
        if rejected && self.identity().can(Ability::Check) {
            self.session.check(dialect, source)
        } else {
            self.session.run(&RunRequest::once(dialect, source, &observe))
        }
    }
}
