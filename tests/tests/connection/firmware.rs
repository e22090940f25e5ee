//! Refusal of commands that a controller's firmware does not have, before they are sent, once the client knows the
//! firmware.
//!
//! The built-in spec has no command that only some firmware has, so a pack adds one.

use std::time::Duration;

use fan::{FanCommands as _, FanCurve, SetFan};
use jaka_robot::jaka_sync::ErrorKind as Failure;
use jaka_robot::{Cause, Client, Error, FirmwareVersion, Motion, NotInFirmware, Target};
use jaka_sim::{Controller, Fault, Firmware};
use jaka_tests::{Arm, ArmBuilder, LONG, failure};
use serde_json::json;

jaka_robot::pack!("data/fan.toml");

/// So that a robot can wait for it.
impl Motion for SetFan {
    fn target(&self) -> Target {
        Target::Unknown
    }
}

const PLAIN: SetFan = SetFan { curve: FanCurve { speed: 0.5, quiet: None }, delay: None };
const QUIET: SetFan = SetFan { curve: FanCurve { speed: 0.5, quiet: Some(true) }, ..PLAIN };
const DELAYED: SetFan = SetFan { delay: Some(1.0), ..PLAIN };

fn arm() -> ArmBuilder {
    let pack = concat!(env!("CARGO_MANIFEST_DIR"), "/data/fan.toml");
    Arm::simulated().controller(|controller| controller.firmware(Firmware::Document).pack(pack))
}

/// The controller takes what any firmware has, whatever it says of its version.
fn connected() -> (Arm, Client) {
    let (arm, client) = arm().with_client();
    arm.set_state(|state| "1.8.0".clone_into(&mut state.version));
    (arm, client)
}

/// Has the controller say, once, that its version is this.
fn says(controller: &Controller, version: &str) {
    let reply = json!({"errorCode": "0", "errorMsg": "", "version": version, "cmdName": "get_version"});
    controller.inject(Fault::Instead(reply.to_string().into_bytes()));
}

fn missing<E: Into<Error>>(result: Result<(), E>) -> NotInFirmware {
    let error: Error = result.expect_err("the firmware does not have it").into();
    match failure(&error) {
        Some(Failure::NotInFirmware(missing)) => missing.clone(),
        _ => panic!("the firmware does not have it, not {error:?}"),
    }
}

#[test]
fn nothing_is_refused_by_default() {
    let (controller, mut client) = connected();
    assert_eq!(client.get_version().expect("it answers").version, "1.8.0");
    assert_eq!(client.firmware(), None);
    client.call(&QUIET).expect("the simulator takes it");
    assert_eq!(controller.requests()[1], r#"{"cmdName":"set_fan","curve":{"speed":0.5,"quiet":true}}"#);
}

#[test]
fn a_command_that_the_controller_does_not_have_is_not_sent() {
    let (controller, mut client) = connected();
    says(&controller, "1.6.5_01_X86");
    let firmware = client.check_firmware().expect("the simulator says its version");
    assert_eq!((firmware, client.firmware()), (FirmwareVersion::new([1, 6, 5]), Some(firmware)));
    assert_eq!(controller.requests(), [r#"{"cmdName":"get_version"}"#]);

    let error = client.set_fan(PLAIN.curve).expect_err("the firmware is too old");
    assert_eq!(
        error.to_string(),
        "`set_fan` was not sent: the controller's firmware 1.6.5 does not have it; firmware 1.7 and later has"
    );
    assert!(error.is_not_in_firmware() && !error.may_have_run());
    assert!(!error.is_invalid_argument() && !error.is_refused() && !error.is_disconnected());
    missing(client.call_within(&PLAIN, LONG));
    assert_eq!(controller.requests().len(), 1);

    // All else is sent: what every firmware has, the version, and what the spec knows nothing of.
    client.get_joint_pos().expect("every firmware has it");
    client.get_version().expect("every firmware has it");
    client.call_raw("set_fan", &json!({"curve": {"speed": 1}})).expect("raw calls are sent as they are");
    assert_eq!(controller.requests().len(), 4);
}

#[test]
fn a_field_that_the_controller_does_not_have_is_not_sent() {
    let (controller, mut client) = connected();
    says(&controller, "V1.7.1.46_X64");
    client.check_firmware().expect("the text is a version");
    client.set_fan(PLAIN.curve).expect("the firmware has the command");
    client.call(&DELAYED).expect("the firmware has the field");
    assert_eq!(
        missing(client.call(&QUIET)).to_string(),
        "`set_fan` was not sent: the controller's firmware 1.7.1.46 does not have its field `curve.quiet`; \
         firmware 1.7.2 and later has"
    );
    assert_eq!(controller.requests().len(), 3);

    says(&controller, "1.8.0");
    client.check_firmware().expect("the text is a version");
    client.call(&QUIET).expect("the firmware has the field");
    assert_eq!(missing(client.call(&DELAYED)).field.as_deref(), Some("delay"));
}

#[test]
fn a_version_that_cannot_be_read_is_an_error_and_changes_nothing() {
    let (controller, mut client) = connected();
    says(&controller, "development build");
    let error = client.check_firmware().expect_err("it is not a version");
    assert_eq!(error.to_string(), "`get_version` was not refused, but its reply does not fit the spec");
    let source = std::error::Error::source(&error).expect("the field is told");
    assert_eq!(
        source.to_string(),
        "field `version`: expected a firmware version such as 1.6.5_01_X86, found `development build`"
    );
    assert_eq!(client.firmware(), None);
    client.call(&QUIET).expect("nothing is refused");

    says(&controller, "1.6.5_01_X86");
    client.check_firmware().expect("now it is one");
    says(&controller, "");
    client.check_firmware().expect_err("it is not a version");
    missing(client.set_fan(PLAIN.curve));
}

#[test]
fn a_firmware_that_is_set_is_not_asked_for() {
    let (controller, mut client) = connected();
    client.set_firmware(Some(FirmwareVersion::new([1, 5, 14])));
    missing(client.set_fan(PLAIN.curve));
    assert!(controller.requests().is_empty());
    client.set_firmware(None);
    client.set_fan(PLAIN.curve).expect("nothing is refused");
}

#[test]
fn a_motion_that_the_controller_does_not_have_is_not_waited_for() {
    let (controller, mut robot) = arm().with_robot();
    robot.client().check_firmware().expect("the simulator says its version");
    missing(robot.start(&PLAIN));
    assert!(robot.run(&PLAIN, LONG).is_err_and(|error| error.is_not_in_firmware()));
    assert!(robot.wait(Duration::ZERO).cause() == Cause::NoMotion);
    assert_eq!(controller.requests().len(), 1);
}
