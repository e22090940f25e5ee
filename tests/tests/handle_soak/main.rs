//! Clones of a client in threads beside each way of moving, by seed. By simulated clocks.
//!
//! Witnesses are the requests and replies on the wire, where each reply bears the tag of its request, and the outputs
//! of the simulated controller. `JAKA_HANDLES_MINUTES=10 cargo test --release -p jaka-tests --test handle_soak` is the
//! long form, with that many simulated minutes in all.
//!
//! One test, alone in its process, so that handles, threads and memory can be counted.

mod clones;

use std::alloc::System;
use std::collections::HashMap;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Duration;

use jaka_robot::io::AnalogOutputKind;
use jaka_robot::jaka_motion::{Checker, Frames, Limits, Model, Trajectory, Via};
use jaka_robot::motion::JointMove;
use jaka_robot::{Client, Error, ErrorKind, FollowConfig, Robot, RobotConfig, ServoConfig, StreamConfig, Unchecked};
use jaka_sim::{Port, SimulatedClock};
use jaka_tests::resources::{Handles, allocated};
use jaka_tests::rig::Random;
use jaka_tests::simulated::{Exchanged, TaggedWire, side_by_side, until};
use jaka_tests::{Arm, Configured as _, LONG};
use stats_alloc::{INSTRUMENTED_SYSTEM, StatsAlloc};

use self::clones::{Sender, Sent};

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

/// Ways of moving.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Way {
    Run,
    Session,
    Stream,
    Trajectory,
}

const WAYS: [Way; 4] = [Way::Run, Way::Session, Way::Stream, Way::Trajectory];

const START: [f64; 6] = [10.0, 100.0, 80.0, 90.0, -90.0, 0.0];
/// Maximum growth of the memory between rounds, in bytes.
const GROWTH: u64 = 2048;
/// Time for which clones begin to send.
const SENDING: Duration = Duration::from_millis(2200);
/// Commands that no clone gets out while set-points move the arm.
const KEPT_BACK: [&str; 5] = ["power_off", "disable_robot", "joint_move", "nobody_knows_it", "get_version"];

fn by(joint_6: f64) -> [f64; 6] {
    [0.0, 0.0, 0.0, 0.0, 0.0, joint_6]
}

fn limits() -> Limits {
    let limits = Limits::of(Model::named("Zu 5").expect("a published arm"));
    limits.with_joint_accelerations([300.0; 6]).expect("above 0")
}

/// To and fro for six seconds and more, after which no clone sends any more.
fn to_and_fro() -> Trajectory {
    let places =
        [0.0, 60.0, -60.0, 0.0].map(|side| Via::joints(std::array::from_fn(|joint| START[joint] + by(side)[joint])));
    let path = Trajectory::through(places).joint_speeds([40.0; 6]);
    path.build(&Checker::new(limits(), Frames::new())).expect("within the limits")
}

fn turn(joint_6: f64) -> JointMove {
    JointMove::relative(by(joint_6), 40.0).acceleration(200.0)
}

fn is_frame_changing(error: &Error) -> bool {
    matches!(error.kind(), ErrorKind::NotChecked { reason: Unchecked::Frames, .. })
}

impl Way {
    /// Moves the arm to and fro while clones send.
    fn act(
        self,
        robot: &mut Robot,
        clock: &SimulatedClock,
        servo: ServoConfig,
        sends: &dyn Fn() -> bool,
    ) -> Result<(), Error> {
        match self {
            Self::Run => {
                let mut go = |joint_6| loop {
                    match robot.run(&turn(joint_6), LONG) {
                        // A command that no spec knows may have changed a frame meanwhile. Nothing was sent.
                        Err(error) if is_frame_changing(&error) => {}
                        end => return end?.reached(),
                    }
                };
                loop {
                    go(20.0)?;
                    go(-20.0)?;
                    if !sends() {
                        return Ok(());
                    }
                }
            }
            Self::Session => {
                let period_s = servo.period().as_secs_f64();
                let mut session = robot.enter_servo_mode(servo)?;
                let mut time_s = 0.0;
                while sends() {
                    time_s += period_s;
                    session.send_joint_offset(by(30.0 * period_s * f64::sin(3.0 * time_s)))?;
                }
                session.land()?.at_rest()
            }
            Self::Stream => {
                let stream = robot.stream(&StreamConfig::new().servo(servo))?;
                for number in 0.. {
                    let speed = if number / 10 % 2 == 0 { 30.0 } else { -30.0 };
                    // Fails once the stream lands, and `land` says why.
                    let is_set = stream.handle().set_joint_velocity(by(speed), Duration::from_millis(300));
                    if !sends() || is_set.is_err() {
                        break;
                    }
                    clock.sleep(Duration::from_millis(100));
                }
                stream.land()?.at_rest()
            }
            Self::Trajectory => robot.start_follow(&to_and_fro(), &FollowConfig::new().servo(servo))?.wait().reached(),
        }
    }
}

/// One arm, with clones beside one way of moving. Returns the simulated time and what is wrong.
fn round(way: Way, seed: u32) -> (Duration, Vec<String>) {
    let mut random = Random::new(seed);
    let arm = &Arm::simulated().at(START).status_period(Duration::from_millis(30)).start();
    let clock = arm.clock();
    let wire = TaggedWire::watch(clock, arm.command_addr());
    let client = Client::connect_with(&arm.config(), wire.address()).expect("the proxy listens");
    let robot = Robot::new(client, arm.monitor()).expect("it is the only robot");
    let mut robot = robot.configured(&RobotConfig::new().limits(limits())).expect("it is this arm");
    arm.link(Port::Command).to_client().delay(Duration::from_millis([0, 5, 20][random.below(3) as usize]));
    let servo = ServoConfig::new().step_count([1, 2, 4][random.below(3) as usize]);
    let period = servo.period();
    let since = clock.elapsed();
    let stall = since + Duration::from_secs(1) + Duration::from_micros(random.below(1_000_000).into());
    let stall = (way != Way::Run && seed % 2 == 1).then_some(stall);

    let (all_sent, moved) = (Mutex::new(Vec::new()), Mutex::new(None));
    let count = 2 + random.below(7);
    let sending = AtomicUsize::new(count as usize);
    let sends = || sending.load(Ordering::SeqCst) > 0;
    let mut acts: Vec<Box<dyn FnOnce() + Send + '_>> = Vec::new();
    for number in 0..count {
        let client = robot.client().try_clone().expect("the connection is there");
        let sender = Sender::new(client, number, Random::new(seed * 8 + number), way != Way::Run, stall);
        let (all_sent, sending) = (&all_sent, &sending);
        acts.push(Box::new(move || {
            until(clock, || if way == Way::Run { !arm.state().at_rest } else { arm.state().servo_mode });
            let sent = sender.act(clock, since + SENDING);
            all_sent.lock().expect("nothing panics").push(sent);
            sending.fetch_sub(1, Ordering::SeqCst);
        }));
    }
    acts.push(Box::new(|| {
        let end = way.act(&mut robot, clock, servo, &sends);
        *moved.lock().expect("nothing panics") = Some((end, sends()));
    }));
    if let Some(stall) = stall {
        acts.push(Box::new(move || {
            clock.sleep(stall.saturating_sub(clock.elapsed()));
            arm.link(Port::Command).hold();
        }));
    }
    side_by_side(clock, acts);
    let (end, is_before_clones) = moved.into_inner().expect("nothing panics").expect("the arm was moved");
    let all_sent = all_sent.into_inner().expect("nothing panics");
    let exchanged = wire.exchanged();
    let mut found: Vec<_> = all_sent.iter().filter_map(|sent| sent.found.clone()).collect();
    if way != Way::Run {
        found.extend(judge_set_points(&exchanged, period, stall));
    }
    found.extend(judge_replies(&exchanged, &all_sent));
    if stall.is_some() {
        if end.is_ok() {
            found.push("the stall is not noticed".to_owned());
        }
    } else {
        if let Err(error) = end {
            found.push(format!("it ends: {error:?}"));
        }
        let state = arm.state();
        if is_before_clones || state.servo_mode || !state.powered || !state.enabled {
            found.push(format!("ends before the clones: {is_before_clones}, {state:?}"));
        }
        for number in 0..i64::from(count) {
            let is_of = |one: &&Exchanged| one.is("set_analog_output") && one.request["index"] == number;
            let last = exchanged.iter().rfind(is_of).and_then(|one| one.request["value"].as_f64());
            if state.analog_outputs.get(&(AnalogOutputKind::Cabinet, number)).copied() != last {
                found.push(format!("output {number} is not {last:?}"));
            }
        }
    }
    let name = |what| format!("{way:?}, seed {seed}, {count} clones, stall {stall:?}: {what}");
    (clock.elapsed(), found.into_iter().map(name).collect())
}

/// Set-points go out in each period until the stall or the end, and at most as many as promised after the stall. What
/// is kept back is not among the requests from the first set-point on.
fn judge_set_points(exchanged: &[Exchanged], period: Duration, stall: Option<Duration>) -> Vec<String> {
    let mut found = Vec::new();
    let is_set_point = |one: &Exchanged| one.is("servo_j");
    let [Some(first), Some(last)] = [exchanged.iter().position(is_set_point), exchanged.iter().rposition(is_set_point)]
    else {
        return vec!["no set-point is sent".to_owned()];
    };
    let times: Vec<_> = exchanged.iter().filter(|one| is_set_point(one)).map(|one| one.at).collect();
    let (before, after): (Vec<_>, Vec<_>) = times.iter().partition(|at| stall.is_none_or(|stall| **at <= stall));
    let ends = before.iter().skip(1).copied().chain(stall);
    for (from, to) in before.iter().zip(ends.collect::<Vec<_>>()) {
        if to.saturating_sub(*from) > period * 3 / 2 {
            found.push(format!("no set-point from {from:?} to {to:?}"));
        }
    }
    let most = (Duration::from_millis(100).as_nanos() / period.as_nanos()).max(3);
    if after.len() as u128 > most {
        found.push(format!("{} set-points after the stall, and {most} are promised", after.len()));
    }
    for (number, one) in exchanged.iter().enumerate().skip(first) {
        let is_kept_back = KEPT_BACK.iter().any(|command| one.is(command)) && (number < last || !one.is("get_version"));
        if is_kept_back || (one.is("stop_program") && stall.is_none()) {
            found.push(format!("on the wire: {}", one.request));
        }
    }
    found
}

/// Each tagged request is on the wire once, those of each clone in the order of its calls, and pipelines count those
/// that were accepted.
fn judge_replies(exchanged: &[Exchanged], all_sent: &[Sent]) -> Vec<String> {
    let mut found = Vec::new();
    let (mut by_tag, mut last_tags) = (HashMap::new(), HashMap::new());
    for (tag, one) in exchanged.iter().filter_map(|one| Some((one.tag()?, one))) {
        by_tag.insert(tag, one.is_accepted());
        let last = last_tags.insert(clones::number_of(tag), tag).unwrap_or_default();
        if tag <= last {
            found.push(format!("{tag} is sent after {last}"));
        }
    }
    for (tags, accepted) in all_sent.iter().flat_map(|sent| &sent.pipelines) {
        let is: Vec<_> = tags.clone().filter_map(|tag| by_tag.get(&tag)).collect();
        let were_accepted = is.iter().filter(|is_accepted| ***is_accepted).count() as u64;
        if is.len() as u64 != tags.end - tags.start || were_accepted != *accepted {
            found.push(format!("of {tags:?} {} are sent, {were_accepted} accepted, {accepted} counted", is.len()));
        }
    }
    if by_tag.len() < 50 {
        found.push(format!("clones send {} requests alone", by_tag.len()));
    }
    found
}

#[test]
fn clones_disturb_nothing_and_nothing_is_left_behind() {
    let minutes = std::env::var("JAKA_HANDLES_MINUTES").ok().and_then(|minutes| minutes.parse::<u32>().ok());
    let least = Duration::from_secs(60) * minutes.unwrap_or_default();
    let (mut time, mut found) = (Duration::ZERO, Vec::new());
    let (handles, mut held) = (Handles::now(), None);
    for seed in 0.. {
        if seed >= 2 && time >= least {
            break;
        }
        for way in WAYS {
            // A thread keeps the clocks in which it takes part until its end.
            let round = thread::spawn(move || round(way, seed));
            let (took, wrong) = round.join().expect("it panics for no reason of its own");
            time += took;
            found.extend(wrong);
        }
        let now = handles.settle();
        if now != handles {
            found.push(format!("after seed {seed} there are {now}, and {handles} before the first"));
        }
        let now = allocated(ALLOCATOR);
        let first = *held.get_or_insert(now);
        if now > first + GROWTH {
            found.push(format!("after seed {seed} {now} bytes are allocated, and {first} after the first"));
        }
    }
    println!("{time:?}");
    assert!(found.is_empty(), "{} findings:\n{}", found.len(), found.join("\n"));
}
