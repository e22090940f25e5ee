//! Settings as last set, and the queries that return them by `remembers` of the spec or of a pack.

use std::borrow::Cow;

use jaka_dynamic::Translation;
use jaka_spec::{Command, Effect, Request};
use serde_json::{Map, Value};

use crate::State;
use crate::spec_index::SpecIndex;

/// Records the values of an accepted setting. `text` is its request, in terms of the built-in spec if that has the
/// command.
pub(super) fn note(spec_index: &SpecIndex, command: &Command, text: &str, state: &mut State) {
    let Some(known) = spec_index.spec_of(&command.wire).command(&command.wire) else { return };
    let (Effect::Setting, Request::Fields(fields)) = (known.effect, &known.request) else { return };
    let Ok(mut members) = serde_json::from_str::<Map<_, _>>(text) else { return };
    let values = fields.iter().filter_map(|field| Some((field.name.clone(), members.remove(&field.wire)?)));
    let given = values.filter(|(_, value)| !value.is_null());
    state.remembered.entry(known.wire.clone()).or_default().extend(given);
}

/// Returns the sample of a reply with the values of the setting that its query remembers.
pub(super) fn with<'s>(spec_index: &SpecIndex, query: &Command, sample: &'s str, state: &State) -> Cow<'s, str> {
    remembered(spec_index, query, sample, state).map_or(Cow::Borrowed(sample), Cow::Owned)
}

fn remembered(spec_index: &SpecIndex, query: &Command, sample: &str, state: &State) -> Option<String> {
    let setting = query.remembers.as_ref()?;
    let values = state.remembered.get(setting)?;
    let mut members = serde_json::from_str::<Map<_, _>>(sample).ok()?;
    let (from, to) = (spec_index.spec_of(setting), spec_index.spec_of(&query.wire));
    let (setting, query) = (from.command(setting)?, to.command(&query.wire)?);
    let translation = Translation::new(from, to);
    members.extend(to.reply_fields(query).iter().filter_map(|field| {
        let set = setting.request.fields().find(|set| set.name == field.name)?;
        Some((field.wire.clone(), translation.field(set, field, values.get(&set.name)?)?))
    }));
    Some(Value::from(members).to_string())
}
