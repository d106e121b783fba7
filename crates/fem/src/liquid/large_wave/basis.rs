//! The modes of small waves in a tank, with their values and slopes on quadrature points of the level at rest.

use std::f64::consts::{PI, TAU};

use super::bessel::{bessel_j, bessel_j_prime_zero};
use super::quadrature::gauss_legendre;

/// Points that are handled together: the tables hold blocks of so many points, mode after mode.
pub(super) const LANES: usize = 8;

/// Quadrature points in r. Products of four of the modes have wave numbers up to 58/R, which 24 points still resolve.
const RADII: usize = 24;

/// Harmonics of a cylinder: cos 0θ to cos 3θ. Terms of third order of a wave cos θ reach cos 3θ.
const HARMONICS: i32 = 4;

/// Plan of the tank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// A circle.
    Cylinder {
        /// Radius R [m].
        radius: f64,
    },
    /// A rectangle whose liquid moves along its length only.
    Strip {
        /// Length in the direction of motion L [m].
        length: f64,
        /// Width across [m].
        width: f64,
    },
}

/// Which families of a cylinder's modes are unknowns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// cos mθ: motion along x without swirling.
    Cosine,
    /// cos mθ and sin mθ: two components, swirling.
    Both,
}

/// A place on the level at rest [m].
pub type Place = [f64; 2];

/// A mode of the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mode {
    /// Wave number k [1/m]; 0 of the constant.
    pub wave_number: f64,
    /// Circumferential wave number m of a cylinder, n of a strip's cos nπ(x/L + ½).
    pub harmonic: i32,
    /// Whether it is a sine in θ.
    pub sine: bool,
}

/// Modes of a tank's surface and their tables. The first mode is the constant. All others are 1 at the wall.
#[derive(Clone, Debug)]
pub struct Basis {
    pub(super) shape: Shape,
    pub(super) modes: Vec<Mode>,
    pub(super) blocks: usize,
    /// Values, slopes along the first and second direction, and weights of projection: `[block][mode][lane]`.
    pub(super) value: Vec<f64>,
    pub(super) slope: [Vec<f64>; 2],
    pub(super) projection: Vec<f64>,
    /// Places of the points and their areas; points that fill the last block have no area.
    pub(super) places: Vec<Place>,
    pub(super) areas: Vec<f64>,
    /// ∫F² dA [m²], ∫xF dA and ∫yF dA [m³].
    pub(super) norm: Vec<f64>,
    pub(super) lever: [Vec<f64>; 2],
}

impl Basis {
    /// Modes of a cylinder: harmonics 0 to 3, `radial` of each.
    ///
    /// * `radius`: R [m], positive
    /// * `radial`: radial modes of each harmonic, 1 to 4
    pub fn cylinder(radius: f64, radial: usize, side: Side) -> Basis {
        let mut modes = vec![Mode { wave_number: 0.0, harmonic: 0, sine: false }];
        for sine in [false, true] {
            if sine && side == Side::Cosine {
                continue;
            }
            for m in i32::from(sine)..HARMONICS {
                modes.extend((1..=radial.clamp(1, 4)).map(|n| Mode {
                    wave_number: bessel_j_prime_zero(m, n) / radius,
                    harmonic: m,
                    sine,
                }));
            }
        }
        // Half of the circle is enough for cosines; its points count twice. Products of five factors have 15 waves at most.
        let (angles, span) = if side == Side::Cosine { (12, PI) } else { (24, TAU) };
        let mut points = Vec::new();
        for (x, w) in gauss_legendre(RADII) {
            let r = 0.5 * radius * (1.0 + x);
            for i in 0..angles {
                let angle = span * (f64::from(i) + 0.5) / f64::from(angles);
                points.push(([r * angle.cos(), r * angle.sin()], 0.5 * radius * w * r * TAU / f64::from(angles)));
            }
        }
        Basis::tables(Shape::Cylinder { radius }, modes, (points, angles as usize))
    }

    /// Modes cos nπ(x/L + ½), n = 1 to `count`, of a rectangle.
    ///
    /// * `length`, `width`: L along the motion, and across [m], positive
    pub fn strip(length: f64, width: f64, count: usize) -> Basis {
        let modes = (0..=count as i32)
            .map(|n| Mode { wave_number: f64::from(n) * PI / length, harmonic: n, sine: false })
            .collect();
        let points = 4 * count;
        let points = (0..points)
            .map(|i| ([length * ((i as f64 + 0.5) / points as f64 - 0.5), 0.0], length * width / points as f64))
            .collect();
        Basis::tables(Shape::Strip { length, width }, modes, (points, 1))
    }

    /// Values at the points, of which `ring` after each other have the same radius: Bessel functions cost more than all that is done with them.
    fn tables(shape: Shape, modes: Vec<Mode>, (points, ring): (Vec<(Place, f64)>, usize)) -> Basis {
        let blocks = points.len().div_ceil(LANES);
        let size = blocks * modes.len() * LANES;
        let mut basis = Basis {
            shape,
            norm: vec![0.0; modes.len()],
            lever: [vec![0.0; modes.len()], vec![0.0; modes.len()]],
            modes,
            blocks,
            value: vec![0.0; size],
            slope: [vec![0.0; size], vec![0.0; size]],
            projection: vec![0.0; size],
            places: vec![[0.0; 2]; blocks * LANES],
            areas: vec![0.0; blocks * LANES],
        };
        let mut radial = Vec::new();
        for (p, &(place, area)) in points.iter().enumerate() {
            basis.places[p] = place;
            basis.areas[p] = area;
            if p % ring == 0 {
                radial = (0..basis.modes.len()).map(|j| basis.along(j, place)).collect();
            }
            for j in 0..basis.modes.len() {
                let [f, first, second] = basis.around(j, place, radial[j]);
                let at = basis.index(p, j);
                basis.value[at] = f;
                basis.slope[0][at] = first;
                basis.slope[1][at] = second;
                basis.norm[j] += area * f * f;
                basis.lever[0][j] += area * place[0] * f;
                basis.lever[1][j] += area * place[1] * f;
            }
        }
        for p in 0..points.len() {
            for j in 0..basis.modes.len() {
                let at = basis.index(p, j);
                basis.projection[at] = basis.areas[p] * basis.value[at] / basis.norm[j];
            }
        }
        // With cosines alone the two halves of the plan cancel each other's lever along y.
        if basis.modes.iter().all(|mode| !mode.sine) {
            basis.lever[1].fill(0.0);
        }
        basis
    }

    pub(super) fn index(&self, point: usize, mode: usize) -> usize {
        (point / LANES * self.modes.len() + mode) * LANES + point % LANES
    }

    /// The modes, the constant first.
    pub fn modes(&self) -> &[Mode] {
        &self.modes
    }

    /// Plan of the tank.
    pub fn shape(&self) -> Shape {
        self.shape
    }

    /// Area of the surface [m²].
    pub fn area(&self) -> f64 {
        self.areas.iter().sum()
    }

    /// A mode at a place: its value, and its slopes along r and θ (cylinder) or x (strip) [1/m].
    pub fn at(&self, mode: usize, place: Place) -> [f64; 3] {
        self.around(mode, place, self.along(mode, place))
    }

    /// The same but for the factors cos mθ, sin mθ of a cylinder.
    fn along(&self, mode: usize, place: Place) -> [f64; 3] {
        let Mode { wave_number: k, harmonic: m, .. } = self.modes[mode];
        match self.shape {
            Shape::Strip { length, .. } => {
                let phase = k * (place[0] + 0.5 * length);
                // cos nπ(x/L + ½) is (−1)ⁿ at x = +L/2: the sign makes it 1 there, where the wave of +x stands.
                let sign = if m % 2 == 0 { 1.0 } else { -1.0 };
                [sign * phase.cos(), -sign * k * phase.sin(), 0.0]
            }
            Shape::Cylinder { .. } if k == 0.0 => [1.0, 0.0, 0.0],
            Shape::Cylinder { radius } => {
                let r = place[0].hypot(place[1]);
                let wall = bessel_j(m, k * radius);
                let [before, j, after] = [m - 1, m, m + 1].map(|m| bessel_j(m, k * r) / wall);
                // m J_m(kr)/r without a division by a radius of zero.
                let over = if m == 0 { 0.0 } else { 0.5 * k * (before + after) };
                [j, 0.5 * k * (before - after), over]
            }
        }
    }

    /// With those factors.
    fn around(&self, mode: usize, place: Place, [value, slope, over]: [f64; 3]) -> [f64; 3] {
        let Mode { harmonic: m, sine, .. } = self.modes[mode];
        if let Shape::Strip { .. } = self.shape {
            return [value, slope, over];
        }
        let (sin, cos) = (f64::from(m) * place[1].atan2(place[0])).sin_cos();
        let (around, along) = if sine { (sin, cos) } else { (cos, -sin) };
        [value * around, slope * around, over * along]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_modes_are_orthogonal_on_their_points() {
        for basis in
            [Basis::cylinder(2.0, 4, Side::Cosine), Basis::cylinder(2.0, 4, Side::Both), Basis::strip(1.7, 0.4, 16)]
        {
            for i in 0..basis.modes.len() {
                for j in 0..basis.modes.len() {
                    let product: f64 = (0..basis.places.len())
                        .map(|p| basis.projection[basis.index(p, i)] * basis.value[basis.index(p, j)])
                        .sum();
                    assert!((product - f64::from(i == j)).abs() < 1e-9, "{i}, {j}: {product}");
                }
            }
        }
        assert!((Basis::cylinder(2.0, 4, Side::Cosine).area() - 4.0 * PI).abs() < 1e-12);
    }

    #[test]
    fn slopes_are_the_derivatives() {
        let basis = Basis::cylinder(1.5, 4, Side::Both);
        let (r, angle, h) = (0.7_f64, 0.4_f64, 1e-5);
        let place = |r: f64, angle: f64| [r * angle.cos(), r * angle.sin()];
        for j in 0..basis.modes.len() {
            let [_, radial, tangential] = basis.at(j, place(r, angle));
            let value = |r, angle| basis.at(j, place(r, angle))[0];
            let first = (value(r + h, angle) - value(r - h, angle)) / (2.0 * h);
            let second = (value(r, angle + h) - value(r, angle - h)) / (2.0 * h * r);
            assert!((radial - first).abs() < 1e-7 && (tangential - second).abs() < 1e-7, "mode {j}");
        }
    }
}
