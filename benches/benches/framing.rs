//! Framing: `cargo bench --manifest-path benches/Cargo.toml --bench framing`.

fn main() {
    for mut work in jaka_benches::framing::works() {
        println!("{}", work.report());
    }
}
