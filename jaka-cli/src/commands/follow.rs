//! `jaka follow`: follow a trajectory from a file.

mod picture;
mod report;

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

use clap::Args;
use jaka_motion::{Checker, Frames, Limits, TimedPoint, Trajectory};
use jaka_robot::FollowConfig;

use self::report::Peaks;
use crate::arm::acting::ActArgs;
use crate::arm::limits::LimitsArgs;
use crate::failure::Failure;
use crate::target::packs;
use crate::terminal::output;

const EXAMPLES: &str = "\
Examples:
  jaka follow weld.csv --model zu5 --dry-run -o weld.svg
  jaka follow weld.csv --model zu5 --sim --sim-powered --approach 20
  jaka follow weld.csv -r cell1 --limits cell1.toml --approach 5 --scale 0.3";

/// Follow a trajectory from a file, from where the arm is; Ctrl-C stops it on the trajectory
///
/// The file has times in seconds and joint positions, as CSV or JSON, with their units: the README shows it. All of it is compared with the arm's limits
/// before anything is sent. Then a set-point goes out each 8 ms. Ctrl-C brakes the arm along the trajectory, and a second one also sends
/// `stop_program`. It stops likewise where it takes longer than --timeout, if that is given. The exit code tells how it ended: `jaka --help`
/// has them.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Follow {
    /// The trajectory: a .csv or .json file
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// Print what was checked, how long it takes and its peaks; connect to nothing
    ///
    /// The tool and the frames of the controller are not known then: what is said of the tool centre point is said of the flange.
    #[arg(long)]
    dry_run: bool,
    /// Write a picture, too: position, speed and acceleration of the joints, and the tool's way, as SVG
    #[arg(long, short, value_name = "FILE", requires = "dry_run")]
    output: Option<PathBuf>,
    /// Go to where it starts first, straight in joint space, with at most this speed of each joint, in deg/s
    #[arg(long, value_name = "SPEED")]
    approach: Option<f64>,
    /// Follow it at this share of its own speed, up to 1
    #[arg(long, value_name = "SHARE", default_value_t = 1.0, value_parser = share)]
    scale: f64,
    /// Print one JSON object
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    limits: LimitsArgs,
    #[command(flatten)]
    act: ActArgs,
}

impl Follow {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let limits = self.limits.read()?.ok_or_else(|| {
            Failure::Usage("without limits it is not known what the arm can do: give --model or --limits".to_owned())
        })?;
        let checker = Checker::new(limits.clone(), Frames::new());
        let trajectory = read(&self.file, &checker)?;
        if self.dry_run { self.show(&trajectory, &checker) } else { self.follow(&trajectory, &checker, limits) }
    }

    fn show(&self, trajectory: &Trajectory, checker: &Checker) -> Result<(), Failure> {
        if let Some(path) = &self.output {
            let written = picture::svg(trajectory, checker).and_then(|svg| fs::write(path, svg));
            written.map_err(|error| Failure::unwritten(path, error))?;
        }
        let peaks = Peaks::of(trajectory, checker);
        if self.json {
            output::json(&format!("{:#}\n", report::checked_as_json(trajectory, &peaks, checker)))
        } else {
            output::lines(&report::checked(trajectory, &peaks, checker))
        }
    }

    fn follow(&self, trajectory: &Trajectory, checker: &Checker, limits: Limits) -> Result<(), Failure> {
        let seconds = trajectory.duration_s() / self.scale;
        let before = self.approach.map_or_else(String::new, |speed| format!(" after an approach at {speed} deg/s"));
        let speeds = Peaks::of(trajectory, checker).speeds.map(|speed| format!("{:.1}", speed * self.scale)).join(", ");
        let what =
            format!("follow {} for {seconds:.1} s, its joints at up to {speeds} deg/s{before}", self.file.display());
        let act = self.act.begin(&what, &[])?;
        let mut config = FollowConfig::new().speed_scale(self.scale).deadline(act.patience(Duration::MAX));
        if let Some(speed) = self.approach {
            config = config.approach(speed);
        }
        report::print(act.follow(trajectory, limits, &config)?, self.json)
    }
}

/// The trajectory of a file, by its name's end.
fn read(path: &Path, checker: &Checker) -> Result<Trajectory, Failure> {
    let (text, name) = (packs::read(path)?, path.display().to_string());
    let is = |end: &str| path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case(end));
    let points = match () {
        () if is("csv") => TimedPoint::from_csv(&text, &name),
        () if is("json") => TimedPoint::from_json(&text, &name),
        () => return Err(Failure::Usage(format!("{name}: a trajectory is a .csv or a .json file"))),
    };
    let points = points.map_err(|errors| Failure::Usage(errors.to_string()))?;
    Trajectory::timed(&points, checker).map_err(|error| Failure::Usage(format!("{name}: {error}")))
}

/// More than 0, up to 1.
fn share(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|number| *number > 0.0 && *number <= 1.0);
    number.ok_or_else(|| "not a number above 0, up to 1".to_owned())
}
