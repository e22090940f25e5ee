//! `jaka call`, as its users run it.

mod beyond;
mod consent;
mod document;
mod help;
mod lines;
mod packs;
mod replies;
mod requests;
mod wait;
