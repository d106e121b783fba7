//! Path data of a drawing as lines.

/// Pieces that a cubic is drawn in.
const PIECES: usize = 8;

/// A line from point to point.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Line {
    pub(super) points: Vec<(f64, f64)>,
    pub(super) closed: bool,
}

/// The lines of path data with the commands M, L, H, V, C and Z, absolute or relative; lines of fewer than two points are left out.
pub(super) fn of(data: &str) -> Vec<Line> {
    let mut lines: Vec<Line> = Vec::new();
    let mut at = (0.0, 0.0);
    for (command, numbers) in commands(data) {
        let from = if command.is_ascii_lowercase() { at } else { (0.0, 0.0) };
        match command.to_ascii_uppercase() {
            'Z' => {
                if let Some(line) = lines.last_mut() {
                    line.closed = true;
                    at = line.points[0];
                }
                continue;
            }
            'M' => {
                let mut origin = from;
                for (i, pair) in numbers.chunks_exact(2).enumerate() {
                    at = (origin.0 + pair[0], origin.1 + pair[1]);
                    match i {
                        0 => lines.push(Line { points: vec![at], closed: false }),
                        _ => reach(&mut lines, at),
                    }
                    origin = if command == 'm' { at } else { (0.0, 0.0) };
                }
            }
            'L' => {
                for pair in numbers.chunks_exact(2) {
                    let origin = if command == 'l' { at } else { (0.0, 0.0) };
                    at = (origin.0 + pair[0], origin.1 + pair[1]);
                    reach(&mut lines, at);
                }
            }
            'H' | 'V' => {
                for number in numbers {
                    let shift = |along: f64| if command.is_ascii_lowercase() { along + number } else { number };
                    at = if command.eq_ignore_ascii_case(&'H') { (shift(at.0), at.1) } else { (at.0, shift(at.1)) };
                    reach(&mut lines, at);
                }
            }
            'C' => {
                for six in numbers.chunks_exact(6) {
                    let origin = if command == 'c' { at } else { (0.0, 0.0) };
                    let handle = |i: usize| (origin.0 + six[i], origin.1 + six[i + 1]);
                    let points = [at, handle(0), handle(2), handle(4)];
                    for piece in 1..=PIECES {
                        reach(&mut lines, cubic(points, piece as f64 / PIECES as f64));
                    }
                    at = points[3];
                }
            }
            _ => {}
        }
    }
    lines.retain(|line| line.points.len() > 1);
    lines
}

/// Goes on with the last line; one that is closed is followed by another from its start.
fn reach(lines: &mut Vec<Line>, point: (f64, f64)) {
    let next = lines.last().filter(|line| line.closed).map(|line| line.points[0]);
    if let Some(start) = next {
        lines.push(Line { points: vec![start], closed: false });
    }
    if let Some(line) = lines.last_mut() {
        line.points.push(point);
    }
}

/// A point of a cubic.
fn cubic(points: [(f64, f64); 4], t: f64) -> (f64, f64) {
    let s = 1.0 - t;
    let weights = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
    points
        .iter()
        .zip(weights)
        .fold((0.0, 0.0), |sum, (point, weight)| (sum.0 + weight * point.0, sum.1 + weight * point.1))
}

/// Commands with their numbers.
fn commands(data: &str) -> Vec<(char, Vec<f64>)> {
    let mut found: Vec<(char, String)> = Vec::new();
    for c in data.chars() {
        if c.is_ascii_alphabetic() && c != 'e' {
            found.push((c, String::new()));
        } else if let Some((_, text)) = found.last_mut() {
            // A sign begins a number, except behind an exponent.
            if c == '-' && !text.ends_with('e') {
                text.push(' ');
            }
            text.push(c);
        }
    }
    let numbers = |text: &str| text.split([' ', ',', '\n']).filter_map(|number| number.parse().ok()).collect();
    found.iter().map(|(command, text)| (*command, numbers(text))).collect()
}

#[cfg(test)]
mod tests {
    use super::{Line, of};

    #[test]
    fn lines_go_on_from_where_they_are() {
        let found = of("M1 2L3 4l1-1 2 0H10V0M5 5l1 0 0 1Z");
        assert_eq!(
            found,
            [
                Line {
                    points: vec![(1.0, 2.0), (3.0, 4.0), (4.0, 3.0), (6.0, 3.0), (10.0, 3.0), (10.0, 0.0)],
                    closed: false
                },
                Line { points: vec![(5.0, 5.0), (6.0, 5.0), (6.0, 6.0)], closed: true },
            ]
        );
    }

    /// A cubic from (0, 0) to (1, 0) with both handles one above: halfway it is three quarters above.
    #[test]
    fn a_cubic_ends_at_its_end() {
        let found = of("M0 0C0 1 1 1 1 0");
        assert_eq!(found[0].points.len(), 9);
        assert_eq!(found[0].points[4], (0.5, 0.75));
        assert_eq!(found[0].points[8], (1.0, 0.0));
    }

    #[test]
    fn a_point_alone_is_no_line() {
        assert_eq!(of("M1 1"), []);
        assert_eq!(of("L1 1 2 2"), []);
        assert_eq!(of(""), []);
    }
}
