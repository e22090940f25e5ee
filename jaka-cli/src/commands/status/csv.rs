//! Packets as CSV.

use std::iter::once;

use super::packets::Packet;
use crate::csv::{cell, row};
use crate::fields::Field;

/// The columns: those of the first packet, since there is only one header.
#[derive(Debug)]
pub(super) enum Columns {
    /// The fields that are asked for.
    Wanted(Vec<Field>),
    /// Each of them, divided into its parts.
    Found(Vec<Field>),
}

impl Columns {
    pub(super) fn new(fields: Vec<Field>) -> Self {
        Self::Wanted(fields)
    }

    /// A packet's line, with the header before the first. A cell is empty where the packet says nothing.
    pub(super) fn lines(&mut self, packet: &Packet) -> String {
        let mut text = String::new();
        if let Self::Wanted(fields) = self {
            let columns: Vec<_> = fields.drain(..).flat_map(|field| field.leaves(&packet.json)).collect();
            text = row(once("time_s".to_owned()).chain(columns.iter().map(|column| column.name.clone())));
            *self = Self::Found(columns);
        }
        let (Self::Wanted(columns) | Self::Found(columns)) = self;
        let cells = columns.iter().map(|column| cell(column.named_value(&packet.json)));
        text + &row(once(format!("{:.3}", packet.time)).chain(cells))
    }
}
