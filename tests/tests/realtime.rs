//! The real-time priority of the thread that sends set-points. Whether the system allows it is not known here: what follows from either answer
//! is checked.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Duration;
use std::{fs, io, thread};

use jaka_sim::{Controller, Delays};
use jaka_sync::jaka_motion::{Limits, Model};
use jaka_sync::{Config, Error, ErrorKind, Robot, ServoConfig, ServoSession, StreamConfig};

const LONG: Duration = Duration::from_secs(60);

const PRIORITY: u8 = 7;

/// How a thread is scheduled.
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

fn ready() -> (Controller, Robot) {
    let controller = Controller::builder().delays(Delays::NONE).start().expect("loopback has free ports");
    controller.set_state(|state| (state.powered, state.enabled) = (true, true));
    let config = Config::new().stale_after(LONG);
    let monitor = config.connect_monitor(controller.status_addr()).expect("the controller listens");
    let client = config.connect_client(controller.command_addr()).expect("the controller listens");
    (controller, Robot::new(client, monitor))
}

fn config(priority: u8) -> ServoConfig {
    ServoConfig::new().max_unanswered(LONG).rest_timeout(LONG).realtime_priority(priority)
}

/// The session, unless the system does not allow the priority.
fn entered<'r>(controller: &Controller, robot: &'r mut Robot) -> Option<ServoSession<'r>> {
    match robot.enter_servo_mode(&config(PRIORITY)) {
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
        let (controller, mut robot) = ready();
        let own = Scheduling::own();
        if let Some(mut session) = entered(&controller, &mut robot) {
            assert_eq!(Scheduling::own(), own.with(PRIORITY), "{name}");
            session.send_joint_offset([0.01; 6]).expect("servo mode is on");
            end(session);
        }
        assert_eq!(Scheduling::own(), own, "{name}");
    }
}

#[test]
fn a_session_that_ends_by_an_error_gives_the_priority_back_at_once() {
    let (controller, mut robot) = ready();
    let own = Scheduling::own();
    let Some(mut session) = entered(&controller, &mut robot) else { return };
    session.send_joint_offset([1.9; 6]).expect_err("it is too fast");
    assert_eq!(Scheduling::own(), own);
    assert!(!controller.state().servo_mode);
    drop(session);
    assert_eq!(Scheduling::own(), own);
}

#[test]
fn a_session_that_is_not_entered_leaves_the_thread_as_it_was() {
    let (controller, mut robot) = ready();
    controller.set_state(|state| state.enabled = false);
    let own = Scheduling::own();
    robot.enter_servo_mode(&config(PRIORITY)).expect_err("the arm is not enabled");
    assert_eq!(Scheduling::own(), own);
}

#[test]
fn a_session_that_ends_in_another_thread_leaves_that_one_as_it_was() {
    let (controller, mut robot) = ready();
    let own = Scheduling::own();
    let Some(session) = entered(&controller, &mut robot) else { return };
    thread::scope(|scope| {
        let other = scope.spawn(move || {
            let before = Scheduling::own();
            drop(session);
            assert_eq!(Scheduling::own(), before);
        });
        other.join().expect("it has its own");
    });
    assert_eq!(Scheduling::own(), own.with(PRIORITY));
}

#[test]
fn a_stream_s_thread_has_the_priority_and_no_other() {
    const OF_STREAM: u8 = 9;
    let (_controller, robot) = ready();
    let limits = Limits::of(Model::named("Zu 5").expect("a published arm"));
    let mut robot = robot.with_limits(limits).expect("it is this arm");
    let own = Scheduling::own();
    match robot.stream(&StreamConfig::new().servo(config(OF_STREAM)).max_gap(LONG)) {
        Ok(stream) => {
            assert!(streams().iter().any(|thread| thread.priority == OF_STREAM && thread.is_fifo));
            assert_eq!(Scheduling::own(), own);
            stream.land().expect("nothing was refused");
        }
        Err(error) => assert_is_refusal(&error, OF_STREAM),
    }
    assert!(!streams().iter().any(|thread| thread.priority == OF_STREAM));
    assert_eq!(Scheduling::own(), own);
}

#[test]
fn priorities_are_from_1_to_99() {
    let (controller, mut robot) = ready();
    for priority in [0, 100] {
        let error = robot.enter_servo_mode(&config(priority)).expect_err("it is not one");
        assert!(error.is_invalid_argument(), "{error}");
        assert!(config(priority).measure_lateness(Duration::ZERO).expect_err("it is not one").is_invalid_argument());
    }
    assert!(!controller.requests().iter().any(|request| request.contains("servo_move")));
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
    // Cycles are delayed, and none comes too soon.
    assert!((1..=7).contains(&lateness.len()), "{lateness:?}");
}
