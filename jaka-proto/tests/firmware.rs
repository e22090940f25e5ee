//! Firmware versions: how they are read and ordered, and what is refused because a controller's firmware does not have
//! it.

use jaka_proto::check::{AdvisoryRanges, FieldLimits, NotSent, Place, Rules, Validate};
use jaka_proto::messages::power::GetVersion;
use jaka_proto::text::Visible;
use jaka_proto::wire::{DecodeError, Encode, Fields, Reader, Writer};
use jaka_proto::{Command, CommandInfo, FirmwareRange, FirmwareVersion, NotInFirmware, Request};

fn version(text: &str) -> FirmwareVersion {
    text.parse().expect("the text is a version")
}

#[test]
fn versions_as_controllers_write_them() {
    let read = |text: &str| version(text).to_string();
    assert_eq!(read("1.6.5_01_X86"), "1.6.5");
    assert_eq!(read("1.5.14_X64"), "1.5.14");
    assert_eq!(read("V1.7.1.46_X64"), "1.7.1.46");
    assert_eq!(read(" v1.4 \n"), "1.4");
    assert_eq!(read("1.7.0-rc2"), "1.7.0");
    assert_eq!(read("1.7.X64"), "1.7");
    assert_eq!(read("2"), "2");
    assert_eq!(version("1.7.1.46_X64"), FirmwareVersion::new([1, 7, 1, 46]));
    // The vendor's release notes have underscores between the numbers.
    assert_eq!(read("1_7_2_28"), "1.7.2.28");
    assert_eq!(read("V1_7_2_28_X64"), "1.7.2.28");
    assert_eq!(read("1_7"), "1.7");
    assert_eq!(read("1.5.13.09"), "1.5.13.9");
    assert_eq!(read("1_X64"), "1");
}

#[test]
fn texts_that_are_no_versions() {
    for text in [
        "",
        "V",
        "VV1.7",
        "X64",
        "_1.7",
        ".7",
        "-1.7",
        "+1.7",
        "1.7.1.46.2",
        "1_7_2_28_1",
        "1.4294967296",
        "version 1.7",
        "１.７",
        "1..5",
        "1._5",
        "1.",
        "1.7.",
        "1.7_",
        "1.7-",
        "1__7",
        "0x1.5.1",
        "1e3.5.1",
        "1.5e3",
        "1.7b",
        "1,7,2",
        "1 7 2",
        "1-7-2",
        "1/7",
        "1.-7",
        "1.7 2",
        "1.7_\u{1b}[2J",
        "1.7_X64\n2",
        "inf",
        "NaN",
        "1_7.2",
        "1_7-2",
    ] {
        let error = text.parse::<FirmwareVersion>().expect_err("it is not a version");
        assert_eq!(error.to_string(), format!("`{}` is not a firmware version such as 1.6.5_01_X86", Visible(text)));
    }
}

#[test]
fn versions_are_ordered_by_their_numbers() {
    let ascending = ["1", "1.4", "1.5", "1.5.0", "1.5.9", "1.5.14", "1.5.14.1", "1.6", "1.10", "2"].map(version);
    assert!(ascending.is_sorted_by(|a, b| a < b));
}

#[test]
fn a_range_has_what_lies_below_its_ends() {
    let between = |since: &str, until: &str| {
        let bound = |text: &str| (!text.is_empty()).then(|| version(text));
        FirmwareRange { since: bound(since), until: bound(until) }
    };
    for (since, until, inside, outside) in [
        ("1.6", "", &["1.6", "1.6.0", "1.6.5", "1.10", "2"][..], &["1.5.14", "1"][..]),
        ("1.7.0", "", &["1.7", "1.7.0"], &["1.6.9"]),
        ("", "1.6", &["1", "1.5.14", "1.6", "1.6.0", "1.6.5.2"], &["1.7", "1.60", "2"]),
        ("", "1.6.0", &["1.6", "1.6.0", "1.6.0.3"], &["1.6.1"]),
        ("1.5.14", "1.6.5", &["1.5.14", "1.6", "1.6.5.1"], &["1.5.9", "1.6.6", "1.7"]),
        ("", "", &["0", "9.9.9.9"], &[]),
    ] {
        let range = between(since, until);
        assert_eq!(inside.iter().find(|text| !range.contains(version(text))), None, "{range}");
        assert_eq!(outside.iter().find(|text| range.contains(version(text))), None, "{range}");
    }
    assert_eq!(between("", "").to_string(), "of any version");
    assert_eq!(between("", ""), FirmwareRange::ALL);
}

/// A command as it is generated: of firmware 1.5 to 1.7, with fields that not all of these have.
#[derive(Debug, Clone, Default)]
struct SetFan {
    /// Since 1.6.
    curve: Option<FanCurve>,
    points: Vec<FanCurve>,
    /// Until 1.6.
    delay: f64,
}

#[derive(Debug, Clone, Default)]
struct FanCurve {
    /// Since 1.7.
    quiet: Option<bool>,
}

impl Fields for SetFan {
    fn write_fields(&self, out: &mut Writer) {
        out.key("\"delay\":");
        self.delay.encode(out);
    }

    fn read_fields(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        reader.skip().map(|()| Self::default())
    }
}

fn in_firmware(firmware: FirmwareRange) -> FieldLimits<'static> {
    FieldLimits { firmware, ..FieldLimits::NONE }
}

impl Validate for SetFan {
    fn validate(&self, place: &Place<'_>, _limits: &FieldLimits) -> Result<(), NotSent> {
        place.check("curve", &self.curve, &in_firmware(FirmwareRange::ALL.since([1, 6])))?;
        place.check("points", &self.points, &FieldLimits::NONE)?;
        place.check(
            "delay",
            &self.delay,
            &FieldLimits { min: Some(0.0), ..in_firmware(FirmwareRange::ALL.until([1, 6])) },
        )
    }
}

impl Validate for FanCurve {
    fn validate(&self, place: &Place<'_>, _limits: &FieldLimits) -> Result<(), NotSent> {
        place.check("quiet", &self.quiet, &in_firmware(FirmwareRange::ALL.since([1, 7])))
    }
}

impl Command for SetFan {
    type Reply = ();
    const INFO: &'static CommandInfo = &jaka_proto::__command_info!(
        "set_fan", "{\"cmdName\":\"set_fan\"", "", Setting, firmware: FirmwareRange::ALL.since([1, 5]).until([1, 7]),
    );
}

fn check(request: &SetFan, firmware: &str) -> Result<(), NotSent> {
    request.check(Rules { ranges: AdvisoryRanges::Enforced, firmware: Some(version(firmware)) })
}

fn missing(request: &SetFan, firmware: &str) -> NotInFirmware {
    match check(request, firmware) {
        Err(NotSent::NotInFirmware(missing)) => *missing,
        other => panic!("firmware {firmware} does not have it, not {other:?}"),
    }
}

#[test]
fn a_command_that_the_firmware_does_not_have() {
    let request = SetFan::default();
    let error = missing(&request, "1.4.12");
    assert_eq!((error.command.as_str(), &error.field, error.firmware), ("set_fan", &None, version("1.4.12")));
    assert_eq!(error.range, SetFan::INFO.firmware);
    assert_eq!(
        error.to_string(),
        "`set_fan` was not sent: the controller's firmware 1.4.12 does not have it; firmware 1.5 to 1.7 has"
    );
    assert_eq!(missing(&request, "1.8").field, None);
    assert_eq!(check(&request, "1.5.14"), Ok(()));
}

#[test]
fn a_field_that_the_firmware_does_not_have() {
    let request = SetFan { curve: Some(FanCurve::default()), ..SetFan::default() };
    assert_eq!(
        missing(&request, "1.5.14").to_string(),
        "`set_fan` was not sent: the controller's firmware 1.5.14 does not have its field `curve`; \
         firmware 1.6 and later has"
    );
    assert_eq!(check(&request, "1.6.0"), Ok(()));
    // A field that must be given is given, whatever its value.
    assert_eq!(
        missing(&SetFan::default(), "1.7.1").to_string(),
        "`set_fan` was not sent: the controller's firmware 1.7.1 does not have its field `delay`; firmware up to 1.6 has"
    );
}

#[test]
fn a_field_inside_other_types() {
    let quiet = FanCurve { quiet: Some(false) };
    let request = SetFan { points: vec![FanCurve::default(), quiet.clone()], ..SetFan::default() };
    assert_eq!(missing(&request, "1.6.5").field.as_deref(), Some("points[1].quiet"));
    let request = SetFan { curve: Some(quiet), ..SetFan::default() };
    assert_eq!(missing(&request, "1.6.5").field.as_deref(), Some("curve.quiet"));
}

#[test]
fn without_a_known_firmware_all_is_sent() {
    let request = SetFan { curve: Some(FanCurve { quiet: Some(true) }), ..SetFan::default() };
    assert_eq!(request.check(AdvisoryRanges::Enforced), Ok(()));
    assert_eq!(request.check(Rules::default()), Ok(()));
    // The check still refuses a value that the spec forbids.
    let request = SetFan { delay: -1.0, ..request };
    assert!(matches!(request.check(Rules::default()), Err(NotSent::InvalidArgument(_))));
}

#[test]
fn every_firmware_can_be_asked_for_its_version() {
    assert_eq!(GetVersion::INFO.firmware, FirmwareRange::ALL);
    let rules = Rules { firmware: Some(version("0.1")), ..Rules::default() };
    assert_eq!(Request::GetVersion(GetVersion::new()).check(rules), Ok(()));
}
