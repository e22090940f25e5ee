//! Pictures of a page, each with its text.

use std::collections::BTreeMap;

use itertools::Itertools as _;
use jaka_sync::proto::text::visible;

use super::more;
use super::page::{escaped, figure, paragraph};
use super::session::{HappeningKind, Packed, Packets, Session, SetPointLateness};
use crate::failure::Failure;
use crate::packets::fields;
use crate::plots::{Series, Strip, Trace, ViewAxes, calls, histogram, strips, way};
use crate::text::number::count;

/// Greatest numbers of strips of digital and of analog inputs and outputs.
const MOST_DIGITAL: usize = 24;
const MOST_ANALOG: usize = 8;
/// Greatest number of strips of the fields of packs.
const MOST_PACKED: usize = 24;
/// Greatest number of points of a path. Of a longer path, only every second, third, or later point is drawn.
const MOST_POINTS: usize = 8000;

/// Input or output: the name of its list, and its index.
type Key = (&'static str, usize);

/// Text of a part of the page, and its pictures.
type Content = (String, Vec<String>);

/// Returns all sections with pictures: each with its name in links, its title, and its HTML.
pub(super) fn sections(session: &Session<'_>) -> Result<Vec<(&'static str, &'static str, String)>, Failure> {
    let packets = &session.packets;
    let timed = |text: String, pictures: Vec<Strip>| -> Result<Content, Failure> {
        if pictures.is_empty() {
            return Ok((text, Vec::new()));
        }
        Ok((format!("{text} Time in s since the recording began."), vec![strips(session.end, &pictures)?]))
    };
    let known = |text: &str, strips: Vec<Strip>| {
        let text = if strips.is_empty() { none(packets) } else { text.to_owned() };
        timed(text, strips)
    };
    let (io, io_text) = inputs_and_outputs(packets);
    let mut sections = vec![
        ("joints", "Joints", known("Actual positions, by status packets.", joints(packets))?),
        ("speeds", "Speeds", known(SPEEDS, speeds(packets))?),
        ("path", "Path of the tool centre point", path(packets)?),
        ("state", "State", known("By status packets; high is true.", state(packets))?),
        ("io", "Inputs and outputs", timed(io_text, io)?),
        ("calls", "Calls", requests(session)?),
        ("events", "Events", timed("The events in the list at the end of this page.".to_owned(), events(session))?),
        ("lateness", "Lateness of set-points", lateness(&session.lateness)?),
    ];
    if !packets.packed.is_empty() {
        let (text, strips) = packed(packets);
        sections.insert(5, ("packs", "Status fields of packs", timed(text, strips)?));
    }
    let html = |(id, title, (text, pictures)): (_, _, Content)| (id, title, paragraph(&text) + &figure(&pictures));
    Ok(sections.into_iter().map(html).collect())
}

const SPEEDS: &str = "Of the joints: means over 0.1 s or more, from the positions and the times at which packets arrived, so that shorter peaks are not shown. \
                      Of the tool centre point: by status packets.";

fn none(packets: &Packets) -> String {
    if packets.count == 0 { "The recording has no status packets." } else { "No status packet has these fields." }
        .to_owned()
}

fn curve(title: String, series: &Series) -> Option<Strip> {
    series.range().map(|_| Strip { title, trace: Trace::Curve(series.clone()) })
}

fn joints(packets: &Packets) -> Vec<Strip> {
    let joints = packets.joints.iter().enumerate();
    joints.filter_map(|(at, series)| curve(format!("joint {} (deg)", at + 1), series)).collect()
}

fn speeds(packets: &Packets) -> Vec<Strip> {
    let joints = packets.speeds.series.iter().enumerate();
    let joints = joints.filter_map(|(at, series)| curve(format!("joint {} (deg/s)", at + 1), series));
    joints.chain(curve("tool centre (mm/s)".to_owned(), &packets.tcp_speed)).collect()
}

fn state(packets: &Packets) -> Vec<Strip> {
    let known = packets.state.iter().filter(|(_, series)| series.range().is_some());
    known.map(|(name, series)| Strip { title: (*name).to_owned(), trace: Trace::Level(series.clone()) }).collect()
}

/// Returns strips of the inputs and outputs that change, and a text on the others.
fn inputs_and_outputs(packets: &Packets) -> (Vec<Strip>, String) {
    let title = |(name, at): &Key| format!("{name}[{at}]");
    let (digital, analog) = (changing(&packets.digital), changing(&packets.analog));
    let levels = digital.iter().take(MOST_DIGITAL);
    let levels = levels.map(|(key, series)| Strip { title: title(key), trace: Trace::Level((*series).clone()) });
    let steps = analog.iter().take(MOST_ANALOG);
    let steps = steps.map(|(key, series)| Strip { title: title(key), trace: Trace::Steps((*series).clone()) });
    let strips: Vec<_> = levels.chain(steps).collect();
    if packets.digital.is_empty() && packets.analog.is_empty() {
        return (strips, none(packets));
    }
    let on = packets.digital.iter().filter(|(_, series)| series.range() == Some((1.0, 1.0)));
    let on = on.map(|(key, _)| title(key)).join(", ");
    let mut text = vec!["The signals that change; high is true.".to_owned()];
    text.push(if on.is_empty() { "None is on throughout.".to_owned() } else { format!("On throughout: {on}.") });
    text.extend(more(digital.len(), MOST_DIGITAL, "digital one"));
    text.extend(more(analog.len(), MOST_ANALOG, "analog one"));
    if strips.is_empty() {
        text[0] = String::from("None changes.");
    }
    (strips, text.join(" "))
}

/// Returns a text on the fields of packs, with the number of those not drawn, and strips of their numbers and truth
/// values.
fn packed(packets: &Packets) -> (String, Vec<Strip>) {
    let known: Vec<_> = packets.packed.iter().filter(|(_, packed)| packed.series.range().is_some()).collect();
    let strip = |(name, packed): &(&String, &Packed)| {
        let unit = packed.field.unit().map(|unit| format!(" ({unit})"));
        let trace = match packed.field.kind() {
            fields::Kind::Truth => Trace::Level,
            fields::Kind::Number | fields::Kind::Other => Trace::Steps,
        };
        Strip {
            title: visible(&format!("{name}{}", unit.unwrap_or_default())).into_owned(),
            trace: trace(packed.series.clone()),
        }
    };
    let text = "Numbers and truth values; high is true. Changes of others are in the list of events.".to_owned();
    let more = more(known.len(), MOST_PACKED, "one").map(|more| format!(" {more}"));
    (text + &more.unwrap_or_default(), known.iter().take(MOST_PACKED).map(strip).collect())
}

fn changing(all: &BTreeMap<Key, Series>) -> Vec<(&Key, &Series)> {
    all.iter().filter(|(_, series)| series.changes()).collect()
}

/// Returns the path of the tool centre point from two sides.
fn path(packets: &Packets) -> Result<Content, Failure> {
    let points: usize = packets.tcp.iter().map(Vec::len).sum();
    if points == 0 {
        return Ok((none(packets), Vec::new()));
    }
    let step = points.div_ceil(MOST_POINTS);
    let seen = |right: usize, up: usize| -> Vec<Vec<(f64, f64)>> {
        let curves = packets.tcp.iter().filter(|curve| !curve.is_empty());
        curves.map(|curve| curve.iter().step_by(step).map(|point| (point[right], point[up])).collect()).collect()
    };
    let above = way(ViewAxes { right: "x (mm)", up: "y (mm)" }, &seen(0, 1))?;
    let side = way(ViewAxes { right: "x (mm)", up: "z (mm)" }, &seen(0, 2))?;
    let thinned = if step > 1 { format!(" One of {step} packets is drawn.") } else { String::new() };
    let text = "From above (x to the right, y upwards) and from the side (x to the right, z upwards), in the user frame that is selected. \
                    A circle is at the beginning, a square at the end."
        .to_owned()
        + &thinned;
    Ok((text, vec![above, side]))
}

fn requests(session: &Session<'_>) -> Result<Content, Failure> {
    let requests = &session.calls.latencies;
    if requests.is_empty() {
        return Ok(("The recording has no requests.".to_owned(), Vec::new()));
    }
    let text = "Time until the reply, at the time of the request. A dot: accepted; a triangle: refused; a cross at the top: no reply is recorded. \
                Of requests at almost the same time the slowest is drawn. Time in s since the recording began."
        .to_owned();
    Ok((text, vec![calls(session.end, requests)?]))
}

fn events(session: &Session<'_>) -> Vec<Strip> {
    let of_kind = |kind: HappeningKind| session.happenings.iter().filter(move |happening| happening.kind == kind);
    let strips = HappeningKind::ALL.into_iter().filter_map(|(kind, title)| {
        let times: Vec<_> = of_kind(kind).map(|happening| happening.time.as_secs_f64()).collect();
        (!times.is_empty()).then(|| Strip { title: title.to_owned(), trace: Trace::Marks(times) })
    });
    strips.collect()
}

fn lateness(lateness: &SetPointLateness) -> Result<Content, Failure> {
    let Some([median, p99, latest]) = lateness.figures() else {
        return Ok(("The recording has no set-points that follow each other.".to_owned(), Vec::new()));
    };
    let text = format!(
        "Excess in ms of the time between two set-points (servo_j, servo_p) over the period of the first, as the program sent them: {}; median {median:.3}, \
         99th percentile {p99:.3}, latest {latest:.3}; late by 8 or more: {}, by 24 or more: {}. Heights are logarithmic.",
        count(lateness.count(), "interval"),
        lateness.late_by(8.0),
        lateness.late_by(24.0),
    );
    Ok((escaped(&text), vec![histogram(&lateness.bars())?]))
}
