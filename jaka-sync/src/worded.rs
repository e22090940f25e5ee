//! Enums whose values are each shown as a text.

/// An enum in which the text of each value, by which it is displayed in one line, stands next to it: a literal that can show the fields of the
/// value, or, in parentheses, what makes a string of them.
macro_rules! worded {
    (@text $text:literal) => { format!($text) };
    (@text ($text:expr)) => { $text };
    ($(#[$attribute:meta])* $vis:vis enum $name:ident {
        $(
            $(#[$of_value:meta])*
            $value:ident
            $({ $($(#[$of_field:meta])* $field:ident: $type:ty,)+ })?
            $(($part:ident: $of_part:ty))?
            => $text:tt,
        )+
    }) => {
        $(#[$attribute])*
        $vis enum $name {
            $($(#[$of_value])* $value $({ $($(#[$of_field])* $field: $type,)+ })? $(($of_part))?,)+
        }

        impl std::fmt::Display for $name {
            #[allow(unused_doc_comments, reason = "the docs of a value come with its other attributes")]
            #[allow(unused_variables, reason = "not every text shows all fields")]
            #[allow(clippy::too_many_lines, clippy::useless_format, reason = "it has a line for each value")]
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                let text = match self {
                    $($(#[$of_value])* Self::$value $({ $($field),+ })? $(($part))? => worded!(@text $text),)+
                };
                // Parts of it may have come from outside.
                f.pad(&jaka_proto::text::visible(&text))
            }
        }
    };
}

pub(crate) use worded;
