//! Pictures as SVG, black on white, for pages and print.
//!
//! Texts in them are escaped by the library. Nothing in them is fetched from anywhere.

mod calls;
mod canvas;
pub(crate) mod chart;
mod histogram;
mod series;
mod strips;
mod way;

pub(crate) use self::calls::{Latency, calls};
pub(crate) use self::histogram::histogram;
pub(crate) use self::series::Series;
pub(crate) use self::strips::{Strip, Trace, strips};
pub(crate) use self::way::{ViewAxes, draw_way, way};
