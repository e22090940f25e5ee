//! The real-time priority of the thread that sends set-points. The system may allow or deny it: the tests check the
//! consequences of either answer. The sessions go by simulated clocks, the priorities are the system's.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Duration;
use std::{fs, io};

use jaka_robot::jaka_motion::{Limits, Model};
use jaka_robot::{End, Error, ErrorKind, Robot, RobotConfig, ServoConfig, ServoSession, StreamConfig};
use jaka_sim::Controller;
use jaka_tests::Arm;
use jaka_tests::Configured as _;
use jaka_tests::simulated::beside;

const PRIORITY: u8 = 7;

/// Scheduling of a thread.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Scheduling {
    nice: i32,
    priority: u8,
    is_fifo: bool,
}

impl Scheduling {
    fn own() -> Self {
        let stat = fs::read_to_string("/proc/thread-self/stat").expect("Linux has it");
        Self::read(&stat)
    }

    /// The fields 19, 40 and 41.
    fn read(stat: &str) -> Self {
        let fields: Vec<_> = stat.rsplit(')').next().expect("there is a last part").split_whitespace().collect();
        let number = |at: usize| fields[at - 3].parse::<i32>().expect("it is a number");
        Self { nice: number(19), priority: number(40).try_into().expect("at most 99"), is_fifo: number(41) == 1 }
    }

    fn with(self, priority: u8) -> Self {
        Self { priority, is_fifo: true, ..self }
    }
}

/// The streams' threads of this process.
fn streams() -> Vec<Scheduling> {
    let threads = fs::read_dir("/proc/self/task").expect("Linux has it");
    let stats = threads.filter_map(|thread| fs::read_to_string(thread.ok()?.path().join("stat")).ok());
    stats.filter(|stat| stat.contains("(jaka stream)")).map(|stat| Scheduling::read(&stat)).collect()
}

fn ready() -> (Arm, Robot) {
    Arm::simulated().with_robot()
}

fn config(priority: u8) -> ServoConfig {
    ServoConfig::new().realtime_priority(priority)
}

/// The session, unless the system does not allow the priority.
fn entered<'r>(controller: &Controller, robot: &'r mut Robot) -> Option<ServoSession<'r>> {
    match robot.enter_servo_mode(config(PRIORITY)) {
        Ok(session) => Some(session),
        Err(error) => {
            assert_is_refusal(&error, PRIORITY);
            assert!(
                !controller.requests().iter().any(|request| request.contains("servo_move")),
                "nothing was asked for"
            );
            None
        }
    }
}

fn assert_is_refusal(error: &Error, asked: u8) {
    let ErrorKind::RealtimePriority { priority, source } = error.kind() else { panic!("{error}") };
    assert_eq!((*priority, error.may_have_run(), error.is_disconnected()), (asked, false, false));
    if source.kind() == io::ErrorKind::PermissionDenied {
        let text = error.to_string();
        assert!(["`rtprio`", "`ulimit -r`", "CAP_SYS_NICE"].iter().all(|help| text.contains(help)), "{text}");
    }
}

#[test]
fn the_thread_has_the_priority_until_its_session_ends() {
    type End = fn(ServoSession<'_>);
    let ends: [(&str, End); 3] = [
        ("land", |session| drop(session.land().expect("nothing was refused"))),
        ("drop", |session| drop(session)),
        ("panic", |session| {
            let panics = move || {
                let _session = session;
                panic!("the caller panics");
            };
            catch_unwind(AssertUnwindSafe(panics)).expect_err("it panics");
        }),
    ];
    for (name, end) in ends {
        let (arm, mut robot) = ready();
        let own = Scheduling::own();
        if let Some(mut session) = entered(&arm, &mut robot) {
            assert_eq!(Scheduling::own(), own.with(PRIORITY), "{name}");
            session.send_joint_offset([0.01; 6]).expect("servo mode is on");
            end(session);
        }
        assert_eq!(Scheduling::own(), own, "{name}");
    }
}

#[test]
fn a_session_that_ends_by_an_error_gives_the_priority_back_at_once() {
    let (arm, mut robot) = ready();
    let own = Scheduling::own();
    let Some(mut session) = entered(&arm, &mut robot) else { return };
    session.send_joint_offset([1.9; 6]).expect_err("it is too fast");
    assert_eq!(Scheduling::own(), own);
    assert!(!arm.state().servo_mode);
    drop(session);
    assert_eq!(Scheduling::own(), own);
}

#[test]
fn a_session_that_is_not_entered_leaves_the_thread_as_it_was() {
    let (arm, mut robot) = ready();
    arm.set_state(|state| state.enabled = false);
    let own = Scheduling::own();
    robot.enter_servo_mode(config(PRIORITY)).expect_err("the arm is not enabled");
    assert_eq!(Scheduling::own(), own);
}

#[test]
fn a_session_that_ends_in_another_thread_leaves_that_one_as_it_was() {
    let (arm, mut robot) = ready();
    let own = Scheduling::own();
    let Some(session) = entered(&arm, &mut robot) else { return };
    let end = move || {
        let before = Scheduling::own();
        drop(session);
        assert_eq!(Scheduling::own(), before);
    };
    beside(arm.clock(), end, || ());
    assert_eq!(Scheduling::own(), own.with(PRIORITY));
}

#[test]
fn a_stream_s_thread_has_the_priority_and_no_other() {
    const OF_STREAM: u8 = 9;
    let (_arm, robot) = ready();
    let limits = Limits::of(Model::named("Zu 5").expect("a published arm"));
    let mut robot = robot.configured(&RobotConfig::new().limits(limits)).expect("it is this arm");
    let own = Scheduling::own();
    match robot.stream(&StreamConfig::new().servo(config(OF_STREAM))) {
        Ok(stream) => {
            assert!(streams().iter().any(|thread| thread.priority == OF_STREAM && thread.is_fifo));
            assert_eq!(Scheduling::own(), own);
            stream.land().and_then(End::at_rest).expect("nothing was refused");
        }
        Err(error) => assert_is_refusal(&error, OF_STREAM),
    }
    assert!(!streams().iter().any(|thread| thread.priority == OF_STREAM));
    assert_eq!(Scheduling::own(), own);
}

#[test]
fn priorities_are_from_1_to_99() {
    let (arm, mut robot) = ready();
    for priority in [0, 100] {
        let error = robot.enter_servo_mode(config(priority)).expect_err("it is not one");
        assert!(error.is_invalid_argument(), "{error}");
        assert!(config(priority).measure_lateness(Duration::ZERO).expect_err("it is not one").is_invalid_argument());
    }
    assert!(!arm.requests().iter().any(|request| request.contains("servo_move")));
}

#[test]
fn lateness_is_measured_with_the_priority() {
    let own = Scheduling::own();
    match config(PRIORITY).measure_lateness(Duration::ZERO) {
        Ok(lateness) => assert_eq!(lateness.len(), 1),
        Err(error) => assert_is_refusal(&error, PRIORITY),
    }
    assert_eq!(Scheduling::own(), own);
    let time = Duration::from_millis(50);
    let lateness = ServoConfig::new().busy_wait(time).measure_lateness(time).expect("no priority is asked for");
    // Seven where none is late; a late cycle delays the next ones by a period or more, or leaves them where they are
    // due.
    assert!((1..=9).contains(&lateness.len()), "{lateness:?}");
}
