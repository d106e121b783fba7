//! Grades of steel and concrete: what they supply where the file is silent.

/// What a grade supplies, SI; `None`: the file must give it, if it is needed.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Preset {
    /// Name as listed.
    pub name: &'static str,
    /// Where the values stand.
    pub source: &'static str,
    /// E [Pa].
    pub youngs_modulus: f64,
    /// ν.
    pub poisson_ratio: f64,
    /// ρ [kg/m³].
    pub density: f64,
    /// What it is, with its strengths.
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
    pub fn kind(self) -> &'static str {
        match self {
            Strengths::Steel { .. } => "steel",
            Strengths::Concrete { .. } => "concrete",
            Strengths::Bars { .. } => "reinforcement",
        }
    }
}

/// All grades: plates, concrete, bars.
fn all() -> Vec<Preset> {
    let steel = |name, yielding, ultimate| Preset {
        name,
        source: "EN 1993-1-1:2005, table 3.1 and 3.2.6",
        youngs_modulus: 210e9,
        poisson_ratio: 0.3,
        density: 7850.0,
        strengths: Strengths::Steel {
            yielding,
            ultimate,
            tangent: 2.1e9,
        },
    };
    let concrete = |name, source, youngs_modulus, strengths| Preset {
        name,
        source,
        youngs_modulus,
        poisson_ratio: 0.2,
        density: 2549.0,
        strengths,
    };
    vec![
        steel("S235", 235e6, 360e6),
        steel("S275", 275e6, 430e6),
        steel("S355", 355e6, 490e6),
        concrete(
            "C30/37",
            "EN 1992-1-1:2004, table 3.1",
            33e9,
            Strengths::Concrete {
                compressive: 30e6,
                mean: 38e6,
                tensile: 2.9e6,
            },
        ),
        concrete(
            "B35",
            "DIN 1045:1988, tables 1 and 11",
            34e9,
            Strengths::Concrete {
                compressive: 35e6,
                mean: 34e6,
                tensile: 2.67e6,
            },
        ),
        Preset {
            name: "BSt 500",
            source: "DIN 488",
            youngs_modulus: 210e9,
            poisson_ratio: 0.3,
            density: 7850.0,
            strengths: Strengths::Bars {
                yielding: 500e6,
                tangent: 2.1e9,
                rupture: 0.05,
            },
        },
    ]
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
