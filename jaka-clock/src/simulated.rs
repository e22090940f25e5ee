//! Simulated clock.

mod channel;
mod hold_up;
mod parker;
mod presence;
mod state;
mod stream;

use std::fmt;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

pub(crate) use self::channel::Channel;
use self::hold_up::HoldUps;
use self::parker::Parker;
pub use self::presence::Participant;
use self::state::{ClockState, MovesTime, Reason};
pub use self::stream::{Listener, Stream};

/// Clock whose time advances when all participants wait. Its clones are the same clock.
///
/// Waits for a time, for bytes or for another thread go through it: in the connections and threads of jaka-sync and
/// jaka-sim that have it, and in [`sleep`](Self::sleep). Time stands still while a participating thread works; when all
/// wait, it advances to the first time for which one waits. Several waits for the same time end one after the other.
/// Time advances only while a thread of the program waits, and not for a monitor or a simulator alone.
///
/// A thread participates from its first wait in the time of the clock until its end. Its work in between takes no time.
/// A program must use the clock for three things:
/// - a thread that is started while others take part: [`participant`](Self::participant);
/// - a wait for something else, such as the end of another thread: [`outside`](Self::outside). Otherwise time stands
///   still for ever;
/// - its own connections: [`connect`](Self::connect) and [`bind`](Self::bind). On a connection whose other end does not
///   take part, such as a proxy, bytes arrive in real time: the time of the clock stands still for 100 ms of real time
///   whenever a wait for bytes begins, or for as long as [`with_grace`](Self::with_grace) says. Bytes that are later
///   come at a time that depends on the machine.
///
/// Instants of the clock can be compared with each other alone.
#[derive(Clone)]
pub struct SimulatedClock(Arc<Inner>);

struct Inner {
    /// Instant at which no time has passed.
    origin: Instant,
    /// Real time for which this clock stands still for an end that does not participate.
    grace: Duration,
    state: Mutex<ClockState>,
    hold_ups: HoldUps,
}

/// Real time for which a clock stands still for an end that does not participate, by default.
const GRACE: Duration = Duration::from_millis(100);

impl SimulatedClock {
    /// A new clock, which begins now.
    pub fn new() -> Self {
        Self::with_grace(GRACE)
    }

    /// Clock that stands still for so long, in real time, when a wait begins for a connection with an end that does not
    /// participate. With a minute, the answer of another program always comes at the time of its request; but a wait
    /// for a silent one takes a minute.
    pub fn with_grace(grace: Duration) -> Self {
        Self(Arc::new(Inner { origin: Instant::now(), grace, state: Mutex::default(), hold_ups: HoldUps::default() }))
    }

    fn grace(&self) -> Duration {
        self.0.grace
    }

    /// Present time.
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

    /// Time since the clock was made.
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

    /// Waits until then, or not at all if that has passed.
    pub fn sleep_until(&self, due: Instant) {
        self.sleep(due.saturating_duration_since(self.now()));
    }

    /// Participation of a thread before its start: time stands still from now on until that thread waits.
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

    /// Participation of a thread that serves others, such as a simulator's: time does not go on for its waits alone.
    pub fn servant(&self) -> Participant {
        Participant::new(self, MovesTime::No)
    }

    /// Keeps time from going on until it is dropped.
    pub fn work(&self) -> Work {
        self.lock().begin_work();
        Work::new(self)
    }

    /// Waits by other means than this clock, such as a `join`: time may advance meanwhile.
    pub fn outside<T>(&self, act: impl FnOnce() -> T) -> T {
        let Some(moves_time) = presence::membership(self) else { return act() };
        presence::leave(self);
        let _back = Back { clock: self, moves_time };
        act()
    }

    /// Gives the mutex up, and waits until the signal is given, or so long if a time is given; then locks the mutex
    /// again. The signal is the address of something that lives as long as this waits for it.
    pub(crate) fn wait_for<'m, T>(
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

    /// Wakes all threads that wait for a signal.
    pub(crate) fn notify_all(&self, signal: usize) {
        self.lock().signal(Reason::Signal(signal));
    }

    /// End, by the clock's own time, of a wait that begins now and may last so long; none for a time that is too long
    /// to be a limit. The thread takes part from now on.
    fn deadline(&self, time: Option<Duration>) -> Option<Duration> {
        self.take_part();
        let until = self.elapsed().checked_add(time?)?;
        self.0.origin.checked_add(until).map(|_| until)
    }

    /// Waits. `state` is the state by which it must; `begun` is called once others see that it waits.
    fn wait(&self, state: MutexGuard<'_, ClockState>, reason: Reason, until: Option<Duration>, begun: impl FnOnce()) {
        let parker = presence::parker();
        let (number, is_member) = self.begin(state, reason, until, &parker);
        begun();
        parker.wait(|waited| self.warn(waited, number));
        self.end(is_member);
    }

    /// Waits for news of the system: until `attempt` brings something, for which it may take a short while; none where
    /// the wait ends otherwise.
    fn poll<T>(&self, reason: Reason, until: Option<Duration>, mut attempt: impl FnMut() -> Option<T>) -> Option<T> {
        let parker = presence::parker();
        let (number, is_member) = self.begin(self.lock(), reason, until, &parker);
        let mut found = None;
        while found.is_none() && !parker.is_woken() {
            found = attempt();
        }
        self.lock().resume(number);
        self.end(is_member);
        found
    }

    /// Begins a wait of this thread. Returns the wait's number, and true if the thread takes part.
    fn begin(
        &self,
        mut state: MutexGuard<'_, ClockState>,
        reason: Reason,
        until: Option<Duration>,
        parker: &Arc<Parker>,
    ) -> (u64, bool) {
        let membership = presence::membership(self);
        if membership.is_none() {
            // The thread is at its end.
            state.begin_work();
        }
        parker.begin_wait();
        (state.wait(reason, until, parker, membership.unwrap_or(MovesTime::Yes)), membership.is_some())
    }

    /// Makes this thread take part, unless it does or is at its end.
    fn take_part(&self) {
        if presence::membership(self).is_none() {
            presence::enter(self.work(), MovesTime::Yes);
        }
    }

    /// Ends the wait of a thread, and its work if it is at its end.
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
    fn lock(&self) -> MutexGuard<'_, ClockState> {
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
    /// Handle of work that has begun.
    fn new(clock: &SimulatedClock) -> Self {
        Self { clock: clock.clone() }
    }
}

impl Drop for Work {
    fn drop(&mut self) {
        self.clock.lock().end_work();
    }
}

/// Makes the thread take part again when it is dropped.
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

/// Equal if it is the same clock.
impl PartialEq for SimulatedClock {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Eq for SimulatedClock {}

/// Writes the time; with `{:#?}` also the number of threads at work, and each wait with its reason.
impl fmt::Debug for SimulatedClock {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if f.alternate() {
            return f.debug_tuple("SimulatedClock").field(&*self.lock()).finish();
        }
        f.debug_struct("SimulatedClock").field("elapsed", &self.elapsed()).finish_non_exhaustive()
    }
}
