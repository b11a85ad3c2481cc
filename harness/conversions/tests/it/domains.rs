//! Tests the inputs that a sweep goes through.

use stickler_conversions::sweep::{Domain, Sampling};
use stickler_mdtest::check_examples;
use stickler_types::{ElementaryType, Value, literal};

fn domain(operands: &[ElementaryType], inputs: u64, seed: u64) -> Domain {
    let sampling = Sampling {
        inputs: Some(inputs),
        seed,
        ..Sampling::default()
    };
    Domain::of(operands, sampling)
}

fn holds(domain: &Domain, literal: &str) -> bool {
    let value = Value::parse(literal).expect("a typed literal");
    (0..domain.len()).any(|place| domain.operands(place) == [value.clone()])
}

#[test]
fn a_small_source_is_swept_in_the_order_of_its_bits() {
    for ty in ElementaryType::ALL
        .into_iter()
        .filter(|ty| !ty.is_text() && ty.bits() <= 16)
    {
        let domain = Domain::of(&[ty], Sampling::default());
        assert!(domain.is_exhaustive());
        assert_eq!(domain.len(), 1 << ty.bits(), "{ty}");
        let mut raws = vec![u64::MAX; 1 << ty.bits()];
        domain.fill(0..domain.len(), &mut raws);
        for (place, raw) in raws.iter().enumerate() {
            assert_eq!(domain.operands(place as u64), [Value::plain(ty, *raw)]);
            // Every pattern of bits comes once, in its canonical raw form.
            assert_eq!(ty.wrap((*raw).into()), *raw);
            assert_eq!(raw & ((1 << ty.bits()) - 1), place as u64);
        }
    }
}

#[test]
fn golden_domains() {
    check_examples("tests/examples/domains.md", |example| {
        let ty = ElementaryType::from_name(example.text("type")).expect("a type");
        if let Some(place) = example.get("place") {
            let place = u64::from_str_radix(&place.replace('_', ""), 16).expect("a place");
            let domain = Domain::of(&[ty], Sampling::default());
            assert_eq!(domain.len(), 1 << ty.bits(), "{ty}");
            return domain.operands(place)[0].to_string();
        }
        let domain = domain(&[ty], 0, 1);
        let missing = example
            .text("holds")
            .split_whitespace()
            .filter(|literal| !holds(&domain, literal));
        missing.map(|literal| format!("without {literal} ")).collect()
    });
}

#[test]
fn a_sample_is_the_same_for_the_same_seed_and_another_for_another() {
    for ty in [ElementaryType::Lreal, ElementaryType::Dt, ElementaryType::String] {
        let with = |seed| {
            let domain = domain(&[ty], 100, seed);
            let (chosen, _) = domain.parts().expect("a sample");
            (chosen..domain.len())
                .map(|place| domain.operands(place))
                .collect::<Vec<_>>()
        };
        assert_eq!(with(7), with(7));
        assert_ne!(with(7), with(8));
    }
}

#[test]
fn whatever_is_sampled_is_a_value_of_its_type() {
    for ty in ElementaryType::ALL {
        let domain = domain(&[ty], 5_000, 1);
        for place in 0..domain.len() {
            let operands = domain.operands(place);
            let written = operands[0].to_string();
            assert_eq!(Value::parse(&written).as_ref(), Ok(&operands[0]), "{written}");
        }
    }
}

#[test]
fn a_sample_of_reals_has_ties_and_numbers_on_either_side() {
    let domain = domain(&[ElementaryType::Lreal], 10_000, 1);
    let (chosen, _) = domain.parts().expect("a sample");
    let mut ties = 0;
    for place in chosen..domain.len() {
        let Value::Plain { raw, .. } = domain.operands(place)[0] else {
            continue;
        };
        let number = f64::from_bits(raw);
        ties += u32::from(number.fract().abs() == 0.5);
    }
    assert!((500..8_000).contains(&ties), "{ties}");
    assert!(literal::real("0.5", ElementaryType::Lreal).is_ok());
}

#[test]
fn two_operands_are_paired_boundary_by_boundary() {
    let domain = domain(&[ElementaryType::Date, ElementaryType::Tod], 10, 1);
    let (chosen, sampled) = domain.parts().expect("a sample");
    assert_eq!(sampled, 10);
    assert_eq!(domain.len(), chosen + 10);
    for place in [0, chosen - 1, chosen, chosen + 9] {
        let operands = domain.operands(place);
        let types: Vec<&str> = operands.iter().map(Value::type_name).collect();
        assert_eq!(types, ["DATE", "TOD"]);
    }
}
