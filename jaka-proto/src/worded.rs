//! Enums whose variants are each shown as a text.

/// An enum with a text for each variant, which stands next to it and by which it is displayed.
///
/// A text is a literal that can show the fields of the variant, or, in parentheses, an expression that makes a string
/// of them. It is displayed in one line, with each character that is not [visible](crate::text::is_visible) escaped,
/// and padded as a format asks for. No part of the interface: other crates of the project use it.
///
/// ```
/// jaka_proto::worded! {
///     /// Why a name was refused.
///     #[derive(Debug)]
///     enum Refused {
///         /// There is none.
///         Empty => "no name is given",
///         /// It is in use.
///         Taken {
///             /// The name.
///             name: String,
///         } => "the name `{name}` is taken",
///         /// It has so many characters, and may have so many.
///         TooLong(length: usize, most: usize) => (format!("{} characters too many", length - most)),
///     }
/// }
///
/// assert_eq!(Refused::Empty.to_string(), "no name is given");
/// assert_eq!(Refused::Taken { name: "a\u{1b}".to_owned() }.to_string(), r"the name `a\u{1b}` is taken");
/// assert_eq!(Refused::TooLong(9, 7).to_string(), "2 characters too many");
/// ```
#[doc(hidden)]
#[macro_export]
macro_rules! worded {
    (@text $text:literal) => { format!($text) };
    (@text ($text:expr)) => { $text };
    ($(#[$attribute:meta])* $vis:vis enum $name:ident {
        $(
            $(#[$of_value:meta])*
            $value:ident
            $({ $($(#[$of_field:meta])* $field:ident: $type:ty),+ $(,)? })?
            $(($($part:ident: $of_part:ty),+))?
            => $text:tt,
        )+
    }) => {
        $(#[$attribute])*
        $vis enum $name {
            $($(#[$of_value])* $value $({ $($(#[$of_field])* $field: $type,)+ })? $(($($of_part),+))?,)+
        }

        impl ::std::fmt::Display for $name {
            #[allow(unused_doc_comments, reason = "the docs of a value come with its other attributes")]
            #[allow(unused_variables, reason = "not every text shows all fields")]
            #[allow(clippy::too_many_lines, clippy::useless_format, reason = "it has a line for each value")]
            fn fmt(&self, f: &mut ::std::fmt::Formatter<'_>) -> ::std::fmt::Result {
                match self {
                    $($(#[$of_value])* Self::$value $({ $($field),+ })? $(($($part),+))? => {
                        // Parts of it may have come from outside.
                        let text: &str = &$crate::worded!(@text $text);
                        f.pad(&$crate::text::visible(text))
                    })+
                }
            }
        }
    };
}
