//! The bottom plate dragged along the ground: shear of the wall against its displacement.
//!
//! ```text
//! u_r = U(r) cos θ ,  u_θ = −W(r) sin θ          W(R) = s           displacement of the wall's foot along θ = 0
//! ε_r = U′ ,  ε_θ = e = (U − W)/r ,  γ = W′ + e                      plane stress of the plate, E′ and ν, per cos θ and sin θ
//! τ = k (u − u_p) ,  |τ| ≤ μ p                                       friction of the ground at each place
//! V = ∂/∂s of the work of plate and ground
//! ```
//!
//! The wall hands its shear over along its foot, n_xθ = V sin θ/(πR); a thin plate spreads it over as much of the ground as friction needs,
//! and slips under the wall long before the tank slides. V(s) ends at μ N. Elastic parts with friction in series and in parallel turn round by
//! Masing's rule where the pressure does not change (Iwan 1966), so that V(s) is a chain of springs with friction.
//!
//! The limit is that of the pressure at rest, and of the weight of the wall under its foot. Lifted parts and the pressure of the motion move
//! the forces of the ground around without changing their sum; that is left out. The ground is as stiff along its surface as across it.

use std::f64::consts::{PI, TAU};

use crate::band::Band;
use crate::error::BaseError;
use crate::law::Spring;
use crate::model::Base;

/// Elements from the axis to the wall; lengths grow from the wall on.
const ELEMENTS: usize = 80;
const GROWTH: f64 = 1.6;
/// Places over a quarter of the circumference at which friction is asked.
const PLACES: usize = 8;
/// Displacements of the curve up to where all of the plate slips, and the factor from one to the next.
const MOST: usize = 60;
const NEXT: f64 = 1.25;
/// Share of μ N at which the curve ends.
const FULL: f64 = 0.995;
const ITERATIONS: usize = 60;
/// Shortest part of an increment that overshoots: the work of plate and friction is convex, so that some part does not.
const SHORTEST: f64 = 1e-6;

/// Shear against displacement under a growing force.
#[derive(Clone, Debug, PartialEq)]
pub struct Drag {
    /// (s [m], V [N]), rising from 0.
    points: Vec<(f64, f64)>,
    /// μ N [N].
    limit: f64,
}

struct Plate {
    radii: Vec<f64>,
    /// t E′, ν and t G of each element.
    stiff: Vec<[f64; 3]>,
    /// Area of each node [m²], and the largest friction on it [N].
    areas: Vec<(f64, f64)>,
    modulus: f64,
    /// Radial stiffness of the wall's edge against its foot, π R k₁₁ [N/m].
    edge: f64,
}

impl Drag {
    /// The plate of a base with a coefficient of friction μ > 0.
    ///
    /// Errors: no equilibrium.
    pub fn of(base: &Base, coefficient: f64) -> Result<Drag, BaseError> {
        Drag::meshed(base, coefficient, ELEMENTS, PLACES)
    }

    pub(crate) fn meshed(base: &Base, coefficient: f64, elements: usize, places: usize) -> Result<Drag, BaseError> {
        let plate = Plate::new(base, coefficient, elements);
        let limit = plate.areas.iter().map(|a| a.1).sum::<f64>();
        let mut x = vec![0.0; 2 * plate.radii.len()];
        let failed = |s: f64| BaseError::Parameter {
            name: "displacement of the bottom plate along the ground",
            value: s,
            allowed: "an equilibrium within the iterations of a step",
        };
        // Elastic, scaled to the first place that slips.
        let unit = plate.settle(&mut x, 1.0, places, f64::INFINITY).ok_or(failed(1.0))?;
        let first = plate.first_slip(&x);
        x.iter_mut().for_each(|v| *v *= first);
        let mut points = vec![(0.0, 0.0), (first, unit * first)];
        let mut s = first;
        while points.last().is_some_and(|p| p.1 < FULL * limit) && points.len() < MOST {
            let next = NEXT * s;
            x.iter_mut().for_each(|v| *v *= next / s);
            s = next;
            points.push((s, plate.settle(&mut x, s, places, 1.0).ok_or(failed(s))?));
        }
        Ok(Drag { points, limit })
    }

    /// V under a displacement s ≥ 0 that grows from rest [N].
    pub fn shear(&self, s: f64) -> f64 {
        let after = self.points.partition_point(|p| p.0 < s);
        match (after.checked_sub(1).map(|i| self.points[i]), self.points.get(after)) {
            (Some(a), Some(b)) => a.1 + (b.1 - a.1) * (s - a.0) / (b.0 - a.0),
            (Some(last), None) => last.1,
            _ => 0.0,
        }
    }

    /// μ N, which the plate does not pass [N].
    pub fn limit(&self) -> f64 {
        self.limit
    }

    /// dV/ds before any slip [N/m].
    pub fn stiffness(&self) -> f64 {
        self.points[1].1 / self.points[1].0
    }

    /// The curve as a chain of springs that slip one after another; together they hold μ N.
    pub fn springs(&self) -> Vec<Spring> {
        let mut chords: Vec<(f64, f64)> =
            self.points.windows(2).map(|p| (p[1].0, (p[1].1 - p[0].1) / (p[1].0 - p[0].0))).collect();
        for i in 1..chords.len() {
            chords[i].1 = chords[i].1.min(chords[i - 1].1);
        }
        chords.push((f64::INFINITY, 0.0));
        let mut springs: Vec<Spring> = chords
            .windows(2)
            .filter(|c| c[0].1 > c[1].1)
            .map(|c| Spring { stiffness: c[0].1 - c[1].1, limit: (c[0].1 - c[1].1) * c[0].0 })
            .collect();
        // What is left between the end of the curve and μ N.
        let held: f64 = springs.iter().map(|s| s.limit).sum();
        for spring in &mut springs {
            spring.limit *= self.limit / held;
            spring.stiffness *= self.limit / held;
        }
        springs
    }
}

impl Plate {
    fn new(base: &Base, coefficient: f64, elements: usize) -> Plate {
        let radius = base.radius;
        let at = |i: usize| radius * (1.0 - ((elements - i) as f64 / elements as f64).powf(GROWTH));
        let radii: Vec<f64> = (0..=elements).map(at).collect();
        let middles: Vec<f64> = radii.windows(2).map(|r| 0.5 * (r[0] + r[1])).collect();
        let stiff = middles
            .iter()
            .map(|r| {
                let plate = base.plate_at(radius - r);
                let (e, nu, t) = (plate.young_modulus, plate.poisson_ratio, plate.thickness);
                [t * plate.plane_modulus(), nu, t * e / (2.0 * (1.0 + nu))]
            })
            .collect();
        let edges: Vec<f64> = std::iter::once(0.0).chain(middles).chain([radius]).collect();
        let last = elements;
        let areas = edges
            .windows(2)
            .enumerate()
            .map(|(i, r)| {
                let area = PI * (r[1] * r[1] - r[0] * r[0]);
                let wall = if i == last { TAU * radius * base.weight } else { 0.0 };
                (area, coefficient * (base.pressure * area + wall))
            })
            .collect();
        Plate { radii, stiff, areas, modulus: base.modulus, edge: PI * radius * base.edge_stiffness() }
    }

    /// Factor on the displacements `x` at which the first place slips.
    fn first_slip(&self, x: &[f64]) -> f64 {
        let ratio = |(i, (area, limit)): (usize, &(f64, f64))| {
            let most = x[2 * i].abs().max(x[2 * i + 1].abs());
            limit / (self.modulus * area * most)
        };
        self.areas.iter().enumerate().map(ratio).fold(f64::INFINITY, f64::min)
    }

    /// Equilibrium under W(R) = s from the start `x` = (U, W) of the nodes; the shear V. Friction holds `hold` times its limit.
    fn settle(&self, x: &mut [f64], s: f64, places: usize, hold: f64) -> Option<f64> {
        let n = x.len();
        x[n - 1] = s;
        let (mut force, mut tangent) = self.forces(x, s, places, hold);
        for _ in 0..ITERATIONS {
            // The wall pushes the plate along its foot and across it.
            let shear = force[n - 1] - self.edge * (x[n - 2] - s);
            let mut change: Vec<f64> = force.iter().map(|f| -f).collect();
            change[n - 1] = 0.0;
            let off = change.iter().fold(0.0_f64, |m, f| m.max(f.abs()));
            if off <= 1e-9 * shear.abs() {
                return Some(shear);
            }
            tangent.fix(n - 1);
            if !tangent.solve(&mut change) {
                return None;
            }
            let slope = |force: &[f64]| -> f64 { change.iter().zip(force).map(|(d, f)| d * f).sum() };
            let (before, descent) = (x.to_vec(), -slope(&force));
            let mut share = 1.0;
            (force, tangent) = loop {
                x.iter_mut().zip(before.iter().zip(&change)).for_each(|(x, (x0, d))| *x = x0 + share * d);
                let next = self.forces(x, s, places, hold);
                if share < SHORTEST || slope(&next.0) <= 0.5 * descent {
                    break next;
                }
                share *= 0.5;
            };
        }
        None
    }

    /// Forces on the nodes and their derivatives; the wall holds U(R) against W(R) = s.
    fn forces(&self, x: &[f64], s: f64, places: usize, hold: f64) -> (Vec<f64>, Band) {
        let n = x.len();
        let (mut force, mut tangent) = (vec![0.0; n], Band::new(n));
        self.plate(x, &mut force, &mut tangent);
        self.ground(x, places, hold, &mut force, &mut tangent);
        force[n - 2] += self.edge * (x[n - 2] - s);
        tangent.add(n - 2, n - 2, self.edge);
        (force, tangent)
    }

    fn plate(&self, x: &[f64], force: &mut [f64], tangent: &mut Band) {
        for (i, [normal, nu, shear]) in self.stiff.iter().enumerate() {
            let (a, b) = (self.radii[i], self.radii[i + 1]);
            let (length, r) = (b - a, 0.5 * (a + b));
            // U′, e and γ of U₁, W₁, U₂, W₂ at the middle.
            let half = 0.5 / r;
            let stretch = [-1.0 / length, 0.0, 1.0 / length, 0.0];
            let hoop = [half, -half, half, -half];
            let angle = [half, -1.0 / length - half, half, 1.0 / length - half];
            let weight = PI * r * length;
            let mut block = [[0.0; 4]; 4];
            for (p, row) in block.iter_mut().enumerate() {
                for (q, value) in row.iter_mut().enumerate() {
                    *value = weight
                        * (normal
                            * (stretch[p] * stretch[q]
                                + hoop[p] * hoop[q]
                                + nu * (stretch[p] * hoop[q] + hoop[p] * stretch[q]))
                            + shear * angle[p] * angle[q]);
                }
            }
            let own = &x[2 * i..2 * i + 4];
            for (f, row) in force[2 * i..].iter_mut().zip(&block) {
                *f += row.iter().zip(own).map(|(k, x)| k * x).sum::<f64>();
            }
            tangent.add_block(2 * i, &block);
        }
    }

    fn ground(&self, x: &[f64], places: usize, hold: f64, force: &mut [f64], tangent: &mut Band) {
        for (i, (area, limit)) in self.areas.iter().enumerate() {
            let (k, most) = (self.modulus * area / places as f64, hold * limit / places as f64);
            let mut block = [[0.0; 2]; 2];
            for place in 0..places {
                let (sin, cos) = (0.25 * TAU * (place as f64 + 0.5) / places as f64).sin_cos();
                // −u_θ = W sin θ.
                let u = [x[2 * i] * cos, x[2 * i + 1] * sin];
                let size = u[0].hypot(u[1]);
                let slips = k * size > most;
                let secant = if slips { most / size } else { k };
                let turn = [cos, sin];
                for p in 0..2 {
                    force[2 * i + p] += secant * u[p] * turn[p];
                    for q in 0..2 {
                        let unit = if p == q { 1.0 } else { 0.0 };
                        let along = if slips { u[p] * u[q] / (size * size) } else { 0.0 };
                        block[p][q] += secant * (unit - along) * turn[p] * turn[q];
                    }
                }
            }
            tangent.add_block(2 * i, &block);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tank::reference::{case, material};
    use tank::{Bottom, Shape, Support};

    /// A steel tank of 17.5 m with 12 m of water on a plate of one thickness [m].
    fn base(thickness: f64) -> Base {
        let mut steel = material(205e9, 0.3, 7850.0);
        steel.yield_strength = Some(250e6);
        let courses = [12e-3, 10e-3, 8e-3].map(|t| (4.5, t));
        let mut case = case(Shape::Cylinder { radius: 17.5 }, &courses, &steel, (1000.0, 12.0));
        case.tank.support = Support::Unanchored;
        case.tank.bottom = Some(Bottom {
            thickness,
            corrosion: 0.0,
            width: None,
            sketch: None,
            projection: 0.0,
            subgrade_modulus: Some(1e8),
            material: steel,
        });
        Base::of(&case).unwrap()
    }

    /// I₁ and its derivative by their series.
    fn bessel(x: f64) -> [f64; 2] {
        let (mut value, mut slope, mut term) = (0.0, 0.0, 0.5 * x);
        for k in 0..200_u32 {
            value += term;
            slope += term * f64::from(2 * k + 1) / x;
            term *= 0.25 * x * x / (f64::from(k + 1) * f64::from(k + 2));
        }
        [value, slope]
    }

    /// A disc in plane stress on an elastic ground, u = ∇φ + ∇ × ψ with φ = A I₁(αr) cos θ, ψ = B I₁(βr) sin θ, α² = k/(t E′), β² = k/(t G):
    /// a rim moved along by W(R) = 1 and held across by the wall's edge needs V = π ∫ k (U + W) r dr.
    fn closed(base: &Base) -> f64 {
        let (plate, r, k) = (base.plate(), base.radius, base.modulus);
        let (nu, t) = (plate.poisson_ratio, plate.thickness);
        let [normal, shear] = [plate.plane_modulus(), plate.young_modulus / (2.0 * (1.0 + nu))].map(|m| m * t);
        let (alpha, beta) = ((k / normal).sqrt(), (k / shear).sqrt());
        // U and W of A = 1 and of B = 1 at a radius.
        let at = |r: f64| {
            let ([a, da], [b, db]) = (bessel(alpha * r), bessel(beta * r));
            [[alpha * da, a / r], [b / r, beta * db]]
        };
        let h = 1e-5 * r;
        let (before, own) = (at(r - h), at(r));
        // Force across the rim per metre: t E′ (U′ + ν (U − W)/r) + k₁₁ (U − 1).
        let across = |i: usize| {
            let [u, w] = own[i];
            normal * ((u - before[i][0]) / h + nu * (u - w) / r) + base.edge_stiffness() * u
        };
        let (f, g, load) = (across(0), across(1), base.edge_stiffness());
        let det = own[0][1] * g - own[1][1] * f;
        let (a, b) = ((g - own[1][1] * load) / det, (own[0][1] * load - f) / det);
        let n = 4000;
        (0..n)
            .map(|i| r * (f64::from(i) + 0.5) / f64::from(n))
            .map(|x| (x, at(x)))
            .map(|(x, [p, q])| PI * k * (a * (p[0] + p[1]) + b * (q[0] + q[1])) * x * r / f64::from(n))
            .sum()
    }

    /// Before anything slips: 0.5 %, elements of second order of which the first is a hundredth of the decay length.
    #[test]
    fn an_elastic_plate_has_the_stiffness_of_bessel_functions() {
        for thickness in [6e-3, 12e-3, 40e-3] {
            let base = base(thickness);
            let (found, expected) = (Drag::of(&base, 0.4).unwrap().stiffness(), closed(&base));
            assert!((found / expected - 1.0).abs() < 5e-3, "{thickness}: {found} {expected}");
        }
    }

    /// All of it slips at μ (p π R² + wall), and the chain of springs holds that.
    #[test]
    fn the_plate_slides_under_friction_of_all_its_weight() {
        let base = base(8e-3);
        let drag = Drag::of(&base, 0.4).unwrap();
        let weight = PI * base.radius.powi(2) * base.pressure + TAU * base.radius * base.weight;
        assert!((drag.limit() / (0.4 * weight) - 1.0).abs() < 1e-9);
        let (springs, far) = (drag.springs(), drag.points[drag.points.len() - 1]);
        assert!(far.1 > FULL * drag.limit() && far.1 <= drag.limit());
        let held: f64 = springs.iter().map(|s| s.limit).sum();
        assert!((held / drag.limit() - 1.0).abs() < 1e-9);
        // The chain is the curve, 1 %: it ends at μ N instead of 0.995 μ N.
        for s in [1e-3, 3e-3, 1e-2] {
            let chain: f64 = springs.iter().map(|p| (p.stiffness * s).min(p.limit)).sum();
            assert!((chain / drag.shear(s) - 1.0).abs() < 1e-2, "{s}");
        }
    }

    /// The softest and the stiffest ground that an input may name: an equilibrium everywhere, and the whole friction in the end.
    #[test]
    fn any_ground_has_an_equilibrium() {
        for modulus in [1e6, 1e8, 1e10, 1e11, 1e12] {
            let mut base = base(8e-3);
            base.modulus = modulus;
            let drag = Drag::of(&base, 0.4).unwrap_or_else(|e| panic!("{modulus}: {e}"));
            let held: f64 = drag.springs().iter().map(|s| s.limit).sum();
            assert!((held / drag.limit() - 1.0).abs() < 1e-9, "{modulus}");
            assert!(drag.points.windows(2).all(|p| p[0].1 < p[1].1), "{modulus}");
        }
    }

    /// Elements half as long and twice as many places around change the curve by less than 1 %.
    #[test]
    fn elements_and_places_converge() {
        let base = base(8e-3);
        let (coarse, fine) =
            (Drag::of(&base, 0.4).unwrap(), Drag::meshed(&base, 0.4, 2 * ELEMENTS, 2 * PLACES).unwrap());
        for s in [3e-4, 1e-3, 3e-3, 1e-2, 3e-2] {
            let ratio = coarse.shear(s) / fine.shear(s);
            assert!((ratio - 1.0).abs() < 1e-2, "{s}: {ratio}");
        }
    }
}
