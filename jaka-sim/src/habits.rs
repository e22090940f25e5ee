//! What real controllers do and no document describes.

mod text;

use std::time::Duration;

pub use self::text::HabitError;

/// Something that some real controllers do, and that a client must handle.
///
/// [`Builder::habits`](crate::Builder::habits) makes a controller do it. A habit has a text form, as `jaka sim --habits` takes it:
/// `pause 100ms`, `events`. It is what `Display` writes and `FromStr` reads; a time that is left out is that of
/// [`one_of_each`](Self::one_of_each).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Habit {
    /// The arm rests this long, in position, between two motions of the queue. `pause 100ms` as a text.
    ///
    /// What waits for the arm to be in position alone takes the first motion's end for the last one's.
    Pause(Duration),
    /// `get_joint_pos`, `get_tcp_pos` and the commanded positions of status packets are those that the arm will have this much later.
    /// `lead 16ms` as a text.
    ///
    /// At rest they are where the arm is. At 5 deg/s, 16 ms are 0.08 deg.
    Lead(Duration),
    /// Replies to queries wait until the arm is at rest, as with firmware 1.4, or for this long in the controller's time, whichever
    /// is the sooner. `late-queries` or `late-queries 2s` as a text.
    ///
    /// A reply says what was so when its request was received, and later replies wait until it is sent; the requests are carried out.
    LateQueries(Option<Duration>),
    /// `power_on` and `enable_robot` are answered when the arm has power and is enabled, as with firmware 1.5.14. `late-power` as a
    /// text.
    ///
    /// Later replies wait until that reply is sent. Without this habit they are answered at once, as by newer firmware.
    LatePower,
    /// A motion with a tolerance that another one follows does not come to rest: where it is nearer to its end than the tolerance, the
    /// next begins, and the arm rounds the corner. `blend` as a text.
    ///
    /// `moveL` and `movc` have a tolerance. Without this habit each motion ends at its target.
    Blend,
    /// `servo_move` is acknowledged while the arm moves, and servo mode is not entered. `servo-at-rest` as a text.
    ///
    /// `is_in_servomove` stays false, and `servo_j` is refused with -1.
    ServoAtRest,
    /// Information is put into the error code of status packets: enabling and disabling, servo mode on and off, the start of a
    /// program. `events` as a text.
    ///
    /// It stays until the next, or until `clear_error`. An error is not replaced by it.
    Events,
}

impl Habit {
    /// One habit of each kind, with the times of real controllers, for tests that go through all of them.
    pub fn one_of_each() -> Vec<Self> {
        vec![
            Self::Pause(Duration::from_millis(100)),
            Self::Lead(Duration::from_millis(16)),
            Self::LateQueries(None),
            Self::LatePower,
            Self::Blend,
            Self::ServoAtRest,
            Self::Events,
        ]
    }
}

/// What a controller does as real ones do: some [`Habit`]s, or none.
///
/// ```
/// use std::time::Duration;
///
/// use jaka_sim::{Controller, Habit, Habits};
///
/// let pause = Habit::Pause(Duration::from_millis(100));
/// let controller = Controller::builder().habits([pause, Habit::Events]).start()?;
/// assert_eq!("pause, events".parse(), Ok(Habits::from([pause, Habit::Events])));
/// # Ok::<(), std::io::Error>(())
/// ```
///
/// As a text they are separated by commas; `all` is [`Habits::all`], `none` none.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[expect(clippy::struct_excessive_bools, reason = "each is a habit of its own")]
pub struct Habits {
    pub(crate) pause: Option<Duration>,
    pub(crate) lead: Option<Duration>,
    /// The longest time where replies wait for the arm alone.
    pub(crate) late_queries: Option<Duration>,
    pub(crate) late_power: bool,
    pub(crate) blend: bool,
    pub(crate) servo_at_rest: bool,
    pub(crate) events: bool,
}

impl Habits {
    /// No habits.
    pub fn none() -> Self {
        Self::default()
    }

    /// All habits, as [`Habit::one_of_each`] has them.
    pub fn all() -> Self {
        Habit::one_of_each().into_iter().collect()
    }

    /// The habits that there are.
    pub fn iter(&self) -> impl Iterator<Item = Habit> {
        let late_queries = self.late_queries.map(|time| Some(time).filter(|time| *time < Duration::MAX));
        let timed = [self.pause.map(Habit::Pause), self.lead.map(Habit::Lead), late_queries.map(Habit::LateQueries)];
        let plain = [
            (self.late_power, Habit::LatePower),
            (self.blend, Habit::Blend),
            (self.servo_at_rest, Habit::ServoAtRest),
            (self.events, Habit::Events),
        ];
        timed.into_iter().flatten().chain(plain.into_iter().filter(|(on, _)| *on).map(|(_, habit)| habit))
    }
}

impl Extend<Habit> for Habits {
    fn extend<T: IntoIterator<Item = Habit>>(&mut self, habits: T) {
        for habit in habits {
            match habit {
                Habit::Pause(time) => self.pause = Some(time),
                Habit::Lead(time) => self.lead = Some(time),
                Habit::LateQueries(time) => self.late_queries = Some(time.unwrap_or(Duration::MAX)),
                Habit::LatePower => self.late_power = true,
                Habit::Blend => self.blend = true,
                Habit::ServoAtRest => self.servo_at_rest = true,
                Habit::Events => self.events = true,
            }
        }
    }
}

impl FromIterator<Habit> for Habits {
    fn from_iter<T: IntoIterator<Item = Habit>>(habits: T) -> Self {
        let mut these = Self::default();
        these.extend(habits);
        these
    }
}

impl<const N: usize> From<[Habit; N]> for Habits {
    fn from(habits: [Habit; N]) -> Self {
        habits.into_iter().collect()
    }
}

impl From<Habit> for Habits {
    fn from(habit: Habit) -> Self {
        [habit].into()
    }
}
