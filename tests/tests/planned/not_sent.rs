//! Errors of the queries that a call makes before it moves the arm, or before a step of its power. Nothing was sent
//! then, by the bytes that the controller has received, and the error says so.

use std::time::Duration;

use jaka_proto::Envelope;
use jaka_robot::frames::SetToolId;
use jaka_robot::jaka_motion::{Limits, Model, Trajectory, Via};
use jaka_robot::motion::{EndMove, JointMove, MoveL};
use jaka_robot::servo::SetServoMoveFilter;
use jaka_robot::{
    Error, ErrorKind, FollowConfig, Guard, MotionExt as _, Remedy, Robot, RobotConfig, ServoConfig, StreamConfig,
};
use jaka_sim::Fault;
use jaka_tests::{Arm, Configured as _, LONG};

const START: [f64; 6] = [0.0, 90.0, 90.0, 90.0, -90.0, 0.0];

/// Commands that move the arm.
const MOTIONS: [&str; 5] = ["joint_move", "end_move", "moveL", "servo_j", "servo_p"];
/// Commands that concern its power.
const STEPS: [&str; 4] = ["power_on", "enable_robot", "disable_robot", "power_off"];

/// A call, and the robot that makes it.
struct Case {
    name: &'static str,
    ready: fn() -> (Arm, Robot),
    call: fn(&mut Robot) -> Result<(), Error>,
}

/// Timeout for a reply, for entering servo mode, and for a call.
const SHORT: Duration = Duration::from_millis(500);

fn bare() -> (Arm, Robot) {
    Arm::simulated().at(START).config(|config| config.reply_timeout(SHORT)).with_robot()
}

fn limited() -> (Arm, Robot) {
    let (arm, robot) = bare();
    let limits = Limits::of(Model::named("Zu 5").expect("a published arm"));
    (arm, robot.configured(&RobotConfig::new().limits(limits)).expect("it is this arm"))
}

/// The limits do not know the frames of the arm.
fn framed() -> (Arm, Robot) {
    let (arm, mut robot) = limited();
    robot.client().call(&SetToolId::new(1)).expect("there is one");
    (arm, robot)
}

fn without_power() -> (Arm, Robot) {
    Arm::simulated().without_power().config(|config| config.reply_timeout(SHORT)).with_robot()
}

fn offset() -> JointMove {
    JointMove::relative([0.5, 0.0, 0.0, 0.0, 0.0, 0.0], 25.0).acceleration(50.0)
}

fn line() -> MoveL {
    MoveL::relative([0.0, 0.0, 1.0, 0.0, 0.0, 0.0], 20.0).acceleration(100.0)
}

const CASES: [Case; 14] = [
    Case { name: "offset", ready: bare, call: |robot| robot.run(&offset(), LONG).map(drop) },
    Case { name: "start of an offset", ready: bare, call: |robot| robot.start(&offset()) },
    Case { name: "line", ready: bare, call: |robot| robot.run(&line(), LONG).map(drop) },
    Case {
        name: "offset under a guard",
        ready: bare,
        call: |robot| robot.run(&offset().guard(Guard::when("never", |_| false)), LONG).map(drop),
    },
    Case { name: "offset within limits", ready: limited, call: |robot| robot.run(&offset(), LONG).map(drop) },
    Case { name: "line within limits", ready: framed, call: |robot| robot.run(&line(), LONG).map(drop) },
    Case {
        name: "pose within limits",
        ready: limited,
        call: |robot| {
            let pose =
                robot.limits().expect("it has some").limits().model().forward(jaka_robot::types::JointPosition(START));
            robot.run(&EndMove::new(jaka_robot::types::Pose::from(pose), 10.0).acceleration(50.0), LONG).map(drop)
        },
    },
    Case { name: "session", ready: bare, call: |robot| robot.enter_servo_mode(servo())?.send_joint_offset([0.0; 6]) },
    Case {
        name: "session with a filter, within limits",
        ready: framed,
        call: |robot| {
            let config = servo().filter(SetServoMoveFilter::disabled());
            robot.enter_servo_mode(config)?.send_joint_offset([0.0; 6])
        },
    },
    Case { name: "stream", ready: limited, call: stream },
    Case { name: "trajectory", ready: limited, call: |robot| follow(robot, &FollowConfig::new().servo(servo())) },
    Case {
        name: "trajectory in other frames",
        ready: framed,
        call: |robot| follow(robot, &FollowConfig::new().servo(servo())),
    },
    Case { name: "power up", ready: without_power, call: |robot| robot.power_up(LONG) },
    Case { name: "power down", ready: bare, call: |robot| robot.power_down(LONG) },
];

fn servo() -> ServoConfig {
    ServoConfig::new().enter_timeout(SHORT)
}

fn stream(robot: &mut Robot) -> Result<(), Error> {
    let stream = robot.stream(&StreamConfig::new().servo(servo()))?;
    let mut end = START;
    end[0] += 0.5;
    stream.handle().set_joints(end).expect("within its range");
    stream.handle().wait_for_rest(LONG).map(drop)
}

fn follow(robot: &mut Robot, config: &FollowConfig) -> Result<(), Error> {
    let mut end = START;
    end[0] += 0.5;
    let points = [Via::joints(START), Via::joints(end)];
    let checker = robot.limits().expect("it has some");
    let trajectory = Trajectory::through(points).joint_speeds([20.0; 6]).build(checker).expect("within them");
    robot.start_follow(&trajectory, config).map(|run| drop(run.wait()))
}

/// Names of the requests after the first so many.
fn names(arm: &Arm, after: usize) -> Vec<String> {
    let name = |text: &String| Envelope::read(text).ok()?.command.map(std::borrow::Cow::into_owned);
    arm.requests().iter().skip(after).filter_map(name).collect()
}

fn moves(name: &str) -> bool {
    MOTIONS.contains(&name) || STEPS.contains(&name)
}

/// Names of the requests until the first that moves the arm, or concerns its power.
fn before_motion(case: &Case) -> (Vec<String>, String) {
    let (arm, mut robot) = (case.ready)();
    let asked = arm.requests().len();
    (case.call)(&mut robot).unwrap_or_else(|error| panic!("{}: {error}", case.name));
    let mut sent = names(&arm, asked);
    let first = sent.iter().position(|name| moves(name)).expect("it moves the arm, or switches its power");
    let motion = sent.swap_remove(first);
    sent.truncate(first);
    (sent, motion)
}

#[test]
fn an_error_of_a_query_before_a_motion_does_not_claim_that_the_motion_may_have_run() {
    let mut cells = 0;
    for case in &CASES {
        let (queries, motion) = before_motion(case);
        assert!(!queries.is_empty(), "{} asks nothing", case.name);
        for (at, query) in queries.iter().enumerate() {
            // It is no query. Whether servo mode is on is not known then.
            let is_entry = query == "servo_move";
            // Of many in a row, the first and the last.
            let is_amid = at > 0 && queries[at - 1] == *query && queries.get(at + 1) == Some(query);
            if is_entry || is_amid {
                continue;
            }
            let refused = format!(r#"{{"errorCode": "2", "errorMsg": "no", "cmdName": "{query}"}}"#);
            let unfit = format!(r#"{{"errorCode": "0", "errorMsg": "", "cmdName": "{query}"}}"#);
            let instead = |reply: String| Fault::Instead(reply.into_bytes());
            for fault in [Fault::Close, Fault::HalfOpen, Fault::Drop, instead(refused), instead(unfit)] {
                let (arm, mut robot) = (case.ready)();
                let asked = arm.requests().len();
                (0..at).for_each(|_| arm.inject(Fault::None));
                arm.inject(fault.clone());
                let what = format!("{}, {fault} at {query} {at}", case.name);
                let result = (case.call)(&mut robot);
                let sent = names(&arm, asked);
                let Err(error) = result else {
                    // The place of the arm is not needed, or the controller was asked again.
                    assert!(sent.iter().any(|name| moves(name)), "{what}: it is done, and nothing was sent: {sent:?}");
                    continue;
                };
                cells += 1;
                assert!(!sent.iter().any(|name| moves(name)), "{what}: {error}: {sent:?}");
                let has_entered = sent.iter().any(|name| name == "servo_move");
                if has_entered && matches!(error.kind(), ErrorKind::ServoModeNotLeft { .. }) {
                    continue;
                }
                assert!(!error.may_have_run(), "{what}: {error:?}");
                assert!(!error.to_string().contains("may have run"), "{what}: {error}");
                assert!(!matches!(error.remedy(), Remedy::None | Remedy::SeeError), "{what}: {error:?}");
                let next =
                    if MOTIONS.contains(&&*motion) && !has_entered && queries.iter().any(|name| name == "servo_move") {
                        "servo_move"
                    } else {
                        &*motion
                    };
                assert!(error.to_string().contains(&format!("`{next}` was not sent")), "{what}: {error}");
                assert_eq!(error.is_disconnected(), fault == Fault::Close, "{what}: {error}");
            }
        }
    }
    assert!(cells > 100, "{cells}");
}
