//! The linear system of a model in the form that reductions and eigenvalue solvers want: K positive definite, M positive
//! semi-definite.
//!
//! With a displacement liquid these are the assembled matrices. With a potential liquid φ is eliminated,
//!
//! ```text
//! H φ = B u + S η          M = M_s ⊕ 0 + ρ Fᵀ H⁺ F,  F = [B S]          K = K_s ⊕ ρ g S
//! ```
//!
//! without ever forming M: a product with it is one solve with H. A constant φ has no energy, so that H is solved with one
//! potential held; motions must keep the liquid's volume, cᵀ x = 0 with c = Fᵀ 1, and every solve with K is projected on
//! them,
//!
//! ```text
//! x = K⁻¹ b − K⁻¹ c (cᵀ K⁻¹ b)/(cᵀ K⁻¹ c)
//! ```
//!
//! in which an arbitrary constant in φ, which adds a multiple of c to b, drops out. φ is given with mean zero over the
//! surface; its mean follows from the pressure there, −ρ φ̈ = ρ g η on average.

use std::sync::Arc;

use fem::assembly::Assembler;
use fem::dofs::Dof;
use fem::linalg::{Factor, Kind, Matrix, Ordering, Symbolic, Symmetric, dot};
use fem::model::Model;

use super::memory::allow;
use super::poles::VECTORS;
use crate::FeError;
use crate::coupled::SparseRow;
use crate::error::{failed, failure};

/// Entries (row, column, value) of a rectangular block between equations of the model.
type Block = Vec<(usize, usize, f64)>;

/// Liquid by its potential, eliminated.
struct Potential {
    /// Equation of the potential that is held.
    held: usize,
    /// Equations of the others.
    free: Vec<usize>,
    /// ρ H on them.
    factor: Factor,
    /// ρ F by equations: row φ, column u or η.
    coupling: Block,
    /// ρ c.
    flux: Vec<f64>,
    /// K⁻¹ ρ c.
    lift: Vec<f64>,
    /// Mean of φ over the surface: equations of φ and weights.
    mean: SparseRow,
}

/// A factor of K + s M, and the equations it is of: those of φ as well where there are any.
struct Pole {
    /// s [rad²/s²].
    place: f64,
    factor: Factor,
    whole: bool,
}

/// K and M of a model over all its unknowns; those of φ are zero in K, and in vectors follow from the others.
pub struct System {
    stiffness: Symmetric,
    /// Mass without the blocks of φ.
    mass: Symmetric,
    /// Equations that are not potentials.
    own: Vec<usize>,
    factor: Factor,
    potential: Option<Potential>,
    /// Mean elevation of a potential liquid's surface over the unknowns, empty with a displacement liquid.
    pub mean_elevation: SparseRow,
    /// Bytes of the factors.
    pub bytes: u64,
    /// Factors of K + s M for further poles s; those of a potential liquid hold φ.
    poles: Vec<Pole>,
}

/// Matrices and their symbolic factors.
struct Phase {
    stiffness: Symmetric,
    mass: Symmetric,
    own: Vec<usize>,
    phi: Vec<usize>,
    own_stiffness: Symmetric,
    symbolic: Arc<Symbolic>,
    /// Symbolic factor of all unknowns, where a pole needs it.
    whole: Option<Arc<Symbolic>>,
    /// Equations of φ but for the held one, ρ H, its symbolic factor.
    liquid: Option<(Vec<usize>, Symmetric, Arc<Symbolic>)>,
    bytes: u64,
}

impl Phase {
    fn new(model: &Model, assembler: &Assembler, poles: usize) -> Result<Phase, FeError> {
        let stiffness = assembler.stiffness(model).map_err(failed)?;
        let mass = assembler.mass(model);
        let dofs = model.dofs();
        let (phi, own): (Vec<usize>, Vec<usize>) = (0..dofs.len()).partition(|&e| dofs.unknown(e).1 == Dof::Phi);
        let own_stiffness = stiffness.submatrix(&own);
        let symbolic = self::symbolic(&own_stiffness, model, &own)?;
        let mut entries = symbolic.entries();
        let whole = if poles > 0 && !phi.is_empty() {
            let all: Vec<usize> = (0..dofs.len()).collect();
            Some(self::symbolic(&stiffness, model, &all)?)
        } else {
            None
        };
        entries += poles * whole.as_ref().unwrap_or(&symbolic).entries();
        let liquid = if phi.is_empty() {
            None
        } else {
            let free = phi[1..].to_vec();
            let mut h = mass.submatrix(&free);
            h.values.iter_mut().for_each(|v| *v = -*v);
            let symbolic = self::symbolic(&h, model, &free)?;
            entries += symbolic.entries();
            Some((free, h, symbolic))
        };
        // Factors, the matrices themselves, and the vectors of a reduction with their images.
        let vectors = 3 * VECTORS;
        let bytes = 8 * (entries + 4 * stiffness.pattern.places() + vectors * dofs.len()) as u64;
        Ok(Phase { stiffness, mass, own, phi, own_stiffness, symbolic, whole, liquid, bytes })
    }
}

impl System {
    /// Factors the matrices of `model`; `limit` is the memory allowed for them [bytes]. `poles` s > 0 [rad²/s²] are those at which
    /// K + s M is factored as well, with the potentials where there are any.
    ///
    /// Errors: more memory than allowed, before anything is factored; a matrix that is not positive definite.
    pub fn new(model: &Model, assembler: &Assembler, poles: &[f64], limit: u64) -> Result<System, FeError> {
        let phase = Phase::new(model, assembler, poles.len())?;
        allow(phase.bytes, limit)?;
        let Phase { stiffness, mass: full_mass, own, phi, own_stiffness, symbolic, whole, liquid, bytes } = phase;
        let own_symbolic = symbolic.clone();
        let factor = symbolic.factor(&own_stiffness, Kind::Definite).map_err(failure("the stiffness matrix"))?;
        let mut system = System {
            stiffness,
            mass: without(&full_mass, &phi),
            own,
            factor,
            potential: None,
            mean_elevation: Vec::new(),
            bytes,
            poles: Vec::new(),
        };
        for &pole in poles {
            let mut shifted = system.stiffness.clone();
            let factor = match &whole {
                // In three fields: −ρ H is negative semi-definite, and the volume of the liquid is kept.
                Some(symbolic) => {
                    shifted.add(pole, &full_mass);
                    symbolic.factor(&shifted, Kind::QuasiDefinite)
                }
                None => {
                    shifted.add(pole, &system.mass);
                    own_symbolic.factor(&shifted, Kind::Definite)
                }
            };
            let factor = factor.map_err(failure("K + s M"))?;
            system.poles.push(Pole { place: pole, factor, whole: whole.is_some() });
        }
        if let Some((free, h, symbolic)) = liquid {
            system.add_potential(model, &full_mass, &phi, (free, h, symbolic))?;
        }
        Ok(system)
    }

    fn add_potential(
        &mut self,
        model: &Model,
        full_mass: &Symmetric,
        phi: &[usize],
        (free, h, symbolic): (Vec<usize>, Symmetric, Arc<Symbolic>),
    ) -> Result<(), FeError> {
        let dofs = model.dofs();
        let coupling: Block =
            full_mass.block(phi, &self.own).into_iter().map(|(i, j, v)| (phi[i], self.own[j], v)).collect();
        let mut flux = vec![0.0; dofs.len()];
        let (mut mean, mut area) = (vec![0.0; dofs.len()], 0.0);
        for &(i, j, v) in &coupling {
            flux[j] += v;
            if dofs.unknown(j).1 == Dof::Eta {
                mean[i] += v;
                area += v;
            }
        }
        let weights = |values: &[f64]| -> SparseRow {
            let entries = values.iter().enumerate().filter(|(_, v)| **v != 0.0);
            entries.map(|(i, v)| (i, v / area)).collect()
        };
        let elevation: Vec<f64> =
            (0..dofs.len()).map(|e| if dofs.unknown(e).1 == Dof::Eta { flux[e] } else { 0.0 }).collect();
        self.mean_elevation = weights(&elevation);
        let factor = symbolic.factor(&h, Kind::Definite).map_err(failure("the liquid matrix H"))?;
        let lift = self.solve_plain(&flux)?;
        self.potential = Some(Potential { held: phi[0], free, factor, coupling, lift, mean: weights(&mean), flux });
        Ok(())
    }

    /// Number of unknowns, potentials included.
    pub fn size(&self) -> usize {
        self.stiffness.size()
    }

    /// The assembled stiffness matrix.
    pub fn stiffness(&self) -> &Symmetric {
        &self.stiffness
    }

    /// K⁻¹ b without keeping the volume.
    fn solve_plain(&self, b: &[f64]) -> Result<Vec<f64>, FeError> {
        let own: Vec<f64> = self.own.iter().map(|&e| b[e]).collect();
        let solved = self.factor.solve_vector(&own).map_err(failure("the stiffness matrix"))?;
        let mut x = vec![0.0; b.len()];
        for (&e, v) in self.own.iter().zip(solved) {
            x[e] = v;
        }
        Ok(x)
    }

    /// K⁻¹ b among the motions that keep the liquid's volume; the entries of φ are zero.
    ///
    /// Errors: not enough memory.
    pub fn solve(&self, b: &[f64]) -> Result<Vec<f64>, FeError> {
        let mut x = self.solve_plain(b)?;
        if let Some(liquid) = &self.potential {
            let factor = dot(&liquid.flux, &x) / dot(&liquid.flux, &liquid.lift);
            for (x, l) in x.iter_mut().zip(&liquid.lift) {
                *x -= factor * l;
            }
        }
        Ok(x)
    }

    /// Number of poles: s = 0 and those asked for.
    pub fn poles(&self) -> usize {
        1 + self.poles.len()
    }

    /// Place s of a pole [rad²/s²].
    pub fn place(&self, pole: usize) -> f64 {
        match pole {
            0 => 0.0,
            pole => self.poles[pole - 1].place,
        }
    }

    /// (K + s M)⁻¹ b for pole `pole`; the first is s = 0.
    ///
    /// Errors: not enough memory.
    pub fn solve_at(&self, pole: usize, b: &[f64]) -> Result<Vec<f64>, FeError> {
        match pole {
            0 => self.solve(b),
            pole => {
                let pole = &self.poles[pole - 1];
                let mut right = b.to_vec();
                if pole.whole {
                    // φ follows from the other unknowns.
                    let potentials = self.potential.iter().flat_map(|p| p.free.iter().chain([&p.held]));
                    potentials.for_each(|&e| right[e] = 0.0);
                }
                pole.factor.solve_vector(&right).map_err(failure("K + s M"))
            }
        }
    }

    /// Sets the entries of φ in `x` to H⁺ F x, with mean zero over the surface; nothing with a displacement liquid.
    ///
    /// Errors: not enough memory.
    pub fn complete(&self, x: &mut [f64]) -> Result<(), FeError> {
        let Some(liquid) = &self.potential else { return Ok(()) };
        let mut right = vec![0.0; x.len()];
        for &(i, j, v) in &liquid.coupling {
            right[i] += v * x[j];
        }
        let phi = self.potential_of(&right)?;
        for (x, phi) in x.iter_mut().zip(phi) {
            if let Some(phi) = phi {
                *x = phi;
            }
        }
        Ok(())
    }

    /// φ of the flux `right` (ρ times, by equations of φ): `None` for other equations.
    ///
    /// Errors: not enough memory.
    pub fn potential_of(&self, right: &[f64]) -> Result<Vec<Option<f64>>, FeError> {
        let mut out = vec![None; right.len()];
        let Some(liquid) = &self.potential else { return Ok(out) };
        let own: Vec<f64> = liquid.free.iter().map(|&e| right[e]).collect();
        let solved = liquid.factor.solve_vector(&own).map_err(failure("the liquid matrix H"))?;
        let mut phi = vec![0.0; right.len()];
        for (&e, v) in liquid.free.iter().zip(&solved) {
            phi[e] = *v;
        }
        let mean: f64 = liquid.mean.iter().map(|&(e, w)| w * phi[e]).sum();
        for &e in &liquid.free {
            out[e] = Some(phi[e] - mean);
        }
        out[liquid.held] = Some(-mean);
        Ok(out)
    }

    /// M x for an `x` whose potentials are complete; the entries of φ are zero.
    pub fn mass_times(&self, x: &[f64]) -> Vec<f64> {
        let mut y = self.mass.times(x);
        if let Some(liquid) = &self.potential {
            for &(i, j, v) in &liquid.coupling {
                y[j] += v * x[i];
            }
        }
        y
    }

    /// K x.
    pub fn stiffness_times(&self, x: &[f64]) -> Vec<f64> {
        self.stiffness.times(x)
    }
}

/// Symbolic factor of the part of a model's matrix that belongs to `equations`.
///
/// Errors: not enough memory.
pub fn symbolic(matrix: &Symmetric, model: &Model, equations: &[usize]) -> Result<Arc<Symbolic>, FeError> {
    let nodes: Vec<usize> = equations.iter().map(|&e| model.dofs().unknown(e).0).collect();
    let ordering = Ordering::best(&matrix.pattern, &nodes, model.nodes());
    Symbolic::new(matrix.pattern.clone(), &ordering).map(Arc::new).map_err(failure("the symbolic factor"))
}

/// Columns of a dense matrix from vectors.
pub fn columns(vectors: &[Vec<f64>]) -> Matrix {
    let rows = vectors.first().map_or(0, Vec::len);
    Matrix { rows, cols: vectors.len(), data: vectors.concat() }
}

/// A matrix without the entries of these unknowns.
fn without(matrix: &Symmetric, unknowns: &[usize]) -> Symmetric {
    let mut rest = matrix.clone();
    let mut gone = vec![false; rest.pattern.size()];
    unknowns.iter().for_each(|&e| gone[e] = true);
    for j in 0..gone.len() {
        for p in rest.pattern.starts[j]..rest.pattern.starts[j + 1] {
            if gone[j] || gone[rest.pattern.rows[p]] {
                rest.values[p] = 0.0;
            }
        }
    }
    rest
}
