//! Closed choices of words: an enum, its words in a tank file and their meaning, declared once with [`words!`](crate::words).

/// A closed choice of words.
pub trait Words: Copy + PartialEq + 'static {
    /// Name in the JSON Schema.
    const NAME: &'static str;
    /// Meaning of the choice, line by line.
    const HELP: &'static [&'static str];
    /// Each word, the value that it names, and its meaning line by line.
    const WORDS: &'static [(&'static str, Self, &'static [&'static str])];

    /// The word of this value.
    fn word(self) -> &'static str {
        let own = Self::WORDS.iter().find(|(_, value, _)| *value == self);
        own.map_or("", |(word, ..)| word)
    }
}

/// Declares enums without data as choices of words.
///
/// ```text
/// words! {
///     /// Meaning of the choice.
///     pub Name as SchemaName: DefaultVariant in "snake_case" {
///         /// Meaning of the word.
///         Variant = "word",
///     }
/// }
/// ```
///
/// Schema name, default variant and serde's case are optional. Without a case, serde has the words.
#[macro_export]
macro_rules! words {
    ($(
        $(#[doc = $doc:literal])+
        $vis:vis $name:ident $(as $schema:ident)? $(: $default:ident)? $(in $case:literal)? { $(
            $(#[doc = $vdoc:literal])+
            $variant:ident = $word:literal,
        )+ }
    )*) => {$(
        $crate::words! { @enum ($($case)?) $(#[doc = $doc])+ $vis $name { $($(#[doc = $vdoc])+ $variant = $word,)+ } }

        $(impl Default for $name {
            fn default() -> Self {
                $name::$default
            }
        })?

        impl $crate::value::Value for $name {
            type Domain = Self;
            fn domain(self) -> Self {
                self
            }
        }

        impl $crate::words::Words for $name {
            const NAME: &'static str = $crate::words!(@name $name $($schema)?);
            const HELP: &'static [&'static str] = &[$($doc),+];
            const WORDS: &'static [(&'static str, Self, &'static [&'static str])] =
                &[$(($word, $name::$variant, &[$($vdoc),+])),+];
        }
    )*};
    (@name $name:ident) => { stringify!($name) };
    (@name $name:ident $schema:ident) => { stringify!($schema) };
    (@enum () $(#[doc = $doc:literal])+ $vis:vis $name:ident { $($(#[doc = $vdoc:literal])+ $variant:ident = $word:literal,)+ }) => {
        $(#[doc = $doc])+
        #[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
        $vis enum $name { $($(#[doc = $vdoc])+ #[serde(rename = $word)] $variant,)+ }
    };
    (@enum ($case:literal) $(#[doc = $doc:literal])+ $vis:vis $name:ident { $($(#[doc = $vdoc:literal])+ $variant:ident = $word:literal,)+ }) => {
        $(#[doc = $doc])+
        #[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
        #[serde(rename_all = $case)]
        $vis enum $name { $($(#[doc = $vdoc])+ $variant,)+ }
    };
}
