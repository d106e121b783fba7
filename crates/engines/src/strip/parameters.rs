//! Parameters of a strip, and its errors.

use std::sync::Arc;

use fem::analysis::AnalysisError;
use fem::element::ElementError;
use fem::element::beam_section::FibreSection;
use fem::element::fibre_beam::Options;
use fem::model::ModelError;

use super::liquid::{StripLiquid, Trace};
use super::shell_wall::ShellWall;
use crate::FeError;

/// Parameters of the strip, per metre of tank.
#[derive(Clone, Debug)]
pub struct StripTank {
    /// Heights of the wall's nodes [m], ascending from 0 to the wall's height.
    pub levels: Vec<f64>,
    /// Section of each element, from the bottom; one fewer than levels. ζ along +x: the wet face is at −h/2.
    pub sections: Vec<Arc<FibreSection>>,
    /// Shells that take the place of the beams; the sections then give the mass of the wall and the penalty of the joint alone.
    pub shells: Option<ShellWall>,
    /// Integration along the beams, P-Δ.
    pub options: Options,
    /// Masses that the wall carries at heights [kg per m], [m]; each is on the two levels next to it, which holds its moment.
    pub carried: Vec<(f64, f64)>,
    /// Rotation spring at the base [N m/rad per m]; clamped without.
    pub base_spring: Option<f64>,
    /// The liquid.
    pub liquid: StripLiquid,
    /// Number of sloshing modes.
    pub sloshing: usize,
    /// How liquid and wall touch.
    pub contact: Contact,
    /// Liquid of displacement elements between both walls, in one model, in place of the condensed one.
    pub mesh: Option<LiquidMesh>,
}

/// Liquid of displacement elements, joined to both walls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LiquidMesh {
    /// Elements from wall to wall; rows are those of the wall.
    pub columns: usize,
    /// Bulk modulus [Pa].
    pub bulk_modulus: f64,
    /// Penalty K_rot [Pa] of the element of [B02], volume part at one point and full rotation part; `None`: mean dilatation and split penalty.
    pub rotation_penalty: Option<f64>,
    /// Stiffness k_t of the joints along the wall [N/m³].
    pub tangential: f64,
    /// Whether a joint opens by the pressure at its place, as in [B02], not by that of the displaced particle.
    pub at_place: bool,
}

impl LiquidMesh {
    /// The default element, free along the wall.
    pub fn new(columns: usize, bulk_modulus: f64) -> LiquidMesh {
        LiquidMesh { columns, bulk_modulus, rotation_penalty: None, tangential: 0.0, at_place: false }
    }
}

impl StripTank {
    /// Unknowns of the liquid's face: those of the beams; deflections alone of shells and of a face of its own.
    pub fn trace(&self) -> Trace {
        match self.shells {
            Some(_) => Trace::Linear,
            None => self.contact.trace(),
        }
    }
}

/// How liquid and wall touch.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Contact {
    /// The wall's displacement is the liquid's.
    #[default]
    Bonded,
    /// The liquid has its own displacement, joined to the wall by a penalty.
    Joined {
        /// Whether the joint opens where the pressure of the displaced particle falls below zero.
        opens: bool,
        /// k_n [N/m³]; without, [`PENALTY`](fem::element::liquid_joint::PENALTY) times the stiffness of the wall under the pressure at rest.
        penalty: Option<f64>,
    },
}

impl Contact {
    /// Unknowns of the liquid's face: with more of them than joints, points of the face could move on their own.
    pub fn trace(self) -> Trace {
        match self {
            Contact::Bonded => Trace::Cubic,
            Contact::Joined { .. } => Trace::Linear,
        }
    }
}

/// Share of the height by which the top of a wall may move: beyond it the theory of small deflections does not apply, and the
/// wall counts as collapsed.
pub const LARGEST_DEFLECTION: f64 = 0.1;

/// Why a run of a wall was stopped whose top stands at the deflection `u` [m] of a height `h` [m].
pub(super) fn lost(u: f64, h: f64) -> Option<String> {
    (u.abs() > LARGEST_DEFLECTION * h).then(|| {
        format!(
            "the top of the wall has moved by more than {LARGEST_DEFLECTION} of its height, beyond small deflections"
        )
    })
}

/// A strip that cannot be made or solved.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum StripError {
    /// A parameter out of range.
    #[error("strip: {parameter} is {found}, allowed {allowed}")]
    Parameter {
        /// Name of the parameter.
        parameter: &'static str,
        /// Found.
        found: String,
        /// Allowed.
        allowed: &'static str,
    },
    /// An element failed.
    #[error(transparent)]
    Element(#[from] ElementError),
    /// The model failed.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// An analysis failed.
    #[error(transparent)]
    Analysis(#[from] AnalysisError),
}

impl From<StripError> for FeError {
    fn from(error: StripError) -> FeError {
        match error {
            StripError::Analysis(AnalysisError::Checkpoint(fault)) => FeError::Checkpoint(fault),
            other => FeError::Analysis(other.to_string()),
        }
    }
}

/// Nodes of a wall: `wet` elements up to the surface and `dry` above it. Lengths of the wet elements grow upwards in
/// geometric progression, the last `ratio` times as long as the first.
///
/// Errors: no wet element, lengths that are not positive, a surface above the wall.
pub fn levels([depth, height]: [f64; 2], [wet, dry]: [usize; 2], ratio: f64) -> Result<Vec<f64>, StripError> {
    let refuse = |parameter, found: String, allowed| Err(StripError::Parameter { parameter, found, allowed });
    if wet == 0 || (dry == 0) != (height == depth) {
        let found = format!("{wet} wet, {dry} dry for a depth of {depth} m and a height of {height} m");
        return refuse("elements", found, "1 or more wet, dry ones where the wall is dry");
    }
    if !(depth > 0.0 && height >= depth && height.is_finite()) {
        return refuse("depth and height", format!("{depth}, {height} m"), "0 < depth ≤ height");
    }
    if !(ratio > 0.0 && ratio.is_finite()) {
        return refuse("ratio", ratio.to_string(), "> 0");
    }
    let growth = if wet > 1 { ratio.powf(1.0 / (wet - 1) as f64) } else { 1.0 };
    let lengths: Vec<f64> = (0..wet).map(|i| growth.powi(i as i32)).collect();
    let total: f64 = lengths.iter().sum();
    let mut z = vec![0.0];
    for i in 1..wet {
        z.push(z[i - 1] + depth * lengths[i - 1] / total);
    }
    z.push(depth);
    z.extend((1..=dry).map(|i| depth + (height - depth) * i as f64 / dry as f64));
    Ok(z)
}
