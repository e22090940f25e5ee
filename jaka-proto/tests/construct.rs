//! Construction of requests by programs, and display of values.

use jaka_proto::messages::force::TorqueSensorBrand;
use jaka_proto::messages::motion::{Jog, JogFrame, JointMove, LineMode, MoveL};
use jaka_proto::messages::power::GetVersion;
use jaka_proto::messages::program::ProgramState;
use jaka_proto::messages::types::{JointPosition, MoveMode, Pose};
use jaka_proto::wire::Writer;
use jaka_proto::{Command, Request};

fn written(request: &impl Command) -> String {
    let mut out = Writer::new();
    request.write_request(&mut out);
    out.into_string()
}

#[test]
fn required_fields_are_arguments_and_optional_ones_setters() {
    let pose = Pose { x: 300.0, y: 0.0, z: 200.0, rx: 180.0, ry: 0.0, rz: 0.0 };
    let request = MoveL::relative(pose, 20.0).tolerance(0.5);
    assert_eq!(request, MoveL::new(LineMode::Relative, [300.0, 0.0, 200.0, 180.0, 0.0, 0.0], 20.0).tolerance(0.5));
    assert_eq!(
        written(&request),
        r#"{"cmdName":"moveL","relFlag":1,"cartPosition":[300,0,200,180,0,0],"speed":20,"tol":0.5}"#
    );
    assert_eq!((request.acceleration, request.tolerance), (None, Some(0.5)));
}

#[test]
fn a_bare_request_and_one_with_variants_have_constructors() {
    assert_eq!(GetVersion::new(), GetVersion::default());
    assert_eq!(Request::from(GetVersion::new()).info().name, "get_version");
    let jog = Jog::continuous(JogFrame::Joint, 2, -5.0);
    assert!(matches!(jog, Jog::Continuous { frame: JogFrame::Joint, axis: 2, .. }));
}

#[test]
fn a_constructor_can_stand_in_a_constant() {
    const JOG: Jog = Jog::stop(JogFrame::Tool, 1);
    assert_eq!(written(&JOG), r#"{"cmdName":"jog","jog_mode":0,"coord_map":2,"jnum":1}"#);
}

#[test]
fn enums_are_shown_in_words() {
    assert_eq!(TorqueSensorBrand::StMicroelectronics.to_string(), "st microelectronics");
    assert_eq!(TorqueSensorBrand::Other(9).to_string(), "9");
    assert_eq!(ProgramState::Running.to_string(), "running");
    assert_eq!(format!("{:>10}|{:<10}|", MoveMode::Relative, ProgramState::Idle), "  relative|idle      |");
}

#[test]
fn positions_are_shown_with_units_and_joints_have_indices() {
    let mut joints = JointPosition::from_degrees([0.0, 90.5, 90.0, 90.0, -90.0, 0.0]);
    joints[5] = 1.25;
    assert_eq!(joints[5].to_bits(), joints.0[5].to_bits());
    assert_eq!(joints.to_string(), "[0, 90.5, 90, 90, -90, 1.25] deg");
    let pose = Pose::from([300.0, 0.0, 200.5, 180.0, 0.0, 45.0]);
    assert_eq!(format!("{pose:.1}"), "[300.0, 0.0, 200.5] mm, [180.0, 0.0, 45.0] deg");
    assert_eq!(JointMove::absolute(joints, 1.0).joint_position, joints);
}
