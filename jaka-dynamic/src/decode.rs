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
            None => self.unfit(&slot, DepartureKind::Missing, &Value::Null),
        }
        if field.or_raw && found.is_some_and(|value| !value.is_null()) {
            // What does not fit is kept as raw JSON.
            self.departures[before..].iter_mut().for_each(|departure| departure.reading = Reading::Lenient);
        }
    }

    fn value(&mut self, slot: &Slot<'_>, value: &Value) {
        match slot.shape {
            Shape::Scalar(scalar) => self.fit(slot, value, scalar::fit(scalar, &slot.limits, value)),
            Shape::Python(inner) => match value.as_str().and_then(scalar::literal) {
                Some(found) => self.value(&slot.inner(slot.place, inner), &found),
                None => self.unfit(slot, DepartureKind::Form, value),
            },
            Shape::List(element, len) => self.list(slot, element, value, len),
            Shape::Object(fields) => match value.as_object() {
                Some(found) => self.object(slot.place, fields, found, &[]),
                None => self.unfit(slot, DepartureKind::Form, value),
            },
            Shape::Tuple { fields, exact } => match value.as_array() {
                Some(found) => {
                    self.length(slot, fields, (found, value), exact);
                    self.elements(slot, fields, found);
                }
                None => self.unfit(slot, DepartureKind::Form, value),
            },
            Shape::IntEnum(values) => match scalar::int(value) {
                Some((wire, _)) if values.iter().all(|listed| listed.wire != wire) => {
                    self.lenient(slot, DepartureKind::Unlisted, value);
                }
                found => self.fit(slot, value, found.map_or(Fit::Unfit, |(_, fit)| fit)),
            },
            Shape::TextEnum(values) => match value.as_str() {
                Some(text) if values.iter().any(|listed| listed.wire == text) => {}
                Some(_) => self.lenient(slot, DepartureKind::Unlisted, value),
                None => self.unfit(slot, DepartureKind::Form, value),
            },
            Shape::Choice(choice) => self.array_choice(slot, choice, value),
        }
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

    fn array_choice(&mut self, slot: &Slot<'_>, choice: &Choice, value: &Value) {
        let parts = value.as_array().and_then(|found| found.split_first());
        let Some(((tag, _), rest)) = parts.and_then(|(tag, rest)| Some((scalar::int(tag)?, rest))) else {
            return self.unfit(slot, DepartureKind::Form, value);
        };
        match choice.variants.iter().find(|variant| variant.wire == tag) {
            Some(variant) => {
                self.length(slot, &variant.fields, (rest, value), false);
                self.elements(slot, &variant.fields, rest);
            }
            None => self.lenient(slot, DepartureKind::Unlisted, value),
        }
    }

    fn list(&mut self, slot: &Slot<'_>, ty: &Type, value: &Value, len: Option<usize>) {
        let Some(found) = value.as_array() else { return self.unfit(slot, DepartureKind::Form, value) };
        if len.is_some_and(|len| found.len() != len) {
            self.unfit(slot, DepartureKind::Length, value);
        }
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

    fn fit(&mut self, slot: &Slot<'_>, value: &Value, fit: Fit) {
        match fit {
            Fit::Plain => {}
            Fit::Lenient(kind) => self.lenient(slot, kind, value),
            Fit::Unfit => self.unfit(slot, DepartureKind::Form, value),
        }
    }

    fn lenient(&mut self, slot: &Slot<'_>, kind: DepartureKind, value: &Value) {
        self.at(slot, kind, value, Reading::Lenient);
    }

    fn unfit(&mut self, slot: &Slot<'_>, kind: DepartureKind, value: &Value) {
        self.at(slot, kind, value, Reading::Unreadable);
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
