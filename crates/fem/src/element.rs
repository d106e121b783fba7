//! Elements: one file a kind.
//!
//! An element is pure: it holds parameters, reads the committed history and writes the given trial history, and
//! does not depend on equations or supports. Its local vector runs node by node over [`Element::dofs`] of each node; all
//! vector components are global Cartesian (the model turns them into the frames of its nodes).
//!
//! Every element implements [`Element`], which assembly uses; optional abilities are [`Contact`], [`Inspect`], [`Mixed`] and
//! [`Buckling`]. A new kind is a file here, a line below, and an entry in `tests/laws/registry`, whose suite asks every
//! element for the laws it must obey.

use materials::{LawError, PointState};
use nalgebra::{UnitQuaternion, Vector3};

use crate::dofs::Dof;
use crate::ring::RingOperator;

pub use fluid::{LiquidProperties, RotationPart, VolumePart};
pub use fluid8::Fluid8;
pub use free_surface::FreeSurface;
pub use local::LocalMatrix;
pub use potential_surface::PotentialSurface;
pub use potential8::Potential8;
pub use wet_face::WetFace;

pub mod anchor;
pub mod beam_section;
pub mod contact8;
mod contact8_area;
pub mod fibre_beam;
mod fluid;
mod fluid8;
mod free_surface;
pub mod ground;
pub mod interlayer;
pub mod liquid_joint;
mod local;
mod potential8;
mod potential_face;
mod potential_surface;
pub mod shell;
pub mod shell4;
pub mod solid8;
pub mod solid8_law;
pub mod spring;
pub mod super_element;
pub mod wall;
mod wet_face;

/// Motion of the nodes of an element.
#[derive(Clone, Copy, Debug)]
pub struct Motion<'a> {
    /// Values of the element's dofs, total, node by node. Rotational dofs hold the rotation vector of linear theory and
    /// are read by linear elements only; elements with finite rotations read `rotations`.
    pub values: &'a [f64],
    /// Rotation of each node since the reference state (identity at nodes without rotational dofs).
    pub rotations: &'a [UnitQuaternion<f64>],
}

/// Requested results of [`Element::respond`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Want {
    /// Internal force.
    pub force: bool,
    /// Consistent tangent.
    pub tangent: bool,
}

impl Want {
    /// Force and tangent.
    pub const ALL: Want = Want { force: true, tangent: true };
    /// The tangent alone.
    pub const TANGENT: Want = Want { force: false, tangent: true };
    /// The force alone.
    pub const FORCE: Want = Want { force: true, tangent: false };
}

/// Part of a load history, for elements with free strains (temperature, shrinkage, prestress) or creep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stage {
    /// Lasting loads grow: this share of the free strains acts, and materials creep.
    Lasting(f64),
    /// Short-time loads follow: free strains and what has crept stay.
    Short,
}

/// A trial state of an element.
#[derive(Debug)]
pub struct Trial<'a> {
    /// Motion of its nodes.
    pub motion: Motion<'a>,
    /// Committed history.
    pub old: &'a [f64],
    /// Trial history, to be written.
    pub new: &'a mut [f64],
    /// Requested results.
    pub want: Want,
}

/// Force and tangent of one element, reused from element to element.
#[derive(Clone, Debug, Default)]
pub struct Response {
    /// Internal force f_int, one entry a local dof.
    pub force: Vec<f64>,
    /// Tangent ∂f_int/∂u (rotations: with respect to a spin superposed on the current rotation).
    pub tangent: LocalMatrix,
}

/// Failure of an element.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ElementError {
    /// The Jacobian determinant is not positive.
    #[error(
        "{kind}: the Jacobian determinant is {determinant:.3e} at an integration point, allowed > 0 (nodes {nodes:?})"
    )]
    Jacobian {
        /// Kind of element.
        kind: &'static str,
        /// Determinant found.
        determinant: f64,
        /// Its nodes.
        nodes: Vec<usize>,
    },
    /// A parameter out of range.
    #[error("{kind}: {parameter} is {found}, allowed {allowed}")]
    Parameter {
        /// Kind of element.
        kind: &'static str,
        /// Name of the parameter.
        parameter: &'static str,
        /// Found.
        found: String,
        /// Allowed.
        allowed: &'static str,
    },
    /// A stress law failed.
    #[error("{kind}: {source}")]
    Law {
        /// Kind of element.
        kind: &'static str,
        /// The law's failure.
        source: LawError,
    },
    /// The kinematics failed.
    #[error("{kind}: {reason}")]
    NoAnswer {
        /// Kind of element.
        kind: &'static str,
        /// Why.
        reason: String,
    },
}

/// Refuses the parameter `found` of an element unless it is `good`.
///
/// Errors: [`ElementError::Parameter`].
fn require(
    good: bool,
    kind: &'static str,
    parameter: &'static str,
    found: impl std::fmt::Display,
    allowed: &'static str,
) -> Result<(), ElementError> {
    if good { Ok(()) } else { Err(ElementError::Parameter { kind, parameter, found: found.to_string(), allowed }) }
}

/// Whether a number is positive and finite.
fn positive(x: f64) -> bool {
    x > 0.0 && x.is_finite()
}

/// Whether a number is finite and not negative.
fn not_negative(x: f64) -> bool {
    x >= 0.0 && x.is_finite()
}

/// A quantity at a point of an element as a linear function of its dofs at the reference state.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// Name: `n_11`, `m_22`, `q_1`, `pressure`, `stress_33`, …
    pub name: &'static str,
    /// Global Cartesian position [m].
    pub position: [f64; 3],
    /// Coefficients, one a local dof: value = row · u.
    pub row: Vec<f64>,
    /// Whether the row multiplies accelerations instead of displacements (pressure of a potential).
    pub of_acceleration: bool,
}

/// A material point as a picture shows it.
#[derive(Clone, Debug, PartialEq)]
pub struct Inspection {
    /// Integration point of the element, or of its reference surface or axis.
    pub point: usize,
    /// Layer or fibre over that point, bars after the layers.
    pub layer: usize,
    /// Global reference position [m].
    pub position: [f64; 3],
    /// Distance from the reference surface or axis along the director [m]; 0 in solids.
    pub depth: f64,
    /// Axes 1 and 2 of strain and stress.
    pub axes: [Vector3<f64>; 2],
    /// ε_11, ε_22, γ_12; fibres and bars have the first alone.
    pub strain: [f64; 3],
    /// σ_11, σ_22, σ_12 [Pa].
    pub stress: [f64; 3],
    /// State of the material.
    pub state: PointState,
}

/// Strains and resultants of a shell's or beam's section at an integration point.
#[derive(Clone, Debug, PartialEq)]
pub struct SectionState {
    /// Global reference position [m].
    pub position: [f64; 3],
    /// Axes 1 and 2.
    pub axes: [Vector3<f64>; 2],
    /// Strains in the order of [`shell::section`]; a beam uses ε_11, κ_11, γ_1.
    pub strain: [f64; 8],
    /// Resultants in the same order, per metre of width [N/m, N].
    pub resultants: [f64; 8],
}

/// What an element answers in a word, for its `impl Element`: kind, field of the nodes, dofs of every node unless they differ; then
/// which of `own_axes`, `linear` and `massless` it is, and its abilities `contact`, `inspect`, `mixed` and `buckling`.
///
/// ```text
/// fem::answers!("ground", node, Dof::TRANSLATIONS; massless contact inspect);
/// ```
#[macro_export]
macro_rules! answers {
    ($kind:expr, $($nodes:ident).+ $(, $dofs:expr)? $(; $($word:ident)+)?) => {
        fn kind(&self) -> &'static str {
            $kind
        }

        fn nodes(&self) -> &[usize] {
            &self.$($nodes).+
        }

        $(fn dofs(&self, _node: usize) -> &'static [$crate::dofs::Dof] {
            $dofs
        })?

        $($($crate::answers!(@$word);)+)?
    };
    (@own_axes) => { fn own_axes(&self) -> bool { true } };
    (@linear) => { fn is_linear(&self) -> bool { true } };
    (@massless) => { fn has_mass(&self) -> bool { false } };
    (@contact) => { fn contact(&self) -> Option<&dyn $crate::element::Contact> { Some(self) } };
    (@inspect) => { fn inspect(&self) -> Option<&dyn $crate::element::Inspect> { Some(self) } };
    (@mixed) => { fn mixed(&self) -> Option<&dyn $crate::element::Mixed> { Some(self) } };
    (@buckling) => { fn buckling(&self) -> Option<&dyn $crate::element::Buckling> { Some(self) } };
}

/// A finite element as used by assembly.
///
/// Optional abilities are separate traits, which an element returns if it has them: [`Contact`], [`Inspect`],
/// [`Mixed`], [`Buckling`].
pub trait Element: Send + Sync {
    /// Kind, as users name it (`fluid8`, `shell4`, …).
    fn kind(&self) -> &'static str;

    /// Its nodes, in local order.
    fn nodes(&self) -> &[usize];

    /// Dofs that the element uses at its local node `node`, in local order.
    fn dofs(&self, node: usize) -> &'static [Dof];

    /// Whether the element's local vector has components along the axes of the nodes' own frames instead of the global
    /// axes. Vector dofs need not come in triples then.
    fn own_axes(&self) -> bool {
        false
    }

    /// Whether internal force and tangent are K u with a constant K, in small rotations: such elements are assembled once
    /// for all steps.
    fn is_linear(&self) -> bool {
        false
    }

    /// Number of history variables, all integration points together.
    fn history_len(&self) -> usize {
        0
    }

    /// Writes the initial history.
    fn init_history(&self, _slots: &mut [f64]) {}

    /// Changes the stage in a committed history.
    fn stage(&self, _stage: Stage, _history: &mut [f64]) {}

    /// Consistent mass matrix at the reference state (zeros by default). `out` has the element's size and is zero.
    ///
    /// This includes the blocks that join a potential to its boundary, since they multiply accelerations.
    fn mass(&self, _out: &mut LocalMatrix) {}

    /// Whether [`Element::mass`] may be non-zero.
    fn has_mass(&self) -> bool {
        true
    }

    /// Internal force and consistent tangent in a trial state, whose history it writes. `out` has the element's size and is zero.
    ///
    /// Errors: a state in which the element fails.
    fn respond(&self, trial: Trial<'_>, out: &mut Response) -> Result<(), ElementError>;

    /// Viscous damping matrix of the element itself (element Rayleigh, super-elements); returns false if it has none.
    fn damping(&self, _out: &mut LocalMatrix) -> bool {
        false
    }

    /// Adds the consistent nodal forces of a uniform acceleration field b (gravity: b = (0, 0, −g)), ∫ ρ Nᵀ b dV.
    fn body_force(&self, _acceleration: [f64; 3], _out: &mut [f64]) {}

    /// The element as an operator over its local dofs: it is linear, and its matrices are not assembled. [`Element::mass`] and
    /// [`Element::respond`] form them for small elements.
    fn operator(&self) -> Option<&RingOperator> {
        None
    }

    /// The element as a joint that opens and closes.
    fn contact(&self) -> Option<&dyn Contact> {
        None
    }

    /// The element as a source of internal state.
    fn inspect(&self) -> Option<&dyn Inspect> {
        None
    }

    /// The element with a second tangent.
    fn mixed(&self) -> Option<&dyn Mixed> {
        None
    }

    /// The element as something that buckles.
    fn buckling(&self) -> Option<&dyn Buckling> {
        None
    }
}

/// A joint of two bodies that may separate: contact, one-sided joints, layers.
pub trait Contact {
    /// Shows every yes or no of the element at `motion`, in a fixed order: joint closed, layer pressed. A solution counts only
    /// when these repeat from one iteration to the next.
    fn switches(&self, motion: Motion<'_>, history: &[f64], see: &mut dyn FnMut(bool));

    /// Whether time steps take the element's force at their end, whatever their scheme blends the others with: so that a
    /// one-sided joint never gains energy (Moreau 1999).
    fn acts_at_end(&self) -> bool {
        false
    }

    /// Whether the element is stable only between shells or beams ([`interlayer::check`]).
    fn only_between_shells(&self) -> bool {
        false
    }

    /// Largest penetration of a penalty at `motion` [m]; 0 without a penalty.
    fn penetration(&self, _motion: Motion<'_>) -> f64 {
        0.0
    }

    /// Moves the remaining violation of a penalty at `motion` into `history` (augmented Lagrangian).
    fn augment(&self, _motion: Motion<'_>, _history: &mut [f64]) {}
}

/// Internal state of an element for output; empty by default. No analysis depends on it.
pub trait Inspect {
    /// Stresses, resultants or pressure as linear functions of the dofs at the reference state.
    fn samples(&self) -> Vec<Sample> {
        Vec::new()
    }

    /// Shows every material point at the committed `motion` and `history`, in a fixed order.
    fn material_points(&self, _motion: Motion<'_>, _history: &[f64], _see: &mut dyn FnMut(&Inspection)) {}

    /// Strains and resultants of the sections at the committed `motion` and `history`; elements without sections have
    /// none.
    ///
    /// Errors: those of [`Element::respond`].
    fn sections(&self, _motion: Motion<'_>, _history: &[f64]) -> Result<Vec<SectionState>, ElementError> {
        Ok(Vec::new())
    }

    /// Energy that the element has dissipated so far [J], read from its committed history.
    fn dissipated(&self, _history: &[f64]) -> f64 {
        0.0
    }
}

/// An element without [`Inspect`] has no samples.
impl Inspect for dyn Element + '_ {
    fn samples(&self) -> Vec<Sample> {
        self.inspect().map_or_else(Vec::new, |own| own.samples())
    }

    fn material_points(&self, motion: Motion<'_>, history: &[f64], see: &mut dyn FnMut(&Inspection)) {
        if let Some(own) = self.inspect() {
            own.material_points(motion, history, see);
        }
    }

    fn sections(&self, motion: Motion<'_>, history: &[f64]) -> Result<Vec<SectionState>, ElementError> {
        self.inspect().map_or_else(|| Ok(Vec::new()), |own| own.sections(motion, history))
    }

    fn dissipated(&self, history: &[f64]) -> f64 {
        self.inspect().map_or(0.0, |own| own.dissipated(history))
    }
}

/// A second tangent, whose geometric part takes stresses extrapolated from the iterate before: Newton's method then needs
/// far fewer iterations in thin bodies with large rotations.
pub trait Mixed {
    /// Number of variables that are kept from one iteration to the next; zeros at the beginning of a step.
    fn mixed_len(&self) -> usize;

    /// [`Element::respond`] with that tangent. The force is that of [`Element::respond`], and so is the tangent at
    /// equilibrium.
    ///
    /// Errors: those of [`Element::respond`].
    fn respond_mixed(&self, trial: Trial<'_>, kept: &mut [f64], out: &mut Response) -> Result<(), ElementError>;
}

/// Linear buckling: at λ times the load, (K + λ K_G) φ = 0.
pub trait Buckling {
    /// Adds the geometric stiffness at the reference state of the stresses that belong to the linear displacement `values`.
    ///
    /// Errors: a material that fails in the reference state.
    fn geometric_stiffness(&self, values: &[f64], out: &mut LocalMatrix) -> Result<(), ElementError>;
}

/// Sum of the dofs of all nodes.
pub fn local_size(element: &dyn Element) -> usize {
    (0..element.nodes().len()).map(|a| element.dofs(a).len()).sum()
}

/// Stiffness of `element` at rest in its reference state.
///
/// Errors: those of [`Element::respond`].
pub fn reference_stiffness(element: &dyn Element) -> Result<LocalMatrix, ElementError> {
    let n = local_size(element);
    let mut old = vec![0.0; element.history_len()];
    element.init_history(&mut old);
    let mut new = old.clone();
    let mut response = Response::sized(n);
    let rest = Motion { values: &vec![0.0; n], rotations: &vec![UnitQuaternion::identity(); element.nodes().len()] };
    element.respond(Trial { motion: rest, old: &old, new: &mut new, want: Want::TANGENT }, &mut response)?;
    Ok(response.tangent)
}

/// Mass matrix of `element`.
pub fn reference_mass(element: &dyn Element) -> LocalMatrix {
    let mut out = LocalMatrix::zeros(local_size(element));
    element.mass(&mut out);
    out
}

impl Response {
    /// Zeros for `n` dofs.
    pub fn sized(n: usize) -> Response {
        Response { force: vec![0.0; n], tangent: LocalMatrix::zeros(n) }
    }

    /// Zeros for `n` dofs, keeping the storage.
    pub fn reset(&mut self, n: usize) {
        self.force.clear();
        self.force.resize(n, 0.0);
        self.tangent.reset(n);
    }

    /// Zeros for the force of `n` dofs, with room for a tangent that nobody reads.
    pub(crate) fn reset_force(&mut self, n: usize) {
        self.force.clear();
        self.force.resize(n, 0.0);
        self.tangent.n = n;
        if self.tangent.data.len() < n * n {
            self.tangent.data.resize(n * n, 0.0);
        }
    }
}
