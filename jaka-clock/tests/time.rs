//! Advances of the simulated time: their moments and their lengths.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use jaka_clock::{Clock, Signal, SimulatedClock};

const HOUR: Duration = Duration::from_secs(3600);

fn secs(seconds: u64) -> Duration {
    Duration::from_secs(seconds)
}

/// Runs each in a thread that takes part from the beginning, and waits for all.
fn together(clock: &SimulatedClock, acts: Vec<Box<dyn FnOnce() + Send + '_>>) {
    thread::scope(|scope| {
        let places: Vec<_> = acts.iter().map(|_| clock.participant()).collect();
        let threads: Vec<_> =
            acts.into_iter().zip(places).map(|(act, place)| scope.spawn(move || place.run(act))).collect();
        for thread in threads {
            thread.join().expect("it does not panic");
        }
    });
}

#[test]
fn those_who_sleep_go_on_in_the_order_of_their_times_and_alone() {
    let clock = SimulatedClock::new();
    let (order, is_one_awake) = (Mutex::new(Vec::new()), AtomicBool::new(false));
    let sleeper = |times: Vec<u64>| {
        let (clock, order, is_one_awake) = (&clock, &order, &is_one_awake);
        Box::new(move || {
            for time in times {
                clock.sleep(secs(time));
                assert!(!is_one_awake.swap(true, Ordering::SeqCst), "two are at work");
                thread::sleep(Duration::from_millis(2));
                order.lock().expect("nobody panics").push(clock.elapsed().as_secs());
                is_one_awake.store(false, Ordering::SeqCst);
            }
        }) as Box<dyn FnOnce() + Send>
    };
    together(&clock, vec![sleeper(vec![3, 3, 3]), sleeper(vec![2, 2, 2, 2]), sleeper(vec![12, 100])]);
    assert_eq!(*order.lock().expect("nobody panics"), [2, 3, 4, 6, 6, 8, 9, 12, 112]);
}

#[test]
fn time_stands_still_while_a_participant_is_at_work() {
    let clock = SimulatedClock::new();
    let (clock, slept) = (&clock, &AtomicBool::new(false));
    let works = move || {
        thread::sleep(Duration::from_millis(100));
        assert_eq!((clock.elapsed(), slept.load(Ordering::SeqCst)), (Duration::ZERO, false));
        // Now it waits for longer than the other one.
        clock.sleep(secs(2));
        assert!(slept.load(Ordering::SeqCst));
    };
    let sleeps = move || {
        clock.sleep(secs(1));
        slept.store(true, Ordering::SeqCst);
    };
    together(clock, vec![Box::new(works), Box::new(sleeps)]);
}

#[test]
fn a_signal_ends_a_wait_at_the_time_at_which_it_is_given() {
    let clock = SimulatedClock::new();
    let signal = Signal::new(&Clock::simulated(&clock));
    let (clock, is_done, signal) = (&clock, &Mutex::new(false), &signal);
    let waits = move || {
        let done = signal.wait_until(is_done, HOUR, |is_done| *is_done);
        assert_eq!((*done, clock.elapsed()), (true, secs(5)));
        // Nobody signals: the time ends it.
        drop(signal.wait(is_done, done, HOUR));
        assert_eq!(clock.elapsed(), secs(5) + HOUR);
    };
    let signals = move || {
        clock.sleep(secs(5));
        *is_done.lock().expect("nobody panics") = true;
        signal.notify_all();
        // The one who waited is at work from then on, whether it runs already or not.
        thread::sleep(Duration::from_millis(50));
        assert_eq!(clock.elapsed(), secs(5));
    };
    together(clock, vec![Box::new(waits), Box::new(signals)]);
}

#[test]
fn time_does_not_go_on_for_servants_alone() {
    let clock = SimulatedClock::new();
    let (servant, theirs) = (clock.servant(), clock.clone());
    thread::spawn(move || {
        servant.run(|| {
            loop {
                theirs.sleep(Duration::from_millis(8));
            }
        })
    });
    thread::sleep(Duration::from_millis(100));
    assert_eq!(clock.elapsed(), Duration::ZERO);
    clock.sleep(secs(1));
    assert_eq!(clock.elapsed(), secs(1));
}

#[test]
fn a_thread_takes_part_until_it_ends_or_is_outside() {
    let clock = SimulatedClock::new();
    let theirs = clock.clone();
    // It takes part by its wait, and its end is the end of that, also by a panic.
    let other = thread::spawn(move || {
        theirs.sleep(secs(1));
        panic!("as the test wants it");
    });
    other.join().expect_err("it panics");
    clock.sleep(secs(1));
    assert_eq!(clock.elapsed(), secs(2));
    // This thread takes part now: without `outside`, the other one would wait for ever.
    let theirs = clock.clone();
    let other = thread::spawn(move || theirs.sleep(HOUR));
    clock.outside(|| other.join()).expect("it does not panic");
    assert_eq!(clock.elapsed(), secs(2) + HOUR);
    // And it still does, once.
    clock.outside(|| clock.sleep(secs(1)));
    clock.sleep(secs(1));
    assert_eq!(clock.elapsed(), secs(4) + HOUR);
}

#[test]
fn work_keeps_time_from_going_on_between_two_threads() {
    let clock = SimulatedClock::new();
    let (background, theirs) = (clock.participant(), clock.clone());
    // Time goes on for this one, if nobody is at work.
    thread::spawn(move || {
        background.run(|| {
            loop {
                theirs.sleep(secs(1));
            }
        })
    });
    for _ in 0..100 {
        let (place, theirs) = (clock.participant(), clock.clone());
        let other = thread::spawn(move || {
            place.run(|| {
                theirs.sleep(secs(10));
                (theirs.elapsed(), theirs.work())
            })
        });
        let (ended, _work) = clock.outside(|| other.join()).expect("it does not panic");
        assert_eq!(clock.elapsed(), ended);
    }
}

#[test]
fn an_hour_of_cycles_takes_seconds() {
    let (clock, since) = (SimulatedClock::new(), Instant::now());
    let mut due = clock.now();
    for _ in 0..450_000 {
        due += Duration::from_millis(8);
        clock.sleep_until(due);
        assert_eq!(clock.now(), due);
    }
    assert_eq!(clock.elapsed(), HOUR);
    assert!(since.elapsed() < secs(600));
}
