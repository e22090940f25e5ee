//! Who may receive which reply: random runs of the exchange against a model that knows the truth.

mod ledger;

/// How many times as many runs as usual: `RELIABILITY_RUNS`, or 1.
fn times() -> u32 {
    std::env::var("RELIABILITY_RUNS").ok().and_then(|times| times.parse().ok()).unwrap_or(1)
}
