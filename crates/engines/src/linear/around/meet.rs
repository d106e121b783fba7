//! Where the parts along x and along y of a quantity meet: around a cylinder, in the middle of the walls of a box, at its corners.

use crate::linear::model::Model;
use results::channel::OnWall;

/// The box whose motion along x is that along y of the box of a run, turned by 90°.
#[derive(Clone, Copy)]
pub(crate) struct Across<'a> {
    /// Its model.
    pub model: &'a Model,
    /// Half length and half breadth of the box of the run [m].
    pub halves: [f64; 2],
}

impl Across<'_> {
    /// Angle of the corner at x, y > 0 [°], to two decimals as its channel has it.
    pub(crate) fn corner([x, y]: [f64; 2]) -> f64 {
        (100.0 * y.atan2(x).to_degrees()).round() / 100.0
    }
}

/// Where the parts along x and y of a quantity meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Meet {
    /// In every direction: a cylinder; forces and moments of any tank.
    Everywhere,
    /// In the middle of the walls of a box, which the other motion leaves at rest by its symmetry.
    Walls,
    /// At the corners of a box, which both motions move with full amplitude.
    Corners,
}

/// The four directions of [`Meet::Walls`] and [`Meet::Corners`].
const WALLS: [(f64, f64); 4] = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)];
pub(super) const CORNERS: [(f64, f64); 4] = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];

impl Meet {
    /// Directions of the largest and of the smallest even + x c + y s, with the values.
    fn ends(self, x: f64, y: f64) -> Option<[((f64, f64), f64); 2]> {
        let four = match self {
            Meet::Everywhere => {
                let size = x.hypot(y);
                let towards = (x / size, y / size);
                return (size > 0.0).then_some([(towards, size), (opposite(towards), -size)]);
            }
            Meet::Walls => WALLS,
            Meet::Corners => CORNERS,
        };
        let all = four.map(|(c, s)| ((c, s), x * c + y * s));
        let largest = all.into_iter().reduce(|a, b| if b.1 > a.1 { b } else { a })?;
        let smallest = all.into_iter().reduce(|a, b| if b.1 < a.1 { b } else { a })?;
        (x != 0.0 || y != 0.0).then_some([largest, smallest])
    }
}

/// The other end of a diameter.
pub(super) fn opposite((c, s): (f64, f64)) -> (f64, f64) {
    (-c, -s)
}

/// Where even + X cos θ + Y sin θ is largest and smallest over time and θ.
pub(super) fn extreme_directions(meet: Meet, x: &[f64], y: &[f64], even: &[f64]) -> [(f64, f64); 2] {
    let (mut highest, mut lowest) = (f64::NEG_INFINITY, f64::INFINITY);
    let mut directions = [(1.0, 0.0), (-1.0, 0.0)];
    for ((&x, &y), &even) in x.iter().zip(y).zip(even) {
        let Some([(up, high), (down, low)]) = meet.ends(x, y) else { continue };
        if even + high > highest {
            (highest, directions[0]) = (even + high, up);
        }
        if even + low < lowest {
            (lowest, directions[1]) = (even + low, down);
        }
    }
    directions
}

/// Lines over the height of a cylinder, or of a box.
pub(super) fn lines(boxed: bool) -> Vec<OnWall> {
    match boxed {
        false => vec![OnWall::Hoop, OnWall::Pressure],
        true => vec![OnWall::Pressure, OnWall::Moment, OnWall::HorizontalMoment, OnWall::CornerMoment],
    }
}

/// Angles of the corners of a box in the order of [`CORNERS`], from that of the first [°].
pub(super) fn at_corners(degrees: f64) -> [f64; 4] {
    // Two decimals, as the first has.
    [degrees, 180.0 - degrees, 180.0 + degrees, 360.0 - degrees].map(|angle| (100.0 * angle).round() / 100.0)
}
