//! Recursive descent over the characters of a lay-up.

use super::{Group, Item, LayupError, Plies, Sign};

const MAXIMUM_DEPTH: usize = 16;

pub(super) fn parse(text: &str) -> Result<Group, LayupError> {
    let mut parser = Parser {
        text,
        characters: text.chars().collect(),
        at: 0,
    };
    let group = parser.group(1)?;
    match parser.peek() {
        None => Ok(group),
        Some(_) => Err(parser.unexpected("the end, after ], ]s, ]_2 or ]_2s")),
    }
}

struct Parser<'t> {
    text: &'t str,
    characters: Vec<char>,
    at: usize,
}

impl Parser<'_> {
    fn group(&mut self, depth: usize) -> Result<Group, LayupError> {
        let close = match self.peek() {
            Some('[') => ']',
            Some('(') => ')',
            _ => return Err(self.unexpected("[ before the first angle, as in [0/90]s")),
        };
        if depth > MAXIMUM_DEPTH {
            return Err(LayupError::TooDeep {
                layup: self.text.to_owned(),
                position: self.at + 1,
                limit: MAXIMUM_DEPTH,
            });
        }
        self.at += 1;
        let mut items = Vec::new();
        let mut marks = Vec::new();
        loop {
            let (item, mark) = self.item(depth)?;
            items.push(item);
            marks.push(mark);
            match self.peek() {
                Some('/' | ',') => self.at += 1,
                Some(c) if c == close => break,
                _ if close == ']' => return Err(self.unexpected("/ or ]")),
                _ => return Err(self.unexpected("/ or )")),
            }
        }
        self.at += 1;
        let (repeats, symmetric) = self.suffix()?;
        let last = marks.len() - 1;
        for (index, mark) in marks.into_iter().enumerate() {
            if let Some(position) = mark
                && !(index == last && symmetric && repeats == 1)
            {
                return Err(self.midplane(position));
            }
        }
        Ok(Group {
            items,
            repeats,
            symmetric,
        })
    }

    /// Repeats and symmetry after a closing bracket.
    fn suffix(&mut self) -> Result<(usize, bool), LayupError> {
        let underscore = self.eat(&['_']);
        let repeats = self.count()?;
        let symmetric = self.eat(&['s', 'S', 'ₛ']);
        let total = !symmetric && self.eat(&['t', 'T', 'ₜ']);
        if underscore && repeats.is_none() && !symmetric && !total {
            return Err(self.unexpected("a number of repeats, or s"));
        }
        Ok((repeats.map_or(1, |(count, _)| count), symmetric))
    }

    /// An item, and where its mid-plane mark stands if it has one.
    fn item(&mut self, depth: usize) -> Result<(Item, Option<usize>), LayupError> {
        match self.peek() {
            Some('[' | '(') => Ok((Item::Group(self.group(depth + 1)?), None)),
            Some(']' | ')' | '/' | ',') => Err(LayupError::Empty {
                layup: self.text.to_owned(),
                position: self.at + 1,
            }),
            None => Err(self.unexpected("an angle in degrees")),
            Some(_) => {
                let (plies, mark) = self.plies()?;
                Ok((Item::Plies(plies), mark))
            }
        }
    }

    fn plies(&mut self) -> Result<(Plies, Option<usize>), LayupError> {
        let (sign, negative) = self.sign();
        let (magnitude, mut mark) = self.angle()?;
        let angle = if negative { 0.0 - magnitude } else { magnitude };
        let explicit = if self.eat(&['_']) {
            Some(
                self.count()?
                    .ok_or_else(|| self.unexpected("a number of plies after _"))?,
            )
        } else if self.peek().is_some_and(|c| !c.is_ascii_digit()) {
            self.count()?
        } else {
            None
        };
        let count = explicit.map_or(1, |(count, _)| count);
        if let Some((count, position)) = explicit
            && sign != Sign::Single
        {
            return Err(LayupError::AmbiguousCount {
                layup: self.text.to_owned(),
                position,
                angle,
                count,
            });
        }
        self.skip_spaces();
        if self.eat(&['~']) {
            mark = Some(self.at);
        }
        if let Some(position) = mark
            && (sign != Sign::Single || count > 1)
        {
            return Err(self.midplane(position));
        }
        let ply = if self.eat(&[':']) {
            Some(self.name()?)
        } else {
            None
        };
        let plies = Plies {
            sign,
            angle,
            count,
            shared: mark.is_some(),
            ply,
        };
        Ok((plies, mark))
    }

    /// The sign before an angle, and whether it is a minus.
    fn sign(&mut self) -> (Sign, bool) {
        const MINUS: [char; 3] = ['-', '−', '–'];
        if self.eat(&['±']) {
            return (Sign::PlusMinus, false);
        }
        if self.eat(&['∓']) {
            return (Sign::MinusPlus, false);
        }
        if self.eat(&MINUS) {
            return if self.eat(&['+']) {
                (Sign::MinusPlus, false)
            } else {
                (Sign::Single, true)
            };
        }
        if self.eat(&['+']) {
            let before = self.at;
            self.eat(&['/']);
            if self.eat(&MINUS) {
                return (Sign::PlusMinus, false);
            }
            self.at = before;
        }
        (Sign::Single, false)
    }

    /// The magnitude of an angle, and where an overline marks the mid-plane.
    fn angle(&mut self) -> Result<(f64, Option<usize>), LayupError> {
        self.skip_spaces();
        let start = self.at;
        let mut digits = String::new();
        let mut mark = None;
        while let Some(&c) = self.characters.get(self.at) {
            match c {
                '0'..='9' | '.' => digits.push(c),
                '\u{304}' | '\u{305}' => mark = Some(self.at + 1),
                _ => break,
            }
            self.at += 1;
        }
        let angle: Option<f64> = digits.parse().ok();
        let Some(angle) = angle.filter(|angle| *angle <= 180.0) else {
            let ends = |c: &char| {
                matches!(c, '/' | ',' | ']' | ')' | '_' | '~' | ':') || c.is_whitespace()
            };
            let found = self.characters[start..]
                .iter()
                .take_while(|&c| !ends(c))
                .collect();
            return Err(LayupError::Angle {
                layup: self.text.to_owned(),
                position: start + 1,
                found,
            });
        };
        self.eat(&['°']);
        Ok((angle, mark))
    }

    /// A number of plies in plain or subscript digits, and its place; `None` if no digit follows.
    fn count(&mut self) -> Result<Option<(usize, usize)>, LayupError> {
        self.skip_spaces();
        let start = self.at;
        let mut digits = String::new();
        while let Some(digit) = self.characters.get(self.at).and_then(|&c| plain_digit(c)) {
            digits.push(digit);
            self.at += 1;
        }
        if digits.is_empty() {
            return Ok(None);
        }
        match digits.parse() {
            Ok(count) if count > 0 => Ok(Some((count, start + 1))),
            _ => Err(LayupError::Count {
                layup: self.text.to_owned(),
                position: start + 1,
                found: digits,
            }),
        }
    }

    fn name(&mut self) -> Result<String, LayupError> {
        self.skip_spaces();
        let ends = |c: char| matches!(c, '/' | ',' | ']' | ')' | '[' | '(') || c.is_whitespace();
        let rest = self.characters[self.at..].iter();
        let name: String = rest.take_while(|&&c| !ends(c)).collect();
        if name.is_empty() {
            return Err(self.unexpected("the name of a ply after :"));
        }
        self.at += name.chars().count();
        Ok(name)
    }

    fn skip_spaces(&mut self) {
        while self
            .characters
            .get(self.at)
            .is_some_and(|c| c.is_whitespace())
        {
            self.at += 1;
        }
    }

    fn peek(&mut self) -> Option<char> {
        self.skip_spaces();
        self.characters.get(self.at).copied()
    }

    fn eat(&mut self, accepted: &[char]) -> bool {
        let found = self.peek().is_some_and(|c| accepted.contains(&c));
        self.at += usize::from(found);
        found
    }

    fn unexpected(&mut self, expected: &'static str) -> LayupError {
        let found = self
            .peek()
            .map_or("the end".to_owned(), |c| format!("'{c}'"));
        LayupError::Unexpected {
            layup: self.text.to_owned(),
            position: self.at + 1,
            found,
            expected,
        }
    }

    fn midplane(&self, position: usize) -> LayupError {
        LayupError::Midplane {
            layup: self.text.to_owned(),
            position,
        }
    }
}

fn plain_digit(c: char) -> Option<char> {
    let value = match c {
        '0'..='9' => return Some(c),
        '₀'..='₉' => u32::from(c) - u32::from('₀'),
        _ => return None,
    };
    char::from_digit(value, 10)
}
