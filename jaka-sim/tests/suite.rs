//! All tests through sockets that need no process of their own.

mod commands;
mod common;
mod contact;
mod fault_plans;
mod faults;
mod firmware;
mod habits;
mod happenings;
mod late_replies;
mod lifecycle;
mod link_faults;
mod lost_connections;
mod real_packets;
mod replies;
mod sequels;
mod servo_arm;
mod servo_filters;
mod status;
mod status_faults;
mod stops;
mod stream;
mod time_scale;
mod triggers;
