//! The liquid in a rigid tank: quantities with closed forms in potential flow.
//!
//! ```text
//! sloshing     K_ηη η = ω² M_ηη η                      wall held
//! convective   m_n = (η_nᵀ M_ηw ι)²                     ι unit translation of the wall
//! impulsive    M_ηη a = −M_ηw ι: the surface free of pressure;  m_i = ιᵀ (M_ww ι + M_wη a)
//! ```

use engines::FeError;
use engines::liquid::{Domain, LiquidMesh, Potential};
use fem::linalg::{Cholesky, LinalgError, Matrix, dot, generalized_eigen};

/// Heights at which the held wall may translate, as a share of the depth: any partition will do.
const TRACE: u32 = 12;

/// A liquid with its wall held.
pub struct RigidTank {
    /// The liquid.
    pub liquid: Potential,
    gravity: f64,
}

/// Impulsive mass and its levers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impulsive {
    /// m_i [kg].
    pub mass: f64,
    /// h_i [m], wall pressure alone.
    pub lever: f64,
    /// h_i' [m], wall and bottom pressure.
    pub lever_below: f64,
}

impl RigidTank {
    /// Density of the liquid [kg/m³]; no result but the masses depends on it.
    pub const DENSITY: f64 = 1000.0;

    /// A tank on the default mesh, refined by `refine`.
    ///
    /// Errors: a mesh without elements.
    pub fn new(domain: Domain, depth: f64, gravity: f64, refine: f64) -> Result<RigidTank, FeError> {
        let mesh = LiquidMesh::graded(domain.half_length(), depth, refine);
        let trace = (0..=TRACE).map(|k| depth * f64::from(k) / f64::from(TRACE)).collect();
        let liquid = Potential::new(domain, mesh, trace, Self::DENSITY).map_err(failure)?;
        Ok(RigidTank { liquid, gravity })
    }

    /// Sloshing frequencies [rad/s], ascending.
    pub fn sloshing(&self) -> Result<Vec<f64>, FeError> {
        let (k, m) = self.surface_system();
        Ok(generalized_eigen(&k, &m, None).map_err(failure)?.omega)
    }

    /// Convective masses [kg] of the sloshing modes, by ascending frequency.
    pub fn convective_masses(&self) -> Result<Vec<f64>, FeError> {
        let (k, m) = self.surface_system();
        let eigen = generalized_eigen(&k, &m, None).map_err(failure)?;
        let load = self.liquid.mass.times(&self.liquid.rigid_translation());
        let load: Vec<f64> = self.liquid.surface_columns().map(|c| load[c]).collect();
        Ok((0..eigen.omega.len()).map(|j| dot(eigen.vectors.column(j), &load).powi(2)).collect())
    }

    /// Impulsive mass and levers.
    pub fn impulsive(&self) -> Result<Impulsive, FeError> {
        let liquid = &self.liquid;
        let surface: Vec<usize> = liquid.surface_columns().collect();
        let translation = liquid.rigid_translation();
        let load = liquid.mass.times(&translation);
        let right: Vec<f64> = surface.iter().map(|&c| -load[c]).collect();
        let fall = Cholesky::factor(&liquid.mass.select(&surface, &surface)).map_err(failure)?.solve_vector(&right);
        let mut motion = translation.clone();
        surface.iter().zip(&fall).for_each(|(&c, a)| motion[c] = *a);
        let force = liquid.mass.times(&motion);
        // Wall columns hold displacement and slope by turns: the arm z interpolates as (z, 1).
        let arm: Vec<f64> = (0..liquid.columns())
            .map(|c| match c < surface[0] {
                true if c % 2 == 0 => liquid.trace[c / 2],
                true => 1.0,
                false => 0.0,
            })
            .collect();
        let mass = dot(&translation, &force);
        let moment = dot(&arm, &force);
        let below = moment + dot(&liquid.bottom_moment(), &motion);
        Ok(Impulsive { mass, lever: moment / mass, lever_below: below / mass })
    }

    /// Mass that a rigid translation of wall and surface moves, ιᵀ M_f ι [kg].
    pub fn translated_mass(&self) -> f64 {
        let translation = self.liquid.rigid_translation();
        dot(&translation, &self.liquid.mass.times(&translation))
    }

    /// K = ρ g S and M of the surface; a floating liquid (m = 0) loses the elevation with the largest flux.
    fn surface_system(&self) -> (Matrix, Matrix) {
        let liquid = &self.liquid;
        let columns: Vec<usize> = liquid.surface_columns().collect();
        let mut k = liquid.surface_area.select(&columns, &columns);
        k.data.iter_mut().for_each(|v| *v *= Self::DENSITY * self.gravity);
        let m = liquid.mass.select(&columns, &columns);
        if !liquid.domain.is_floating() {
            return (k, m);
        }
        let q: Vec<f64> = columns.iter().map(|&c| liquid.flux[c]).collect();
        let e = (0..q.len()).max_by(|&a, &b| q[a].abs().total_cmp(&q[b].abs())).unwrap_or(0);
        // Columns of T: x_e = −Σ q_j x_j / q_e, no net volume leaves the tank.
        let free: Vec<usize> = (0..q.len()).filter(|&i| i != e).collect();
        let mut t = Matrix::zeros(q.len(), free.len());
        for (j, &i) in free.iter().enumerate() {
            t.add(i, j, 1.0);
            t.add(e, j, -q[i] / q[e]);
        }
        let congruent = |a: &Matrix| {
            let mut out = Matrix::zeros(free.len(), free.len());
            for j in 0..free.len() {
                let column = a.times(t.column(j));
                for i in 0..free.len() {
                    out.add(i, j, dot(t.column(i), &column));
                }
            }
            out
        };
        (congruent(&k), congruent(&m))
    }
}

fn failure(error: LinalgError) -> FeError {
    FeError::Eigen(error.to_string())
}
