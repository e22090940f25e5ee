//! Undocumented habits of real controllers.

use std::fmt;
use std::str::FromStr;
use std::time::Duration;

use crate::ScriptError;
use crate::fault::{kinds, quoted};

/// Times of real controllers.
const PAUSE: Duration = Duration::from_millis(100);
const LEAD: Duration = Duration::from_millis(16);

kinds! {
    /// Undocumented behaviour of some real controllers that a client must handle.
    ///
    /// [`Builder::habits`](crate::Builder::habits) selects the habits of a controller. A habit has a text form, as for
    /// `jaka sim --habits`: `pause 100ms`, `events`. `Display` writes it and `FromStr` reads it; a missing time is that
    /// of [`one_of_each`](Self::one_of_each).
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum Habit("a habit", unknown);

    pub(crate) fn set(&self, habits: &mut Habits) -> ();

    /// Rests this long, in position, between two motions of the queue. `pause 100ms` as a text.
    ///
    /// A client that only waits for the arm to be in position takes the end of the first motion for that of the last
    /// one.
    Pause(time: Duration as time_or(PAUSE) = PAUSE): "pause" => habits.pause = Some(*time);

    /// Gives the positions of the arm this much later in `get_joint_pos`, in `get_tcp_pos` and as the commanded
    /// positions of status packets. `lead 16ms` as a text.
    ///
    /// At rest they are the actual positions. At 5 deg/s, 16 ms are 0.08 deg.
    Lead(time: Duration as time_or(LEAD) = LEAD): "lead" => habits.lead = Some(*time);

    /// Delays replies to queries until the arm is at rest, as firmware 1.4 does, or for this long in the controller's
    /// time, whichever is sooner. `late-queries` or `late-queries 2s` as a text.
    ///
    /// A reply has the values at the time of its request, and later replies wait for it; the controller carries out
    /// their requests.
    LateQueries(time: Option<Duration> as optional_time = None): "late-queries" => {
        habits.late_queries = Some(time.unwrap_or(Duration::MAX));
    };

    /// Answers `power_on` and `enable_robot` when the arm has power and is enabled, as firmware 1.5.14 does.
    /// `late-power` as a text.
    ///
    /// Later replies wait for that reply. Without this habit the controller answers at once, as newer firmware does.
    LatePower: "late-power" => habits.late_power = true;

    /// Blends a motion with a tolerance into the next one without a stop. When the distance to the end of the first
    /// motion is less than the tolerance, the next motion begins, and the arm rounds the corner. `blend` as a text.
    ///
    /// `moveL` and `movc` have a tolerance. Without this habit each motion ends at its target.
    Blend: "blend" => habits.blend = true;

    /// Acknowledges `servo_move` while the arm moves, without entering servo mode. `servo-at-rest` as a text.
    ///
    /// `is_in_servomove` stays false, and the controller refuses `servo_j` with -1.
    ServoAtRest: "servo-at-rest" => habits.servo_at_rest = true;

    /// Acknowledges `disable_robot` while the arm moves, as firmware 1.5.14 does. `disable-moving` as a text.
    ///
    /// The reaction of a real arm is unknown; here the arm is disabled, and its motion ends. Without this habit the
    /// controller refuses the command, in accordance with the vendor's event `0x0F003A`.
    DisableMoving: "disable-moving" => habits.disable_moving = true;

    /// Reports information in the error code of status packets: enabling and disabling, servo mode on and off, the
    /// start of a program. `events` as a text.
    ///
    /// It stays for 256 ms, until the next information, or until `clear_error`: 312 of 312 captured packets of enabled
    /// arms have `"0x0"`, and one entry of a log lasted 257 ms. Information does not replace an error.
    Events: "events" => habits.events = true;
}

fn unknown(_word: &str) -> String {
    format!("unknown habit; the habits are {}, and `all`", quoted(&Habit::one_of_each()))
}

/// Habits of a controller: some [`Habit`]s of real controllers, or none.
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
/// Commas separate the habits in a text; `all` is [`Habits::all`], and `none` is no habit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[expect(clippy::struct_excessive_bools, reason = "each is a habit of its own")]
pub struct Habits {
    pub(crate) pause: Option<Duration>,
    pub(crate) lead: Option<Duration>,
    /// Longest time for which replies to queries wait for the arm.
    pub(crate) late_queries: Option<Duration>,
    pub(crate) late_power: bool,
    pub(crate) blend: bool,
    pub(crate) servo_at_rest: bool,
    pub(crate) disable_moving: bool,
    pub(crate) events: bool,
}

impl Habits {
    /// Returns no habits.
    pub fn none() -> Self {
        Self::default()
    }

    /// Returns all habits, with the arguments of [`Habit::one_of_each`].
    pub fn all() -> Self {
        Habit::one_of_each().into_iter().collect()
    }

    /// Returns an iterator over the habits.
    pub fn iter(&self) -> impl Iterator<Item = Habit> {
        let late_queries = self.late_queries.map(|time| Some(time).filter(|time| *time < Duration::MAX));
        let timed = [self.pause.map(Habit::Pause), self.lead.map(Habit::Lead), late_queries.map(Habit::LateQueries)];
        let plain = [
            (self.late_power, Habit::LatePower),
            (self.blend, Habit::Blend),
            (self.servo_at_rest, Habit::ServoAtRest),
            (self.disable_moving, Habit::DisableMoving),
            (self.events, Habit::Events),
        ];
        timed.into_iter().flatten().chain(plain.into_iter().filter(|(on, _)| *on).map(|(_, habit)| habit))
    }
}

impl Extend<Habit> for Habits {
    fn extend<T: IntoIterator<Item = Habit>>(&mut self, habits: T) {
        habits.into_iter().for_each(|habit| habit.set(self));
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

impl fmt::Display for Habits {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let texts: Vec<_> = self.iter().map(|habit| habit.to_string()).collect();
        f.write_str(if texts.is_empty() { "none" } else { "" })?;
        f.write_str(&texts.join(", "))
    }
}

impl FromStr for Habits {
    type Err = ScriptError;

    /// Reads the text form of habits.
    ///
    /// # Errors
    /// One of them is not a habit.
    fn from_str(text: &str) -> Result<Self, ScriptError> {
        match text.trim() {
            "all" => Ok(Self::all()),
            "none" => Ok(Self::none()),
            text => text.split(',').map(|habit| habit.trim().parse::<Habit>()).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_habit_has_a_text() {
        let two_seconds = Duration::from_secs(2);
        let more = [Habit::LateQueries(Some(two_seconds)), Habit::Pause(two_seconds), Habit::Lead(two_seconds)];
        for habit in Habit::one_of_each().into_iter().chain(more) {
            assert_eq!(habit.to_string().parse(), Ok(habit));
            assert_eq!(habit.to_string().parse(), Ok(Habits::from(habit)));
        }
        for habits in [Habits::all(), Habits::none(), [Habit::Blend, Habit::Events].into()] {
            assert_eq!(habits.to_string().parse(), Ok(habits));
        }
        assert_eq!("all".parse(), Ok(Habits::all()));
        assert_eq!(" lead,blend , pause 1s".parse::<Habits>().map(|habits| habits.to_string()), {
            Ok("pause 1s, lead 16ms, blend".to_owned())
        });
    }

    #[test]
    fn an_error_says_what_there_is() {
        for text in ["", "pauses", "pause 3", "pause 1s 2s", "blend 1s", "all, pause", "pause,"] {
            assert!(text.parse::<Habits>().is_err(), "{text}");
        }
        let error = "blend, pauses".parse::<Habits>().expect_err("there is no such habit").to_string();
        assert_eq!(
            error,
            "`pauses`: unknown habit; the habits are `pause 100ms`, `lead 16ms`, `late-queries`, `late-power`, `blend`, \
             `servo-at-rest`, `disable-moving`, `events`, and `all`"
        );
    }
}
