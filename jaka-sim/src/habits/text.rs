//! Habits as a text.

use std::error::Error;
use std::fmt;
use std::str::FromStr;
use std::time::Duration;

use super::{Habit, Habits};
use crate::fault::read_time;

/// The text is not that of a [`Habit`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct HabitError {
    text: String,
}

impl fmt::Display for HabitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "`{}` is not a habit; the habits are ", self.text)?;
        for habit in Habit::one_of_each() {
            write!(f, "`{habit}`, ")?;
        }
        f.write_str("and `all`")
    }
}

impl Error for HabitError {}

impl fmt::Display for Habit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Pause(time) => write!(f, "pause {time:?}"),
            Self::Lead(time) => write!(f, "lead {time:?}"),
            Self::LateQueries(None) => f.write_str("late-queries"),
            Self::LateQueries(Some(time)) => write!(f, "late-queries {time:?}"),
            Self::LatePower => f.write_str("late-power"),
            Self::Blend => f.write_str("blend"),
            Self::ServoAtRest => f.write_str("servo-at-rest"),
            Self::Events => f.write_str("events"),
        }
    }
}

impl FromStr for Habit {
    type Err = HabitError;

    /// Reads the text form of a habit.
    ///
    /// # Errors
    /// There is no such habit, or its time is not one.
    fn from_str(text: &str) -> Result<Self, HabitError> {
        let unfit = || HabitError { text: text.to_owned() };
        let mut tokens = text.split_whitespace();
        let name = tokens.next().ok_or_else(unfit)?;
        let time = tokens.next().map(|word| read_time(word).ok_or_else(unfit)).transpose()?;
        let usual = Self::one_of_each().into_iter().find(|habit| habit.name() == name);
        let habit = usual.and_then(|habit| habit.with_time(time)).ok_or_else(unfit)?;
        tokens.next().map_or(Ok(habit), |_| Err(unfit()))
    }
}

impl Habit {
    fn name(self) -> String {
        let text = self.to_string();
        text.split_whitespace().next().unwrap_or_default().to_owned()
    }

    /// The same with another time, if one is given; `None` where it cannot have one.
    fn with_time(self, time: Option<Duration>) -> Option<Self> {
        let Some(time) = time else { return Some(self) };
        match self {
            Self::Pause(_) => Some(Self::Pause(time)),
            Self::Lead(_) => Some(Self::Lead(time)),
            Self::LateQueries(_) => Some(Self::LateQueries(Some(time))),
            Self::LatePower | Self::Blend | Self::ServoAtRest | Self::Events => None,
        }
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
    type Err = HabitError;

    /// Reads the text form of habits.
    ///
    /// # Errors
    /// One of them is not a habit.
    fn from_str(text: &str) -> Result<Self, HabitError> {
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
            "`pauses` is not a habit; the habits are `pause 100ms`, `lead 16ms`, `late-queries`, `late-power`, `blend`, \
             `servo-at-rest`, `events`, and `all`"
        );
    }
}
