//! Results of the measurements, for people and for programs.

use std::fmt::Write;
use std::time::Duration;

use jaka_robot::kinematics::GetJointPos;
use jaka_robot::{Command, ServoConfig};
use serde_json::{Value, json};

use super::advice;
use super::measured::{Measured, PRIORITY, SPIN, Times, micros};
use crate::text::number::fixed;

/// Kind of wait: its times, or the reason why there are none.
struct LatenessRow<'m> {
    busy_wait: Duration,
    priority: Option<u8>,
    times: Result<&'m Times, &'m str>,
}

impl LatenessRow<'_> {
    fn name(&self) -> String {
        let wait =
            if self.busy_wait.is_zero() { "asleep".to_owned() } else { format!("spinning {:?}", self.busy_wait) };
        self.priority.map_or(wait.clone(), |priority| format!("{wait}, priority {priority}"))
    }
}

fn rows(measured: &Measured) -> [LatenessRow<'_>; 4] {
    let usual = &measured.lateness.usual;
    let realtime = measured.lateness.realtime.as_ref().map_err(String::as_str);
    [
        LatenessRow { busy_wait: Duration::ZERO, priority: None, times: Ok(&usual.asleep) },
        LatenessRow { busy_wait: SPIN, priority: None, times: Ok(&usual.spinning) },
        LatenessRow { busy_wait: Duration::ZERO, priority: Some(PRIORITY), times: realtime.map(|waits| &waits.asleep) },
        LatenessRow { busy_wait: SPIN, priority: Some(PRIORITY), times: realtime.map(|waits| &waits.spinning) },
    ]
}

/// Returns two tables, and advice on changes.
pub(super) fn text(measured: &Measured) -> String {
    let period = ServoConfig::new().period();
    let mut text = format!("Lateness of cycles of {period:?} on this machine, in µs\n\n");
    let heads = format!("{:?} or more", period * 3);
    let columns = ["cycles", "p50", "p90", "p99", "max", &format!("{period:?} or more"), &heads];
    line(&mut text, "", columns.map(str::to_owned));
    for row in rows(measured) {
        match row.times {
            Ok(times) => {
                let [p50, p90, p99, most] = [50, 90, 99, 100].map(|percent| fixed(micros(times.within(percent)), 1));
                let [late, gaps] = [period, period * 3].map(|time| times.at_least(time).to_string());
                line(&mut text, &row.name(), [times.count().to_string(), p50, p90, p99, most, late, gaps]);
            }
            Err(_) => line(&mut text, &row.name(), ["not allowed: see `priority` below".to_owned()]),
        }
    }
    if let Some(round_trip) = &measured.round_trip {
        let times = &round_trip.times;
        writeln!(text, "\nTime until replies of {} to `{}`, in µs\n", round_trip.robot, GetJointPos::INFO.name).ok();
        line(&mut text, "", ["replies", "p50", "p99", "max"].map(str::to_owned));
        let [p50, p99, most] = [50, 99, 100].map(|percent| fixed(micros(times.within(percent)), 1));
        line(&mut text, "", [times.count().to_string(), p50, p99, most]);
    }
    text.push_str("\nRecommendations\n\n");
    for advice in advice::on(measured) {
        writeln!(text, "{:<10} {:<13} {}", advice.item, advice.verdict, advice.text).ok();
    }
    text
}

/// Writes a line of a table.
fn line<const CELLS: usize>(text: &mut String, name: &str, cells: [String; CELLS]) {
    write!(text, "{name:<30}").ok();
    for cell in cells {
        write!(text, " {cell:>13}").ok();
    }
    text.push('\n');
}

/// Returns the JSON described in the README.
pub(super) fn json(measured: &Measured) -> Value {
    let round_trip = measured.round_trip.as_ref().map(|round_trip| {
        let mut figures = figures(&round_trip.times);
        figures["robot"] = json!(round_trip.robot);
        figures["query"] = json!(GetJointPos::INFO.name);
        figures
    });
    let advice = advice::on(measured)
        .into_iter()
        .map(|advice| json!({"item": advice.item, "verdict": advice.verdict.replace(' ', "_"), "text": advice.text}));
    json!({
        "jaka": env!("CARGO_PKG_VERSION"),
        "period_us": micros(ServoConfig::new().period()),
        "lateness": rows(measured).iter().map(way).collect::<Vec<_>>(),
        "round_trip": round_trip,
        "advice": advice.collect::<Vec<_>>(),
    })
}

fn way(row: &LatenessRow<'_>) -> Value {
    let period = ServoConfig::new().period();
    let mut way = row.times.map_or_else(|refusal| json!({"refused": refusal}), figures);
    if let Ok(times) = row.times {
        way["late_by_a_period"] = json!(times.at_least(period));
        way["late_by_three"] = json!(times.at_least(period * 3));
    }
    way["busy_wait_us"] = json!(micros(row.busy_wait));
    way["priority"] = json!(row.priority);
    way
}

fn figures(times: &Times) -> Value {
    let [p50, p90, p99, most] = [50, 90, 99, 100].map(|percent| micros(times.within(percent)));
    json!({"count": times.count(), "p50_us": p50, "p90_us": p90, "p99_us": p99, "max_us": most})
}
