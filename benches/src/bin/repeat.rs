//! Does our part of a task a number of times, for a tool that counts: `repeat "status packet of 9 KB" 100`. Without
//! arguments: the names of all tasks.

use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments: Vec<_> = std::env::args().skip(1).collect();
    let mut works = jaka_benches::works();
    let [name, times] = arguments.as_slice() else {
        for work in &works {
            println!("{}", work.name);
        }
        return ExitCode::SUCCESS;
    };
    let work = works.iter_mut().find(|work| work.name == name);
    let (Some(work), Ok(times)) = (work, times.parse()) else { return ExitCode::FAILURE };
    work.contenders[0].run(times);
    ExitCode::SUCCESS
}
