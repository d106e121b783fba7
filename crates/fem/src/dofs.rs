//! Unknowns of a model: (node, dof) → equation.

use std::fmt;

/// Kind of unknown at a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Dof {
    /// Displacement along x, or along the first axis of the node's frame [m].
    Ux,
    /// Displacement along y, or along the second axis of the node's frame [m].
    Uy,
    /// Displacement along z, or along the third axis of the node's frame [m].
    Uz,
    /// Rotation about x, or about the first axis of the node's rotation frame [rad].
    Rx,
    /// Rotation about y, or about the second axis of the node's rotation frame [rad].
    Ry,
    /// Rotation about z, or about the third axis of the node's rotation frame [rad]; smooth shell nodes have their
    /// director there and no stiffness about it.
    Rz,
    /// Displacement potential of a liquid φ, u = ∇φ [m²].
    Phi,
    /// Elevation of a liquid's free surface η [m].
    Eta,
    /// Amplitude of a mode (sloshing mode, fixed-interface mode) at a separate node; zero in rigid-body motions.
    Amplitude,
}

/// Number of kinds.
pub const KINDS: usize = 9;

impl Dof {
    /// All kinds, in order.
    pub const ALL: [Dof; KINDS] =
        [Dof::Ux, Dof::Uy, Dof::Uz, Dof::Rx, Dof::Ry, Dof::Rz, Dof::Phi, Dof::Eta, Dof::Amplitude];

    /// Position in [`Dof::ALL`].
    pub fn index(self) -> usize {
        self as usize
    }

    /// A run of kinds.
    ///
    /// Panics beyond the last kind.
    pub fn slice(range: std::ops::Range<usize>) -> &'static [Dof] {
        const ALL: &[Dof] = &Dof::ALL;
        &ALL[range]
    }

    /// Displacements.
    pub const TRANSLATIONS: &'static [Dof] = &[Dof::Ux, Dof::Uy, Dof::Uz];
    /// Displacements and rotations.
    pub const SHELL: &'static [Dof] = &[Dof::Ux, Dof::Uy, Dof::Uz, Dof::Rx, Dof::Ry, Dof::Rz];
}

impl fmt::Display for Dof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(["u_x", "u_y", "u_z", "r_x", "r_y", "r_z", "phi", "eta", "amplitude"][self.index()])
    }
}

/// Marks (node, dof) pairs that are not unknowns.
const NONE: u32 = u32::MAX;

/// Numbers the unknowns: those dofs that some element uses and no support holds, node by node.
#[derive(Clone, Debug, PartialEq)]
pub struct DofMap {
    equation: Vec<[u32; KINDS]>,
    /// (node, dof) of each equation.
    unknowns: Vec<(u32, Dof)>,
}

impl DofMap {
    /// `used[node][dof]`: some element uses it; `held[node][dof]`: a support holds it.
    pub fn new(used: &[[bool; KINDS]], held: &[[bool; KINDS]]) -> DofMap {
        let mut unknowns = Vec::new();
        let number = |(node, (used, held)): (usize, (&[bool; KINDS], &[bool; KINDS]))| {
            let mut row = [NONE; KINDS];
            for dof in Dof::ALL {
                if used[dof.index()] && !held[dof.index()] {
                    row[dof.index()] = unknowns.len() as u32;
                    unknowns.push((node as u32, dof));
                }
            }
            row
        };
        let equation = used.iter().zip(held).enumerate().map(number).collect();
        DofMap { equation, unknowns }
    }

    /// Number of equations.
    pub fn len(&self) -> usize {
        self.unknowns.len()
    }

    /// Whether there is no unknown at all.
    pub fn is_empty(&self) -> bool {
        self.unknowns.is_empty()
    }

    /// Equation of (node, dof), `None` if it is held or not used.
    pub fn equation(&self, node: usize, dof: Dof) -> Option<usize> {
        match self.equation[node][dof.index()] {
            NONE => None,
            e => Some(e as usize),
        }
    }

    /// Node and dof of an equation.
    pub fn unknown(&self, equation: usize) -> (usize, Dof) {
        let (node, dof) = self.unknowns[equation];
        (node as usize, dof)
    }

    /// Equations of all unknowns of one kind, ascending.
    pub fn of_kind(&self, dof: Dof) -> Vec<usize> {
        (0..self.len()).filter(|&e| self.unknowns[e].1 == dof).collect()
    }
}
