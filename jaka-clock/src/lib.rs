#![doc = include_str!("../docs/overview.md")]
// The logo: `docs/logo.svg`.
#![doc(
    html_logo_url = "data:image/svg+xml,<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 64 64'><rect width='64' height='64' rx='12' fill='%2314506b'/><g fill='none' stroke='%23fff' stroke-width='6' stroke-linecap='round' stroke-linejoin='round'><path d='M14 54h20M24 54V42L20 22 44 14V30'/></g><g fill='%23f5a623'><circle cx='24' cy='42' r='5'/><circle cx='20' cy='22' r='5'/><circle cx='44' cy='14' r='5'/></g><path d='M38 40v-6h12v6' fill='none' stroke='%23fff' stroke-width='4'/></svg>"
)]
// On the host of the documentation each item says which feature it needs.
#![cfg_attr(docsrs, feature(doc_cfg))]

mod clock;
mod signal;
#[cfg(feature = "simulated")]
mod simulated;
mod socket;

pub use clock::{Clock, Stopwatch};
pub use signal::{Signal, lock};
#[cfg(feature = "simulated")]
pub use simulated::{Listener, Participant, SimulatedClock, Stream, Work};
pub use socket::Socket;
