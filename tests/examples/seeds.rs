//! Writes the inputs from which fuzzing begins: `cargo run -p jaka-tests --example seeds -- fuzz/corpus`.

use std::error::Error;
use std::path::PathBuf;
use std::{env, fs};

use jaka_fuzz_targets::TARGETS;
use jaka_tests::seeds;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = env::args_os().nth(1).map(PathBuf::from).ok_or("the folder to write to is missing")?;
    for target in TARGETS {
        let folder = folder.join(target.name);
        fs::create_dir_all(&folder)?;
        for (number, seed) in seeds(target.name).into_iter().enumerate() {
            fs::write(folder.join(format!("seed-{number}")), seed)?;
        }
    }
    Ok(())
}
