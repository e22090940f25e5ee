//! The state of an arm, as gates know it at each moment.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError, mpsc};
use std::thread;
use std::time::Duration;

use jaka_proto::wire::{Decode, DecodeError, Reader};
use jaka_robot::motion::JointMove;
use jaka_robot::status::RobotStatus;
use jaka_robot::{Cause, ErrorKind, Guard, Monitor, MotionExt as _, MotionStatus, Robot, ServoConfig};
use jaka_tests::{Arm, LONG};

/// Pause between two looks at the state of another thread.
const AGAIN: Duration = Duration::from_millis(2);

fn to(angle: f64, speed: f64) -> JointMove {
    JointMove::absolute([angle, 90.0, 90.0, 90.0, -90.0, 0.0], speed).acceleration(400.0)
}

fn sent(arm: &Arm, name: &str) -> usize {
    arm.requests().iter().filter(|request| request.contains(&format!("\"cmdName\":\"{name}\""))).count()
}

fn until(is_so: impl Fn() -> bool) {
    while !is_so() {
        thread::sleep(AGAIN);
    }
}

#[test]
fn a_wait_that_saw_the_arm_at_rest_is_not_enough_for_servo_mode() {
    let (arm, mut robot) = Arm::simulated().with_robot();
    robot.run(&to(5.0, 40.0), LONG).expect("it is reachable").reached().expect("it ends there");
    let before = sent(&arm, "get_joint_pos");
    let session = robot.enter_servo_mode(ServoConfig::new()).expect("the arm rests");
    let asked = sent(&arm, "get_joint_pos") - before;
    drop(session);
    assert_eq!(asked, 4, "three answers that show rest, and where it begins");
}

/// The question runs on the monitor's thread, which has read the packet that shows the stop.
#[test]
fn a_slow_question_of_a_guard_keeps_no_gate_from_a_stop_that_was_read() {
    let status_period = Duration::from_millis(20);
    let (guarded, other) = (Arm::real_time().status_period(status_period).start(), Arm::real_time().start());
    let monitor: Arc<Monitor> = Arc::new(guarded.monitor());
    let mut first = Robot::new(guarded.client(), Arc::clone(&monitor));
    let mut second = Robot::new(other.client(), Arc::clone(&monitor));
    let ((seen, saw), (go_on, may_go_on)) = (mpsc::channel(), mpsc::channel::<()>());
    let (seen, may_go_on) = (Mutex::new(seen), Mutex::new(may_go_on));
    let guard = Guard::when("slow", move |status| {
        if status.protective_stop == Some(true) {
            let _ = seen.lock().unwrap_or_else(PoisonError::into_inner).send(());
            let _ = may_go_on.lock().unwrap_or_else(PoisonError::into_inner).recv();
        }
        false
    });
    let error = thread::scope(|scope| {
        scope.spawn(|| {
            let end = first.run(&to(30.0, 1.0).guard(guard), LONG).expect("it is sent");
            assert!(end.reached().is_err(), "a stop has ended it");
        });
        until(|| sent(&guarded, "joint_move") > 0);
        guarded.set_state(|state| state.protective_stop = true);
        saw.recv_timeout(LONG).expect("the packet comes");
        let error = second.start(&to(5.0, 40.0)).expect_err("a packet has shown a stop");
        drop(go_on);
        error
    });
    assert_eq!(error.cause(), Cause::ProtectiveStop, "{error:?}");
    assert_eq!(sent(&other, "joint_move"), 0);
}

/// Held where the robot is made, until the test lets it go on.
static HELD: Mutex<Option<mpsc::Receiver<()>>> = Mutex::new(None);
static IS_HELD: AtomicBool = AtomicBool::new(false);
const MAKER: &str = "maker";

struct Held(RobotStatus);

impl Decode for Held {
    fn decode(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        RobotStatus::decode(reader).map(Self)
    }
}

impl MotionStatus for Held {
    fn robot_status(&self) -> RobotStatus {
        if thread::current().name() == Some(MAKER) {
            let held = HELD.lock().unwrap_or_else(PoisonError::into_inner).take();
            if let Some(may_go_on) = held {
                IS_HELD.store(true, Ordering::SeqCst);
                let _ = may_go_on.recv();
            }
        }
        self.0.clone()
    }
}

#[test]
fn a_packet_that_cannot_be_read_counts_also_while_a_robot_is_made() {
    let arm = Arm::real_time().no_packets().start();
    let monitor: Arc<Monitor<Held>> = Arc::new(arm.monitor());
    arm.publish();
    monitor.wait_until(|_| true, LONG).expect("a packet comes");
    let (go_on, may_go_on) = mpsc::channel();
    *HELD.lock().unwrap_or_else(PoisonError::into_inner) = Some(may_go_on);
    let (client, shared) = (arm.client(), Arc::clone(&monitor));
    let make = move || Robot::with_monitor(client, shared);
    let maker = thread::Builder::new().name(MAKER.to_owned()).spawn(make).expect("there are threads");
    until(|| IS_HELD.load(Ordering::SeqCst));
    let before = monitor.statistics().unfit;
    arm.send_status(br#"{"len": 40 "enabled": true}"#);
    until(|| monitor.statistics().unfit > before);
    drop(go_on);
    let mut robot = maker.join().expect("it does not panic");
    let error = robot.start(&to(5.0, 40.0)).expect_err("the newest packet cannot be read");
    assert!(matches!(error.kind(), ErrorKind::StatusUnknown { .. }), "{error:?}");
    assert_eq!(sent(&arm, "joint_move"), 0);
}
