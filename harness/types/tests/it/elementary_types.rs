//! Tests of the whole table of elementary types; single rows of it are in `tests/literals/types.md`.

use stickler_types::ElementaryType as E;

#[test]
fn the_table_is_in_the_order_of_the_declaration_and_every_name_is_read_back() {
    for (index, ty) in E::ALL.into_iter().enumerate() {
        assert_eq!(ty as usize, index);
        assert_eq!(ty.name(), format!("{ty:?}").to_ascii_uppercase());
        assert_eq!(E::from_name(&ty.name().to_ascii_lowercase()), Some(ty));
        assert_eq!(E::from_literal_prefix(ty.name()), Some(ty));
    }
    assert_eq!(E::from_name(""), None);
}

#[test]
fn wrapping_keeps_the_value_modulo_two_to_the_width() {
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
        let (whole, text) = (ty.is_signed() || ty.is_unsigned(), ty.is_text());
        let others = [ty == E::Bool, ty.is_bit_string(), ty.is_real(), ty.is_duration()];
        let rest = [ty.is_date_or_time(), ty.is_character(), whole, text];
        let groups = others.into_iter().chain(rest).filter(|&group| group);
        assert_eq!(groups.count(), 1, "{ty}");
        assert!(
            ty.is_integer() == whole && !(ty.is_signed() && ty.is_unsigned()),
            "{ty}"
        );
    }
}

#[test]
fn a_long_form_is_of_the_same_family_and_of_the_third_edition() {
    for (ty, long) in E::ALL.into_iter().filter_map(|ty| Some((ty, ty.long_form()?))) {
        assert_eq!(long.family(), ty.family());
        assert!(long.is_third_edition() && !ty.is_third_edition());
    }
    assert!(E::Char.is_third_edition() && E::Wchar.is_third_edition() && !E::Lword.is_third_edition());
}
