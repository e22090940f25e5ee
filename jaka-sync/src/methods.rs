//! Modules of the messages, and a method for each command, generated from the spec.

use crate::{Client, Error};

jaka_proto_derive::client_methods!();
