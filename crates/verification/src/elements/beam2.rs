//! Straight beam of two nodes: Bernoulli's theory, or Timoshenko's by the exact static shape functions.
//!
//! ```text
//! axial      E A / L          torsion  G J / L
//! bending    E I / (L³ (1 + Φ)) [ 12     6 L          −12    6 L        ]
//!                               [ 6 L   (4 + Φ) L²    −6 L  (2 − Φ) L²  ]      Φ = 12 E I / (G A_s L²), 0: Bernoulli
//! mass       consistent with the cubic functions of Φ = 0; m linear along the axis; torsion m (I₂ + I₃)/A
//! ```
//!
//! Small displacements. Nodal values are exact for loads at the nodes. Axes: e₁ along the beam, e₂ given, e₃ = e₁ × e₂;
//! `bending_3` = E I about e₃ bends the beam along e₂.
//!
//! Use: exact nodal values as reference for walls of solids and shells.
//!
//! Source: Przemieniecki 1968, (5.116) and (11.24).

use fem::dofs::Dof;
use fem::element::{Element, ElementError, Inspect, LocalMatrix, Response, Sample, Trial};
use nalgebra::{Matrix3, Vector3};

const KIND: &str = "beam2";

/// Stiffnesses and mass of a beam's section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeamSection {
    /// E A [N].
    pub axial: f64,
    /// E I about e₂ [N m²].
    pub bending_2: f64,
    /// E I about e₃ [N m²].
    pub bending_3: f64,
    /// G J [N m²].
    pub torsion: f64,
    /// G A_s of the shear force along e₂ and along e₃ [N]; infinite for Bernoulli's beam.
    pub shear: [f64; 2],
    /// Mass per length m [kg/m].
    pub mass: f64,
    /// Rotary inertia about the axis per length [kg m].
    pub polar_inertia: f64,
}

/// The element.
#[derive(Clone, Debug, PartialEq)]
pub struct Beam2 {
    nodes: [usize; 2],
    ends: [[f64; 3]; 2],
    /// Rows e₁, e₂, e₃.
    axes: Matrix3<f64>,
    length: f64,
    section: BeamSection,
}

impl Beam2 {
    /// Beam from `ends[0]` to `ends[1]` [m]; `second` gives e₂ after its part along the beam is subtracted.
    ///
    /// Errors: a stiffness or mass out of range, no length, e₂ along the beam.
    pub fn new(
        nodes: [usize; 2],
        ends: [[f64; 3]; 2],
        second: [f64; 3],
        section: BeamSection,
    ) -> Result<Beam2, ElementError> {
        let refuse =
            |parameter, found: String, allowed| Err(ElementError::Parameter { kind: KIND, parameter, found, allowed });
        let s = &section;
        for (parameter, value) in [
            ("axial", s.axial),
            ("bending_2", s.bending_2),
            ("bending_3", s.bending_3),
            ("torsion", s.torsion),
            ("mass", s.mass),
            ("polar_inertia", s.polar_inertia),
        ] {
            if !(value >= 0.0 && value.is_finite()) {
                return refuse(parameter, value.to_string(), "≥ 0");
            }
        }
        if !s.shear.iter().all(|&g| g > 0.0) {
            return refuse("shear", format!("{:?}", s.shear), "> 0, or infinite");
        }
        let along = Vector3::from(ends[1]) - Vector3::from(ends[0]);
        let length = along.norm();
        if !(length > 0.0 && length.is_finite()) {
            return refuse("length", length.to_string(), "> 0");
        }
        let e1 = along / length;
        let second = Vector3::from(second);
        let across = second - e1 * e1.dot(&second);
        // Below this angle the direction is rounding.
        if across.norm().is_nan() || across.norm() <= 1e-6 * second.norm() {
            return refuse("second axis", format!("{second:?}"), "not along the beam");
        }
        let e2 = across.normalize();
        let e3 = e1.cross(&e2);
        Ok(Beam2 {
            nodes,
            ends,
            axes: Matrix3::from_rows(&[e1.transpose(), e2.transpose(), e3.transpose()]),
            length,
            section,
        })
    }

    /// Stiffness in local axes: u₁ u₂ u₃ φ₁ φ₂ φ₃ of both ends.
    fn local_stiffness(&self) -> LocalMatrix {
        let (l, s) = (self.length, &self.section);
        let mut k = LocalMatrix::zeros(12);
        for (dof, stiffness) in [(0, s.axial), (3, s.torsion)] {
            add_rod(dof, stiffness / l, &mut k);
        }
        for plane in PLANES {
            let ei = [s.bending_2, s.bending_3][plane.about];
            let phi = 12.0 * ei / (s.shear[plane.shear] * l * l);
            let f = ei / (l.powi(3) * (1.0 + phi));
            let (near, far) = ((4.0 + phi) * l * l * f, (2.0 - phi) * l * l * f);
            let (c, d) = (12.0 * f, 6.0 * l * f);
            plane.add([[c, d, -c, d], [d, near, -d, far], [-c, -d, c, -d], [d, far, -d, near]], &mut k);
        }
        k
    }

    /// Mass in local axes.
    fn local_mass(&self) -> LocalMatrix {
        let (l, s) = (self.length, &self.section);
        let mut m = LocalMatrix::zeros(12);
        for (dof, mass) in [(0, s.mass), (3, s.polar_inertia)] {
            for (i, j, factor) in [(0, 0, 2.0), (6, 6, 2.0), (0, 6, 1.0), (6, 0, 1.0)] {
                m.add(dof + i, dof + j, factor * mass * l / 6.0);
            }
        }
        let f = s.mass * l / 420.0;
        let rows = [
            [156.0, 22.0 * l, 54.0, -13.0 * l],
            [22.0 * l, 4.0 * l * l, 13.0 * l, -3.0 * l * l],
            [54.0, 13.0 * l, 156.0, -22.0 * l],
            [-13.0 * l, -3.0 * l * l, -22.0 * l, 4.0 * l * l],
        ];
        for plane in PLANES {
            plane.add(rows.map(|row| row.map(|x| f * x)), &mut m);
        }
        m
    }

    /// Tᵀ A T into `out`.
    fn turn(&self, local: &LocalMatrix, out: &mut LocalMatrix) {
        for a in 0..4 {
            for b in 0..4 {
                let block = Matrix3::from_fn(|i, j| local.get(3 * a + i, 3 * b + j));
                let global = self.axes.transpose() * block * self.axes;
                for i in 0..3 {
                    for j in 0..3 {
                        out.add(3 * a + i, 3 * b + j, global[(i, j)]);
                    }
                }
            }
        }
    }

    /// Rows of the local stiffness over the global dofs.
    fn force_row(&self, k: &LocalMatrix, row: usize) -> Vec<f64> {
        (0..12)
            .map(|j| {
                let (block, component) = (3 * (j / 3), j % 3);
                (0..3).map(|i| k.get(row, block + i) * self.axes[(i, component)]).sum()
            })
            .collect()
    }
}

/// One plane of bending: local dofs of deflection and slope at both ends, and the sign of the rotation that is the slope.
struct Plane {
    deflection: usize,
    rotation: usize,
    sign: f64,
    about: usize,
    shear: usize,
}

/// Deflection along e₂ turns about +e₃, along e₃ about −e₂.
const PLANES: [Plane; 2] = [
    Plane { deflection: 1, rotation: 5, sign: 1.0, about: 1, shear: 0 },
    Plane { deflection: 2, rotation: 4, sign: -1.0, about: 0, shear: 1 },
];

impl Plane {
    /// Adds a matrix over (w₁, w₁', w₂, w₂').
    fn add(&self, rows: [[f64; 4]; 4], out: &mut LocalMatrix) {
        let places = [
            (self.deflection, 1.0),
            (self.rotation, self.sign),
            (self.deflection + 6, 1.0),
            (self.rotation + 6, self.sign),
        ];
        for (i, (row, si)) in places.into_iter().enumerate() {
            for (j, (column, sj)) in places.into_iter().enumerate() {
                out.add(row, column, si * sj * rows[i][j]);
            }
        }
    }
}

fn add_rod(dof: usize, k: f64, out: &mut LocalMatrix) {
    out.add(dof, dof, k);
    out.add(dof + 6, dof + 6, k);
    out.add(dof, dof + 6, -k);
    out.add(dof + 6, dof, -k);
}

impl Element for Beam2 {
    fem::answers!(KIND, nodes, Dof::SHELL; inspect);

    fn mass(&self, out: &mut LocalMatrix) {
        self.turn(&self.local_mass(), out);
    }

    fn has_mass(&self) -> bool {
        self.section.mass > 0.0
    }

    fn respond(&self, Trial { motion, want, .. }: Trial<'_>, out: &mut Response) -> Result<(), ElementError> {
        let mut k = LocalMatrix::zeros(12);
        self.turn(&self.local_stiffness(), &mut k);
        if want.force {
            for (i, f) in out.force.iter_mut().enumerate() {
                *f += (0..12).map(|j| k.get(i, j) * motion.values[j]).sum::<f64>();
            }
        }
        if want.tangent {
            out.tangent = k;
        }
        Ok(())
    }

    fn body_force(&self, acceleration: [f64; 3], out: &mut [f64]) {
        let local = self.axes * Vector3::from(acceleration) * (0.5 * self.section.mass * self.length);
        let l = self.length / 6.0;
        // Forces in halves; moments q L²/12 of the cubic functions.
        let force = self.axes.transpose() * local;
        let moment = self.axes.transpose() * Vector3::new(0.0, -local[2] * l, local[1] * l);
        for i in 0..3 {
            out[i] += force[i];
            out[6 + i] += force[i];
            out[3 + i] += moment[i];
            out[9 + i] -= moment[i];
        }
    }
}

impl Inspect for Beam2 {
    /// Forces and moments on the cut at the first and the second end, positive on the face that looks along e₁:
    /// `n_11`, `q_2`, `q_3`, `m_1`, `m_2`, `m_3`. Loads between the nodes are not in them.
    fn samples(&self) -> Vec<Sample> {
        const NAMES: [&str; 6] = ["n_11", "q_2", "q_3", "m_1", "m_2", "m_3"];
        let k = self.local_stiffness();
        let mut samples = Vec::new();
        for (end, sign) in [(0, -1.0), (1, 1.0)] {
            for (i, name) in NAMES.into_iter().enumerate() {
                samples.push(Sample {
                    name,
                    position: self.ends[end],
                    row: self.force_row(&k, 6 * end + i).iter().map(|x| sign * x).collect(),
                    of_acceleration: false,
                });
            }
        }
        samples
    }
}

#[cfg(test)]
mod tests {
    use fem::element::reference_stiffness;

    use super::*;

    fn section(shear: f64) -> BeamSection {
        BeamSection {
            axial: 300.0,
            bending_2: 20.0,
            bending_3: 50.0,
            torsion: 9.0,
            shear: [shear; 2],
            mass: 2.0,
            polar_inertia: 0.1,
        }
    }

    /// Cantilever in a general direction under a tip force: w = P L³/(3 E I) + P L/(G A_s).
    #[test]
    fn cantilever_in_space() {
        let ends = [[1.0, 0.0, 0.5], [2.2, 1.6, 0.5]];
        for shear in [f64::INFINITY, 40.0] {
            let beam = Beam2::new([0, 1], ends, [0.0, 0.0, 3.0], section(shear)).unwrap();
            let k = reference_stiffness(&beam).unwrap();
            let free = nalgebra::DMatrix::from_fn(6, 6, |i, j| k.get(6 + i, 6 + j));
            let mut load = nalgebra::DVector::zeros(6);
            load[2] = 3.0;
            let u = free.lu().solve(&load).unwrap();
            let exact = 3.0 * 8.0 / (3.0 * 50.0) + 3.0 * 2.0 / shear;
            assert!((u[2] - exact).abs() < 1e-13, "{}", u[2]);
            let sample = &beam.samples()[5];
            let values: Vec<f64> = std::iter::repeat_n(0.0, 6).chain(u.iter().copied()).collect();
            let moment: f64 = sample.row.iter().zip(&values).map(|(a, b)| a * b).sum();
            assert!((moment - 6.0).abs() < 1e-12, "{moment}");
        }
    }

    /// Weight: resultant and moment about the first end.
    #[test]
    fn weight() {
        let beam = Beam2::new([0, 1], [[0.0; 3], [2.0, 0.0, 0.0]], [0.0, 1.0, 0.0], section(60.0)).unwrap();
        let mut out = vec![0.0; 12];
        beam.body_force([0.0, 0.0, -10.0], &mut out);
        assert!((out[2] + out[8] + 40.0).abs() < 1e-13);
        // Moments about y: −x F_z at the second end, and both end moments q L²/12.
        assert!((out[4] - 10.0 * 2.0 * 4.0 / 12.0).abs() < 1e-13, "{}", out[4]);
        assert!((out[4] + out[10]).abs() < 1e-13);
    }

    #[test]
    fn bad_beams_are_rejected() {
        let ends = [[0.0; 3], [0.0, 0.0, 1.0]];
        assert!(Beam2::new([0, 1], ends, [0.0, 0.0, 1.0], section(1.0)).is_err());
        assert!(Beam2::new([0, 1], [[0.0; 3]; 2], [1.0, 0.0, 0.0], section(1.0)).is_err());
        assert!(Beam2::new([0, 1], ends, [1.0, 0.0, 0.0], section(0.0)).is_err());
    }
}
