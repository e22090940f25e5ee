//! Ranges of firmware.

use jaka_spec::{Version, Versions};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// The firmware that has something, unless all has it.
pub(crate) fn firmware(versions: &Versions) -> Option<TokenStream> {
    (versions != &Versions::default()).then(|| firmware_of(versions, &quote!(proto)))
}

/// The firmware that has something, by the module that has the type of ranges.
pub(crate) fn firmware_of(versions: &Versions, module: &TokenStream) -> TokenStream {
    let numbers = |version: &Version| {
        let numbers = version.numbers().iter().map(|number| Literal::u32_unsuffixed(*number));
        quote!([#(#numbers),*])
    };
    let since = versions.since.as_ref().map(numbers).map(|numbers| quote!(.since(#numbers)));
    let until = versions.until.as_ref().map(numbers).map(|numbers| quote!(.until(#numbers)));
    quote!(#module::FirmwareRange::ALL #since #until)
}
