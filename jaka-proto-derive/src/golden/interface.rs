//! Generated code without its bodies: what programs can name, with its docs.

use proc_macro2::TokenStream;
use quote::ToTokens;
use syn::{Attribute, Fields, File, ImplItem, Item, ItemImpl, TraitItem, Visibility, parse_quote};

/// Formats the public items, with empty bodies. It leaves out hidden items, the codec, the checks of requests, the
/// request of each reply (the methods tell), aliases (the docs tell), `#[inline]`, and `#[must_use]`, which all
/// constructors and setters have.
pub(super) fn interface(tokens: TokenStream) -> String {
    interface_without(tokens, "", &[])
}

/// Formats the interface without these fields of the struct `name`.
pub(super) fn interface_without(tokens: TokenStream, name: &str, fields: &[&str]) -> String {
    let mut file = parsed(tokens);
    remove(&mut file.items, name, fields);
    printed(&file)
}

/// Formats the interface with the first paragraph of the methods' docs; the rest is mostly as in the docs of their
/// requests.
pub(super) fn signatures(tokens: TokenStream) -> String {
    let mut file = parsed(tokens);
    for item in &mut file.items {
        let Item::Impl(block) = item else { continue };
        for item in &mut block.items {
            if let ImplItem::Fn(method) = item {
                let mut is_over = false;
                method.attrs.retain(|attribute| {
                    let text = attribute.to_token_stream().to_string();
                    is_over |= text == r#"# [doc = ""]"#;
                    !is_over || !text.starts_with("# [doc =")
                });
            }
        }
    }
    printed(&file)
}

fn parsed(tokens: TokenStream) -> File {
    let mut file: File = syn::parse2(tokens).expect("the expansion is valid Rust");
    file.items = items(file.items);
    file
}

fn printed(file: &File) -> String {
    let text = prettyplease::unparse(file);
    let lines = text.split_inclusive('\n');
    let is_left_out = |line: &str| line.starts_with("#[doc(alias = ") || matches!(line, "#[must_use]" | "#[inline]");
    lines.filter(|line| !is_left_out(line.trim())).collect()
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

fn items(items: Vec<Item>) -> Vec<Item> {
    items.into_iter().filter_map(item).collect()
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
            if matches!(constant.expr, syn::Expr::Reference(_)) {
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
