//! Hold-down force against uplift.

use crate::error::BaseError;
use crate::march::{Lifted, Point};
use crate::strip::Strip;

/// F(w) of a strip that is lifted and lowered from rest.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// In the order of the uplift.
    points: Vec<Point>,
    slopes: Vec<f64>,
    /// The uplifts alone, and F between each and the next.
    uplifts: Vec<f64>,
    cubics: Vec<Cubic>,
}

/// F over the uplift beyond the first of two points: c₀ + c₁ x + c₂ x² + c₃ x³.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Cubic([f64; 4]);

impl Cubic {
    /// Through two points with these slopes.
    fn between([a, b]: [&Point; 2], [m, n]: [f64; 2]) -> Cubic {
        let h = b.uplift - a.uplift;
        let secant = (b.hold_down - a.hold_down) / h;
        Cubic([a.hold_down, m, (3.0 * secant - 2.0 * m - n) / h, (m + n - 2.0 * secant) / (h * h)])
    }

    /// F and its slope.
    fn at(&self, x: f64) -> [f64; 2] {
        let Cubic([a, b, c, d]) = self;
        [a + x * (b + x * (c + x * d)), b + x * (2.0 * c + x * 3.0 * d)]
    }
}

/// Points of a curve on either side of rest.
const POINTS: usize = 48;

impl Curve {
    /// Between `from` and `to` [m] around the rest of the strip under a wall of `weight` [N/m].
    ///
    /// Points stand close around rest, where the rim leaves the ground, and grow apart geometrically.
    ///
    /// Errors: no equilibrium.
    pub fn of(strip: &Strip, weight: f64, from: f64, to: f64) -> Result<Curve, BaseError> {
        let rest = Lifted::at_rest(strip, weight)?;
        let middle = rest.uplift();
        let mut points = Vec::with_capacity(2 * POINTS + 1);
        for end in [from.min(middle), to.max(middle)] {
            let mut state = rest.clone();
            let mut branch = Vec::with_capacity(POINTS);
            for i in 1..=POINTS {
                // Cubic: the first step is 9e-6 of the whole.
                let share = (i as f64 / POINTS as f64).powi(3);
                if end == middle {
                    break;
                }
                state.lift_to(middle + share * (end - middle))?;
                branch.push(state.point());
            }
            if end < middle {
                branch.reverse();
                branch.push(rest.point());
            }
            if points.is_empty() && branch.is_empty() {
                branch.push(rest.point());
            }
            points.extend(branch);
        }
        Ok(Curve::through(points))
    }

    /// Through two or more states in the order of the uplift: of strips, or of another law of the rim.
    pub fn through(points: Vec<Point>) -> Curve {
        let slopes = slopes(&points);
        let cubics = points.windows(2).zip(slopes.windows(2));
        Curve {
            cubics: cubics.map(|(p, m)| Cubic::between([&p[0], &p[1]], [m[0], m[1]])).collect(),
            uplifts: points.iter().map(|p| p.uplift).collect(),
            slopes,
            points,
        }
    }

    /// The states of the curve.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// Lowest and highest uplift [m].
    pub fn range(&self) -> (f64, f64) {
        (self.points[0].uplift, self.points[self.points.len() - 1].uplift)
    }

    fn place(&self, uplift: f64) -> usize {
        let after = self.uplifts.partition_point(|w| *w < uplift);
        after.clamp(1, self.points.len() - 1)
    }

    /// Hold-down force F at an uplift [N/m]; monotone cubics between the points, straight on beyond them.
    pub fn hold_down(&self, uplift: f64) -> f64 {
        self.hold(uplift)[0]
    }

    /// The same with its slope dF/dw [N/m²].
    pub(crate) fn hold(&self, uplift: f64) -> [f64; 2] {
        let i = self.place(uplift);
        let (from, to) = (self.uplifts[i - 1], self.uplifts[i]);
        if uplift < from {
            let slope = self.slopes[i - 1];
            return [self.points[i - 1].hold_down + slope * (uplift - from), slope];
        }
        if uplift > to {
            return [self.points[i].hold_down + self.slopes[i] * (uplift - to), self.slopes[i]];
        }
        self.cubics[i - 1].at(uplift - from)
    }

    /// The state at an uplift within the range, linear between points but for the force.
    pub fn at(&self, uplift: f64) -> Point {
        let i = self.place(uplift);
        let (a, b) = (&self.points[i - 1], &self.points[i]);
        let t = ((uplift - a.uplift) / (b.uplift - a.uplift)).clamp(0.0, 1.0);
        let mix = |f: fn(&Point) -> f64| f(a) + t * (f(b) - f(a));
        Point {
            uplift,
            hold_down: self.hold_down(uplift),
            rotation: mix(|p| p.rotation),
            rim_moment: mix(|p| p.rim_moment),
            axial_force: mix(|p| p.axial_force),
            lifted_width: mix(|p| p.lifted_width),
            plastic_rotation: mix(|p| p.plastic_rotation),
        }
    }
}

/// Slopes that keep the curve monotone between its points (Fritsch & Butland 1984).
fn slopes(points: &[Point]) -> Vec<f64> {
    let secant: Vec<(f64, f64)> = points
        .windows(2)
        .map(|p| {
            let h = p[1].uplift - p[0].uplift;
            (h, (p[1].hold_down - p[0].hold_down) / h)
        })
        .collect();
    let inner = secant.windows(2).map(|s| {
        let ((h, a), (k, b)) = (s[0], s[1]);
        if a * b <= 0.0 {
            return 0.0;
        }
        3.0 * (h + k) / ((2.0 * k + h) / a + (k + 2.0 * h) / b)
    });
    let first = secant.first().map(|s| s.1);
    let last = secant.last().map(|s| s.1);
    first.into_iter().chain(inner).chain(last).collect()
}
