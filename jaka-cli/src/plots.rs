//! Pictures as SVG, black on white, for pages and print.
//!
//! The library escapes texts in them. They load no external resources.

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
