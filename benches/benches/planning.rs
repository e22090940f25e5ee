//! Times of planning: `cargo bench --manifest-path benches/Cargo.toml --bench planning`. That set-points allocate
//! nothing is a test of `tests/counts.rs`.

fn main() {
    println!("{}", jaka_benches::planning::report());
}
