//! Shared code of the benchmarks.

#[path = "../../jaka-cli/src/plots/chart.rs"]
mod chart;
pub mod encode;
pub mod framing;
pub mod measure;
pub mod peers;
pub mod planning;
pub mod reply;
pub mod status;
pub mod stream_picture;
pub mod system;

/// A status packet of 3.5 KB with the keys of the document's sample, in its order, and its lengths of arrays.
pub const PACKET_OF_DOCUMENT: &str = include_str!("../data/status-document.json");

/// A status packet of 9 KB with all keys of the spec and the style of firmware 1.5.14, a blank after each comma and
/// colon.
pub const PACKET_OF_NEWER: &str = include_str!("../data/status-newer.json");

/// All works whose instructions are counted.
pub fn works() -> Vec<measure::Work<'static>> {
    [encode::works(), reply::works(), status::works(), framing::works(), planning::works()]
        .into_iter()
        .flatten()
        .collect()
}
