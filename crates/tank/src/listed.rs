//! Enums whose variants have a value each in the same columns, declared as a table with [`listed!`](crate::listed).

/// Declares an enum as a table: its columns, then a row a variant. The values of a column are those of a method of its name.
///
/// ```text
/// listed! {
///     /// Meaning of the enum.
///     pub enum Name {
///         /// Meaning of the column.
///         column: &'static str,
///     }
///     /// Meaning of the variant.
///     Variant: "value";
/// }
/// ```
#[macro_export]
macro_rules! listed {
    (
        $(#[$meta:meta])*
        pub enum $name:ident { $($(#[doc = $column_doc:literal])+ $column:ident: $type:ty,)+ }
        $($(#[$doc:meta])+ $variant:ident: $($value:expr),+;)+
    ) => {
        $(#[$meta])*
        pub enum $name { $($(#[$doc])+ $variant,)+ }

        const _: () = {
            struct Row {
                $($column: $type,)+
            }

            const fn row($($column: $type),+) -> Row {
                Row { $($column),+ }
            }

            impl $name {
                /// All of them, in the order of their declaration.
                pub const ALL: [$name; [$(stringify!($variant)),+].len()] = [$($name::$variant),+];

                $($(#[doc = $column_doc])+
                pub const fn $column(self) -> $type {
                    self.columns().$column
                })+

                const fn columns(self) -> Row {
                    match self {
                        $($name::$variant => row($($value),+),)+
                    }
                }
            }
        };
    };
}
