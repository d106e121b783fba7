//! Concrete.

/// Concrete.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConcreteGrade {
    /// Name.
    pub name: &'static str,
    /// Compressive strength f_c [Pa] > 0, a positive number: characteristic, of the cylinder (f_ck) or, in grades B, the
    /// nominal strength of the 200 mm cube (β_WN).
    pub strength: f64,
    /// Mean strength of the cylinder f_cm [Pa] > 0.
    pub mean_strength: f64,
    /// Mean tensile strength f_ctm [Pa] > 0.
    pub tensile_strength: f64,
    /// Young's modulus, secant E_cm [Pa] > 0.
    pub young_modulus: f64,
    /// Poisson's ratio ν before cracking, 0 ≤ ν < 0.5.
    pub poisson_ratio: f64,
    /// Density of reinforced concrete ρ [kg/m³] > 0.
    pub density: f64,
    /// Sources of the numbers.
    pub source: &'static str,
}

impl ConcreteGrade {
    /// Fracture energy G_f = 73 f_cm^0.18 [N/m], f_cm in MPa (fib Model Code 2010, eq. 5.1-9).
    pub fn fracture_energy(&self) -> f64 {
        73.0 * (self.mean_strength / 1e6).powf(0.18)
    }

    /// Strain at the peak, ε_c1 = 0.7 f_cm^0.31 ‰ ≤ 2.8 ‰, as a positive number (EN 1992-1-1:2004, table 3.1).
    pub fn peak_strain(&self) -> f64 {
        (0.7 * (self.mean_strength / 1e6).powf(0.31)).min(2.8) * 1e-3
    }
}

/// Grade after EN 1992-1-1, numbers in MPa and GPa as in its table.
const fn eurocode(name: &'static str, f_ck: f64, f_ctm: f64, e_cm: f64) -> ConcreteGrade {
    ConcreteGrade {
        name,
        strength: f_ck * 1e6,
        mean_strength: (f_ck + 8.0) * 1e6,
        tensile_strength: f_ctm * 1e6,
        young_modulus: e_cm * 1e9,
        poisson_ratio: 0.2,
        density: 2549.0,
        source: "EN 1992-1-1:2004, table 3.1 (f_ck, f_cm, f_ctm, E_cm) and 3.1.3 (ν); EN 1991-1-1:2002, table A.1 (25 kN/m³, \
                 reinforced)",
    }
}

/// Grade after DIN 1045:1988: β_WN, 0.25 β_WN^(2/3) [MPa], E [GPa].
const fn din1045(name: &'static str, beta_wn: f64, beta_bz: f64, e_b: f64) -> ConcreteGrade {
    ConcreteGrade {
        name,
        strength: beta_wn * 1e6,
        mean_strength: 0.85 * (beta_wn + 5.0) * 1e6,
        tensile_strength: beta_bz * 1e6,
        young_modulus: e_b * 1e9,
        poisson_ratio: 0.2,
        density: 2549.0,
        source: "DIN 1045:1988, table 1 (β_WN, β_WS = β_WN + 5 N/mm², 200 mm cube), table 11 (E_b), 16.2.2 (ν); 0.85 from cube to \
                 cylinder; axial tensile strength 0.25 β_WN^(2/3) (Rüsch 1975; [B02] uses 0.1 β_WN, 3.5 N/mm² for \
                 B35); DIN 1055-1 (25 kN/m³, reinforced)",
    }
}

/// Concretes.
pub const CONCRETES: &[ConcreteGrade] = &[
    eurocode("C20/25", 20.0, 2.2, 30.0),
    eurocode("C25/30", 25.0, 2.6, 31.0),
    eurocode("C30/37", 30.0, 2.9, 33.0),
    eurocode("C35/45", 35.0, 3.2, 34.0),
    eurocode("C40/50", 40.0, 3.5, 35.0),
    eurocode("C45/55", 45.0, 3.8, 36.0),
    eurocode("C50/60", 50.0, 4.1, 37.0),
    din1045("B25", 25.0, 2.14, 30.0),
    din1045("B35", 35.0, 2.67, 34.0),
    din1045("B45", 45.0, 3.16, 37.0),
];
