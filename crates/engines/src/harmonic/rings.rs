//! Stiffening rings and attachments, at their heights by the shape functions of the wall.
//!
//! ```text
//! ring    2 U = c [E A ε² + E I κ²]              ε = (m v + w)/R      κ = (1 − m²) w/R²
//! round   2 U = c/R k (w² + v²)                  m = 1: c/R k (w + v)²/2, what is left of a translation
//! mass    2 T = c/P m_a (u̇² + v̇² + ẇ²)           P: length of the wall in plan, over which m_a is spread
//! ```
//!
//! c is that of the wall, and v counts in sin mθ: ε = (v_θ + w)/R, and κ = −(w_θθ + w)/R² is the change of curvature of a circular arch
//! (Love 1927, §293; Timoshenko & Gere 1961, 7.1). With m = 1 both vanish in translation and tilt, with m = 0 the hoop stiffness
//! E A/R² is left. The axis of a ring lies in the wall's surface: eccentricity, torsion and bending out of its plane are left out.
//!
//! The shape functions hold rigid motions, so that mass, its moment and its rotational inertia about the base are exact. Rings have a
//! node of the wall at their height, at which the bending of the wall has a kink.

use tank::Tank;

use fem::linalg::Matrix;

use super::assembly::element_unknowns;
use super::wall::{LocalRow, NODAL, NODE, Wall, displacements};
use crate::fittings::round_rim;

/// A ring, an attachment, or a roof that keeps the rim round.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fitting {
    height: f64,
    /// Mass of all of it but the roof's [kg].
    mass: f64,
    stiffness: Stiffness,
}

/// What a fitting resists.
#[derive(Clone, Copy, Debug)]
enum Stiffness {
    None,
    /// E A [N] and E I [N·m²] of a ring.
    Ring([f64; 2]),
    /// k by angle of a round rim [N/m].
    Round(f64),
}

/// A fitting on its element of a wall.
pub(super) struct Placed {
    pub(super) element: usize,
    /// Mass that the harmonic moves [kg].
    pub(super) mass: f64,
    /// u, v, w there.
    pub(super) shapes: [LocalRow; 3],
    /// Stiffness, integrated over the circumference, and row of each strain.
    pub(super) strains: Vec<(f64, LocalRow)>,
}

impl Fitting {
    /// Those of a tank.
    pub(super) fn all(tank: &Tank) -> Vec<Fitting> {
        let stiffness = tank.rings.iter().map(|ring| {
            let young = ring.material.youngs_modulus;
            Stiffness::Ring([young * ring.area, young * ring.inertia])
        });
        // Attachments follow the rings.
        let stiffness = stiffness.chain(std::iter::repeat(Stiffness::None));
        let all = tank.carried().zip(stiffness).map(|((mass, height), stiffness)| Fitting { height, mass, stiffness });
        let rim =
            round_rim(tank).map(|k| Fitting { height: tank.wall_height(), mass: 0.0, stiffness: Stiffness::Round(k) });
        all.chain(rim).collect()
    }

    pub(super) fn on(&self, wall: &Wall, tank: &Tank) -> Placed {
        let (element, xi) = wall.locate(self.height, false);
        let shapes = displacements(xi, wall.elements[element].length);
        let [_, v, w] = &shapes;
        let (m, k) = (wall.wave, wall.curvature);
        let row = |f: &dyn Fn(usize) -> f64| -> LocalRow { std::array::from_fn(f) };
        let strains = match self.stiffness {
            _ if k == 0.0 => Vec::new(),
            Stiffness::None => Vec::new(),
            Stiffness::Ring([extension, bending]) => vec![
                (wall.factor * extension, row(&|i| k * (m * v[i] + w[i]))),
                (wall.factor * bending, row(&|i| k * k * (1.0 - m * m) * w[i])),
            ],
            Stiffness::Round(stiffness) if m == 1.0 => {
                vec![(0.5 * wall.factor * k * stiffness, row(&|i| v[i] + w[i]))]
            }
            Stiffness::Round(stiffness) => [w, v].map(|field| (wall.factor * k * stiffness, *field)).to_vec(),
        };
        Placed { element, mass: self.mass * wall.factor / tank.perimeter(), strains, shapes }
    }

    /// Adds mass and stiffness to the matrices of all unknowns.
    pub(super) fn add_to(
        &self,
        (wall, tank): (&Wall, &Tank),
        node: &[[Option<usize>; NODE]],
        mass: &mut Matrix,
        stiffness: &mut Matrix,
    ) {
        let placed = self.on(wall, tank);
        let element = &wall.elements[placed.element];
        let unknowns = element_unknowns(node, placed.element);
        let add = |to: &mut Matrix, factor: f64, row: &LocalRow| {
            let row: [f64; NODAL] = element.condensed_row(row);
            for (p, a) in unknowns.iter().zip(row) {
                for (q, b) in unknowns.iter().zip(row) {
                    if let (Some(p), Some(q)) = (p, q) {
                        to.add(*p, *q, factor * a * b);
                    }
                }
            }
        };
        placed.shapes.iter().for_each(|row| add(mass, placed.mass, row));
        placed.strains.iter().for_each(|(factor, row)| add(stiffness, *factor, row));
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};

    use super::*;
    use crate::harmonic::test_tanks::{broad, fit};
    use crate::harmonic::{Output, Static};
    use crate::linear::describe::mass_balance;
    use crate::linear::model::Model;
    use tank::Case;
    use tank::options::LinearOptions as Options;

    const RING: (f64, f64, f64) = (1.4, 4e-4, 2e-7);
    /// Neither a joint nor a node.
    const LADDER: (f64, f64) = (1.2345, 30.0);

    fn fitted() -> Case {
        let mut case = broad();
        fit(&mut case, RING, LADDER);
        case
    }

    /// Twice the energies of all fittings in a harmonic, of the field u, v, w, w' of z: kinetic and elastic.
    fn energies(case: &Case, harmonic: u32, field: impl Fn(f64) -> [f64; NODE]) -> [f64; 2] {
        let wall = Wall::new(&case.tank, case.liquid.fill_height, harmonic, 1.0);
        let node: Vec<[Option<usize>; NODE]> =
            (0..wall.nodes.len()).map(|n| std::array::from_fn(|k| Some(NODE * n + k))).collect();
        let size = NODE * node.len();
        let (mut mass, mut stiffness) = (Matrix::zeros(size, size), Matrix::zeros(size, size));
        for fitting in Fitting::all(&case.tank) {
            fitting.add_to((&wall, &case.tank), &node, &mut mass, &mut stiffness);
        }
        let x: Vec<f64> = wall.nodes.iter().flat_map(|z| field(*z)).collect();
        [mass, stiffness].map(|a| fem::linalg::dot(&x, &a.times(&x)))
    }

    /// Masses at their heights z: m, m z and m (z² + R²/2) in rigid motions, with neither energy in a ring.
    #[test]
    fn rigid_motions_move_the_whole_mass_and_strain_nothing() {
        let case = fitted();
        let radius = 1.83;
        let ring = TAU * radius * 2750.0 * RING.1;
        let all = [(ring, RING.0), (LADDER.1, LADDER.0)];
        let sum = |f: &dyn Fn(f64) -> f64| all.iter().map(|(m, z)| m * f(*z)).sum::<f64>();
        let translation = |_| [0.0, -1.0, 1.0, 0.0];
        let rotation = |z: f64| [-radius, -z, z, 1.0];
        let both = |z: f64| [-radius, -z - 1.0, z + 1.0, 1.0];
        let [mass, strain] = energies(&case, 1, translation);
        assert!((mass / sum(&|_| 1.0) - 1.0).abs() < 1e-12, "{mass}");
        let [inertia, tilt] = energies(&case, 1, rotation);
        assert!((inertia / sum(&|z| z * z + 0.5 * radius * radius) - 1.0).abs() < 1e-12, "{inertia}");
        let moment = 0.5 * (energies(&case, 1, both)[0] - mass - inertia);
        assert!((moment / sum(&|z| z) - 1.0).abs() < 1e-11, "{moment}");
        let [upwards, _] = energies(&case, 0, |_| [1.0, 0.0, 0.0, 0.0]);
        assert!((upwards / mass - 1.0).abs() < 1e-12);
        let stretched = energies(&case, 1, |_| [0.0, 0.0, 1.0, 0.0])[1];
        assert!(strain.abs().max(tilt.abs()) < 1e-12 * stretched, "{strain} {tilt} {stretched}");
    }

    /// Love 1927, §293: E A/R² against even expansion, E I (n² − 1)²/R⁴ against ovalling without extension.
    #[test]
    fn a_ring_resists_expansion_and_ovalling() {
        let (radius, young): (f64, f64) = (1.83, 69e9);
        let expansion = energies(&fitted(), 0, |_| [0.0, 0.0, 1.0, 0.0])[1];
        let bending = young * RING.2 / radius.powi(4);
        let exact = TAU * radius * (young * RING.1 / (radius * radius) + bending);
        assert!((expansion / exact - 1.0).abs() < 1e-12, "{expansion} {exact}");
        for n in 2..6_u32 {
            let wave = f64::from(n);
            let found = energies(&fitted(), n, |_| [0.0, -1.0 / wave, 1.0, 0.0])[1];
            let exact = PI * radius * bending * (wave * wave - 1.0).powi(2);
            assert!((found / exact - 1.0).abs() < 1e-9, "n = {n}: {found} {exact}");
        }
    }

    /// A roof that keeps the rim round holds all waves but the first: the lowest mode of eight waves of an open tank rises by more than a
    /// half, and the bulging mode of the beam moves by less than the extension of its edge, 0.5 %.
    #[test]
    fn a_round_rim_holds_the_waves() {
        let mut case = crate::harmonic::test_tanks::case(
            tank::Shape::Cylinder { radius: 10.0 },
            &[(10.0, 8e-3)],
            (210e9, 0.3, 7850.0),
            (1000.0, 6.0),
        );
        let lowest = |case: &Case, n: u32| {
            let modes = crate::modes(case, &Options::default(), &[n], 1).unwrap();
            modes.iter().find(|m| m.kind == "structural").unwrap().omega
        };
        let free = [1, 8].map(|n| lowest(&case, n));
        case.tank.roof.holds = tank::RimSupport::Round;
        let round = [1, 8].map(|n| lowest(&case, n));
        assert!(round[1] > 1.5 * free[1], "{free:?} {round:?}");
        assert!((round[0] / free[0] - 1.0).abs() < 5e-3, "{free:?} {round:?}");
    }

    /// The masses are in the balance, the weights in the static axial force, and a ring takes part of the pressure.
    #[test]
    fn balance_and_weight() {
        let (bare, case) = (broad(), fitted());
        let model = |case| Model::new(case, &Options::default(), false, crate::harmonic::Places::Usual).unwrap();
        let (before, after) = (model(&bare), model(&case));
        for balance in mass_balance(&after) {
            assert!(balance.error.abs() < 1e-9, "{balance:?}");
        }
        let added = TAU * 1.83 * 2750.0 * RING.1 + LADDER.1;
        let mass = |m: &Model| m.horizontal.coupled.wall_mass;
        assert!(((mass(&after) - mass(&before)) / added - 1.0).abs() < 1e-9);
        let at = |case: &Case, z: f64, output| Static::solve(case, 1.0, 0.0).unwrap().at(z, true, output);
        let weight = at(&bare, 0.0, Output::AxialForce) - at(&case, 0.0, Output::AxialForce);
        assert!((weight / (added * 9.81 / (TAU * 1.83)) - 1.0).abs() < 1e-6, "{weight}");
        assert!(at(&case, RING.0, Output::HoopStress) < 0.9 * at(&bare, RING.0, Output::HoopStress));
    }
}
