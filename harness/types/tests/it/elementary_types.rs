//! Tests of the table of elementary types: names, ranges, raw forms.

use stickler_types::ElementaryType as E;

#[test]
fn the_table_is_in_the_order_of_the_declaration() {
    for (index, ty) in E::ALL.into_iter().enumerate() {
        assert_eq!(ty as usize, index);
        assert_eq!(ty.name(), format!("{ty:?}").to_ascii_uppercase());
    }
}

#[test]
fn every_name_is_read_back_in_any_case() {
    for ty in E::ALL {
        assert_eq!(E::from_name(ty.name()), Some(ty));
        assert_eq!(E::from_name(&ty.name().to_ascii_lowercase()), Some(ty));
        assert_eq!(E::from_literal_prefix(ty.name()), Some(ty));
    }
    for (name, ty) in [
        ("Time_Of_Day", E::Tod),
        ("LTIME_OF_DAY", E::Ltod),
        ("date_and_time", E::Dt),
        ("LDATE_AND_TIME", E::Ldt),
    ] {
        assert_eq!(E::from_name(name), Some(ty), "{name}");
    }
}

#[test]
fn what_names_no_type_is_turned_away() {
    for name in [
        "",
        "I",
        "INTE",
        "T",
        "LT",
        "D",
        "LD",
        "DİNT",
        "LDATE_AND_TIMES",
        "ANY_INT",
        "ſtring",
    ] {
        assert_eq!(E::from_name(name), None, "{name}");
    }
}

#[test]
fn the_short_prefixes_of_literals_name_types_of_both_editions() {
    for (prefix, ty) in [("t", E::Time), ("LT", E::Ltime), ("D", E::Date), ("ld", E::Ldate)] {
        assert_eq!(E::from_literal_prefix(prefix), Some(ty), "{prefix}");
    }
}

#[test]
fn ranges_are_those_of_two_s_complement() {
    assert_eq!(E::Bool.integer_range(), Some((0, 1)));
    assert_eq!(E::Sint.integer_range(), Some((-128, 127)));
    assert_eq!(E::Lint.integer_range(), Some((i64::MIN.into(), i64::MAX.into())));
    assert_eq!(E::Word.integer_range(), Some((0, 65_535)));
    assert_eq!(E::Ulint.integer_range(), Some((0, u64::MAX.into())));
    assert_eq!(E::Real.integer_range(), None);
    assert_eq!(E::Char.integer_range(), None);
    assert_eq!(E::Time.integer_range(), None);
}

#[test]
fn wrapping_keeps_the_value_modulo_two_to_the_width() {
    assert_eq!(E::Int.integer_value(E::Int.wrap(100_000)), -31_072);
    assert_eq!(E::Int.wrap(-1), u64::MAX);
    assert_eq!(E::Word.wrap(-1), 0xFFFF);
    assert_eq!(E::Ulint.integer_value(E::Ulint.wrap(-1)), u64::MAX.into());
    assert_eq!(E::Bool.wrap(2), 0);
    assert_eq!(E::Bool.wrap(-1), 1);
    for ty in E::ALL {
        let Some((least, greatest)) = ty.integer_range() else {
            continue;
        };
        for value in [least, least + 1, 0, 1, greatest - 1, greatest] {
            assert_eq!(ty.integer_value(ty.wrap(value)), value, "{ty}");
            assert_eq!(ty.wrap(value + (1 << ty.bits())), ty.wrap(value), "{ty}");
        }
        assert_eq!(ty.integer_value(ty.wrap(greatest + 1)), least, "{ty}");
    }
}

#[test]
fn every_type_belongs_to_exactly_one_of_the_groups() {
    for ty in E::ALL {
        let groups = [
            ty == E::Bool,
            ty.is_signed(),
            ty.is_unsigned(),
            ty.is_bit_string(),
            ty.is_real(),
            ty.is_duration(),
            ty.is_date_or_time(),
            ty.is_text(),
            ty.is_character(),
        ];
        assert_eq!(groups.into_iter().filter(|&group| group).count(), 1, "{ty}");
        assert_eq!(ty.is_integer(), ty.is_signed() || ty.is_unsigned(), "{ty}");
    }
}

#[test]
fn a_long_form_is_of_the_same_family_and_of_the_third_edition() {
    let with_long_form = E::ALL.into_iter().filter(|ty| ty.long_form().is_some());
    assert!(with_long_form.clone().eq([E::Time, E::Date, E::Tod, E::Dt]));
    for ty in with_long_form {
        let long = ty.long_form().unwrap();
        assert_eq!(long.name(), format!("L{ty}"));
        assert_eq!(long.family(), ty.family());
        assert!(long.is_third_edition() && !ty.is_third_edition());
    }
    assert!(E::Char.is_third_edition() && E::Wchar.is_third_edition() && !E::Lword.is_third_edition());
}
