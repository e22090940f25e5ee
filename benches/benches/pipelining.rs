//! Set-points with 1, 8 and 64 of them outstanding: the requests of servo sessions, without their cycle.
//!
//! Option: `--server-core N` binds the server to a processor, by `taskset`.

use std::error::Error;
use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::time::Instant;

use jaka_benches::system::canned::{SET_POINT, SET_POINT_REPLY};
use jaka_benches::system::child::Server;
use jaka_benches::system::figures::{Contender, Samples, alternate, median, ratio_of_rounds};
use jaka_benches::system::options;
use jaka_benches::system::report::{self, Target};
use jaka_sync::Client;
use jaka_sync::servo::ServoJ;

const ROUNDS: usize = 100;

type Failure = Box<dyn Error>;

fn main() -> Result<(), Failure> {
    let core = options::text("--server-core");
    let server = Server::start(env!("CARGO_BIN_EXE_canned"), &[], core.as_deref())?;
    let address = server.robots()[0].commands;
    let mut contenders = [
        one(address)?,
        window("ours: Pipeline, 8 outstanding", address, 8, 2000)?,
        window("ours: Pipeline, 64 outstanding", address, 64, 8000)?,
        together("ours: Pipeline, 8, sent together", address, 8, 2000)?,
        together("ours: Pipeline, 64, sent together", address, 64, 8000)?,
        bare("limit: bare, 1 outstanding", address, 1, 1, 500)?,
        bare("limit: bare, 8 outstanding", address, 8, 1, 2000)?,
        bare("limit: bare, 64 outstanding", address, 64, 1, 8000)?,
        bare("limit: bare, 64, 32 in a write", address, 64, 32, 8000)?,
    ];
    alternate(&mut contenders, ROUNDS)?;
    report::title("Pipelining, loopback", format_args!("{ROUNDS} rounds of 500 to 8000 set-points of each"));
    for contender in &contenders {
        report::figure(&format!("{}, 1000/s", contender.name), 1000.0 / median(&mut contender.samples.medians()));
    }
    let [one, eight, sixty_four, eight_together, together, bare_one, bare_eight, bare_sixty_four, bare_together] =
        contenders.map(|contender| contender.samples);
    report::verdict("8 outstanding, sent together", ratio_of_rounds(&one, &eight_together), Target::AtLeast(6.0));
    report::verdict("64 outstanding, sent together", ratio_of_rounds(&one, &together), Target::AtLeast(15.0));
    report::figure("8 outstanding, a write for each", ratio_of_rounds(&one, &eight));
    report::figure("64 outstanding, a write for each", ratio_of_rounds(&one, &sixty_four));
    report::figure("the same, bare, 8", ratio_of_rounds(&bare_one, &bare_eight));
    report::figure("the same, bare, 64", ratio_of_rounds(&bare_one, &bare_sixty_four));
    report::figure("the same, bare, 64, 32 in a write", ratio_of_rounds(&bare_one, &bare_together));
    Ok(())
}

/// One sample a round: what one of `count` set-points took on average.
fn timed(samples: &mut Samples, count: u32, send: impl FnOnce() -> Result<(), Failure>) -> Result<(), Failure> {
    let start = Instant::now();
    send()?;
    samples.push(start.elapsed() / count);
    Ok(())
}

fn set_point() -> ServoJ {
    let joint_position = [0.1, 0.0, 0.0, 0.0, 0.0, -0.1];
    ServoJ::relative(joint_position).step_count(1.into())
}

fn one<'a>(address: SocketAddr) -> Result<Contender<'a>, Failure> {
    let mut client = Client::connect(address)?;
    Ok(Contender::new("ours: Client::call, one at a time", move |samples| {
        timed(samples, 500, || Ok((0..500).try_for_each(|_| client.call(&set_point()))?))
    }))
}

fn window<'a>(name: &'static str, address: SocketAddr, window: usize, count: u32) -> Result<Contender<'a>, Failure> {
    let mut client = Client::connect(address)?;
    Ok(Contender::new(name, move |samples| {
        timed(samples, count, || {
            let mut pipeline = client.pipeline(window);
            (0..count).try_for_each(|_| pipeline.send(&set_point()))?;
            if pipeline.finish()? == u64::from(count) { Ok(()) } else { Err("not all were accepted".into()) }
        })
    }))
}

/// Sends through a pipeline with as many set-points in one write as the window has room for.
fn together<'a>(name: &'static str, address: SocketAddr, window: usize, count: u32) -> Result<Contender<'a>, Failure> {
    let mut client = Client::connect(address)?;
    let set_points: Vec<_> = (0..count).map(|_| set_point()).collect();
    Ok(Contender::new(name, move |samples| {
        timed(samples, count, || {
            let mut pipeline = client.pipeline(window);
            pipeline.send_all(&set_points)?;
            if pipeline.finish()? == u64::from(count) { Ok(()) } else { Err("not all were accepted".into()) }
        })
    }))
}

/// Fills the same window through a plain socket, with `together` set-points in a write. Counts answers by their length
/// alone.
fn bare<'a>(
    name: &'static str,
    address: SocketAddr,
    window: usize,
    together: usize,
    count: usize,
) -> Result<Contender<'a>, Failure> {
    let mut stream = TcpStream::connect(address)?;
    stream.set_nodelay(true)?;
    let (out, mut buffer) = (SET_POINT.repeat(together), vec![0; 8 << 10]);
    Ok(Contender::new(name, move |samples| {
        timed(samples, u32::try_from(count)?, || {
            let answer = SET_POINT_REPLY.len();
            // In bytes of answers.
            let (mut outstanding, full) = (0, (window - together) * answer);
            for write in 1..=count / together {
                stream.write_all(&out)?;
                outstanding += together * answer;
                let is_last = write == count / together;
                let most = if is_last { 0 } else { window / 2 * answer };
                while (outstanding > full || is_last) && outstanding > most {
                    outstanding -= stream.read(&mut buffer)?;
                }
            }
            Ok(())
        })
    }))
}
