//! Alarms: changes from one packet to the next.

use std::collections::VecDeque;
use std::time::{Duration, SystemTime, UNIX_EPOCH};

use jaka_robot::Severity;
use jaka_robot::proto::text::visible;
use jaka_robot::status::RobotStatus;
use ratatui::text::{Line, Span};

use super::style;
use crate::packets::event;
use crate::packets::flags::{Flags, Tone};

/// Order of severities; an unknown event may be an error.
const WORST_FIRST: [Severity; 3] = [Severity::Error, Severity::Unknown, Severity::Warning];
/// Columns of the time of an alarm, and the blanks around it.
const TIME_COLUMNS: usize = 10;
/// Greatest number of alarms in the list.
const MOST: usize = 1000;

/// Alarm with its time.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Alarm {
    /// Time of its detection.
    pub(super) time: SystemTime,
    pub(super) tone: Tone,
    pub(super) text: String,
}

impl Alarm {
    /// Returns its time of day in UTC: the standard library does not know the system's time zone.
    pub(super) fn clock(&self) -> String {
        let seconds = self.time.duration_since(UNIX_EPOCH).map_or(0, |time| time.as_secs());
        format!("{:02}:{:02}:{:02}", seconds / 3600 % 24, seconds / 60 % 60, seconds % 60)
    }
}

/// Latest alarms, the newest first.
#[derive(Debug, Default)]
pub(super) struct Alarms {
    entries: VecDeque<Alarm>,
    flags: Flags,
    /// Last event; a packet without one does not change it.
    event: Option<Event>,
    /// Highest severity of the events since the controller last reported no event. Excludes information.
    standing: Option<Severity>,
}

/// Event of the controller: its code and message, as in the packet.
type Event = (String, String);

impl Alarms {
    /// Returns an iterator over the alarms, the newest first.
    pub(super) fn entries(&self) -> impl Iterator<Item = &Alarm> {
        self.entries.iter()
    }

    /// Returns the alarms in lines of this width, the newest first.
    pub(super) fn lines(&self, width: u16) -> Vec<Line<'static>> {
        let columns = usize::from(width).saturating_sub(TIME_COLUMNS);
        let lines = self.entries().flat_map(|alarm| {
            let mut time = format!(" {} ", alarm.clock());
            let style = style::of_tone(alarm.tone);
            pieces(&alarm.text, columns).into_iter().map(move |piece| {
                let time = std::mem::replace(&mut time, " ".repeat(TIME_COLUMNS));
                Line::from(vec![Span::styled(time, style::faint()), Span::styled(piece, style)])
            })
        });
        let lines: Vec<_> = lines.collect();
        if lines.is_empty() { vec![Line::styled(" none since the start", style::faint())] } else { lines }
    }

    /// Adds an alarm.
    pub(super) fn add(&mut self, time: SystemTime, tone: Tone, text: impl Into<String>) {
        self.entries.push_front(Alarm { time, tone, text: visible(&text.into()).into_owned() });
        self.entries.truncate(MOST);
    }

    /// Adds an alarm for each change of a packet from the previous ones.
    pub(super) fn packet(&mut self, status: &RobotStatus, time: SystemTime) {
        for (tone, text) in self.flags.see(status) {
            self.add(time, tone, text);
        }
        if let (Some(code), message) = (&status.error_code, &status.error_message) {
            let event = (code.clone(), message.clone().unwrap_or_default());
            self.event(time, &status.event(), &event);
            self.event = Some(event);
        }
    }

    /// Reports an event that is more than information. The most severe one stays until the controller reports its end
    /// with a code of zero: information may replace an error in the packet while the error lasts.
    fn event(&mut self, time: SystemTime, reading: &event::Reading, (code, message): &Event) {
        let Some(severity) = event::severity(reading) else {
            if let Some(standing) = self.standing.take() {
                self.add(time, Tone::Good, format!("{} cleared", name(standing)));
            }
            return;
        };
        if severity == Severity::Information {
            return;
        }
        if self.event.as_ref().is_none_or(|(before, told)| (before, told) != (code, message)) {
            let message = if message.is_empty() { event::meaning(reading).unwrap_or_default() } else { message };
            let tone = if severity == Severity::Warning { Tone::Warning } else { Tone::Bad };
            if let Some(remedy) = event::remedy(reading).filter(|remedy| !remedy.of_family) {
                self.add(time, Tone::Plain, format!("  remedy: {remedy}"));
            }
            self.add(time, tone, format!("{} {code} {message}", label(severity)).trim_end());
        }
        self.standing = WORST_FIRST.into_iter().find(|one| *one == severity || self.standing == Some(*one));
    }
}

/// Cuts the text in pieces of at most so many columns, between words if possible. Each piece has the indentation of
/// the text.
fn pieces(text: &str, columns: usize) -> Vec<String> {
    let indentation: String = text.chars().take_while(|c| *c == ' ').collect();
    let columns = columns.saturating_sub(indentation.len()).max(1);
    let (mut pieces, mut piece, mut used) = (Vec::new(), indentation.clone(), 0);
    for word in text.split(' ').filter(|word| !word.is_empty()) {
        if used > 0 && used + 1 + width(word) > columns {
            pieces.push(std::mem::replace(&mut piece, indentation.clone()));
            used = 0;
        } else if used > 0 {
            piece.push(' ');
            used += 1;
        }
        for c in word.chars() {
            let c_columns = width(c.encode_utf8(&mut [0; 4]));
            if used > 0 && used + c_columns > columns {
                pieces.push(std::mem::replace(&mut piece, indentation.clone()));
                used = 0;
            }
            piece.push(c);
            used += c_columns;
        }
    }
    pieces.push(piece);
    pieces
}

fn width(text: &str) -> usize {
    Span::raw(text).width()
}

/// Returns the label of an event of this severity.
fn label(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        _ => "event of unknown severity",
    }
}

/// Returns the word for an event of this severity.
fn name(severity: Severity) -> &'static str {
    match severity {
        Severity::Error | Severity::Warning => label(severity),
        _ => "event",
    }
}

/// Formats a duration for people.
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
    fn texts_are_cut_between_words_and_long_words_anywhere() {
        assert_eq!(pieces("  remedy: look for obstacles", 12), ["  remedy:", "  look for", "  obstacles"]);
        assert_eq!(pieces("remedy: look", 12), ["remedy: look"]);
        assert_eq!(pieces("a unbreakable", 4), ["a", "unbr", "eaka", "ble"]);
        assert_eq!(pieces("碰撞检测", 4), ["碰撞", "检测"]);
        assert_eq!(pieces("", 4), [""]);
        assert_eq!(pieces("ab", 0), ["a", "b"]);
    }

    #[test]
    fn changes_are_reported_once() {
        let mut alarms = Alarms::default();
        let mut status = RobotStatus::default();
        let mut tell = |status: &RobotStatus| alarms.packet(status, UNIX_EPOCH);
        tell(&status);
        status.enabled = Some(true);
        status.error_code = Some("0x0".to_owned());
        tell(&status);
        status.protective_stop = Some(true);
        status.error_code = Some("0x0f0034".to_owned());
        status.error_message = Some("collision".to_owned());
        tell(&status);
        tell(&status);
        // A packet without the field has no effect.
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
            Bad error 0x0f0034 collision
            Plain   remedy: look for obstacles around the arm and for signs of a collision; check whether the robot's serial number and model are recognised correctly; check the settings of payload and mounting angle
            Bad protective stop
        "]]
        .assert_eq(&texts.concat());
    }

    /// Returns the alarms of packets with these codes and messages, the newest first.
    fn alarms_of(codes: &[(&str, &str)]) -> String {
        let mut alarms = Alarms::default();
        for (code, message) in codes {
            let mut status = RobotStatus::default();
            status.error_code = Some((*code).to_owned());
            status.error_message = Some((*message).to_owned());
            alarms.packet(&status, UNIX_EPOCH);
        }
        let texts: Vec<_> = alarms.entries().map(|alarm| format!("{:?} {}\n", alarm.tone, alarm.text)).collect();
        texts.concat()
    }

    #[test]
    fn information_is_not_an_alarm() {
        let codes =
            [("0x0", ""), ("0x10f0004", "enabled"), ("0x10f0015", ""), ("0x10f0000", "emergency stop"), ("0x0", "")];
        assert_eq!(alarms_of(&codes), "");
    }

    #[test]
    fn warnings_are_marked_and_what_is_unknown_is_an_alarm() {
        let codes = [("0x10f0020", ""), ("0x0f9999", "new"), ("fine", "what"), ("0x0f0030", ""), ("0x0f0034", "")];
        expect![[r"
            Bad error 0x0f0034 a collision was detected
            Plain   remedy: look for obstacles around the arm and for signs of a collision; check whether the robot's serial number and model are recognised correctly; check the settings of payload and mounting angle
            Bad error 0x0f0030 the joint speed limit is set to 0
            Plain   remedy: check in the app's safety settings whether the joint speed limit is 0 °/s
            Bad event of unknown severity fine what
            Bad event of unknown severity 0x0f9999 new
            Warning warning 0x10f0020 reduced mode is on
        "]]
        .assert_eq(&alarms_of(&codes));
    }

    /// Only zero ends an error: another event may follow it while it lasts.
    #[test]
    fn an_error_is_not_cleared_by_information() {
        let codes = [("0x0f0034", ""), ("0x10f000b", ""), ("0x10f0020", ""), ("0x0", ""), ("0x0", "")];
        expect![[r"
            Good error cleared
            Warning warning 0x10f0020 reduced mode is on
            Bad error 0x0f0034 a collision was detected
            Plain   remedy: look for obstacles around the arm and for signs of a collision; check whether the robot's serial number and model are recognised correctly; check the settings of payload and mounting angle
        "]]
        .assert_eq(&alarms_of(&codes));
        let codes = [("0x10f0020", ""), ("0x10f0021", ""), ("0x10f000b", ""), ("0x0", "")];
        expect![[r"
            Good warning cleared
            Warning warning 0x10f0021 reduced mode is off
            Warning warning 0x10f0020 reduced mode is on
        "]]
        .assert_eq(&alarms_of(&codes));
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
