//! Advice on changes to a machine, from the measurements. The thresholds are our choice.

use std::time::Duration;

use super::measured::{Lateness, Measured, PRIORITY, RoundTrip, SPIN, Waits};
use crate::text::number::count;

/// Period of a servo session.
const PERIOD: Duration = Duration::from_millis(8);
/// Greatest lateness of 99 of 100 cycles at which spinning is not worth its CPU time: 3 % of the period.
const EXACT: Duration = Duration::from_micros(250);
/// Lateness from which a cycle is late, as in a session's report.
const LATE: Duration = Duration::from_millis(4);
/// Gap without a set-point after which the arm counts as stopped.
const GAP: Duration = Duration::from_millis(24);
/// Time of unanswered set-points after which a session ends.
const UNANSWERED: Duration = Duration::from_millis(100);
/// Number of cycles below which one in a hundred has little meaning.
const FEWEST: usize = 1000;

/// Advice on one item.
#[derive(Debug, PartialEq)]
pub(super) struct Advice {
    pub(super) item: &'static str,
    pub(super) verdict: &'static str,
    pub(super) text: String,
}

/// Verdict, and its reason.
type Verdict = (&'static str, String);

const LEAVE: &str = "leave";
const CHANGE: &str = "change";

/// Returns the advice, item by item.
pub(super) fn on(measured: &Measured) -> Vec<Advice> {
    let lateness = &measured.lateness;
    let items = [
        ("busy_wait", Some(busy_wait(lateness))),
        ("priority", Some(priority(lateness))),
        ("core", Some(core(lateness))),
        ("network", Some(network(measured.round_trip.as_ref()))),
        ("gaps", gaps(lateness)),
        ("seconds", seconds(&lateness.usual)),
    ];
    let given = items.into_iter().filter_map(|(item, verdict)| Some((item, verdict?)));
    given.map(|(item, (verdict, text))| Advice { item, verdict, text }).collect()
}

/// Judges busy waiting, with the better priority.
fn busy_wait(lateness: &Lateness) -> Verdict {
    let waits = match &lateness.realtime {
        Ok(realtime) if share(realtime) < share(&lateness.usual) => realtime,
        _ => &lateness.usual,
    };
    let [asleep, spinning] = [&waits.asleep, &waits.spinning].map(|times| times.within(99));
    if asleep <= EXACT {
        return (LEAVE, format!("asleep, 99 % of cycles begin within {asleep:.1?}, which is not over {EXACT:?}"));
    }
    let compared = format!("spinning, 99 % of cycles begin within {spinning:.1?}; asleep, within {asleep:.1?}");
    if spinning * 2 <= asleep {
        (CHANGE, format!("spin before each cycle, with `ServoConfig::busy_wait` of {SPIN:?}: {compared}"))
    } else {
        (LEAVE, format!("spinning does not halve the lateness: {compared}"))
    }
}

fn priority(lateness: &Lateness) -> Verdict {
    let (usual, counts) = (late(&lateness.usual), counts(&lateness.usual));
    let is_late = lateness.usual.at_least(LATE) > 0;
    match &lateness.realtime {
        Err(refusal) if is_late => (
            CHANGE,
            format!(
                "{usual} without a real-time priority, and none could be measured; allow it, and measure again: {refusal}"
            ),
        ),
        Err(refusal) => (LEAVE, format!("{usual} without a real-time priority; none could be measured: {refusal}")),
        Ok(_) if !is_late => (LEAVE, format!("{usual} without a real-time priority")),
        Ok(realtime) if share(realtime) < share(&lateness.usual) => (
            CHANGE,
            format!(
                "set a real-time priority, with `ServoConfig::realtime_priority({PRIORITY})` (feature `realtime`): {}, {counts} without it",
                late(realtime)
            ),
        ),
        Ok(realtime) => (LEAVE, format!("a real-time priority does not help: {}, {counts} without it", late(realtime))),
    }
}

fn core(lateness: &Lateness) -> Verdict {
    const KEEP: &str = "reserve a core for the cycle: `isolcpus` on the command line of the kernel, and `taskset` for the program; otherwise a \
                        real-time kernel (PREEMPT_RT), no power saving, no virtual machine";
    match &lateness.realtime {
        Ok(waits) if waits.at_least(LATE) > 0 => (CHANGE, format!("{} with a real-time priority: {KEEP}", late(waits))),
        Ok(waits) => (LEAVE, format!("{} with a real-time priority", late(waits))),
        Err(_) if lateness.usual.at_least(LATE) > 0 => {
            (CHANGE, format!("if a real-time priority is not enough, {KEEP}"))
        }
        Err(_) => (LEAVE, late(&lateness.usual)),
    }
}

fn network(round_trip: Option<&RoundTrip>) -> Verdict {
    let Some(round_trip) = round_trip else {
        return ("not measured", "name a robot with `--robot`, or use `--sim`".to_owned());
    };
    let [usual, longest] = [99, 100].map(|percent| round_trip.times.within(percent));
    let seen = format!("99 % of replies came within {usual:.1?}, all within {longest:.1?}");
    if usual <= PERIOD && longest < UNANSWERED {
        return (LEAVE, format!("{seen}, which is not over {PERIOD:?} and under {UNANSWERED:?}"));
    }
    let advice = "connect by cable, without Wi-Fi and busy switches: set-points are due each";
    (CHANGE, format!("{seen}; {advice} {PERIOD:?}, and a session ends when {UNANSWERED:?} of them are not answered"))
}

/// Judges gaps, if there are any, with real-time priority if it was measured.
fn gaps(lateness: &Lateness) -> Option<Verdict> {
    let waits = lateness.realtime.as_ref().unwrap_or(&lateness.usual);
    let gaps = waits.at_least(GAP);
    let cycles = count(gaps, "cycle");
    let text = format!(
        "{cycles} began {GAP:?} late or more: in a motion the arm would have stopped; do not move an arm from this machine before this is fixed"
    );
    (gaps > 0).then_some((CHANGE, text))
}

fn seconds(waits: &Waits) -> Option<Verdict> {
    let cycles = waits.asleep.count();
    let text = format!("measure for longer, such as 60 s: {} of each kind are too few", count(cycles, "cycle"));
    (cycles < FEWEST).then_some((CHANGE, text))
}

/// Returns the number of late cycles, in words.
fn late(waits: &Waits) -> String {
    format!("{} cycles began {LATE:?} late or more", counts(waits))
}

fn counts(waits: &Waits) -> String {
    format!("{} of {}", waits.at_least(LATE), waits.count())
}

#[expect(clippy::cast_precision_loss)]
fn share(waits: &Waits) -> f64 {
    waits.at_least(LATE) as f64 / waits.count().max(1) as f64
}

#[cfg(test)]
mod tests {
    use super::super::measured::Times;
    use super::*;

    /// Returns cycles of which some are late, in microseconds each.
    fn waits(asleep: u64, spinning: u64, some: usize, late: u64) -> Waits {
        let times = |usual| {
            let mut times = Times::default();
            let late = std::iter::repeat_n(Duration::from_micros(late), some);
            times.add(std::iter::repeat_n(Duration::from_micros(usual), FEWEST - some).chain(late));
            times
        };
        Waits { asleep: times(asleep), spinning: times(spinning) }
    }

    fn round_trip(usual: u64, longest: u64) -> RoundTrip {
        let mut times = Times::default();
        times.add(std::iter::repeat_n(Duration::from_micros(usual), 999).chain([Duration::from_micros(longest)]));
        RoundTrip { robot: "arm".to_owned(), times }
    }

    fn verdicts(usual: Waits, realtime: Result<Waits, String>, round_trip: Option<RoundTrip>) -> Vec<String> {
        let advice = on(&Measured { lateness: Lateness { usual, realtime }, round_trip });
        advice.iter().map(|advice| format!("{} {}", advice.item, advice.verdict)).collect()
    }

    #[test]
    fn a_good_machine_is_left_as_it_is() {
        let found = verdicts(waits(250, 1, 1, 3999), Ok(waits(100, 1, 0, 0)), Some(round_trip(8000, 99_999)));
        assert_eq!(found, ["busy_wait leave", "priority leave", "core leave", "network leave"]);
        let found = verdicts(waits(250, 1, 0, 0), Err("not allowed".to_owned()), None);
        assert_eq!(found, ["busy_wait leave", "priority leave", "core leave", "network not measured"]);
    }

    #[test]
    fn what_helps_is_advised() {
        let found = verdicts(waits(300, 151, 2, 4000), Ok(waits(300, 150, 0, 0)), Some(round_trip(8001, 8001)));
        assert_eq!(found, ["busy_wait change", "priority change", "core leave", "network change"]);
        let found = verdicts(waits(300, 150, 2, 4000), Ok(waits(300, 151, 1, 23_999)), Some(round_trip(100, 100_000)));
        assert_eq!(found, ["busy_wait leave", "priority change", "core change", "network change"]);
        let found = verdicts(waits(100, 1, 1, 4000), Ok(waits(100, 1, 1, 24_000)), None);
        assert_eq!(found, ["busy_wait leave", "priority leave", "core change", "network not measured", "gaps change"]);
        let found = verdicts(waits(100, 1, 1, 24_000), Err("not allowed".to_owned()), None);
        assert_eq!(found, ["busy_wait leave", "priority change", "core change", "network not measured", "gaps change"]);
    }

    #[test]
    fn a_short_measurement_says_so() {
        let mut asleep = Times::default();
        asleep.add([Duration::ZERO; FEWEST - 1]);
        let found = verdicts(Waits { asleep, spinning: Times::default() }, Ok(Waits::default()), None);
        assert_eq!(found.last().map(String::as_str), Some("seconds change"));
    }
}
