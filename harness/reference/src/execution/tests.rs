//! The machine on small programs written by hand, those of `tests/machine`, and on any instructions at all.

use super::{Inconsistency, Machine, RaisedFault, Stop};
use crate::conversion::{Conversion, ConversionRule};
use crate::instruction::{
    ArithmeticOperator, ComparisonOperator, FaultKind, Instruction, LogicOperator, LoopTypes, MachineProgram,
    Part, StandardFunction, TextCell,
};
use ArithmeticOperator::{Add, Divide, Modulo, Subtract};
use Instruction::{
    Address, Arithmetic, Call, CallInstance, CheckRange, Clear, Compare, CompareText, Convert, Copy,
    Dereference, Drop, DropText, InstanceAddress, Jump, JumpIfFalse, Load, LoadIndirect, LoadText, Logic,
    LoopStep, LoopTest, Negate, Not, Offset, Push, PushText, Replicate, Return, Standard, Store,
    StoreIndirect, StorePart, StoreText, Subscript, Swap,
};
use StandardFunction::{Concat, Len, Min, Mux, Ror, Sel};
use stickler_types::ElementaryType::{self, Int, String};
use stickler_types::dialect::{COMMON_CHOICES, TextElements};
use stickler_types::{BitStringText, MomentText, RealText, SplitMix64, join};

const STEPS: u64 = 10_000;

/// A program of one routine after another; the first is the scan. Cell 8 is a text of 4 units, cell 9 of 8.
fn program(routines: &[&[Instruction]]) -> MachineProgram {
    let mut program = MachineProgram {
        memory: 16,
        ..MachineProgram::default()
    };
    for routine in routines {
        program.routines.push(program.code.len() as u32);
        program.code.extend_from_slice(routine);
        program.code.push(Return);
    }
    program.lines = (1..=program.code.len() as u32).collect();
    let text = |(address, capacity)| TextCell { address, capacity };
    program.texts = [(8, 4), (9, 8)].map(text).into();
    program.text_constants = ["abc", "defgh"].map(|text| text.encode_utf16().collect()).into();
    program
}

fn fault(kind: FaultKind, line: u32) -> Stop {
    Stop::Fault(RaisedFault { kind, line })
}

/// Reads an instruction as the rows of `tests/machine` write it.
fn instruction(text: &str) -> Instruction {
    let words: Vec<&str> = text.split_whitespace().collect();
    let number = |at: usize| words[at].parse::<i64>().expect("a number");
    let small = |at: usize| number(at) as u32;
    let ty = |at: usize| ElementaryType::from_name(words[at]).expect("a type");
    let unsigned = words.last() == Some(&"unsigned");
    let of = match words.get(1) {
        Some(&"codes") => TextElements::Codes,
        _ => TextElements::Characters,
    };
    let standard = |function| Standard {
        function,
        of: ty(1),
        count: small(2) as u16,
        numbers: words.get(3).map_or(0, |_| small(3) as u16),
    };
    let part = || Part {
        first: small(1) as u8,
        ty: ty(2),
    };
    let loop_types = || LoopTypes {
        control: ty(1),
        limit: ty(words.len() - 1),
        step: ty(1),
        wraps: false,
    };
    match words[0] {
        "push" => Push(number(1).cast_unsigned()),
        "push-text" => PushText(small(1)),
        "drop" => Drop,
        "drop-text" => DropText,
        "swap" => Swap,
        "address" => Address(small(1)),
        "instance-address" => InstanceAddress(small(1)),
        "dereference" => Dereference,
        "offset" => Offset(small(1)),
        "subscript-within" => Instruction::SubscriptWithin { unsigned },
        "subscript" => Subscript {
            low: number(1),
            high: number(2),
            stride: small(3),
            unsigned,
        },
        "load" => Load(small(1)),
        "load-indirect" => LoadIndirect,
        "store" => Store(small(1)),
        "store-indirect" => StoreIndirect,
        "load-text" => LoadText,
        "store-text" => StoreText,
        "character" => Instruction::Character { of, unsigned },
        "load-character" => Instruction::LoadCharacter,
        "store-character" => Instruction::StoreCharacter(of),
        "copy" => Copy(small(1)),
        "replicate" => Replicate {
            stride: small(1),
            count: small(2),
        },
        "clear" => Clear(small(1)),
        "part" => Instruction::Part(part()),
        "store-part" => StorePart {
            part: part(),
            of: ty(4),
        },
        "write-int" => Convert(Conversion {
            from: Int,
            to: String,
            rule: ConversionRule::WriteText(
                RealText::Shortest,
                BitStringText::FullWidth,
                MomentText::Literal,
            ),
        }),
        "convert" => Convert(Conversion {
            from: ty(1),
            to: ty(2),
            rule: ConversionRule::between(ty(1), ty(2), &COMMON_CHOICES).unwrap_or(ConversionRule::ToBcd),
        }),
        "scale" => Instruction::ScaleDuration(Divide, ty(1), false),
        "power" => Instruction::Power {
            base: ty(1),
            exponent: ty(2),
            stops: unsigned,
        },
        "add" => Arithmetic(Add, ty(1)),
        "subtract" => Arithmetic(Subtract, ty(1)),
        "divide" => Arithmetic(Divide, ty(1)),
        "modulo" => Arithmetic(Modulo, ty(1)),
        "less" => Compare(ComparisonOperator::Less, ty(1)),
        "less-text" => CompareText(ComparisonOperator::Less),
        "xor" => Logic(LogicOperator::Xor),
        "not" => Not(ty(1)),
        "negate" => Negate(ty(1)),
        "check" => CheckRange {
            low: number(1),
            high: number(2).cast_unsigned(),
            unsigned,
        },
        "loop-test" => LoopTest(loop_types()),
        "loop-step" => LoopStep(loop_types()),
        "concat" => standard(Concat),
        "len" => standard(Len),
        "min" => standard(Min),
        "mux" => standard(Mux),
        "ror" => standard(Ror),
        "sel" => standard(Sel),
        "jump" => Jump(small(1)),
        "jump-if-false" => JumpIfFalse(small(1)),
        "call" => Call(small(1)),
        "call-instance" => CallInstance(small(1)),
        word => panic!("`{word}` is no instruction"),
    }
}

/// Runs the routines of a row for a scan, and describes what comes of it in the form of its answer.
fn answered(routines: &str, answer: &str) -> std::string::String {
    let code = |routine: &str| routine.split(';').map(instruction).collect::<Vec<_>>();
    let routines: Vec<_> = routines.split(" | ").map(code).collect();
    let program = program(&routines.iter().map(Vec::as_slice).collect::<Vec<_>>());
    let mut machine = Machine::new(&program, STEPS);
    let plain = |machine: &Machine<'_>, address| machine.plain(address).unwrap_or_default().cast_signed();
    match machine.scan() {
        Err(Stop::Fault(RaisedFault { kind, line })) => {
            format!("fault {} at {line}", kind)
        }
        Err(Stop::Inconsistent(Inconsistency { what, .. })) => format!("no {what}"),
        Ok(()) => match answer.split_once(": ") {
            Some((place, numbers)) if place.starts_with("cells ") => {
                let first: u32 = place["cells ".len()..].parse().expect("an address");
                let count = numbers.split(' ').count() as u32;
                let cells = (first..first + count).map(|address| plain(&machine, address).to_string());
                format!("{place}: {}", join(cells, " "))
            }
            Some((place, _)) => {
                let address = place["text ".len()..].parse().expect("an address");
                let units = machine.text(address).expect("a text");
                format!("{place}: {}", std::string::String::from_utf16_lossy(units))
            }
            None => plain(&machine, 0).to_string(),
        },
    }
}

#[test]
fn each_routine_gives_what_its_row_says() {
    stickler_mdtest::check(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/machine"), |block| {
        block.rows(|routines, answer| stickler_mdtest::same(answered(routines, answer), answer.to_owned()))
    });
}

#[test]
fn a_copy_costs_steps_by_its_cells() {
    let copies: Vec<_> = [Address(0), Address(0), Copy(8), Jump(0)].into();
    let program = program(&[&copies]);
    // A turn costs 4 instructions and 8 cells.
    let turns = |steps| {
        let mut machine = Machine::new(&program, steps);
        machine.scan().expect_err("it does not end")
    };
    assert_eq!(turns(12 * 5), fault(FaultKind::StepLimit, 3));
    assert_eq!(turns(12 * 5 + 8), fault(FaultKind::StepLimit, 4));
}

#[test]
fn steps_are_counted_over_all_scans() {
    let program = program(&[&[Push(1), Store(0)]]);
    let mut machine = Machine::new(&program, 7);
    assert_eq!([machine.scan(), machine.scan()], [Ok(()), Ok(())]);
    assert_eq!(machine.scan(), Err(fault(FaultKind::StepLimit, 3)));
    assert_eq!(machine.plain(0), Some(1));
}

#[test]
fn a_program_without_routines_is_an_error() {
    let started = Machine::new(&MachineProgram::default(), 1).startup();
    let missing = "routine of this number";
    let is_missing =
        matches!(started, Err(Stop::Inconsistent(Inconsistency { what, .. })) if what == missing);
    assert!(is_missing, "{started:?}");
}

/// Instructions whose operands are chosen: a SMALL number, one of a FEW, ANY number or a TYPE.
const CHOSEN: &str = "push SMALL; push SMALL; push SMALL; push ANY; push-text FEW; address SMALL; instance-address ANY;
    subscript -3 ANY ANY; subscript -3 ANY ANY unsigned; load-indirect; store SMALL; store-indirect; load-text; store-text;
    character; character codes; character codes unsigned; load-character; store-character; store-character codes;
    copy SMALL; replicate SMALL ANY; clear SMALL; store-part ANY TYPE of TYPE; convert TYPE TYPE; add TYPE; divide TYPE;
    modulo TYPE; scale TYPE; power TYPE TYPE; power TYPE TYPE unsigned; less-text; mux TYPE SMALL FEW; sel TYPE SMALL FEW;
    concat TYPE SMALL FEW; ror TYPE SMALL FEW; jump SMALL; jump-if-false SMALL; call FEW; loop-step TYPE TYPE";

/// Any instruction at all, with operands that often make sense.
fn any_instruction(next: &mut impl FnMut() -> u64) -> Instruction {
    const TYPES: [&str; 9] = [
        "BOOL", "BYTE", "DINT", "INT", "SINT", "STRING", "UINT", "ULINT", "WSTRING",
    ];
    let all: Vec<&str> = CHOSEN.split(';').collect();
    let words = all[next() as usize % all.len()].split_whitespace();
    let chosen = words.map(|word| match word {
        "SMALL" => (next() % 20).to_string(),
        "FEW" => (next() % 3).to_string(),
        "ANY" => next().cast_signed().to_string(),
        "TYPE" => TYPES[next() as usize % TYPES.len()].to_owned(),
        word => word.to_owned(),
    });
    instruction(&join(chosen, " "))
}

#[test]
fn no_instruction_panics_whatever_it_finds() {
    let mut numbers = SplitMix64::new(1).numbers();
    let mut next = || numbers.next().unwrap_or_default();
    let mut ended = [0; 3];
    for _ in 0..20_000 {
        let code: Vec<_> = (0..12).map(|_| any_instruction(&mut next)).collect();
        let program = program(&[&code, &code[6..]]);
        let ending = match Machine::new(&program, STEPS).scan() {
            Ok(()) => 0,
            Err(Stop::Fault(_)) => 1,
            Err(Stop::Inconsistent(_)) => 2,
        };
        ended[ending] += 1;
    }
    assert!(
        ended.iter().all(|&count| count > 0),
        "the programs reach every kind of ending: {ended:?}"
    );
}
