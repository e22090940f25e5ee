//! The best hand-written code for each single job: no table, no generic step, no leniency, but every check that the job
//! needs.

pub mod encode;
pub mod forward;
pub mod framing;
pub mod joint_pos_reply;
pub mod one_field;
pub mod scan;
pub mod status;
