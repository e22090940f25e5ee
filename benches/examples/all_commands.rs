//! For `benches/build-time`: reads and writes all requests and their replies with the generated codec.

use std::error::Error;

use jaka_proto::wire::{DecodeError, Writer};
use jaka_proto::{Command, Request, Visit, read_payload, write_reply};

struct Reply<'t>(&'t str);

impl Visit for Reply<'_> {
    type Output = Result<String, DecodeError>;

    fn visit<C: Command>(self, _command: &C) -> Self::Output {
        let reply: C::Reply = read_payload(C::INFO, self.0)?;
        let mut out = Writer::new();
        write_reply(C::INFO, &reply, &mut out);
        Ok(out.into_string())
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    for line in std::io::stdin().lines() {
        let line = line?;
        let request = Request::read(&line)?;
        let mut out = Writer::new();
        request.write(&mut out);
        println!("{} {}", out.as_str(), request.visit(Reply(&line))?);
    }
    Ok(())
}
