//! The condensed liquid of a cylinder as an operator: [`CondensedLiquid`](super::CondensedLiquid) without its matrices.
//!
//! Harmonics do not couple, so that the elimination of the elevations in favour of sloshing modes happens in each of them:
//!
//! ```text
//! x̂ = (ŵ, q)      η̂ = Ψ q − Σ_{n>N} ψ_n (ψ_nᵀ M_ηw) ŵ          in every harmonic whose surface is free to slosh
//! ```
//!
//! The modes kept are the lowest of all harmonics together. On half a tank q is the amplitude of the half's own normalisation,
//! ½ q̂² = q² ([`Ring`]).

use super::harmonic::{Block, HarmonicLiquid};
use super::super_liquid::{CondenseError, Rim};
use crate::dofs::Dof;
use crate::element::{Element, ElementError, LocalMatrix, Response, Trial};
use crate::linalg::{Cholesky, Matrix, dot, generalized_eigen, product, transposed_product};
use crate::ring::{Ring, RingAmplitude, RingBlock, RingOperator};

/// Liquid over wall displacements `level · meridians + meridian`, outwards, and sloshing amplitudes.
#[derive(Clone, Debug)]
pub struct CircularLiquid {
    /// Mass and stiffness.
    pub operator: RingOperator,
    /// Circular frequencies of the sloshing modes [rad/s].
    pub omega: Vec<f64>,
    /// Elevation at the wall, its cosines.
    pub rim: Vec<Rim>,
}

impl CircularLiquid {
    /// The liquid with at most `count` sloshing modes, on the full circle or the half 0 ≤ θ ≤ π of it.
    ///
    /// Errors: half of an odd number of meridians; a mass or stiffness of the surface that is not positive definite.
    pub fn new(liquid: &HarmonicLiquid, half: bool, count: usize) -> Result<CircularLiquid, CondenseError> {
        let (sectors, levels) = (liquid.sectors(), liquid.levels());
        let ring = Ring::new(sectors, half).ok_or_else(|| CondenseError::Option {
            what: "meridians of half a liquid",
            found: sectors.to_string(),
            allowed: "an even number".into(),
        })?;
        let modes: Vec<Option<Modes>> =
            liquid.blocks.iter().map(|block| Modes::of(block, levels)).collect::<Result<_, _>>()?;
        let chosen = choose(&modes, &ring, count);
        let mut blocks = Vec::new();
        let mut rims = Vec::new();
        for (m, (block, modes)) in liquid.blocks.iter().zip(&modes).enumerate() {
            let own = chosen.iter().filter(|c| c.0 == m).count();
            let Some(modes) = modes else {
                blocks.push(RingBlock { mass: block.mass.clone(), stiffness: None });
                continue;
            };
            let t = modes.basis(own, levels);
            let project = |a: &Matrix| symmetric(transposed_product(&t, &product(a, &t)));
            blocks.push(RingBlock { mass: project(&block.mass), stiffness: Some(project(&block.stiffness)) });
            if let Some(rim) = &block.rim {
                rims.push((m, (0..t.cols).map(|j| dot(rim, t.column(j))).collect::<Vec<f64>>()));
            }
        }
        let mut amplitudes = Vec::new();
        let mut omega = Vec::new();
        for &(harmonic, slot) in &chosen {
            let single = harmonic == 0 || 2 * harmonic == sectors;
            for family in 0..if single { 1 } else { ring.families() } {
                amplitudes.push(RingAmplitude { harmonic, family, slot });
                omega.push(modes[harmonic].as_ref().map_or(0.0, |m| m.omega[slot]));
            }
        }
        let operator = RingOperator::new(ring, levels, blocks, amplitudes);
        let rim = rims.into_iter().map(|(m, own)| rim(&operator, m, &own)).collect();
        Ok(CircularLiquid { operator, omega, rim })
    }

    /// The element over these wall dofs and these of the amplitudes, with the damping ratio `ratio` of each sloshing mode.
    ///
    /// Errors: numbers of dofs that do not fit, a ratio that is not from 0 to 1.
    pub fn element(
        &self,
        wall: &[(usize, Dof)],
        surface: &[(usize, Dof)],
        ratio: f64,
    ) -> Result<CircularElement, CondenseError> {
        let fits = wall.len() == self.operator.wall() && surface.len() == self.omega.len();
        if !fits || !(0.0..1.0).contains(&ratio) {
            return Err(CondenseError::Option {
                what: "element of a condensed liquid",
                found: format!("{} wall dofs, {} of the surface, damping ratio {ratio}", wall.len(), surface.len()),
                allowed: format!("{} and {}, a ratio from 0 to 1", self.operator.wall(), self.omega.len()),
            });
        }
        let unknowns = wall.iter().chain(surface);
        Ok(CircularElement {
            nodes: unknowns.clone().map(|u| u.0).collect(),
            dofs: unknowns.map(|u| u.1).collect(),
            operator: self.operator.clone().with_damping(self.omega.iter().map(|omega| 2.0 * ratio * omega).collect()),
        })
    }
}

/// Sloshing modes of one harmonic.
struct Modes {
    omega: Vec<f64>,
    vectors: Matrix,
    /// M_ηw, and M_ηη⁻¹ M_ηw.
    coupling: Matrix,
    follow: Matrix,
}

impl Modes {
    /// `None` where the elevations are no unknowns.
    fn of(block: &Block, levels: usize) -> Result<Option<Modes>, CondenseError> {
        if block.elevations(levels) == 0 {
            return Ok(None);
        }
        let wall: Vec<usize> = (0..levels).collect();
        let surface: Vec<usize> = (levels..block.mass.rows).collect();
        let m = block.mass.select(&surface, &surface);
        let eigen = generalized_eigen(&block.stiffness.select(&surface, &surface), &m, None)?;
        let coupling = block.mass.select(&surface, &wall);
        let mut follow = coupling.clone();
        Cholesky::factor(&m)?.solve(&mut follow);
        Ok(Some(Modes { omega: eigen.omega, vectors: eigen.vectors, coupling, follow }))
    }

    /// (ŵ, η̂) of unit ŵ and unit amplitudes of the lowest `count` modes.
    fn basis(&self, count: usize, levels: usize) -> Matrix {
        let surface = self.coupling.rows;
        let all: Vec<usize> = (0..surface).collect();
        let modes = self.vectors.select(&all, &(0..count).collect::<Vec<_>>());
        let part = product(&modes, &transposed_product(&modes, &self.coupling));
        let mut t = Matrix::zeros(levels + surface, levels + count);
        for j in 0..levels {
            t.add(j, j, 1.0);
            for i in 0..surface {
                t.add(levels + i, j, part.get(i, j) - self.follow.get(i, j));
            }
        }
        for j in 0..count {
            for i in 0..surface {
                t.add(levels + i, levels + j, modes.get(i, j));
            }
        }
        t
    }
}

/// (harmonic, number) of the lowest modes by ascending frequency; both families of a harmonic or none.
fn choose(modes: &[Option<Modes>], ring: &Ring, count: usize) -> Vec<(usize, usize)> {
    let mut all: Vec<(f64, usize, usize)> = Vec::new();
    for (m, modes) in modes.iter().enumerate() {
        let omega = modes.iter().flat_map(|modes| modes.omega.iter().enumerate());
        all.extend(omega.map(|(k, omega)| (*omega, m, k)));
    }
    all.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let mut room = count;
    let mut out = Vec::new();
    for (_, m, k) in all {
        let single = m == 0 || 2 * m == ring.sectors();
        let wanted = if single { 1 } else { ring.families() };
        if wanted > room {
            break;
        }
        room -= wanted;
        out.push((m, k));
    }
    out
}

/// Rows over all unknowns of harmonic `m` of the elevation, `own` over (ŵ, q̂).
fn rim(operator: &RingOperator, m: usize, own: &[f64]) -> Rim {
    let (ring, levels) = (operator.ring(), operator.levels());
    // Unknowns of a half are (ŵ, q̂)/√2.
    let scale = ring.scale(m) * if ring.is_half() { 2.0_f64.sqrt() } else { 1.0 };
    let over = |family: usize| {
        let mut row = vec![0.0; operator.size()];
        let mut room = ring.room();
        for (level, out) in row[..operator.wall()].chunks_exact_mut(ring.meridians()).enumerate() {
            let get = |n: usize, f: usize| if n == m && f == family { scale * own[level] } else { 0.0 };
            ring.synthesise(false, crate::ring::Weight::Forces, &mut room, get, out);
        }
        for (a, out) in operator.amplitudes().iter().zip(&mut row[operator.wall()..]) {
            if a.harmonic == m && a.family == family {
                *out = scale * own[levels + a.slot];
            }
        }
        row
    };
    Rim { harmonic: m as u32, row: over(0), sine: if m > 0 && ring.families() > 1 { over(1) } else { Vec::new() } }
}

/// Symmetric to the last digit.
fn symmetric(mut a: Matrix) -> Matrix {
    for j in 0..a.cols {
        for i in 0..j {
            let mean = 0.5 * (a.get(i, j) + a.get(j, i));
            a.data[i + j * a.rows] = mean;
            a.data[j + i * a.rows] = mean;
        }
    }
    a
}

/// The liquid as an element that is not assembled.
#[derive(Clone, Debug)]
pub struct CircularElement {
    nodes: Vec<usize>,
    dofs: Vec<Dof>,
    operator: RingOperator,
}

fn add_columns(from: &Matrix, out: &mut LocalMatrix) {
    out.data.iter_mut().zip(&from.data).for_each(|(o, v)| *o += v);
}

impl Element for CircularElement {
    crate::answers!("circular_liquid", nodes; own_axes linear);

    fn dofs(&self, node: usize) -> &'static [Dof] {
        let own = self.dofs[node].index();
        Dof::slice(own..own + 1)
    }

    /// Dense, for small liquids; analyses use [`Element::operator`].
    fn mass(&self, out: &mut LocalMatrix) {
        add_columns(&self.operator.dense_mass(), out);
    }

    fn respond(&self, Trial { motion, want, .. }: Trial<'_>, out: &mut Response) -> Result<(), ElementError> {
        if want.force {
            self.operator.add_stiffness(1.0, motion.values, &mut out.force);
        }
        if want.tangent {
            add_columns(&self.operator.dense_stiffness(), &mut out.tangent);
        }
        Ok(())
    }

    fn damping(&self, out: &mut LocalMatrix) -> bool {
        let own = self.operator.damping();
        for (k, c) in own.iter().enumerate() {
            let at = self.operator.wall() + k;
            out.add(at, at, *c);
        }
        own.iter().any(|c| *c != 0.0)
    }

    fn operator(&self) -> Option<&RingOperator> {
        Some(&self.operator)
    }
}

#[cfg(test)]
mod tests;
