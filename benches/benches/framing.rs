//! Framing: `cargo bench -p jaka-benches --bench framing`.

fn main() {
    for mut work in jaka_benches::framing::works() {
        println!("{}", work.report());
    }
}
