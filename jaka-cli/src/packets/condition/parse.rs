//! Parser of conditions.

use std::cmp::Ordering;

use jaka_sync::proto::text::visible;
use serde_json::{Number, Value};

use super::{Expression, Misread};
use crate::packets::fields::{Field, Kind};

/// Greatest nesting depth of a condition.
const DEEPEST: usize = 50;

/// Sign of a comparison, and whether it holds for an ordering of the two values.
type Comparison = (&'static str, fn(Ordering) -> bool);

/// Comparison operators, the longer ones first.
const COMPARISONS: [Comparison; 6] = [
    ("==", Ordering::is_eq),
    ("!=", Ordering::is_ne),
    ("<=", Ordering::is_le),
    (">=", Ordering::is_ge),
    ("<", Ordering::is_lt),
    (">", Ordering::is_gt),
];

/// Parses a condition.
pub(super) fn condition(text: &str) -> Result<Expression, Misread> {
    let mut parser = ConditionParser { text, rest: text.trim_start(), depth: 0 };
    let root = parser.either()?;
    if parser.rest.is_empty() { root.truth() } else { Err(parser.unexpected("`&&`, `||` or the end")) }
}

struct ConditionParser<'t> {
    text: &'t str,
    /// Remaining text, without white space at its beginning.
    rest: &'t str,
    depth: usize,
}

/// Part of a condition, with its kind and its start column, from 0.
struct Part {
    expression: Expression,
    kind: Kind,
    column: usize,
}

impl Part {
    fn truth(self) -> Result<Expression, Misread> {
        match self.kind {
            Kind::Truth => Ok(self.expression),
            _ => Err(Misread::new(self.column, "this is a number: compare it, as in `rapid_rate > 0.5`")),
        }
    }
}

impl<'t> ConditionParser<'t> {
    fn column(&self) -> usize {
        self.text.chars().count() - self.rest.chars().count()
    }

    /// Takes this many bytes.
    fn take(&mut self, length: usize) -> &'t str {
        let (taken, rest) = self.rest.split_at(length);
        self.rest = rest.trim_start();
        taken
    }

    /// Takes all leading characters of this kind.
    fn take_all(&mut self, is_part: fn(char) -> bool) -> &'t str {
        self.take(self.rest.find(|c| !is_part(c)).unwrap_or(self.rest.len()))
    }

    /// Takes an operator if it comes next, and returns whether it did.
    fn takes(&mut self, sign: &str) -> bool {
        self.rest.starts_with(sign) && !self.take(sign.len()).is_empty()
    }

    fn unexpected(&self, expected: &str) -> Misread {
        let mut signs = self.rest.chars();
        let text = match (signs.next(), signs.next()) {
            (Some('&'), second) if second != Some('&') => "`&&` stands for \"and\"".to_owned(),
            (Some('|'), second) if second != Some('|') => "`||` stands for \"or\"".to_owned(),
            (Some('='), second) if second != Some('=') => "`==` compares".to_owned(),
            (Some(sign), _) if !is_word(sign) && !"&|=!<>()+-".contains(sign) => {
                format!("`{}` is not expected here", visible(&sign.to_string()))
            }
            _ => format!("expected {expected}"),
        };
        Misread::new(self.column(), text)
    }

    fn either(&mut self) -> Result<Part, Misread> {
        self.joined("||", Self::both, Expression::Or)
    }

    fn both(&mut self) -> Result<Part, Misread> {
        self.joined("&&", Self::comparison, Expression::And)
    }

    /// Parses a part, or several truth values joined by this operator.
    fn joined(
        &mut self,
        sign: &str,
        part: fn(&mut Self) -> Result<Part, Misread>,
        join: fn(Box<Expression>, Box<Expression>) -> Expression,
    ) -> Result<Part, Misread> {
        let mut one = part(self)?;
        while self.takes(sign) {
            let column = one.column;
            let expression = join(Box::new(one.truth()?), Box::new(part(self)?.truth()?));
            one = Part { expression, kind: Kind::Truth, column };
        }
        Ok(one)
    }

    fn comparison(&mut self) -> Result<Part, Misread> {
        let one = self.operand()?;
        let column = self.column();
        let Some((sign, holds)) = self.take_comparison() else { return Ok(one) };
        let other = self.operand()?;
        let after = self.column();
        if self.take_comparison().is_some() {
            return Err(Misread::new(after, "compare two values at a time, and join comparisons with `&&`"));
        }
        match (one.kind, other.kind) {
            (Kind::Number, Kind::Number) => {}
            (Kind::Truth, Kind::Truth) if ["==", "!="].contains(&sign) => {}
            (Kind::Truth, Kind::Truth) => {
                return Err(Misread::new(column, "truth values can only be compared with `==` and `!=`"));
            }
            _ => return Err(Misread::new(column, "a truth value and a number cannot be compared")),
        }
        let expression = Expression::Compare(holds, Box::new(one.expression), Box::new(other.expression));
        Ok(Part { expression, kind: Kind::Truth, column: one.column })
    }

    fn take_comparison(&mut self) -> Option<Comparison> {
        COMPARISONS.into_iter().find(|(sign, _)| self.takes(sign))
    }

    fn operand(&mut self) -> Result<Part, Misread> {
        let column = self.column();
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(Misread::new(column, "too many nested parts"));
        }
        let (expression, kind) = if self.takes("!") {
            (Expression::Not(Box::new(self.operand()?.truth()?)), Kind::Truth)
        } else if self.takes("(") {
            let inner = self.either()?;
            if !self.takes(")") {
                return Err(self.unexpected("`)`"));
            }
            (inner.expression, inner.kind)
        } else if self.rest.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '-' | '+' | '.')) {
            let text = self.take_all(|c| c.is_alphanumeric() || matches!(c, '.' | '-' | '+'));
            let number = number(text).ok_or_else(|| Misread::new(column, format!("`{text}` is not a number")))?;
            (Expression::Literal(number), Kind::Number)
        } else {
            match self.take_all(is_word) {
                "" => return Err(self.unexpected("a field, a number, `!` or `(`")),
                truth @ ("true" | "false") => (Expression::Literal((truth == "true").into()), Kind::Truth),
                path => field(path).map_err(|text| Misread::new(column, text))?,
            }
        };
        self.depth -= 1;
        Ok(Part { expression, kind, column })
    }
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || matches!(c, '_' | '.' | '[' | ']')
}

/// Parses a finite number: JSON has no others.
fn number(text: &str) -> Option<Value> {
    text.parse().ok().and_then(Number::from_f64).map(Value::from)
}

fn field(path: &str) -> Result<(Expression, Kind), String> {
    let field = Field::find(path)?;
    match field.kind() {
        Kind::Other => Err(format!("the status field `{}` is neither a truth value nor a number", field.name)),
        kind => Ok((Expression::Field(Box::new(field)), kind)),
    }
}
