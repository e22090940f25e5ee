//! Robots whose pack has elsewhere what they need of status packets, or not at all, or leaves it to the program.

use std::path::PathBuf;

use jaka_pack_user::{mapped, radians};
use jaka_proto::wire::{Decode, DecodeError, Reader};
use jaka_robot::motion::JointMove;
use jaka_robot::preflight::{CheckItem, Finding, Preflight, Verdict};
use jaka_robot::status::RobotStatus;
use jaka_robot::{Cause, ErrorKind, MotionStatus, Robot, StatusProblem};
use jaka_spec::NEEDED_FIELDS;
use jaka_sync::layer::needed;
use jaka_tests::simulated::beside;
use jaka_tests::{Arm, CYCLE, LONG};
use serde_json::{Value, json};

fn to(angle: f64) -> JointMove {
    JointMove::absolute([angle, 90.0, 90.0, 90.0, -90.0, 0.0], 40.0).acceleration(400.0)
}

fn robot<S: MotionStatus>(arm: &Arm) -> Robot<S> {
    Robot::with_monitor(arm.client(), arm.monitor::<S>()).expect("it is the only robot")
}

/// An arm whose packets have the key that the pack `mapped` takes for the protective stop.
fn arm(halt: &Value) -> Arm {
    let pack = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("pack-user/halt.toml");
    let arm = Arm::simulated().controller(|controller| controller.pack(pack)).start();
    show(&arm, halt);
    arm
}

/// Has all packets from now on show this under the pack's key, and what nobody can read under the built-in one.
fn show(arm: &Arm, halt: &Value) {
    arm.set_status([("demo_halt".to_owned(), halt.clone()), ("protective_stop".to_owned(), json!([1]))]);
    arm.publish();
    arm.clock().sleep(CYCLE);
}

/// Asserts that no motion goes out, because packets do not tell this field.
fn assert_kept_back<S: MotionStatus>(arm: &Arm, robot: &mut Robot<S>, field: &str) {
    let error = robot.run(&to(5.0), LONG).expect_err("a packet does not tell it");
    let ErrorKind::StatusUnknown { problem: StatusProblem::Unreadable { source } } = error.kind() else {
        panic!("{error:?}")
    };
    assert!(source.is_in(field), "{source}");
    assert!(!arm.requests().iter().any(|request| request.contains("joint_move")), "{:?}", arm.requests());
}

fn status_packets(preflight: &Preflight) -> &Finding {
    let mut findings = preflight.findings().iter();
    findings.find(|finding| finding.item() == CheckItem::StatusPackets).expect("each item has a finding")
}

#[test]
fn a_robot_reads_a_mapped_stop() {
    let arm = arm(&json!("free"));
    let mut robot = robot::<mapped::RobotStatus>(&arm);
    robot.run(&to(5.0), LONG).expect("nothing keeps it back").reached().expect("nothing stops it");
    let halted = || {
        arm.clock().sleep(5 * CYCLE);
        show(&arm, &json!("halted"));
    };
    let end = beside(arm.clock(), halted, || robot.run(&to(40.0), LONG)).expect("it is accepted");
    assert_eq!(end.cause(), Cause::ProtectiveStop, "{end}");
    assert!(end.packets.last().is_some_and(|last| last.status.protective_stop == Some(true)));
}

#[test]
fn a_mapped_field_that_packets_lack_or_that_does_not_fit_keeps_motions_back() {
    // Without the pack, the controller has no such key.
    let lacking = Arm::simulated().start();
    assert_kept_back(&lacking, &mut robot::<mapped::RobotStatus>(&lacking), "protective_stop");
    for halt in [Value::Null, json!("perhaps")] {
        let arm = arm(&halt);
        assert_kept_back(&arm, &mut robot::<mapped::RobotStatus>(&arm), "protective_stop");
        show(&arm, &json!("free"));
        let mut robot = robot::<mapped::RobotStatus>(&arm);
        robot.run(&to(5.0), LONG).expect("packets tell it again").reached().expect("nothing stops it");
    }
}

#[test]
fn an_end_tells_that_an_error_is_not_seen_where_packets_have_no_code() {
    let arm = arm(&json!("free"));
    let mut robot = robot::<mapped::RobotStatus>(&arm);
    let fail = || {
        arm.clock().sleep(5 * CYCLE);
        arm.set_state(|state| {
            state.error_code = "0x0F0034".to_owned();
            state.enabled = false;
        });
        arm.set_state(|state| state.enabled = true);
    };
    let end = beside(arm.clock(), fail, || robot.run(&to(40.0), LONG)).expect("it is accepted");
    assert_eq!((end.cause(), end.report.absent), (Cause::Stopped, &["error_code", "error_message"][..]), "{end}");
    assert!(end.to_string().contains("an error of the controller is not seen"), "{end}");
    let end = robot.run(&to(10.0), LONG).expect("it is accepted");
    assert!(end.cause() == Cause::Reached && !end.to_string().contains("not seen"), "{end}");

    let session = robot.enter_servo_mode(jaka_robot::ServoConfig::new()).expect("the arm rests");
    let end = session.land().expect("nothing keeps it from landing");
    assert_eq!(end.report.absent, ["error_code", "error_message"]);
}

#[test]
fn a_preflight_tells_what_packets_never_have() {
    let arm = arm(&json!("free"));
    let addresses = (arm.command_addr(), arm.status_addr());
    let preflight = Preflight::read_as::<mapped::RobotStatus>(&arm.config(), addresses.0, addresses.1, None);
    let found = status_packets(&preflight);
    let seen = "absent, as declared: error_code, error_message";
    assert_eq!((found.verdict(), found.seen()), (Verdict::Look, seen));
    assert_eq!(status_packets(&robot::<mapped::RobotStatus>(&arm).preflight()), found);
    // The built-in type cannot read this controller's stop.
    let found = Preflight::read_at(&arm.config(), addresses.0, addresses.1);
    assert_eq!(status_packets(&found).verdict(), Verdict::Wrong, "{found}");
}

#[test]
fn a_program_reads_what_its_pack_leaves_to_it() {
    let arm = Arm::simulated().start();
    let radians = [0.0, 90.0, 90.0, 90.0, -90.0, 0.0].map(f64::to_radians);
    arm.set_status([("joint_actual_position".to_owned(), json!(radians))]);
    arm.publish();
    let mut robot = robot::<radians::RobotStatus>(&arm);
    let end = robot.run(&to(5.0), LONG).expect("nothing keeps it back");
    let joints = end.packets.last().and_then(|last| last.status.joint_actual_position).expect("packets have them");
    assert!((joints.0[1] - 90.0).abs() < 1e-9, "{joints:?}");

    let lacking = Arm::simulated().start();
    lacking.set_status([("joint_actual_position".to_owned(), Value::Null)]);
    lacking.publish();
    lacking.clock().sleep(CYCLE);
    assert_kept_back(&lacking, &mut self::robot::<radians::RobotStatus>(&lacking), "joint_actual_position");
}

/// A program's own type that leaves out the controller's errors, and says so or not.
struct Own<const DECLARES: bool>(RobotStatus);

impl<const DECLARES: bool> Decode for Own<DECLARES> {
    fn decode(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        RobotStatus::decode(reader).map(Self)
    }
}

impl<const DECLARES: bool> MotionStatus for Own<DECLARES> {
    fn robot_status(&self) -> RobotStatus {
        let mut status = self.0.clone();
        status.error_code = None;
        status
    }

    fn absent() -> &'static [&'static str] {
        if DECLARES { &["error_code"] } else { &[] }
    }
}

#[test]
fn a_type_that_leaves_out_errors_without_saying_so_moves_no_arm() {
    let arm = Arm::simulated().start();
    assert_kept_back(&arm, &mut robot::<Own<false>>(&arm), "error_code");
    robot::<Own<true>>(&arm).run(&to(5.0), LONG).expect("it is declared").reached().expect("nothing stops it");
}

/// The client knows the list without the spec.
#[test]
fn the_needed_fields_are_those_of_the_spec() {
    let names = needed(&RobotStatus::default()).map(|(name, _)| name);
    let mut listed: Vec<_> = NEEDED_FIELDS.iter().map(|field| field.name).collect();
    listed.sort_unstable();
    let mut known = names.to_vec();
    known.sort_unstable();
    assert_eq!(known, listed);
    let required: Vec<_> = <Own<false> as MotionStatus>::expected().iter().map(|[name, _]| *name).collect();
    let is_expected =
        |name: &str| name == "error_code" || NEEDED_FIELDS.iter().any(|f| f.name == name && f.is_required);
    let expected: Vec<_> = NEEDED_FIELDS.iter().map(|field| field.name).filter(|name| is_expected(name)).collect();
    assert_eq!(required, expected);
}
