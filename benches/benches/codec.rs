//! Requests, replies and status packets beside serde: `cargo bench --manifest-path benches/Cargo.toml --bench codec`.

fn main() {
    let works = [jaka_benches::encode::works(), jaka_benches::reply::works(), jaka_benches::status::works()];
    for mut work in works.into_iter().flatten().filter(|work| work.contenders.len() > 1) {
        println!("{}", work.report());
    }
}
