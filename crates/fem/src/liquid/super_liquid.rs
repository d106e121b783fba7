//! A linear liquid as one element of a model: condensed onto the wetted wall, and onto the surface or its sloshing modes.
//!
//! ```text
//! x = (w, η)      M_f = ρ Fᵀ H⁻¹ F      K_f = ρ g S on η                       all unknowns of the surface: exact
//! x = (w, q)      η = Ψ q − Σ_{n>N} ψ_n (ψ_nᵀ M_ηw) w                          N sloshing modes
//! ```
//!
//! with the sloshing modes of the tank at rest, K_ηη ψ = ω² M_ηη ψ, ψᵀ M_ηη ψ = 1. The modes that are left out follow the wall
//! without gravity (p = 0 at the surface), so that the mass of the liquid is complete for any N; with
//! all modes the basis is complete and the result equals that of η. q_n is the true amplitude of mode n of the surface, and the
//! matrices have the form of [`crate::element::super_element`] with c_n = 1.
//!
//! Source: Morand & Ohayon 1995, chapter 5; Craig & Bampton 1968.

use super::HarmonicLiquid;
use crate::dofs::Dof;
use crate::element::ElementError;
use crate::element::super_element::SuperElement;
use crate::linalg::{LinalgError, Matrix, generalized_eigen, product, transposed_product};

/// Failure of a condensation.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CondenseError {
    /// The linear algebra failed.
    #[error(transparent)]
    Linalg(#[from] LinalgError),
    /// An element of the liquid failed, or the one that is made.
    #[error(transparent)]
    Element(#[from] ElementError),
    /// A liquid with other elements in it, or the other way round.
    #[error("{what}: found {found}, allowed {allowed}")]
    Option {
        /// The wrong quantity.
        what: &'static str,
        /// Found.
        found: String,
        /// Allowed.
        allowed: String,
    },
}

/// Matrices of a liquid over wall displacements and then elevations or sloshing amplitudes.
#[derive(Clone, Debug, PartialEq)]
pub struct CondensedLiquid {
    /// Number of wall displacements.
    pub wall: usize,
    /// M_f.
    pub mass: Matrix,
    /// K_f.
    pub stiffness: Matrix,
    /// Circular frequencies of the sloshing modes [rad/s], if amplitudes have taken the place of the elevations.
    pub omega: Vec<f64>,
    /// Elevation at the wall of a cylinder; empty where the harmonics are not known.
    pub rim: Vec<Rim>,
}

/// One harmonic of the elevation at the wall: η(θ) = Σ (row · x) cos mθ + (sine · x) sin mθ.
#[derive(Clone, Debug, PartialEq)]
pub struct Rim {
    /// m.
    pub harmonic: u32,
    /// Coefficients of the cosine over the unknowns of the liquid.
    pub row: Vec<f64>,
    /// Those of the sine; empty where it does not exist: m = 0, half a tank.
    pub sine: Vec<f64>,
}

impl CondensedLiquid {
    /// The liquid of [`HarmonicLiquid`]: wall displacements `level * sectors + sector`, outwards; then the amplitudes of its
    /// elevations, which rest in horizontal translations. These coordinates do not contain a vertical acceleration: its load
    /// is the hydrostatic pressure times a_z/g.
    pub fn of_harmonic(liquid: &HarmonicLiquid) -> CondensedLiquid {
        let (n, levels) = (liquid.wall() + liquid.elevations(), liquid.levels());
        let unit = identity(n);
        let rim = |(m, block): (usize, &super::harmonic::Block)| -> Option<Rim> {
            let (own, &(cosine, _)) = (block.rim.as_ref()?, block.columns.first()?);
            // Columns of cosine and sine have the same factor.
            let scale = liquid.fourier.get(0, cosine);
            let over = |&(column, first): &(usize, usize)| {
                let mut row = vec![0.0; n];
                for (level, value) in own[..levels].iter().enumerate() {
                    for k in 0..liquid.sectors() {
                        row[level * liquid.sectors() + k] = scale * value * liquid.fourier.get(k, column);
                    }
                }
                for (k, value) in own[levels..].iter().enumerate() {
                    row[liquid.wall() + first + k] = scale * value;
                }
                row
            };
            Some(Rim {
                harmonic: m as u32,
                row: block.columns.first().map(over)?,
                sine: block.columns.get(1).map_or_else(Vec::new, over),
            })
        };
        CondensedLiquid {
            wall: liquid.wall(),
            mass: liquid.mass(&unit),
            stiffness: liquid.stiffness(&unit),
            omega: Vec::new(),
            rim: liquid.blocks.iter().enumerate().filter_map(rim).collect(),
        }
    }

    /// The half of it at 0 ≤ θ ≤ π, for motions that are symmetric about the plane θ = 0, π: wall displacements
    /// `level * (N/2 + 1) + meridian`. With w = T w_half (every meridian except the first and the last counts twice) and the
    /// cosines F_m of the harmonics
    ///
    /// ```text
    /// M_half = ½ Tᵀ M T = ½ Σ_m (G_m ⊗ 1) M^(m) (G_m ⊗ 1)ᵀ ,   G_m = Tᵀ F_m
    /// ```
    ///
    /// Errors: an odd number of meridians.
    pub fn of_harmonic_half(liquid: &HarmonicLiquid) -> Result<CondensedLiquid, CondenseError> {
        let (sectors, levels) = (liquid.sectors(), liquid.levels());
        if !sectors.is_multiple_of(2) {
            return Err(CondenseError::Option {
                what: "meridians of half a liquid",
                found: sectors.to_string(),
                allowed: "an even number".into(),
            });
        }
        let meridians = sectors / 2 + 1;
        let wall = meridians * levels;
        let surface: usize = liquid.blocks.iter().map(|b| b.elevations(levels)).sum();
        let mut out = CondensedLiquid {
            wall,
            mass: Matrix::zeros(wall + surface, wall + surface),
            stiffness: Matrix::zeros(wall + surface, wall + surface),
            omega: Vec::new(),
            rim: Vec::new(),
        };
        let mut first = wall;
        for (m, block) in liquid.blocks.iter().enumerate() {
            let Some(&(column, _)) = block.columns.first() else { continue };
            let g: Vec<f64> = (0..meridians)
                .map(|k| {
                    let twice = if k == 0 || 2 * k == sectors { 1.0 } else { 2.0 };
                    twice * liquid.fourier.get(k, column)
                })
                .collect();
            // Unknown of the half and its factor, for each unknown of the block and each meridian.
            let elevations = block.elevations(levels);
            let places = |i: usize| -> Vec<(usize, f64)> {
                if i < levels {
                    (0..meridians).map(|k| (i * meridians + k, g[k])).collect()
                } else {
                    vec![(first + i - levels, 1.0)]
                }
            };
            let spread: Vec<Vec<(usize, f64)>> = (0..levels + elevations).map(places).collect();
            for (from, to) in [(&block.mass, &mut out.mass), (&block.stiffness, &mut out.stiffness)] {
                for j in 0..spread.len() {
                    for i in 0..spread.len() {
                        let value = 0.5 * from.get(i, j);
                        if value == 0.0 {
                            continue;
                        }
                        for &(column, b) in &spread[j] {
                            let target = to.column_mut(column);
                            for &(row, a) in &spread[i] {
                                target[row] += a * b * value;
                            }
                        }
                    }
                }
            }
            if let Some(rim) = &block.rim {
                let scale = liquid.fourier.get(0, column);
                let mut row = vec![0.0; wall + surface];
                for (value, to) in rim.iter().zip(&spread) {
                    to.iter().for_each(|&(place, factor)| row[place] += scale * value * factor);
                }
                out.rim.push(Rim { harmonic: m as u32, row, sine: Vec::new() });
            }
            first += elevations;
        }
        Ok(out)
    }

    /// Number of elevations or amplitudes.
    pub fn surface(&self) -> usize {
        self.mass.rows - self.wall
    }

    /// With the amplitudes of the lowest `count` sloshing modes instead of the elevations.
    ///
    /// Errors: more modes than elevations; a mass or stiffness of the surface that is not positive definite.
    pub fn with_sloshing_modes(&self, count: usize) -> Result<CondensedLiquid, CondenseError> {
        if count > self.surface() || !self.omega.is_empty() {
            return Err(CondenseError::Option {
                what: "sloshing modes",
                found: format!("{count} of {} elevations", self.surface()),
                allowed: "at most as many as there are elevations, once".into(),
            });
        }
        let wall: Vec<usize> = (0..self.wall).collect();
        let surface: Vec<usize> = (self.wall..self.mass.rows).collect();
        let m = self.mass.select(&surface, &surface);
        let eigen = generalized_eigen(&self.stiffness.select(&surface, &surface), &m, None)?;
        if eigen.omega.len() < count {
            return Err(CondenseError::Option {
                what: "sloshing modes",
                found: format!("{} that double precision resolves", eigen.omega.len()),
                allowed: format!("{count} or more"),
            });
        }
        // η of the modes left out: −M_ηη⁻¹ M_ηw w + Σ_{n≤N} ψ_n ψ_nᵀ M_ηw w.
        let coupling = self.mass.select(&surface, &wall);
        let mut follow = coupling.clone();
        crate::linalg::Cholesky::factor(&m)?.solve(&mut follow);
        let all: Vec<usize> = (0..surface.len()).collect();
        let modes = eigen.vectors.select(&all, &(0..count).collect::<Vec<_>>());
        let part = product(&modes, &transposed_product(&modes, &coupling));
        let mut t = Matrix::zeros(self.mass.rows, self.wall + count);
        for j in 0..self.wall {
            t.add(j, j, 1.0);
            for i in 0..surface.len() {
                t.add(self.wall + i, j, part.get(i, j) - follow.get(i, j));
            }
        }
        for j in 0..count {
            for i in 0..surface.len() {
                t.add(self.wall + i, self.wall + j, modes.get(i, j));
            }
        }
        let project = |a: &Matrix| transposed_product(&t, &product(a, &t));
        let row = |row: &[f64]| -> Vec<f64> { (0..t.cols).map(|j| crate::linalg::dot(row, t.column(j))).collect() };
        Ok(CondensedLiquid {
            wall: self.wall,
            mass: project(&self.mass),
            stiffness: project(&self.stiffness),
            omega: eigen.omega[..count].to_vec(),
            rim: self
                .rim
                .iter()
                .map(|rim| Rim {
                    harmonic: rim.harmonic,
                    row: row(&rim.row),
                    sine: if rim.sine.is_empty() { Vec::new() } else { row(&rim.sine) },
                })
                .collect(),
        })
    }

    /// The element over these wall dofs and these of the surface ([`Dof::Eta`] for elevations, [`Dof::Amplitude`] at nodes of
    /// their own for amplitudes), with the damping ratio `ratio` of each sloshing mode.
    ///
    /// Errors: numbers of dofs that do not fit; a ratio where there are no modes.
    pub fn element(
        &self,
        wall: &[(usize, Dof)],
        surface: &[(usize, Dof)],
        ratio: f64,
    ) -> Result<SuperElement, CondenseError> {
        let fits = wall.len() == self.wall && surface.len() == self.surface();
        if !fits || !(ratio == 0.0 || (!self.omega.is_empty() && ratio > 0.0 && ratio < 1.0)) {
            return Err(CondenseError::Option {
                what: "element of a condensed liquid",
                found: format!("{} wall dofs, {} of the surface, damping ratio {ratio}", wall.len(), surface.len()),
                allowed: format!("{} and {}, a ratio from 0 to 1, 0 without sloshing modes", self.wall, self.surface()),
            });
        }
        let unknowns: Vec<(usize, Dof)> = wall.iter().chain(surface).copied().collect();
        let element =
            SuperElement::over(&unknowns)?.with_mass(self.mass.clone())?.with_stiffness(self.stiffness.clone())?;
        if ratio == 0.0 {
            return Ok(element);
        }
        let mut damping = Matrix::zeros(self.mass.rows, self.mass.rows);
        for (j, omega) in self.omega.iter().enumerate() {
            damping.add(self.wall + j, self.wall + j, 2.0 * ratio * omega);
        }
        Ok(element.with_damping(damping)?)
    }
}

fn identity(n: usize) -> Matrix {
    let mut out = Matrix::zeros(n, n);
    (0..n).for_each(|i| out.add(i, i, 1.0));
    out
}

#[cfg(test)]
mod tests;
