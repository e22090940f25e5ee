//! Panics of what a program gives to a client, a logger or the type of a reply: they take nothing from the connection.

use std::panic::{self, AssertUnwindSafe};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use jaka_robot::motion::JointMove;
use jaka_robot::{MotionExt as _, Numbering};
use jaka_sim::{Controller, Fault};
use jaka_sync::kinematics::GetJointPos;
use jaka_sync::proto::check::{FieldLimits, NotSent, Place, Validate};
use jaka_sync::proto::wire::{DecodeError, Fields, Reader, Writer};
use jaka_sync::{Client, Command, CommandInfo};
use jaka_tests::simulated::beside;
use jaka_tests::{Arm, LONG};
use log::{LevelFilter, Log, Metadata, Record};

/// Panics at each message that comes, while it is to, or at one alone: the reply to a motion.
struct Panicking {
    always: AtomicBool,
    at_motion: AtomicBool,
}

impl Log for Panicking {
    fn enabled(&self, metadata: &Metadata<'_>) -> bool {
        metadata.target() == "jaka_sync::wire"
    }

    fn log(&self, record: &Record<'_>) {
        let comes = self.enabled(record.metadata()) && !record.args().to_string().starts_with("->");
        let is_motion = || record.args().to_string().contains("joint_move") && self.at_motion.load(Ordering::SeqCst);
        let is_to = comes && (self.always.load(Ordering::SeqCst) || is_motion());
        assert!(!is_to, "as the test wants");
    }

    fn flush(&self) {}
}

static LOGGER: Panicking = Panicking { always: AtomicBool::new(false), at_motion: AtomicBool::new(false) };

/// `get_joint_pos` with a reply that cannot be read without a panic.
struct Ask;

#[derive(Debug)]
struct Unreadable;

impl Fields for Ask {
    fn write_fields(&self, _out: &mut Writer) {}

    fn read_fields(_reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self)
    }
}

impl Validate for Ask {
    fn validate(&self, _place: &Place<'_>, _limits: &FieldLimits) -> Result<(), NotSent> {
        Ok(())
    }
}

impl Fields for Unreadable {
    fn write_fields(&self, _out: &mut Writer) {}

    fn read_fields(_reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        panic!("as the test wants")
    }
}

impl Command for Ask {
    type Reply = Unreadable;

    const INFO: &'static CommandInfo = GetJointPos::INFO;
}

fn panics<T>(act: impl FnOnce() -> T) -> bool {
    panic::catch_unwind(AssertUnwindSafe(act)).is_err()
}

/// Calls and stops are answered, each with its own reply.
fn assert_usable(controller: &Controller, client: &mut Client) {
    let joints = [1.0, 2.0, 3.0, 4.0, 5.0, 6.5];
    controller.set_state(|state| state.joint_position = joints.into());
    assert_eq!(client.get_joint_pos().expect("the connection works").joint_position, joints.into());
    client.stop_handle().stop().expect("the connection works");
    assert!(client.disconnect_cause().is_none());
}

#[test]
fn a_panic_of_a_logger_or_of_a_reply_takes_nothing_from_the_connection() {
    log::set_logger(&LOGGER).expect("this is the only test of the process");
    log::set_max_level(LevelFilter::Trace);
    let (controller, mut client) = Arm::simulated().with_client();
    for _ in 0..3 {
        assert!(panics(|| client.call(&Ask)), "the reply's type panics");
        assert_usable(&controller, &mut client);
        LOGGER.always.store(true, Ordering::SeqCst);
        assert!(panics(|| client.get_version()), "the logger panics");
        let stop = client.stop_handle();
        assert!(panics(|| stop.stop()), "the logger panics");
        LOGGER.always.store(false, Ordering::SeqCst);
        assert_usable(&controller, &mut client);
    }
    // A late reply is logged twice.
    controller.inject(Fault::Hold);
    assert!(client.call_within(&GetJointPos::new(), Duration::from_millis(50)).is_err_and(|error| error.is_timeout()));
    LOGGER.always.store(true, Ordering::SeqCst);
    controller.release();
    assert!(panics(|| client.get_version()), "the logger panics");
    LOGGER.always.store(false, Ordering::SeqCst);
    assert_usable(&controller, &mut client);
    a_panic_of_one_thread_leaves_its_reply_to_another(&controller, client);
    a_panic_while_a_motion_runs_under_a_guard_stops_the_arm();
}

/// The logger panics over the reply to the motion: nobody waits for its end, and the guard is judged no longer.
fn a_panic_while_a_motion_runs_under_a_guard_stops_the_arm() {
    let (arm, mut robot) = Arm::simulated().with_robot();
    let far = JointMove::absolute([100.0, 90.0, 90.0, 90.0, -90.0, 0.0], 25.0).acceleration(500.0);
    let guarded = far.guard(Numbering::FromOne.cabinet(1).is_high());
    LOGGER.at_motion.store(true, Ordering::SeqCst);
    assert!(panics(|| robot.run(&guarded, LONG)), "the logger panics");
    LOGGER.at_motion.store(false, Ordering::SeqCst);
    arm.clock().sleep(Duration::from_secs(1));
    let sent = |name: &str| arm.requests().iter().filter(|request| request.contains(name)).count();
    assert_eq!((sent("joint_move"), sent("stop_program")), (1, 1));
    let state = arm.state();
    assert!(state.at_rest && state.joint_position.0[0] < 99.0, "at {:?}", state.joint_position);
}

/// The thread that reads for all panics over the reply to another.
fn a_panic_of_one_thread_leaves_its_reply_to_another(controller: &Arm, mut client: Client) {
    let stop = client.stop_handle();
    controller.inject(Fault::Hold);
    let sent = controller.requests().len();
    let wait = || assert!(panics(|| client.call(&Ask)));
    beside(controller.clock(), wait, || {
        assert!(controller.wait_for_requests(sent + 1, LONG));
        stop.stop().expect("the stop has its reply, whichever thread reads it");
    });
    assert_usable(controller, &mut client);
}
