//! Requests and replies in the forms of the controller's firmware.

use std::borrow::Cow;

use jaka_dynamic::{Forms, Message};
use jaka_spec::Command;
use jaka_sync::{Client, Error, ErrorKind};

use super::request::Request;
use crate::failure::Failure;
use crate::target::packs::Protocol;

/// Forms of the firmware, if the protocol has several. The first request that needs them queries the controller's
/// version; other requests, such as a stop, never do.
#[derive(Debug, Default)]
pub(super) struct FirmwareForms(Option<Forms>);

/// Request in its outgoing form.
#[derive(Debug)]
pub(super) struct Outgoing<'f, 'r> {
    pub(super) text: Cow<'r, str>,
    command: Option<&'r Command>,
    /// Forms of its reply, if there are several.
    forms: Option<&'f Forms>,
}

impl FirmwareForms {
    /// Returns the request in the forms of the controller's firmware.
    pub(super) fn of<'f, 'r>(
        &'f mut self,
        protocol: &Protocol,
        client: &mut Client,
        request: &'r Request<'_>,
    ) -> Result<Outgoing<'f, 'r>, Failure> {
        let as_it_is = Outgoing { text: Cow::Borrowed(&request.text), command: request.command, forms: None };
        let Some(command) = request.command.filter(|command| varies(protocol, command)) else { return Ok(as_it_is) };
        let firmware = match client.firmware() {
            Some(firmware) => firmware,
            None => client.check_firmware()?,
        };
        if self.0.is_none() {
            self.0 = Forms::of(&protocol.spec, Some(firmware));
        }
        let Some(forms) = &self.0 else { return Ok(as_it_is) };
        let text = forms.request(&command.wire, &request.text).ok_or_else(|| {
            Failure::Usage(format!(
                "`{}` was not sent: the controller's firmware has no form for one of the values",
                request.name
            ))
        })?;
        Ok(Outgoing { text: Cow::Owned(text), command: Some(command), forms: Some(forms) })
    }
}

impl Outgoing<'_, '_> {
    /// Returns the text of the reply in the spec's own forms.
    pub(super) fn reply<'t>(&self, text: &'t str) -> Result<Cow<'t, str>, Failure> {
        let (Some(forms), Some(command)) = (self.forms, self.command) else { return Ok(Cow::Borrowed(text)) };
        let own = forms
            .own_text(Message::Reply(&command.wire), text)
            .map_err(|source| Error::from(ErrorKind::UnexpectedReply { command: command.wire.clone(), source }))?;
        Ok(Cow::Owned(own))
    }
}

/// Whether the request or the reply of a command has forms.
fn varies(protocol: &Protocol, command: &Command) -> bool {
    let fields: Vec<_> = command.request.fields().cloned().collect();
    protocol.spec.has_forms(&fields) || protocol.spec.has_forms(protocol.spec.reply_fields(command))
}

/// Returns an error for a request with bytes that depend on the firmware, which a dry run does not query.
pub(super) fn must_be_known(protocol: &Protocol, request: &Request<'_>) -> Result<(), Failure> {
    let fields: Vec<_> = request.command.iter().flat_map(|command| command.request.fields()).cloned().collect();
    if !protocol.spec.has_forms(&fields) {
        return Ok(());
    }
    let fact = "its bytes depend on the controller's firmware, which a dry run does not query";
    Err(Failure::Usage(format!("`{}` is not shown: {fact}", request.name)))
}
