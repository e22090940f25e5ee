//! What happens to the simulated arm: at once, or at a time of the controller's.

use std::fmt;
use std::io::{BufRead, stdin};
use std::str::FromStr;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::thread;
use std::time::Duration;

use jaka_sim::Controller;

use crate::failure::Failure;
use crate::output;

/// How often it is checked whether something is due.
const TICK: Duration = Duration::from_millis(10);

/// What happens to the arm.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Happening {
    Collide,
    PressEmergencyStop,
    ReleaseEmergencyStop,
    CutPower,
}

impl Happening {
    const ALL: [(&str, Self); 4] = [
        ("collide", Self::Collide),
        ("press-emergency-stop", Self::PressEmergencyStop),
        ("release-emergency-stop", Self::ReleaseEmergencyStop),
        ("cut-power", Self::CutPower),
    ];

    fn apply(self, controller: &Controller) {
        match self {
            Self::Collide => controller.collide(),
            Self::PressEmergencyStop => controller.press_emergency_stop(),
            Self::ReleaseEmergencyStop => controller.release_emergency_stop(),
            Self::CutPower => controller.cut_power(),
        }
    }
}

impl fmt::Display for Happening {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let word = Self::ALL.iter().find(|(_, happening)| happening == self).map_or("", |(word, _)| word);
        f.write_str(word)
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
        let mut words = text.split_whitespace();
        let word = words.next().unwrap_or_default();
        let known = Happening::ALL.iter().find(|(known, _)| *known == word);
        let (_, happening) = known.ok_or_else(|| {
            let all: Vec<_> = Happening::ALL.iter().map(|(word, _)| format!("`{word}`")).collect();
            format!("`{word}` is not one of {}", all.join(", "))
        })?;
        let rest: Vec<_> = words.collect();
        let at = match rest[..] {
            [] => Some(Duration::ZERO),
            ["at", time] => duration(time),
            _ => None,
        };
        let at =
            at.ok_or_else(|| format!("`{word}` may be followed by a time, as in `{word} at 2s` or `{word} at 500ms`"))?;
        Ok(Self { happening: *happening, at })
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
            due.happening.apply(controller);
            output::line(&format!("{:.3} s: {}", now.as_secs_f64(), due.happening))?;
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
            Err(error) => output::tell(&error),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_happens_has_words_and_a_time() {
        let read = |text: &str| text.parse::<Scheduled>();
        for (word, happening) in Happening::ALL {
            assert_eq!(read(word), Ok(Scheduled { happening, at: Duration::ZERO }));
            assert_eq!(happening.to_string(), word);
        }
        let at = |ms| Ok(Scheduled { happening: Happening::Collide, at: Duration::from_millis(ms) });
        assert_eq!(read(" collide  at 2s "), at(2000));
        assert_eq!(read("collide at 1.5s"), at(1500));
        assert_eq!(read("collide at 250ms"), at(250));
        for bad in [
            "",
            "colide",
            "collide at",
            "collide at 2",
            "collide at -1s",
            "collide at nans",
            "collide 2s",
            "collide at 2s 3s",
        ] {
            assert!(read(bad).is_err(), "{bad}");
        }
    }
}
