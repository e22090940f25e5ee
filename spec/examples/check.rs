//! Checks the built-in spec and prints its errors, or its counts.

fn main() -> Result<(), jaka_spec::Errors> {
    let spec = jaka_spec::builtin().inspect_err(|errors| eprintln!("{errors}"))?;
    println!("{} commands, {} types", spec.commands().count(), spec.types().count());
    Ok(())
}
