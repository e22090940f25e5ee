//! `jaka follow`: follow a trajectory from a file.

mod picture;
mod plan;
mod report;

use std::fs;
use std::path::PathBuf;
use std::time::Duration;

use clap::Args;
use jaka_motion::{Checker, Frames, Limits, Trajectory};
use jaka_robot::FollowConfig;

use self::plan::{Plan, PlanArgs};
use self::report::{Checked, Peaks};
use crate::arm::acting::ActArgs;
use crate::arm::limits::LimitsArgs;
use crate::failure::Failure;
use crate::terminal::output;
use crate::text::number::rate;

const EXAMPLES: &str = "\
Examples:
  jaka follow weld.csv --model zu5 --dry-run -o weld.svg
  jaka follow weld.csv --model zu5 --sim --sim-powered --approach 20
  jaka follow weld.csv -r cell1 --limits cell1.toml --approach 5 --scale 0.3
  jaka follow seam.csv -r cell1 --model zu5 --within-mm 0.2 --tool-speed 15 --approach 10";

/// Follow a trajectory from a file, starting where the arm is; Ctrl-C stops it on the trajectory
///
/// The file has times in seconds and joint positions with their units, as CSV or JSON: see the README. A CSV file
/// without times has joint positions, or poses of the tool: --within-mm and --within-deg select a smooth curve near
/// them, --corner-mm and --corner-deg a path through them. The trajectory is compared with the limits of the arm before
/// any request is sent. Then a set-point is sent every 8 ms. Ctrl-C brakes the arm along the trajectory, and a second
/// Ctrl-C also sends `stop_program`. The arm stops in the same way after --timeout, if that is given. The exit code
/// tells the outcome: see `jaka --help`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Follow {
    /// Trajectory: a .csv or .json file
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// Print the checks, the duration and the peaks without connecting
    ///
    /// The tool and the frames of the controller are not known then: figures for the tool centre point are those of the
    /// flange.
    #[arg(long)]
    dry_run: bool,
    /// Also write a picture as SVG: position, speed and acceleration of the joints, and the path of the tool
    #[arg(long, short, value_name = "FILE", requires = "dry_run")]
    output: Option<PathBuf>,
    /// Move to the start first, straight in joint space, at no more than this speed of each joint, in deg/s
    #[arg(long, value_name = "SPEED", value_parser = rate)]
    approach: Option<f64>,
    /// Follow the trajectory at this share of its own speed, up to 1
    #[arg(long, value_name = "SHARE", default_value_t = 1.0, value_parser = share)]
    scale: f64,
    /// Print one JSON object: its `end`; with --dry-run, the trajectory and its peaks
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    plan: PlanArgs,
    #[command(flatten)]
    limits: LimitsArgs,
    #[command(flatten)]
    act: ActArgs,
}

impl Follow {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let limits = self.limits.read()?.ok_or_else(|| {
            Failure::Usage("the limits of the arm are not known: give --model or --limits".to_owned())
        })?;
        let plan = self.plan.read(&self.file)?;
        let checker = Checker::new(limits.clone(), Frames::new());
        if self.dry_run {
            return self.show(&plan.made(&checker, self.plan.near())?, &checker);
        }
        // A failure that depends on no frame comes before any request.
        let known = if plan.is_in_poses() { None } else { Some(plan.made(&checker, None)?) };
        self.follow(&plan, known.as_ref(), (&checker, limits))
    }

    fn show(&self, trajectory: &Trajectory, checker: &Checker) -> Result<(), Failure> {
        if let Some(path) = &self.output {
            let written = picture::svg(trajectory, checker).and_then(|svg| fs::write(path, svg));
            written.map_err(|error| Failure::unwritten(path, error))?;
        }
        let peaks = Peaks::of(trajectory, checker);
        if self.json {
            output::json_lines(&Checked { trajectory, peaks: &peaks })
        } else {
            output::lines(&report::checked(trajectory, &peaks, checker))
        }
    }

    fn follow(
        &self,
        plan: &Plan,
        known: Option<&Trajectory>,
        (checker, limits): (&Checker, Limits),
    ) -> Result<(), Failure> {
        let before = self.approach.map_or_else(String::new, |speed| format!(" after an approach at {speed} deg/s"));
        let file = self.file.display();
        let what = match known {
            Some(trajectory) => {
                let seconds = trajectory.duration_s() / self.scale;
                let speeds = Peaks::of(trajectory, checker).speeds;
                let speeds = speeds.map(|speed| format!("{:.1}", speed * self.scale)).join(", ");
                format!("follow {file} for {seconds:.1} s, its joints at up to {speeds} deg/s{before}")
            }
            None => format!("follow {file}, {}{before}", plan.told()),
        };
        let act = self.act.begin(&what, &[])?;
        let mut config = FollowConfig::new().speed_scale(self.scale).deadline(act.patience(Duration::MAX));
        if let Some(speed) = self.approach {
            config = config.approach(speed);
        }
        if !plan.is_in_poses() {
            config = config.in_joints();
        }
        let near = match self.plan.near() {
            None if plan.is_in_poses() => act.joints()?,
            near => near,
        };
        report::print(act.follow(&|checker| plan.made(checker, near), limits, &config)?, self.json)
    }
}

/// Reads a share: at less than a thousandth of its speed an arm seems to rest.
fn share(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|number| (1e-3..=1.0).contains(number));
    number.ok_or_else(|| "not a number from 0.001 to 1".to_owned())
}
