//! Conditions from their tokens.

use super::tokens::{Placed, Token};
use super::{Comparison, Expression, Misread};
use crate::fields::{Field, Kind};

/// How deeply parts may stand in each other.
const DEEPEST: usize = 50;

/// The condition that all of the tokens make.
pub(super) fn condition(tokens: Vec<Placed>) -> Result<Expression, Misread> {
    let mut parser = Parser { tokens: tokens.into_iter(), next: Placed { token: Token::End, column: 0 }, depth: 0 };
    parser.advance();
    let root = parser.either()?;
    if parser.next.token == Token::End { root.truth() } else { Err(parser.unexpected("`&&`, `||` or the end")) }
}

struct Parser {
    tokens: std::vec::IntoIter<Placed>,
    next: Placed,
    depth: usize,
}

/// A part, where it begins and what it is.
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

impl Parser {
    /// Takes the next token.
    fn advance(&mut self) -> Placed {
        let end = Placed { token: Token::End, column: self.next.column };
        std::mem::replace(&mut self.next, self.tokens.next().unwrap_or(end))
    }

    fn unexpected(&self, expected: &str) -> Misread {
        Misread::new(self.next.column, format!("expected {expected}"))
    }

    fn either(&mut self) -> Result<Part, Misread> {
        let mut one = self.both()?;
        while self.next.token == Token::Or {
            self.advance();
            let column = one.column;
            let expression = Expression::Or(Box::new(one.truth()?), Box::new(self.both()?.truth()?));
            one = Part { expression, kind: Kind::Truth, column };
        }
        Ok(one)
    }

    fn both(&mut self) -> Result<Part, Misread> {
        let mut one = self.comparison()?;
        while self.next.token == Token::And {
            self.advance();
            let column = one.column;
            let expression = Expression::And(Box::new(one.truth()?), Box::new(self.comparison()?.truth()?));
            one = Part { expression, kind: Kind::Truth, column };
        }
        Ok(one)
    }

    fn comparison(&mut self) -> Result<Part, Misread> {
        let one = self.operand()?;
        let Token::Compare(comparison) = self.next.token else { return Ok(one) };
        let sign = self.advance();
        let other = self.operand()?;
        if let Token::Compare(_) = self.next.token {
            return Err(Misread::new(self.next.column, "compare two values at a time, and join comparisons with `&&`"));
        }
        let is_equality = matches!(comparison, Comparison::Equal | Comparison::NotEqual);
        match (one.kind, other.kind) {
            (Kind::Number, Kind::Number) => {}
            (Kind::Truth, Kind::Truth) if is_equality => {}
            (Kind::Truth, Kind::Truth) => {
                return Err(Misread::new(sign.column, "truth values are compared with `==` and `!=` alone"));
            }
            _ => return Err(Misread::new(sign.column, "a truth value and a number cannot be compared")),
        }
        let expression = Expression::Compare(comparison, Box::new(one.expression), Box::new(other.expression));
        Ok(Part { expression, kind: Kind::Truth, column: one.column })
    }

    fn operand(&mut self) -> Result<Part, Misread> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(Misread::new(self.next.column, "there are too many parts in each other"));
        }
        let Placed { token, column } = self.advance();
        let part = |expression, kind| Ok(Part { expression, kind, column });
        let found = match token {
            Token::Number(number) => part(Expression::Number(number), Kind::Number),
            Token::Word(word) => match word.as_str() {
                "true" => part(Expression::Truth(true), Kind::Truth),
                "false" => part(Expression::Truth(false), Kind::Truth),
                path => field(path, column).and_then(|field| {
                    let kind = field.kind();
                    part(Expression::Field(field), kind)
                }),
            },
            Token::Not => {
                let negated = self.operand()?.truth()?;
                part(Expression::Not(Box::new(negated)), Kind::Truth)
            }
            Token::Open => {
                let inner = self.either()?;
                if self.next.token != Token::Close {
                    return Err(self.unexpected("`)`"));
                }
                self.advance();
                Ok(Part { column, ..inner })
            }
            _ => Err(Misread::new(column, "expected a field, a number, `!` or `(`")),
        };
        self.depth -= 1;
        found
    }
}

fn field(path: &str, column: usize) -> Result<Field, Misread> {
    let field = Field::find(path).map_err(|text| Misread::new(column, text))?;
    match field.kind() {
        Kind::Other => {
            let text = format!("the status field `{}` is neither a truth value nor a number", field.name);
            Err(Misread::new(column, text))
        }
        _ => Ok(field),
    }
}
