//! Transfer from a monitor to the view.

use std::collections::{BTreeSet, VecDeque};
use std::sync::Arc;
use std::time::{Duration, Instant, SystemTime};

use jaka_robot::{Monitor, Snapshot, Subscription};

use super::View;
use super::alarms::duration;
use super::view::{Link, STALE};
use crate::packets::fields::Field;
use crate::packets::flags::Tone;
use crate::packets::packed_status::{PackedStatus, own_fields};
use crate::packets::value_rows::value_rows;

/// Queue for packets of some seconds, so that a slow terminal misses no alarm.
const CAPACITY: usize = 1000;
/// Time over which the rate is measured.
const OF_LATE: Duration = Duration::from_secs(2);

/// Updates a view with the packets read by a monitor.
#[derive(Debug)]
pub(crate) struct Feed {
    monitor: Monitor<PackedStatus>,
    queue: Subscription<PackedStatus>,
    newest: Option<Arc<Snapshot<PackedStatus>>>,
    shown: Option<Arc<Snapshot<PackedStatus>>>,
    /// Whether there is an active alarm for missing packets.
    silent: bool,
    /// Number of the monitor's reconnections at the last packet.
    reconnects: u64,
    /// Fields that packs add or change.
    own_fields: Vec<Field>,
    /// Fields reported not to fit.
    unfit: BTreeSet<String>,
    /// Numbers of packets at times of the last seconds.
    counts: VecDeque<(Instant, u64)>,
}

impl Feed {
    pub(crate) fn new(monitor: Monitor<PackedStatus>) -> Self {
        let queue = monitor.subscribe(CAPACITY);
        Self {
            monitor,
            queue,
            newest: None,
            shown: None,
            silent: false,
            reconnects: 0,
            own_fields: own_fields(),
            unfit: BTreeSet::new(),
            counts: VecDeque::new(),
        }
    }

    /// Updates the view to the present.
    pub(crate) fn update(&mut self, view: &mut View) {
        while let Some(packet) = self.queue.try_next_packet() {
            self.take(&packet, view);
            self.newest = Some(packet);
        }
        self.watch_silence(view);
        if !view.paused || self.shown.is_none() {
            self.shown.clone_from(&self.newest);
            view.status = self.shown.as_ref().map(|packet| packet.status.status.clone());
            let packed = self.shown.as_ref().map(|packet| packet.status.own());
            let rows = |field: &Field| Some(value_rows(&field.name, field.value(packed.as_ref()?)?));
            view.packed = self.own_fields.iter().filter_map(rows).flatten().collect();
        }
        view.age = self.shown.as_ref().map(|packet| packet.age());
        view.link = self.link();
    }

    fn take(&mut self, packet: &Snapshot<PackedStatus>, view: &mut View) {
        let time = SystemTime::now().checked_sub(packet.age()).unwrap_or_else(SystemTime::now);
        let reconnects = self.monitor.statistics().reconnects;
        let again = if reconnects > self.reconnects { "reconnected" } else { "status packets resumed" };
        if self.silent || reconnects > self.reconnects {
            let gap = self.newest.as_ref().map(|last| packet.received.saturating_duration_since(last.received));
            let after = gap.map_or_else(String::new, |gap| format!(" after {}", duration(gap)));
            view.alarms.add(time, Tone::Good, format!("{again}{after}"));
        }
        (self.silent, self.reconnects) = (false, reconnects);
        self.tell_unfit(packet, view, time);
        view.alarms.packet(&packet.status.status, time);
    }

    /// Reports each field that does not fit once: its value is unknown.
    fn tell_unfit(&mut self, packet: &Snapshot<PackedStatus>, view: &mut View, time: SystemTime) {
        let unfit = packet.unfit.iter().chain(&packet.status.unfit);
        for error in unfit.filter(|error| self.unfit.insert(error.field().to_owned())) {
            view.alarms.add(time, Tone::Bad, error.to_string());
        }
    }

    /// Reports once that packets have stopped.
    fn watch_silence(&mut self, view: &mut View) {
        let stopped = self.newest.as_ref().is_some_and(|packet| packet.age() > STALE);
        if stopped && !self.silent {
            self.silent = true;
            view.alarms.add(SystemTime::now(), Tone::Bad, "no status packets: connection lost, or controller silent");
        }
    }

    fn link(&mut self) -> Link {
        let found = self.monitor.statistics();
        let now = Instant::now();
        self.counts.push_back((now, found.packets + found.skipped));
        while self.counts.front().is_some_and(|(time, _)| now.saturating_duration_since(*time) > OF_LATE) {
            self.counts.pop_front();
        }
        Link {
            rate: self.rate(),
            jitter: found.period.map(|_| found.jitter),
            longest_gap: found.period.map(|_| found.longest_gap),
            skipped: found.skipped,
            unfit: found.unfit + found.resyncs,
            reconnects: found.reconnects,
            ended: self.monitor.disconnect_cause().map(|cause| cause.to_string()),
        }
    }

    fn rate(&self) -> Option<f64> {
        let ((first, before), (last, now)) = (self.counts.front()?, self.counts.back()?);
        let time = last.saturating_duration_since(*first);
        #[expect(clippy::cast_precision_loss, reason = "packets of two seconds are few")]
        let packets = now.saturating_sub(*before) as f64;
        (time >= OF_LATE / 4).then(|| packets / time.as_secs_f64())
    }
}

#[cfg(test)]
mod tests {
    use jaka_robot::Reconnect;
    use jaka_tests::{Arm, LONG};

    use super::*;

    /// Returns an arm whose controller sends a packet on connecting and on request, and a feed that has had the first
    /// one.
    fn started() -> (Arm, Feed, View) {
        let policy = Reconnect::Attempts { limit: 1000, delay: Duration::from_millis(1), longest: LONG };
        let controller =
            Arm::simulated().without_power().no_packets().config(|config| config.reconnect(policy)).start();
        let monitor = Monitor::connect_with(&controller.config(), controller.status_addr()).unwrap();
        let (mut feed, mut view) = (Feed::new(monitor), View::default());
        // The first packet may have come before the queue existed.
        controller.publish();
        update_until(&mut feed, &mut view, |view| view.status.is_some());
        (controller, feed, view)
    }

    const MOMENT: Duration = Duration::from_millis(10);

    fn update_until(feed: &mut Feed, view: &mut View, wanted: impl Fn(&View) -> bool) {
        let mut elapsed = Duration::ZERO;
        while !wanted(view) {
            assert!(elapsed < LONG, "{view:?}");
            // Waits for a change of the view: a packet, or the time without one.
            let _ = feed.monitor.wait_until(|_| false, MOMENT);
            elapsed += MOMENT;
            feed.update(view);
        }
    }

    fn newest_alarm(view: &View) -> &str {
        view.alarms.entries().next().map_or("", |alarm| &alarm.text)
    }

    #[test]
    fn silence_and_its_end_are_reported() {
        let (controller, mut feed, mut view) = started();
        update_until(&mut feed, &mut view, |view| newest_alarm(view).starts_with("no status packets"));
        assert!(!view.is_fresh());
        controller.publish();
        update_until(&mut feed, &mut view, |view| newest_alarm(view).starts_with("status packets resumed after"));
        assert!(view.status.is_some());
    }

    #[test]
    fn a_new_connection_is_reported() {
        let (controller, mut feed, mut view) = started();
        controller.disconnect();
        update_until(&mut feed, &mut view, |view| newest_alarm(view).starts_with("reconnected after"));
        assert_eq!(view.link.reconnects, 1);
    }

    #[test]
    fn a_field_that_does_not_fit_is_reported_once_and_the_rest_is_shown() {
        let (controller, mut feed, mut view) = started();
        for _ in 0..2 {
            controller.send_status(br#"{"len": 55, "rapidrate": "100%", "protective_stop": 1}"#);
        }
        update_until(&mut feed, &mut view, |view| view.link.unfit == 2 && newest_alarm(view) == "protective stop");
        let unfit: Vec<_> = view.alarms.entries().filter(|alarm| alarm.text.contains("rapid_rate")).collect();
        assert_eq!(unfit.len(), 1, "{unfit:?}");
        assert_eq!(view.status.as_ref().and_then(|status| status.rapid_rate), None);
    }

    #[test]
    fn a_pause_keeps_what_is_shown_and_misses_no_alarm() {
        let (controller, mut feed, mut view) = started();
        view.paused = true;
        controller.press_emergency_stop();
        controller.publish();
        update_until(&mut feed, &mut view, |view| newest_alarm(view) == "emergency stop");
        assert_eq!(view.status.as_ref().and_then(|status| status.emergency_stop), Some(false));
        view.paused = false;
        feed.update(&mut view);
        assert_eq!(view.status.as_ref().and_then(|status| status.emergency_stop), Some(true));
    }
}
