//! Requests and replies.

use jaka_spec::{Command, Request};
use proc_macro2::TokenStream;
use quote::quote;

use crate::scope::{Scope, ident};
use crate::{choice, construct, docs, motion, role, typedef, validate};

/// The request, its reply if it carries data, and their connection.
pub(crate) fn render(scope: Scope<'_>, command: &Command) -> TokenStream {
    let name = ident(&command.request_type());
    let alias = (command.wire != command.request_type()).then(|| docs::alias(&command.wire, &command.name));
    let docs = scope.docs.request_type(command);
    let sdk = docs::sdk_aliases(command);
    let docs = quote!(#docs #alias #sdk);
    let (request, constructors) = match &command.request {
        Request::Fields(fields) => {
            (typedef::object(scope, &name, &docs, fields), construct::object(scope, &name, fields))
        }
        Request::Choice(choice) => {
            (choice::object(scope, &name, &docs, choice), construct::choice(scope, &name, choice))
        }
    };
    let checks = validate::request(scope, command, &name);
    let reply = reply(scope, command);
    let reply_type = scope.reply_type(&TokenStream::new(), command);
    let info = info(command);
    let role = role::of_request(scope.spec, command);
    let motion = motion::render(scope, command, &name);
    quote! {
        #request
        #constructors
        #checks

        impl proto::Command for #name {
            type Reply = #reply_type;
            const INFO: &'static proto::CommandInfo = &#info;
            #role
        }

        #motion

        #reply
    }
}

fn reply(scope: Scope<'_>, command: &Command) -> Option<TokenStream> {
    let name = ident(&command.reply_type()?);
    let docs = scope.docs.reply_type(command);
    Some(typedef::object(scope, &name, &docs, command.reply.own_fields()))
}

fn info(command: &Command) -> TokenStream {
    let name = &command.wire;
    let head = command.head();
    let section = command.section.as_deref().unwrap_or_default();
    let effect = ident(command.effect.variant());
    let role = role::of_command(command).map(|role| quote!(role: Some(#role),));
    let changes = (!command.changes.is_empty()).then(|| {
        let changes = command.changes.iter().map(|change| ident(change.variant()));
        quote!(changes: &[#(proto::Change::#changes),*],)
    });
    let motion = command.motion.as_ref().map(|_| quote!(is_motion: true,));
    let requires = (!command.requires.is_empty()).then(|| {
        let requires = command.requires.iter().map(|state| ident(state.variant()));
        quote!(requires: &[#(proto::Requirement::#requires),*],)
    });
    let deadline = command.deadline.map(|deadline| {
        let ms = u64::try_from(deadline.as_millis()).unwrap_or(u64::MAX);
        quote!(deadline: Some(::core::time::Duration::from_millis(#ms)),)
    });
    let uncertain = (!command.reply_certain).then(|| quote!(reply_certain: false,));
    let ends = command.ends_session.then(|| quote!(ends_session: true,));
    let bare = bare_reply_key(command).map(|key| quote!(bare_reply: Some(#key),));
    let firmware = validate::firmware(&command.versions).map(|firmware| quote!(firmware: #firmware,));
    quote!(
        proto::__command_info!(#name, #head, #section, #effect, #role #changes #motion #requires #deadline #uncertain #ends #bare #firmware)
    )
}

fn bare_reply_key(command: &Command) -> Option<&str> {
    let name = command.bare_reply.as_ref()?;
    command.reply.own_fields().iter().find(|field| field.name == *name).map(|field| field.wire.as_str())
}
