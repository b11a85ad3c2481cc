//! Choices that the file of a dialect states: how a value of the file becomes one, and how it is written.

use crate::near::advice;
use std::borrow::Cow;
use toml::de::DeValue;

/// A choice that the file of a dialect states under a key such as `conversions.rounding`.
pub(crate) trait Choice {
    /// Makes the choice that a value of the file names.
    ///
    /// # Errors
    /// A message without the name of the key, which it speaks of: `must be true or false`.
    fn state(&mut self, key: &str, value: &DeValue<'_>) -> Result<(), String>;

    /// Returns the choice in the notation of the file, without quotes.
    fn written(&self, key: &str) -> Cow<'static, str>;

    /// Makes one of the choices that are listed for it, by its number; returns false where there are fewer.
    fn take(&mut self, _number: usize) -> bool {
        false
    }
}

/// Returns the option of `all` that a value of the file names.
pub(crate) fn one_of<T: Copy>(
    value: &DeValue<'_>,
    all: &[T],
    as_str: fn(T) -> &'static str,
) -> Result<T, String> {
    let Some(word) = value.as_str() else {
        let found = value.type_str();
        return Err(format!("must be a text in quotes, and this is of type {found}"));
    };
    let known = || all.iter().map(|known| as_str(*known));
    let found = all.iter().find(|known| as_str(**known) == word);
    let unknown = || format!("is not `{word}`; {}", advice(word, &known().collect::<Vec<_>>()));
    found.copied().ok_or_else(unknown)
}

/// Returns a value of the file that is true or false.
pub(crate) fn truth(value: &DeValue<'_>) -> Result<bool, String> {
    let found = value.type_str();
    let wrong = || format!("must be true or false, and this is of type {found}");
    value.as_bool().ok_or_else(wrong)
}

/// Makes one of `all` the choice; returns false where there are fewer.
pub(crate) fn take<T: Copy>(choice: &mut T, all: &[T], number: usize) -> bool {
    let found = all.get(number);
    found.inspect(|&&found| *choice = found).is_some()
}

impl Choice for bool {
    fn state(&mut self, _: &str, value: &DeValue<'_>) -> Result<(), String> {
        *self = truth(value)?;
        Ok(())
    }

    fn written(&self, _: &str) -> Cow<'static, str> {
        self.to_string().into()
    }
}

impl Choice for u32 {
    fn state(&mut self, _: &str, value: &DeValue<'_>) -> Result<(), String> {
        let number = value.as_integer().and_then(|number| number.as_str().parse().ok());
        *self = number
            .filter(|number| (1..=65535).contains(number))
            .ok_or("must be a number from 1 to 65535")?;
        Ok(())
    }

    fn written(&self, _: &str) -> Cow<'static, str> {
        self.to_string().into()
    }
}

/// Makes choices of enumerations of words; a list of variants limits those that a file may state.
macro_rules! choices_of_words {
    ($($name:ty $(: $all:expr)?,)*) => {
        $(impl $crate::choice::Choice for $name {
            fn state(&mut self, _: &str, value: &toml::de::DeValue<'_>) -> Result<(), String> {
                let all = $crate::choice::choices_of_words!(@all $name $(, $all)?);
                *self = $crate::choice::one_of(value, all, <$name>::as_str)?;
                Ok(())
            }

            fn written(&self, _: &str) -> std::borrow::Cow<'static, str> {
                self.as_str().into()
            }

            fn take(&mut self, number: usize) -> bool {
                let all = $crate::choice::choices_of_words!(@all $name $(, $all)?);
                $crate::choice::take(self, all, number)
            }
        })*
    };
    (@all $name:ty) => { &<$name>::ALL };
    (@all $name:ty, $all:expr) => { $all };
}

pub(crate) use choices_of_words;

/// Declares a structure of choices: of each the default, and the keys by which the file of a dialect states it. Fields beside them
/// are no choices.
macro_rules! choices {
    ($(#[$about:meta])* $name:ident {
        $($(#[$said:meta])* $field:ident : $choice:ty = $default:expr, [$($key:literal),*];)*
    } $(beside {
        $($(#[$told:meta])* $other:ident : $kind:ty = $start:expr;)*
    })?) => {
        $(#[$about])*
        pub struct $name {
            $($($(#[$told])* pub $other: $kind,)*)?
            $($(#[$said])* pub $field: $choice,)*
        }

        impl $name {
            /// The choices where nothing else is stated.
            pub const DEFAULT: $name = $name {
                $($($other: $start,)*)?
                $($field: $default,)*
            };

            /// The keys of the choices, in the order of the declaration.
            pub(crate) const KEYS: &'static [&'static str] = &[$($($key,)*)*];

            /// Returns the choice of a key, if the key is one of these.
            pub(crate) fn own_choice(&self, key: &str) -> Option<&dyn $crate::choice::Choice> {
                match key {
                    $($($key => Some(&self.$field),)*)*
                    _ => None,
                }
            }

            /// Returns the choice of a key, to make another one.
            pub(crate) fn own_choice_mut(&mut self, key: &str) -> Option<&mut dyn $crate::choice::Choice> {
                match key {
                    $($($key => Some(&mut self.$field),)*)*
                    _ => None,
                }
            }
        }
    };
}

pub(crate) use choices;
