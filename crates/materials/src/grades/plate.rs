//! Steel and aluminium of plates: the type.

use crate::LawError;
use crate::von_mises::VonMises;

/// What a plate is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlateKind {
    /// Carbon and low-alloy steel.
    CarbonSteel,
    /// Stainless steel.
    Stainless,
    /// Aluminium alloy.
    Aluminium,
    /// Steel with nine per cent of nickel.
    NickelSteel,
}

/// Steel or aluminium of plates. Its strengths depend on the nominal thickness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SteelGrade {
    /// Name.
    pub name: &'static str,
    /// What it is.
    pub kind: PlateKind,
    /// Other names: qualities with the same strengths, numbers, metric designations.
    pub aliases: &'static [&'static str],
    /// Young's modulus E [Pa] > 0.
    pub young_modulus: f64,
    /// Poisson's ratio ν, −1 < ν < 0.5.
    pub poisson_ratio: f64,
    /// Density ρ [kg/m³] > 0.
    pub density: f64,
    /// Strengths by thickness, thin plates first; at least one.
    pub steps: &'static [Step],
    /// Slope E_T of the bilinear curve beyond f_y [Pa], 0 ≤ E_T < E.
    pub tangent_modulus: f64,
    /// Sources of the numbers.
    pub source: &'static str,
}

/// Strengths up to a thickness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Largest nominal thickness [m]; infinite where the source gives none.
    pub up_to: f64,
    /// Yield stress f_y, or 0.2 % proof stress f_o of aluminium [Pa] > 0.
    pub yield_stress: f64,
    /// Ultimate tensile strength f_u [Pa] > f_y.
    pub ultimate_strength: f64,
    /// Product design stress S_d [Pa] (API 650 table 5-2, annex S for stainless steel); `None` for a plate that is in neither.
    pub allowable_stress: Option<f64>,
}

impl SteelGrade {
    /// Strengths of a plate; `None` for one thicker than the source covers.
    ///
    /// * `thickness`: nominal thickness [m]
    pub fn at(&self, thickness: f64) -> Option<Step> {
        // 10⁻⁹: a thickness in inches is not the decimal number of its table.
        (self.steps.iter().copied()).find(|step| thickness <= step.up_to * (1.0 + 1e-9))
    }

    /// Strengths of thin plates.
    pub fn thin(&self) -> Step {
        self.steps[0]
    }

    /// Largest nominal thickness [m]; infinite where the source gives none.
    pub fn thickest(&self) -> f64 {
        self.steps[self.steps.len() - 1].up_to
    }

    /// von Mises' law of thin plates, bilinear.
    ///
    /// * `kinematic`: share of kinematic hardening, from 0 to 1
    ///
    /// Errors: a parameter out of range.
    pub fn law(&self, kinematic: f64) -> Result<VonMises, LawError> {
        VonMises::new(self.young_modulus, self.poisson_ratio, self.thin().yield_stress, self.tangent_modulus, kinematic)
    }
}

/// A step without a place in API 650 table 5-2.
///
/// * `up_to`: [mm]
/// * `yield_stress`, `ultimate_strength`: [MPa]
pub(super) const fn step(up_to: f64, yield_stress: f64, ultimate_strength: f64) -> Step {
    Step {
        up_to: up_to * 1e-3,
        yield_stress: yield_stress * 1e6,
        ultimate_strength: ultimate_strength * 1e6,
        allowable_stress: None,
    }
}

/// A line of API 650 table 5-2a.
///
/// * `up_to`: [mm]
/// * `yield_stress`, `ultimate_strength`, `allowable_stress`: [MPa]
pub(super) const fn api(up_to: f64, yield_stress: f64, ultimate_strength: f64, allowable_stress: f64) -> Step {
    Step { allowable_stress: Some(allowable_stress * 1e6), ..step(up_to, yield_stress, ultimate_strength) }
}
