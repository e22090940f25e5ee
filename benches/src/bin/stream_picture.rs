//! Writes the picture of `docs/streams.md`: `stream_picture docs/streams.svg`.

use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args_os().nth(1).ok_or("where to: docs/streams.svg")?;
    std::fs::write(path, jaka_benches::stream_picture::svg()?)?;
    Ok(())
}
