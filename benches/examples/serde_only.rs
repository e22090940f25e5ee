//! For `benches/build-time`: what any program that speaks JSON compiles, serde with its derives and `serde_json`.

use std::error::Error;

use serde::{Deserialize, Serialize};

#[derive(Debug, Serialize, Deserialize)]
struct SetPoint {
    #[serde(rename = "jointPosition")]
    joint_position: [f64; 6],
    speed: f64,
    #[serde(rename = "accel")]
    acceleration: Option<f64>,
}

fn main() -> Result<(), Box<dyn Error>> {
    for line in std::io::stdin().lines() {
        let point: SetPoint = serde_json::from_str(&line?)?;
        println!("{point:?} {}", serde_json::to_string(&point)?);
    }
    Ok(())
}
