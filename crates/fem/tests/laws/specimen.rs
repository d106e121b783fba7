//! An element under test, and its expected properties.

use fem::dofs::{Dof, KINDS};
use fem::element::{Element, LocalMatrix, Response, Trial, local_size};
use nalgebra::{UnitQuaternion, Vector3};

use crate::motion::Moved;

/// Builds an element in axes turned about the origin.
pub(crate) type Build = Box<dyn Fn(&UnitQuaternion<f64>) -> Box<dyn Element>>;

/// Components of a field at a point, in the order of [`Dof::ALL`].
pub(crate) type Field = fn([f64; 3]) -> [f64; KINDS];

/// An element, its place, and its expected properties.
pub(crate) struct Specimen {
    /// Its type, as in `impl Element for …`.
    pub(crate) of: &'static str,
    /// Which of that type.
    pub(crate) what: &'static str,
    pub(crate) build: Build,
    /// Positions of its local nodes [m].
    pub(crate) positions: Vec<[f64; 3]>,
    /// Size of the displacements that make it work [m]; rotations are that of a metre's length.
    pub(crate) amplitude: f64,
    pub(crate) tangent: Tangent,
    pub(crate) rotations: Rotations,
    /// Rigid motions that meet a force at rest, in the order of [`crate::rigid::MODES`], and why.
    pub(crate) resists: (&'static [usize], &'static str),
    /// Why there is a force at rest.
    pub(crate) load: Option<&'static str>,
    pub(crate) turns: Turns,
    pub(crate) mass: Mass,
}

/// How many specimens have an ability at least, so that its law is put to some.
pub(crate) struct Least {
    /// Dissipate energy.
    pub(crate) dissipate: usize,
    /// Have a mixed tangent.
    pub(crate) mixed: usize,
    /// Buckle.
    pub(crate) buckle: usize,
    /// Change their history.
    pub(crate) change: usize,
}

/// How the tangent belongs to the force.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Tangent {
    /// It is the derivative.
    Derivative,
    /// It is the symmetric part of the derivative, because …
    SymmetricPart(&'static str),
    /// It misses the derivative by up to this part of the largest entry, because …
    Near(f64, &'static str),
}

/// Rotations for which the element is meant.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Rotations {
    /// Any: a rotation on top of a motion turns the forces.
    Finite,
    /// Those of linear theory, because …
    Small(&'static str),
}

/// Axes in which the element can be built.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Turns {
    /// All.
    Any,
    /// Turned about the global y axis, because …
    AboutY(&'static str),
    /// Turned about the global z axis, because …
    AboutZ(&'static str),
    /// None other, because …
    None(&'static str),
}

/// Sum of the mass matrix.
#[derive(Clone, Copy)]
pub(crate) enum Mass {
    /// This mass [kg] in every direction that its dofs have, with its weight.
    Of(f64),
    /// The same along one axis only, because …
    Along(usize, f64, &'static str),
    /// This mass [kg], but no weight, because …
    Weightless(f64, &'static str),
    /// A form that joins two fields: leftᵀ M right is `value`.
    Joins { left: Field, right: Field, value: f64 },
    /// There is one, whose sum is tested elsewhere, because …
    Elsewhere(&'static str),
    /// None, because …
    None(&'static str),
}

/// Why most elements are linear.
const LINEAR: &str = "it is linear: strains are those of small displacements";

impl Turns {
    /// A turn about the origin, as long as there may be one.
    pub(crate) fn turn(self) -> Option<UnitQuaternion<f64>> {
        let vector = match self {
            Turns::Any => Vector3::new(0.5, -0.8, 1.1),
            Turns::AboutY(_) => Vector3::new(0.0, 0.7, 0.0),
            Turns::AboutZ(_) => Vector3::new(0.0, 0.0, 0.7),
            Turns::None(_) => return None,
        };
        Some(UnitQuaternion::from_scaled_axis(vector))
    }
}

impl Specimen {
    /// A specimen of small rotations that can be built in any axes, has its tangent for derivative and no mass.
    pub(crate) fn new(
        of: &'static str,
        what: &'static str,
        positions: &[[f64; 3]],
        build: impl Fn(&UnitQuaternion<f64>) -> Box<dyn Element> + 'static,
    ) -> Specimen {
        Specimen {
            of,
            what,
            build: Box::new(build),
            positions: positions.to_vec(),
            amplitude: 0.05,
            tangent: Tangent::Derivative,
            rotations: Rotations::Small(LINEAR),
            resists: (&[], ""),
            load: None,
            turns: Turns::Any,
            mass: Mass::None("it has no volume"),
        }
    }

    /// In the axes of its entry.
    pub(crate) fn element(&self) -> Box<dyn Element> {
        (self.build)(&UnitQuaternion::identity())
    }

    /// Local dofs: node and kind.
    pub(crate) fn locals(&self) -> Vec<(usize, Dof)> {
        let element = self.element();
        assert_eq!(element.nodes().len(), self.positions.len(), "{self}: positions");
        let of = |a: usize| element.dofs(a).iter().map(move |&d| (a, d));
        (0..element.nodes().len()).flat_map(of).collect()
    }

    /// Whether its first node has a displacement along that axis.
    pub(crate) fn moves(&self, axis: usize) -> bool {
        self.locals().contains(&(0, Dof::ALL[axis]))
    }

    /// Values of a field at the local dofs.
    pub(crate) fn row(&self, field: impl Fn([f64; 3]) -> [f64; KINDS]) -> Vec<f64> {
        let at = |&(a, dof): &(usize, Dof)| field(self.positions[a])[dof.index()];
        self.locals().iter().map(at).collect()
    }
}

impl std::fmt::Display for Specimen {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}, {}", self.of, self.what)
    }
}

/// Response of an element.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Answer {
    pub(crate) force: Vec<f64>,
    pub(crate) tangent: LocalMatrix,
    /// Trial history.
    pub(crate) history: Vec<f64>,
}

/// Force, tangent and trial history at a motion, with the committed history `old`.
pub(crate) fn answer(element: &dyn Element, moved: &Moved, old: &[f64]) -> Answer {
    asked(element, moved, old, fem::element::Want::ALL)
}

/// The same for the requested results. The trial history starts with values that no element may read.
pub(crate) fn asked(element: &dyn Element, moved: &Moved, old: &[f64], want: fem::element::Want) -> Answer {
    let mut out = Response::sized(local_size(element));
    let mut history = vec![f64::NAN; old.len()];
    element
        .respond(Trial { motion: moved.motion(), old, new: &mut history, want }, &mut out)
        .unwrap_or_else(|error| panic!("{}: {error}", element.kind()));
    assert!(history.iter().all(|h| h.is_finite()), "{}: history", element.kind());
    Answer { force: out.force, tangent: out.tangent, history }
}

/// The initial history of an element.
pub(crate) fn virgin(element: &dyn Element) -> Vec<f64> {
    let mut history = vec![0.0; element.history_len()];
    element.init_history(&mut history);
    history
}

/// Largest entry.
pub(crate) fn largest(of: &[f64]) -> f64 {
    of.iter().fold(0.0, |m, x| m.max(x.abs()))
}

/// K x.
pub(crate) fn times(matrix: &LocalMatrix, x: &[f64]) -> Vec<f64> {
    matrix.to_matrix().times(x)
}

/// Whether the matrix is symmetric to rounding: sums of 10² terms that cancel by 10² leave 10⁻¹² of the largest entry.
pub(crate) fn symmetric(matrix: &LocalMatrix) -> bool {
    let allowed = 1e-12 * largest(&matrix.data);
    (0..matrix.n).all(|j| (0..j).all(|i| (matrix.get(i, j) - matrix.get(j, i)).abs() <= allowed))
}
