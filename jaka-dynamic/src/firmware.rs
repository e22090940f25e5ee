//! Firmware that has a command, a field or a value.

use jaka_proto::{FirmwareRange, FirmwareVersion, NotInFirmware};
use jaka_spec::{Command, Version, Versions};

use crate::tree::{Label, Node};

/// Returns the versions as a range of jaka-proto.
pub fn firmware_range(versions: &Versions) -> FirmwareRange {
    let version =
        |version: &Option<Version>| version.as_ref().and_then(|version| FirmwareVersion::of(version.numbers()));
    FirmwareRange { since: version(&versions.since), until: version(&versions.until) }
}

/// Returns the first item of a request that the firmware does not have: the command, a field, or a value of an enum.
pub fn not_in_firmware(command: &Command, request: &Node<'_>, firmware: FirmwareVersion) -> Option<NotInFirmware> {
    let range = firmware_range(&command.versions);
    if !range.contains(firmware) {
        return Some(NotInFirmware::new(&command.wire, None, firmware, range));
    }
    in_parts(command, request, "", firmware)
}

fn in_parts(command: &Command, node: &Node<'_>, place: &str, firmware: FirmwareVersion) -> Option<NotInFirmware> {
    node.parts().iter().filter(|part| !part.is_absent()).find_map(|part| {
        let place = part.label().path(place);
        let missing = |versions: &Versions| {
            let range = firmware_range(versions);
            let missing = || NotInFirmware::new(&command.wire, Some(place.clone()), firmware, range);
            (!range.contains(firmware)).then(missing)
        };
        let of_field = if let Label::Field(field) = part.label() { missing(&field.versions) } else { None };
        let of_value = || {
            let versions = part.listed(|listed| &listed.versions, |listed| &listed.versions)?;
            let value = part.value();
            let text = value.as_str().map_or_else(|| value.to_string(), str::to_owned);
            Some(missing(versions)?.with_value(text))
        };
        of_field.or_else(of_value).or_else(|| in_parts(command, part, &place, firmware))
    })
}
