//! `jaka call`, as its users run it.

#[path = "../common/mod.rs"]
mod common;
#[path = "../program/mod.rs"]
mod program;

mod consent;
mod document;
mod help;
mod packs;
mod replies;
mod requests;
