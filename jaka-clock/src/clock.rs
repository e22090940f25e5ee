//! The clock.

mod hold_up;
mod participant;
mod presence;

use std::fmt;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use self::hold_up::HoldUps;
pub use self::participant::Participant;
use crate::seat::Seat;
use crate::state::{MovesTime, Reason, State};

/// A clock whose time goes on when all that take part in it wait. Its clones are the same clock.
///
/// What waits for a time, for bytes or for another thread goes through it: the connections and threads of jaka-sync and
/// jaka-sim that were given it, and [`sleep`](Self::sleep). Time stands still while one that takes part is at work;
/// when all wait, it goes on to the first time for which one waits. If several wait for the same time, they go on one
/// after the other. Time goes on only while a thread of the program waits, and not for a monitor or a simulator alone.
///
/// A thread takes part from its first wait in the time of the clock until it ends. What it does in between takes no
/// time. Three things must be told to the clock:
/// - a thread that is started while others take part: [`participant`](Self::participant);
/// - a wait for something else, such as the end of another thread: [`outside`](Self::outside). Otherwise time stands still for ever;
/// - what goes through the hands of others, such as a proxy between client and controller, arrives when the system says
///   so: on a connection whose other end does not take part, time stands still for 100 ms of real time whenever a wait
///   for bytes begins, or for so long as [`with_grace`](Self::with_grace) says. What is later comes at a time that
///   depends on the machine. A program or test takes part with its own connections by [`connect`](Self::connect) and
///   [`bind`](Self::bind).
///
/// Instants of the clock can be compared with each other alone.
#[derive(Clone)]
pub struct SimulatedClock(Arc<Inner>);

struct Inner {
    /// The instant of no time.
    origin: Instant,
    /// Real time for which this stands still for an end that does not take part.
    grace: Duration,
    state: Mutex<State>,
    hold_ups: HoldUps,
}

/// Real time for which a clock stands still for an end that does not take part, unless the user says otherwise.
const GRACE: Duration = Duration::from_millis(100);

impl SimulatedClock {
    /// A clock of its own, which begins now.
    pub fn new() -> Self {
        Self::with_grace(GRACE)
    }

    /// A clock that stands still for so long, in real time, when a wait for a connection begins whose other end does
    /// not take part. With a minute, what another program answers always comes at the time at which it was asked; but a
    /// wait for one that is silent takes a minute.
    pub fn with_grace(grace: Duration) -> Self {
        Self(Arc::new(Inner { origin: Instant::now(), grace, state: Mutex::default(), hold_ups: HoldUps::default() }))
    }

    pub(crate) fn grace(&self) -> Duration {
        self.0.grace
    }

    /// What the time is.
    pub fn now(&self) -> Instant {
        let now = self.0.origin + self.elapsed();
        self.0.hold_ups.has_read();
        now
    }

    /// Holds a thread of this name up, as a scheduler does: once it has slept and read the clock the next time, it
    /// calls `act` before it goes on, which may sleep.
    pub fn hold_up(&self, thread: &str, act: impl FnOnce() + Send + 'static) {
        self.0.hold_ups.add(thread, act);
    }

    /// The time since the clock was made.
    pub fn elapsed(&self) -> Duration {
        self.lock().now
    }

    /// Waits so long, in this clock's time.
    pub fn sleep(&self, time: Duration) {
        if !time.is_zero() {
            let until = self.deadline(Some(time));
            self.wait(self.lock(), Reason::Time, until, || ());
            hold_up::has_slept();
        }
    }

    /// Waits until then; not at all where that has passed.
    pub fn sleep_until(&self, due: Instant) {
        self.sleep(due.saturating_duration_since(self.now()));
    }

    /// A place for a thread that will be started: time stands still from now on until that thread waits.
    ///
    /// ```
    /// use std::thread;
    /// use std::time::Duration;
    /// use jaka_clock::SimulatedClock;
    ///
    /// let clock = SimulatedClock::new();
    /// let (participant, theirs) = (clock.participant(), clock.clone());
    /// let other = thread::spawn(move || participant.run(|| theirs.sleep(Duration::from_secs(60))));
    /// clock.outside(|| other.join()).expect("it does not panic");
    /// assert_eq!(clock.elapsed(), Duration::from_secs(60));
    /// ```
    pub fn participant(&self) -> Participant {
        Participant::new(self, MovesTime::Yes)
    }

    /// The same for a thread that serves others, such as a simulator's: time does not go on for its waits alone.
    pub fn servant(&self) -> Participant {
        Participant::new(self, MovesTime::No)
    }

    /// Keeps time from going on until it is dropped.
    pub fn work(&self) -> Work {
        self.lock().begin_work();
        Work::new(self)
    }

    /// Does something that waits in another way than by this clock, such as a `join`: time may go on meanwhile.
    pub fn outside<T>(&self, act: impl FnOnce() -> T) -> T {
        let Some(moves_time) = presence::membership(self) else { return act() };
        presence::leave(self);
        let _back = Back { clock: self, moves_time };
        act()
    }

    /// Gives the mutex up, and waits until the signal is given, or so long if a time is given; then locks the mutex
    /// again.
    ///
    /// `signal` is the address of something that lives as long as this waits for it.
    pub fn wait_for<'m, T>(
        &self,
        signal: usize,
        mutex: &'m Mutex<T>,
        guard: MutexGuard<'m, T>,
        time: Option<Duration>,
    ) -> MutexGuard<'m, T> {
        let until = self.deadline(time);
        // It begins to wait before others can change what it waits for.
        self.wait(self.lock(), Reason::Signal(signal), until, || drop(guard));
        mutex.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Gives a signal to all that wait for it.
    pub fn notify_all(&self, signal: usize) {
        self.lock().signal(Reason::Signal(signal));
    }

    /// A wait that may last so long begins: when it ends by the clock's own time; none where that is no limit. The
    /// thread takes part from now on.
    pub(crate) fn deadline(&self, time: Option<Duration>) -> Option<Duration> {
        self.take_part();
        self.elapsed().checked_add(time?)
    }

    /// Waits. `state` is the state by which it must; `begun` is called once others see that it waits.
    pub(crate) fn wait(
        &self,
        state: MutexGuard<'_, State>,
        reason: Reason,
        until: Option<Duration>,
        begun: impl FnOnce(),
    ) {
        let seat = presence::seat();
        let (number, is_member) = self.begin(state, reason, until, &seat);
        begun();
        seat.wait(|waited| self.warn(waited, number));
        self.end(is_member);
    }

    /// Waits for what only the system knows: until `attempt` brings something, which it may look for a short while;
    /// none where the wait ends otherwise.
    pub(crate) fn poll<T>(
        &self,
        reason: Reason,
        until: Option<Duration>,
        mut attempt: impl FnMut() -> Option<T>,
    ) -> Option<T> {
        let seat = presence::seat();
        let (number, is_member) = self.begin(self.lock(), reason, until, &seat);
        let mut found = None;
        while found.is_none() && !seat.is_woken() {
            found = attempt();
        }
        self.lock().resume(number);
        self.end(is_member);
        found
    }

    /// This thread waits from now on: the wait's number, and whether the thread takes part.
    fn begin(
        &self,
        mut state: MutexGuard<'_, State>,
        reason: Reason,
        until: Option<Duration>,
        seat: &Arc<Seat>,
    ) -> (u64, bool) {
        let membership = presence::membership(self);
        if membership.is_none() {
            // It is at its end.
            state.begin_work();
        }
        seat.sit_down();
        (state.wait(reason, until, seat, membership.unwrap_or(MovesTime::Yes)), membership.is_some())
    }

    /// Has this thread take part, unless it does or is at its end.
    pub(crate) fn take_part(&self) {
        if presence::membership(self).is_none() {
            presence::enter(self.work(), MovesTime::Yes);
        }
    }

    /// A thread at its end takes part no longer.
    fn end(&self, is_member: bool) {
        if !is_member {
            self.lock().end_work();
        }
    }

    fn warn(&self, waited: Duration, number: u64) {
        let is_kept_from = self.lock().is_kept_from(number);
        if is_kept_from {
            log::warn!(
                target: "jaka_clock",
                "the simulated clock has stood still for {waited:.0?}: a thread that takes part does something else; see `SimulatedClock::outside`",
            );
        }
    }

    /// Every change is made whole before the lock is left.
    pub(crate) fn lock(&self) -> MutexGuard<'_, State> {
        self.0.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Keeps the time of a clock from going on until it is dropped, from [`SimulatedClock::work`]: handed to a thread that
/// was [outside](SimulatedClock::outside), it loses no time.
#[derive(Debug)]
#[must_use = "dropped, it keeps nothing"]
pub struct Work {
    clock: SimulatedClock,
}

impl Work {
    /// Of work that has begun.
    pub(crate) fn new(clock: &SimulatedClock) -> Self {
        Self { clock: clock.clone() }
    }
}

impl Drop for Work {
    fn drop(&mut self) {
        self.clock.lock().end_work();
    }
}

/// Takes part again when it is dropped.
struct Back<'c> {
    clock: &'c SimulatedClock,
    moves_time: MovesTime,
}

impl Drop for Back<'_> {
    fn drop(&mut self) {
        // It may have waited by the clock meanwhile.
        if presence::membership(self.clock).is_none() {
            presence::enter(self.clock.work(), self.moves_time);
        }
    }
}

impl Default for SimulatedClock {
    fn default() -> Self {
        Self::new()
    }
}

/// The same clock.
impl PartialEq for SimulatedClock {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Eq for SimulatedClock {}

/// The time; with `{:#?}` also who is at work, and who waits for what.
impl fmt::Debug for SimulatedClock {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if f.alternate() {
            return f.debug_tuple("SimulatedClock").field(&*self.lock()).finish();
        }
        f.debug_struct("SimulatedClock").field("elapsed", &self.elapsed()).finish_non_exhaustive()
    }
}
