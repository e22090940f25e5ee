//! Does one task a number of times, for a tool that counts: `repeat "status packet of 9 KB" ours 100`. Without
//! arguments: the names of all works, contenders and targets.

use std::process::ExitCode;

use jaka_benches::measure::Work;

fn main() -> ExitCode {
    let arguments: Vec<_> = std::env::args().skip(1).collect();
    let mut works = jaka_benches::works();
    let [work, contender, times] = arguments.as_slice() else {
        works.iter().for_each(list);
        return ExitCode::SUCCESS;
    };
    let Ok(times) = times.parse() else { return ExitCode::FAILURE };
    let work = works.iter_mut().find(|known| known.name == work);
    let contenders = work.map(|work| &mut work.contenders);
    match contenders.and_then(|list| list.iter_mut().find(|known| known.name() == contender)) {
        Some(contender) => contender.run(times),
        None => return ExitCode::FAILURE,
    }
    ExitCode::SUCCESS
}

/// A line for each target: the work, who has to meet it, which limit, and compared with whom.
fn list(work: &Work<'_>) {
    for target in &work.targets {
        println!("{}\t{}", work.name, target);
    }
}
