//! The checks that need all files: references between them, and names that may stand only once.

use std::collections::{BTreeMap, BTreeSet};

use crate::item::{Item, Placed};
use crate::model::{Spec, Type, TypeKind};
use crate::names::to_camel;
use crate::read::Unique;
use crate::report::{At, Report};

/// What the files define and use, gathered while they are read.
#[derive(Debug, Default)]
pub(crate) struct Index<'s> {
    commands: Unique<'s, String>,
    sections: Unique<'s, String>,
    methods: Unique<'s, String>,
    type_names: Unique<'s, String>,
    error_wires: Unique<'s, i64>,
    error_names: Unique<'s, String>,
    types: BTreeMap<String, Vec<String>>,
    uses: Vec<TypeUse<'s>>,
}

#[derive(Debug)]
struct TypeUse<'s> {
    what: String,
    at: At<'s>,
    name: String,
}

impl<'s> Index<'s> {
    /// What a spec has that a pack adds to.
    pub(crate) fn of(base: &Spec) -> Self {
        let commands = || base.commands();
        let requests = commands().flat_map(|command| [Some(command.request_type()), command.reply_type()]).flatten();
        let mut index = Self {
            commands: Unique::taken(commands().map(|command| command.wire.clone())),
            sections: Unique::taken(commands().filter_map(|command| command.section.clone())),
            methods: Unique::taken(commands().map(|command| command.name.clone())),
            type_names: Unique::taken(requests.chain(base.types().map(|def| def.name.clone()))),
            error_wires: Unique::taken(base.errors().map(|code| code.wire)),
            error_names: Unique::taken(base.errors().map(|code| code.name.clone())),
            ..Self::default()
        };
        for def in base.types() {
            index.type_body(&def.name, &def.kind);
        }
        index
    }

    pub(crate) fn command(
        &mut self,
        item: &Item<'_, 's>,
        wire: &Placed<'s, String>,
        section: Option<&Placed<'s, String>>,
    ) {
        self.commands.add(item, "cmdName", wire);
        if let Some(section) = section {
            self.sections.add(item, "section", section);
        }
    }

    /// A command's method, and the types that come with it.
    pub(crate) fn method(&mut self, item: &Item<'_, 's>, name: &Placed<'s, String>) {
        self.methods.add(item, "method name", name);
        let request = to_camel(&name.value);
        for generated in [request.clone() + "Reply", request] {
            self.type_names.add(item, "type name", &Placed { at: name.at, value: generated });
        }
    }

    pub(crate) fn type_name(&mut self, item: &Item<'_, 's>, name: &Placed<'s, String>) {
        self.type_names.add(item, "type name", name);
    }

    /// What a type is made of, for the check that no type contains itself.
    pub(crate) fn type_body(&mut self, name: &str, kind: &TypeKind) {
        self.types.insert(name.to_owned(), kind.names().map(str::to_owned).collect());
    }

    pub(crate) fn type_use(&mut self, item: &Item<'_, 's>, at: At<'s>, ty: &Type) {
        if let Some(name) = ty.named() {
            self.uses.push(TypeUse { what: item.what.clone(), at, name: name.to_owned() });
        }
    }

    pub(crate) fn error_code(&mut self, item: &Item<'_, 's>, wire: &Placed<'s, i64>, name: &Placed<'s, String>) {
        self.error_wires.add(item, "code", wire);
        self.error_names.add(item, "name", name);
    }
}

/// Runs the checks that need all files.
pub(crate) fn check(index: &Index<'_>, report: &Report) {
    for TypeUse { what, at, name } in &index.uses {
        if !index.types.contains_key(name) {
            report.error(*at, format!("{what}: there is no `[[type]]` named `{name}`"));
        } else if reaches_itself(index, name) {
            report.error(*at, format!("{what}: the type `{name}` contains itself"));
        }
    }
}

fn reaches_itself(index: &Index<'_>, name: &str) -> bool {
    let mut seen = BTreeSet::new();
    let mut open = vec![name];
    while let Some(open_name) = open.pop() {
        for part in index.types.get(open_name).into_iter().flatten() {
            if part == name {
                return true;
            }
            if seen.insert(part) {
                open.push(part);
            }
        }
    }
    false
}
