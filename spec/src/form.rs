//! Forms of fields and types by firmware.

use std::collections::BTreeMap;

use crate::model::{Command, Field, Form, FormKind, Spec, Type, TypeDef, TypeId, TypeKind};
use crate::range::Range;
use crate::scalar::Scalar;
use crate::unit::Factors;
use crate::version::Versions;

impl Field {
    /// True if the version alone tells two forms apart: a number in another unit under the same key, or a word that
    /// means false in one form and true in the other.
    pub fn has_forms_alike(&self) -> bool {
        self.keys().any(|key| self.are_alike_under(key))
    }

    /// True if the version alone tells two forms under a key apart.
    pub fn are_alike_under(&self, key: &str) -> bool {
        let forms: Vec<_> = self.forms_under(key).collect();
        let are_alike = |form: &Form, other: &Form| form.unit != other.unit || contradict(&form.ty, &other.ty);
        forms.iter().enumerate().any(|(at, form)| forms[at + 1..].iter().any(|other| are_alike(form, other)))
    }

    /// Keys of the field in any firmware, its own first, each once.
    pub fn keys(&self) -> impl Iterator<Item = &str> {
        let others = self.forms.iter().enumerate().filter(|(at, form)| {
            form.wire != self.wire && self.forms[..*at].iter().all(|before| before.wire != form.wire)
        });
        std::iter::once(&*self.wire).chain(others.map(|(_, form)| &*form.wire))
    }

    /// Forms of the field under a key, its own first if it has that key.
    pub fn forms_under(&self, key: &str) -> impl Iterator<Item = Form> {
        let own = self.own_form();
        std::iter::once(own).chain(self.forms.iter().cloned()).filter(move |form| form.wire == key)
    }

    /// Form of the field in all firmware that none of its other forms is for.
    pub fn own_form(&self) -> Form {
        let Self { wire, ty, unit, .. } = self;
        let (wire, ty, unit) = (wire.clone(), ty.clone(), unit.clone());
        Form { versions: Versions::default(), wire, ty, unit, factors: Factors::ONE }
    }
}

/// True if a value may mean one thing as this type, and another as that.
#[expect(clippy::match_same_arms, reason = "a text may be a literal, and is one of a list")]
fn contradict(ty: &Type, other: &Type) -> bool {
    match (ty, other) {
        (Type::Python(inner), Type::Python(other)) => contradict(inner, other),
        // A literal of an array or an object is a string, which these are not.
        (Type::Python(inner), _) | (_, Type::Python(inner)) => matches!(**inner, Type::Scalar(_)),
        (Type::List(element), Type::List(other)) => contradict(element, other),
        (Type::Array(element, _), Type::Array(other, _)) => contradict(element, other),
        (Type::Scalar(Scalar::Bool { off, on }), Type::Scalar(Scalar::Bool { off: other_off, on: other_on })) => {
            let words = [off, on, other_off, other_on].map(|word| word.trim_matches('"'));
            words.iter().any(|word| {
                let [ours, theirs] = [[off, on], [other_off, other_on]].map(|[off, on]| truth(word, off, on));
                ours.is_some_and(|ours| theirs.is_some_and(|theirs| ours != theirs))
            })
        }
        _ => false,
    }
}

/// Meaning of a word as a truth value with these two forms, or in one of the usual ones.
fn truth(word: &str, off: &str, on: &str) -> Option<bool> {
    let is = |forms: &[&str]| forms.iter().any(|form| form.trim_matches('"').eq_ignore_ascii_case(word));
    match word {
        _ if is(&[off]) => Some(false),
        _ if is(&[on]) => Some(true),
        _ if is(&["false", "0"]) => Some(false),
        _ if is(&["true", "1"]) => Some(true),
        _ => None,
    }
}

impl TypeDef {
    /// True if the version alone tells two forms apart: numbers in another unit.
    pub fn has_forms_alike(&self) -> bool {
        self.forms.iter().any(|form| match form.kind {
            FormKind::Unit { .. } => true,
            FormKind::Object(_) | FormKind::Array => false,
        })
    }
}

impl Spec {
    /// True if a command can be sent only once the firmware is known: its request has forms, or its reply has forms
    /// that are told apart by the version alone.
    pub fn needs_firmware(&self, command: &Command) -> bool {
        let sent = |field: &Field| !field.forms.is_empty();
        let sent_type = |def: &TypeDef| !def.forms.is_empty();
        command.request.fields().any(|field| self.any(field, &sent, &sent_type))
            || self.reply_fields(command).iter().any(|field| self.is_told_by_version(field))
    }

    /// True if a field, or anything inside it, has forms that the version alone tells apart.
    pub fn is_told_by_version(&self, field: &Field) -> bool {
        self.any(field, &Field::has_forms_alike, &TypeDef::has_forms_alike)
    }

    /// True if any field or type has forms.
    pub fn varies_by_firmware(&self) -> bool {
        self.commands().flat_map(Command::fields).any(|field| !field.forms.is_empty())
            || self
                .types()
                .any(|(_, def)| !def.forms.is_empty() || def.kind.fields().any(|field| !field.forms.is_empty()))
    }

    /// True if a field of a message, or anything inside it, has forms.
    pub fn has_forms(&self, fields: &[Field]) -> bool {
        fields.iter().any(|field| self.any(field, &|field| !field.forms.is_empty(), &|def| !def.forms.is_empty()))
    }

    /// True if either holds of a field, or of anything inside it.
    fn any(&self, field: &Field, of_field: &dyn Fn(&Field) -> bool, of_type: &dyn Fn(&TypeDef) -> bool) -> bool {
        of_field(field) || field.ty.named().is_some_and(|id| self.any_in_type(id, of_field, of_type))
    }

    fn any_in_type(&self, id: TypeId, of_field: &dyn Fn(&Field) -> bool, of_type: &dyn Fn(&TypeDef) -> bool) -> bool {
        let def = &self[id];
        of_type(def)
            || def.kind.fields().any(of_field)
            || def.kind.parts().any(|part| self.any_in_type(part, of_field, of_type))
    }

    /// The spec as a firmware has it: each field and each type in the form of its version, and in no other; `is_among`
    /// says of which versions the firmware's is one. Ranges are left out, since they are in the units of the spec's own
    /// forms.
    #[must_use]
    pub fn of_firmware(&self, is_among: impl Fn(&Versions) -> bool) -> Self {
        let mut spec = self.clone();
        for topic in &mut spec.topics {
            for command in &mut topic.commands {
                command.request.fields_mut().for_each(|field| settle(field, &is_among));
                command.reply.own_fields_mut().iter_mut().for_each(|field| settle(field, &is_among));
            }
        }
        for def in &mut spec.types {
            def.kind.fields_mut().for_each(|field| settle(field, &is_among));
            settle_type(def, &is_among);
        }
        spec
    }
}

/// Gives a field the form of a firmware.
fn settle(field: &mut Field, is_among: &impl Fn(&Versions) -> bool) {
    (field.range, field.advised) = (Range::default(), Vec::new());
    let forms = std::mem::take(&mut field.forms);
    let Some(form) = forms.into_iter().find(|form| is_among(&form.versions)) else { return };
    (field.wire, field.ty, field.unit) = (form.wire, form.ty, form.unit);
}

fn settle_type(def: &mut TypeDef, is_among: &impl Fn(&Versions) -> bool) {
    let forms = std::mem::take(&mut def.forms);
    let Some(form) = forms.into_iter().find(|form| is_among(&form.versions)) else { return };
    let mut fields: Vec<_> = def.kind.fields().cloned().collect();
    def.kind = match (form.kind, &def.kind) {
        (FormKind::Object(keys), _) => {
            fields.iter_mut().zip(keys).for_each(|(field, key)| field.wire = key);
            TypeKind::Object(fields)
        }
        (FormKind::Array, _) => {
            for field in &mut fields {
                field.wire.clear();
            }
            TypeKind::Array { fields, exact: false }
        }
        (FormKind::Unit { unit, .. }, TypeKind::Wrapper(ty, _)) => TypeKind::Wrapper(ty.clone(), Some(unit)),
        (FormKind::Unit { .. }, other) => other.clone(),
    };
}

/// Problem of a type's forms, once all of its fields are known.
pub(crate) fn problem(def: &TypeDef) -> Option<&'static str> {
    match &def.kind {
        TypeKind::Array { fields, .. } => array_problem(def, fields),
        TypeKind::Object(fields) if !def.forms.is_empty() => object_problem(fields),
        _ => None,
    }
}

/// Problem of an array that is an object in some firmware.
fn array_problem(def: &TypeDef, fields: &[Field]) -> Option<&'static str> {
    let keys = def.forms.iter().filter_map(|form| match &form.kind {
        FormKind::Object(keys) => Some(keys),
        FormKind::Array | FormKind::Unit { .. } => None,
    });
    let keys: Vec<_> = keys.collect();
    let mut places = BTreeMap::new();
    for (at, key) in keys.iter().flat_map(|keys| keys.iter().enumerate()) {
        if *places.entry(key).or_insert(at) != at {
            return Some("a key of its forms is that of one element in one form, and of another in another");
        }
    }
    if keys.iter().any(|keys| keys.len() != fields.len()) {
        return Some("its form as an object has a key for each element");
    }
    let differ = keys.windows(2).any(|pair| pair[0] != pair[1]);
    let have_forms = fields.iter().any(|field| !field.forms.is_empty());
    (differ && have_forms).then_some("elements with forms have one key in all forms of their type")
}

/// Problem of an object that is an array in some firmware.
fn object_problem(fields: &[Field]) -> Option<&'static str> {
    if fields.iter().any(|field| field.ty.needs_key() || !field.forms.is_empty()) {
        return Some("the fields of an object that is an array in some firmware are read without their keys");
    }
    let is_in_order = fields.windows(2).all(|pair| !pair[0].optional || pair[1].optional);
    (!is_in_order)
        .then_some("a field after an optional one is optional too, since the object is an array in some firmware")
}

/// True for versions that have something in common.
pub(crate) fn overlap(some: &Versions, others: &Versions) -> bool {
    let is_void = |since: &Versions, until: &Versions| {
        Versions { since: since.since.clone(), until: until.until.clone() }.is_void()
    };
    !is_void(some, others) && !is_void(others, some)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::version::Version;

    #[test]
    fn ranges_of_versions_overlap_where_a_version_has_both() {
        let range = |since: &str, until: &str| Versions { since: Version::read(since), until: Version::read(until) };
        assert!(overlap(&range("1.5", "1.6"), &range("1.6.5", "")));
        assert!(overlap(&range("", ""), &range("1.6", "")));
        assert!(!overlap(&range("", "1.6"), &range("1.7", "")));
    }
}
