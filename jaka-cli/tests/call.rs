//! `jaka call`, as its users run it.

mod consent;
mod help;
mod lines;
mod packs;
mod replies;
mod requests;
mod wait;
