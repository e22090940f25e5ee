//! Settings that queries return, by `remembers` of the spec or of a pack.

use std::borrow::Cow;

use jaka_dynamic::Translation;
use jaka_spec::Field;
use serde_json::{Map, Value};

use crate::State;
use crate::spec_index::SpecIndex;

/// Records the values of an accepted setting for its query. `text` is its request, in terms of the built-in spec if
/// that has the command.
pub(super) fn note(spec_index: &SpecIndex, command: &str, text: &str, state: &mut State) {
    let from = spec_index.spec_of(command);
    let Some(setting) = from.command(command) else { return };
    let queries = spec_index.spec.commands().filter(|query| query.remembers.as_deref() == Some(command));
    for query in queries {
        let Ok(members) = serde_json::from_str::<Map<_, _>>(text) else { return };
        let to = spec_index.spec_of(&query.wire);
        let Some(fields) = to.command(&query.wire).map(|query| to.reply_fields(query)) else { continue };
        let translation = Translation::new(from, to);
        let value = |set: &Field| {
            let field = fields.iter().find(|field| field.name == set.name)?;
            let value = members.get(&set.wire).filter(|value| !value.is_null())?;
            Some((field.name.clone(), translation.field(set, field, value)?))
        };
        let fields: Vec<_> = setting.request.fields().filter_map(value).collect();
        state.remembered.entry(query.wire.clone()).or_default().extend(fields);
    }
}

/// Returns the sample of a reply with the remembered values of its query.
pub(super) fn with<'s>(spec_index: &SpecIndex, command: &str, sample: &'s str, state: &State) -> Cow<'s, str> {
    let Some(remembered) = state.remembered.get(command) else { return Cow::Borrowed(sample) };
    let Ok(mut members) = serde_json::from_str::<Map<_, _>>(sample) else { return Cow::Borrowed(sample) };
    let spec = spec_index.spec_of(command);
    let fields = spec.command(command).map_or(&[][..], |query| spec.reply_fields(query));
    let member = |field: &Field| Some((field.wire.clone(), remembered.get(&field.name)?.clone()));
    members.extend(fields.iter().filter_map(member));
    Cow::Owned(Value::from(members).to_string())
}
