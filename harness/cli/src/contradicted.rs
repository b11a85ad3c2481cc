//! Collects what sources answer to the questions of cases, for [`stickler_conversions::contradictions`].
//!
//! An answer is what a document or the standard states, or what a product was recorded or measured to do. A case that rests on one of
//! Stickler's own rules has none, nor has one of another system's document, nor the reference.

use std::collections::HashMap;
use std::sync::Arc;
use stickler_conversions::contradictions::{AnswerOrigin, AskedQuestion, ContradictionsBuilder};
use stickler_conversions::recording::Recording;
use stickler_suite::{Acceptance, Case, SourceKind, Suite};
use stickler_types::{DialectName, MatrixWord, Question};

/// Returns the answers that these cases of a suite, its statements and the recordings have.
pub fn gather(cases: &[&Case], suite: &Suite, recordings: &[Recording]) -> ContradictionsBuilder {
    let mut builder = ContradictionsBuilder::default();
    let mut origins = HashMap::new();
    // A variant has options of its own, and a program of places asks about them too.
    let states = |case: &&&Case| {
        let is_variant = case.dialect.is_variant() || case.dialect.is_custom();
        !is_variant && case.placement.is_none() && !case.is_open()
    };
    for case in cases.iter().filter(states) {
        let key = (&case.basis, case.dialect);
        let of_case = || origin(suite, &case.basis, Some(case.dialect));
        if let Some(origin) = origins.entry(key).or_insert_with(of_case) {
            add_case(&mut builder, case, origin, suite);
        }
    }
    for stated in &suite.statements {
        let (text, kind) = (stated.asks.clone(), "as sources state it".to_owned());
        if let Some(origin) = origin(suite, &stated.basis, None) {
            let given = (&origin, stated.answer.clone());
            match text.parse::<Question>() {
                Ok(question) => builder.add_question(&question, None, given),
                Err(_) => builder.add(text.clone(), AskedQuestion::new(text, kind), given),
            }
        }
    }
    for recording in recordings {
        let source = suite.sources.get("recording");
        let address = source.map(|source| source.address_of(&recording.name));
        recording.add_answers(&mut builder, &address.unwrap_or_default());
    }
    builder
}

/// Returns the origin of a basis in a dialect, or, of a statement, in the dialect for which its source speaks first; `None` where no source of
/// the system states anything.
fn origin(suite: &Suite, basis: &str, dialect: Option<DialectName>) -> Option<Arc<AnswerOrigin>> {
    let (source, section) = suite.sources.of(basis)?;
    let speaks = dialect.is_none_or(|dialect| source.speaks_for(section, dialect));
    if source.kind == SourceKind::Rule || !speaks {
        return None;
    }
    let is_standard = source.kind == SourceKind::Standard;
    // What the standard says in the dialect of a vendor is what it says itself.
    let dialect = dialect.filter(|dialect| !is_standard || source.dialects.contains(dialect));
    let dialect = dialect.or_else(|| source.dialects_of(section).first().copied());
    let title = match dialect {
        Some(dialect) => &dialect.rules().title,
        None if is_standard => &source.key,
        None => &source.publisher,
    };
    let publisher = (!source.relation.is_maker()).then(|| format!(" of {}", source.publisher));
    Some(Arc::new(AnswerOrigin {
        // The title of a dialect names its flavour behind a comma.
        system: match title.split_once(',') {
            Some((system, _)) if !is_standard => system.to_owned(),
            _ => title.clone(),
        },
        kind: source.kind.as_str().to_owned() + &publisher.unwrap_or_default(),
        source: basis.to_owned(),
        read: source.read_of(section).into_owned(),
        address: source.address_of(section),
        dialect,
    }))
}

/// Adds what a case states: the answer to its question, or whether its program is accepted and what its variables hold.
fn add_case(builder: &mut ContradictionsBuilder, case: &Case, origin: &Arc<AnswerOrigin>, suite: &Suite) {
    let expected = &case.expectation;
    let accepted = match (case.cell.as_deref().map(|cell| cell.word), expected.accepted) {
        (Some(MatrixWord::No), _) | (None, Acceptance::Rejected) => Some("rejected"),
        (Some(MatrixWord::Open), _) | (None, Acceptance::Observed) => None,
        _ => Some("accepted"),
    };
    let stops = expected.fault.map(|one| format!("stops: {}", one.fault));
    let values = expected.values.iter();
    let values = values.map(|one| (one.key(), one.value.to_string()));
    let stopped = case.observe.iter();
    let stopped = stopped.filter_map(|one| Some((one.key(), stops.clone()?)));
    let mut values = values.chain(stopped);
    match case.question.as_deref() {
        // A rejected call may be one of a name that the system does not have.
        Some(question @ Question::Call(call)) => {
            if let (Some((_, value)), None) = (values.next(), values.next()) {
                builder.add_question(question, Some(&case.id), (origin, value));
            }
            let page = stickler_exact::signature_of(call, case.dialect)
                .and_then(|known| stickler_exact::stated_by_vendor(&known, &call.operands, case.dialect));
            if let Some((value, basis)) = page
                && let Some(origin) = self::origin(suite, basis, Some(case.dialect))
            {
                builder.add_question(question, Some(&case.id), (&origin, value.to_string()));
            }
        }
        Some(question) => {
            if let Some(answer) = accepted {
                builder.add_question(question, Some(&case.id), (origin, answer.to_owned()));
            }
        }
        None if expected.rendered.is_none() && case.set.is_empty() && case.clock.is_empty() => {
            let values = values.map(|(variable, value)| (format!(", {variable}"), value));
            let accepted = accepted.map(|answer| (String::new(), answer.to_owned()));
            for (variable, answer) in values.chain(accepted) {
                let asked = AskedQuestion {
                    text: format!("{}{variable}", case.title),
                    // The cases of one probe vary one thing.
                    kind: case.id.split('(').next().unwrap_or_default().to_owned(),
                    case: Some(Arc::clone(&case.id)),
                    program: Some(Arc::clone(&case.source)),
                };
                let key = format!("{}\n{}{variable}", case.source, case.scans);
                builder.add(key, asked, (origin, answer));
            }
        }
        None => {}
    }
}
