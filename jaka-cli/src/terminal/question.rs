//! Questions on the terminal.

use std::io::{self, BufRead, Write, stderr, stdin};

use crate::failure::Failure;

/// Asks on standard error, reads the answer from standard input, and returns true if it is yes.
pub(crate) fn is_confirmed(question: &str) -> Result<bool, Failure> {
    ask(question, &mut stdin().lock(), &mut stderr()).map_err(|error| Failure::local("cannot ask", error))
}

/// Asks a question, and returns true if the answer is yes.
fn ask(question: &str, input: &mut impl BufRead, output: &mut impl Write) -> io::Result<bool> {
    output.write_all(question.as_bytes())?;
    output.flush()?;
    let mut answer = String::new();
    input.read_line(&mut answer)?;
    Ok(matches!(answer.trim().to_ascii_lowercase().as_str(), "y" | "yes"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_yes_is_one() {
        for (answer, expected) in
            [("y\n", true), (" Yes \n", true), ("", false), ("\n", false), ("n\n", false), ("yy\n", false)]
        {
            let mut shown = Vec::new();
            let found = ask("Send it? ", &mut answer.as_bytes(), &mut shown).expect("both are in memory");
            assert_eq!((found, shown.as_slice()), (expected, b"Send it? ".as_slice()), "{answer:?}");
        }
    }
}
