//! What happened: what a packet says that the one before did not.

use std::collections::VecDeque;
use std::time::{Duration, SystemTime, UNIX_EPOCH};

use jaka_sync::status::RobotStatus;

/// How many are kept.
const MOST: usize = 1000;

/// How grave something is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Tone {
    /// The robot stopped, or is out of sight.
    Bad,
    /// What was bad is over.
    Good,
    /// It changed.
    Plain,
}

/// Something that happened.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Alarm {
    /// When it came to be known.
    pub(super) time: SystemTime,
    pub(super) tone: Tone,
    pub(super) text: String,
}

impl Alarm {
    /// Its time of day in UTC: the system's time zone is not to be had without more.
    pub(super) fn clock(&self) -> String {
        let seconds = self.time.duration_since(UNIX_EPOCH).map_or(0, |time| time.as_secs());
        format!("{:02}:{:02}:{:02}", seconds / 3600 % 24, seconds / 60 % 60, seconds % 60)
    }
}

/// What happened of late, the newest first.
#[derive(Debug, Default)]
pub(super) struct Alarms {
    entries: VecDeque<Alarm>,
    before: Facts,
}

/// What alarms tell of, as the packets say it. Packets that do not say it change nothing.
#[derive(Debug, Clone, Default)]
struct Facts {
    emergency_stop: Option<bool>,
    protective_stop: Option<bool>,
    powered: Option<bool>,
    enabled: Option<bool>,
    error: Option<(String, String)>,
}

impl Alarms {
    /// The newest first.
    pub(super) fn entries(&self) -> impl Iterator<Item = &Alarm> {
        self.entries.iter()
    }

    /// Adds one.
    pub(super) fn add(&mut self, time: SystemTime, tone: Tone, text: impl Into<String>) {
        self.entries.push_front(Alarm { time, tone, text: text.into() });
        self.entries.truncate(MOST);
    }

    /// Adds what a packet says that the ones before did not.
    pub(super) fn packet(&mut self, status: &RobotStatus, time: SystemTime) {
        let before = self.before.clone();
        self.flag(time, before.emergency_stop, status.emergency_stop, ["emergency stop released", "emergency stop"]);
        self.flag(time, before.protective_stop, status.protective_stop, ["protective stop cleared", "protective stop"]);
        self.switch(time, before.powered, status.powered_on, ["power off", "power on"]);
        self.switch(time, before.enabled, status.enabled, ["disabled", "enabled"]);
        self.error(time, before.error.as_ref(), status);
        self.before = Facts {
            emergency_stop: status.emergency_stop.or(before.emergency_stop),
            protective_stop: status.protective_stop.or(before.protective_stop),
            powered: status.powered_on.or(before.powered),
            enabled: status.enabled.or(before.enabled),
            error: error_of(status).or(before.error),
        };
    }

    /// Something that is bad if it is on, also in the first packet.
    fn flag(&mut self, time: SystemTime, before: Option<bool>, now: Option<bool>, [off, on]: [&str; 2]) {
        match (before.unwrap_or_default(), now) {
            (false, Some(true)) => self.add(time, Tone::Bad, on),
            (true, Some(false)) => self.add(time, Tone::Good, off),
            _ => {}
        }
    }

    /// Something that may be on or off.
    fn switch(&mut self, time: SystemTime, before: Option<bool>, now: Option<bool>, [off, on]: [&str; 2]) {
        match (before, now) {
            (Some(false), Some(true)) => self.add(time, Tone::Plain, on),
            (Some(true), Some(false)) => self.add(time, Tone::Plain, off),
            _ => {}
        }
    }

    fn error(&mut self, time: SystemTime, before: Option<&(String, String)>, status: &RobotStatus) {
        let Some(now) = error_of(status) else { return };
        let was_error = before.is_some_and(|(code, _)| is_error(code));
        if is_error(&now.0) && before != Some(&now) {
            self.add(time, Tone::Bad, format!("error {} {}", now.0, now.1).trim_end());
        } else if was_error && !is_error(&now.0) {
            self.add(time, Tone::Good, "error cleared");
        }
    }
}

fn error_of(status: &RobotStatus) -> Option<(String, String)> {
    Some((status.error_code.clone()?, status.error_message.clone().unwrap_or_default()))
}

/// True for a code that is not zero: `0x0` says that there is no error.
pub(super) fn is_error(code: &str) -> bool {
    let digits = code.trim().trim_start_matches("0x");
    !digits.trim_matches('0').is_empty()
}

/// A time as people say it.
pub(super) fn duration(time: Duration) -> String {
    let seconds = time.as_secs();
    match seconds {
        0..60 => format!("{:.1} s", time.as_secs_f64()),
        60..3600 => format!("{} min {} s", seconds / 60, seconds % 60),
        _ => format!("{} h {} min", seconds / 3600, seconds / 60 % 60),
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn changes_are_told_once() {
        let mut alarms = Alarms::default();
        let mut status = RobotStatus::default();
        let mut tell = |status: &RobotStatus| alarms.packet(status, UNIX_EPOCH);
        tell(&status);
        status.enabled = Some(true);
        status.error_code = Some("0x0".to_owned());
        tell(&status);
        status.protective_stop = Some(true);
        status.error_code = Some("0x10f0005".to_owned());
        status.error_message = Some("collision".to_owned());
        tell(&status);
        tell(&status);
        // A packet that does not say it changes nothing.
        tell(&RobotStatus::default());
        tell(&status);
        status.protective_stop = Some(false);
        status.enabled = Some(false);
        status.error_code = Some("0x0".to_owned());
        tell(&status);
        let texts: Vec<_> = alarms.entries().map(|alarm| format!("{:?} {}\n", alarm.tone, alarm.text)).collect();
        expect![[r"
            Good error cleared
            Plain disabled
            Good protective stop cleared
            Bad error 0x10f0005 collision
            Bad protective stop
        "]]
        .assert_eq(&texts.concat());
    }

    #[test]
    fn the_oldest_are_forgotten() {
        let mut alarms = Alarms::default();
        for number in 0..=MOST {
            alarms.add(UNIX_EPOCH, Tone::Plain, number.to_string());
        }
        assert_eq!(alarms.entries().count(), MOST);
        assert_eq!(alarms.entries().next().map(|alarm| &*alarm.text), Some("1000"));
    }
}
