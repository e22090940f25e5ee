//! All tests of the program, which is run as its users run it.

mod any_language;
mod call;
mod check;
mod common;
mod completions;
mod console;
mod export;
mod first_robot;
mod follow;
mod guide;
mod held_packets;
mod hostile_text;
mod jitter;
mod manual;
mod others;
mod pages;
mod probe;
mod program;
mod record;
mod replay;
mod report;
mod script;
mod spec;
mod status;
mod target;
mod verbs;
