//! One command and its reply, again and again, on one core: this crate's client compared with a bare write and read of
//! the same bytes.

use std::error::Error;
use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::time::{Duration, Instant};

use jaka_benches::system::canned::{JOINTS_REPLY, JOINTS_REQUEST};
use jaka_benches::system::child::Server;
use jaka_benches::system::figures::{Contender, Samples, alternate, ratio_of_rounds};
use jaka_benches::system::report;
use jaka_sync::Client;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

const ROUNDS: usize = 100;
const CALLS: usize = 1000;

/// Calls at the beginning of each round that do not count: the contender before has left its own code and data in the
/// caches.
const WARM_UP: usize = 10;

/// As a client with a deadline must have it.
const DEADLINE: Duration = Duration::from_secs(5);

type Failure = Box<dyn Error>;

fn main() -> Result<(), Failure> {
    let server = Server::start(env!("CARGO_BIN_EXE_canned"))?;
    let address = server.address();
    let mut contenders = [limit(address)?, with_deadline(address)?, ours(address)?, typed(address)?, value(address)?];
    alternate(&mut contenders, ROUNDS)?;
    let [limit, with_deadline, ours, typed, value] = &contenders;
    let (out, back) = (JOINTS_REQUEST.len(), JOINTS_REPLY.len());
    report::title(
        "Blocking round trip, loopback",
        format_args!("{ROUNDS} rounds of {CALLS} calls of each, {out} bytes out and {back} back"),
    );
    report::percentiles(&contenders);
    let at = |contender: &Contender<'_>, share| contender.samples.percentile(share) / limit.samples.percentile(share);
    report::verdict("p50, Client relative to bare", at(ours, 0.5), 1.12);
    report::verdict("p99, Client relative to bare", at(ours, 0.99), 1.15);
    let rounds = |contender: &Contender<'_>| ratio_of_rounds(&contender.samples, &limit.samples);
    report::figure("median of the rounds' ratios, Client", rounds(ours));
    report::figure("the same, bare with a deadline", rounds(with_deadline));
    report::figure("the same, typed serde", rounds(typed));
    report::figure("the same, Value and one read", rounds(value));
    Ok(())
}

/// The samples of one round, each from the end of the one before.
fn round(samples: &mut Samples, mut call: impl FnMut() -> Result<(), Failure>) -> Result<(), Failure> {
    for _ in 0..WARM_UP {
        call()?;
    }
    let mut before = Instant::now();
    for _ in 0..CALLS {
        call()?;
        let now = Instant::now();
        samples.push(now - before);
        before = now;
    }
    Ok(())
}

fn connect(address: SocketAddr) -> Result<TcpStream, Failure> {
    let stream = TcpStream::connect(address)?;
    stream.set_nodelay(true)?;
    Ok(stream)
}

fn limit<'a>(address: SocketAddr) -> Result<Contender<'a>, Failure> {
    Ok(bare("limit: bare write and read", connect(address)?))
}

/// Bare exchange with a read timeout on the socket, which shows the cost of that timeout.
fn with_deadline<'a>(address: SocketAddr) -> Result<Contender<'a>, Failure> {
    let stream = connect(address)?;
    stream.set_read_timeout(Some(DEADLINE))?;
    Ok(bare("bare, with a deadline on the read", stream))
}

fn bare<'a>(name: &'static str, mut stream: TcpStream) -> Contender<'a> {
    let mut buffer = vec![0; 8 << 10];
    Contender::new(name, move |samples| {
        round(samples, || {
            stream.write_all(JOINTS_REQUEST)?;
            let mut len = 0;
            while len < JOINTS_REPLY.len() {
                len += stream.read(&mut buffer[len..])?;
            }
            Ok(())
        })
    })
}

fn ours<'a>(address: SocketAddr) -> Result<Contender<'a>, Failure> {
    let mut client = Client::connect(address)?;
    Ok(Contender::new("ours: Client::get_joint_pos", move |samples| {
        round(samples, || {
            std::hint::black_box(client.get_joint_pos()?.joint_position);
            Ok(())
        })
    }))
}

#[derive(Serialize)]
struct Request<'a> {
    #[serde(rename = "cmdName")]
    command: &'a str,
}

#[derive(Deserialize)]
struct Reply<'a> {
    #[serde(rename = "errorCode")]
    code: &'a str,
    #[serde(rename = "cmdName")]
    command: &'a str,
    joint_pos: [f64; 6],
}

/// serde's derives, one buffer for each direction, one read.
fn typed<'a>(address: SocketAddr) -> Result<Contender<'a>, Failure> {
    let mut stream = connect(address)?;
    let (mut out, mut buffer) = (Vec::new(), vec![0; 8 << 10]);
    Ok(Contender::new("peer: typed serde, one read", move |samples| {
        round(samples, || {
            out.clear();
            serde_json::to_writer(&mut out, &Request { command: "get_joint_pos" })?;
            stream.write_all(&out)?;
            let len = stream.read(&mut buffer)?;
            let reply: Reply<'_> = serde_json::from_slice(&buffer[..len])?;
            if reply.code != "0" || reply.command != "get_joint_pos" {
                return Err("refused".into());
            }
            std::hint::black_box(reply.joint_pos);
            Ok(())
        })
    }))
}

/// libjaka's way: a `Value` for each request and reply, and one read into a fresh buffer.
fn value<'a>(address: SocketAddr) -> Result<Contender<'a>, Failure> {
    let mut stream = connect(address)?;
    Ok(Contender::new("peer: serde_json::Value, one read", move |samples| {
        round(samples, || {
            let request = json!({"cmdName": "get_joint_pos"}).to_string();
            stream.write_all(request.as_bytes())?;
            let mut buffer = [0; 2048];
            let len = stream.read(&mut buffer)?;
            let reply: Value = serde_json::from_slice(&buffer[..len])?;
            if reply["errorCode"] != "0" {
                return Err("refused".into());
            }
            std::hint::black_box(serde_json::from_value::<[f64; 6]>(reply["joint_pos"].clone())?);
            Ok(())
        })
    }))
}
