//! Wall of a tank: shell of revolution (cylinder) for one harmonic, or a plane cantilever strip.
//!
//! ```text
//! u(z) cos mθ axial (up), v(z) sin mθ circumferential, w(z) cos mθ radial (outward)
//!
//! ε_x = u'                  κ_x = −w''                          n_x = C (ε_x + ν ε_θ)    C = E t/(1 − ν²)
//! ε_θ = (m v + w)/R         κ_θ = (m² w + m v)/R²               n_θ = C (ε_θ + ν ε_x)
//! γ   = v' − m u/R          τ   = 2 (m w' + v')/R               m_x = D (κ_x + ν κ_θ)    D = E t³/(12 (1 − ν²))
//!
//! 2 U = c ∫ [C (ε_x² + ε_θ² + 2 ν ε_x ε_θ + (1−ν)/2 γ²) + D (κ_x² + κ_θ² + 2 ν κ_x κ_θ + (1−ν)/2 τ²)] dz
//! 2 T = c ∫ ρ_s t (u̇² + v̇² + ẇ²) dz
//! ```
//!
//! c = π R (m ≥ 1), 2 π R (m = 0). A strip is the same with 1/R = 0, m = 0 and c = twice its breadth (both walls): a beam
//! of stiffness D in plane strain. Rotary inertia and transverse shear are neglected (thin wall); R is the inner radius.
//!
//! w is cubic Hermite, v cubic and u quartic, both continuous only, so that u' may jump at a course joint. u' and ν w/R
//! are then of one degree, and an axial force that is constant does not oscillate within an element. The bubbles of u
//! (three) and v (two) are eliminated statically; their own frequencies lie far above all modes of interest.
//!
//! Source: Novozhilov 1964 (strains); Love 1888. Check: rigid translation and rotation cost no energy (tests).

use std::f64::consts::PI;
use tank::{Material, Shape, Tank};

use fem::shape::{gauss, line};

use super::wall_mesh::wall_nodes;

/// Unknowns of a node: u, v, w, w'.
pub const NODE: usize = 4;
/// Nodal unknowns of an element.
pub const NODAL: usize = 2 * NODE;
/// Bubbles of u in an element.
pub(super) const U_BUBBLES: usize = 3;
/// Bubbles of an element: those of u, then two of v.
const BUBBLES: usize = U_BUBBLES + 2;
/// All unknowns of an element: u₁ v₁ w₁ w₁' u₂ v₂ w₂ w₂', then the bubbles of u and of v.
pub(super) const LOCAL: usize = NODAL + BUBBLES;

/// A linear functional of one element's unknowns.
pub(super) type LocalRow = [f64; LOCAL];

/// Symmetric matrix of one element.
pub(super) type LocalMatrix = [[f64; LOCAL]; LOCAL];

/// Outputs at a height.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Output {
    /// Outward displacement w [m].
    RadialDisplacement,
    /// n_θ/t [Pa].
    HoopStress,
    /// n_x/t [Pa].
    AxialStress,
    /// 6 m_x/t² [Pa]: meridional bending stress at the outer face.
    BendingStress,
    /// m_x [N·m/m]: positive if the outer face is in tension.
    BendingMoment,
    /// n_xθ [N/m], the amplitude of sin mθ.
    ShearForce,
    /// n_x [N/m].
    AxialForce,
    /// n_θ [N/m].
    HoopForce,
    /// m_θ [N·m/m]: positive if the outer face is in tension.
    HoopMoment,
    /// m_xθ [N·m/m], the amplitude of sin mθ.
    Twist,
}

/// A ring of the wall.
#[derive(Clone, Debug)]
pub struct Element {
    /// Lower end [m].
    pub bottom: f64,
    /// Length [m].
    pub length: f64,
    /// Thickness t [m].
    pub thickness: f64,
    /// Material.
    pub material: Material,
    /// Stiffness matrix.
    pub stiffness: LocalMatrix,
    /// Consistent mass matrix.
    pub mass: LocalMatrix,
    /// Bubbles that follow from the nodal unknowns, T_b = −K_bb⁻¹ K_ba.
    pub bubbles: [[f64; NODAL]; BUBBLES],
    /// Bubbles that their own inertia adds per nodal acceleration, −K_bb⁻¹ (M_ba + M_bb T_b).
    pub bubble_inertia: [[f64; NODAL]; BUBBLES],
}

/// The wall of one harmonic.
#[derive(Clone, Debug)]
pub struct Wall {
    /// Heights of the nodes [m].
    pub nodes: Vec<f64>,
    /// Elements from the base up.
    pub elements: Vec<Element>,
    /// Which of u, v, w, w' are unknowns.
    pub active: [bool; NODE],
    /// Curvature 1/R of the wall [1/m]; 0 for a strip.
    pub curvature: f64,
    /// Harmonic m; 0 for both halves of a strip.
    pub wave: f64,
    /// Factor c of the integrals over z [m].
    pub factor: f64,
    /// Which of u, v, w, w' the base holds.
    pub held: [bool; NODE],
    /// Radial stiffness of the base per length of the circumference, where it does not hold w [Pa].
    pub foot: f64,
}

impl Wall {
    /// The wall of a tank for one harmonic (strip: 0 is the symmetric half, anything else the antisymmetric one).
    pub fn new(tank: &Tank, fill_height: f64, harmonic: u32, refine: f64) -> Wall {
        let (curvature, wave, factor, active) = match tank.shape {
            Shape::Cylinder { radius } => {
                let turn = if harmonic == 0 { 2.0 * PI } else { PI };
                (1.0 / radius, f64::from(harmonic), turn * radius, [true, harmonic > 0, true, true])
            }
            Shape::Rectangle { breadth, .. } => (0.0, 0.0, 2.0 * breadth, [harmonic == 0, false, true, true]),
        };
        let (nodes, courses) = wall_nodes(tank, fill_height, refine);
        let mut wall = Wall {
            nodes,
            elements: Vec::new(),
            active,
            curvature,
            wave,
            factor,
            held: [true, true, tank.wall_base.holds().0, tank.wall_base.holds().1],
            foot: tank.wall_base.stiffness(),
        };
        for (e, &course) in courses.iter().enumerate() {
            let course = &tank.courses[course];
            let (bottom, top) = (wall.nodes[e], wall.nodes[e + 1]);
            let element = wall.element(bottom, top - bottom, course.thickness, &course.material);
            wall.elements.push(element);
        }
        wall
    }

    fn element(&self, bottom: f64, length: f64, thickness: f64, material: &Material) -> Element {
        let (c, d, nu) = rigidities(thickness, material);
        let (mut stiffness, mut mass) = ([[0.0; LOCAL]; LOCAL], [[0.0; LOCAL]; LOCAL]);
        for &(xi, weight) in gauss::FIVE {
            let measure = 0.5 * self.factor * length * weight;
            let [ex, et, g, kx, kt, twist] = self.strains(xi, length);
            let fields = displacements(xi, length);
            let inertia = measure * material.density * thickness;
            for i in 0..LOCAL {
                for j in 0..LOCAL {
                    let membrane = ex[i] * ex[j]
                        + et[i] * et[j]
                        + nu * (ex[i] * et[j] + et[i] * ex[j])
                        + 0.5 * (1.0 - nu) * g[i] * g[j];
                    let bending = kx[i] * kx[j]
                        + kt[i] * kt[j]
                        + nu * (kx[i] * kt[j] + kt[i] * kx[j])
                        + 0.5 * (1.0 - nu) * twist[i] * twist[j];
                    stiffness[i][j] += measure * (c * membrane + d * bending);
                    mass[i][j] += inertia * fields.iter().map(|f| f[i] * f[j]).sum::<f64>();
                }
            }
        }
        let (bubbles, bubble_inertia) = bubble_recovery(&stiffness, &mass);
        Element { bottom, length, thickness, material: material.clone(), bubbles, bubble_inertia, stiffness, mass }
    }

    /// ε_x, ε_θ, γ, κ_x, κ_θ, τ at ξ of an element of the given length.
    pub fn strains(&self, xi: f64, length: f64) -> [LocalRow; 6] {
        let [u, v, w] = displacements(xi, length);
        let [du, dv] = membrane_slopes(xi, length);
        let [_, slope, curvature] = line::hermite(xi, length);
        let dw = on_w(slope);
        let ddw = on_w(curvature);
        let (k, m) = (self.curvature, self.wave);
        let at = |f: &dyn Fn(usize) -> f64| std::array::from_fn(f);
        [
            du,
            at(&|i| k * (m * v[i] + w[i])),
            at(&|i| dv[i] - k * m * u[i]),
            at(&|i| -ddw[i]),
            at(&|i| k * k * m * (m * w[i] + v[i])),
            at(&|i| 2.0 * k * (m * dw[i] + dv[i])),
        ]
    }

    /// An output at ξ of element `e`, on all unknowns of the element.
    pub fn output(&self, e: usize, xi: f64, output: Output) -> LocalRow {
        let element = &self.elements[e];
        if output == Output::RadialDisplacement {
            return displacements(xi, element.length)[2];
        }
        let t = element.thickness;
        let (c, d, nu) = rigidities(t, &element.material);
        let [ex, et, g, kx, kt, twist] = self.strains(xi, element.length);
        let row = |f: &dyn Fn(usize) -> f64| std::array::from_fn(f);
        match output {
            Output::RadialDisplacement => displacements(xi, element.length)[2],
            Output::HoopStress => row(&|i| c / t * (et[i] + nu * ex[i])),
            Output::AxialStress => row(&|i| c / t * (ex[i] + nu * et[i])),
            Output::BendingStress => row(&|i| 6.0 * d / (t * t) * (kx[i] + nu * kt[i])),
            Output::BendingMoment => row(&|i| d * (kx[i] + nu * kt[i])),
            Output::ShearForce => row(&|i| 0.5 * (1.0 - nu) * c * g[i]),
            Output::AxialForce => row(&|i| c * (ex[i] + nu * et[i])),
            Output::HoopForce => row(&|i| c * (et[i] + nu * ex[i])),
            Output::HoopMoment => row(&|i| d * (kt[i] + nu * kx[i])),
            Output::Twist => row(&|i| 0.5 * (1.0 - nu) * d * twist[i]),
        }
    }

    /// Element and ξ at height z; at a node the element above (`upper`) or below it.
    pub fn locate(&self, z: f64, upper: bool) -> (usize, f64) {
        let last = self.elements.len() - 1;
        let tolerance = 1e-9 * self.nodes[last + 1];
        let above = |e: &usize| {
            let top = self.nodes[e + 1];
            if upper { z < top - tolerance } else { z <= top + tolerance }
        };
        let e = (0..last).find(above).unwrap_or(last);
        let element = &self.elements[e];
        (e, (2.0 * (z - element.bottom) / element.length - 1.0).clamp(-1.0, 1.0))
    }
}

impl Element {
    /// Matrix of the nodal unknowns after the bubbles are eliminated statically: Tᵀ A T.
    pub fn condensed(&self, matrix: &LocalMatrix) -> [[f64; NODAL]; NODAL] {
        let columns: [LocalRow; NODAL] = std::array::from_fn(|j| {
            let expanded = self.expand(&std::array::from_fn(|k| f64::from(k == j)));
            std::array::from_fn(|i| (0..LOCAL).map(|k| matrix[i][k] * expanded[k]).sum())
        });
        let reduced: [[f64; NODAL]; NODAL] = std::array::from_fn(|j| self.condensed_row(&columns[j]));
        std::array::from_fn(|i| std::array::from_fn(|j| 0.5 * (reduced[i][j] + reduced[j][i])))
    }

    /// A functional of all unknowns as one of the nodal unknowns: Tᵀ a.
    pub fn condensed_row(&self, row: &LocalRow) -> [f64; NODAL] {
        std::array::from_fn(|j| row[j] + (0..BUBBLES).map(|b| self.bubbles[b][j] * row[NODAL + b]).sum::<f64>())
    }

    /// The part of a functional that the inertia of the bubbles adds, on the nodal accelerations.
    pub fn inertia_row(&self, row: &LocalRow) -> [f64; NODAL] {
        std::array::from_fn(|j| (0..BUBBLES).map(|b| self.bubble_inertia[b][j] * row[NODAL + b]).sum::<f64>())
    }

    /// All unknowns from the nodal ones: T x.
    fn expand(&self, nodal: &[f64; NODAL]) -> LocalRow {
        std::array::from_fn(|i| match i.checked_sub(NODAL) {
            None => nodal[i],
            Some(b) => (0..NODAL).map(|j| self.bubbles[b][j] * nodal[j]).sum(),
        })
    }
}

/// C = E t/(1 − ν²), D = E t³/(12 (1 − ν²)), ν.
fn rigidities(thickness: f64, material: &Material) -> (f64, f64, f64) {
    let nu = material.poisson_ratio;
    let c = material.youngs_modulus * thickness / (1.0 - nu * nu);
    (c, c * thickness * thickness / 12.0, nu)
}

/// u, v, w at ξ of an element of the given length.
pub(super) fn displacements(xi: f64, length: f64) -> [LocalRow; 3] {
    let [smooth, _] = line::bubbled(xi, length);
    [on_u(smooth), on_v(smooth), on_w(line::hermite(xi, length)[0])]
}

/// u', v' at ξ.
fn membrane_slopes(xi: f64, length: f64) -> [LocalRow; 2] {
    let [_, slope] = line::bubbled(xi, length);
    [on_u(slope), on_v(slope)]
}

fn on_u(n: [f64; 5]) -> LocalRow {
    spread(n, [0, NODE, NODAL, NODAL + 1, NODAL + 2])
}

/// v has no quartic bubble.
fn on_v([a, b, c, d, _]: [f64; 5]) -> LocalRow {
    let bubbles = NODAL + U_BUBBLES;
    spread([a, b, c, d], [1, NODE + 1, bubbles, bubbles + 1])
}

fn on_w(n: [f64; 4]) -> LocalRow {
    spread(n, [2, 3, NODE + 2, NODE + 3])
}

fn spread<const N: usize>(n: [f64; N], places: [usize; N]) -> LocalRow {
    let mut row = [0.0; LOCAL];
    for (value, place) in n.into_iter().zip(places) {
        row[place] = value;
    }
    row
}

/// −K_bb⁻¹ K_ba, the bubbles that make the elastic energy least for given nodal unknowns, and −K_bb⁻¹ (M_ba + M_bb T_b).
fn bubble_recovery(k: &LocalMatrix, m: &LocalMatrix) -> ([[f64; NODAL]; BUBBLES], [[f64; NODAL]; BUBBLES]) {
    type Block = nalgebra::SMatrix<f64, BUBBLES, NODAL>;
    type Inner = nalgebra::SMatrix<f64, BUBBLES, BUBBLES>;
    let inner = |a: &LocalMatrix| Inner::from_fn(|i, j| a[NODAL + i][NODAL + j]);
    let outer = |a: &LocalMatrix| Block::from_fn(|i, j| a[NODAL + i][j]);
    let factor = inner(k).cholesky().expect("bubbles vanish at both ends, so none is free of strain");
    let elastic: Block = -factor.solve(&outer(k));
    let inertia: Block = -factor.solve(&(outer(m) + inner(m) * elastic));
    let rows = |b: &Block| std::array::from_fn(|i| std::array::from_fn(|j| b[(i, j)]));
    (rows(&elastic), rows(&inertia))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wall(harmonic: u32) -> Wall {
        let tank = crate::harmonic::test_tanks::broad().tank;
        Wall::new(&tank, 1.525, harmonic, 1.0)
    }

    fn energy(wall: &Wall, field: impl Fn(f64) -> [f64; NODE]) -> f64 {
        wall.elements
            .iter()
            .map(|e| {
                let k = e.condensed(&e.stiffness);
                let (a, b) = (field(e.bottom), field(e.bottom + e.length));
                let x: Vec<f64> = a.into_iter().chain(b).collect();
                (0..NODAL).map(|i| (0..NODAL).map(|j| x[i] * k[i][j] * x[j]).sum::<f64>()).sum::<f64>()
            })
            .sum()
    }

    /// Rigid translation along x and rigid rotation about y cost no energy compared with an inextensional-looking field.
    #[test]
    fn rigid_motion_is_free_of_strain() {
        let wall = wall(1);
        let radius = 1.83;
        let ovalling = energy(&wall, |_| [0.0, 0.0, 1.0, 0.0]);
        let translation = energy(&wall, |_| [0.0, -1.0, 1.0, 0.0]);
        let rotation = energy(&wall, |z| [-radius, -z, z, 1.0]);
        // Entries of K are up to 10⁴ times the forces of this field, and rounding is relative to the entries.
        assert!(translation.abs() < 1e-10 * ovalling, "{translation:e} {ovalling:e}");
        assert!(rotation.abs() < 1e-10 * ovalling, "{rotation:e} {ovalling:e}");
    }

    /// m = 0: uniform expansion w = 1 with u' free to contract costs E t/R² per area (uniaxial hoop stress).
    #[test]
    fn ring_expansion() {
        let wall = wall(0);
        let (e, nu, r) = (69e9, 0.32, 1.83);
        let found = energy(&wall, |z| [-nu * z / r, 0.0, 1.0, 0.0]);
        let exact = 2.0 * PI * r * e / (r * r) * (0.915 * 2.03e-3 + 0.915 * 1.27e-3);
        assert!((found / exact - 1.0).abs() < 1e-12, "{found} {exact}");
    }

    /// Σ of the condensed mass for a rigid translation is the wall's mass.
    #[test]
    fn translation_carries_the_whole_mass() {
        let wall = wall(1);
        let mass: f64 = wall
            .elements
            .iter()
            .map(|e| {
                let m = e.condensed(&e.mass);
                let x = [0.0, -1.0, 1.0, 0.0, 0.0, -1.0, 1.0, 0.0];
                (0..NODAL).map(|i| (0..NODAL).map(|j| x[i] * m[i][j] * x[j]).sum::<f64>()).sum::<f64>()
            })
            .sum();
        let exact = 2.0 * PI * 1.83 * 2750.0 * (0.915 * 2.03e-3 + 0.915 * 1.27e-3);
        assert!((mass / exact - 1.0).abs() < 1e-12);
    }
}
