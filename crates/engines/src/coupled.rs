//! A coupled linear system M ẍ + C ẋ + K x = −M ι a_g, ready for modal or direct analysis.
//!
//! One harmonic (m = 1 for horizontal, m = 0 for vertical motion) of a cylinder, or the antisymmetric half of a plane
//! strip; or a three-dimensional model reduced to the space its load excites. Built once, then read-only.

use crate::probe::{Probe, ProbeLine};
use fem::linalg::{Matrix, dot};
use results::channel::OnWall;
use results::{Channel, ModeShape};

/// Matrices, loads and observations of one harmonic.
#[derive(Clone, Debug)]
pub struct Coupled {
    /// Circumferential harmonic m (1 for a plane strip).
    pub harmonic: u32,
    /// Mass matrix M = M_shell + M_f (liquid condensed), symmetric positive definite.
    pub mass: Matrix,
    /// Stiffness K = K_shell ⊕ ρ g S, symmetric positive definite.
    pub stiffness: Matrix,
    /// Influence vector ι = M⁻¹ f, where −f is the load of a unit ground acceleration: close to the unknowns under a
    /// unit rigid translation, and such that the load −M ι a_g also holds the inertia that couples the unknowns to the
    /// clamped edge (m = 0: hydrostatic pressure and wall weight × a_v/g). ιᵀ M ι plus the `ground_acceleration` of the
    /// probe `base_shear` is `liquid_mass` + `wall_mass`.
    pub influence: Vec<f64>,
    /// Part of K that is gravity at the free surface.
    pub surface: Part,
    /// Part of K that resists rotation of a displacement liquid: a penalty, no physics. `None` where there is none.
    pub rotation: Option<Part>,
    /// Scalar outputs: wave gauges, `base_shear`, `base_moment`, `overturning_moment`, `bending_stress` at the base, stations.
    pub probes: Vec<Probe>,
    /// Outputs over the height: `pressure`, `hoop_stress`, `axial_membrane_stress`, `bending_stress`, `radial_displacement`.
    pub lines: Vec<ProbeLine>,
    /// Height of the surface at rest [m].
    pub level: f64,
    /// Membrane shear force n_zθ [N/m] at the places of the hoop stress, as the amplitude of sin θ; none where it is not computed.
    pub shear: Option<ProbeLine>,
    /// Liquid mass [kg] and wall plus roof mass [kg] in the model (for the balance of masses).
    pub liquid_mass: f64,
    /// Mass of wall and roof [kg].
    pub wall_mass: f64,
    /// Vector κ of the base moment just above the base: M_b = κᵀ M ẍ_total, but for the share of the clamped edge and
    /// of rigid side walls (`ground_acceleration` of the probe `base_moment`).
    pub moment_arm: Vec<f64>,
    /// Rows of base shear and base moment of the wall alone and of the roof alone, by the absolute accelerations; `None` if
    /// the engine does not separate them from the liquid.
    pub structure: Option<[[Vec<f64>; 2]; 2]>,
    /// Dashpots to the ground: row b over the unknowns and coefficient c [N·s/m]; the force −c b·ẋ acts on b·x.
    pub dashpots: Vec<(Vec<f64>, f64)>,
    /// Mesh in words, label → text.
    pub mesh: Vec<results::Labelled>,
    /// Rows that turn an eigenvector into its shape for drawing.
    pub shape_rows: ShapeRows,
}

impl Coupled {
    /// The line of a quantity over the height.
    pub fn line(&self, what: OnWall) -> Option<&ProbeLine> {
        self.lines.iter().find(|line| line.what == what)
    }

    /// The probe of a scalar.
    pub fn probe(&self, channel: Channel) -> Option<&Probe> {
        self.probes.iter().find(|probe| probe.channel == channel)
    }
}

/// A part of the stiffness matrix that holds energy of one kind.
#[derive(Clone, Debug)]
pub struct Part {
    /// The unknowns it couples.
    pub unknowns: std::ops::Range<usize>,
    /// Symmetric matrix on these unknowns.
    pub stiffness: Matrix,
}

impl Part {
    /// The diagonal block of `stiffness` that belongs to `unknowns`.
    pub fn block(stiffness: &Matrix, unknowns: std::ops::Range<usize>) -> Part {
        let places: Vec<usize> = unknowns.clone().collect();
        Part { stiffness: stiffness.select(&places, &places), unknowns }
    }

    /// Twice its energy, xᵀ K x.
    pub fn energy(&self, x: &[f64]) -> f64 {
        let own = &x[self.unknowns.clone()];
        own.iter().enumerate().map(|(j, xj)| xj * dot(self.stiffness.column(j), own)).sum()
    }
}

/// A row over the unknowns by its non-zero entries (unknown, coefficient).
pub type SparseRow = Vec<(usize, f64)>;

/// Linear maps from the unknowns to a drawable shape: values at `z` are `wall · x`, at `r` `surface · x`.
#[derive(Clone, Debug, Default)]
pub struct ShapeRows {
    /// Heights [m].
    pub z: Vec<f64>,
    /// Radial displacement at each height; empty where it is held.
    pub wall: Vec<SparseRow>,
    /// Radii [m].
    pub r: Vec<f64>,
    /// Elevation at each radius; empty where it is zero.
    pub surface: Vec<SparseRow>,
    /// Axial displacement and amplitude of the circumferential one at each height, of the harmonic engine; empty where they are held.
    pub tangential: Vec<[SparseRow; 2]>,
    /// Radius at which the elevation follows from the balance of volume, with its row; none where all are unknowns.
    pub closing: Option<(f64, SparseRow)>,
}

impl ShapeRows {
    /// The shape of `x`, scaled so that its largest absolute value is 1.
    pub fn shape(&self, x: &[f64]) -> ModeShape {
        let value = |row: &SparseRow| row.iter().map(|&(i, c)| c * x[i]).sum::<f64>();
        let take = |rows: &[SparseRow]| rows.iter().map(value).collect::<Vec<f64>>();
        let mut shape =
            ModeShape { z: self.z.clone(), wall: take(&self.wall), r: self.r.clone(), surface: take(&self.surface) };
        let peak = shape.wall.iter().chain(&shape.surface).fold(0.0_f64, |m, v| m.max(v.abs()));
        if peak > 0.0 {
            shape.wall.iter_mut().chain(shape.surface.iter_mut()).for_each(|v| *v /= peak);
        }
        shape
    }
}
