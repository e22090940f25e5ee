//! Dashboard of `jaka monitor`: the screen depends on a [`View`] alone.

mod alarms;
mod draw;
mod feed;
mod io;
mod joints;
mod keys;
mod measurements;
mod overview;
mod robot_state;
mod style;
#[cfg(test)]
mod tests;
mod view;

pub(crate) use draw::draw;
pub(crate) use feed::Feed;
pub(crate) use view::View;
