//! Generated code without its bodies and docs: what programs can name, with its limits.

use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use syn::{Arm, ExprMethodCall, ImplItemConst, parse_quote};
use syn::{Attribute, Block, Expr, Fields, File, ImplItem, Item, ItemImpl, Member, Pat, Stmt, TraitItem, Visibility};

/// Mark of a line of ours among those of docs.
const MARK: &str = "///=";

/// Formats the public items, with empty bodies. It leaves out docs, hidden items, the codec, the request of each reply
/// (the methods tell), `#[inline]`, and `#[must_use]`, which all constructors and setters have. A comment shows what
/// the generated code states of a command, and the limits that it checks of a field or of a value.
pub(super) fn interface(tokens: TokenStream) -> String {
    interface_without(tokens, "", &[])
}

/// Formats the interface without these fields of the struct `name`.
pub(super) fn interface_without(tokens: TokenStream, name: &str, fields: &[&str]) -> String {
    let mut file: File = syn::parse2(tokens).expect("the expansion is valid Rust");
    file.items = items(file.items);
    remove(&mut file.items, name, fields);
    let text = prettyplease::unparse(&file);
    let is_left_out = |line: &str| {
        let is_doc = line.starts_with("///") && !line.starts_with(MARK) || line.starts_with("//!");
        is_doc || line.starts_with("#[doc(alias = ") || matches!(line, "#[must_use]" | "#[inline]")
    };
    let lines = text.split_inclusive('\n').filter(|line| !is_left_out(line.trim()));
    lines.map(|line| line.replacen(MARK, "//", 1)).collect()
}

fn remove(items: &mut [Item], name: &str, without: &[&str]) {
    for item in items {
        match item {
            Item::Mod(module) => remove(module.content.as_mut().map_or(&mut [], |(_, items)| items), name, without),
            Item::Struct(item) if item.ident == name => {
                if let Fields::Named(fields) = &mut item.fields {
                    let all = std::mem::take(&mut fields.named).into_iter();
                    let is_kept = |ident: &syn::Ident| without.iter().all(|name| ident != name);
                    fields.named = all.filter(|field| field.ident.as_ref().is_none_or(is_kept)).collect();
                }
            }
            _ => {}
        }
    }
}

fn items(mut items: Vec<Item>) -> Vec<Item> {
    let lines: Vec<_> = items.iter().flat_map(lines).collect();
    for item in &mut items {
        add(&lines, item);
    }
    items.into_iter().filter_map(item).collect()
}

/// A line of the interface: the type, the variant or none, the field or none, and the text.
struct Line {
    place: [String; 3],
    text: String,
}

/// Returns the lines that an implementation of `Command` or `Validate` gives.
fn lines(item: &Item) -> Vec<Line> {
    let Item::Impl(ItemImpl { self_ty, items, .. }) = item else { return Vec::new() };
    let place = [self_ty.to_token_stream().to_string(), String::new(), String::new()];
    let mut found = Vec::new();
    for item in items {
        match item {
            ImplItem::Const(ImplItemConst { ident, expr: Expr::Reference(info), .. }) if ident == "INFO" => {
                let Expr::Macro(info) = &*info.expr else { panic!("`INFO` is written by a macro") };
                found.push(Line { place: place.clone(), text: command(info.mac.tokens.clone()) });
            }
            ImplItem::Fn(function) if function.sig.ident == "validate" => checks(&function.block, &place, &mut found),
            _ => {}
        }
    }
    found
}

/// The facts of a command after its name, the head of its message and its section.
fn command(tokens: TokenStream) -> String {
    let tokens: Vec<_> = tokens.into_iter().collect();
    let parts = tokens.split(|token| matches!(token, TokenTree::Punct(punct) if punct.as_char() == ','));
    let facts = parts.skip(3).map(|part| squeezed(part.iter().cloned().collect::<TokenStream>()));
    facts.filter(|fact| !fact.is_empty()).collect::<Vec<_>>().join(", ")
}

fn checks(block: &Block, place: &[String; 3], found: &mut Vec<Line>) {
    for statement in &block.stmts {
        if let Stmt::Expr(expression, _) = statement {
            checks_of(expression, place, found);
        }
    }
}

fn checks_of(expression: &Expr, place: &[String; 3], found: &mut Vec<Line>) {
    let [of, variant, _] = place;
    match expression {
        Expr::Try(inner) => checks_of(&inner.expr, place, found),
        Expr::Block(inner) => checks(&inner.block, place, found),
        Expr::Match(choice) => {
            for Arm { pat, body, .. } in &choice.arms {
                let path = match pat {
                    Pat::Struct(pattern) => &pattern.path,
                    Pat::Path(pattern) => &pattern.path,
                    _ => continue,
                };
                let variant = path.segments.last().expect("a path has a segment").ident.to_string();
                checks_of(body, &[of.clone(), variant, String::new()], found);
            }
        }
        Expr::MethodCall(ExprMethodCall { method, args, .. }) if method == "check" => {
            let field = squeezed(&args[0]).replace('"', "");
            found.extend(limits(&args[2]).map(|text| Line { place: [of.clone(), variant.clone(), field], text }));
        }
        Expr::MethodCall(ExprMethodCall { method, args, .. }) if method == "takes" => {
            found.push(Line { place: place.clone(), text: squeezed(&args[1]) });
        }
        _ => {}
    }
}

/// The limits of a field, by their names.
fn limits(expression: &Expr) -> Option<String> {
    let Expr::Reference(inner) = expression else { return None };
    let Expr::Struct(limits) = &*inner.expr else { return None };
    let each = limits.fields.iter().map(|field| {
        let Member::Named(name) = &field.member else { panic!("limits have names") };
        let text = squeezed(&field.expr);
        let bound = text.strip_prefix("Some(").and_then(|text| text.strip_suffix(')'));
        format!("{name} {}", bound.unwrap_or(&text))
    });
    Some(each.collect::<Vec<_>>().join(", "))
}

/// The tokens without the blanks that nobody would write, and without what they have in common.
fn squeezed(tokens: impl ToTokens) -> String {
    let common =
        [(" :: ", "::"), (":: core::time::", ""), ("check::", ""), ("proto::", ""), ("FirmwareRange::ALL . ", "")];
    let text = tokens.to_token_stream().to_string();
    let text = common.iter().fold(text, |text, (from, to)| text.replace(from, to)).replace("f64", "").replace("& ", "");
    let mut out = String::new();
    let mut rest = text.chars().peekable();
    while let Some(letter) = rest.next() {
        let is_before_word = rest.peek().is_some_and(|next| next.is_alphanumeric() || *next == '"');
        let is_after_word = out.ends_with(|before: char| before.is_alphanumeric() || ",:".contains(before));
        if letter != ' ' || is_before_word && is_after_word {
            out.push(letter);
        }
    }
    out
}

/// Adds the lines of a type, of its variants and of its fields.
fn add(lines: &[Line], item: &mut Item) {
    let add = |place: [&str; 3], attributes: &mut Vec<Attribute>| {
        for Line { text, .. } in lines.iter().filter(|line| line.place == place) {
            let text = format!("= {text}");
            attributes.push(parse_quote!(#[doc = #text]));
        }
    };
    let (name, variants) = match item {
        Item::Struct(item) => {
            add([&item.ident.to_string(), "", ""], &mut item.attrs);
            (item.ident.to_string(), vec![(String::new(), &mut item.fields)])
        }
        Item::Enum(item) => {
            let name = item.ident.to_string();
            add([&name, "", ""], &mut item.attrs);
            let variants = item.variants.iter_mut().map(|variant| {
                add([&name, &variant.ident.to_string(), ""], &mut variant.attrs);
                (variant.ident.to_string(), &mut variant.fields)
            });
            (name.clone(), variants.collect())
        }
        _ => return,
    };
    for (variant, fields) in variants {
        for field in fields {
            let place = field.ident.as_ref().map(ToString::to_string).unwrap_or_default();
            if !place.is_empty() {
                add([&name, &variant, &place], &mut field.attrs);
            }
        }
    }
}

fn item(item: Item) -> Option<Item> {
    match item {
        Item::Mod(mut module) if !is_hidden(&module.attrs) => {
            if let Some((_, content)) = &mut module.content {
                *content = items(std::mem::take(content));
            }
            Some(Item::Mod(module))
        }
        Item::Impl(block) => implementation(block).map(Item::Impl),
        Item::Fn(mut function) => {
            function.block = parse_quote!({});
            Some(Item::Fn(function))
        }
        Item::Trait(mut block) => {
            for item in &mut block.items {
                if let TraitItem::Fn(method) = item {
                    method.default = None;
                }
            }
            Some(Item::Trait(block))
        }
        Item::Use(import) => is_public(&import.vis).then_some(Item::Use(import)),
        Item::Macro(_) | Item::Mod(_) => None,
        other => Some(other),
    }
}

/// Public functions and constants of a type, or the fact that a trait is implemented.
fn implementation(mut block: ItemImpl) -> Option<ItemImpl> {
    let is_trait = block.trait_.is_some();
    if block.trait_.as_ref().is_some_and(|(path, _)| {
        let path: Vec<_> = path.segments.iter().map(|segment| segment.ident.to_string()).collect();
        ["wire", "check", "proto"].iter().any(|module| path.iter().any(|segment| segment == module))
    }) {
        return None;
    }
    block.items.retain_mut(|item| match item {
        ImplItem::Fn(function) if !is_trait && is_public(&function.vis) => {
            function.block = parse_quote!({});
            true
        }
        ImplItem::Const(constant) if !is_trait && is_public(&constant.vis) => {
            // A number tells which code it is, a long list nothing.
            if matches!(constant.expr, Expr::Reference(_)) {
                constant.expr = parse_quote!(_);
            }
            true
        }
        ImplItem::Type(_) => true,
        _ => false,
    });
    (is_trait || !block.items.is_empty()).then_some(block)
}

fn is_public(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

fn is_hidden(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| attribute.to_token_stream().to_string() == "# [doc (hidden)]")
}
