//! Motions, trajectories and streams under a guard that meet each fault together with what trips the guard, by what the
//! controller receives.
//!
//! Not cells of the table: which of the two ends them depends on the moment. What holds in each is asserted.

use std::time::Duration;

use jaka_robot::jaka_motion::{Dynamics, Limits, Model, TimedPoint, Trajectory};
use jaka_robot::motion::JointMove;
use jaka_robot::{
    Cause, End, Error, ErrorKind, Evidence, FollowConfig, GuardTrip, MotionExt as _, Numbering, Robot, RobotConfig,
    ServoConfig, StreamConfig, TripReason,
};
use jaka_sim::{Direction, Port, StatusFault};
use jaka_tests::Configured as _;
use jaka_tests::simulated::{beside, clock_of};

use crate::cell::Kind;
use crate::each;
use crate::landings::{CYCLES, MOST, PERIOD, START, parsed, steps};
use crate::model;
use crate::outcome::Outcome;
use crate::troubles::Trouble;

/// Motion until the guard trips.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Way {
    Motion,
    Trajectory,
    Stream,
}

/// Travel of joint 3 in degrees, and its approximate duration in seconds.
const FAR: f64 = 20.0;
const SECONDS: f64 = 2.5;
/// Time of the fault after the start: the arm moves by then.
const STRUCK: Duration = Duration::from_millis(700);
/// Longer than all of it takes.
const LONG: Duration = Duration::from_secs(20);
const INPUT: jaka_robot::InputCondition = Numbering::FromOne.cabinet(1).rises();

/// Each trouble with each way; fails with all that is wrong.
pub(crate) fn go_through(troubles: &[Trouble]) {
    let ways = [Way::Motion, Way::Trajectory, Way::Stream];
    let tasks: Vec<_> = troubles.iter().flat_map(|trouble| ways.map(|way| (trouble, way))).collect();
    each(&tasks, |(trouble, way)| format!("{trouble}, {way:?}"), |(trouble, way)| guarded(trouble, *way));
}

fn guarded(trouble: &Trouble, way: Way) {
    let arm = Arm::new(trouble, way);
    let config = arm.controller.config().reply_timeout(Duration::from_secs(1));
    let robot = Robot::connect_at(&config, arm.controller.command_addr(), arm.controller.status_addr());
    let robot = robot.expect("the controller listens");
    robot.monitor().next_packet().expect("packets come");
    let limits = Limits::of(Model::named("Zu 5").expect("a published arm"));
    let limits = limits.with_joint_accelerations([MOST; 6]).expect("above 0");
    let mut robot = robot.configured(&RobotConfig::new().limits(limits)).expect("it is this arm");
    match way {
        Way::Motion => arm.judge_motion(&arm.motion(&mut robot)),
        Way::Trajectory => arm.trajectory(&mut robot),
        Way::Stream => arm.stream(&mut robot),
    }
}

/// An arm that something befalls.
struct Arm<'t> {
    trouble: &'t Trouble,
    way: Way,
    controller: jaka_tests::Arm,
}

impl<'t> Arm<'t> {
    fn new(trouble: &'t Trouble, way: Way) -> Self {
        let controller = jaka_tests::Arm::simulated().status_period(Duration::from_millis(30)).at(START).start();
        Self { trouble, way, controller }
    }

    /// After some time on the way it goes wrong, the input goes high, and what is held for a time is released after it.
    fn strike(&self) {
        let clock = clock_of(&self.controller);
        clock.sleep(STRUCK);
        let moved = self.controller.state().joint_position.0[2] - START[2];
        assert!((0.5..FAR / 2.0).contains(&moved), "{}: the arm has moved by {moved} deg", self.what());
        let command = if self.way == Way::Motion { "stop_program" } else { "servo_j" };
        if let Some(fault) = self.trouble.fault(command) {
            self.controller.inject_for(command, fault);
        }
        self.controller.status_fault(self.trouble.status());
        let lasting = match self.trouble {
            Trouble::Link(link) => {
                link.strike(&self.controller);
                link.lasting
            }
            _ => None,
        };
        self.controller.set_state(|state| state.digital_inputs[0] = true);
        if let Some(time) = lasting {
            clock.sleep(time);
            self.controller.links().release();
        }
    }

    /// Clears all faults, releases the links, and lets the arm run for a time.
    fn lift(&self, time: Duration) {
        self.controller.clear_faults();
        self.controller.status_fault(StatusFault::None);
        self.controller.links().release();
        clock_of(&self.controller).sleep(time);
    }

    fn motion(&self, robot: &mut Robot) -> End {
        let target = [START[0], START[1], START[2] + FAR, START[3], START[4], START[5]];
        let motion = JointMove::absolute(target, FAR / SECONDS).acceleration(MOST);
        let clock = clock_of(&self.controller);
        beside(clock, || self.strike(), || robot.run(&motion.guard(INPUT), LONG)).expect("its reply came before")
    }

    fn trajectory(&self, robot: &mut Robot) {
        let mut end = START;
        end[2] += FAR;
        let points = [TimedPoint::new(0.0, START), TimedPoint::new(SECONDS, end)];
        let trajectory = Trajectory::timed(&points, robot.limits().expect("it has some")).expect("it is within them");
        let config = FollowConfig::new().servo(servo());
        let run = robot.start_follow(&trajectory, &config.clone().guard(INPUT)).expect("nothing is wrong yet");
        self.strike();
        let end = run.wait();
        let state = self.controller.state();
        assert!(!end.rest.was_seen() || state.at_rest, "{}: {end}: {state:?}", self.what());
        let error = end.error.as_ref().unwrap_or_else(|| panic!("{}: {end}", self.what()));
        let expected = match end.cause() {
            Cause::Guard => error_kinds(error).any(|kind| matches!(kind, ErrorKind::GuardTripped { .. })),
            Cause::StatusLost => !self.has_packets(),
            Cause::CommandsLost | Cause::Unanswered | Cause::Refused | Cause::Failed => !self.has_replies(),
            _ => false,
        };
        assert!(expected, "{}: {end:?}", self.what());
        self.judge_set_points(error);
    }

    fn stream(&self, robot: &mut Robot) {
        let limits = robot.limits().expect("it has some").limits();
        let dynamics = Dynamics::of(limits).with_speeds([FAR / SECONDS; 6]).expect("they are enough");
        let config = StreamConfig::new().servo(servo()).dynamics(dynamics);
        let stream = robot.stream(&config.clone().guard(INPUT)).expect("nothing is wrong yet");
        let mut target = stream.handle().joints();
        target[2] += FAR;
        stream.handle().set_joints(target).expect("it runs");
        let (handle, clock) = (stream.handle(), clock_of(&self.controller));
        self.strike();
        let since = clock.elapsed();
        while handle.set_joints(target).is_ok() {
            assert!(clock.elapsed().saturating_sub(since) < LONG, "{}: it goes on", self.what());
            // Not asleep: where it has ended, the time waits for who waits for it.
            let _ = handle.wait_for_rest(Duration::from_millis(100));
        }
        self.judge_set_points(&stream.land().expect_err("it was not asked to land before"));
    }

    /// Checks that the end of a motion is true, whatever the fault.
    fn judge_motion(&self, end: &End) {
        let (what, state) = (format!("{}: {:?}, {:?}", self.what(), end.cause(), end.stop), self.controller.state());
        match end.evidence() {
            Evidence::Trip(trip) => {
                assert!(self.is_true(trip), "{what}");
                assert!(!trip.is_at_rest || state.at_rest, "{what}: {state:?}");
            }
            Evidence::Status { .. } => assert!(!self.has_packets(), "{what}"),
            Evidence::Commands { .. } => assert!(!self.has_replies(), "{what}"),
            _ => panic!("{what}"),
        }
        let accepted = end.stop.as_ref().unwrap_or_else(|| panic!("{what}: nobody has stopped it"));
        self.lift(Duration::from_secs_f64(SECONDS));
        let (state, stops) = (self.controller.state(), self.received("stop_program"));
        let at = state.joint_position.0[2] - START[2];
        assert!(state.at_rest, "{what}: {state:?}");
        // No stop that came is told as one that was not sent, and none is told as accepted that did not stop the arm.
        assert!(stops <= 1 && self.received("joint_move") == 1, "{what}: {:?}", self.controller.requests());
        assert!(stops == 1 || !self.has_requests(), "{what}: it can be reached");
        assert!(at < FAR - 1.0 || accepted.is_err(), "{what}: it went on to {at}");
        match accepted {
            Ok(()) => assert!(stops == 1, "{what}"),
            Err(error) => assert!(stops == 0 || error.may_have_run() || error.is_refused(), "{what}"),
        }
        assert!(stops == 0 || at < FAR - 1.0 || !self.has_requests(), "{what}: {at}");
        assert!(accepted.is_ok() || !(self.has_requests() && self.has_replies()), "{what}");
    }

    fn judge_set_points(&self, error: &Error) {
        self.lift(Duration::from_millis(500));
        let (requests, state) = (parsed(&self.controller), self.controller.state());
        let steps = steps(&requests);
        let what = || format!("{}: {error:?}: {steps:?}", self.what());
        for kind in error_kinds(error) {
            if let ErrorKind::GuardTripped { trip } = kind {
                assert!(self.is_true(trip), "{}", what());
            }
        }
        let jumps = steps.windows(2).any(|two| (two[1] - two[0]).abs() > MOST * PERIOD * PERIOD * (1.0 + 1e-6));
        assert!(!jumps, "{}", what());
        let off = requests.iter().position(|request| request["cmdName"] == "servo_move" && request["relFlag"] == 0);
        let after = off.map_or(&[][..], |off| &requests[off..]);
        assert!(after.iter().all(|request| request["cmdName"] != "servo_j"), "a set-point after the end: {}", what());
        // What is not at rest is said, or the connection is gone.
        let tells = error_kinds(error).any(|kind| {
            matches!(kind, ErrorKind::Connection(error) if error.is_disconnected())
                || matches!(
                    kind,
                    ErrorKind::SetPointsUnanswered { .. }
                        | ErrorKind::ServoModeNotLeft { .. }
                        | ErrorKind::NotLanded { .. }
                )
        });
        let (rests, at) = (steps.last() == Some(&0.0), state.joint_position.0[2] - START[2]);
        assert!(rests || tells, "{}", what());
        assert!(!self.has_replies() || rests && off.is_some() && !state.servo_mode, "{state:?}: {}", what());
        assert!(state.at_rest && at < FAR - 1.0, "{at}: {}", what());
        if self.has_replies() && self.has_packets() {
            assert!(matches!(error.kind(), ErrorKind::GuardTripped { .. }), "{}", what());
        }
    }

    /// Whether a guard tripped by the input, or by a packet that does not show it.
    fn is_true(&self, trip: &GuardTrip) -> bool {
        let inputs = trip.packet.status.digital_inputs.as_ref();
        let is_high = inputs.and_then(|inputs| inputs.first()) == Some(&true);
        let is_so = match trip.reason {
            TripReason::Holds => is_high && self.has_packets(),
            TripReason::NotShown(_) => inputs.is_none() && !self.has_packets(),
            _ => false,
        };
        is_so && !trip.is_before_start
    }

    /// True if packets come, and in time.
    fn has_packets(&self) -> bool {
        model::expected(self.trouble, Kind::Monitor).first == Outcome::Ok
    }

    /// True if requests reach the controller, and in time.
    fn has_requests(&self) -> bool {
        !matches!(self.trouble, Trouble::Link(link) if !link.is_in_time() && link.is_on(Port::Command, Direction::ToController))
    }

    /// True if the replies come, in time, and nothing else.
    fn has_replies(&self) -> bool {
        let expected = model::expected(self.trouble, Kind::Stop);
        expected.first == Outcome::Ok && expected.other == Outcome::Ok
    }

    fn received(&self, command: &str) -> usize {
        parsed(&self.controller).iter().filter(|request| request["cmdName"] == command).count()
    }

    fn what(&self) -> String {
        format!("{}, {:?}", self.trouble, self.way)
    }
}

fn servo() -> ServoConfig {
    ServoConfig::new().step_count(CYCLES)
}

/// The kind of an error, and of those that it wraps.
fn error_kinds(error: &Error) -> impl Iterator<Item = &ErrorKind> {
    std::iter::successors(Some(error.kind()), |kind| match kind {
        ErrorKind::RestNotSeen { first: Some(first), .. }
        | ErrorKind::NotLanded { first, .. }
        | ErrorKind::ServoModeNotLeft { first: Some(first), .. } => Some(first.kind()),
        _ => None,
    })
}
