//! Tests of motions that the controller plans: run, waited for, guarded and stopped.

mod arm_state;
mod guards;
mod io_waits;
mod json;
mod limits;
mod lost_seat;
mod mapped_status;
mod motion;
mod old_status;
mod races;
mod random_motions;
mod rest;
mod robot;
mod robot_faults;
mod stopped_steps;
