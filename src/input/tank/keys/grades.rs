//! Grades of steel and concrete: values for keys that the file does not give.

use materials::grades::{BARS, CONCRETES, PlateKind, SteelGrade, Step, folded, steels};

use ::tank::keys::list;

/// Values of a grade, SI.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Preset {
    /// Name as listed.
    pub name: &'static str,
    /// Source of the values.
    pub source: &'static str,
    /// Family.
    pub family: tank::Family,
    /// Thickness up to which the strengths hold, in words (", t ≤ 40 mm"); empty where they do not depend on it.
    pub range: String,
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
    Steel {
        yielding: f64,
        ultimate: f64,
        tangent: f64,
        /// S_d of API 650, if the steel is in its table.
        allowable: Option<f64>,
    },
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

/// A steel with the strengths of a plate.
fn plate(g: &SteelGrade, step: Step) -> Preset {
    Preset {
        name: g.name,
        source: g.source,
        family: match g.kind {
            PlateKind::CarbonSteel => tank::Family::CarbonSteel,
            PlateKind::Stainless => tank::Family::Stainless,
            PlateKind::Aluminium => tank::Family::Aluminium,
            PlateKind::NickelSteel => tank::Family::OtherMetal,
        },
        range: match g.steps.len() {
            1 => String::new(),
            _ => format!(", t ≤ {} mm", 1e3 * step.up_to),
        },
        youngs_modulus: g.young_modulus,
        poisson_ratio: g.poisson_ratio,
        density: g.density,
        strengths: Strengths::Steel {
            yielding: step.yield_stress,
            ultimate: step.ultimate_strength,
            tangent: g.tangent_modulus,
            allowable: step.allowable_stress,
        },
    }
}

/// Concretes and bars.
fn others() -> impl Iterator<Item = Preset> {
    let concretes = CONCRETES.iter().map(|g| Preset {
        name: g.name,
        source: g.source,
        family: tank::Family::Concrete,
        range: String::new(),
        youngs_modulus: g.young_modulus,
        poisson_ratio: g.poisson_ratio,
        density: g.density,
        strengths: Strengths::Concrete { compressive: g.strength, mean: g.mean_strength, tensile: g.tensile_strength },
    });
    let bars = BARS.iter().map(|g| Preset {
        name: g.name,
        source: g.source,
        family: tank::Family::CarbonSteel,
        range: String::new(),
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
    concretes.chain(bars)
}

/// What a name stands for.
pub(super) enum Found {
    /// A grade, with the strengths of the thickness.
    Grade(Preset),
    /// A steel whose standard ends at thinner plates: its name, and the largest thickness [m].
    TooThick(&'static str, f64),
    /// Not a grade.
    Unknown,
}

/// The grade of this name.
///
/// * `thickness`: nominal thickness of the thickest plate [m]
pub(super) fn find(name: &str, thickness: f64) -> Found {
    if let Ok(steel) = materials::grades::steel(name) {
        return match steel.at(thickness) {
            Some(step) => Found::Grade(plate(&steel, step)),
            None => Found::TooThick(steel.name, steel.thickest()),
        };
    }
    let wanted = folded(name);
    (others().find(|p| folded(p.name) == wanted)).map_or(Found::Unknown, Found::Grade)
}

/// Names and aliases nearest to an unknown one, the nearest first; and the one that is probably meant. None for a name that is not like any.
pub(super) fn near(name: &str) -> (Vec<&'static str>, Option<&'static str>) {
    let wanted = folded(name);
    let length = wanted.chars().count();
    if length > LONGEST {
        return (Vec::new(), None);
    }
    let plates = steels().flat_map(|g| std::iter::once(g.name).chain(g.aliases.iter().copied()));
    let mut near: Vec<(usize, &str)> = plates
        .chain(others().map(|p| p.name))
        .map(|known| (strsim::damerau_levenshtein(&wanted, &folded(known)), known))
        .filter(|(distance, known)| distance * 2 <= length.max(known.len()))
        .collect();
    // Stable: of names equally near the first in the list.
    near.sort_by_key(|(distance, _)| *distance);
    near.truncate(SHOWN);
    let meant = near.first().filter(|(distance, _)| distance * 3 <= length);
    let meant = meant.map(|(_, known)| *known);
    (near.into_iter().map(|(_, known)| known).collect(), meant)
}

/// Longest folded name that is compared [characters]; the longest of a grade has 18.
const LONGEST: usize = 40;
/// Names in a message about an unknown one.
const SHOWN: usize = 6;

/// What is allowed instead of an unknown name.
pub(super) fn allowed(near: &[&str]) -> String {
    let such = if near.is_empty() { &EXAMPLES } else { near };
    format!("a grade such as {}; `tankcheck schema --markdown` lists all", list(such, "or"))
}

/// One name of each kind.
const EXAMPLES: [&str; 6] = ["S355", "S355JR", "1.4301", "A36", "C30/37", "BSt500"];
