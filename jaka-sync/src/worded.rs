//! Enums whose values are each shown as a text.

/// An enum in which the text of each value, by which it is displayed, stands next to it. The text can show the fields of the value.
macro_rules! worded {
    ($(#[$attribute:meta])* $vis:vis enum $name:ident {
        $($(#[$of_value:meta])* $value:ident $({ $($(#[$of_field:meta])* $field:ident: $type:ty,)+ })? => $text:literal,)+
    }) => {
        $(#[$attribute])*
        $vis enum $name {
            $($(#[$of_value])* $value $({ $($(#[$of_field])* $field: $type,)+ })?,)+
        }

        impl std::fmt::Display for $name {
            #[allow(unused_doc_comments, reason = "the docs of a value come with its other attributes")]
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.pad(&match self {
                    $($(#[$of_value])* Self::$value $({ $($field),+ })? => format!($text),)+
                })
            }
        }
    };
}

pub(crate) use worded;
