//! `jaka call`, as its users run it.

mod consent;
mod lines;
mod replies;
mod requests;
mod wait;
