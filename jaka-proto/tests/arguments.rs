//! Arguments that the spec forbids give an error that names field, value and range. Values that newer firmware takes
//! can be let through.

use jaka_proto::Command;
use jaka_proto::check::{AdvisoryRanges, InvalidArgument, NotSent};
use jaka_proto::messages::collision::SetClsnSensitivity;
use jaka_proto::messages::frames::{SetToolId, SetToolOffsets};
use jaka_proto::messages::io::{DigitalOutputKind, SetDigitalOutput};
use jaka_proto::messages::motion::{EndMove, Jog, JogFrame, JointMove};
use jaka_proto::messages::program::{LoadProgram, SetRapidRate};
use jaka_proto::messages::types::{MoveMode, Pose, Switch};

fn refused(command: &impl Command) -> InvalidArgument {
    match command.check(AdvisoryRanges::Enforced) {
        Err(NotSent::InvalidArgument(invalid)) => invalid,
        other => panic!("the spec forbids it, not {other:?}"),
    }
}

fn joint_move() -> JointMove {
    JointMove::absolute([0.0; 6], 10.0).acceleration(10.0)
}

#[test]
fn numbers_that_are_not_finite() {
    let mut request = joint_move();
    request.joint_position.0[2] = f64::NAN;
    assert_eq!(
        refused(&request).to_string(),
        "`joint_move` was not sent: field `joint_position[2]` is NaN, allowed is -360 to 360 deg"
    );
    let mut request = joint_move();
    request.speed = f64::INFINITY;
    assert_eq!(
        refused(&request).to_string(),
        "`joint_move` was not sent: field `speed` is inf, allowed is more than 0, at most 265 deg/s"
    );
    let request = joint_move().acceleration(f64::NEG_INFINITY);
    assert_eq!(refused(&request).field, "acceleration");
    let pose = Pose { ry: f64::NAN, ..Pose::from([0.0; 6]) };
    let request = EndMove::new(pose, 1.0);
    assert_eq!(refused(&request).field, "pose.ry");
}

#[test]
fn numbers_out_of_range() {
    assert_eq!(
        refused(&SetRapidRate::new(1.5)).to_string(),
        "`rapid_rate` was not sent: field `rate` is 1.5, allowed is 0 to 1"
    );
    assert_eq!(
        refused(&SetClsnSensitivity::new(9)).to_string(),
        "`set_clsn_sensitivity` was not sent: field `level` is 9, allowed is 0 to 5; this is advisory: `AdvisoryRanges::Ignored` leaves it to the controller"
    );
    let frame = SetToolOffsets::new([0.0; 6], 0, "gripper");
    assert_eq!(
        refused(&frame).to_string(),
        "`set_tool_offsets` was not sent: field `id` is 0, allowed is 1 to 10; this is advisory: `AdvisoryRanges::Ignored` leaves it to the controller"
    );
    assert_eq!(SetToolId::new(0).check(AdvisoryRanges::Enforced), Ok(()));
    let jog = Jog::continuous(JogFrame::Joint, 6, 1.0);
    assert_eq!(refused(&jog).to_string(), "`jog` was not sent: field `axis` is 6, allowed is 0 to 5");
}

#[test]
fn text_that_the_controller_does_not_take() {
    assert_eq!(
        refused(&LoadProgram::new("程序.jks")).to_string(),
        "`load_program` was not sent: field `program_name` is `程序.jks`, allowed is printable ASCII"
    );
}

#[test]
fn enum_values_that_the_spec_does_not_list() {
    let mut request = joint_move();
    request.mode = MoveMode::Other(2);
    assert_eq!(
        refused(&request).to_string(),
        "`joint_move` was not sent: field `mode` is 2, allowed is 0 (Absolute) or 1 (Relative)"
    );
}

#[test]
fn what_only_newer_firmware_takes_is_let_through_on_request() {
    let output = |kind| SetDigitalOutput::new(kind, 1, Switch::On);
    let invalid = refused(&output(DigitalOutputKind::Profinet));
    assert!(invalid.advisory);
    assert_eq!(
        invalid.to_string(),
        "`set_digital_output` was not sent: field `kind` is 5, allowed is 0 (Cabinet), 1 (Tool) or 2 (Extension); \
         this is advisory: `AdvisoryRanges::Ignored` leaves it to the controller"
    );
    assert_eq!(output(DigitalOutputKind::Profinet).check(AdvisoryRanges::Ignored), Ok(()));
    assert_eq!(output(DigitalOutputKind::Tool).check(AdvisoryRanges::Enforced), Ok(()));
    assert!(output(DigitalOutputKind::Other(99)).check(AdvisoryRanges::Ignored).is_err());
    // A range that is not advisory holds in any case.
    assert!(SetRapidRate::new(1.5).check(AdvisoryRanges::Ignored).is_err());
}
