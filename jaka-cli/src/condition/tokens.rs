//! The words and signs of a condition.

use super::{Comparison, Misread};

/// A word or a sign.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Token {
    Word(String),
    Number(f64),
    And,
    Or,
    Not,
    Compare(Comparison),
    Open,
    Close,
    End,
}

/// A token, where it begins.
#[derive(Debug, Clone)]
pub(super) struct Placed {
    pub(super) token: Token,
    pub(super) column: usize,
}

/// The signs, the longer ones first.
const SIGNS: [(&str, Token); 11] = [
    ("&&", Token::And),
    ("||", Token::Or),
    ("==", Token::Compare(Comparison::Equal)),
    ("!=", Token::Compare(Comparison::NotEqual)),
    ("<=", Token::Compare(Comparison::LessOrEqual)),
    (">=", Token::Compare(Comparison::GreaterOrEqual)),
    ("<", Token::Compare(Comparison::Less)),
    (">", Token::Compare(Comparison::Greater)),
    ("!", Token::Not),
    ("(", Token::Open),
    (")", Token::Close),
];

/// All tokens of a text, and where it ends.
pub(super) fn read(text: &str) -> Result<Vec<Placed>, Misread> {
    let mut tokens = Vec::new();
    let mut rest = text;
    let column = |rest: &str| text.chars().count() - rest.chars().count();
    while let Some(first) = rest.chars().next() {
        if first.is_whitespace() {
            rest = rest.trim_start();
            continue;
        }
        let at = column(rest);
        let (token, length) = token(rest, first).map_err(|text| Misread::new(at, text))?;
        tokens.push(Placed { token, column: at });
        rest = &rest[length..];
    }
    tokens.push(Placed { token: Token::End, column: column(rest) });
    Ok(tokens)
}

/// The token at the beginning, and its length.
fn token(text: &str, first: char) -> Result<(Token, usize), String> {
    if let Some((sign, token)) = SIGNS.iter().find(|(sign, _)| text.starts_with(sign)) {
        return Ok((token.clone(), sign.len()));
    }
    let is_word = |c: char| c.is_alphanumeric() || matches!(c, '_' | '.' | '[' | ']');
    let is_number = |c: char| c.is_alphanumeric() || matches!(c, '.' | '-' | '+');
    let until = |is_part: fn(char) -> bool| text.find(|c| !is_part(c)).unwrap_or(text.len());
    match first {
        '&' => Err("`&&` stands for \"and\"".to_owned()),
        '|' => Err("`||` stands for \"or\"".to_owned()),
        '=' => Err("`==` compares".to_owned()),
        '0'..='9' | '-' | '+' | '.' => {
            let length = until(is_number);
            let number = text[..length].parse().ok().filter(|number: &f64| number.is_finite());
            let number = number.ok_or_else(|| format!("`{}` is not a number", &text[..length]))?;
            Ok((Token::Number(number), length))
        }
        _ if is_word(first) => {
            let length = until(is_word);
            Ok((Token::Word(text[..length].to_owned()), length))
        }
        _ => Err(format!("`{}` means nothing here", jaka_sync::proto::text::visible(&first.to_string()))),
    }
}
