//! Shared code of the tests: an arm with its client, and the list of a topic's commands.

use std::time::Duration;

use jaka_sync::motion::JointMove;
use jaka_sync::proto::Request;
use jaka_sync::status::RobotStatus;
use jaka_sync::types::Pose;
use jaka_sync::{Client, Error, StatusStream};

/// Makes a test of each `command => function`, and the list of the commands.
///
/// The function must send the command to the arm that it is given. Commands that are wrong in the list fail the test;
/// one whose function is in no list is dead code.
macro_rules! effects {
    ($($command:ident => $effect:ident),+ $(,)?) => {
        /// The commands that have a test here.
        pub(crate) const COVERED: &[&str] = &[$(stringify!($command)),+];

        #[allow(non_snake_case, reason = "a test bears its command's name")]
        mod effect_of {
            $(#[test]
            fn $command() {
                $crate::effects::arm::check(stringify!($command), super::$effect);
            })+
        }
    };
}

/// Runs a test on an arm of its own, and makes sure that it sent the command.
pub(crate) fn check(command: &str, effect: fn(&mut Arm)) {
    let mut arm = Arm::ready();
    effect(&mut arm);
    let requests = arm.controller.requests();
    let sent = |text: &String| Request::read(text).is_ok_and(|request| request.info().name == command);
    assert!(requests.iter().any(sent), "`{command}` is not among {requests:?}");
}

/// An arm that is enabled, its controller and a client.
pub(crate) struct Arm {
    pub(crate) controller: jaka_tests::Arm,
    pub(crate) client: Client,
}

impl Arm {
    pub(crate) fn ready() -> Self {
        let (controller, client) = jaka_tests::Arm::stepped().no_packets().with_client();
        Self { controller, client }
    }

    /// Lets time go on.
    pub(crate) fn wait(&self, seconds: u64) {
        self.controller.advance(Duration::from_secs(seconds));
    }

    /// Status on port 10000.
    pub(crate) fn status(&self) -> RobotStatus {
        self.stream().1
    }

    /// A reader of port 10000, and the packet it gets at once. No other comes unasked.
    pub(crate) fn stream(&self) -> (StatusStream, RobotStatus) {
        let mut stream = self.controller.stream();
        let packet = stream.next_packet().expect("the first packet comes at once");
        (stream, packet)
    }

    /// The joints as port 10000 shows them.
    pub(crate) fn joints(&self) -> [f64; 6] {
        self.status().joint_actual_position.expect("the packet has joints").0
    }

    /// The tool centre point as port 10000 shows it.
    pub(crate) fn pose(&self) -> [f64; 6] {
        self.status().actual_position.expect("the packet has a pose").into()
    }

    /// Takes back the power, the enabling or servo mode, and has the command refused.
    #[track_caller]
    pub(crate) fn refuses<T>(
        &mut self,
        state: impl FnOnce(&mut jaka_sim::State),
        send: impl FnOnce(&mut Client) -> Result<T, Error>,
    ) {
        self.controller.set_state(state);
        refused(send(&mut self.client));
    }
}

/// The arm is not enabled.
pub(crate) fn disabled(state: &mut jaka_sim::State) {
    state.enabled = false;
}

/// Servo mode is on.
pub(crate) fn servo_mode(state: &mut jaka_sim::State) {
    state.servo_mode = true;
}

/// A turn of joint 1 from where it is, in degrees, at 20 deg/s.
pub(crate) fn turn(angle: f64) -> JointMove {
    JointMove::relative(turned([0.0; 6], angle), 20.0).acceleration(80.0)
}

/// These joints with joint 1 turned.
pub(crate) fn turned(mut joints: [f64; 6], angle: f64) -> [f64; 6] {
    joints[0] += angle;
    joints
}

/// A pose upwards of this one, by this many millimetres.
pub(crate) fn raised(mut pose: [f64; 6], by: f64) -> Pose {
    pose[2] += by;
    pose.into()
}

/// A displacement.
pub(crate) fn shift(x: f64, y: f64, z: f64) -> Pose {
    Pose { x, y, z, rx: 0.0, ry: 0.0, rz: 0.0 }
}

#[track_caller]
pub(crate) fn refused<T>(result: Result<T, Error>) {
    assert!(result.is_err_and(|error| error.is_refused()));
}

#[track_caller]
pub(crate) fn assert_close(a: impl Into<[f64; 6]>, b: impl Into<[f64; 6]>, tolerance: f64) {
    let (a, b) = (a.into(), b.into());
    assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance), "{a:?} is not {b:?}");
}
