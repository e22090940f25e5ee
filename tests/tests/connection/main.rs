//! Tests of clients, status packets and recordings, over connections to a simulated controller.

mod advisory;
mod corpora;
mod effects;
mod exchange;
mod exchange_stress;
mod faults;
mod firmware;
mod first_program;
mod foreign_clients;
mod held_back;
mod hostile_text;
mod mistakes;
mod monitor;
mod nameless;
mod odd_replies;
mod odd_status;
mod packet_types;
mod packs;
mod pipeline;
mod preflight;
mod recording;
mod reference_pages;
mod replay;
mod safety;
mod status;
mod strange;
