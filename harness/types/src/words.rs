//! Enumerations whose variants are spelled as words in files and on the command line.

/// Declares an enumeration and the word of each variant, as which a variant is displayed. Behind `spelled` stand variants of which their words
/// say all.
#[macro_export]
macro_rules! words {
    ($(#[$about:meta])* $name:ident spelled { $($word:ident = $text:literal,)* }) => {
        $crate::words! {
            $(#[$about])* $name { $(#[doc = concat!("`", $text, "`")] $word = $text,)* }
        }
    };
    ($(#[$about:meta])* $name:ident { $($(#[$said:meta])* $word:ident = $text:literal,)* }) => {
        $(#[$about])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        pub enum $name {
            $($(#[$said])* $word,)*
        }

        impl $name {
            /// Every variant, in the order of the declaration.
            pub const ALL: [$name; [$($name::$word),*].len()] = [$($name::$word),*];

            /// Returns the word.
            pub const fn as_str(self) -> &'static str {
                match self {
                    $($name::$word => $text,)*
                }
            }

            /// Returns the variant with this word.
            pub fn from_word(word: &str) -> Option<$name> {
                $name::ALL.into_iter().find(|known| known.as_str() == word)
            }
        }

        impl std::fmt::Display for $name {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.pad(self.as_str())
            }
        }
    };
}

pub(crate) use words;
