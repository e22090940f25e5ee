//! Tests of motions that the controller plans: run, waited for, guarded and stopped.

mod arm_state;
mod guards;
mod io_waits;
mod json;
mod limits;
mod lost_seat;
mod mapped_status;
mod motion;
mod not_sent;
mod old_status;
mod power_down;
mod races;
mod random_motions;
mod rest;
mod robot;
mod stopped_steps;
