//! Positions along the walls of a box: from the middle of the wall at +x towards +y, around all four walls.

use std::f64::consts::TAU;

/// Half the length (along x) and half the breadth (along y) of a box [m].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Perimeter {
    /// Half the length.
    pub length: f64,
    /// Half the breadth.
    pub breadth: f64,
}

impl Perimeter {
    /// Names of the walls in the order of [`Perimeter::corners`], the wall where it begins last.
    pub const WALLS: [&'static str; 4] = ["+y", "−x", "−y", "+x"];

    /// Length of all walls [m].
    pub fn whole(self) -> f64 {
        4.0 * (self.length + self.breadth)
    }

    /// Positions of the corners [m].
    pub fn corners(self) -> [f64; 4] {
        let (a, b) = (self.length, self.breadth);
        [b, b + 2.0 * a, 3.0 * b + 2.0 * a, 3.0 * b + 4.0 * a]
    }

    /// The position [m] in a direction seen from the middle, θ [rad] from +x towards +y; it grows by the whole length each turn.
    pub fn along(self, theta: f64) -> f64 {
        let (a, b) = (self.length, self.breadth);
        let (sine, cosine) = theta.sin_cos();
        let reach = f64::min(a / cosine.abs(), b / sine.abs());
        let (x, y) = (reach * cosine, reach * sine);
        let [first, second, third, _] = self.corners();
        // On a wall across x, or on one along it.
        let within = match (a / cosine.abs() <= b / sine.abs(), cosine > 0.0, sine > 0.0) {
            (true, true, _) if y < 0.0 => self.whole() + y,
            (true, true, _) => y,
            (true, false, _) => second + b - y,
            (false, _, true) => first + a - x,
            (false, _, false) => third + a + x,
        };
        // The turn that θ is in; rounding may put the begin of one at the end of the other.
        let turn = (theta / TAU - within / self.whole()).round();
        within + turn * self.whole()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A box of 24 m × 12 m: middles of walls and corners by hand, and once more a turn later.
    #[test]
    fn walls_and_corners() {
        let plan = Perimeter { length: 12.0, breadth: 6.0 };
        let corner = 6.0_f64.atan2(12.0);
        for (theta, expected) in [
            (0.0, 0.0),
            (corner, 6.0),
            (0.25 * TAU, 18.0),
            (0.5 * TAU - corner, 30.0),
            (0.5 * TAU, 36.0),
            (0.75 * TAU, 54.0),
            (TAU - corner, 66.0),
            (TAU - 0.1, 72.0 - 12.0 * 0.1_f64.tan()),
            (TAU, 72.0),
        ] {
            for (turn, more) in [(0.0, 0.0), (TAU, 72.0)] {
                let found = plan.along(theta + turn);
                assert!((found - expected - more).abs() < 1e-9, "{theta}: {found}");
            }
        }
        assert_eq!(plan.corners(), [6.0, 30.0, 42.0, 66.0]);
        assert_eq!(plan.whole(), 72.0);
    }

    #[test]
    fn positions_rise_with_the_angle() {
        let plan = Perimeter { length: 2.0, breadth: 5.0 };
        let all: Vec<f64> = (0..=720).map(|i| plan.along(TAU * f64::from(i) / 700.0)).collect();
        assert!(all.windows(2).all(|s| s[1] > s[0]));
    }
}
