//! Requests and replies in the forms of the controller's firmware.

use std::borrow::Cow;

use jaka_dynamic::Forms;
use jaka_spec::Command;
use jaka_sync::Client;

use super::request::Request;
use crate::failure::Failure;
use crate::packs::Protocol;

/// Forms of the firmware, where the protocol has several.
#[derive(Debug)]
pub(super) struct FirmwareForms(Option<Forms>);

impl FirmwareForms {
    /// Forms of the controller's firmware, for which it is asked where the protocol has several.
    pub(super) fn of(protocol: &Protocol, client: &mut Client) -> Result<Self, Failure> {
        if !protocol.spec.varies_by_firmware() {
            return Ok(Self(None));
        }
        let firmware = match client.firmware() {
            Some(firmware) => firmware,
            None => client.check_firmware()?,
        };
        Ok(Self(Forms::of(&protocol.spec, Some(firmware))))
    }

    /// The text of a request as it goes out.
    pub(super) fn request<'r>(&self, request: &'r Request<'_>) -> Result<Cow<'r, str>, Failure> {
        let (Some(forms), Some(command)) = (&self.0, request.command) else { return Ok(Cow::Borrowed(&request.text)) };
        let text = forms.request(&command.wire, &request.text).ok_or_else(|| {
            Failure::Usage(format!("`{}` was not sent: the controller's firmware has no form of a value", request.name))
        })?;
        Ok(Cow::Owned(text))
    }

    /// The text of a reply in the spec's own forms.
    pub(super) fn reply<'r>(&self, command: Option<&Command>, text: &'r str) -> Cow<'r, str> {
        match (&self.0, command) {
            (Some(forms), Some(command)) => Cow::Owned(forms.reply(&command.wire, text)),
            _ => Cow::Borrowed(text),
        }
    }
}

/// Fails for a request whose bytes depend on the firmware, which a dry run does not ask for.
pub(super) fn must_be_known(protocol: &Protocol, request: &Request<'_>) -> Result<(), Failure> {
    let fields: Vec<_> = request.command.iter().flat_map(|command| command.request.fields()).cloned().collect();
    if !protocol.spec.has_forms(&fields) {
        return Ok(());
    }
    let fact = "its bytes depend on the controller's firmware, for which a dry run does not ask";
    Err(Failure::Usage(format!("`{}` is not shown: {fact}", request.name)))
}
