//! The files of a spec as tables, and places in them.

use std::fmt::Write as _;

use jaka_spec::{Errors, Source, Spec, load};
use toml::{Table, Value};

/// A step from a table to a value in it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Step {
    Key(&'static str),
    At(usize),
}

/// The place of a table: its file, and the steps to it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Place {
    pub(crate) file: usize,
    steps: Vec<Step>,
}

impl Place {
    fn inside(&self, key: &'static str, at: usize) -> Self {
        let mut place = self.clone();
        place.steps.extend([Step::Key(key), Step::At(at)]);
        place
    }

    /// True for a field, a value or a variant of a named type.
    pub(crate) fn is_of_type(&self) -> bool {
        self.steps.first() == Some(&Step::Key("type"))
    }

    /// True for a field of a request, also of one of its variants.
    pub(crate) fn is_of_request(&self) -> bool {
        matches!(self.steps.get(2), Some(Step::Key("request" | "choice")))
    }

    /// True for a field of a reply.
    pub(crate) fn is_of_reply(&self) -> bool {
        self.steps.get(2) == Some(&Step::Key("reply"))
    }

    /// The list in which the table is.
    pub(crate) fn list(&self) -> List {
        let mut owner = self.clone();
        let (Some(Step::At(_)), Some(Step::Key(key))) = (owner.steps.pop(), owner.steps.pop()) else {
            panic!("a file is in no list")
        };
        List { owner, key }
    }

    /// The place of the command or type in which this place is.
    pub(crate) fn owner(&self) -> Self {
        Self { file: self.file, steps: self.steps[..2].to_vec() }
    }
}

/// A list of tables: the table that has it, and its key.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct List {
    pub(crate) owner: Place,
    pub(crate) key: &'static str,
}

/// Files of a spec that are being edited.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Draft {
    files: Vec<(String, Table)>,
}

impl Draft {
    pub(crate) fn new(sources: &[Source<'_>]) -> Self {
        let read = |source: &Source<'_>| (source.path.to_owned(), source.text.parse().expect("a file is TOML"));
        Self { files: sources.iter().map(read).collect() }
    }

    pub(crate) fn load(&self) -> Result<Spec, Errors> {
        let texts: Vec<_> = self.files.iter().map(|(path, table)| (path, table.to_string())).collect();
        let sources: Vec<_> = texts.iter().map(|(path, text)| Source { path, text }).collect();
        load(&sources)
    }

    /// The places of the files themselves.
    pub(crate) fn files(&self) -> Vec<Place> {
        (0..self.files.len()).map(|file| Place { file, steps: Vec::new() }).collect()
    }

    /// The module of a file.
    pub(crate) fn module(&self, file: usize) -> &str {
        let path = &self.files[file].0;
        path.strip_prefix("spec/").and_then(|path| path.strip_suffix(".toml")).unwrap_or(path)
    }

    /// Gives a file another name.
    pub(crate) fn rename_file(&mut self, file: usize, module: &str) {
        self.files[file].0 = format!("spec/{module}.toml");
    }

    pub(crate) fn table(&self, place: &Place) -> &Table {
        let mut table = &self.files[place.file].1;
        for steps in place.steps.chunks(2) {
            let [Step::Key(key), Step::At(at)] = steps else { panic!("a place is keys and numbers in turn") };
            let value = table.get(*key).expect("a place is that of a table");
            let value = if value.is_table() { value } else { value.get(*at).expect("a place is that of a table") };
            table = value.as_table().expect("a place is that of a table");
        }
        table
    }

    pub(crate) fn table_mut(&mut self, place: &Place) -> &mut Table {
        let mut table = &mut self.files[place.file].1;
        for steps in place.steps.chunks(2) {
            let [Step::Key(key), Step::At(at)] = steps else { panic!("a place is keys and numbers in turn") };
            let value = table.get_mut(*key).expect("a place is that of a table");
            let value = if value.is_table() { value } else { value.get_mut(*at).expect("a place is that of a table") };
            table = value.as_table_mut().expect("a place is that of a table");
        }
        table
    }

    /// The tables under `key` of each of these places.
    fn inside(&self, owners: &[Place], key: &'static str) -> Vec<Place> {
        let tables = |owner: &Place| {
            let count = match self.table(owner).get(key) {
                Some(Value::Array(tables)) => tables.len(),
                Some(Value::Table(_)) => 1,
                _ => 0,
            };
            (0..count).map(|at| owner.inside(key, at)).collect::<Vec<_>>()
        };
        owners.iter().flat_map(tables).collect()
    }

    pub(crate) fn commands(&self) -> Vec<Place> {
        self.inside(&self.files(), "command")
    }

    pub(crate) fn types(&self) -> Vec<Place> {
        self.inside(&self.files(), "type")
    }

    pub(crate) fn errors(&self) -> Vec<Place> {
        self.inside(&self.files(), "error")
    }

    pub(crate) fn events(&self) -> Vec<Place> {
        self.inside(&self.files(), "event")
    }

    /// The tables `[command.motion]`.
    pub(crate) fn motions(&self) -> Vec<Place> {
        self.inside(&self.commands(), "motion")
    }

    /// Variants of requests and of types.
    pub(crate) fn variants(&self) -> Vec<Place> {
        let choices = self.inside(&self.commands(), "choice");
        [self.inside(&choices, "variant"), self.inside(&self.types(), "variant")].concat()
    }

    /// Values of enums.
    pub(crate) fn values(&self) -> Vec<Place> {
        self.inside(&self.types(), "value")
    }

    /// Fields of requests, replies, types and variants.
    pub(crate) fn fields(&self) -> Vec<Place> {
        let (commands, types, variants) = (self.commands(), self.types(), self.variants());
        let fields = [(&commands, "request"), (&commands, "reply"), (&types, "field"), (&variants, "field")];
        fields.into_iter().flat_map(|(owners, key)| self.inside(owners, key)).collect()
    }

    /// The lists of fields, also empty ones.
    pub(crate) fn field_lists(&self) -> Vec<List> {
        let mut lists = Vec::new();
        for owner in self.commands() {
            if !self.table(&owner).contains_key("choice") {
                lists.push(List { owner: owner.clone(), key: "request" });
            }
            if !self.table(&owner).get("reply").is_some_and(Value::is_str) {
                lists.push(List { owner, key: "reply" });
            }
        }
        let structs = self.types().into_iter().filter(|owner| matches!(self.text(owner, "kind"), "object" | "array"));
        lists.extend(structs.chain(self.variants()).map(|owner| List { owner, key: "field" }));
        lists
    }

    /// The tables of a list, which is made where there is none.
    pub(crate) fn list_mut(&mut self, list: &List) -> &mut Vec<Value> {
        let table = self.table_mut(&list.owner);
        let value = table.entry(list.key).or_insert_with(|| Value::Array(Vec::new()));
        value.as_array_mut().expect("a list is an array")
    }

    /// Takes a table out of the list in which it is.
    pub(crate) fn remove(&mut self, place: &Place) -> Table {
        let mut owner = place.clone();
        let (Some(Step::At(at)), Some(Step::Key(key))) = (owner.steps.pop(), owner.steps.pop()) else {
            panic!("a file is in no list")
        };
        let table = self.table_mut(&owner);
        match table.get_mut(key) {
            Some(Value::Array(tables)) => match tables.remove(at) {
                Value::Table(removed) => removed,
                other => panic!("{other} is not a table"),
            },
            _ => match table.remove(key) {
                Some(Value::Table(removed)) => removed,
                _ => panic!("there is no table {key}"),
            },
        }
    }

    /// A text of a table; an empty one where it has none.
    pub(crate) fn text(&self, place: &Place, key: &str) -> &str {
        self.table(place).get(key).and_then(Value::as_str).unwrap_or_default()
    }

    /// The name in Rust of a field or a command.
    pub(crate) fn name(&self, place: &Place) -> String {
        let name = self.text(place, "name");
        if name.is_empty() { self.text(place, "wire").to_owned() } else { name.to_owned() }
    }

    /// True if the fields of a list are elements of an array, which have no keys.
    pub(crate) fn is_array(&self, list: &List) -> bool {
        let owner = list.owner.owner();
        list.owner.is_of_type() && self.text(&owner, "kind") != "object"
    }

    /// Names of all types.
    pub(crate) fn type_names(&self) -> Vec<String> {
        self.types().iter().map(|place| self.text(place, "name").to_owned()).collect()
    }

    /// The place in words.
    pub(crate) fn describe(&self, place: &Place) -> String {
        let mut text = self.module(place.file).to_owned();
        for len in (2..=place.steps.len()).step_by(2) {
            let part = Place { file: place.file, steps: place.steps[..len].to_vec() };
            let (Step::Key(key), table) = (part.steps[len - 2], self.table(&part)) else { continue };
            let name = ["wire", "name"].iter().find_map(|key| table.get(*key));
            let name = name.map(|name| format!(" {}", name.to_string().trim_matches('"'))).unwrap_or_default();
            let _ = write!(text, ", {key}{name}");
        }
        text
    }
}
