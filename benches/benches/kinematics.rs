//! Kinematics and checks against limits: `cargo bench --manifest-path benches/Cargo.toml --bench kinematics`. A
//! set-point may take 20 microseconds in all; that nothing
//! allocates is `tests/counts.rs`'s.

fn main() {
    for mut work in jaka_benches::kinematics::works() {
        println!("{}", work.report());
    }
    println!("{}", jaka_benches::generator::report());
    println!("{}", jaka_benches::follower::report());
    println!("{}", jaka_benches::beginning::report());
}
