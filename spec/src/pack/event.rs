//! What a pack says about the controller's events.

use super::{COVERED, Draft};
use crate::item::Item;
use crate::model::Event;
use crate::read;
use crate::words::{self, event_code};

impl<'s> Draft<'s, '_> {
    /// The event without the codes of which the spec says as much. Codes of which it says less, the spec then leaves to the pack.
    pub(super) fn new_event(&mut self, item: &Item<'_, 's>) -> Option<Event> {
        let mut event = read::event(item, &mut self.index);
        for code in event.codes() {
            if let Some(known) = self.spec.event(code).filter(|known| known.severity != event.severity) {
                let (code, severity) = (event_code(code), words::severity(known.severity));
                item.error(item.at, &format!("the spec has the code {code} already, with the severity `{severity}`"));
            }
        }
        self.events.push(event.clone());
        let adds = event.meaning.is_some();
        let says_as_much = |known: &Event| known.meaning.is_some() || !adds;
        let spec = &self.spec;
        event.retain(|code| !spec.event(code).is_some_and(says_as_much));
        if event.codes.is_empty() {
            self.note(item, COVERED);
            return None;
        }
        for topic in &mut self.spec.topics {
            topic.events.iter_mut().for_each(|known| known.retain(|code| !event.has(code)));
            topic.events.retain(|known| !known.codes.is_empty());
        }
        Some(event)
    }
}
