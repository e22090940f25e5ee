//! Messages compared with the spec, read as leniently as the generated code reads them.

use serde_json::{Map, Value};

use super::departure::{Departure, DepartureKind, Reading};
use super::notation::notation;
use super::problem::{element, member, shown};
use super::scalar::{self, Fit};
use super::slot::{Slot, variants};
use jaka_spec::{Choice, Field, Shape, Spec, Type};

/// The departures found so far.
pub(super) struct Decoder<'s> {
    pub(super) spec: &'s Spec,
    pub(super) departures: Vec<Departure>,
}

impl<'s> Decoder<'s> {
    pub(super) fn new(spec: &'s Spec) -> Self {
        Self { spec, departures: Vec::new() }
    }

    /// Reads the fields of an object. `envelope` are keys that are not fields.
    pub(super) fn object(&mut self, place: &str, fields: &[Field], found: &Map<String, Value>, envelope: &[&str]) {
        let known = |key: &str| envelope.contains(&key) || fields.iter().any(|field| field.wire == key);
        for (key, value) in found.iter().filter(|(key, _)| !known(key)) {
            self.add(&member(place, key), DepartureKind::Unknown, value, notation(value), Reading::Lenient);
        }
        for field in fields {
            self.field(&member(place, &field.wire), field, found.get(&field.wire));
        }
    }

    /// Reads the variant of an object that holds a choice.
    pub(super) fn object_choice(&mut self, choice: &Choice, found: &Map<String, Value>, envelope: &[&str]) {
        let tag = found.get(&choice.tag).unwrap_or(&Value::Null);
        let known = variants(&choice.variants);
        let wire = scalar::int(tag).map(|(wire, _)| wire);
        match choice.variants.iter().find(|variant| Some(variant.wire) == wire) {
            Some(variant) => self.object("", &variant.fields, found, &[envelope, &[&choice.tag]].concat()),
            None if tag.is_null() => self.add(&choice.tag, DepartureKind::Missing, tag, known, Reading::Unreadable),
            None => self.add(&choice.tag, DepartureKind::Unlisted, tag, known, Reading::Unreadable),
        }
    }

    fn field(&mut self, place: &str, field: &Field, found: Option<&Value>) {
        let slot = Slot::of(self.spec, place, field);
        let before = self.departures.len();
        match found.filter(|value| !value.is_null()) {
            Some(value) => self.value(&slot, value),
            None if field.optional => return,
            None => self.at(&slot, DepartureKind::Missing, &Value::Null, Reading::Unreadable),
        }
        if field.or_raw && found.is_some_and(|value| !value.is_null()) {
            // What does not fit is kept as raw JSON.
            self.departures[before..].iter_mut().for_each(|departure| departure.reading = Reading::Lenient);
        }
    }

    fn value(&mut self, slot: &Slot<'_>, value: &Value) {
        match self.parts(slot, value) {
            Fit::Plain => {}
            Fit::Lenient(kind) => self.at(slot, kind, value, Reading::Lenient),
            Fit::Unfit => self.at(slot, DepartureKind::Form, value, Reading::Unreadable),
        }
    }

    /// Reads what the value is made of, and says whether it fits as a whole.
    fn parts(&mut self, slot: &Slot<'_>, value: &Value) -> Fit {
        match slot.shape {
            Shape::Scalar(scalar) => return scalar::fit(scalar, &slot.limits, value),
            Shape::Python(inner) => {
                let Some(found) = value.as_str().and_then(scalar::literal) else { return Fit::Unfit };
                self.value(&slot.inner(slot.place, inner), &found);
            }
            Shape::List(element, len) => {
                let Some(found) = value.as_array() else { return Fit::Unfit };
                if len.is_some_and(|len| found.len() != len) {
                    self.at(slot, DepartureKind::Length, value, Reading::Unreadable);
                }
                self.list(slot, element, found);
            }
            Shape::Object(fields) => {
                let Some(found) = value.as_object() else { return Fit::Unfit };
                self.object(slot.place, fields, found, &[]);
            }
            Shape::Tuple { fields, exact } => {
                let Some(found) = value.as_array() else { return Fit::Unfit };
                self.length(slot, fields, (found, value), exact);
                self.elements(slot, fields, found);
            }
            Shape::IntEnum(values) => {
                let Some((wire, fit)) = scalar::int(value) else { return Fit::Unfit };
                let is_listed = values.iter().any(|listed| listed.wire == wire);
                return if is_listed { fit } else { Fit::Lenient(DepartureKind::Unlisted) };
            }
            Shape::TextEnum(values) => {
                let Some(text) = value.as_str() else { return Fit::Unfit };
                let is_listed = values.iter().any(|listed| listed.wire == text);
                return if is_listed { Fit::Plain } else { Fit::Lenient(DepartureKind::Unlisted) };
            }
            Shape::Choice(choice) => {
                let parts = value.as_array().and_then(|found| found.split_first());
                let Some((tag, rest)) = parts.and_then(|(tag, rest)| Some((scalar::int(tag)?.0, rest))) else {
                    return Fit::Unfit;
                };
                let Some(variant) = choice.variants.iter().find(|variant| variant.wire == tag) else {
                    return Fit::Lenient(DepartureKind::Unlisted);
                };
                self.length(slot, &variant.fields, (rest, value), false);
                self.elements(slot, &variant.fields, rest);
            }
        }
        Fit::Plain
    }

    /// Tells of elements beyond the fields; they are those of the whole value, perhaps without its tag.
    fn length(&mut self, slot: &Slot<'_>, fields: &[Field], (found, whole): (&[Value], &Value), exact: bool) {
        if found.len() > fields.len() {
            let reading = if exact { Reading::Unreadable } else { Reading::Lenient };
            self.at(slot, DepartureKind::Length, whole, reading);
        }
    }

    /// Reads the elements of a struct that is an array on the wire.
    fn elements(&mut self, slot: &Slot<'_>, fields: &[Field], found: &[Value]) {
        for (index, field) in fields.iter().enumerate() {
            self.field(&member(slot.place, &field.name), field, found.get(index));
        }
    }

    fn list(&mut self, slot: &Slot<'_>, ty: &Type, found: &[Value]) {
        let first = self.departures.len();
        for (index, value) in found.iter().enumerate() {
            let before = self.departures.len();
            let place = element(slot.place, index);
            self.value(&slot.inner(&place, ty), value);
            for departure in self.departures.split_off(before) {
                self.add_or_count(slot.place, first, departure);
            }
        }
    }

    /// Adds a departure of an element, or counts it where an element before differs in the same way.
    fn add_or_count(&mut self, array: &str, first: usize, new: Departure) {
        /// The path inside the element.
        fn inner<'f>(array: &str, field: &'f str) -> &'f str {
            field[array.len()..].split_once(']').map_or("", |(_, inner)| inner)
        }
        let same = |old: &&mut Departure| {
            (old.kind, old.reading) == (new.kind, new.reading) && inner(array, &old.field) == inner(array, &new.field)
        };
        match self.departures[first..].iter_mut().find(same) {
            Some(old) => old.more += new.more + 1,
            None => self.departures.push(new),
        }
    }

    fn at(&mut self, slot: &Slot<'_>, kind: DepartureKind, value: &Value, reading: Reading) {
        self.add(slot.place, kind, value, slot.words(), reading);
        if let Some(last) = self.departures.last_mut() {
            last.advisory = kind == DepartureKind::Range && slot.limits.advisory;
        }
    }

    pub(super) fn add(&mut self, place: &str, kind: DepartureKind, value: &Value, expected: String, reading: Reading) {
        let found = if kind == DepartureKind::Missing { String::new() } else { shown(value) };
        self.departures.push(Departure {
            field: place.to_owned(),
            kind,
            found,
            expected,
            reading,
            advisory: false,
            more: 0,
        });
    }
}
