//! A rigid foundation in layered soil, by cones with reflection and refraction.
//!
//! A disc sends waves up and down, each a cone whose opening belongs to the soil and the motion:
//!
//! ```text
//! translation  z₀/R = π (2 − ν)/8           u(x) = u₀ z₀/(z₀ + x) e^{−iωx/c}                            c = V_s
//! rocking      z₀/R = 9π (1 − ν)(c/V_s)²/32 ϑ(x) ∝ (1/(z₀ + x)³ + iω/(c (z₀ + x)²)) e^{−iωx/c}         c of [`Soil::cone_velocity`]
//! stiffness    S_x = ρ c² π R²/z₀ (1 + i b₀)    S_θ = 3 ρ c² I₀/z₀ (1 − b₀²/(3 (1 + b₀²)) + i b₀³/(3 (1 + b₀²)))      b₀ = ω z₀/c
//! ```
//!
//! Where a wave meets an interface with the radius R' it has reached, S₁ and S₂ are the stiffnesses of discs of R' on either side:
//! u_r = (S₁ − S₂)/(S₁ + S₂) u_i goes back, u_i + u_r goes on; at the free surface S₂ = 0. Waves of the same radius at the same interface add.
//! An embedded foundation is a stack of discs over its depth e with the flexibility G of their waves; between them the soil moves as a rigid body,
//! whose inertia is taken out:
//!
//! ```text
//! S = Aᵀ G⁻¹ A + ω² M_e             A: translation 1, rotation about the underside: arm, and rocking of each disc
//! ```
//!
//! Material damping by the correspondence principle, V_s √(1 + 2iξ). Source: Meek & Wolf 1992 and 1994; Wolf & Deeks 2004. Within 6 % of
//! the static formulas of Pais & Kausel 1988 up to an embedment of R for ν from 0.25 to 0.45; 10 % in translation and 19 % in rocking at ν = 0.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use crate::C64;
use crate::disc::{Disc, Soil};
use crate::error::{SoilError, not_negative, positive};
use crate::structure::{Effective, Structure, effective};

/// Discs over a radius of embedment, and at least this many over any.
const DISCS: usize = 8;
/// Amplitude at which a wave is lost, over that at its disc.
const LOST: f64 = 1e-5;
/// Reflections at most.
const GENERATIONS: usize = 400;
/// Places and radii that differ less are the same, over the radius of the foundation.
const SAME: f64 = 1e-7;

/// A layer of soil.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layer {
    /// Thickness [m].
    pub thickness: f64,
    /// Its soil; [`Soil::depth`] is not used.
    pub soil: Soil,
}

/// A cylinder of soil replaced by a rigid foundation.
#[derive(Clone, Debug, PartialEq)]
pub struct Embedded {
    /// Radius R [m].
    pub radius: f64,
    /// Depth e of the underside below the ground [m].
    pub embedment: f64,
    /// Layers from the ground down.
    pub layers: Vec<Layer>,
    /// The half-space below them.
    pub below: Soil,
}

/// Impedance of x and ψ about the underside: [N/m], [N], [N m].
pub type Matrix2 = [[C64; 2]; 2];

#[derive(Clone, Copy, PartialEq)]
enum Motion {
    Translation,
    Rocking,
}

/// A soil for one kind of wave.
#[derive(Clone, Copy)]
struct Medium {
    density: f64,
    /// c, with its damping.
    velocity: C64,
    /// z₀/R.
    aspect: f64,
    motion: Motion,
}

impl Medium {
    fn of(soil: &Soil, motion: Motion) -> Medium {
        let nu = soil.poisson_ratio;
        let ratio = soil.cone_velocity() / soil.shear_wave_velocity;
        let (speed, aspect) = match motion {
            Motion::Translation => (1.0, PI * (2.0 - nu) / 8.0),
            Motion::Rocking => (ratio, 9.0 * PI / 32.0 * (1.0 - nu) * ratio * ratio),
        };
        let turned = C64::new(1.0, 2.0 * soil.damping).sqrt();
        Medium { density: soil.density, velocity: turned * (speed * soil.shear_wave_velocity), aspect, motion }
    }

    /// Stiffness of a disc of this radius on one side.
    fn stiffness(&self, radius: f64, omega: f64) -> C64 {
        let z0 = self.aspect * radius;
        let modulus = self.velocity * self.velocity * self.density;
        let b = omega * z0 / self.velocity;
        let i = C64::new(0.0, 1.0);
        match self.motion {
            Motion::Translation => modulus * (PI * radius * radius / z0) * (1.0 + i * b),
            Motion::Rocking => {
                let share = b * b / (1.0 + b * b) / 3.0;
                modulus * (3.0 * PI * radius.powi(4) / (4.0 * z0)) * (1.0 - share + i * b * share)
            }
        }
    }

    /// Amplitude after a distance, over that at a disc of this radius, and the radius there.
    fn travels(&self, radius: f64, distance: f64, omega: f64) -> (C64, f64) {
        let z0 = self.aspect * radius;
        let x = z0 + distance;
        let i = C64::new(0.0, 1.0);
        let spread = match self.motion {
            Motion::Translation => C64::new(z0 / x, 0.0),
            Motion::Rocking => {
                let shape = |x: f64| 1.0 / x.powi(3) + i * omega / (self.velocity * x * x);
                shape(x) / shape(z0)
            }
        };
        (spread * (-i * omega * distance / self.velocity).exp(), radius * x / z0)
    }
}

/// A stack of interfaces: places, the medium between each and the next, and that below the last.
struct Stack {
    places: Vec<f64>,
    between: Vec<Medium>,
    below: Medium,
}

impl Stack {
    /// Stiffness of the side of an interface that a wave meets going `down` or up; 0 above the ground.
    fn beyond(&self, place: usize, down: bool, radius: f64, omega: f64) -> C64 {
        match self.medium(place, down) {
            Some(medium) => medium.stiffness(radius, omega),
            None => C64::new(0.0, 0.0),
        }
    }

    fn medium(&self, place: usize, down: bool) -> Option<&Medium> {
        match down {
            true => Some(self.between.get(place).unwrap_or(&self.below)),
            false => place.checked_sub(1).map(|above| &self.between[above]),
        }
    }

    /// Displacement of every interface under a unit force on a disc of this radius at one of them.
    fn flexibility(&self, source: usize, radius: f64, omega: f64) -> Vec<C64> {
        let mut moved = vec![C64::new(0.0, 0.0); self.places.len()];
        let both = self.beyond(source, true, radius, omega) + self.beyond(source, false, radius, omega);
        let first = both.inv();
        moved[source] += first;
        let quantum = SAME * radius;
        // By interface, way and radius in quanta.
        let mut waves: BTreeMap<(usize, bool, u64), (f64, C64)> = BTreeMap::new();
        for down in [false, true] {
            if self.medium(source, down).is_some() {
                waves.insert((source, down, 0), (radius, first));
            }
        }
        for _ in 0..GENERATIONS {
            let mut next: BTreeMap<(usize, bool, u64), (f64, C64)> = BTreeMap::new();
            for ((place, down, _), (radius, amplitude)) in waves {
                let Some(medium) = self.medium(place, down) else { continue };
                // Nothing comes back from the half-space.
                if down && place + 1 == self.places.len() {
                    continue;
                }
                let there = if down { place + 1 } else { place - 1 };
                let distance = (self.places[there] - self.places[place]).abs();
                let (share, reached) = medium.travels(radius, distance, omega);
                let incident = amplitude * share;
                if incident.norm() < LOST * first.norm() {
                    continue;
                }
                let (own, other) = (medium.stiffness(reached, omega), self.beyond(there, down, reached, omega));
                let back = (own - other) / (own + other) * incident;
                moved[there] += incident + back;
                let key = (reached / quantum).round() as u64;
                for (way, amplitude) in [(!down, back), (down, incident + back)] {
                    if amplitude.norm() > LOST * LOST * first.norm() {
                        next.entry((there, way, key)).or_insert((reached, C64::new(0.0, 0.0))).1 += amplitude;
                    }
                }
            }
            waves = next;
            if waves.is_empty() {
                break;
            }
        }
        moved
    }
}

impl Embedded {
    /// A foundation in soil.
    ///
    /// Errors: as [`Disc::new`] for every soil; a thickness that is not above 0; a negative embedment.
    pub fn new(radius: f64, embedment: f64, layers: Vec<Layer>, below: Soil) -> Result<Embedded, SoilError> {
        not_negative("embedment [m]", embedment)?;
        for soil in layers.iter().map(|layer| layer.soil).chain([below]) {
            Disc::new(radius, Soil { depth: None, ..soil })?;
        }
        for layer in &layers {
            positive("thickness of a layer of soil [m]", layer.thickness)?;
        }
        Ok(Embedded { radius, embedment, layers, below })
    }

    /// Depths of the discs.
    fn discs(&self) -> Vec<f64> {
        if self.embedment <= SAME * self.radius {
            return vec![0.0];
        }
        let parts = DISCS.max((DISCS as f64 * self.embedment / self.radius).ceil() as usize);
        (0..=parts).map(|k| self.embedment * k as f64 / parts as f64).collect()
    }

    fn soil_at(&self, depth: f64) -> &Soil {
        let mut bottom = 0.0;
        for layer in &self.layers {
            bottom += layer.thickness;
            if depth < bottom {
                return &layer.soil;
            }
        }
        &self.below
    }

    fn stack(&self, discs: &[f64], motion: Motion) -> Stack {
        let mut bottom = 0.0;
        let ends = self.layers.iter().map(|layer| {
            bottom += layer.thickness;
            bottom
        });
        let mut places: Vec<f64> = std::iter::once(0.0).chain(ends).chain(discs.iter().copied()).collect();
        places.sort_by(f64::total_cmp);
        places.dedup_by(|a, b| *a - *b < SAME * self.radius);
        let between = places.windows(2).map(|p| Medium::of(self.soil_at(0.5 * (p[0] + p[1])), motion)).collect();
        let last = places[places.len() - 1];
        let below = Medium::of(self.soil_at(last + SAME * self.radius), motion);
        Stack { places, between, below }
    }

    /// Inverse of the flexibility of the discs.
    fn dynamic_stiffness(&self, discs: &[f64], motion: Motion, omega: f64) -> Vec<Vec<C64>> {
        let stack = self.stack(discs, motion);
        let place = |depth: &f64| {
            let away = |p: &f64| (p - depth).abs();
            let nearest = stack.places.iter().enumerate().min_by(|a, b| away(a.1).total_cmp(&away(b.1)));
            nearest.map_or(0, |(k, _)| k)
        };
        let places: Vec<usize> = discs.iter().map(place).collect();
        let columns = places.iter().map(|&source| {
            let moved = stack.flexibility(source, self.radius, omega);
            places.iter().map(|&p| moved[p]).collect::<Vec<C64>>()
        });
        inverse(columns.collect())
    }

    /// S(ω), symmetric.
    pub fn impedance(&self, omega: f64) -> Matrix2 {
        let discs = self.discs();
        let along = self.dynamic_stiffness(&discs, Motion::Translation, omega);
        let turned = self.dynamic_stiffness(&discs, Motion::Rocking, omega);
        let arm = |k: usize| self.embedment - discs[k];
        let mut s = [[C64::new(0.0, 0.0); 2]; 2];
        for (i, row) in along.iter().enumerate() {
            for (j, value) in row.iter().enumerate() {
                // Waves up and down between two discs differ by what the cones leave out: the mean of both ways.
                let value = 0.5 * (value + along[j][i]);
                s[0][0] += value;
                s[0][1] += value * arm(j);
                s[1][1] += value * arm(i) * arm(j);
            }
        }
        s[1][1] += turned.iter().flatten().sum::<C64>();
        let [m, first, second] = self.excavated(&discs);
        s[0][0] += omega * omega * m;
        s[0][1] += omega * omega * first;
        s[1][1] += omega * omega * second;
        s[1][0] = s[0][1];
        s
    }

    /// Moment of inertia of the soil below the underside that rocks with it [kg m²].
    pub fn trapped_inertia(&self) -> f64 {
        Disc { radius: self.radius, soil: *self.soil_at(self.embedment) }.cones().trapped_inertia
    }

    /// Mass, first and second moment about the underside of the soil that the foundation replaces.
    fn excavated(&self, discs: &[f64]) -> [f64; 3] {
        let (r, e) = (self.radius, self.embedment);
        let mut sum = [0.0; 3];
        for pair in discs.windows(2) {
            let (above, below) = (e - pair[0], e - pair[1]);
            let mass = self.soil_at(0.5 * (pair[0] + pair[1])).density * PI * r * r * (above - below);
            let middle = 0.5 * (above + below);
            sum[0] += mass;
            sum[1] += mass * middle;
            sum[2] += mass * (r * r / 4.0 + middle * middle + (above - below).powi(2) / 12.0);
        }
        sum
    }

    /// T̃ and ξ̃ of a structure on it, its arm above the underside, as [`crate::structure::OnSoil::effective`].
    ///
    /// Errors: no convergence.
    pub fn effective(&self, structure: &Structure) -> Result<Effective, SoilError> {
        let h = structure.height;
        effective(structure, std::f64::consts::TAU / structure.period, |omega| {
            let [[a, b], [_, d]] = self.impedance(omega);
            // (1, h) S⁻¹ (1, h)ᵀ
            (d - 2.0 * h * b + h * h * a) / (a * d - b * b)
        })
    }
}

/// Inverse by Gauss-Jordan elimination; the flexibility of discs has its largest entries on the diagonal.
fn inverse(mut a: Vec<Vec<C64>>) -> Vec<Vec<C64>> {
    let n = a.len();
    let mut out: Vec<Vec<C64>> =
        (0..n).map(|i| (0..n).map(|j| C64::new(f64::from(u8::from(i == j)), 0.0)).collect()).collect();
    for k in 0..n {
        let pivot = a[k][k].inv();
        for j in 0..n {
            a[k][j] *= pivot;
            out[k][j] *= pivot;
        }
        for i in (0..n).filter(|i| *i != k) {
            let factor = a[i][k];
            for j in 0..n {
                let (from, to) = (a[k][j], out[k][j]);
                a[i][j] -= factor * from;
                out[i][j] -= factor * to;
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::disc::Impedance;

    fn soil(velocity: f64, poisson_ratio: f64, damping: f64) -> Soil {
        Soil { density: 1900.0, shear_wave_velocity: velocity, poisson_ratio, damping, depth: None }
    }

    fn layer(thickness: f64, soil: Soil) -> Layer {
        Layer { thickness, soil }
    }

    /// Layers of the same soil are the half-space: the impedance of the cones, in closed form.
    #[test]
    fn equal_layers_are_the_half_space() {
        for damping in [0.0, 0.05] {
            let own = soil(200.0, 1.0 / 3.0, damping);
            let found = Embedded::new(10.0, 0.0, vec![layer(7.0, own), layer(3.0, own)], own).unwrap();
            let disc = Disc::new(10.0, soil(200.0, 1.0 / 3.0, 0.0)).unwrap();
            for omega in [1.0, 20.0, 60.0] {
                let [[x, coupling], [_, turned]] = found.impedance(omega);
                // The correspondence principle takes ω over √(1 + 2iξ) for a complex frequency; without damping both are the same.
                if damping == 0.0 {
                    let expected = disc.horizontal(omega, Impedance::Cone);
                    assert!((x / expected - 1.0).norm() < 1e-12, "{omega}: {x} {expected}");
                    let expected = disc.rocking(omega, Impedance::Cone);
                    assert!((turned / expected - 1.0).norm() < 1e-12, "{omega}: {turned} {expected}");
                } else if omega == 1.0 {
                    // Slow: K (1 + 2iξ), the radiation of a₀ = 0.05 beside it.
                    let expected = disc.horizontal(omega, Impedance::Cone) * C64::new(1.0, 0.1);
                    assert!((x / expected - 1.0).norm() < 5e-3);
                }
                assert_eq!(coupling, C64::new(0.0, 0.0));
            }
        }
    }

    /// A layer on rock at rest: the unfolded cone, 1/(1 + 2 Σ (−1)^j/(1 + 2 j d/z₀)) in closed form (Meek & Wolf 1992), the sum to 2e5 terms with half
    /// of the next; rock of 3000 m/s gives way by (200/3000)². Gazetas' K_x (1 + R/2d) is another formula: 5 %.
    #[test]
    fn a_layer_on_rock_is_the_unfolded_cone() {
        let rock = Soil { density: 2700.0, ..soil(3e5, 1.0 / 3.0, 0.0) };
        for depth in [10.0, 20.0, 40.0] {
            let own = soil(200.0, 1.0 / 3.0, 0.0);
            let found = Embedded::new(10.0, 0.0, vec![layer(depth, own)], rock).unwrap().impedance(1e-3);
            let disc = Disc::new(10.0, own).unwrap();
            let kappa = depth / (PI * (2.0 - 1.0 / 3.0) / 8.0 * 10.0);
            let term = |j: u32| if j.is_multiple_of(2) { 1.0 } else { -1.0 } / (1.0 + 2.0 * f64::from(j) * kappa);
            let sum: f64 = (1..=200_000).map(term).sum::<f64>() + 0.5 * term(200_001);
            let ratio = found[0][0].re / disc.stiffness().horizontal;
            // Waves below 1e-5 of the first are lost: half of the last one at most.
            assert!((ratio * (1.0 + 2.0 * sum) - 1.0).abs() < 1e-4 + 0.02 / kappa, "{depth}: {ratio} {sum}");
            assert!((ratio / (1.0 + 5.0 / depth) - 1.0).abs() < 0.05, "{depth}: {ratio}");
        }
    }

    /// Static stiffness of an embedded cylinder after Pais & Kausel 1988: K_x (1 + e/R), K_θ (1 + 2.3 e/R + 0.58 (e/R)³). Cones of discs are
    /// known to be within 20 % (Wolf & Deeks 2004); 10 % in translation and 20 % in rocking up to e = R.
    #[test]
    fn an_embedded_cylinder_is_near_pais_and_kausel() {
        for nu in [0.25, 1.0 / 3.0, 0.45] {
            for ratio in [0.25, 0.5, 1.0] {
                let own = soil(200.0, nu, 0.0);
                let s = Embedded::new(10.0, 10.0 * ratio, Vec::new(), own).unwrap().impedance(1e-3);
                let disc = Disc::new(10.0, own).unwrap().stiffness();
                let x = s[0][0].re / (disc.horizontal * (1.0 + ratio));
                let turned = s[1][1].re / (disc.rocking * (1.0 + 2.3 * ratio + 0.58 * ratio.powi(3)));
                assert!((x - 1.0).abs() < 0.1 && (turned - 1.0).abs() < 0.2, "{nu} {ratio}: {x} {turned}");
                // The sides alone would hold it at half of the depth, the underside alone at none; Pais & Kausel have 0.28 to 0.37.
                let height = s[0][1].re / s[0][0].re / (10.0 * ratio);
                assert!((0.1..0.4).contains(&height), "{height}");
            }
        }
    }

    /// A fast layer over a slow one is between both half-spaces, and radiates.
    #[test]
    fn two_layers_are_between_their_half_spaces() {
        let (stiff, soft) = (soil(300.0, 0.3, 0.0), soil(150.0, 0.3, 0.0));
        let of = |layers, below| Embedded::new(10.0, 0.0, layers, below).unwrap().impedance(5.0);
        let [low, both, high] = [of(vec![], soft), of(vec![layer(5.0, stiff)], soft), of(vec![], stiff)];
        for k in [0, 1] {
            assert!(low[k][k].re < both[k][k].re && both[k][k].re < high[k][k].re);
            assert!(both[k][k].im > 0.0);
        }
    }

    #[test]
    fn impossible_layers_are_errors() {
        let own = soil(200.0, 0.3, 0.0);
        assert!(Embedded::new(10.0, -1.0, Vec::new(), own).is_err());
        assert!(Embedded::new(10.0, 0.0, vec![layer(0.0, own)], own).is_err());
        assert!(Embedded::new(10.0, 0.0, vec![layer(1.0, soil(200.0, 0.5, 0.0))], own).is_err());
    }
}
