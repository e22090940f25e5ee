//! Interleavings of threads that share the state of an arm: each that waits is woken, and no motion passes that must
//! not.
//!
//! `.ci/interleavings` runs these tests. Under shuttle a wait never times out, so a wake-up that is lost is a deadlock,
//! which it reports with the schedule that leads to it. No test depends on real time: nothing becomes due or stale.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use jaka_clock::Clock;
use jaka_proto::messages::status::RobotStatus;
use jaka_sync::layer::{StatusNews, Stops};
use shuttle::thread::{self, JoinHandle};

use super::guards::{GuardProgress, PacketObserver};
use super::state::{ArmState, Sending};
use crate::{Cause, Disconnect, GuardTrip, Occurrence, Snapshot, TripReason};

/// Number of schedules of each test: at random, and with a few switches of threads anywhere.
const SCHEDULES: usize = 2000;
const SWITCHES: usize = 3;

/// Longer than any test.
const LONG: Duration = Duration::from_secs(3600);

fn check(test: impl Fn() + Send + Sync + Copy + 'static) {
    shuttle::check_random(test, SCHEDULES);
    shuttle::check_pct(test, SCHEDULES, SWITCHES);
}

/// Fact that threads note and read. Shuttle does not switch threads at an atomic of std, so that notes are exact.
#[derive(Debug, Default)]
struct Fact(AtomicBool);

impl Fact {
    fn note(&self) {
        self.0.store(true, Ordering::SeqCst);
    }

    fn holds(&self) -> bool {
        self.0.load(Ordering::SeqCst)
    }
}

/// State of an arm that moves: a packet without a stop has come.
fn moving() -> Arc<ArmState> {
    let state = ArmState::before_news(String::new(), LONG, &Stops::new(&Clock::default()), true);
    take(&state, &packet(1));
    assert!(state.may_send(Sending::Motion).is_ok());
    Arc::new(state)
}

/// Packet that shows no stop.
fn packet(number: u64) -> Arc<Snapshot> {
    shows(number, |_| ())
}

fn shows(number: u64, change: impl FnOnce(&mut RobotStatus)) -> Arc<Snapshot> {
    let mut status = RobotStatus::default();
    (status.emergency_stop, status.protective_stop) = (Some(false), Some(false));
    (status.powered_on, status.enabled) = (Some(true), Some(true));
    change(&mut status);
    Snapshot::arriving(status, number)
}

fn shows_protective_stop(number: u64) -> Arc<Snapshot> {
    shows(number, |status| status.protective_stop = Some(true))
}

fn shows_emergency_stop(number: u64) -> Arc<Snapshot> {
    shows(number, |status| status.emergency_stop = Some(true))
}

/// Takes the newest packet.
fn take(state: &ArmState, packet: &Arc<Snapshot>) {
    state.take(StatusNews::Packet { packet, is_newest: true });
    state.take::<RobotStatus>(StatusNews::Shown);
}

/// Takes a packet after which a newer one has come already.
fn take_late(state: &ArmState, packet: &Arc<Snapshot>) {
    state.take(StatusNews::Packet { packet, is_newest: false });
    state.take::<RobotStatus>(StatusNews::Shown);
}

fn end(state: &ArmState) {
    state.take::<RobotStatus>(StatusNews::Ended(&Arc::new(Disconnect::Closed { partial: 0 })));
}

fn moves(state: &ArmState) -> bool {
    state.may_send(Sending::Motion).is_ok()
}

/// Starts a thread with the state.
fn with<T: Send + 'static>(
    state: &Arc<ArmState>,
    act: impl FnOnce(&Arc<ArmState>) -> T + Send + 'static,
) -> JoinHandle<T> {
    let state = Arc::clone(state);
    thread::spawn(move || act(&state))
}

fn join<T>(thread: JoinHandle<T>) -> T {
    thread.join().expect("it does not panic")
}

#[test]
fn each_watch_is_woken_by_its_packet() {
    check(|| {
        let state = moving();
        let watches = [2, 3].map(|number| {
            with(&state, move |state| {
                let mut seen = Vec::new();
                let found = state.watch(LONG, |packet| {
                    seen.extend(packet.map(|packet| packet.number));
                    packet.is_some_and(|packet| packet.number >= number).then_some(())
                });
                assert!(matches!(found, Ok(Some(()))) && seen.is_sorted_by(|a, b| a < b), "{found:?} {seen:?}");
            })
        });
        take(&state, &packet(2));
        take(&state, &packet(3));
        watches.into_iter().for_each(join);
    });
}

#[test]
fn each_watch_is_woken() {
    check(|| {
        let (state, has_stopped) = (moving(), Arc::new(Fact::default()));
        let watch = |has_stopped: &Arc<Fact>| {
            let has_stopped = Arc::clone(has_stopped);
            with(&state, move |state| {
                let found = state.watch(LONG, |_| has_stopped.holds().then_some(()));
                assert!(matches!(found, Ok(Some(()))), "{found:?}");
            })
        };
        let watches = [watch(&has_stopped), watch(&has_stopped)];
        has_stopped.note();
        state.wake();
        watches.into_iter().for_each(join);
    });
}

#[test]
fn each_watch_is_woken_by_the_end_of_the_port() {
    check(|| {
        let state = moving();
        let watch = |state: &Arc<ArmState>| state.watch(LONG, |_| None::<()>).expect_err("the port ends");
        let watches = [with(&state, watch), with(&state, watch)];
        take(&state, &packet(2));
        end(&state);
        for cause in watches.map(join) {
            assert!(matches!(*cause, Disconnect::Closed { .. }), "{cause:?}");
        }
    });
}

/// The notes of one run with two packets that show a stop, of which one acknowledgement may come at any time.
#[derive(Debug, Default)]
struct Notes {
    first: Fact,
    second: Fact,
    asked: Fact,
    acknowledged: Fact,
    /// The acknowledgement had ended when the second packet came.
    acknowledged_before: Fact,
    /// The acknowledgement began after the second packet.
    asked_after: Fact,
    /// A motion passed before the second packet, and after the acknowledgement: it had ended, or the first packet had
    /// come.
    moved_between: Fact,
}

impl Notes {
    /// Two packets that show a stop, each of which is followed by one that shows none.
    fn packets(&self, state: &ArmState, second: fn(&ArmState)) {
        take(state, &shows_protective_stop(2));
        self.first.note();
        take(state, &packet(3));
        if self.acknowledged.holds() {
            self.acknowledged_before.note();
        }
        second(state);
        self.second.note();
        take(state, &packet(5));
    }

    fn acknowledge(&self, state: &ArmState) {
        self.asked.note();
        if self.second.holds() {
            self.asked_after.note();
        }
        state.acknowledge();
        self.acknowledged.note();
    }

    fn motion(&self, state: &ArmState) {
        let (first, second, acknowledged) = (self.first.holds(), self.second.holds(), self.acknowledged.holds());
        if moves(state) {
            assert!(!first || self.asked.holds(), "a stop was shown");
            assert!(!second || !self.acknowledged_before.holds(), "a stop was shown after the acknowledgement");
            if (acknowledged || first) && !self.second.holds() {
                self.moved_between.note();
            }
        }
    }
}

/// A run, after which its notes are judged.
fn shown_twice(second: fn(&ArmState), judge: fn(&Notes, &ArmState)) {
    check(move || {
        let (state, notes) = (moving(), Arc::new(Notes::default()));
        let (of_packets, of_acknowledging) = (Arc::clone(&notes), Arc::clone(&notes));
        let packets = with(&state, move |state| of_packets.packets(state, second));
        let acknowledging = with(&state, move |state| of_acknowledging.acknowledge(state));
        for _ in 0..3 {
            notes.motion(&state);
        }
        join(packets);
        join(acknowledging);
        if notes.acknowledged_before.holds() {
            assert!(!moves(&state), "a stop was shown after the acknowledgement");
        }
        if notes.asked_after.holds() {
            assert!(moves(&state), "both were acknowledged");
        }
        judge(&notes, &state);
        state.acknowledge();
        assert!(moves(&state));
    });
}

#[test]
fn no_motion_passes_after_a_packet_with_a_stop_until_it_is_acknowledged() {
    let second = |state: &ArmState| take(state, &shows_emergency_stop(4));
    shown_twice(second, |notes, state| {
        // Nothing passes while the packet is the newest: it came after the motion, which came after the
        // acknowledgement.
        assert!(!notes.moved_between.holds() || !moves(state), "the acknowledgement came before the second packet");
    });
}

#[test]
fn no_motion_passes_after_a_late_packet_with_a_stop_until_it_is_acknowledged() {
    shown_twice(|state| take_late(state, &shows_emergency_stop(4)), |_, _| ());
}

/// A guard that trips by the next packet.
#[derive(Debug)]
struct Trips {
    state: Arc<ArmState>,
    guard: u64,
    calls_for_stop: Fact,
}

impl PacketObserver for Trips {
    fn observe(&self, packet: &Arc<Snapshot>) {
        let trip = GuardTrip {
            condition: 0,
            text: String::new(),
            reason: TripReason::Holds,
            packet: Arc::clone(packet),
            reaction: None,
            is_before_start: false,
            is_at_rest: false,
            lag: None,
        };
        if self.state.progress(self.guard, |progress| progress.take(Ok(Some(trip)))) {
            self.calls_for_stop.note();
        }
    }
}

/// As a motion under a guard has it: the gate lets it out, the monitor's thread judges packets, and the guard's own
/// thread watches.
#[test]
fn a_trip_keeps_the_motion_back_or_calls_for_its_stop() {
    for take in [take, take_late] {
        check(move || {
            let state = moving();
            let guard = state.guard_number();
            let observer = Arc::new(Trips { state: Arc::clone(&state), guard, calls_for_stop: Fact::default() });
            let armed: Arc<dyn PacketObserver> = Arc::<Trips>::clone(&observer);
            state.arm_guard(guard, Arc::downgrade(&armed));
            let trips = with(&state, move |state| take(state, &packet(2)));
            let watches = with(&state, move |state| {
                let has_tripped = || state.progress(guard, |progress| progress.trip().is_some());
                let found = state.watch(LONG, |_| has_tripped().then_some(()));
                assert!(matches!(found, Ok(Some(()))), "{found:?}");
                state.progress(guard, |progress| progress.shut(None))
            });
            let sent = state.may_send(Sending::Motion).and_then(|()| state.progress(guard, GuardProgress::let_out));
            join(trips);
            assert_eq!(sent.is_ok(), observer.calls_for_stop.holds(), "{sent:?}");
            assert_eq!(sent.is_ok(), join(watches), "{sent:?}");
        });
    }
}

#[test]
fn a_stop_that_a_packet_shows_must_be_acknowledged_whether_the_status_was_lost_before_or_after() {
    for take in [take, take_late] {
        check(move || {
            let state = moving();
            let packets = with(&state, move |state| {
                take(state, &shows_protective_stop(2));
                take(state, &packet(3));
            });
            let lost = || with(&state, |state| state.latch(&Occurrence::status_lost(None, None)));
            let lost = [lost(), lost()];
            join(packets);
            lost.into_iter().for_each(join);
            for found in [state.unacknowledged(), state.unacknowledged_stop()] {
                assert!(found.as_ref().is_some_and(|found| found.cause == Cause::ProtectiveStop), "{found:?}");
            }
            assert!(state.may_send(Sending::Holding).is_err());
            state.acknowledge();
            assert!(state.unacknowledged().is_none() && moves(&state));
        });
    }
}
