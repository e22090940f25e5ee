//! The `jaka-sim` program: a simulated controller for clients in any language.

mod program_log;

use std::error::Error;
use std::ffi::OsString;
use std::net::IpAddr;
use std::process::ExitCode;
use std::time::Duration;
use std::{fs, thread};

use jaka_sim::{Builder, Controller, Delays, FaultPlan, Firmware, Habits, Model};
use lexopt::{Arg, Parser, ValueExt};

const HELP: &str = "\
A simulated JAKA controller.

Usage: jaka-sim [OPTIONS]

Options:
      --address ADDRESS    address to listen at [default: 127.0.0.1]
      --commands PORT      port for commands, 0 for a free one [default: 10001]
      --status PORT        port for status packets, 0 for a free one [default: 10000]
      --model NAME         the arm, such as zu5; `list` for all [default: zu5]
      --firmware SHAPE     shape of packets and replies: document, 1.5.14 or newer [default: document]
      --period MS          milliseconds between two status packets [default: that of the firmware]
      --programs FOLDER    programs to load: files of requests, one a line
      --faults TEXT        what goes wrong with replies, packets and links, such as `drop, delay 200ms` or
                           `link both to-client hold after 10s for 5s`; @FILE reads it from a file
      --habits LIST        what real controllers do, such as `pause 100ms, events`, or `all`
      --fast               switch power and enable at once, instead of after some seconds
      --log                print each message that comes and goes
  -h, --help               print this
  -V, --version            print the version

Anyone who can reach the ports can move the simulated arm, and nothing else. It runs until it is interrupted.
";

fn main() -> ExitCode {
    match run(Parser::from_env()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("jaka-sim: {error}");
            ExitCode::from(2)
        }
    }
}

/// What the command line asks for.
enum Task {
    Print(String),
    Serve(Box<Builder>),
}

fn run(parser: Parser) -> Result<(), Box<dyn Error>> {
    match read(parser)? {
        Task::Print(text) => print!("{text}"),
        Task::Serve(builder) => serve(*builder)?,
    }
    Ok(())
}

fn serve(builder: Builder) -> Result<(), Box<dyn Error>> {
    let controller = builder.start().map_err(|error| format!("cannot listen: {error}"))?;
    println!("commands at {}, status at {}", controller.command_addr(), controller.status_addr());
    loop {
        thread::park();
    }
}

fn read(mut parser: Parser) -> Result<Task, Box<dyn Error>> {
    let mut address: IpAddr = [127, 0, 0, 1].into();
    let (mut commands, mut status) = (10001, 10000);
    let mut builder = Controller::builder();
    while let Some(arg) = parser.next()? {
        match arg {
            Arg::Long("address") => address = parser.value()?.parse()?,
            Arg::Long("commands") => commands = parser.value()?.parse()?,
            Arg::Long("status") => status = parser.value()?.parse()?,
            Arg::Long("model") => match parser.value()?.string()?.as_str() {
                "list" => return Ok(Task::Print(models())),
                name => builder = builder.model(model(name)?),
            },
            Arg::Long("firmware") => builder = builder.firmware(firmware(&parser.value()?.string()?)?),
            Arg::Long("period") => builder = builder.status_period(Duration::from_millis(parser.value()?.parse()?)),
            Arg::Long("programs") => builder = builder.programs_from(parser.value()?),
            Arg::Long("faults") => builder = builder.faults(faults(parser.value()?)?),
            Arg::Long("habits") => builder = builder.habits(parser.value()?.parse::<Habits>()?),
            Arg::Long("fast") => builder = builder.delays(Delays::NONE),
            Arg::Long("log") => program_log::print_all(),
            Arg::Short('h') | Arg::Long("help") => return Ok(Task::Print(HELP.to_owned())),
            Arg::Short('V') | Arg::Long("version") => {
                return Ok(Task::Print(format!("jaka-sim {}\n", env!("CARGO_PKG_VERSION"))));
            }
            other => return Err(format!("{}; `--help` lists the options", other.unexpected()).into()),
        }
    }
    Ok(Task::Serve(Box::new(builder.address(address).ports(commands, status))))
}

fn models() -> String {
    let names: Vec<_> = Model::published().iter().map(Model::name).collect();
    names.join("\n") + "\n"
}

fn model(name: &str) -> Result<Model, String> {
    Model::named(name).cloned().ok_or_else(|| format!("no model `{name}`; `--model list` prints all"))
}

fn firmware(name: &str) -> Result<Firmware, String> {
    let found = Firmware::ALL.iter().find(|firmware| firmware.name() == name).copied();
    found.ok_or_else(|| {
        let names: Vec<_> = Firmware::ALL.iter().map(|firmware| firmware.name()).collect();
        format!("no firmware `{name}`; there are {}", names.join(", "))
    })
}

fn faults(text: OsString) -> Result<FaultPlan, Box<dyn Error>> {
    let text = text.string()?;
    let text = match text.strip_prefix('@') {
        Some(path) => fs::read_to_string(path).map_err(|error| format!("cannot read `{path}`: {error}"))?,
        None => text,
    };
    Ok(text.parse()?)
}
