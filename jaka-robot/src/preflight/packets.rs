//! Check of status packets: their content, their form and their rate.

use std::sync::Arc;
use std::time::Duration;

use jaka_clock::Stopwatch;
use jaka_proto::messages::status::RobotStatus;
use jaka_sync::layer::needed;
use jaka_sync::{Error, MonitorStatistics, Severity, Snapshot, StatusProblem};

use super::finding::{CheckItem, Finding, Judgement};
use super::ports;
use crate::arm::StatusPort;

/// Time for which packets are counted.
const WINDOW: Duration = Duration::from_secs(1);
/// Packets in a second: they come each 30 ms on firmware 1.5.14, and each 50 or 100 ms elsewhere (field notes). A few
/// may be late.
const FEWEST: f64 = 8.0;

const SLOW: &str = "check the network, and how often the controller sends (`get_port10000_delay_ms` on newer firmware)";

const SILENT: &str = "check the network and the controller, and wait until packets come again";

/// Packets being counted.
#[derive(Debug)]
pub(super) struct Count<'m> {
    status: StatusPort<'m>,
    since: Stopwatch,
    before: MonitorStatistics,
}

impl<'m> Count<'m> {
    /// Waits for the first packet.
    pub(super) fn begin(status: Result<StatusPort<'m>, &Error>) -> Result<Self, Judgement> {
        let status = status.map_err(|error| ports::of_status(error, 0))?;
        let StatusPort { source, state } = status;
        if state.fresh_packet().is_err() {
            source.next_packet().map_err(|error| ports::of_status(&error, source.statistics().dropped_bytes))?;
        }
        Ok(Self { status, since: state.clock().stopwatch(), before: source.statistics() })
    }

    /// Counts to the end, and returns the newest packet, which is none that a network may have held back.
    pub(super) fn end(self, findings: &mut Vec<Finding>) -> Result<Option<Arc<Snapshot>>, Judgement> {
        let StatusPort { source, state } = self.status;
        let ended = state.watch(self.since.left_of(WINDOW), |_| None::<()>);
        let (elapsed, after) = (self.since.passed(), source.statistics());
        if let Err(cause) = ended {
            return Err(ports::status_ended(&cause));
        }
        // A later packet shows the present.
        let may_be_old = || matches!(state.fresh_packet(), Err(StatusProblem::Resuming));
        let _ = state.watch(state.stale_after(), |_| (!may_be_old()).then_some(()));
        let newest = match state.fresh_packet() {
            Ok(newest) => Some(newest),
            Err(StatusProblem::Stale { age }) => {
                return Err(Judgement::wrong(format!("the last status packet came {age:.1?} ago"), SILENT));
            }
            Err(StatusProblem::Resuming) => {
                return Err(Judgement::wrong(
                    "status packets have just resumed after a silence, and may be old",
                    SILENT,
                ));
            }
            Err(_) => state.newest_packet(),
        };
        let newest = newest.ok_or_else(no_packet)?;
        findings.extend([
            Judgement::nothing("packets arrive").at(CheckItem::StatusPort),
            rate(arrived(&after).saturating_sub(arrived(&self.before)), elapsed).at(CheckItem::StatusRate),
            form(&newest, source.absent(), after.dropped_bytes.saturating_sub(self.before.dropped_bytes))
                .at(CheckItem::StatusPackets),
        ]);
        Ok(Some(newest))
    }
}

/// Judges the facts that only packets show, and no query of the document.
pub(super) fn read(packet: Option<&RobotStatus>, findings: &mut Vec<Finding>) {
    findings.extend([
        shown(packet, |packet| packet.emergency_stop, emergency_stop).at(CheckItem::EmergencyStop),
        shown(packet, |packet| packet.error_code.as_deref().map(|_| packet), event).at(CheckItem::Event),
        shown(packet, |packet| packet.rapid_rate, rapid_rate).at(CheckItem::RapidRate),
        shown(packet, |packet| packet.on_soft_limit, soft_limit).at(CheckItem::SoftLimit),
    ]);
}

/// Judgement that the packet does not show the item, or that there is no packet.
pub(super) fn not_shown(packet: Option<&RobotStatus>) -> Judgement {
    match packet {
        Some(_) => Judgement::not_checked("status packets do not show it"),
        None => no_packet(),
    }
}

pub(super) fn no_packet() -> Judgement {
    Judgement::not_checked("there is no status packet")
}

fn shown<'p, T>(
    packet: Option<&'p RobotStatus>,
    field: impl FnOnce(&'p RobotStatus) -> Option<T>,
    judge: impl FnOnce(T) -> Judgement,
) -> Judgement {
    packet.and_then(field).map_or_else(|| not_shown(packet), judge)
}

fn emergency_stop(is_pressed: bool) -> Judgement {
    if is_pressed {
        let advice = "release it when nobody is at the arm, and enable the arm";
        return Judgement::wrong("the emergency stop is pressed", advice);
    }
    Judgement::nothing("not pressed")
}

/// An event is not always an error, and may be over.
fn event(packet: &RobotStatus) -> Judgement {
    let message = packet.error_message.as_deref().filter(|message| !message.is_empty());
    let with_message = |event: String| message.map_or(event.clone(), |message| format!("{event}, {message:?}"));
    match packet.event() {
        Ok(None) => Judgement::nothing("none"),
        Err(error) => Judgement::look(with_message(error.to_string()), "look at the pendant"),
        Ok(Some(event)) => {
            let seen = with_message(event.to_string());
            match event.severity() {
                Severity::Information => Judgement::nothing(seen),
                Severity::Error => {
                    Judgement::wrong(seen, "remove its cause: the pendant and the vendor's table of events explain it")
                }
                _ => Judgement::look(seen, "look it up in the vendor's table of events, or at the pendant"),
            }
        }
    }
}

fn rapid_rate(rate: f64) -> Judgement {
    let seen = format!("{rate} of 1");
    if rate == 0.0 {
        return Judgement::wrong(seen, "no motion moves the arm: set it with `set_rapid_rate`");
    }
    if (rate - 1.0).abs() < f64::EPSILON {
        return Judgement::nothing(seen);
    }
    Judgement::look(seen, "motions run at another speed than requested: set it with `set_rapid_rate`")
}

fn soft_limit(flag: i64) -> Judgement {
    if flag == 0 {
        return Judgement::nothing("not hit");
    }
    let advice = "find the joint, and jog it back";
    Judgement::look(format!("hit (`on_soft_limit` is {flag})"), advice)
}

/// All packets, also those that were never the newest because others followed at once.
fn arrived(statistics: &MonitorStatistics) -> u64 {
    statistics.packets.saturating_add(statistics.skipped)
}

fn rate(packets: u64, elapsed: Duration) -> Judgement {
    #[expect(clippy::cast_precision_loss, reason = "there are not so many packets in a second")]
    let rate = packets as f64 / elapsed.as_secs_f64();
    let seen = format!("{rate:.0} packets in a second");
    if rate >= FEWEST {
        return Judgement::nothing(seen);
    }
    Judgement::look(format!("{seen}; 10 to 33 are usual"), SLOW)
}

/// Judges the form of the packet: keys that are missing or cannot be read, and bytes between packets.
fn form(newest: &Snapshot, absent: &[&str], dropped: u64) -> Judgement {
    const PROBE: &str = "`jaka probe` compares the packet with the spec";
    const NO_ERRORS: &str = "look at the pendant for errors of the controller: packets do not show them";
    let mut seen: Vec<_> = newest.unfit.iter().map(|unfit| format!("cannot be read: {unfit}")).collect();
    let missing: Vec<_> = missing(newest).into_iter().filter(|field| !absent.contains(field)).collect();
    if !missing.is_empty() {
        seen.push(format!("missing: {}", missing.join(", ")));
    }
    if dropped > 0 {
        seen.push(format!("{dropped} bytes that are not a packet"));
    }
    let is_whole = seen.is_empty();
    if !absent.is_empty() {
        seen.push(format!("absent, as declared: {}", absent.join(", ")));
    }
    let seen = seen.join("; ");
    if newest.unreadable().is_some() {
        let advice = format!("a `Robot` refuses motions while it cannot tell whether the arm is stopped: {PROBE}");
        return Judgement::wrong(seen, &advice);
    }
    match (is_whole, absent) {
        (true, []) => Judgement::nothing("complete"),
        (true, absent) if absent.contains(&"error_code") => Judgement::look(seen, NO_ERRORS),
        (true, _) => Judgement::nothing(format!("complete; {seen}")),
        (false, _) => Judgement::look(seen, PROBE),
    }
}

/// Fields for a robot and for this check that the packet has in no form.
fn missing(newest: &Snapshot) -> Vec<&'static str> {
    let status = &newest.status;
    let of_check = [("rapid_rate", status.rapid_rate.is_some())];
    let missing =
        needed(status).into_iter().chain(of_check).filter(|(field, is_there)| !is_there && !newest.is_unfit(field));
    missing.map(|(field, _)| field).collect()
}

#[cfg(test)]
mod tests {
    use super::super::finding::Verdict;
    use super::*;

    #[test]
    fn ten_packets_in_a_second_are_usual_though_some_are_late() {
        let verdict = |packets, ms| rate(packets, Duration::from_millis(ms)).verdict;
        assert_eq!([verdict(33, 1000), verdict(8, 1000), verdict(17, 2100)], [Verdict::NothingFound; 3]);
        assert_eq!([verdict(0, 1000), verdict(7, 1000), verdict(8, 1100)], [Verdict::Look; 3]);
    }
}
