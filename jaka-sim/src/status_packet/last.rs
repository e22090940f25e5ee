//! The packet before.

use std::sync::Mutex;

use serde_json::{Map, Value};

use crate::State;
use crate::lock::lock;

/// The last packet, with what it shows: the next one is the same while nothing changes, and most of the work of a controller is to make packets.
#[derive(Debug, Default)]
pub(crate) struct LastPacket(Mutex<Option<Made>>);

#[derive(Debug)]
struct Made {
    state: State,
    set: Map<String, Value>,
    text: String,
}

impl LastPacket {
    /// The packet that shows a state and the values that a user has set; `make` makes it where it is another than the last.
    pub(crate) fn of(
        &self,
        state: &State,
        set: Map<String, Value>,
        make: impl FnOnce(&Map<String, Value>) -> String,
    ) -> String {
        let mut last = lock(&self.0);
        if let Some(made) = last.as_ref().filter(|made| made.state == *state && made.set == set) {
            return made.text.clone();
        }
        let text = make(&set);
        *last = Some(Made { state: state.clone(), set, text: text.clone() });
        text
    }
}
