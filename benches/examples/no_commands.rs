//! For `benches/build-time`: the same parts of the codec as `all_commands`, and no command.

use std::error::Error;

use jaka_proto::wire::{Decode, Encode, Reader, Writer};
use jaka_proto::{Envelope, write_refusal};

fn main() -> Result<(), Box<dyn Error>> {
    for line in std::io::stdin().lines() {
        let line = line?;
        let envelope = Envelope::read(&line)?;
        let mut out = Writer::new();
        write_refusal(envelope.command.as_deref(), envelope.code?, &envelope.message, &mut out);
        Vec::<f64>::decode(&mut Reader::new(&line))?.encode(&mut out);
        println!("{}", out.as_str());
    }
    Ok(())
}
