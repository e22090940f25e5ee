//! Interleavings of the threads that share the stops of a connection: each stop that waits is woken, and no motion
//! passes that must not.
//!
//! `.ci/interleavings` runs these tests. Under shuttle a wait never times out, so a wake-up that is lost is a deadlock,
//! which it reports with the schedule that leads to it.

use std::sync::atomic::{AtomicBool, Ordering};

use jaka_proto::Command as _;
use jaka_proto::messages::program::StopProgram;
use shuttle::sync::Mutex;
use shuttle::thread::JoinHandle;

use super::fixture::with_robot;
use super::*;

/// Number of schedules of each test: at random, and with a few switches of threads anywhere.
const SCHEDULES: usize = 2000;
const SWITCHES: usize = 3;

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

/// Starts a thread with the stops.
fn with<T: Send + 'static>(stops: &Arc<Stops>, act: impl FnOnce(&Arc<Stops>) -> T + Send + 'static) -> JoinHandle<T> {
    let stops = Arc::clone(stops);
    thread::spawn(move || act(&stops))
}

fn join<T>(thread: JoinHandle<T>) -> T {
    thread.join().expect("it does not panic")
}

/// Reply to a stop.
fn answer(stops: &Stops, stop: &UnderWay, is_accepted: bool) {
    let request = RequestId::default();
    let outgoing = Outgoing::of(stops.clock(), StopProgram::INFO, LONGEST_BRAKING);
    stops.entered([request].into_iter(), &outgoing.of_stop(stop.number(), stops.clock().stopwatch()));
    stops.answered(request, is_accepted);
    if !is_accepted {
        stop.failed();
    }
}

/// Far beyond any test.
fn later() -> Instant {
    Clock::default().now() + Duration::from_secs(3600)
}

#[test]
fn stops_that_wait_go_out_once_the_session_has_braked() {
    check(|| {
        let (stops, has_braked) = (with_robot(), Arc::new(Fact::default()));
        let lead = stops.lead(Handle::FIRST, Owner(1)).expect("nothing keeps it back");
        lead.expect_set_point(Some(later()));
        let waiting = [(); 2].map(|()| {
            let has_braked = Arc::clone(&has_braked);
            with(&stops, move |stops| {
                stops.begin(StopKind::Program).wait_until_braked();
                has_braked.holds()
            })
        });
        lead.expect_set_point(Some(later()));
        has_braked.note();
        lead.expect_set_point(None);
        assert_eq!(waiting.map(join), [true, true]);
        assert!(stops.time_to_brake().is_none() && stops.check_braking().is_err());
    });
}

#[test]
fn the_end_of_a_lead_lets_stops_go_out() {
    check(|| {
        let stops = with_robot();
        let lead = stops.lead(Handle::FIRST, Owner(1)).expect("nothing keeps it back");
        lead.expect_set_point(Some(later()));
        let waiting = with(&stops, |stops| stops.begin(StopKind::Program).wait_until_braked());
        drop(lead);
        join(waiting);
        assert!(stops.needs_rest(), "it has moved the arm");
    });
}

/// A gate runs while the connection is locked, and what passes is written before it is unlocked.
#[test]
fn no_motion_is_written_after_a_stop_has_begun() {
    for is_accepted in [true, false] {
        check(move || {
            let (stops, wire, has_begun) = (with_robot(), Arc::new(Mutex::new(Vec::new())), Arc::new(Fact::default()));
            let (written, begun) = (Arc::clone(&wire), Arc::clone(&has_begun));
            let stopping = with(&stops, move |stops| {
                let stop = stops.begin(StopKind::Program);
                begun.note();
                stop.wait_until_braked();
                written.lock().expect("no thread panics").push("stop");
                answer(stops, &stop, is_accepted);
            });
            for _ in 0..3 {
                let had_begun = has_begun.holds();
                let mut wire = wire.lock().expect("no thread panics");
                if stops.check_motion().is_ok() {
                    assert!(!had_begun, "the stop had begun");
                    wire.push("motion");
                }
            }
            join(stopping);
            assert_eq!(wire.lock().expect("no thread panics").last(), Some(&"stop"));
            assert_eq!(stops.check_motion(), Err(Kept::Stopped), "the stop has not been acknowledged");
            let due = stops.rest_due();
            stops.acknowledge();
            assert_eq!(stops.check_motion(), Err(Kept::NotAtRest));
            stops.rest_seen(due);
            assert_eq!(stops.check_motion(), Ok(()));
        });
    }
}

#[test]
fn acknowledging_a_stop_that_is_on_its_way_lets_no_motion_pass() {
    for is_accepted in [true, false] {
        check(move || {
            let stops = with_robot();
            let [has_begun, is_over, is_acknowledged] = [(); 3].map(|()| Arc::new(Fact::default()));
            let (begun, over, acknowledged) = (has_begun.clone(), is_over.clone(), is_acknowledged.clone());
            let stopping = with(&stops, move |stops| {
                let stop = stops.begin(StopKind::Program);
                begun.note();
                stop.wait_until_braked();
                let was_acknowledged = acknowledged.holds();
                answer(stops, &stop, is_accepted);
                over.note();
                drop(stop);
                was_acknowledged
            });
            let acknowledging = with(&stops, move |stops| {
                stops.acknowledge();
                is_acknowledged.note();
            });
            for _ in 0..3 {
                let had_begun = has_begun.holds();
                stops.rest_seen(stops.rest_due());
                let passes = stops.check_motion().is_ok();
                assert!(!passes || !had_begun || is_over.holds(), "a stop is on its way");
            }
            join(acknowledging);
            if join(stopping) && !is_accepted {
                assert!(stops.check_motion().is_err(), "nobody could know that the stop would not be accepted");
            }
            stops.acknowledge();
            stops.rest_seen(stops.rest_due());
            assert_eq!(stops.check_motion(), Ok(()));
        });
    }
}

/// Only one session leads, and none once a stop has begun.
#[test]
fn one_session_leads_and_a_stop_ends_it() {
    check(|| {
        let stops = with_robot();
        let leading = [(); 2].map(|()| with(&stops, |stops| stops.lead(Handle::FIRST, Owner(1))));
        let stopping = with(&stops, |stops| stops.begin(StopKind::OfMotion).wait_until_braked());
        let leads = leading.map(join);
        join(stopping);
        let count = leads.iter().filter(|lead| lead.is_ok()).count();
        assert!(count <= 1, "{leads:?}");
        assert!(count == 0 || stops.check_set_point() == Err(Kept::Stopped) || !stops.is_held());
    });
}
