//! The server with printed answers, as a process. It ends when its standard input does, that is with its parent.

use std::io;
use std::net::TcpListener;
use std::thread;

use jaka_benches::system::canned;

fn main() -> io::Result<()> {
    let commands = TcpListener::bind("127.0.0.1:0")?;
    println!("{}", commands.local_addr()?);
    thread::spawn(move || canned::serve(&commands));
    io::copy(&mut io::stdin(), &mut io::sink()).map(drop)
}
