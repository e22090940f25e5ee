//! Sources of what a robot needs of status packets.

use crate::model::{Field, Spec};
use crate::needed::{NEEDED_FIELDS, NeededField, StatusLine};

/// Source of a field of the built-in status packet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FieldSource<'s> {
    /// Field of the status packet whose values mean the same.
    Field(&'s Field),
    /// None: the packets of this controller never have it.
    Absent,
    /// The program, which reads it of what packets have otherwise.
    Program,
}

/// Source of a field that a robot needs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NeededSource<'s> {
    /// The field, as built in.
    pub needed: &'static NeededField,
    /// Its source.
    pub source: FieldSource<'s>,
    /// True if a pack names the source, or gives the field another key or form: a packet without it does not fit the
    /// pack.
    pub is_changed: bool,
}

impl Spec {
    /// Sources of what a robot needs of status packets, in the order of [`NEEDED_FIELDS`]; none where the spec has no
    /// status packet.
    pub fn robot_status(&self) -> impl Iterator<Item = NeededSource<'_>> {
        NEEDED_FIELDS.iter().filter_map(|needed| {
            let known = self.as_built_in().status_fields().iter().find(|known| known.name == needed.name)?;
            let is_changed = |field: &Field| {
                field.wire != known.wire || field.ty != known.ty || self.has_forms(std::slice::from_ref(field))
            };
            let source = self.status_source(known)?;
            let is_changed = self.status_lines.contains_key(needed.name)
                || matches!(source, FieldSource::Field(field) if is_changed(field));
            Some(NeededSource { needed, source, is_changed })
        })
    }

    /// Field of the status packet whose values mean what those of a field of the built-in one mean.
    pub fn status_field_as(&self, built_in: &Field) -> Option<&Field> {
        match self.status_source(built_in)? {
            FieldSource::Field(field) => Some(field),
            FieldSource::Absent | FieldSource::Program => None,
        }
    }

    /// The spec, or that to which packs have been added.
    pub(crate) fn as_built_in(&self) -> &Self {
        self.built_in.as_deref().unwrap_or(self)
    }

    /// Source of a field of the built-in status packet; none if packs change it and say nothing of that.
    pub(crate) fn status_source(&self, built_in: &Field) -> Option<FieldSource<'_>> {
        let name = match self.status_lines.get(built_in.name.as_str()) {
            Some(StatusLine::Absent) => return Some(FieldSource::Absent),
            Some(StatusLine::Program) => return Some(FieldSource::Program),
            Some(StatusLine::Field(name)) => name,
            None => &built_in.name,
        };
        let field = self.status_fields().iter().find(|field| field.name == *name);
        field.filter(|field| self.means_as_built_in(field, built_in)).map(FieldSource::Field)
    }

    /// True if the values of a field mean what those of the built-in field mean, however truth values are written:
    /// type, unit, and all that the type is made of.
    fn means_as_built_in(&self, field: &Field, built_in: &Field) -> bool {
        field.ty.is_alike(&built_in.ty)
            && (field.or_raw, &field.unit) == (built_in.or_raw, &built_in.unit)
            && self.defines_as(self.as_built_in(), &field.ty)
    }
}
