//! The server with printed answers, as a process: `canned [LATE]`.

use std::io;
use std::net::TcpListener;
use std::thread;

use jaka_benches::system::{canned, child};

fn main() -> io::Result<()> {
    let late = std::env::args().nth(1).map_or(Ok(0), |text| text.parse()).map_err(io::Error::other)?;
    let (commands, status) = (TcpListener::bind("127.0.0.1:0")?, TcpListener::bind("127.0.0.1:0")?);
    println!("{} {}\n", commands.local_addr()?, status.local_addr()?);
    thread::spawn(move || canned::serve(&commands, late));
    thread::spawn(move || canned::keep_silent(&status));
    child::wait_for_parent()
}
