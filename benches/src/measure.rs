//! Ratios that a noisy machine cannot spoil: all contenders of a work run in turns, and are compared turn by turn.

use std::fmt::Write as _;
use std::hint::black_box;
use std::time::Instant;

/// Turns in which every contender runs once.
const TURNS: usize = 101;

/// The shortest time, in nanoseconds, that the first contender runs in a turn.
const SLICE: u128 = 200_000;

/// One way of doing a work.
pub struct Contender<'a> {
    name: &'static str,
    run: Box<dyn FnMut(u32) + 'a>,
}

impl<'a> Contender<'a> {
    /// Makes a contender that does the work once in `once`.
    pub fn new<T>(name: &'static str, mut once: impl FnMut() -> T + 'a) -> Self {
        Self { name, run: Box::new(move |times| (0..times).for_each(|_| drop(black_box(once())))) }
    }

    /// Does the task this many times.
    pub fn run(&mut self, times: u32) {
        (self.run)(times);
    }
}

impl std::fmt::Debug for Contender<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Contender").field("name", &self.name).finish_non_exhaustive()
    }
}

/// Requirement on the time of the first name, as a multiple of the time of the second name.
#[derive(Debug, Clone, Copy)]
pub enum Target {
    /// At most this many times as long.
    AtMost(&'static str, f64, &'static str),
    /// At least this many times as long.
    AtLeast(&'static str, f64, &'static str),
}

/// A work, its contenders with ours first, and their targets.
#[derive(Debug)]
pub struct Work<'a> {
    /// Name of the work.
    pub name: &'static str,
    /// Contenders that do the work; the first is ours.
    pub contenders: Vec<Contender<'a>>,
    /// Requirements on the times of the contenders.
    pub targets: Vec<Target>,
}

impl Work<'_> {
    /// Runs all contenders in turns, in rotating order; a line for each, and for each target.
    pub fn report(&mut self) -> String {
        let times = self.calibrate();
        let mut turns = vec![Vec::with_capacity(TURNS); self.contenders.len()];
        for turn in 0..TURNS {
            for place in 0..turns.len() {
                let at = (turn + place) % turns.len();
                turns[at].push(nanoseconds(&mut self.contenders[at], times) / f64::from(times));
            }
        }
        self.table(&turns)
    }

    /// Number of repetitions of the work in a turn.
    fn calibrate(&mut self) -> u32 {
        let mut times = 1;
        loop {
            let since = Instant::now();
            self.contenders[0].run(times);
            if since.elapsed().as_nanos() >= SLICE || times >= 1 << 24 {
                return times;
            }
            times *= 2;
        }
    }

    fn table(&self, turns: &[Vec<f64>]) -> String {
        let mut out = format!("{}\n", self.name);
        for (contender, own) in self.contenders.iter().zip(turns) {
            let [low, middle, high] = quartiles(ratios(own, &turns[0]));
            let time = quartiles(own.clone())[1];
            let _ = writeln!(out, "  {:24} {middle:6.2}x ({low:.2} to {high:.2}) {time:10.0} ns", contender.name);
        }
        for target in &self.targets {
            let ratio = |name, than| quartiles(ratios(self.of(name, turns), self.of(than, turns)))[1];
            let (words, met) = match *target {
                Target::AtMost(name, factor, than) => {
                    let ratio = ratio(name, than);
                    (format!("{name} at most {factor}x {than}: {ratio:.2}x"), ratio <= factor)
                }
                Target::AtLeast(name, factor, than) => {
                    let ratio = ratio(name, than);
                    (format!("{name} at least {factor}x {than}: {ratio:.2}x"), ratio >= factor)
                }
            };
            let _ = writeln!(out, "  target: {words}, {}", if met { "met" } else { "MISSED" });
        }
        out
    }

    fn of<'t>(&self, name: &str, turns: &'t [Vec<f64>]) -> &'t [f64] {
        let at = self.contenders.iter().position(|contender| contender.name == name);
        at.map_or(&[], |at| &turns[at])
    }
}

fn nanoseconds(contender: &mut Contender<'_>, times: u32) -> f64 {
    let since = Instant::now();
    contender.run(times);
    since.elapsed().as_secs_f64() * 1e9
}

fn ratios(own: &[f64], than: &[f64]) -> Vec<f64> {
    own.iter().zip(than).map(|(own, than)| own / than).collect()
}

fn quartiles(mut values: Vec<f64>) -> [f64; 3] {
    values.sort_by(f64::total_cmp);
    [1, 2, 3].map(|quarter| values.get(values.len() * quarter / 4).copied().unwrap_or(f64::NAN))
}
