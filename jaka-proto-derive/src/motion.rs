//! Motions: targets and paths by the fields of their requests.

use jaka_spec::{Command, Field, JOINT_POSITION, Motion, PathKind, Type, TypeKind};
use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::scope::{Scope, ident};

/// The `Motion` of a command that has one. A pack that makes other types of joint positions or poses has none: only the
/// built-in types are targets.
pub(crate) fn render(scope: Scope<'_>, command: &Command, name: &Ident) -> Option<TokenStream> {
    let motion = command.motion.as_ref()?;
    let places = [Some(&motion.target), motion.through.as_ref()];
    if !places.into_iter().flatten().all(|place| has_built_in_type(scope, command, place)) {
        return None;
    }
    let target = target(scope, command, motion)?;
    let path = path(command, motion).map(|path| {
        quote! {
            fn path(&self) -> proto::Path {
                #path
            }
        }
    });
    let tolerance = motion.tolerance.as_ref().map(|field| {
        let tolerance = value(command, field);
        let tolerance = if is_optional(command, field) { quote!(#tolerance.unwrap_or_default()) } else { tolerance };
        quote! {
            fn tolerance(&self) -> f64 {
                #tolerance
            }
        }
    });
    Some(quote! {
        impl proto::Motion for #name {
            fn target(&self) -> proto::Target {
                #target
            }
            #path
            #tolerance
        }
    })
}

fn has_built_in_type(scope: Scope<'_>, command: &Command, field: &str) -> bool {
    let id = command.request_field(field).and_then(|field| field.ty.named());
    id.and_then(|id| scope.spec.topic_of(id)).is_some_and(|topic| !topic.is_pack)
}

fn target(scope: Scope<'_>, command: &Command, motion: &Motion) -> Option<TokenStream> {
    let id = command.request_field(&motion.target)?.ty.named()?;
    let is_joints = scope.spec[id].name == JOINT_POSITION;
    let target = value(command, &motion.target);
    let absolute =
        if is_joints { quote!(proto::Target::Joints(#target)) } else { quote!(proto::Target::Pose(#target)) };
    let Some(mode) = &motion.mode else { return Some(absolute) };
    let field = command.request_field(&mode.field)?;
    let Type::Named(id) = field.ty else { return None };
    let TypeKind::IntEnum(values) = &scope.spec[id].kind else { return None };
    let (ty, selector) = (scope.path(id), value(command, &mode.field));
    let arm = |wire: i64, then: TokenStream| {
        let value = values.iter().find(|value| value.wire == wire)?;
        let variant = ident(&value.name);
        Some(quote!(#ty::#variant => #then,))
    };
    let absolute = arm(mode.absolute, absolute)?;
    let offset = mode.offset.and_then(|wire| {
        let by = if is_joints {
            quote!(proto::Target::JointOffset(#target))
        } else {
            quote!(proto::Target::pose_offset(#target))
        };
        arm(wire, by)
    });
    Some(quote! {
        match #selector {
            #absolute
            #offset
            _ => proto::Target::Unknown,
        }
    })
}

fn path(command: &Command, motion: &Motion) -> Option<TokenStream> {
    let (path, speed) = (motion.path?, value(command, motion.speed.as_ref()?));
    let acceleration = match &motion.acceleration {
        Some(field) if is_optional(command, field) => value(command, field),
        Some(field) => {
            let acceleration = value(command, field);
            quote!(Some(#acceleration))
        }
        None => quote!(None),
    };
    let known = match path {
        PathKind::Joints => quote!(proto::Path::Joints { speed: #speed, acceleration: #acceleration }),
        PathKind::Line => quote!(proto::Path::Line { speed: #speed, acceleration: #acceleration }),
        PathKind::Arc => {
            let through = value(command, motion.through.as_ref()?);
            quote!(proto::Path::Arc { through: #through, speed: #speed, acceleration: #acceleration })
        }
    };
    let unknown_with: Vec<_> = motion.unknown_with.iter().map(|field| value(command, field)).collect();
    if unknown_with.is_empty() {
        return Some(known);
    }
    Some(quote! {
        // No source says how these change the path.
        if #(#unknown_with.is_some())||* {
            return proto::Path::Unknown;
        }
        #known
    })
}

fn value(command: &Command, field: &str) -> TokenStream {
    let name = ident(command.request_field(field).map_or(field, |field| &field.name));
    quote!(self.#name)
}

fn is_optional(command: &Command, field: &str) -> bool {
    command.request_field(field).is_some_and(|field: &Field| field.optional)
}
