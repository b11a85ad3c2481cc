//! The machine on small programs written by hand.

use super::{Inconsistency, Machine, RaisedFault, Stop};
use crate::conversion::{Conversion, ConversionRule};
use crate::instruction::{
    ArithmeticOperator, ComparisonOperator, FaultKind, Instruction, LogicOperator, LoopTypes, MachineProgram,
    Part, StandardFunction, TextCell,
};
use Instruction::{
    Address, Arithmetic, Call, CallInstance, CheckRange, Clear, Compare, CompareText, Convert, Copy,
    Dereference, Drop, DropText, InstanceAddress, Jump, JumpIfFalse, Load, LoadIndirect, LoadText, Logic,
    LoopStep, LoopTest, Negate, Not, Offset, Push, PushText, Replicate, Return, Standard, Store,
    StoreIndirect, StorePart, StoreText, Subscript, Swap,
};
use stickler_types::ElementaryType::{
    Bool, Byte, Dint, Dword, Int, Sint, String, Uint, Ulint, Word, Wstring,
};
use stickler_types::dialect::COMMON_CHOICES;
use stickler_types::{BitStringText, MomentText, RealText};

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
    program.texts = vec![
        TextCell {
            address: 8,
            capacity: 4,
        },
        TextCell {
            address: 9,
            capacity: 8,
        },
    ];
    program.text_constants = ["abc", "defgh"].map(|text| text.encode_utf16().collect()).into();
    program
}

/// Runs a scan and gives the cells.
fn run(routines: &[&[Instruction]]) -> Result<Vec<u64>, Stop> {
    let program = program(routines);
    let mut machine = Machine::new(&program, STEPS);
    machine.scan()?;
    Ok((0..16).filter_map(|address| machine.plain(address)).collect())
}

/// The content of cell 0 after a scan.
fn result(routine: &[Instruction]) -> Result<u64, Stop> {
    run(&[routine]).map(|cells| cells[0])
}

fn text(routine: &[Instruction], address: u32) -> std::string::String {
    let program = program(&[routine]);
    let mut machine = Machine::new(&program, STEPS);
    machine.scan().expect("the program runs");
    std::string::String::from_utf16_lossy(machine.text(address).expect("a text"))
}

fn fault(kind: FaultKind, line: u32) -> Stop {
    Stop::Fault(RaisedFault { kind, line })
}

#[test]
fn cells_are_written_and_read_directly_and_by_address() {
    assert_eq!(result(&[Push(7), Store(3), Load(3), Store(0)]), Ok(7));
    assert_eq!(result(&[Address(0), Push(7), StoreIndirect]), Ok(7));
    assert_eq!(
        result(&[Push(7), Store(3), Address(1), Offset(2), LoadIndirect, Store(0)]),
        Ok(7)
    );
    // A VAR_IN_OUT: cell 5 holds the address of cell 0.
    assert_eq!(
        result(&[Push(0), Store(5), Address(5), Dereference, Push(9), StoreIndirect]),
        Ok(9)
    );
    assert_eq!(result(&[Push(1), Push(2), Swap, Drop, Store(0)]), Ok(2));
}

#[test]
fn subscripts_find_elements_and_fault_outside() {
    let element = |low, high, subscript: i64, unsigned| {
        let at = Subscript {
            low,
            high,
            stride: 2,
            unsigned,
        };
        result(&[Address(2), Push(subscript.cast_unsigned()), at, Store(0)])
    };
    assert_eq!(element(-1, 1, -1, false), Ok(2));
    assert_eq!(element(-1, 1, 1, false), Ok(6));
    assert_eq!(element(3, 5, 4, true), Ok(4));
    for (subscript, unsigned) in [
        (2, false),
        (-2, false),
        (-1, true),
        (i64::MIN, false),
        (i64::MAX, true),
    ] {
        assert_eq!(
            element(-1, 1, subscript, unsigned),
            Err(fault(FaultKind::SubscriptRange, 3)),
            "{subscript}"
        );
    }
}

#[test]
fn operators_take_their_left_operand_from_below() {
    let minus = Arithmetic(ArithmeticOperator::Subtract, Int);
    assert_eq!(result(&[Push(5), Push(3), minus, Store(0)]), Ok(2));
    let less = Compare(ComparisonOperator::Less, Int);
    assert_eq!(result(&[Push(3), Push(5), less, Store(0)]), Ok(1));
    assert_eq!(
        result(&[Push(12), Push(10), Logic(LogicOperator::Xor), Store(0)]),
        Ok(6)
    );
    assert_eq!(result(&[Push(0), Not(Bool), Store(0)]), Ok(1));
    assert_eq!(result(&[Push(0), Not(Int), Negate(Int), Store(0)]), Ok(1));
    let divide = Arithmetic(ArithmeticOperator::Divide, Int);
    assert_eq!(
        result(&[Push(5), Push(0), divide]),
        Err(fault(FaultKind::DivisionByZero, 3))
    );
}

#[test]
fn bits_are_taken_and_set_without_touching_others() {
    let part = |first, ty| Part { first, ty };
    assert_eq!(
        result(&[Push(0x80), Instruction::Part(part(7, Bool)), Store(0)]),
        Ok(1)
    );
    assert_eq!(
        result(&[Push(0x1234_5678), Instruction::Part(part(8, Byte)), Store(0)]),
        Ok(0x56)
    );
    let store = |old: u64, part, value, of| {
        result(&[
            Push(old),
            Store(0),
            Address(0),
            Push(value),
            StorePart { part, of },
        ])
    };
    let set = |old: u64, bit, value, of| store(old, part(bit, Bool), value, of);
    assert_eq!(set(0x01, 7, 1, Byte), Ok(0x81));
    assert_eq!(set(0xFF, 3, 0, Byte), Ok(0xF7));
    // The sign bit of a signed type carries into the sign extension.
    assert_eq!(set(1, 7, 1, Sint), Ok((-127_i64).cast_unsigned()));
    assert_eq!(set(u64::MAX, 7, 0, Sint), Ok(127));
    assert_eq!(store(0x1234_5678, part(16, Word), 0xABCD, Dword), Ok(0xABCD_5678));
    assert_eq!(
        store(0, part(24, Byte), 0x80, Dint),
        Ok(i64::from(i32::MIN).cast_unsigned())
    );
}

#[test]
fn a_subrange_lets_through_what_lies_in_it() {
    let check = |low, high: i64, value: i64, unsigned| {
        let check = CheckRange {
            low,
            high: high.cast_unsigned(),
            unsigned,
        };
        result(&[Push(value.cast_unsigned()), check, Store(0)])
    };
    assert_eq!(check(-5, 5, -5, false), Ok((-5_i64).cast_unsigned()));
    assert_eq!(check(-5, 5, 6, false), Err(fault(FaultKind::Subrange, 2)));
    assert_eq!(check(1, -1, -1, true), Ok(u64::MAX));
    assert_eq!(check(1, -2, -1, true), Err(fault(FaultKind::Subrange, 2)));
}

#[test]
fn texts_are_stored_cut_and_converted() {
    assert_eq!(text(&[PushText(1), Address(8), StoreText], 8), "defg");
    let joined = Standard {
        function: StandardFunction::Concat,
        of: String,
        count: 2,
    };
    assert_eq!(
        text(&[PushText(0), PushText(1), joined, Address(9), StoreText], 9),
        "abcdefgh"
    );
    let number = Conversion {
        from: Int,
        to: String,
        rule: ConversionRule::WriteText(RealText::Shortest, BitStringText::FullWidth, MomentText::Literal),
    };
    assert_eq!(text(&[Push(42), Convert(number), Address(9), StoreText], 9), "42");
    let length = Standard {
        function: StandardFunction::Len,
        of: String,
        count: 1,
    };
    assert_eq!(result(&[PushText(0), length, Store(0)]), Ok(3));
    let order = CompareText(ComparisonOperator::Less);
    assert_eq!(result(&[PushText(0), PushText(1), order, Store(0)]), Ok(1));
    let chosen = Standard {
        function: StandardFunction::Sel,
        of: Wstring,
        count: 2,
    };
    assert_eq!(
        text(
            &[Push(1), PushText(0), PushText(1), chosen, Address(9), StoreText],
            9
        ),
        "defgh"
    );
    assert_eq!(
        text(
            &[
                PushText(1),
                PushText(0),
                DropText,
                Address(9),
                StoreText,
                Address(9),
                LoadText,
                Address(8),
                StoreText
            ],
            8
        ),
        "defg"
    );
}

#[test]
fn aggregates_are_copied_repeated_and_cleared() {
    let fill: [Instruction; 4] = [Push(1), Store(0), Push(2), Store(1)];
    let with = |rest: &[Instruction]| run(&[&[&fill, rest].concat()]);
    assert_eq!(
        with(&[Address(4), Address(0), Copy(2)]).map(|cells| cells[4..6].to_vec()),
        Ok(vec![1, 2])
    );
    let repeated = with(&[Address(0), Replicate { stride: 2, count: 3 }]);
    assert_eq!(
        repeated.map(|cells| cells[..7].to_vec()),
        Ok(vec![1, 2, 1, 2, 1, 2, 0])
    );
    assert_eq!(
        with(&[Address(0), Clear(2)]).map(|cells| cells[..2].to_vec()),
        Ok(vec![0, 0])
    );
}

#[test]
fn functions_return_to_their_caller_and_instances_see_their_own_variables() {
    let body: &[Instruction] = &[InstanceAddress(1), Push(5), StoreIndirect, Call(2)];
    let function: &[Instruction] = &[
        Load(0),
        Push(1),
        Arithmetic(ArithmeticOperator::Add, Int),
        Store(0),
    ];
    let scan: &[Instruction] = &[Address(4), CallInstance(1), Call(2), InstanceAddress(0), Store(2)];
    let cells = run(&[scan, body, function]).expect("the program runs");
    assert_eq!(
        (cells[0], cells[5], cells[2]),
        (2, 5, 0),
        "`this` is the caller's again"
    );
}

#[test]
fn a_for_loop_runs_to_the_greatest_value_of_its_type() {
    let types = LoopTypes {
        control: Sint,
        limit: Sint,
        step: Sint,
    };
    // Cell 1 counts from 125 to 127; cell 0 counts the turns.
    let before = [
        Push(125),
        Store(1),
        Load(1),
        Push(127),
        Push(1),
        LoopTest(types),
        JumpIfFalse(19),
    ];
    let body = [
        Load(0),
        Push(1),
        Arithmetic(ArithmeticOperator::Add, Dint),
        Store(0),
    ];
    let again = [
        Load(1),
        Push(127),
        Push(1),
        LoopStep(types),
        JumpIfFalse(18),
        Store(1),
        Jump(7),
        Drop,
    ];
    assert_eq!(result(&[&before[..], &body, &again].concat()), Ok(3));
}

#[test]
fn the_step_limit_ends_endless_loops_and_endless_copying() {
    assert_eq!(
        result(&[Push(1), Drop, Jump(0)]),
        Err(fault(FaultKind::StepLimit, 3))
    );
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
fn a_program_that_contradicts_itself_is_an_error() {
    let what = |stop| match stop {
        Err(Stop::Inconsistent(Inconsistency { what, .. })) => what,
        _ => "",
    };
    assert_eq!(what(result(&[Drop])), "operand");
    assert_eq!(what(result(&[DropText])), "text operand");
    assert_eq!(what(result(&[Load(99)])), "cell at this address");
    assert_eq!(
        what(result(&[Push(u64::MAX), LoadIndirect])),
        "cell at this address"
    );
    assert_eq!(what(result(&[PushText(9)])), "text constant of this number");
    assert_eq!(what(result(&[Call(9)])), "routine of this number");
    assert_eq!(what(result(&[Jump(99)])), "instruction at this label");
    assert_eq!(what(result(&[Call(0)])), "end to its calls");
    assert_eq!(
        what(Machine::new(&MachineProgram::default(), 1).startup().map(|()| 0)),
        "routine of this number"
    );
}

/// Any instruction at all, with operands that often make sense.
fn any_instruction(bits: u64) -> Instruction {
    let small = (bits >> 8) as u32 % 20;
    let ty = [Bool, Byte, Dint, Int, Sint, String, Uint, Ulint, Wstring][(bits >> 16) as usize % 9];
    let other = [Int, String, Ulint, Bool][(bits >> 24) as usize % 4];
    let operator = [
        ArithmeticOperator::Add,
        ArithmeticOperator::Divide,
        ArithmeticOperator::Modulo,
    ];
    let operator = operator[(bits >> 32) as usize % 3];
    let functions = [
        StandardFunction::Mux,
        StandardFunction::Sel,
        StandardFunction::Concat,
        StandardFunction::Ror,
    ];
    let function = functions[(bits >> 40) as usize % 4];
    let rule = ConversionRule::between(ty, other, &COMMON_CHOICES).unwrap_or(ConversionRule::ToBcd);
    match bits as u8 % 28 {
        0..4 => Push(small.into()),
        4 => Push(bits),
        5 => PushText(small % 3),
        6 => Address(small),
        7 => InstanceAddress(bits as u32),
        8 => Subscript {
            low: -3,
            high: (bits >> 50) as i64,
            stride: bits as u32,
            unsigned: bits > 1 << 63,
        },
        9 => LoadIndirect,
        10 => Store(small),
        11 => StoreIndirect,
        12 => LoadText,
        13 => StoreText,
        14 => Copy(small),
        15 => Replicate {
            stride: small,
            count: bits as u32,
        },
        16 => Clear(small),
        17 => StorePart {
            part: Part {
                first: bits as u8,
                ty: other,
            },
            of: ty,
        },
        18 => Convert(Conversion {
            from: ty,
            to: other,
            rule,
        }),
        19 => Arithmetic(operator, ty),
        20 => Instruction::ScaleDuration(operator, ty),
        21 => Instruction::Power {
            base: ty,
            exponent: other,
        },
        22 => CompareText(ComparisonOperator::Less),
        23 => Standard {
            function,
            of: ty,
            count: small as u16,
        },
        24 => Jump(small),
        25 => JumpIfFalse(small),
        26 => Call(small % 3),
        _ => LoopStep(LoopTypes {
            control: ty,
            limit: other,
            step: ty,
        }),
    }
}

#[test]
fn no_instruction_panics_whatever_it_finds() {
    let mut state = 1_u64;
    let mut next = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state ^ (state >> 29)).wrapping_mul(0x94D0_49BB_1331_11EB)
    };
    let mut ended = [0; 3];
    for _ in 0..20_000 {
        let code: Vec<_> = (0..12).map(|_| any_instruction(next())).collect();
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
