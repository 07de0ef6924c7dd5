//! Path data as a path: the commands `M L H V Q C Z` and `l h v c z` of SVG, with repeated arguments.

use tiny_skia::{Path, PathBuilder};

/// The path; `None` for data that this crate does not write, or that draws nothing.
pub(super) fn path(data: &str) -> Option<Path> {
    let mut reader = Reader { rest: data };
    let mut path = PathBuilder::new();
    let [mut start, mut at] = [[0.0_f32; 2]; 2];
    let mut command = reader.command()?;
    loop {
        let base = if command.is_ascii_lowercase() {
            at
        } else {
            [0.0; 2]
        };
        match command.to_ascii_uppercase() {
            'M' => {
                at = reader.point(base)?;
                start = at;
                path.move_to(at[0], at[1]);
            }
            'Z' => {
                path.close();
                at = start;
            }
            shape => {
                at = match shape {
                    'H' => [reader.number()? + base[0], at[1]],
                    'V' => [at[0], reader.number()? + base[1]],
                    'L' => reader.point(base)?,
                    'Q' => {
                        let [control, end] = [reader.point(base)?, reader.point(base)?];
                        path.quad_to(control[0], control[1], end[0], end[1]);
                        end
                    }
                    'C' => {
                        let [a, b] = [reader.point(base)?, reader.point(base)?];
                        let end = reader.point(base)?;
                        path.cubic_to(a[0], a[1], b[0], b[1], end[0], end[1]);
                        end
                    }
                    _ => return None,
                };
                if matches!(shape, 'H' | 'V' | 'L') {
                    path.line_to(at[0], at[1]);
                }
            }
        }
        if let Some(next) = reader.command() {
            command = next;
        } else if reader.rest.is_empty() {
            return path.finish();
        } else {
            // Further arguments repeat a command; after a start they are lines.
            command = match command {
                'M' => 'L',
                'Z' | 'z' => return None,
                same => same,
            };
        }
    }
}

struct Reader<'a> {
    rest: &'a str,
}

impl Reader<'_> {
    /// The command that comes next, if it is not a number.
    fn command(&mut self) -> Option<char> {
        self.rest = self.rest.trim_start_matches([' ', ',']);
        let letter = self.rest.chars().next().filter(char::is_ascii_alphabetic)?;
        self.rest = &self.rest[1..];
        Some(letter)
    }

    fn point(&mut self, base: [f32; 2]) -> Option<[f32; 2]> {
        Some([self.number()? + base[0], self.number()? + base[1]])
    }

    fn number(&mut self) -> Option<f32> {
        let rest = self.rest.trim_start_matches([' ', ',']);
        let unsigned = rest.strip_prefix('-').unwrap_or(rest);
        let digits = unsigned
            .find(|letter: char| !letter.is_ascii_digit() && letter != '.')
            .unwrap_or(unsigned.len());
        let end = rest.len() - unsigned.len() + digits;
        let number = rest[..end].parse().ok()?;
        self.rest = &rest[end..];
        Some(number)
    }
}

#[cfg(test)]
mod tests {
    use tiny_skia::PathSegment::{Close, CubicTo, LineTo, MoveTo, QuadTo};
    use tiny_skia::Point;

    use super::*;

    fn segments(data: &str) -> Vec<tiny_skia::PathSegment> {
        path(data).unwrap().segments().collect()
    }

    fn point(x: f32, y: f32) -> Point {
        Point::from_xy(x, y)
    }

    #[test]
    fn relative_and_repeated_arguments_are_read() {
        let expected = [
            MoveTo(point(1.0, 2.0)),
            LineTo(point(1.5, 1.0)),
            LineTo(point(0.0, 12.25)),
            Close,
        ];
        assert_eq!(segments("M1 2l.5-1 -1.5 11.25z"), expected);
    }

    #[test]
    fn all_commands_that_figures_write_are_read() {
        let expected = [
            MoveTo(point(0.0, 0.0)),
            LineTo(point(3.0, 0.0)),
            LineTo(point(3.0, -2.0)),
            QuadTo(point(1.0, 1.0), point(2.0, 2.0)),
            CubicTo(point(2.0, 3.0), point(3.0, 4.0), point(4.0, 5.0)),
            LineTo(point(-1.0, 5.0)),
            LineTo(point(-1.0, 7.0)),
        ];
        assert_eq!(segments("M0 0h3v-2Q1 1 2 2c0 1 1 2 2 3H-1V7"), expected);
    }

    #[test]
    fn other_data_draws_nothing() {
        for data in ["", "M1", "1 2", "M0 0a1 1 0 0 0 1 1", "M0 0zz1", "M0 0L1 x"] {
            assert!(path(data).is_none(), "{data}");
        }
    }
}
