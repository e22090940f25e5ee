//! Roles of commands and of single requests.

use jaka_spec::{Command, Effect, Role, Scalar, Spec, Type, TypeKind};
use proc_macro2::TokenStream;
use quote::quote;

use crate::choice::variant_path;
use crate::scope::ident;

/// Role of a command: that of the spec. Any other command with the effect of a motion starts one.
pub(crate) fn of_command(command: &Command) -> Option<TokenStream> {
    match (command.role, command.effect) {
        (Some(role), _) => Some(path(role)),
        (None, Effect::Motion) => Some(quote!(proto::Role::Start)),
        (None, Effect::Query | Effect::Setting | Effect::Power | Effect::Session) => None,
    }
}

/// `Command::role` of a command with requests that have another role than the command.
pub(crate) fn of_request(spec: &Spec, command: &Command) -> Option<TokenStream> {
    let others = command.variants().iter().filter_map(|variant| {
        let (of_variant, role) = (variant_path(variant), path(variant.role?));
        Some(quote!(#of_variant { .. } => Some(#role),))
    });
    let others: Vec<_> = others.collect();
    let body = if others.is_empty() {
        let leaves = leaves_servo_mode(spec, command)?;
        quote!(if #leaves { Some(proto::Role::LeaveServoMode) } else { Self::INFO.role })
    } else {
        quote!(match self { #(#others)* _ => Self::INFO.role })
    };
    Some(quote! {
        fn role(&self) -> Option<proto::Role> {
            #body
        }
    })
}

/// Condition for a request that leaves servo mode.
fn leaves_servo_mode(spec: &Spec, command: &Command) -> Option<TokenStream> {
    let field = command.servo_mode_field()?;
    let name = ident(&field.name);
    match field.ty {
        Type::Scalar(Scalar::Bool { .. }) => Some(quote!(!self.#name)),
        Type::Named(id) if matches!(spec[id].kind, TypeKind::IntEnum(_)) => {
            Some(quote!(::core::convert::Into::<i64>::into(self.#name) == 0))
        }
        _ => None,
    }
}

fn path(role: Role) -> TokenStream {
    let role = ident(role.variant());
    quote!(proto::Role::#role)
}
