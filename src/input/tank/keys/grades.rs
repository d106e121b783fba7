//! Grades of steel and concrete: values for keys that the file does not give.

use materials::grades::{BARS, CONCRETES, STEELS};

/// Values of a grade, SI.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Preset {
    /// Name as listed.
    pub name: &'static str,
    /// Source of the values.
    pub source: &'static str,
    /// E [Pa].
    pub youngs_modulus: f64,
    /// ν.
    pub poisson_ratio: f64,
    /// ρ [kg/m³].
    pub density: f64,
    /// Kind of material, with its strengths.
    pub strengths: Strengths,
}

/// Strengths of a grade [Pa].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Strengths {
    /// Plates.
    Steel { yielding: f64, ultimate: f64, tangent: f64 },
    /// Concrete: the strength that counts, the mean strength of cylinders, the mean tensile strength.
    Concrete { compressive: f64, mean: f64, tensile: f64 },
    /// Bars; the strain at the greatest force.
    Bars { yielding: f64, tangent: f64, rupture: f64 },
}

impl Strengths {
    /// Kind of behaviour, as users name it.
    pub(crate) fn kind(self) -> &'static str {
        match self {
            Strengths::Steel { .. } => "steel",
            Strengths::Concrete { .. } => "concrete",
            Strengths::Bars { .. } => "reinforcement",
        }
    }
}

/// All grades: plates, concrete, bars.
fn all() -> Vec<Preset> {
    let plates = STEELS.iter().map(|g| Preset {
        name: g.name,
        source: g.source,
        youngs_modulus: g.young_modulus,
        poisson_ratio: g.poisson_ratio,
        density: g.density,
        strengths: Strengths::Steel {
            yielding: g.yield_stress,
            ultimate: g.ultimate_strength,
            tangent: g.tangent_modulus,
        },
    });
    let concretes = CONCRETES.iter().map(|g| Preset {
        name: g.name,
        source: g.source,
        youngs_modulus: g.young_modulus,
        poisson_ratio: g.poisson_ratio,
        density: g.density,
        strengths: Strengths::Concrete {
            compressive: g.strength,
            mean: g.mean_strength,
            tensile: g.tensile_strength,
        },
    });
    let bars = BARS.iter().map(|g| Preset {
        name: g.name,
        source: g.source,
        youngs_modulus: g.young_modulus,
        // Bars are uniaxial: the value has no effect.
        poisson_ratio: 0.3,
        density: g.density,
        strengths: Strengths::Bars {
            yielding: g.yield_stress,
            tangent: g.tangent_modulus(),
            rupture: g.ultimate_strain,
        },
    });
    plates.chain(concretes).chain(bars).collect()
}

/// The grade of this name; case, blanks and hyphens do not count.
pub(super) fn find(name: &str) -> Option<Preset> {
    let wanted = folded(name);
    all().into_iter().find(|p| folded(p.name) == wanted)
}

/// All names.
pub(super) fn names() -> Vec<&'static str> {
    all().into_iter().map(|p| p.name).collect()
}

fn folded(name: &str) -> String {
    name.chars()
        .filter(|c| !c.is_whitespace() && *c != '-' && *c != '_')
        .flat_map(char::to_lowercase)
        .collect()
}
