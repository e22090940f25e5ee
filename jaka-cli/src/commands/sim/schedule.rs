//! What happens to the simulated arm and its inputs: at once, or at a time of the controller's.

use std::fmt;
use std::io::{self, BufRead, stdin};
use std::str::FromStr;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::thread;
use std::time::Duration;

use jaka_sim::{Controller, DigitalInput};

use crate::failure::Failure;
use crate::output;

/// How often it is checked whether something is due.
const TICK: Duration = Duration::from_millis(10);

/// What happens to the arm or to its inputs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Happening {
    Collide,
    PressEmergencyStop,
    ReleaseEmergencyStop,
    CutPower,
    /// A digital input, of the cabinet or of the tool, by its place from 0.
    Input(Side, usize, Level),
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    Cabinet,
    Tool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Level {
    High,
    Low,
}

impl Happening {
    const WORDS: [(&str, Self); 4] = [
        ("collide", Self::Collide),
        ("press-emergency-stop", Self::PressEmergencyStop),
        ("release-emergency-stop", Self::ReleaseEmergencyStop),
        ("cut-power", Self::CutPower),
    ];

    /// The happening at the beginning of these words, and the words after it.
    fn read<'w>(words: &'w [&'w str]) -> Option<(Self, &'w [&'w str])> {
        let (first, rest) = words.split_first()?;
        if let Some((_, happening)) = Self::WORDS.iter().find(|(word, _)| word == first) {
            return Some((*happening, rest));
        }
        let side = match *first {
            "input" => Side::Cabinet,
            "tool-input" => Side::Tool,
            _ => return None,
        };
        let (&[index, level], rest) = rest.split_first_chunk()?;
        let level = match level {
            "high" => Level::High,
            "low" => Level::Low,
            _ => return None,
        };
        Some((Self::Input(side, index.parse().ok()?, level), rest))
    }

    fn apply(self, controller: &Controller) -> io::Result<()> {
        match self {
            Self::Collide => controller.collide(),
            Self::PressEmergencyStop => controller.press_emergency_stop(),
            Self::ReleaseEmergencyStop => controller.release_emergency_stop(),
            Self::CutPower => controller.cut_power(),
            Self::Input(side, index, level) => {
                let input = match side {
                    Side::Cabinet => DigitalInput::cabinet(index),
                    Side::Tool => DigitalInput::tool(index),
                };
                return controller.input(match level {
                    Level::High => input.high_at(Duration::ZERO),
                    Level::Low => input.low_at(Duration::ZERO),
                });
            }
        }
        Ok(())
    }
}

impl fmt::Display for Happening {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Self::Input(side, index, level) = self {
            let side = if *side == Side::Tool { "tool-input" } else { "input" };
            let level = if *level == Level::High { "high" } else { "low" };
            return write!(f, "{side} {index} {level}");
        }
        f.write_str(Self::WORDS.iter().find(|(_, happening)| happening == self).map_or("", |(word, _)| word))
    }
}

/// Something that happens at a time of the controller's, such as `collide at 2s`; without a time at once.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Scheduled {
    happening: Happening,
    at: Duration,
}

impl FromStr for Scheduled {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let words: Vec<_> = text.split_whitespace().collect();
        let (happening, rest) = Happening::read(&words).ok_or_else(|| {
            let all: Vec<_> = Happening::WORDS.iter().map(|(word, _)| format!("`{word}`")).collect();
            format!("`{}` is not one of {}, `input 3 high`, `tool-input 0 low`", text.trim(), all.join(", "))
        })?;
        let at = match *rest {
            [] => Some(Duration::ZERO),
            ["at", time] => duration(time),
            _ => None,
        };
        let at = at.ok_or_else(|| {
            format!("`{happening}` may be followed by a time, as in `{happening} at 2s` or `… at 500ms`")
        })?;
        Ok(Self { happening, at })
    }
}

fn duration(text: &str) -> Option<Duration> {
    let (number, unit) = text.split_at(text.find(|c: char| c.is_alphabetic())?);
    let per_second = match unit {
        "ms" => 1000.0,
        "s" => 1.0,
        _ => return None,
    };
    Duration::try_from_secs_f64(number.parse::<f64>().ok()? / per_second).ok()
}

/// Does all that is scheduled, and what lines add to it, and says when; until there is nothing more to come.
pub(super) fn run(
    controller: &Controller,
    mut scheduled: Vec<Scheduled>,
    lines: &Receiver<Scheduled>,
) -> Result<(), Failure> {
    loop {
        let now = controller.elapsed();
        for due in scheduled.extract_if(.., |scheduled| scheduled.at <= now) {
            match due.happening.apply(controller) {
                Ok(()) => output::line(&format!("{:.3} s: {}", now.as_secs_f64(), due.happening))?,
                Err(error) => output::error(&format!("{}: {error}", due.happening)),
            }
        }
        match lines.recv_timeout(TICK) {
            Ok(line) => scheduled.push(line),
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) if scheduled.is_empty() => return Ok(()),
            Err(RecvTimeoutError::Disconnected) => thread::sleep(TICK),
        }
    }
}

/// The lines of standard input, from a thread that reads them. What is not understood is told, and nothing happens.
pub(super) fn lines() -> Receiver<Scheduled> {
    let (sender, lines) = mpsc::channel();
    thread::spawn(move || read(&sender));
    lines
}

fn read(sender: &Sender<Scheduled>) {
    for line in stdin().lock().lines().map_while(Result::ok).filter(|line| !line.trim().is_empty()) {
        match line.parse() {
            Ok(scheduled) if sender.send(scheduled).is_err() => return,
            Ok(_) => {}
            Err(error) => output::error(&error),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_happens_has_words_and_a_time() {
        let read = |text: &str| text.parse::<Scheduled>();
        let words = Happening::WORDS.iter().map(|(word, _)| *word);
        for word in words.chain(["input 3 high", "tool-input 0 low"]) {
            assert_eq!(
                read(word).map(|read| (read.happening.to_string(), read.at)),
                Ok((word.to_owned(), Duration::ZERO))
            );
        }
        let at = |ms| Ok(Scheduled { happening: Happening::Collide, at: Duration::from_millis(ms) });
        assert_eq!(read(" collide  at 2s "), at(2000));
        assert_eq!(read("collide at 1.5s"), at(1500));
        assert_eq!(read("collide at 250ms"), at(250));
        for bad in [
            "",
            "crash",
            "collide at",
            "collide at 2",
            "collide at -1s",
            "collide at nans",
            "collide 2s",
            "collide at 2s 3s",
            "input 3",
            "input x high",
            "input 3 on",
        ] {
            assert!(read(bad).is_err(), "{bad}");
        }
    }
}
